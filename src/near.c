/* SPDX-License-Identifier: MIT */
#include "near.h"

#include "vector.h"

void invcal_near_inverse(const invcal_real e[6], invcal_real out[6])
{
    const invcal_real xx = 1 + e[0];
    const invcal_real yy = 1 + e[2];
    const invcal_real zz = 1 + e[5];
    const invcal_real adj[6] = {yy * zz - e[4] * e[4],   e[3] * e[4] - e[1] * zz,
                                xx * zz - e[3] * e[3],   e[1] * e[4] - e[3] * yy,
                                e[1] * e[3] - e[4] * xx, xx * yy - e[1] * e[1]};
    const invcal_real scale = -1 / (xx * adj[0] + e[1] * adj[1] + e[3] * adj[3]);

    /* row r of the adjoint times column c of E: they commute, so the product is symmetric */
    out[0] = scale * (adj[0] * e[0] + adj[1] * e[1] + adj[3] * e[3]);
    out[1] = scale * (adj[1] * e[0] + adj[2] * e[1] + adj[4] * e[3]);
    out[2] = scale * (adj[1] * e[1] + adj[2] * e[2] + adj[4] * e[4]);
    out[3] = scale * (adj[3] * e[0] + adj[4] * e[1] + adj[5] * e[3]);
    out[4] = scale * (adj[3] * e[1] + adj[4] * e[2] + adj[5] * e[4]);
    out[5] = scale * (adj[3] * e[3] + adj[4] * e[4] + adj[5] * e[5]);
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
