/* SPDX-License-Identifier: MIT
 *
 * For the EEPROM of an AVR. Boards that keep one in flash want EEPROM.begin(size) in setup and
 * EEPROM.commit() at the end of erase_slot and program; what their own erasing does to the other
 * slot when power fails, their documentation must tell.
 */
#include "storage.h"

#include <EEPROM.h>

/* Two slots for the calibration, and behind them two for the session: of 1,024 bytes, the least that
 * there is, they hold 22 positions. With more a session is not stored any more. */
const int SMALLEST_EEPROM = 1024;
const int CALIBRATION_SLOT = INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1);
const int SESSION_SLOT = SMALLEST_EEPROM / 2 - CALIBRATION_SLOT;

const int SLOT_SIZE[] = {CALIBRATION_SLOT, SESSION_SLOT};
static int begin[] = {0, 2 * CALIBRATION_SLOT};

static int address(const void *context, unsigned slot, uint32_t offset)
{
    const int *first = (const int *)context;

    return *first + (int)slot * SLOT_SIZE[first - begin] + (int)offset;
}

static int read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        bytes[i] = EEPROM.read(address(context, slot, offset + i));
    }
    return 0;
}

static int erase_slot(void *context, unsigned slot)
{
    const int size = SLOT_SIZE[(const int *)context - begin];

    for (int i = 0; i < size; i++) {
        EEPROM.update(address(context, slot, i), 0xFF);
    }
    return 0;
}

static int program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        EEPROM.update(address(context, slot, offset + i), bytes[i]);
    }
    return 0;
}

const invcal_store calibration_store = {read, erase_slot, program, &begin[0], CALIBRATION_SLOT, 1};
const invcal_store session_store = {read, erase_slot, program, &begin[1], SESSION_SLOT, 1};
