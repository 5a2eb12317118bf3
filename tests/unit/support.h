/* SPDX-License-Identifier: MIT
 *
 * Shared by the tests: a random source, a simulated triad, sets of directions. All of it computes
 * in double, whatever the library is built for.
 */
#ifndef SUPPORT_H
#define SUPPORT_H

#include <math.h>
#include <stdint.h>

#include "../positions.h"
#include "invcal/expert.h"

/* Random numbers (xorshift64*): the same everywhere for the same seed. */
typedef struct {
    uint64_t state;
} random_source;

random_source random_start(uint32_t seed);
double random_uniform(random_source *source, double low, double high);
double random_normal(random_source *source);
void random_direction(random_source *source, double direction[3]);
void random_rotation(random_source *source, double rotation[3][3]);

/* exp[v x], the rotation by a vector, rad: by Rodrigues' formula. */
void rotation_by(const double v[3], double rotation[3][3]);

/* The true parameters of a triad, in the library's order. */
typedef struct {
    double x[INVCAL_PARAMETERS];
} triad_truth;

/* Every parameter at random within +- size. */
triad_truth triad_random(random_source *source, double size);

/* u = (I + S) eta + delta: the sensor model, written out from mathematics.md. */
void triad_read(const triad_truth *truth, const double eta[3], double u[3]);

/* Readings of a set of positions, over field. */
enum { MAX_POSITIONS = 64 };
typedef struct {
    unsigned count;
    invcal_real u[MAX_POSITIONS][3];
} reading_set;

/* The readings of a triad held in count directions, each axis with normal noise of sigma. */
void read_positions(const triad_truth *truth, const double directions[][3], unsigned count,
                    double sigma, random_source *source, reading_set *out);

/* The nominal calibration of readings that are already over field: the identity. */
invcal_calibration unit_nominal(void);

/* The sums of exact rows; every reading must be accepted. */
invcal_sums sums_of(const reading_set *set);

/* Element (r, c), c <= r, of H'H. */
double element(const invcal_sums *sums, unsigned r, unsigned c);

/* invcal_calibrate_plain on a set of readings over field. */
invcal_status calibrate_set(const reading_set *set, double noise, invcal_calibration *calibration,
                            invcal_quality *quality);

/* The length of a calibrated reading of eta, over field. */
double calibrated_length(const invcal_calibration *calibration, const triad_truth *truth,
                         const double eta[3]);

/* m^-1, by Cramer's rule. */
void inverse3(const double m[3][3], double inverse[3][3]);

/* The parameters of a symmetric calibration: delta = N (offset - zero) and I + S = N M^-1, M its
 * matrix, N and zero those of the nominal calibration. */
triad_truth truth_of(const invcal_calibration *calibration, const invcal_calibration *nominal);

/* Parameter r of a calibration of readings over field. */
double parameter(const invcal_calibration *calibration, unsigned r);

double length3(const double v[3]);

/* a <- a^-1, n by n, by Gauss-Jordan elimination; positive definite, so that no pivot is small.
 * Returns ln det a. */
double invert(double *a, int n);

/* The larger one, and NaN if either is: then no bound holds. (fmax() drops it.) */
double larger(double a, double b);

/* CRC-32 (IEEE 802.3) from a table, unlike the library's. */
uint32_t crc_by_table(const uint8_t *bytes, uint32_t count);

/* Puts the CRC of the first count bytes after them, the least significant byte first. */
void seal_bytes(uint8_t *bytes, uint32_t count);

/* NAN and INFINITY are floats, and some compilers warn of their promotion in a table of doubles. */
#define NOT_A_NUMBER ((double)NAN)
#define INFINITE ((double)INFINITY) /* its negative is no constant for tcc: not in what is static */

/* TEST_SHORT is 1 on machines that run all of every test. On those that are emulated slowly it is
 * more: a loop over SOME(n) random members then visits one of TEST_SHORT, and at least one; */
#ifndef TEST_SHORT
#define TEST_SHORT 1
#endif
#define SOME(n) (((n) + TEST_SHORT - 1) / TEST_SHORT)

/* and a test of very many draws or steps that are useful only together is skipped, and says why. */
#define RUN_LONG_TEST(test) RUN_AS(test, TEST_SHORT > 1 ? skip_long : (test))
void skip_long(void);

/* The same for a test of a billion cycles, where 8 bits at a time are computed. */
#define RUN_SLOW_TEST(test) RUN_AS(test, TEST_SHORT > 100 ? skip_slow : (test))
void skip_slow(void);
#define SLOW(elsewhere, there) (TEST_SHORT > 100 ? (there) : (elsewhere))

/* A suite that is too large for a machine is built as TEST_PARTS images. Each runs the tests whose
 * line in main, modulo TEST_PARTS, is TEST_PART; the compiler drops the others. */
#ifndef TEST_PARTS
#define TEST_PARTS 1
#define TEST_PART 0
#endif
#define RUN_AS(test, function)                                                                     \
    (__LINE__ % TEST_PARTS == TEST_PART                                                            \
         ? UnityDefaultTestRun(function, #test, (UNITY_LINE_TYPE)__LINE__)                         \
         : (void)0)
#define RUN_TEST(test) RUN_AS(test, test)

/* If memory is small, TEST_RAM is its size in bytes. */
#ifndef TEST_RAM
#define TEST_RAM 1000000
#endif
#define ROOM(plenty, little) (TEST_RAM < 65536 ? (little) : (plenty))
void skip_large(void);

/* Ends a test whose own arithmetic needs a double of 53 bits, if double is float. */
void needs_53_bits(void);

/* a in the float build, b in the double build. */
#define FLOAT_OR_DOUBLE(a, b) (INVCAL_DOUBLE ? (b) : (a))

#endif
