# SPDX-License-Identifier: MIT
# ATmega1284P: 128 KB of flash, 16 KB of RAM.
include port/avr/family.mk
MCU := atmega1284p
RAM := 16384
# 8 bits at a time, in a simulator: one of so many random members, and no tests of a billion cycles.
SHARE := 200
# Take more RAM than there is.
WITHOUT := test_allan_nist test_imu_session test_gyro_greedy
