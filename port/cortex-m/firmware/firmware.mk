# SPDX-License-Identifier: MIT
#
# The example firmware:  make -f port/build.mk TARGET=port/cortex-m/m4f firmware

FIRMWARE         := port/cortex-m/firmware
FIRMWARE_SOURCES := $(wildcard $(FIRMWARE)/*.c $(FIRMWARE)/sim/*.c)

.PHONY: firmware
firmware: $(OUT)/firmware.elf

$(OUT)/$(FIRMWARE)/%.o: FLAGS += -I$(FIRMWARE) -Wconversion -pedantic

# The simulated hand reads what the firmware prints: sim/hand.c wraps uart_put.
$(OUT)/firmware.elf: $(FIRMWARE_SOURCES:%.c=$(OUT)/%.o) $(COMMON) $(LIBRARY)
	$(Q)$(CC) $(FLAGS) $^ -Wl,--gc-sections -Wl,--wrap=uart_put $(LINK) -o $@
