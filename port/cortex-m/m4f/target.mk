# SPDX-License-Identifier: MIT
# Cortex-M4 with the FPU for float.
include port/cortex-m/family.mk
CPU := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
RUN := $(QEMU) -M mps2-an386 -kernel
PROCESSOR := cortex-m4
LEVELS := O2 Og O3 fast
