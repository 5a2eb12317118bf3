/* SPDX-License-Identifier: MIT
 *
 * Internal: numbers as bytes, the least significant first, on any machine.
 */
#ifndef INVCAL_BYTES_H
#define INVCAL_BYTES_H

#include <float.h>
#include <stdint.h>
#include <string.h>

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

#endif
