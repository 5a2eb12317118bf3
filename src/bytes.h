/* SPDX-License-Identifier: MIT
 *
 * Internal: numbers as bytes, the least significant first, on any machine.
 */
#ifndef INVCAL_BYTES_H
#define INVCAL_BYTES_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "invcal/config.h"

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "float is not IEEE-754 binary32 here"
#endif

static inline void invcal_put_u16(uint8_t *bytes, uint16_t value)
{
    bytes[0] = (uint8_t)(value & 0xFFu);
    bytes[1] = (uint8_t)(value >> 8);
}

static inline uint16_t invcal_get_u16(const uint8_t *bytes)
{
    return (uint16_t)(bytes[0] | (unsigned)bytes[1] << 8);
}

static inline void invcal_put_u32(uint8_t *bytes, uint32_t value)
{
    invcal_put_u16(bytes, (uint16_t)(value & 0xFFFFu));
    invcal_put_u16(bytes + 2, (uint16_t)(value >> 16));
}

static inline uint32_t invcal_get_u32(const uint8_t *bytes)
{
    return invcal_get_u16(bytes) | (uint32_t)invcal_get_u16(bytes + 2) << 16;
}

static inline void invcal_put_float(uint8_t *bytes, float value)
{
    uint32_t bits;

    memcpy(&bits, &value, sizeof bits);
    invcal_put_u32(bytes, bits);
}

static inline float invcal_get_float(const uint8_t *bytes)
{
    const uint32_t bits = invcal_get_u32(bytes);
    float value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

/* CRC-32 (IEEE 802.3, as zlib): of "123456789" 0xCBF43926. Starts at 0, and goes on where an
 * earlier call ended. Bit by bit: a table would be larger than both rooms that use it. */
static inline uint32_t invcal_crc32(uint32_t crc, const uint8_t *bytes, uint32_t count)
{
    crc = ~crc;
    for (uint32_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (unsigned bit = 0; bit < 8; bit++) {
            crc = crc & 1u ? crc >> 1 ^ UINT32_C(0xEDB88320) : crc >> 1;
        }
    }
    return ~crc;
}

/* Kind, version, length (16 bits), whatever follows, and at the length's end the CRC of all of it:
 * are these bytes something of the sort, of whatever kind and version? */
enum { INVCAL_CRC_SIZE = 4, INVCAL_SOUND_MIN = 8 };
static inline int invcal_is_sound(const uint8_t *bytes, uint32_t size)
{
    if (size < INVCAL_SOUND_MIN) {
        return 0;
    }
    const uint16_t length = invcal_get_u16(bytes + 2);
    if (length < INVCAL_SOUND_MIN || length > size) {
        return 0;
    }
    const uint16_t end = (uint16_t)(length - INVCAL_CRC_SIZE);
    return invcal_crc32(0, bytes, end) == invcal_get_u32(bytes + end);
}

/* What is written as zeros where there is nothing to tell. */
static inline int invcal_are_zero(const uint8_t *bytes, unsigned count)
{
    uint8_t any = 0;

    for (unsigned i = 0; i < count; i++) {
        any |= bytes[i];
    }
    return any == 0;
}

/* One way through many reals, with something to do at each: an action by name, as a pointer to a
 * function would be a constant that needs relocation. */
typedef enum { INVCAL_PUT, INVCAL_GET, INVCAL_TO_FLOAT } invcal_action;
typedef struct {
    invcal_action what;
    uint8_t *to;
    const uint8_t *from;
    int finite; /* 1 as long as all were, and fitted into a float */
} invcal_way;

/* Returns what x becomes: as it is when put, as it was stored when got, else as it will be. */
static inline invcal_real invcal_way_act(invcal_way *w, invcal_real x)
{
    if (w->what == INVCAL_GET) {
        x = (invcal_real)invcal_get_float(w->from);
        w->from += 4;
    }
    /* compared first: the conversion of a larger number is undefined */
    if (!(INVCAL_FABS(x) <= (invcal_real)FLT_MAX)) {
        w->finite = 0;
        return x;
    }
    if (w->what == INVCAL_PUT) {
        invcal_put_float(w->to, (float)x);
        w->to += 4;
        return x;
    }
    return (invcal_real)(float)x;
}

static inline void invcal_way_each(invcal_way *w, invcal_real *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        x[i] = invcal_way_act(w, x[i]);
    }
}

#endif
