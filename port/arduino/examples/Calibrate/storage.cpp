/* SPDX-License-Identifier: MIT */
#include "storage.h"

#include "cells.h"

/* Two slots for the calibration, then two for the session, which in the smallest EEPROM, of 1,024
 * bytes, hold 22 positions. A session with more is not stored. */
const int CALIBRATION_SLOT = INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1);
const int SESSION_SLOT = SMALLEST_EEPROM / 2 - CALIBRATION_SLOT;

/* Where a store begins, and the size of its slots. */
struct region {
    int begin, size;
};
static region calibrations = {0, CALIBRATION_SLOT};
static region sessions = {2 * CALIBRATION_SLOT, SESSION_SLOT};

static int address(const void *context, unsigned slot)
{
    const region *r = (const region *)context;

    return slot == 0 ? r->begin : r->begin + r->size;
}

static int read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    int at = address(context, slot) + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        *bytes++ = cell_read(at++);
    }
    return 0;
}

static int erase_slot(void *context, unsigned slot)
{
    int at = address(context, slot);

    for (int n = ((const region *)context)->size; n > 0; n--) {
        cell_write(at++, 0xFF);
    }
    return cells_commit();
}

static int program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    int at = address(context, slot) + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        cell_write(at++, *bytes++);
    }
    return cells_commit();
}

const invcal_store calibration_store = {read, erase_slot, program, &calibrations, CALIBRATION_SLOT, 1};
const invcal_store session_store = {read, erase_slot, program, &sessions, SESSION_SLOT, 1};
