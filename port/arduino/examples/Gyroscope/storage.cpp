/* SPDX-License-Identifier: MIT */
#include "storage.h"

#include "cells.h"

const int SLOT = INVCAL_STORE_BYTES(INVCAL_IMU_RECORD_SIZE, 1);

static int read(void *, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    int at = (int)slot * SLOT + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        *bytes++ = cell_read(at++);
    }
    return 0;
}

static int erase_slot(void *, unsigned slot)
{
    int at = (int)slot * SLOT;

    for (int n = SLOT; n > 0; n--) {
        cell_write(at++, 0xFF);
    }
    return cells_commit();
}

static int program(void *, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    int at = (int)slot * SLOT + (int)offset;

    for (uint8_t n = size; n > 0; n--) {
        cell_write(at++, *bytes++);
    }
    return cells_commit();
}

const invcal_store calibration_store = {read, erase_slot, program, NULL, (uint32_t)SLOT, 1};
