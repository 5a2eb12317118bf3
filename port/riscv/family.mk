# SPDX-License-Identifier: MIT
# What all RISC-V targets share. The C library is picolibc; start-up and memory layout are ours: a
# fault ends the run here, where picolibc's start-up would loop, and both are short.
PREFIX   := riscv64-unknown-elf-
LINK      = -nostartfiles -T port/riscv/sections.ld -L $(TARGET) -lm
BOARD    := port/bare.c port/semihosting.c port/riscv/start.c port/riscv/board.c
RUN      := qemu-system-riscv32 -M virt -bios none -nographic -monitor none -serial none \
            -semihosting-config enable=on,target=native -kernel
# minstret then counts ns, one per instruction.
COUNTING := -icount shift=0
UNIT     := instructions
