# SPDX-License-Identifier: MIT
# ATmega1284P: 128 KB of flash, 16 KB of RAM.
include port/avr/family.mk
MCU := atmega1284p
RAM := 16384
# 8 bits at a time, in a simulator: one of so many random members, and no tests of a billion cycles.
SHARE := 200
# Strings and tables lie in RAM here, beside data and stack.
PARTS_test_session := 0 1 2 3
PARTS_test_still := 0 1
PARTS_test_resume := 0 1 2 3 4
