/* SPDX-License-Identifier: MIT
 *
 * The functions of a store, for sectors of the flash; the context is its first sector.
 */
#include "flash.h"

/* The largest record must fit into a sector: an array of -1 elements does not compile. */
typedef char session_fits
    [FLASH_SECTOR_SIZE >= INVCAL_STORE_BYTES(INVCAL_SESSION_SIZE, FLASH_GRANULARITY) ? 1 : -1];

static unsigned sector_of(const void *context, unsigned slot)
{
    return *(const unsigned *)context + slot;
}

static int read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    return flash_read(sector_of(context, slot), offset, bytes, size);
}

static int erase(void *context, unsigned slot)
{
    return flash_erase(sector_of(context, slot));
}

static int program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                   uint32_t size)
{
    return flash_program(sector_of(context, slot), offset, bytes, size);
}

static unsigned first_sector[2] = {0, 2};

const invcal_store calibration_store = {
    read, erase, program, &first_sector[0], FLASH_SECTOR_SIZE, FLASH_GRANULARITY};
const invcal_store session_store = {
    read, erase, program, &first_sector[1], FLASH_SECTOR_SIZE, FLASH_GRANULARITY};
