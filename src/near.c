/* SPDX-License-Identifier: MIT */
#include "near.h"

#include "vector.h"

/* Column by column of (I + E) X = -E with I + E = L D L', the last column first. X is symmetric:
 * what is below the diagonal of a column stands in those before. The adjoint would do without
 * two of the divisions, and lose the square of the digits. */
void invcal_near_inverse(const invcal_real e[6], invcal_real out[6])
{
    const invcal_real x = 1 / (1 + e[0]); /* D^-1 */
    const invcal_real yx = e[1] * x;      /* L */
    const invcal_real zx = e[3] * x;
    const invcal_real e2 = e[2] - yx * e[1]; /* what is left of E: y y, y z, z z */
    const invcal_real e4 = e[4] - yx * e[3];
    const invcal_real y = 1 / (1 + e2);
    const invcal_real zy = e4 * y;
    const invcal_real e5 = e[5] - zx * e[3] - zy * e4;
    const invcal_real z = 1 / (1 + e5);

    out[5] = -z * e5;
    out[4] = -y * e4 - zy * out[5];
    out[3] = -zx - yx * out[4] - zx * out[5];
    out[2] = -y * e2 - zy * out[4];
    out[1] = -yx - yx * out[2] - zx * out[4];
    out[0] = -x * e[0] - yx * out[1] - zx * out[3];
}

/* Is d I + sign E positive definite? By its leading minors; a NaN is not. */
static int is_definite(invcal_real d, invcal_real sign, const invcal_real e[6])
{
    const invcal_real xx = d + sign * e[0];
    const invcal_real yy = d + sign * e[2];
    const invcal_real zz = d + sign * e[5];
    const invcal_real minor = xx * yy - e[1] * e[1];

    return xx > 0 && minor > 0 &&
           zz * minor + sign * 2 * e[1] * e[3] * e[4] > xx * e[4] * e[4] + yy * e[3] * e[3];
}

int invcal_near_is_between(const invcal_real e[6], invcal_real low, invcal_real high)
{
    return is_definite(1 - low, 1, e) && is_definite(high - 1, -1, e);
}

/* The iteration of Denman and Beavers: Y <- (Y + Z^-1)/2, Z <- (Z + Y^-1)/2. */
void invcal_near_root(const invcal_real e[6], invcal_real y[6], invcal_real z[6])
{
    enum { MAX_STEPS = 12 }; /* eigenvalues from 0.01 to 100 take ten at most */
    invcal_real of_y[6];
    invcal_real of_z[6];
    invcal_real change = 1;

    invcal_near_inverse(e, of_y); /* the first step, from Y = I + E and Z = I */
    for (unsigned i = 0; i < 6; i++) {
        y[i] = e[i] / 2;
        z[i] = of_y[i] / 2;
    }
    for (unsigned step = 1; step < MAX_STEPS && change > INVCAL_EPSILON / 4; step++) {
        invcal_near_inverse(y, of_y);
        invcal_near_inverse(z, of_z);
        change = 0;
        INVCAL_UNROLL
        for (unsigned i = 0; i < 6; i++) {
            const invcal_real half = (of_z[i] - y[i]) / 2;
            change += half * half;
            y[i] += half;
            z[i] = (z[i] + of_y[i]) / 2;
        }
    }
}
