/* SPDX-License-Identifier: MIT
 *
 * invcal/normal.h: the normal equations, built position by position.
 *
 * Rows j + h p = 0 of weight w are kept as the sums H'WH, H'Wj, j'Wj (paper: H'H, H'J). Their
 * size does not depend on the number of positions, and order does not matter beyond rounding.
 */
#ifndef INVCAL_NORMAL_H
#define INVCAL_NORMAL_H

#include "invcal/observation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A symmetric matrix of n rows, lower triangle by rows: (r, c) with c <= r stands here. */
#define INVCAL_PACKED(r, c) ((r) * ((r) + 1u) / 2u + (c))
/* How many elements that takes. */
#define INVCAL_PACKED_SIZE(n) ((n) * ((n) + 1u) / 2u)

/* Every element of h h' is a product of two, three or four of x, y, z, and only 31 of the 45 are
 * different: 6 of degree 2, 10 of degree 3, 15 of degree 4. Their sums are kept. */
#define INVCAL_MOMENTS 31u

/* The sums of all positions. */
typedef struct {
    invcal_real moment[INVCAL_MOMENTS]; /* H'WH: see invcal_normal_matrix */
    invcal_real htj[INVCAL_PARAMETERS]; /* H'Wj */
    invcal_real jtj;                    /* j'Wj */
    unsigned count;                     /* equations in the sums, however faded; at
                                           most UINT_MAX */
    invcal_model model; /* of the rows in the sums; without meaning while count is 0 */
} invcal_normal;

/* Empties the sums. All bytes zero is the same state. */
void invcal_normal_init(invcal_normal *normal);

/* Adds one equation.
 *
 * weight  1 for a position like the others; (sigma_usual / sigma_this)^2 for another precision.
 *         Finite, > 0.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING for an unusable weight; INVCAL_MIXED if rows of the
 * other model are in the sums. Cost: 41 multiply-adds, no division. */
invcal_status invcal_normal_add(invcal_normal *normal, const invcal_observation *observation,
                                invcal_real weight);

/* Takes out an equation that was added with the same weight before.
 *
 * What is left equals the sums without it within a few units in the last place of the larger
 * sums; only adding the others again is exact. Without the last one the sums are empty again.
 * A row that has faded since (invcal_normal_scale) goes with its weight of today.
 *
 * Returns as invcal_normal_add, and INVCAL_TOO_FEW if the sums are empty. */
invcal_status invcal_normal_remove(invcal_normal *normal, const invcal_observation *observation,
                                   invcal_real weight);

/* Adds the sums of other to those of normal; both must stem from the same nominal calibration
 * and field. Returns INVCAL_OK; INVCAL_MIXED. */
invcal_status invcal_normal_merge(invcal_normal *normal, const invcal_normal *other);

/* Multiplies all sums, not the count: 0 < factor <= 1 lets old positions fade.
 * Returns INVCAL_OK; INVCAL_BAD_SETTING for any other factor. */
invcal_status invcal_normal_scale(invcal_normal *normal, invcal_real factor);

/* H'WH as a matrix, packed: what Cholesky takes. */
void invcal_normal_matrix(const invcal_normal *normal,
                          invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)]);

#ifdef __cplusplus
}
#endif

#endif
