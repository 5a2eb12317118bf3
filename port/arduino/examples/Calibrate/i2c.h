/* SPDX-License-Identifier: MIT
 *
 * i2c.h: the registers of a chip on the I2C bus.
 */
#ifndef I2C_H
#define I2C_H

#include <Arduino.h>

/* Before the others: 400 kHz. The pull-ups are those of the sensor's board. */
void i2c_begin();

/* Writes a register. False if the chip does not answer. */
bool i2c_set(uint8_t chip, uint8_t address, uint8_t value);

/* Reads consecutive registers. False if the chip does not answer. */
bool i2c_get(uint8_t chip, uint8_t address, uint8_t *bytes, uint8_t size);

#endif
