# SPDX-License-Identifier: MIT
# PowerPC, 32 bits, the most significant byte first: a Linux program in user-mode emulation.
PREFIX := powerpc-linux-gnu-
LINK   := -static -lm
BOARD  := port/hosted/board.c port/powerpc/mffscrni.c
RUN    := qemu-ppc
