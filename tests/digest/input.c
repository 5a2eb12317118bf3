/* SPDX-License-Identifier: MIT
 *
 * Simulated data. Every sum has an order of its own, so that no compiler may choose one.
 */
#include "digest.h"
#include "invcal/positions.h"

static uint32_t state; /* of the random source, xorshift32 */

void input_begin(void)
{
    state = UINT32_C(2463534242);
}

float input_uniform(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return (float)(state >> 8) / 8388608 - 1;
}

/* The variance of a uniform number is 1/3. */
float input_noise(void)
{
    float sum = 0;

    for (int i = 0; i < 3; i++) {
        sum += input_uniform();
    }
    return sum;
}

/* ---- vectors -------------------------------------------------------------------------------- */

static float square_of(const float v[3])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

void input_to_unit(float v[3])
{
    const float length = sqrtf(square_of(v));

    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

void input_cross(const float a[3], const float b[3], float out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* A random point in the unit ball, projected outwards. */
void input_direction(float out[3])
{
    do {
        for (int i = 0; i < 3; i++) {
            out[i] = input_uniform();
        }
    } while (square_of(out) > 1 || square_of(out) < 0.1f);
    input_to_unit(out);
}

/* Rodrigues' formula, for which two terms of the series of sine and cosine are exact. */
void input_turn(float v[3], const float by[3])
{
    const float square = square_of(by);
    float once[3], twice[3];

    input_cross(by, v, once);
    input_cross(by, once, twice);
    for (int i = 0; i < 3; i++) {
        v[i] += (1 - square / 6) * once[i] + (0.5f - square / 24) * twice[i];
    }
}

/* ---- sensors -------------------------------------------------------------------------------- */

void input_sample(const input_sensor *sensor, const float v[3], int32_t raw[3])
{
    for (int i = 0; i < 3; i++) {
        const float *const gain = sensor->gain[i];
        const float reading = gain[0] * v[0] + gain[1] * v[1] + gain[2] * v[2] + sensor->offset[i];
        raw[i] = (int32_t)(reading + sensor->noise * input_noise());
    }
}

void input_nominal(invcal_calibration *nominal)
{
    static const float zero[3] = {32768, 32768, 32768};
    static const float scale[3] = {4096, 4096, 4096};

    (void)invcal_nominal(zero, scale, nominal);
}

void input_positions(float raw[][3], unsigned count, float size, float noise)
{
    float x[INVCAL_PARAMETERS];

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        x[r] = size * input_uniform();
    }
    for (unsigned i = 0; i < count; i++) {
        float e[3];
        input_direction(e);
        const float u[3] = {
            (1 + x[3]) * e[0] + x[6] / 2 * e[1] + x[7] / 2 * e[2] + x[0],
            x[6] / 2 * e[0] + (1 + x[4]) * e[1] + x[8] / 2 * e[2] + x[1],
            x[7] / 2 * e[0] + x[8] / 2 * e[1] + (1 + x[5]) * e[2] + x[2],
        };
        for (int axis = 0; axis < 3; axis++) {
            raw[i][axis] = 32768 + 4096 * (u[axis] + noise * input_uniform());
        }
    }
}
