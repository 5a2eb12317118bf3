/* SPDX-License-Identifier: MIT
 *
 * invcal/allan.h: the noise of a sensor at rest: Allan deviation, its noise model, and how long to
 * measure a position.
 *
 *     static invcal_allan allan;                                one axis at rest, for hours
 *     if (invcal_allan_init(&allan, sizeof allan) == INVCAL_OK)
 *         for every sample:
 *             invcal_allan_feed(&allan, x);
 *     if (invcal_allan_solve(&allan, 100, &noise) == INVCAL_OK &&            100 a second
 *         invcal_noise_dwell(&noise, 1e-4f * 16384, &dwell) == INVCAL_OK &&  1e-4 of the field
 *         dwell.seconds < 3600) {
 *         invcal_session_set_hold(&session, dwell.seconds);
 *         invcal_session_set_noise(&session, dwell.sigma / 16384);
 *     }
 *
 * The worst axis decides; a session holds an hour at most. The unit is the raw count.
 *
 * For an averaging time of m samples the Allan deviation is
 *
 *     adev^2 = < (x(i) - 2 x(i - m) + x(i - 2m))^2 > / (2 m^2),      x the running total,
 *
 * half the mean square step from the mean of m samples to that of the next m (NIST SP 1065, 5.2.4:
 * the overlapping estimator). Memory is fixed: windows begin at every 2^t-th sample, with the
 * smallest t for which m <= 4 2^t, which gives octaves 93 % of the max degrees of freedom for white
 * noise.
 *
 * Sums are exact integers; only invcal_allan_get rounds. A stream may have any length:
 *
 *     squares        of readings that change by 24 bits fill their sum after 2^48 differences at
 *                    m = 65536: INVCAL_NO_SPACE;
 *     differences    their count ends at 2^32 - 1, 49 days at 1 kHz: that tau stays as it is;
 *     samples        2^32 of them act as a gap.
 *
 * Feed samples at rest only. A filter in the sensor flatters averaging times up to its time
 * constant: begin the list above it. If noise is below one count, the short ones show rounding
 * (slope -1 instead of -1/2).
 */
#ifndef INVCAL_ALLAN_H
#define INVCAL_ALLAN_H

#include "invcal/private.h"
#include "invcal/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One axis; 1424 bytes. */
typedef struct {
    uint8_t taus;                              /* averaging times in use; 0: not begun */
    uint8_t own_apart;                         /* private */
    uint32_t samples;                          /* since the last gap, modulo 2^32 */
    uint64_t own_total;                        /* private: of all samples, modulo 2^64 */
    invcal_private_tau own[INVCAL_ALLAN_TAUS]; /* private: in ascending order */
} invcal_allan;

/* Begins a stream with octaves as averaging times: 1, 2, 4 ... samples.
 *
 * size  sizeof *allan.
 *
 * Returns INVCAL_OK; INVCAL_OTHER_BUILD: samples are then ignored. */
INVCAL_NODISCARD invcal_status invcal_allan_init(invcal_allan *allan, size_t size);

/* Begins a stream with averaging times of your own.
 *
 * m         in samples, ascending, 1 ... 2^30. One above 4 must be 3 or 4 times a power of two.
 * count     how many, 1 ... INVCAL_ALLAN_TAUS.
 * is_apart  1: adjacent windows (NIST SP 1065, 5.2.2), to compare with published figures, at a
 *           division for each difference; 0: overlapping ones.
 *
 * Returns INVCAL_OK; else samples are ignored: INVCAL_OTHER_BUILD; INVCAL_BAD_TIME for any other
 * list. */
INVCAL_NODISCARD invcal_status invcal_allan_init_taus(invcal_allan *allan, size_t size,
                                                      const uint32_t *m, unsigned count,
                                                      int is_apart);

/* Feeds one sample, of any value. Cost: 360 instructions on average, when 4 of 16 octaves take it;
 * at worst all do. */
void invcal_allan_feed(invcal_allan *allan, int32_t raw);

/* Call it where samples were lost, or the sensor moved: no window spans that. All sums stay. */
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
 * index  0 ... allan->taus - 1, in the order of the list.
 * out    its edf is for white noise (NIST SP 1065, table 5), within 3 % above 10; 1.2 times smaller
 *        for flicker noise, 1.5 times for a random walk.
 *
 * Returns INVCAL_OK; INVCAL_BAD_COUNT if there is no such index; INVCAL_TOO_FEW if fewer than two
 * windows are full; INVCAL_NO_SPACE if the squares do not fit 128 bits. */
INVCAL_NODISCARD invcal_status invcal_allan_get(const invcal_allan *allan, unsigned index,
                                                invcal_allan_point *out);

/* ---- the noise model ----------------------------------------------------------------------------
 *
 *     adev^2(tau) = N^2 / tau + (2 ln 2 / pi) B^2 + K^2 tau / 3         (IEEE Std 952, annex C)
 *
 * tau in s, N in counts/sqrt(Hz), B in counts, K in counts sqrt(Hz). Times 1e6 over the counts per
 * g, they are ug/sqrt(Hz), ug, ug sqrt(Hz). One-sided densities: 2 N^2 and B^2 / (pi f). */
enum {
    INVCAL_NOISE_WHITE,       /* N: slope -1/2 */
    INVCAL_NOISE_INSTABILITY, /* B: bias instability, flicker noise; the floor is 0.664 B */
    INVCAL_NOISE_WALK,        /* K: rate random walk; slope +1/2 */
    INVCAL_NOISE_KINDS        /* their number */
};

/* The noise model, and how well it is known. Times in s. */
typedef struct {
    invcal_real coefficient[INVCAL_NOISE_KINDS]; /* N, B, K; 0 where it is not visible */
    invcal_real relative[INVCAL_NOISE_KINDS];    /* its relative standard deviation; 0 with it */
    invcal_real misfit;   /* of the residuals, in sigma, root mean square; above 1.5 the noise is of
                             another kind: filtered, a vibration, a drift */
    invcal_real minimum;  /* the smallest adev seen, counts */
    invcal_real best;     /* its tau */
    invcal_real shortest; /* averaging time used */
    invcal_real longest;  /* averaging time used */
    invcal_mask visible;  /* kinds that are visible */
} invcal_noise;

/* Fits the model to all averaging times of 5 degrees of freedom or more.
 *
 * rate  samples per second.
 *
 * Weighted least squares of adev^2: the best of the seven sets of kinds without a negative
 * coefficient; then kinds below 3 sigma are dropped, unless nothing else explains the curve.
 *
 * Returns INVCAL_OK; INVCAL_NOT_BEGUN; INVCAL_BAD_RATE unless rate is positive, and the results fit
 * the number type; INVCAL_TOO_FEW if no kind is visible, as in constant readings: go on sampling.
 * Cost: 71,000 instructions for 16 octaves. Stack: about 600 bytes. */
INVCAL_NODISCARD invcal_status invcal_allan_solve(const invcal_allan *allan, invcal_real rate,
                                                  invcal_noise *out);

/* Does a stay reach the target? */
typedef uint8_t invcal_dwell_end;
enum {
    INVCAL_DWELL_REACHED, /* it does */
    INVCAL_DWELL_BEYOND,  /* it does, if noise goes on falling beyond the averaging times seen */
    INVCAL_DWELL_FLOOR    /* never: longer is not worthwhile */
};

/* How long to stay, and the result. */
typedef struct {
    invcal_real seconds;  /* to stay */
    invcal_real sigma;    /* of the mean after that time, by the model, counts */
    invcal_dwell_end end; /* does that reach the target? */
} invcal_dwell;

/* The shortest time after which the mean of a position has the target sigma, by the model. If there
 * is none, that of the model's minimum, sqrt(3) N / K; without random walk, that after which sigma
 * is 5 % above the floor. Never shorter than noise->shortest.
 *
 * noise  from invcal_allan_solve, or a data sheet's coefficients in a struct otherwise 0.
 * sigma  the target, in the unit of noise, as adev. Over a session slow noise adds more
 *        (mathematics_programs.md, "How long to stay").
 *
 * Returns INVCAL_OK; INVCAL_BAD_NOISE if sigma is not positive, a coefficient negative or not
 * finite, all are 0, or N and shortest are; or if the time exceeds the number type. */
INVCAL_NODISCARD invcal_status invcal_noise_dwell(const invcal_noise *noise, invcal_real sigma,
                                                  invcal_dwell *out);

#ifdef __cplusplus
}
#endif

#endif
