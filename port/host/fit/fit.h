/* SPDX-License-Identifier: MIT
 *
 * fit/fit.h: solves for the nine parameters from position means, with their accuracy.
 *
 * Everything is over the field, as in the library; fit_in_field_units converts a calibration for
 * output.
 */
#ifndef FIT_H
#define FIT_H

#include "invcal/positions.h"
#include "core/system.h"

/* What a calibration is based on. */
typedef struct {
    invcal_calibration nominal;      /* over field per input unit */
    double field;                    /* length of the field, field units: m/s^2, uT, ... */
    double noise;                    /* sigma of a position mean on each axis; 0: not known */
    double prior[INVCAL_PARAMETERS]; /* sigma of the errors of nominal; 0: not known */
    int is_six_faces;                /* prior has angles only; the verdict does not consider them */
    int is_triangular;               /* the frame of the result */
} fit_settings;

typedef struct {
    invcal_calibration calibration; /* in the requested frame */
    invcal_calibration symmetric;   /* in the frame closest to the axes of nominal */
    double x[INVCAL_PARAMETERS];    /* delta, dk, gamma: the deviation from nominal */
} fit_solution;

typedef struct {
    double sigma[INVCAL_PARAMETERS]; /* standard deviations of delta, dk, gamma */
    double sigma_offset[3];          /* and of the offset, input units */
    double coverage;     /* +- coverage * sigma holds the truth in 95 % of cases, except for
                          * parameters from a prior: fit_coverage */
    double noise;        /* of a calibrated position mean, on which sigma is based; 1: not known */
    double dof;          /* degrees of freedom of the residuals */
    double sigma_dof;    /* degrees of freedom of sigma */
    double rms;          /* of the residuals |calibrated| - 1 */
    double max;          /* of their absolute values */
    unsigned worst;      /* position of the largest residual, from 0 */
    double condition;    /* of H'WH, including the prior */
    uint16_t weak;       /* bit r: parameter r is poorly determined */
    uint16_t from_prior; /* bit r: the prior determines it more than the positions do */
    double size;         /* of the systematic error, over the field */
    unsigned systematic; /* its kind, an invcal_systematic */
    unsigned axis;       /* where it is largest */
    unsigned unchecked;  /* bit k: these positions cannot show systematic error k */
    invcal_verdict verdict;
} fit_quality;

/* Why there is no result. */
typedef struct {
    unsigned position;     /* of an invalid reading, from 0 */
    uint16_t undetermined; /* bit r: the positions do not determine parameter r */
} fit_reason;

/* Positions as the library takes them. `raw`: 3 * count numbers, x y z, ... */
invcal_positions fit_positions(const double *raw, unsigned count, const invcal_calibration *nominal,
                               double noise);

/* Calibrates.
 *
 * raw     3 * count numbers, input units.
 * reason  null; or out, written on failure only.
 *
 * Returns as invcal_calibrate_prior, or invcal_calibrate_faces. */
invcal_status fit_make(const double *raw, unsigned count, const fit_settings *settings,
                       fit_solution *solution, fit_quality *quality, fit_reason *reason);

/* Why there is no result: `status`, as solving returned it, or a more specific one.
 *
 * reason  out; may be null. */
invcal_status fit_explain(const double *raw, unsigned count, const fit_settings *settings,
                          invcal_status status, fit_reason *reason);

/* The solution that belongs to a calibration in the symmetric frame. */
fit_solution fit_solution_of(const invcal_calibration *symmetric, const fit_settings *settings);

/* The quality that the library reports of a solution, without `condition`. */
fit_quality fit_quality_of(const invcal_quality *q, const fit_settings *settings,
                           const fit_solution *solution);

/* The weight of the row of a calibrated reading eta, by its actual noise: 1 if that is the noise of
 * a nominal reading. */
double fit_weight(const invcal_calibration *symmetric, const invcal_calibration *nominal,
                  const double eta[3]);

/* The ratio of the noise of a calibrated reading to that of a nominal one: root mean square over
 * all directions. */
double fit_sensitivity(const invcal_calibration *symmetric, const invcal_calibration *nominal);

/* H'WH of the calibrated readings, including the prior, packed: noise^2 times the inverse of the
 * covariance of the nine parameters in calibrated units. `noise` is used with a prior only. */
void fit_information(const double *raw, unsigned count, const fit_settings *settings,
                     const fit_solution *solution, double noise,
                     double information[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

#define FIT_NORMAL 1.959964 /* sigma of a normal distribution that cover 95 % */

/* +- that many sigma of a parameter hold the truth in 95 % of cases. Student's t does not widen the
 * interval of a sigma that is stated. */
double fit_coverage(const fit_quality *quality, unsigned parameter);

/* Bits of the angles that six faces leave to the prior. 0 without is_six_faces. */
uint16_t fit_held(const fit_settings *settings, const fit_quality *quality);

/* 1 if any parameter has a prior. */
int fit_has_prior(const fit_settings *settings);

/* Converts a calibration over the field to field units per input unit. */
invcal_calibration fit_in_field_units(const invcal_calibration *calibration, double field);

/* And back. */
invcal_calibration fit_over_field(const invcal_calibration *calibration, double field);

#endif
