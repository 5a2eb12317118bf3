/* SPDX-License-Identifier: MIT
 *
 * fuzz.h: shared by the fuzzers of the library: inputs from the fuzzer's bytes, and what must hold for
 * a result.
 */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "invcal/expert.h"

/* The entry that libFuzzer calls. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The bytes, one after the other; zeros follow their end. */
typedef struct {
    const uint8_t *at;
    size_t left;
} source;

uint8_t take_byte(source *s);
uint32_t take_u32(source *s);
int32_t take_i32(source *s);

/* A number: mostly the usual one (always after the bytes have ended), else one near it, a power of ten,
 * a special value (NaN, infinite, denormal, the largest ...), or any bits at all. */
invcal_real take_real(source *s, invcal_real usual);

/* What positions are solved with, and how the result is used. */
typedef struct {
    invcal_calibration nominal;
    invcal_real noise;
    invcal_real prior[INVCAL_PARAMETERS];
    invcal_real field;
    int is_triangular;
    int is_linear; /* made of X */
} conditions;

/* Conditions for readings of some thousand counts; any of their values may be unusual. */
conditions take_conditions(source *s);

/* 24 directions, well spread. */
void direction_of(unsigned number, invcal_real up[3]);

/* Ends the program, with a message, if the condition does not hold. */
#define REQUIRE(condition)                                                                         \
    ((condition) ? (void)0 : fuzz_fail(__FILE__, __LINE__, #condition, __func__))
void fuzz_fail(const char *file, int line, const char *condition, const char *function);

int is_finite(invcal_real x);

/* count numbers are finite; or standard deviations: finite and not negative. */
void require_finite(const invcal_real *x, unsigned count);
void require_sigma(const invcal_real *x, unsigned count);

/* A calibration that is stored, or nominal: finite, its matrix regular. */
void require_regular(const invcal_calibration *calibration);

/* A solution: finite, positive definite relative to its nominal, no semi-axis shorter than 0.1, the centre
 * within 10; for one that was made of X = (delta, dk, gamma) these are 1/30, and 10 on each axis. If
 * nominal is nearly singular, rounding hides all but that it is finite. */
void require_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal,
                         int is_of_angles);

/* The same; and it can be made triangular and scaled, as the conditions say. */
void require_solution(const invcal_calibration *calibration, const conditions *c);

/* The quality of count positions with some left out is consistent. */
void require_quality(const invcal_quality *quality, unsigned count);
void require_noise(const invcal_quality *quality, invcal_real stated);

/* A unit vector. */
void require_direction(const invcal_real up[3]);

/* The bits of a set. */
unsigned count_bits(invcal_mask set);

/* An output that must stay as it is if a function fails: marked before, checked after. */
void mark(void *object, size_t size);
void require_mark(const void *object, size_t size);

#endif
