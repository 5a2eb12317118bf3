/* SPDX-License-Identifier: MIT
 *
 * A driver that answers anything, and a memory that reads as anything, which may differ each time; or as
 * nothing, whatever the answer.
 */
#ifndef DRIVER_H
#define DRIVER_H

#include "arbitrary.h"
#include "invcal/store.h"

static int any_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    (void)slot;
    (void)offset;
    if (Frama_C_int_interval(0, 1)) {
        Frama_C_make_unknown((char *)bytes, size);
    }
    return Frama_C_int_interval(-1, 1);
}

static int any_erase(void *context, unsigned slot)
{
    (void)context;
    (void)slot;
    return Frama_C_int_interval(-1, 1);
}

static uint8_t sink;

static int any_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                       uint32_t size)
{
    (void)context;
    (void)slot;
    (void)offset;
    for (uint32_t i = 0; i < size; i++) {
        sink ^= bytes[i];
    }
    return Frama_C_int_interval(-1, 1);
}

#endif
