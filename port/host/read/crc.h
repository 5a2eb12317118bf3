/* SPDX-License-Identifier: MIT
 *
 * read/crc.h: CRC-32 (IEEE 802.3), as in zip, PNG and the records of the library. It uses a table,
 * because logs are long.
 */
#ifndef CRC_H
#define CRC_H

#include <stddef.h>
#include <stdint.h>

/* Continues from `crc` of the bytes before; begin with 0. */
uint32_t crc_update(uint32_t crc, const char *bytes, size_t size);

#endif
