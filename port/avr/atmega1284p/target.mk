# SPDX-License-Identifier: MIT
# ATmega1284P: 128 KB of flash, 16 KB of RAM.
include port/avr/family.mk
MCU := atmega1284p
RAM := 16384
# An 8-bit CPU in a simulator is slow: 1 of 200 random members, and no tests of a billion cycles.
SHARE := 200
# As one program the digest would leave no RAM for the stack.
PARTS_digest := calibrations device background gyro magnetometer thermal frame noise
# They need more RAM than there is.
WITHOUT := test_allan_nist test_imu_session test_gyro_greedy
# QUICK leaves out those that take longest and are not of 16-bit arithmetic in the first place.
WITHOUT += $(if $(QUICK),test_gyro test_moves test_moves_few test_session test_thermal)
