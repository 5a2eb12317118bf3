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

INVCAL_NOINLINE uint8_t *invcali_put_u32(uint8_t *bytes, uint32_t value)
{
    for (unsigned i = 0; i < 4; i++) {
        *bytes++ = (uint8_t)(value & 0xFFu);
        value >>= 8;
    }
    return bytes;
}

static INVCAL_ONCE uint32_t bits_of(invcal_real x)
{
    uint32_t bits = NOT_A_NUMBER;

    /* the conversion of a number beyond the largest float is undefined */
    if (!INVCAL_DOUBLE || INVCAL_FABS(x) <= (invcal_real)FLT_MAX) {
        const float f = (float)x;
        memcpy(&bits, &f, sizeof bits);
    }
    return bits;
}

uint8_t *invcali_put_reals(uint8_t *bytes, const void *reals, unsigned count)
{
    const invcal_real *from = (const invcal_real *)reals;

    for (; count > 0; count--) { /* at most 48: of a record of gyro.h */
        bytes = invcali_put_u32(bytes, bits_of(*from++));
    }
    return bytes;
}

int invcali_get_reals(const uint8_t *bytes, void *reals, unsigned count)
{
    invcal_real *to = (invcal_real *)reals;
    int are_finite = 1;

    for (; count > 0; count--) { /* at most 48: of a record of gyro.h */
        const uint32_t bits = invcali_get_u32(bytes);
        float f;
        memcpy(&f, &bits, sizeof f);
        *to++ = (invcal_real)f;
        if ((bits & EXPONENT) == EXPONENT) {
            are_finite = 0;
        }
        bytes += 4;
    }
    return are_finite;
}

/* A CRC after four more bits. The polynomial is 0x04C11DB7 with its bits reversed, since the least
 * significant bit goes first; the table has what four bits leave. On an AVR it would take memory. */
static INVCAL_ONCE uint32_t after_four(uint32_t crc)
{
#ifdef __AVR__
    for (unsigned bit = 0; bit < 4; bit++) {
        const uint8_t is_odd = (uint8_t)(crc & 1u);
        crc >>= 1;
        if (is_odd) {
            crc ^= UINT32_C(0xEDB88320);
        }
    }
    return crc;
#else
    static const uint32_t table[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                       0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                       0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                       0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};

    return crc >> 4 ^ table[crc & 15u];
#endif
}

INVCAL_NOINLINE uint32_t invcali_crc32(uint32_t crc, const uint8_t *bytes, unsigned count)
{
    crc = ~crc;
    for (unsigned i = 0; i < count; i++) {
        crc = after_four(after_four(crc ^ bytes[i]));
    }
    return ~crc;
}

void invcali_seal(uint8_t *bytes, unsigned kind, unsigned length)
{
    const unsigned end = length - INVCAL_CRC_SIZE;

    (void)invcali_put_two(bytes, kind, length);
    (void)invcali_put_u32(bytes + end, invcali_crc32(0, bytes, end));
}

/* Compares the kind last: sound bytes of another version are not damaged ones. */
invcal_status invcali_unseal(const uint8_t *bytes, uint32_t size, unsigned kind)
{
    if (size < EMPTY_FRAME) {
        return INVCAL_DAMAGED;
    }
    const unsigned length = invcali_get_u16(bytes + 2);
    if (length > size || invcali_crc32(0, bytes, length) != INVCAL_CRC_RESIDUE) {
        return INVCAL_DAMAGED;
    }
    return invcali_get_u16(bytes) == kind ? INVCAL_OK : INVCAL_OTHER_VERSION;
}
