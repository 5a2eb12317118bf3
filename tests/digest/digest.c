/* SPDX-License-Identifier: MIT
 *
 * Runs the whole library on simulated data and prints the bits of every number that comes out, a
 * line each; after each part a CRC-32 of its bits, and at the end one of all of them. With
 * DIGEST_PART=device and the like it is that part alone, for a machine with too little memory.
 */
#include "digest.h"

#include "../report.h"

static uint32_t crc; /* of the part */

/* Castagnoli's polynomial, which is not that of the library's records: the CRC of bytes that end
 * with their own is always the same. */
static uint32_t add_byte(uint32_t sum, uint8_t byte)
{
    sum = ~sum ^ byte;
    for (int bit = 0; bit < 8; bit++) {
        sum = sum >> 1 ^ (sum & 1 ? UINT32_C(0x82F63B78) : 0);
    }
    return ~sum;
}

static uint32_t add_bits(uint32_t sum, uint32_t bits)
{
    for (int shift = 0; shift < 32; shift += 8) {
        sum = add_byte(sum, (uint8_t)(bits >> shift));
    }
    return sum;
}

static void put_line(const char *name, uint32_t bits)
{
    report_text(name);
    board_put(' ');
    for (int shift = 28; shift >= 0; shift -= 4) {
        board_put("0123456789ABCDEF"[bits >> shift & 0xFu]);
    }
    board_put('\n');
}

static void put_heading(const char *kind, const char *name)
{
    report_text(kind);
    report_text(name);
    board_put('\n');
}

void digest_set(const char *name)
{
    put_heading("set ", name);
}

void digest_numbered(const char *name, uint32_t number)
{
    report_text("set ");
    report(name, number);
}

void digest_bits(const char *name, uint32_t bits)
{
    crc = add_bits(crc, bits);
    put_line(name, bits);
}

void digest_reals(const char *name, const float *x, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        digest_bits(name, bits);
    }
}

void digest_text(const char *name, const char *text)
{
    digest_bytes(name, (const uint8_t *)text, (uint32_t)strlen(text));
}

void digest_bytes(const char *name, const uint8_t *bytes, uint32_t size)
{
    uint32_t sum = 0;

    for (uint32_t i = 0; i < size; i++) {
        sum = add_byte(sum, bytes[i]);
    }
    digest_bits(name, sum);
}

/* Returns the CRC of the part. */
static uint32_t run(const char *name, void (*part)(void))
{
    put_heading("part ", name);
    crc = 0;
    input_begin();
    part();
    put_line("crc", crc);
    return crc;
}

#define RUN(name) RUN_NAMED(name)
#define RUN_NAMED(name) run(#name, part_##name)

int main(void)
{
#ifdef DIGEST_PART
    (void)RUN(DIGEST_PART);
#else
    uint32_t all = 0;

    all = add_bits(all, RUN(calibrations));
    all = add_bits(all, RUN(device));
    all = add_bits(all, RUN(background));
    all = add_bits(all, RUN(gyro));
    all = add_bits(all, RUN(magnetometer));
    all = add_bits(all, RUN(thermal));
    all = add_bits(all, RUN(frame));
    all = add_bits(all, RUN(noise));
    put_line("digest", all);
#endif
    return 0;
}
