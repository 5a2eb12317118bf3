/* SPDX-License-Identifier: MIT
 *
 * An EEPROM that is emulated in flash, as by the cores for ESP32, ESP8266 and RP2040, in as much as cells.h uses. They
 * have no update; before begin, reading gives 0 and writing does nothing; only commit lasts. The flash is a file.
 */
#ifndef EEPROM_H
#define EEPROM_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct mock_eeprom {
    const char *flash;
    bool fails;
    uint8_t copy[1024];
    size_t size;

    bool begin(size_t bytes)
    {
        FILE *file = fopen(flash, "rb");

        size = bytes <= sizeof copy ? bytes : 0;
        memset(copy, 0xFF, sizeof copy);
        return file && fread(copy, 1, size, file) == size && fclose(file) == 0;
    }
    uint8_t read(int at)
    {
        return (size_t)at < size ? copy[at] : 0;
    }
    void write(int at, uint8_t value)
    {
        if ((size_t)at < size) {
            copy[at] = value;
        }
    }
    bool commit()
    {
        FILE *file = fails || size == 0 ? NULL : fopen(flash, "wb");

        return file && fwrite(copy, 1, size, file) == size && fclose(file) == 0;
    }
};

extern mock_eeprom EEPROM;

#endif
