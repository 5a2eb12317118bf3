/* SPDX-License-Identifier: MIT
 *
 * As much of EEPROM as storage.cpp uses: 1024 bytes.
 */
#ifndef EEPROM_H
#define EEPROM_H

#include <stdint.h>

struct mock_eeprom {
    uint8_t cell[1024];

    uint8_t read(int at)
    {
        return cell[at];
    }
    void update(int at, uint8_t value)
    {
        cell[at] = value;
    }
};

extern mock_eeprom EEPROM;

#endif
