# SPDX-License-Identifier: MIT
#
# What tests/size.sh measures, for one target:
#     make -f tests/size/size.mk TARGET=port/cortex-m/m4f LEVEL=Os programs
include port/build.mk
override OPT += -fstack-usage

HEADERS := $(notdir $(wildcard include/invcal/*.h))

# Programs without start-up code, made only of library functions: what a device needs for offset and matrix; the
# same with every sigma and the verdict; what the program of README.md calls; that with the gyroscope; everything.
$(OUT)/core.elf:    WANTED = invcal_sums_init invcal_sums_add invcal_sums_solve invcal_apply
$(OUT)/judged.elf:  WANTED = invcal_calibrate_plain invcal_apply
$(OUT)/product.elf: WANTED = $(shell $(subst gcc,nm,$(CC)) -u $(OUT)/program.o | sed -n 's/.* invcal_/invcal_/p')
$(OUT)/imu.elf:     WANTED = $(shell $(subst gcc,nm,$(CC)) -u $(OUT)/program.o | sed -n 's/.* invcal_/invcal_/p') \
    invcal_imu_init_nominal invcal_imu_set_limits invcal_imu_feed_gyro invcal_imu_feed invcal_imu_solve
$(OUT)/whole.elf:   WANTED = %
$(OUT)/product.elf $(OUT)/imu.elf: $(OUT)/program.o
$(OUT)/core.elf $(OUT)/judged.elf $(OUT)/product.elf $(OUT)/imu.elf $(OUT)/whole.elf: $(LIBRARY) $(OUT)/public
	$(Q)$(CC) $(FLAGS) $(LIBRARY) -nostartfiles -Wl,--gc-sections -Wl,-e,0 \
	    $$(awk -v wanted="$(WANTED)" -f tests/size/wanted.awk $(OUT)/public) \
	    -Wl,-Map=$(@:.elf=.map) $(LINK) -o $@

# The program of README.md, with its main, but without start-up and the functions of its board, which have the
# address of main.
$(OUT)/program.elf: $(OUT)/program.o $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -nostartfiles -Wl,--gc-sections -Wl,-e,main \
	    $$($(subst gcc,nm,$(CC)) -u $< | sed -n 's/.* \(board_.*\)/-Wl,--defsym=\1=main/p') $(LINK) -o $@

$(OUT)/program.c: README.md
	@mkdir -p $(@D)
	$(Q)awk '/^```c$$/ { on = 1; next } /^```$$/ { on = 0 } on' $< > $@
$(OUT)/program.o: $(OUT)/program.c $(wildcard include/invcal/*.h)
	$(Q)$(CC) -Itests/readme $(FLAGS) -c $< -o $@

# "header function" of all public functions.
$(OUT)/public: $(wildcard include/invcal/*.h)
	@mkdir -p $(@D)
	$(Q)printf '#include "invcal/%s"\n' $(HEADERS) | $(CC) $(filter-out -MMD -MP,$(FLAGS)) -E -x c - | \
	    awk -f tests/size/public.awk > $@

# The same for functions that the library's private headers declare, with the public ones.
$(OUT)/declared: $(wildcard src/*/*.h include/invcal/*.h)
	@mkdir -p $(@D)
	$(Q)printf '#include "%s"\n' $(wildcard src/*/*.h) | $(CC) $(filter-out -MMD -MP,$(FLAGS)) -I. -E -x c - | \
	    awk -f tests/size/public.awk > $@

.PHONY: programs
programs: $(OUT)/core.elf $(OUT)/judged.elf $(OUT)/product.elf $(OUT)/program.elf $(OUT)/imu.elf $(OUT)/whole.elf \
    $(OUT)/tests/size/structures.o $(OUT)/declared

# The example firmware, where the family has one.
$(OUT)/firmware.elf $(OUT)/firmware_imu.elf: LINK += -Wl,-Map=$(@:.elf=.map)
.PHONY: firmwares
firmwares: $(if $(FIRMWARE),$(OUT)/firmware.elf $(OUT)/firmware_imu.elf)

# The program that measures its stack.
$(OUT)/depth.elf: $(OUT)/tests/size/depth.o $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections $(LINK) -o $@

.PHONY: depth
depth: $(OUT)/depth.elf
	@timeout 60 $(RUN) $<
