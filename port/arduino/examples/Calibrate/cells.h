/* SPDX-License-Identifier: MIT
 *
 * cells.h: the bytes of the EEPROM.
 *
 * An ESP32, ESP8266 or RP2040 has none, and emulates it in flash: its library works on a copy in RAM, and commit writes
 * that to flash. On an ESP32 the old copy stays until the new one is complete. The others erase it first:
 * if power fails just then, both slots are lost. These libraries have no update; their write compares, too.
 */
#ifndef CELLS_H
#define CELLS_H

#include <EEPROM.h>

const int SMALLEST_EEPROM = 1024; /* bytes */

#if defined(ESP32) || defined(ESP8266) || defined(ARDUINO_ARCH_RP2040)

static inline uint8_t cell_read(int at)
{
    static bool is_begun;

    if (!is_begun) { /* not in a constructor, when the flash may not be ready */
        EEPROM.begin(SMALLEST_EEPROM);
        is_begun = true;
    }
    return EEPROM.read(at);
}

static inline void cell_write(int at, uint8_t value)
{
    if (cell_read(at) != value) {
        EEPROM.write(at, value);
    }
}

/* After the last byte: 0, or -1 if they could not be stored. */
static inline int cells_commit()
{
    return EEPROM.commit() ? 0 : -1;
}

#else

static inline uint8_t cell_read(int at)
{
    return EEPROM.read(at);
}

static inline void cell_write(int at, uint8_t value)
{
    EEPROM.update(at, value);
}

static inline int cells_commit()
{
    return 0;
}

#endif

#endif
