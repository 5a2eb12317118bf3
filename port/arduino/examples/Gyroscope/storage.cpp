/* SPDX-License-Identifier: MIT
 *
 * For the EEPROM of an AVR. Boards that emulate one in flash need EEPROM.begin(size) in setup and
 * EEPROM.commit() at the end of erase_slot and program; see their documentation for what their erasing does
 * to the other slot when power fails.
 */
#include "storage.h"

#include <EEPROM.h>

const int SLOT = INVCAL_STORE_BYTES(INVCAL_IMU_RECORD_SIZE, 1);

static int read(void *, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    int at = (int)slot * SLOT + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        *bytes++ = EEPROM.read(at++);
    }
    return 0;
}

static int erase_slot(void *, unsigned slot)
{
    int at = (int)slot * SLOT;

    for (int n = SLOT; n > 0; n--) {
        EEPROM.update(at++, 0xFF);
    }
    return 0;
}

static int program(void *, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    int at = (int)slot * SLOT + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        EEPROM.update(at++, *bytes++);
    }
    return 0;
}

const invcal_store calibration_store = {read, erase_slot, program, NULL, (uint32_t)SLOT, 1};
