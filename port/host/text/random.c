/* SPDX-License-Identifier: MIT */
#include "text/random.h"

#include <math.h>

random_source random_start(uint32_t seed)
{
    return (random_source){0x9E3779B97F4A7C15u ^ ((uint64_t)seed * 0xD1342543DE82EF95u)};
}

/* xorshift64* by Vigna. */
static uint32_t random_bits(random_source *source)
{
    source->state ^= source->state >> 12;
    source->state ^= source->state << 25;
    source->state ^= source->state >> 27;
    return (uint32_t)(source->state * 0x2545F4914F6CDD1Du >> 32);
}

double random_uniform(random_source *source, double low, double high)
{
    return low + (high - low) * ((random_bits(source) + 0.5) / 4294967296.0);
}

/* Box and Muller. */
double random_normal(random_source *source)
{
    const double radius = sqrt(-2 * log(random_uniform(source, 0, 1)));

    return radius * cos(random_uniform(source, 0, 6.283185307179586));
}

void random_direction(random_source *source, double direction[3])
{
    double length = 0;

    for (unsigned i = 0; i < 3; i++) {
        direction[i] = random_normal(source);
        length += direction[i] * direction[i];
    }
    for (unsigned i = 0; i < 3; i++) {
        direction[i] /= sqrt(length);
    }
}
