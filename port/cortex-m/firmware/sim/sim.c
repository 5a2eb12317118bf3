/* SPDX-License-Identifier: MIT
 *
 * Random numbers, and resets of the processor.
 */
#include "sim.h"

#include "uart.h"

static struct {
    uint32_t magic;
    uint32_t random;
} generator SIM_NOINIT;

int sim_is_new(uint32_t *magic)
{
    const int is_new = *magic != UINT32_C(0x1ACA1FED);

    *magic = UINT32_C(0x1ACA1FED);
    return is_new;
}

/* Marsaglia's xorshift. */
uint32_t sim_random(void)
{
    if (sim_is_new(&generator.magic)) {
        generator.random = 2463534242u;
    }
    generator.random ^= generator.random << 13;
    generator.random ^= generator.random >> 17;
    generator.random ^= generator.random << 5;
    return generator.random;
}

/* The sum of four bytes: mean 510, variance 4 (256^2 - 1) / 12. */
float sim_noise(void)
{
    const uint32_t r = sim_random();
    const uint32_t sum = (r & 255u) + (r >> 8 & 255u) + (r >> 16 & 255u) + (r >> 24);

    return ((float)sum - 510.0f) / 147.8f;
}

/* SYSRESETREQ of the Cortex-M's AIRCR. */
void sim_reset(void)
{
    uart_flush();
    flash_fade();
    *(volatile uint32_t *)0xE000ED0Cu = UINT32_C(0x05FA0004);
    for (;;) {
    }
}
