# SPDX-License-Identifier: MIT
# Cortex-M7 with the FPU for float and double.
include port/cortex-m/family.mk
CPU := -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16
RUN := $(QEMU) -M mps2-an500 -kernel
LONG := 1
