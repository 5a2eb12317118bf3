/* SPDX-License-Identifier: MIT */
#include "read/crc.h"

static uint32_t table[256];

static void make_table(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t c = i;
        for (unsigned bit = 0; bit < 8; bit++) {
            c = c & 1u ? c >> 1 ^ UINT32_C(0xEDB88320) : c >> 1;
        }
        table[i] = c;
    }
}

uint32_t crc_update(uint32_t crc, const char *bytes, size_t size)
{
    if (table[1] == 0) {
        make_table();
    }
    crc = ~crc;
    for (size_t i = 0; i < size; i++) {
        crc = crc >> 8 ^ table[(crc ^ (unsigned char)bytes[i]) & 0xFFu];
    }
    return ~crc;
}
