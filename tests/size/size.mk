# SPDX-License-Identifier: MIT
#
# What tests/size.sh measures, for one target:
#     make -f tests/size/size.mk TARGET=port/cortex-m/m4f programs
override OPT := -Os -fstack-usage
include port/build.mk

public = $(shell awk -f tests/size/public.awk $(1) | cut -d ' ' -f 2)

# Programs without start-up and main: what the linker keeps for these functions.
# What a device needs for offset and matrix:
CORE := invcal_observation_reading invcal_observation_exact invcal_normal_init invcal_normal_add \
        invcal_solve invcal_apply
EVERYTHING := $(call public,$(patsubst %,include/invcal/%.h,session guidance outlier plan store record))
WHOLE := $(call public,$(wildcard include/invcal/*.h))

$(OUT)/core.elf: FUNCTIONS = $(CORE)
$(OUT)/everything.elf: FUNCTIONS = $(EVERYTHING)
$(OUT)/whole.elf: FUNCTIONS = $(WHOLE)
$(OUT)/core.elf $(OUT)/everything.elf $(OUT)/whole.elf: $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -nostartfiles -Wl,--gc-sections -Wl,-e,invcal_solve \
	    $(FUNCTIONS:%=-Wl,--require-defined=%) -Wl,-Map=$(@:.elf=.map) $(LINK) -o $@

.PHONY: programs
programs: $(OUT)/core.elf $(OUT)/everything.elf $(OUT)/whole.elf $(OUT)/tests/size/structures.o

# The program that measures its stack, and its run.
$(OUT)/depth.elf: $(OUT)/tests/size/depth.o $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections $(LINK) -o $@

.PHONY: depth
depth: $(OUT)/depth.elf
	@timeout 60 $(RUN) $<
