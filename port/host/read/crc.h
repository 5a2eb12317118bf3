/* SPDX-License-Identifier: MIT
 *
 * read/crc.h: CRC-32 (IEEE 802.3), as zip, PNG and the records of the library have it, by table: logs
 * are long.
 */
#ifndef CRC_H
#define CRC_H

#include <stddef.h>
#include <stdint.h>

/* Of the bytes after those that gave `crc`; begin with 0. */
uint32_t crc_update(uint32_t crc, const char *bytes, size_t size);

#endif
