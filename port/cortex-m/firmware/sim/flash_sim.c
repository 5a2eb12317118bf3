/* SPDX-License-Identifier: MIT
 *
 * NOR flash: erasing sets all bits of a sector, programming clears some, and a granule may be
 * programmed once between two erasures. A call that breaks a rule fails.
 */
#include "flash.h"

#include <string.h>

#include "sim.h"

#define GRANULES (FLASH_SECTOR_SIZE / FLASH_GRANULARITY)

static struct {
    uint32_t magic;
    uint8_t *weak; /* a granule that a reset will erase; null: none */
    uint8_t sector[FLASH_SECTORS][FLASH_SECTOR_SIZE];
    uint8_t is_programmed[FLASH_SECTORS][GRANULES];
} flash SIM_NOINIT;

/* New flash is erased. */
static void power_on(void)
{
    if (sim_is_new(&flash.magic)) {
        flash.weak = NULL;
        memset(flash.sector, 0xFF, sizeof flash.sector);
        memset(flash.is_programmed, 0, sizeof flash.is_programmed);
    }
}

static int is_within(unsigned sector, uint32_t offset, uint32_t size)
{
    return sector < FLASH_SECTORS && offset <= FLASH_SECTOR_SIZE &&
           size <= FLASH_SECTOR_SIZE - offset;
}

int flash_read(unsigned sector, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    power_on();
    if (!is_within(sector, offset, size)) {
        return -1;
    }
    memcpy(bytes, &flash.sector[sector][offset], size);
    return 0;
}

int flash_erase(unsigned sector)
{
    power_on();
    if (!is_within(sector, 0, 0)) {
        return -1;
    }
    memset(flash.sector[sector], 0xFF, FLASH_SECTOR_SIZE);
    memset(flash.is_programmed[sector], 0, GRANULES);
    if (flash.weak >= flash.sector[sector] &&
        flash.weak < flash.sector[sector] + FLASH_SECTOR_SIZE) {
        flash.weak = NULL;
    }
    sim_pass(hand_erase());
    return 0;
}

static void clear_bits(uint8_t *at, const uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        at[i] &= bytes[i];
    }
}

int flash_program(unsigned sector, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    power_on();
    if (!is_within(sector, offset, size) || offset % FLASH_GRANULARITY != 0 ||
        size % FLASH_GRANULARITY != 0) {
        return -1;
    }
    uint8_t *const at = &flash.sector[sector][offset];
    const program_fate fate = hand_program();
    if (fate == PROGRAM_CUT) {
        clear_bits(at, bytes, size / 2 + 1);
        sim_reset();
    }
    for (uint32_t g = offset / FLASH_GRANULARITY; g < (offset + size) / FLASH_GRANULARITY; g++) {
        if (flash.is_programmed[sector][g]) {
            return -1;
        }
        flash.is_programmed[sector][g] = 1;
    }
    clear_bits(at, bytes, size);
    flash.weak = fate == PROGRAM_WEAK ? at : flash.weak;
    return fate == PROGRAM_WEAK;
}

void flash_fade(void)
{
    power_on();
    if (flash.weak) {
        memset(flash.weak, 0xFF, FLASH_GRANULARITY);
        flash.weak = NULL;
    }
}
