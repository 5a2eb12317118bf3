/* SPDX-License-Identifier: MIT
 *
 * invcal/allan.h: the noise of a sensor at rest: Allan deviation, its noise model, and how long to
 * measure a position.
 *
 *     static invcal_allan allan;                                one axis at rest, for hours
 *     invcal_allan_init(&allan, sizeof allan);
 *     for every sample:
 *         invcal_allan_feed(&allan, raw);
 *     if (invcal_allan_solve(&allan, 100, &noise) == INVCAL_OK &&            100 a second
 *         invcal_noise_dwell(&noise, 1e-4f * 16384, &dwell) == INVCAL_OK &&  1e-4 of the field
 *         dwell.seconds < 3600) {
 *         invcal_session_set_hold(&session, dwell.seconds);
 *         invcal_session_set_noise(&session, dwell.sigma / 16384);
 *     }
 *
 * The worst axis decides; a session holds at most an hour. The unit is the raw count throughout.
 *
 * For an averaging time of m samples the Allan deviation is
 *
 *     adev^2 = < (x(i) - 2 x(i - m) + x(i - 2m))^2 > / (2 m^2),      x the running total,
 *
 * half the mean square step from the mean of m samples to that of the next m (NIST SP 1065, section
 * 5.2.4: the overlapping estimator). Memory is fixed: windows begin at every 2^t-th sample, with
 * the smallest t for which m <= 4 2^t. So those of 4 samples or less begin at every sample, and
 * longer octaves overlap 4 times, which gives 93 % of the max degrees of freedom for white noise.
 *
 * Sums are exact integers; only invcal_allan_get rounds. The length of a stream is not limited:
 *
 *     squares        their sum holds 2^(128 - 2b) m^-2 differences of readings that change by b
 *                    bits: 2^48 of 24 bits at m = 65536. An overflow is detected: INVCAL_NO_SPACE;
 *     differences    their count ends at 2^32 - 1, 49 days at 1 kHz: that tau then stays as it is;
 *     samples        2^32 of them act as a gap.
 *
 * Feed samples at rest only. A filter in the sensor makes averaging times up to its time constant
 * look better than they are: begin the list above it. If noise is below one count, the short ones
 * show rounding (slope -1 instead of -1/2).
 */
#ifndef INVCAL_ALLAN_H
#define INVCAL_ALLAN_H

#include "invcal/invcal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- samples in, Allan deviations out -------------------------------------------------------- */

#define INVCAL_ALLAN_LONGEST (UINT32_C(1) << 30) /* samples: differences then fit 63 bits */

/* Internal: an averaging time, and its sum. */
typedef struct {
    uint64_t past[2 * INVCAL_PRIVATE_OVERLAP]; /* totals: a ring */
    uint64_t low, high; /* of the squares of all differences; all bits 1: overflow */
    uint32_t m;         /* samples */
    uint32_t count;     /* differences in the sum */
} invcal_allan_tau;

/* One axis; 1424 bytes. Read-only for the caller. */
typedef struct {
    uint64_t total;                          /* of all samples, modulo 2^64 */
    uint32_t samples;                        /* since the last gap, modulo 2^32 */
    uint8_t taus;                            /* how many are in use; 0: it was not begun */
    uint8_t is_apart;                        /* invcal_allan_apart */
    invcal_allan_tau tau[INVCAL_ALLAN_TAUS]; /* in ascending order */
} invcal_allan;

/* Begins a stream with octaves as averaging times: 1, 2, 4 ... samples.
 *
 * size  sizeof *allan.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_BUILD. */
INVCAL_NODISCARD invcal_status invcal_allan_init(invcal_allan *allan, size_t size);

/* Begins a stream with averaging times of your own.
 *
 * size   sizeof *allan.
 * m      in samples, ascending, 1 ... INVCAL_ALLAN_LONGEST. One above 4 must be a multiple of its
 *        2^t: 2 to 4 of them.
 * count  how many, 1 ... INVCAL_ALLAN_TAUS.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_BUILD; INVCAL_BAD_TIME for any other list. */
INVCAL_NODISCARD invcal_status invcal_allan_init_taus(invcal_allan *allan, size_t size,
                                                      const uint32_t *m, unsigned count);

/* Uses adjacent windows (NIST SP 1065, 5.2.2), to compare with published figures; overlapping ones
 * give more degrees of freedom. Call it before the first sample. Costs a 32-bit division for each
 * difference. */
void invcal_allan_apart(invcal_allan *allan);

/* Feeds one sample, of any value.
 *
 * Cost: a 64-bit difference, its square and a 128-bit addition for each averaging time up to 4; at
 * every 2^t-th sample another one for each that has this t. For 16 octaves: 4 on average, 16 at
 * most. Cost: 360 instructions on average. */
void invcal_allan_feed(invcal_allan *allan, int32_t raw);

/* Call it where samples were lost, or the sensor moved: no window spans the gap. All sums stay. */
void invcal_allan_gap(invcal_allan *allan);

/* One point of the Allan deviation. */
typedef struct {
    uint32_t m;           /* samples */
    uint32_t count;       /* differences, of adjacent or overlapping windows */
    invcal_real adev;     /* counts */
    invcal_real edf;      /* equivalent degrees of freedom of its square */
    invcal_real relative; /* 1 / sqrt(2 edf), the relative standard deviation of adev */
} invcal_allan_point;

/* The current result for one averaging time; the stream may go on.
 *
 * index  0 ... count - 1, in the order of the list.
 *
 * edf is that of white noise, by NIST SP 1065, table 5 (W FM; Howe, Allan and Barnes 1981), of n
 * totals of averages of 2^t samples:
 *
 *     edf = (3 (n - 1) / (2 m') - 2 (n - 2) / n) 4 m'^2 / (4 m'^2 + 5),    m' = m / 2^t
 *
 * Within 3 % of the exact figure for edf > 10, 10 % below. For flicker noise it is 1.2 times
 * smaller, for a random walk 1.5 times. Gaps cost differences, and so edf.
 *
 * Returns INVCAL_OK; INVCAL_BAD_TIME if there is no such index; INVCAL_TOO_FEW if fewer than two
 * windows are full; INVCAL_NO_SPACE if the squares do not fit 128 bits. */
invcal_status invcal_allan_get(const invcal_allan *allan, unsigned index, invcal_allan_point *out);

/* ---- the noise model ----------------------------------------------------------------------------
 *
 *     adev^2(tau) = N^2 / tau + (2 ln 2 / pi) B^2 + K^2 tau / 3         (IEEE Std 952, annex C)
 *
 * tau in s, N in counts/sqrt(Hz), B in counts, K in counts sqrt(Hz). Divided by the counts per g
 * and times 1e6, they are ug/sqrt(Hz), ug, ug sqrt(Hz); N in m/s^2/sqrt(Hz) times 60 is a velocity
 * random walk in m/s/sqrt(h). One-sided densities: 2 N^2 white, B^2 / (pi f) flicker. */
enum {
    INVCAL_NOISE_WHITE,       /* N: slope -1/2 */
    INVCAL_NOISE_INSTABILITY, /* B: bias instability, flicker noise; the floor is 0.664 B */
    INVCAL_NOISE_WALK,        /* K: rate random walk; slope +1/2 */
    INVCAL_NOISE_KINDS        /* their number */
};

/* The noise model, and how well it is known. */
typedef struct {
    invcal_real coefficient[INVCAL_NOISE_KINDS]; /* N, B, K; 0 where it is not visible */
    invcal_real relative[INVCAL_NOISE_KINDS];    /* its relative standard deviation; 0 with it */
    uint8_t visible;                             /* bit k: kind k is visible */
    invcal_real misfit;   /* root mean square of the residuals, in sigma. Above 1.5 the noise is of
                             another kind: filtered, a vibration, a drift */
    invcal_real minimum;  /* the smallest adev seen, counts */
    invcal_real best;     /* its tau, s */
    invcal_real shortest; /* the shortest averaging time used, s */
    invcal_real longest;  /* the longest one, s */
} invcal_noise;

/* Fits the model to all averaging times of 5 degrees of freedom or more.
 *
 * rate  samples per second.
 *
 * Least squares of adev^2 over the model, each with a relative variance of 2 / edf, plus (5 %)^2
 * for the model itself. Takes the best of the seven sets of kinds without a negative coefficient;
 * then drops kinds below 3 sigma, one by one, unless nothing else explains the curve. relative
 * assumes independent averaging times; for B and K, which correlate them, it is doubled. Simulated
 * records scatter by 0.3 to 1.1 of it.
 *
 * Returns INVCAL_OK; INVCAL_BAD_RATE unless rate is positive, and the results fit the number type;
 * INVCAL_TOO_FEW if no kind is visible: go on sampling, 20 samples show white noise. Constant
 * readings show none.
 * Cost: 71,000 instructions for 16 octaves. Stack: about 600 bytes. */
invcal_status invcal_allan_solve(const invcal_allan *allan, invcal_real rate, invcal_noise *noise);

/* adev(tau) of the model, counts; tau in s, above 0: else it means nothing. */
invcal_real invcal_noise_sigma(const invcal_noise *noise, invcal_real tau);

/* ---- how long to stay ------------------------------------------------------------------------ */

/* Does the mean reach the target after that time? */
typedef enum {
    INVCAL_DWELL_REACHED, /* it does */
    INVCAL_DWELL_BEYOND,  /* it does, if noise goes on falling beyond the averaging times seen */
    INVCAL_DWELL_FLOOR    /* never: a longer stay is not worthwhile */
} invcal_dwell_end;

/* How long to stay, and the result. */
typedef struct {
    invcal_real seconds;  /* how long to stay */
    invcal_real sigma;    /* of the mean after that time, by the model, counts */
    invcal_dwell_end end; /* whether that reaches the target */
} invcal_dwell;

/* The shortest time after which the mean of a position has the target sigma, by the model. If there
 * is none, the time of the model's min, sqrt(3) N / K; without random walk, the time after which
 * sigma is 5 % above the floor. Never shorter than noise->shortest.
 *
 * noise  from invcal_allan_solve, or a data sheet's coefficients in a struct otherwise 0, with no
 *        averaging times seen.
 * sigma  the target, counts. (Any unit common to noise and sigma will do.)
 *
 * sigma is adev(T): the standard deviation of a mean in white noise. Over a session slow noise adds
 * more (mathematics_programs.md, "How long to stay").
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOISE if sigma is not positive, a coefficient negative or not
 * finite, all are 0, or N and shortest are; or if the time exceeds the number type. */
invcal_status invcal_noise_dwell(const invcal_noise *noise, invcal_real sigma, invcal_dwell *out);

#ifdef __cplusplus
}
#endif

#endif
