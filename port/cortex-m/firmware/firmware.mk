# SPDX-License-Identifier: MIT
#
# The example firmware:  make -f port/build.mk TARGET=port/cortex-m/m4f firmware
# and that of both sensors, which shares what is not of the sensor:     firmware_imu

FIRMWARE         := port/cortex-m/firmware
FIRMWARE_SOURCES := $(wildcard $(FIRMWARE)/*.c $(FIRMWARE)/sim/*.c)

.PHONY: firmware
firmware: $(OUT)/firmware.elf

$(OUT)/$(FIRMWARE)/%.o: FLAGS += -I$(FIRMWARE) -Wconversion -pedantic

# The simulated hand reads what the firmware prints: sim/hand.c wraps uart_put.
$(OUT)/firmware.elf: $(FIRMWARE_SOURCES:%.c=$(OUT)/%.o) $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections -Wl,--wrap=uart_put $(LINK) -o $@

FIRMWARE_IMU := $(FIRMWARE)_imu
SHARED       := flash_store print tell uart sim/flash_sim sim/sim

.PHONY: firmware_imu
firmware_imu: $(OUT)/firmware_imu.elf

# Its sectors hold session and moves.
$(OUT)/$(FIRMWARE_IMU)/%.o: FLAGS += -I$(FIRMWARE_IMU) -I$(FIRMWARE) -I$(FIRMWARE)/sim -Wconversion \
    -pedantic -DFLASH_SECTOR_SIZE=4096u

$(OUT)/$(FIRMWARE_IMU)/shared/%.o: $(FIRMWARE)/%.c $(RULES)
	@mkdir -p $(@D)
	$(Q)$(CC) $(FLAGS) -MMD -MP -c $< -o $@

$(OUT)/firmware_imu.elf: $(patsubst %.c,$(OUT)/%.o,$(wildcard $(FIRMWARE_IMU)/*.c $(FIRMWARE_IMU)/sim/*.c)) \
    $(SHARED:%=$(OUT)/$(FIRMWARE_IMU)/shared/%.o) $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections -Wl,--wrap=uart_put $(LINK) -o $@
