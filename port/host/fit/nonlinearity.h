/* SPDX-License-Identifier: MIT
 *
 * fit/nonlinearity.h: the paper's epsilon(i): each axis reads q eta^2, and c eta^3, too much, over the field.
 *
 * In the equation of a position these are columns eta_a^3 and eta_a^4 next to the nine of h(eta), with J1
 * exactly and with lengths to the first order: both determine them by the same directions. Twelve
 * parameters with the quadratic, fifteen with both.
 */
#ifndef NONLINEARITY_H
#define NONLINEARITY_H

#include "fit/fit.h"

enum { NONLINEARITY_MOST = 6 }; /* q of x, y, z; c of x, y, z */

/* How well a set of directions determines it, before anything has been measured. */
typedef struct {
    unsigned degree;                                    /* 2: quadratic; 3: cubic as well */
    double root[INVCAL_PARAMETERS + NONLINEARITY_MOST]; /* sigma of delta, dk, gamma, q, c over the
                                                           noise of a position mean */
    double quadratic;                                   /* the largest of q, */
    double cubic;                                       /* and of c; NaN: not asked for */
    double condition;                                   /* of the system of 12 or 15 unknowns */
} nonlinearity_prospect;

/* Judges it.
 *
 * direction  unit vectors, up in the frame of the sensor.
 * weight     of each, 1 on the average; null: 1.
 * open       null, or out, if it returns 0: bit e, q_x q_y q_z c_x c_y c_z: it is not determined.
 *
 * Returns 1; 0 if the directions do not determine all of them: a condition above 10^8. */
int nonlinearity_judge(const double (*direction)[3], const double *weight, unsigned count,
                       unsigned degree, nonlinearity_prospect *out, unsigned *open);

/* The fewest positions that nonlinearity_fit takes. */
unsigned nonlinearity_least(unsigned degree);

/* Calibrates with it, by lengths alone. The calibration is what is linear.
 *
 * out    q of x, y, z and, with degree 3, c.
 * sigma  their standard deviations.
 *
 * Returns as fit_make; INVCAL_TOO_FEW with fewer than nonlinearity_least positions, 14 or 17; INVCAL_UNDETERMINED,
 * too, if the directions do not determine them: nonlinearity_open names them. */
invcal_status nonlinearity_fit(const double *raw, unsigned count, const fit_settings *settings,
                               unsigned degree, fit_solution *solution, fit_quality *quality,
                               double out[NONLINEARITY_MOST], double sigma[NONLINEARITY_MOST]);

/* Which of them readings leave open: bits as above. */
unsigned nonlinearity_open(const double *raw, unsigned count, const invcal_calibration *calibration,
                           unsigned degree);

/* "quadratic x" ... "cubic z". */
const char *nonlinearity_name(unsigned e);

#endif
