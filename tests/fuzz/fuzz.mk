# SPDX-License-Identifier: MIT
#
# The fuzzers that tests/fuzz.sh runs, with libFuzzer and sanitizers:
#     make -f tests/fuzz/fuzz.mk OUT=build/fuzz NAMES='record log'
# DOUBLE=1: the library's in double; the tool is always in double.
DOUBLE ?= 0
CC := clang-19
SANITIZERS := -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all \
    -fno-omit-frame-pointer
FLAGS := -std=c99 -ffp-contract=off -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow \
    -pedantic -Werror -O1 -g $(SANITIZERS) $(EXTRA) -Iinclude -Isrc -Iport/host -Itests/fuzz
# The tool, as the Makefile builds it, but with main renamed.
TOOL := -Dmain=tool_main -DINVCAL_DOUBLE=1 -DINVCAL_MAX_POSITIONS=64 -DINVCAL_ALLAN_TAUS=31 \
    -DINVCAL_PRIVATE_OVERLAP=4096 -DINVCAL_THERMAL_DEGREE=2 -DINVCAL_MAX_SEGMENTS=1000
# Replaces what takes seconds by something quicker, see tool.c.
QUICK := -Wl,--wrap=optimal_within,--wrap=optimal_directions,--wrap=grid_directions

LIBRARY_OBJECTS := $(patsubst %.c,$(OUT)/library/%.o,$(wildcard src/*/*.c) tests/fuzz/fuzz.c \
    tests/fuzz/drive.c)
TOOL_OBJECTS := $(patsubst %.c,$(OUT)/tool/%.o,$(wildcard src/*/*.c port/host/*.c port/host/*/*.c) tests/fuzz/tool.c)

.PHONY: all
.SECONDARY:
all: $(NAMES:%=$(OUT)/fuzz-%)

$(OUT)/library/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(FLAGS) -fsanitize=fuzzer-no-link -DINVCAL_DOUBLE=$(DOUBLE) -MMD -MP -c $< -o $@

$(OUT)/tool/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(FLAGS) -fsanitize=fuzzer-no-link $(if $(filter tests/%,$<),,$(TOOL)) -MMD -MP -c $< -o $@

$(OUT)/fuzz-%: $(OUT)/library/tests/fuzz/%.o $(LIBRARY_OBJECTS)
	$(CC) $(FLAGS) -fsanitize=fuzzer $^ -lm -o $@

$(OUT)/fuzz-log $(OUT)/fuzz-options: $(OUT)/fuzz-%: $(OUT)/tool/tests/fuzz/%.o $(TOOL_OBJECTS)
	$(CC) $(FLAGS) -fsanitize=fuzzer $(QUICK) $^ -lm -o $@

-include $(shell find $(OUT) -name '*.d' 2>/dev/null)
