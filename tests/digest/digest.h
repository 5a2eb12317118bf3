/* SPDX-License-Identifier: MIT
 *
 * What the parts of the digest share. A part puts simulated data through the library and prints the
 * bits of everything that comes out. What goes in is equal everywhere: decimal constants, integers,
 * + - * / and square roots; so is what comes out, on all machines with IEEE-754 floats.
 */
#ifndef DIGEST_H
#define DIGEST_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/store.h"

#if INVCAL_DOUBLE || FLT_EVAL_METHOD
#error "the digest is that of the float build, where floats are computed as floats"
#endif

/* ---- lines: digest.c ------------------------------------------------------------------------ */

/* The lines after it are about this: a name; a name and a number. */
void digest_set(const char *name);
void digest_numbered(const char *name, uint32_t number);

/* A line: a name and bits, those of a number, of each of some reals; or a CRC-32, of a text, of
 * bytes. */
void digest_bits(const char *name, uint32_t bits);
void digest_reals(const char *name, const float *x, unsigned count);
void digest_text(const char *name, const char *text);
void digest_bytes(const char *name, const uint8_t *bytes, uint32_t size);

/* ---- results: results.c --------------------------------------------------------------------- */

void digest_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal);
void digest_quality(const invcal_quality *quality, const invcal_calibration *nominal);

/* ---- what goes in: input.c ------------------------------------------------------------------ */

/* Each part draws the same numbers, whether it runs alone or after others. */
void input_begin(void);

float input_uniform(void); /* -1 ... 1, exact in a float */
float input_noise(void);   /* nearly normal, standard deviation 1 */

void input_to_unit(float v[3]);
void input_cross(const float a[3], const float b[3], float out[3]);
void input_direction(float out[3]); /* uniform on the sphere */

/* Turns a vector by a small rotation vector, below 0.2 rad. */
void input_turn(float v[3], const float by[3]);

/* Of a triad: counts = gain v + offset + noise. */
typedef struct {
    float offset[3];
    float gain[3][3];
    float noise;
} input_sensor;

/* A sample of it. */
void input_sample(const input_sensor *sensor, const float v[3], int32_t raw[3]);

/* Readings at random directions of a sensor with a zero of 32768 and 4096 counts for a field of 1:
 * the nine parameters within +- size, and each reading wrong by up to +- noise. */
void input_positions(float raw[][3], unsigned count, float size, float noise);
void input_nominal(invcal_calibration *nominal);

/* ---- a memory: memory.c --------------------------------------------------------------------- */

/* Two slots, as of flash. */
extern const invcal_store memory;

/* Power fails after so many bytes: in the middle of a granule, and all callbacks fail then. */
void memory_power(uint32_t bytes);

/* ---- the parts ------------------------------------------------------------------------------ */

void part_calibrations(void);
void part_device(void);
void part_background(void);
void part_gyro(void);
void part_magnetometer(void);
void part_thermal(void);
void part_frame(void);
void part_noise(void);

#endif
