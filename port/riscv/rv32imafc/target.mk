# SPDX-License-Identifier: MIT
# RV32IMAFC: with the FPU for float.
include port/riscv/family.mk
CPU := -march=rv32imafc -mabi=ilp32f --specs=picolibc.specs
