# SPDX-License-Identifier: MIT
#
# The example firmware:  make -f port/build.mk TARGET=port/cortex-m/m4f firmware
# and that of both sensors, which is another main.c:                    firmware_imu

FIRMWARE := port/cortex-m/firmware
PARTS    := $(filter-out %/main.c %/accelerometer.c %/both.c, $(wildcard $(FIRMWARE)/*.c $(FIRMWARE)/sim/*.c))

.PHONY: firmware firmware_imu
firmware: $(OUT)/firmware.elf
firmware_imu: $(OUT)/firmware_imu.elf

$(OUT)/$(FIRMWARE)/%.o $(OUT)/$(FIRMWARE)_imu/%.o: FLAGS += -I$(FIRMWARE) -Wconversion -pedantic

$(OUT)/firmware.elf: $(OUT)/$(FIRMWARE)/main.o $(OUT)/$(FIRMWARE)/sim/accelerometer.o
$(OUT)/firmware_imu.elf: $(OUT)/$(FIRMWARE)_imu/main.o $(OUT)/$(FIRMWARE)/sim/both.o

# The simulated hand reads what the firmware prints: sim/hand.c wraps uart_put.
$(OUT)/firmware.elf $(OUT)/firmware_imu.elf: $(PARTS:%.c=$(OUT)/%.o) $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections -Wl,--wrap=uart_put $(LINK) -o $@
