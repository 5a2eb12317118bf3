# SPDX-License-Identifier: MIT
# RV32IMAC: no FPU.
include port/riscv/family.mk
CPU := -march=rv32imac -mabi=ilp32 --specs=picolibc.specs
