# SPDX-License-Identifier: MIT
#
# Everything for one target:  make -f port/build.mk TARGET=port/cortex-m/m4f tests
# The target's own target.mk says with what and how.

include $(TARGET)/target.mk
include port/options.mk

CC     := $(PREFIX)gcc
BUILD  ?= build/targets
OUT    := $(BUILD)/$(subst /,-,$(TARGET:port/%=%))$(if $(QUICK),-quick)$(LEVEL:%=-%)
UNITY  ?= tests/unity
OPT    ?= -O2
# What `make size` and `make bench` measure: LEVEL=Os, O2, ...; fast is -O2 with INVCAL_FAST.
ifdef LEVEL
override OPT := $(if $(filter fast,$(LEVEL)),-O2 -DINVCAL_FAST=1,-$(LEVEL))
endif
REAL   ?= 0
# Long tests run where LONG is set: by the target.mk of a machine that computes double in hardware.
# Elsewhere, and with QUICK, they are skipped, and loops over random members visit one of SHARE.
SHARE  ?= $(if $(QUICK),200,10)
SHORT  := $(if $(QUICK)$(if $(LONG),,short),-DTEST_SHORT=$(SHARE))
WARNINGS := -Wall -Wextra -Wshadow -Wdouble-promotion
# Contraction (fused multiply-add) is off: the same bits on every machine. A square root of a negative
# number is a NaN, and no errno.
FLAGS   = -std=c99 $(OPT) -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections $(WARNINGS) $(CPU) \
          -DINVCAL_DOUBLE=$(REAL) -Iinclude -Iport -MMD -MP
TESTING = -DUNITY_INCLUDE_DOUBLE -DUNITY_STRICT -DUNITY_SUPPORT_64 $(SHORT) \
          $(if $(RAM),-DTEST_RAM=$(RAM)) \
          '-DUNITY_OUTPUT_CHAR(c)=board_put(c)' \
          -include board.h -I$(UNITY) -Isrc -Itests/unit -Itests/reference -I$(BUILD)

$(foreach path,BUILD UNITY,$(call check_path,$(path)))
$(call check_options,OPT,$(OPT))

LIBRARY := $(patsubst %.c,$(OUT)/%.o,$(wildcard src/*/*.c))
SUITES  := $(filter-out $(WITHOUT),$(patsubst tests/unit/%.c,%,$(wildcard tests/unit/test_*.c)))
# A suite that is too large is several images: PARTS_test_session := 0 1 2 in target.mk.
IMAGES  := $(foreach s,$(SUITES),$(if $(PARTS_$s),$(PARTS_$s:%=$s.%),$s))
# The same for the digest: the names of its parts.
DIGESTS := $(if $(PARTS_digest),$(PARTS_digest:%=digest.%),digest)
COMMON  := $(BOARD:%.c=$(OUT)/%.o)
Q := $(if $(V),,@)

.DEFAULT_GOAL := tests
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: tests bench traced digest facts

# What is compiled depends on these rules, and on what the command line changes in them.
RULES := $(MAKEFILE_LIST) $(OUT)/words
target_words = $(CC) $(FLAGS) $(TESTING) $(LINK)

$(OUT)/%.o: %.c $(RULES)
	@mkdir -p $(@D)
	$(Q)$(CC) $(FLAGS) -c $< -o $@

# Where int has 16 bits, it is here that a number too large for it is noticed.
$(LIBRARY): FLAGS += -Wconversion -pedantic -Werror $(if $(filter fast,$(LEVEL)),-Wno-error)

# Not at link time: the optimiser does not see which names the assembly of a start-up uses.
$(COMMON): FLAGS += -fno-lto

$(OUT)/unity.o: $(UNITY)/unity.c $(RULES)
	@mkdir -p $(@D)
	$(Q)$(CC) $(FLAGS) $(TESTING) -c $< -o $@

# The position means as C arrays: there are no files on a target.
$(BUILD)/positions.h: tests/data/to_c.awk $(wildcard tests/data/*_positions.csv)
	@mkdir -p $(@D)
	$(Q)awk -f $^ > $@
$(IMAGES:%=$(OUT)/tests/unit/%.o) $(OUT)/tests/digest/calibrations.o: | $(BUILD)/positions.h

$(OUT)/tests/unit/%.o: FLAGS += $(TESTING)
$(OUT)/tests/digest/%.o: FLAGS += -Isrc -Itests/reference -I$(BUILD)
$(OUT)/tests/bench/%.o $(OUT)/tests/size/%.o: FLAGS += -Isrc

define part
$(OUT)/tests/unit/$(1).$(2).o: tests/unit/$(1).c $(RULES)
	@mkdir -p $$(@D)
	$(Q)$$(CC) $$(FLAGS) -DTEST_PARTS=$(words $(PARTS_$(1))) -DTEST_PART=$(2) -c $$< -o $$@
endef
$(foreach s,$(SUITES),$(foreach k,$(PARTS_$s),$(eval $(call part,$s,$k))))

$(OUT)/%.elf: $(OUT)/tests/unit/%.o $(OUT)/tests/unit/support.o $(OUT)/unity.o $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections $(LINK) -o $@

tests: $(IMAGES:%=$(OUT)/%.elf)

$(PARTS_digest:%=$(OUT)/tests/digest/digest.%.o): $(OUT)/tests/digest/digest.%.o: tests/digest/digest.c $(RULES)
	@mkdir -p $(@D)
	$(Q)$(CC) $(FLAGS) -DDIGEST_PART=$* -c $< -o $@

$(OUT)/bench.elf: $(OUT)/tests/bench/bench.o
$(OUT)/traced.elf: $(OUT)/tests/bench/traced.o
$(DIGESTS:%=$(OUT)/%.elf): $(OUT)/%.elf: $(OUT)/tests/digest/%.o \
    $(patsubst %.c,$(OUT)/%.o,$(filter-out %/digest.c,$(wildcard tests/digest/*.c)))
$(OUT)/bench.elf $(OUT)/traced.elf $(DIGESTS:%=$(OUT)/%.elf): $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections $(LINK) -o $@

digest: $(DIGESTS:%=$(OUT)/%.elf)

bench: $(OUT)/bench.elf

# What tests/bench/cycles.py traces.
$(OUT)/tests/bench/traced.o: tests/bench/bench.c $(RULES)
	@mkdir -p $(@D)
	$(Q)$(CC) $(FLAGS) -DBENCH_TRACED=1 -c $< -o $@

traced: $(OUT)/traced.elf

# The example firmware, where the family has one.
-include $(dir $(TARGET))firmware/firmware.mk

# For tests/target.sh. With run_counting the machine counts; unit says what, nothing if it cannot.
facts:
	@echo "compiler='$(CC)' cpu='$(CPU)' emulator='$(or $(EMULATOR),$(firstword $(RUN)))' levels='Os $(LEVELS)' processor='$(PROCESSOR)'"
	@echo "out='$(OUT)' run='$(RUN)' run_counting='$(RUN:-kernel=$(COUNTING) -kernel)' unit='$(UNIT)'"

$(eval $(call words_file,$(OUT)/words,target_words))
-include $(shell find $(OUT) -name '*.d' 2>/dev/null)
