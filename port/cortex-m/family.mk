# SPDX-License-Identifier: MIT
# What all Cortex-M targets share.
PREFIX   := arm-none-eabi-
# newlib-nano: what small devices link. The whole newlib keeps 1 kB for errno.
LINK      = --specs=nano.specs -nostartfiles -Wl,-T,port/cortex-m/sections.ld -L $(TARGET) -lc -lm -lgcc
BOARD    := port/bare.c port/semihosting.c port/cortex-m/start.c port/cortex-m/board.c
QEMU     := qemu-system-arm -nographic -monitor none -serial none \
            -semihosting-config enable=on,target=native
COUNTING := -icount shift=6
UNIT     := instructions
