/* SPDX-License-Identifier: MIT
 *
 * Internal: numbers as bytes, the least significant first, on any machine.
 */
#ifndef INVCAL_BYTES_H
#define INVCAL_BYTES_H

#include "invcal/invcal.h"

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "float is not IEEE-754 binary32 here"
#endif

static inline unsigned invcal_get_u16(const uint8_t *bytes)
{
    return bytes[0] | (unsigned)bytes[1] << 8;
}

static inline uint32_t invcal_get_u32(const uint8_t *bytes)
{
    return invcal_get_u16(bytes) | (uint32_t)invcal_get_u16(bytes + 2) << 16;
}

/* Returns what is behind it. No inline function: four bytes are four stores, and that every time. */
uint8_t *invcal_put_u32(uint8_t *bytes, uint32_t value);

/* Two numbers of 16 bits. */
static inline uint8_t *invcal_put_two(uint8_t *bytes, unsigned first, unsigned second)
{
    return invcal_put_u32(bytes, (uint32_t)first | (uint32_t)second << 16);
}

/* The first count reals of a structure as binary32; one that has no float becomes a NaN. Returns
 * what is behind them. */
uint8_t *invcal_put_reals(uint8_t *bytes, const void *reals, unsigned count);

/* And back. Returns 1 if all are finite. */
int invcal_get_reals(const uint8_t *bytes, void *reals, unsigned count);

/* CRC-32 (IEEE 802.3, as zlib): of "123456789" 0xCBF43926. Starts at 0, and goes on where an
 * earlier call ended. Bit by bit: a table would be larger than all that use it. */
uint32_t invcal_crc32(uint32_t crc, const uint8_t *bytes, uint32_t count);

/* What is stored has a frame: kind, version, length (16 bits), whatever follows, and at the length's
 * end the CRC of all of it. VERSION is the present one of every kind. */
enum { INVCAL_CRC_SIZE = 4, INVCAL_VERSION_OF_BYTES = 2 };
void invcal_seal(uint8_t *bytes, uint8_t kind, unsigned length);

/* Returns INVCAL_OK; INVCAL_DAMAGED; INVCAL_OTHER_VERSION for sound bytes of another kind, or of a
 * version before `first`, or after the present one. */
invcal_status invcal_unseal(const uint8_t *bytes, uint32_t size, uint8_t kind, unsigned first);

#endif
