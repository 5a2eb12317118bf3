/* SPDX-License-Identifier: MIT
 *
 * As much of Wire as i2c.cpp uses: the bus ends in two functions of the test.
 */
#ifndef WIRE_H
#define WIRE_H

#include <stdint.h>

/* The chip at an address: a register, or consecutive ones. False if nobody answers. */
bool bus_write(uint8_t chip, uint8_t address, uint8_t value);
bool bus_read(uint8_t chip, uint8_t address, uint8_t *bytes, uint8_t size);

struct mock_wire {
    uint8_t chip, sent, at, bytes[2], in[32], next;

    void begin()
    {
    }
    void setClock(uint32_t)
    {
    }
    void beginTransmission(uint8_t to)
    {
        chip = to;
        sent = 0;
    }
    void write(uint8_t byte)
    {
        bytes[sent++ % 2] = byte;
    }
    uint8_t endTransmission(bool = true)
    {
        at = bytes[0];
        return sent == 2 && !bus_write(chip, at, bytes[1]);
    }
    uint8_t requestFrom(uint8_t from, uint8_t size)
    {
        next = 0;
        return size <= sizeof in && bus_read(from, at, in, size) ? size : 0;
    }
    int read()
    {
        return in[next++];
    }
};

extern mock_wire Wire;

#endif
