/* SPDX-License-Identifier: MIT
 *
 * fit/fit.h: nine parameters from position means, and their accuracy.
 *
 * Everything is over the field, as in the library; fit_in_field_units converts a calibration for
 * people and files.
 */
#ifndef FIT_H
#define FIT_H

#include "invcal/expert.h"

/* What a calibration starts from. */
typedef struct {
    invcal_calibration nominal;      /* over field per input unit */
    double field;                    /* its length, field units: m/s^2, uT, ... */
    double noise;                    /* standard deviation of a position mean on each axis; 0: not
                                        known */
    double prior[INVCAL_PARAMETERS]; /* standard deviations of what nominal may be wrong by; 0:
                                        nothing is known */
    int is_six_faces;  /* the prior holds angles alone; the verdict is not about them */
    int is_triangular; /* the frame of the result */
} fit_settings;

typedef struct {
    invcal_calibration calibration; /* in the frame that is wanted */
    invcal_calibration symmetric;   /* closest to the axes of nominal */
    double x[INVCAL_PARAMETERS];    /* delta, dk, gamma: the deviation from nominal */
} fit_solution;

typedef struct {
    double sigma[INVCAL_PARAMETERS]; /* standard deviations of delta, dk, gamma, */
    double sigma_offset[3];          /* and of the offset, input units */
    double coverage;     /* +- coverage * sigma holds the truth in 95 % of cases, but for
                                        what is known from a prior: fit_coverage */
    double noise;        /* of a calibrated position mean behind them; 1: not known */
    double dof;          /* degrees of freedom left to the residuals, */
    double sigma_dof;    /* and those behind sigma */
    double rms;          /* of the residuals |calibrated| - 1, */
    double max;          /* and the largest, without its sign */
    unsigned worst;      /* its position, from 0 */
    double condition;    /* of H'WH, prior included */
    uint16_t weak;       /* bit r: parameter r is badly determined */
    uint16_t from_prior; /* bit r: the prior determines it more than the positions do */
    double size;         /* of the systematic error, over the field */
    unsigned systematic; /* an invcal_systematic, */
    unsigned axis;       /* where it is largest, */
    unsigned unchecked;  /* and bit k: of this one nothing is known */
    invcal_verdict verdict;
} fit_quality;

/* Why there is none. */
typedef struct {
    unsigned position;     /* of a bad reading, from 0 */
    uint16_t undetermined; /* bit r: the positions leave parameter r open */
} fit_reason;

/* Calibrates.
 *
 * raw     3 count numbers, input units.
 * reason  null, or why there is no result; written on failure only.
 *
 * Returns as invcal_calibrate_with_prior, or invcal_calibrate_six_faces. */
invcal_status fit_make(const double *raw, unsigned count, const fit_settings *settings,
                       fit_solution *solution, fit_quality *quality, fit_reason *reason);

/* Why there is no result: what was answered of these readings, or what says more.
 *
 * reason  out; may be null. */
invcal_status fit_explain(const double *raw, unsigned count, const fit_settings *settings,
                          invcal_status status, fit_reason *reason);

/* All of a solution from its calibration in the symmetric frame. */
fit_solution fit_solution_of(const invcal_calibration *symmetric, const fit_settings *settings);

/* What the library says of a solution, but for the condition and what came from the prior. */
fit_quality fit_quality_of(const invcal_quality *q, const fit_settings *settings,
                           const fit_solution *solution);

/* The weight of the row of a calibrated reading eta, by the noise that it really has: 1 for that of a
 * nominal reading. */
double fit_weight(const invcal_calibration *symmetric, const invcal_calibration *nominal,
                  const double eta[3]);

/* How many times as large the noise of a calibrated reading is as that of a nominal one: the root
 * mean square over all directions. */
double fit_sensitivity(const invcal_calibration *symmetric, const invcal_calibration *nominal);

/* H'WH of the calibrated readings with the prior, packed: the inverse of the covariance of the nine
 * parameters in calibrated units, over noise^2. `noise` matters with a prior only. */
void fit_information(const double *raw, unsigned count, const fit_settings *settings,
                     const fit_solution *solution, double noise,
                     double information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

#define FIT_NORMAL 1.959964 /* sigma that hold 95 % */

/* +- so many sigma of a parameter hold the truth in 95 % of cases: a sigma that is stated is not
 * widened by Student's t. */
double fit_coverage(const fit_quality *quality, unsigned parameter);

/* The angles that six faces leave to the prior: bit r for parameter r. 0 if they were not asked for. */
uint16_t fit_held(const fit_settings *settings, const fit_quality *quality);

/* 1 if there is a prior for any parameter. */
int fit_has_prior(const fit_settings *settings);

/* In field units per input unit. */
invcal_calibration fit_in_field_units(const invcal_calibration *calibration, double field);

/* And back. */
invcal_calibration fit_over_field(const invcal_calibration *calibration, double field);

#endif
