# SPDX-License-Identifier: MIT
# What all AVR targets share. Start-up is avr-libc's.
PREFIX   := avr-
OPT      := -Os
# avr-libc's sqrtf is its sqrt: double is float there, and nothing is promoted. The numbers of positions
# and moves are those of other targets, for the same tests.
CPU       = -mmcu=$(MCU) -Wno-double-promotion -DINVCAL_MAX_POSITIONS=24 -DINVCAL_MAX_SEGMENTS=192
LINK     := -lm
BOARD    := port/avr/board.c
RUN       = sh port/avr/run.sh $(MCU)
EMULATOR := simavr
UNIT     := cycles
