/* SPDX-License-Identifier: MIT
 *
 * design/covariance.h: K = (H'H)^-1 of a set of directions, fast enough for a search.
 */
#ifndef COVARIANCE_H
#define COVARIANCE_H

#include "cli/command.h"

/* The row h(eta) of a direction. */
void covariance_row(const double up[3], double h[INVCAL_PARAMETERS]);

/* K of `count` directions, weighted unless `weight` is null. A ridge of 1e-9 keeps the variance of
 * undetermined parameters finite. Returns ln det H'H. */
double covariance_find(const double (*direction)[3], const double *weight, unsigned count,
                       double K[INVCAL_PARAMETERS][INVCAL_PARAMETERS]);

/* K a'. */
void covariance_image(double K[INVCAL_PARAMETERS][INVCAL_PARAMETERS], const double *a,
                      double out[INVCAL_PARAMETERS]);

/* a K b'. */
double covariance_product(double K[INVCAL_PARAMETERS][INVCAL_PARAMETERS], const double *a,
                          const double *b);

#endif
