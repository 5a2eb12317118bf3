# SPDX-License-Identifier: MIT
# Cortex-M3: no FPU. The M0+ runs on this machine, too.
include port/cortex-m/family.mk
CPU  := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft
LINK += -L port/cortex-m/m0plus
RUN  := $(QEMU) -M mps2-an385 -kernel
