/* SPDX-License-Identifier: MIT
 *
 * fit/nonlinearity.h: nonlinear axes, the paper's epsilon(i): each axis reads q eta^2, or q eta^2 +
 * c eta^3, too much, over the field.
 *
 * In the equation of a position these are columns eta_a^3 and eta_a^4 next to the nine of h(eta),
 * exactly with J1 and to first order with lengths; the same directions determine them in both
 * cases. There are twelve parameters with the quadratic errors, fifteen with both.
 */
#ifndef NONLINEARITY_H
#define NONLINEARITY_H

#include "fit/fit.h"

enum { NONLINEARITY_TERMS = 6 }; /* q of x, y, z; c of x, y, z */

/* How well a set of directions determines the errors, before any measurement. `root` has delta, dk,
 * gamma, q, c, over the noise of a position mean. */
typedef struct {
    unsigned degree;                                     /* 2: quadratic; 3: cubic as well */
    double root[INVCAL_PARAMETERS + NONLINEARITY_TERMS]; /* sigma of all parameters over noise */
    double quadratic;                                    /* the largest root of q */
    double cubic;                                        /* the largest of c; NaN: not asked for */
    double condition;                                    /* of the system of 12 or 15 unknowns */
} nonlinearity_prospect;

/* Judges a set of directions.
 *
 * direction  unit vectors, up in the frame of the sensor.
 * weight     of each, 1 on average; null: all 1.
 * open       null; or out, if it returns 0: bit e of q_x q_y q_z c_x c_y c_z is not determined.
 *
 * Returns 1; 0 if the directions do not determine all of them: a condition above 10^8. */
int nonlinearity_judge(const double (*direction)[3], const double *weight, unsigned count,
                       unsigned degree, nonlinearity_prospect *out, unsigned *open);

/* The minimum number of positions for nonlinearity_fit. */
unsigned nonlinearity_min_positions(unsigned degree);

/* Calibrates with these errors, by lengths only. The calibration is the linear part.
 *
 * out    q of x, y, z and, with degree 3, c.
 * sigma  out: their standard deviations.
 *
 * Returns as fit_make; INVCAL_TOO_FEW with fewer than nonlinearity_min_positions, 14 or 17;
 * INVCAL_UNDETERMINED, too, if the directions do not determine them: nonlinearity_open names
 * them. */
invcal_status nonlinearity_fit(const double *raw, unsigned count, const fit_settings *settings,
                               unsigned degree, fit_solution *solution, fit_quality *quality,
                               double out[NONLINEARITY_TERMS], double sigma[NONLINEARITY_TERMS]);

/* The errors that readings leave undetermined: bits as above. */
unsigned nonlinearity_open(const double *raw, unsigned count, const invcal_calibration *calibration,
                           unsigned degree);

/* "quadratic x" ... "cubic z". */
const char *nonlinearity_name(unsigned e);

#endif
