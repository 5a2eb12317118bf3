# SPDX-License-Identifier: MIT
# Cortex-M0+: no FPU, no division. It runs on an emulated Cortex-M3, whose instructions include
# those of the M0+: qemu has no M0+ board with enough memory for the tests.
include port/cortex-m/family.mk
CPU := -mcpu=cortex-m0plus -mthumb -mfloat-abi=soft
RUN := $(QEMU) -M mps2-an385 -kernel
PROCESSOR := cortex-m0plus
LEVELS := O2
