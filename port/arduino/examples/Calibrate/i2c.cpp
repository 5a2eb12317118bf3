/* SPDX-License-Identifier: MIT
 *
 * On an AVR, as in the Uno and the Mega, with its own registers: Wire would take 2 KB more of
 * flash and 200 bytes more of RAM. If another library uses the bus through Wire, delete the
 * first half.
 */
#include "i2c.h"

#ifdef TWBR

#include <util/twi.h>

/* One action on the bus. Returns its status; TW_BUS_ERROR after 4 ms, as when a wire is loose. */
static uint8_t act(uint8_t action)
{
    TWCR = _BV(TWINT) | _BV(TWEN) | action;
    for (uint16_t patience = 8000; patience > 0; patience--) {
        if (TWCR & _BV(TWINT)) {
            return TW_STATUS;
        }
    }
    return TW_BUS_ERROR;
}

/* Returns whether it was acknowledged. */
static bool send(uint8_t byte)
{
    TWDR = byte;
    const uint8_t status = act(0);
    return status == TW_MT_SLA_ACK || status == TW_MT_DATA_ACK || status == TW_MR_SLA_ACK;
}

static bool start(uint8_t chip, uint8_t direction)
{
    const uint8_t status = act(_BV(TWSTA));
    return (status == TW_START || status == TW_REP_START) && send(chip << 1 | direction);
}

/* Frees the bus. */
static bool stop(bool is_done)
{
    TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
    for (uint8_t patience = 255; patience > 0 && (TWCR & _BV(TWSTO)); patience--) {
    }
    return is_done;
}

void i2c_begin()
{
    TWBR = (F_CPU / 400000 - 16) / 2;
}

bool i2c_set(uint8_t chip, uint8_t address, uint8_t value)
{
    return stop(start(chip, TW_WRITE) && send(address) && send(value));
}

bool i2c_get(uint8_t chip, uint8_t address, uint8_t *bytes, uint8_t size)
{
    bool is_done = start(chip, TW_WRITE) && send(address) && start(chip, TW_READ);

    for (; is_done && size > 0; size--) {
        const uint8_t status = act(size > 1 ? _BV(TWEA) : 0); /* the last one is not acknowledged */
        is_done = status == TW_MR_DATA_ACK || status == TW_MR_DATA_NACK;
        *bytes++ = TWDR;
    }
    return stop(is_done);
}

#else

#include <Wire.h>

void i2c_begin()
{
    Wire.begin();
    Wire.setClock(400000);
}

bool i2c_set(uint8_t chip, uint8_t address, uint8_t value)
{
    Wire.beginTransmission(chip);
    Wire.write(address);
    Wire.write(value);
    return Wire.endTransmission() == 0;
}

bool i2c_get(uint8_t chip, uint8_t address, uint8_t *bytes, uint8_t size)
{
    Wire.beginTransmission(chip);
    Wire.write(address);
    if (Wire.endTransmission(false) != 0 || Wire.requestFrom(chip, size) != size) {
        return false;
    }
    for (uint8_t i = 0; i < size; i++) {
        bytes[i] = Wire.read();
    }
    return true;
}

#endif
