/* SPDX-License-Identifier: MIT
 *
 * In place of Arduino's EEPROM, in the simulator, whose EEPROM takes no time: this one does, and power
 * may fail while a byte is written.
 */
#ifndef EEPROM_H
#define EEPROM_H

#include <Arduino.h>
#include <avr/eeprom.h>

/* Of the world (Wire.cpp): it is told of each byte that is written, and may not come back. */
void world_writes(uint8_t *at);

struct EEPROMClass {
    uint8_t read(int at)
    {
        return eeprom_read_byte((uint8_t *)at);
    }

    void update(int at, uint8_t byte)
    {
        if (read(at) != byte) {
            world_writes((uint8_t *)at);
            eeprom_write_byte((uint8_t *)at, byte);
            delayMicroseconds(3400);
        }
    }
};

static EEPROMClass EEPROM;

#endif
