/* SPDX-License-Identifier: MIT
 *
 * A board without drivers, for the program of README.md: what is left is the library's.
 */
#include "../readme/board.h"

static volatile int32_t input;
static volatile char output;

const int32_t *board_sample(void)
{
    static int32_t sample[3];

    sample[0] = input;
    return sample;
}

void board_show(const char *text)
{
    output = *text;
}

void board_use(const invcal_real g[3])
{
    output = g[0] > 0;
}

static int slot_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context, (void)slot, (void)offset, (void)size;
    bytes[0] = (uint8_t)input;
    return input;
}

static int slot_erase(void *context, unsigned slot)
{
    (void)context, (void)slot;
    return input;
}

static int slot_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                        uint32_t size)
{
    (void)context, (void)slot, (void)offset, (void)size;
    output = (char)bytes[0];
    return input;
}

const invcal_store board_result = {slot_read, slot_erase, slot_program, 0, 1024, 8};
const invcal_store board_progress = {slot_read, slot_erase, slot_program, 0, 1024, 8};
