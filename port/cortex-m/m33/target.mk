# SPDX-License-Identifier: MIT
# Cortex-M33 with the FPU for float.
include port/cortex-m/family.mk
CPU := -mcpu=cortex-m33 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16 -DTIMER_NS=50
RUN := $(QEMU) -M mps2-an505 -kernel
