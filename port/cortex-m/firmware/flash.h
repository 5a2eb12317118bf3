/* SPDX-License-Identifier: MIT
 *
 * flash.h: four sectors of NOR flash, and the two stores in them.
 */
#ifndef FLASH_H
#define FLASH_H

#include <stdint.h>

#include "invcal/store.h"

#define FLASH_SECTORS 4u
#define FLASH_SECTOR_SIZE 4096u /* a session takes 384 bytes at most, with moves 3,480 */
#define FLASH_GRANULARITY 8u    /* bytes programmed at once, and only once between two erasures */

/* Write these for your board; sim/flash_sim.c replaces them here. They return when the flash has
 * finished: 0, or anything else for a failure. Offsets are from the start of the sector. */
int flash_read(unsigned sector, uint32_t offset, uint8_t *bytes, uint32_t size);
int flash_erase(unsigned sector);
int flash_program(unsigned sector, uint32_t offset, const uint8_t *bytes, uint32_t size);

/* The calibration in sectors 0 and 1; the current session in 2 and 3. */
extern const invcal_store calibration_store;
extern const invcal_store session_store;

#endif
