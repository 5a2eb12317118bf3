/* SPDX-License-Identifier: MIT
 *
 * The frame of all records: integers and binary32 reals, the least significant byte first, closed
 * by a CRC-32 (store.h, "the record of a calibration"). Values are shifted into bytes one by one,
 * so neither byte order nor alignment of the machine matters; reals go through float, whatever
 * invcal_real is.
 */
#include "bytes.h"

#include <string.h>

#include "vector.h"

#define EXPONENT UINT32_C(0x7F800000) /* of binary32: all set if not finite */
#define NOT_A_NUMBER UINT32_C(0x7FC00000)

enum { EMPTY_FRAME = 8 }; /* a frame without content */

uint8_t *invcal_put_u32(uint8_t *bytes, uint32_t value)
{
    for (unsigned i = 0; i < 4; i++) {
        *bytes++ = (uint8_t)(value & 0xFFu);
        value >>= 8;
    }
    return bytes;
}

static uint32_t bits_of(invcal_real x)
{
    uint32_t bits = NOT_A_NUMBER;

    /* the conversion of a number beyond the largest float is undefined */
    if (!INVCAL_DOUBLE || INVCAL_FABS(x) <= (invcal_real)FLT_MAX) {
        const float f = (float)x;
        memcpy(&bits, &f, sizeof bits);
    }
    return bits;
}

uint8_t *invcal_put_reals(uint8_t *bytes, const void *reals, unsigned count)
{
    const unsigned char *from = (const unsigned char *)reals;
    invcal_real x;

    for (; count > 0; count--) { /* at most 48: of a record of gyro.h */
        memcpy(&x, from, sizeof x);
        from += sizeof x;
        bytes = invcal_put_u32(bytes, bits_of(x));
    }
    return bytes;
}

int invcal_get_reals(const uint8_t *bytes, void *reals, unsigned count)
{
    unsigned char *to = (unsigned char *)reals;
    int are_finite = 1;

    for (; count > 0; count--) { /* at most 48: of a record of gyro.h */
        const uint32_t bits = invcal_get_u32(bytes);
        float f;
        memcpy(&f, &bits, sizeof f);
        const invcal_real x = (invcal_real)f;
        memcpy(to, &x, sizeof x);
        if ((bits & EXPONENT) == EXPONENT) {
            are_finite = 0;
        }
        to += sizeof x;
        bytes += 4;
    }
    return are_finite;
}

/* The polynomial 0x04C11DB7 with its bits reversed, since the least significant bit goes first. */
uint32_t invcal_crc32(uint32_t crc, const uint8_t *bytes, unsigned count)
{
    crc = ~crc;
    for (unsigned i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (unsigned bit = 0; bit < 8; bit++) {
            const uint8_t is_odd = (uint8_t)(crc & 1u); /* a byte, for the AVR */
            crc >>= 1;
            if (is_odd) {
                crc ^= UINT32_C(0xEDB88320);
            }
        }
    }
    return ~crc;
}

void invcal_seal(uint8_t *bytes, unsigned kind, unsigned length)
{
    const unsigned end = length - INVCAL_CRC_SIZE;

    (void)invcal_put_two(bytes, kind, length);
    (void)invcal_put_u32(bytes + end, invcal_crc32(0, bytes, end));
}

/* Compares the kind last: sound bytes of another version are not damaged ones. */
invcal_status invcal_unseal(const uint8_t *bytes, uint32_t size, unsigned kind)
{
    if (size < EMPTY_FRAME) {
        return INVCAL_DAMAGED;
    }
    const unsigned length = invcal_get_u16(bytes + 2);
    if (length > size || invcal_crc32(0, bytes, length) != INVCAL_CRC_RESIDUE) {
        return INVCAL_DAMAGED;
    }
    return invcal_get_u16(bytes) == kind ? INVCAL_OK : INVCAL_OTHER_VERSION;
}
