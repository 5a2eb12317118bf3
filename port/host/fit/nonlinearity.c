/* SPDX-License-Identifier: MIT */
#include "fit/nonlinearity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "maths/eigen.h"
#include "fit/fit_extended.h"
#include "maths/matrix.h"
#include "text/number.h"
#include "core/sums.h"
#include "core/system.h"

#define CONDITION_MAX 1e8
#define RIDGE 1e-5   /* relative to the number of positions */
#define HELD_MAX 0.1 /* the part of a parameter that the ridge may determine */

enum { NINE = INVCAL_PARAMETERS, UNKNOWNS_MAX = NINE + NONLINEARITY_TERMS };

static unsigned unknowns(unsigned degree)
{
    return degree > 2 ? UNKNOWNS_MAX : NINE + 3;
}

/* h, eta^3, eta^4. */
static void row_of(const double eta[3], double row[UNKNOWNS_MAX])
{
    const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    invcali_row h;

    (void)invcali_observe(&unit, eta, &h); /* a unit vector is a valid reading */
    memcpy(row, h.h, NINE * sizeof *row);
    for (unsigned a = 0; a < 3; a++) {
        row[NINE + a] = eta[a] * eta[a] * eta[a];
        row[NINE + 3 + a] = row[NINE + a] * eta[a];
    }
}

static void sum_up(const double (*direction)[3], const double *weight, unsigned count, unsigned n,
                   double *a)
{
    double row[UNKNOWNS_MAX];

    memset(a, 0, INVCAL_PACKED_SIZE(UNKNOWNS_MAX) * sizeof *a);
    for (unsigned i = 0; i < count; i++) {
        const double w = weight ? weight[i] : 1;
        row_of(direction[i], row);
        for (unsigned r = 0; r < n; r++) {
            for (unsigned c = 0; c <= r; c++) {
                a[INVCAL_PACKED(r, c)] += w * row[r] * row[c];
            }
        }
    }
}

/* If a small ridge determines a parameter by more than a tenth, the directions do not determine
 * it. */
static unsigned find_open(const double *information, unsigned count, unsigned n)
{
    double a[INVCAL_PACKED_SIZE(UNKNOWNS_MAX)];
    const double ridge = RIDGE * (count + 1);
    unsigned open = 0;

    memcpy(a, information, sizeof a);
    for (unsigned r = 0; r < n; r++) {
        a[INVCAL_PACKED(r, r)] += ridge;
    }
    if (!matrix_invert_packed(a, n)) {
        return (1u << (n - NINE)) - 1;
    }
    for (unsigned r = NINE; r < n; r++) {
        open |= (unsigned)!(ridge * a[INVCAL_PACKED(r, r)] <= HELD_MAX) << (r - NINE);
    }
    return open;
}

static double largest(const double *root, unsigned first)
{
    return fmax(root[first], fmax(root[first + 1], root[first + 2]));
}

unsigned nonlinearity_min_positions(unsigned degree)
{
    return unknowns(degree) + FIT_EXTENDED_REDUNDANT;
}

int nonlinearity_judge(const double (*direction)[3], const double *weight, unsigned count,
                       unsigned degree, nonlinearity_prospect *out, unsigned *open)
{
    const unsigned n = unknowns(degree);
    double a[INVCAL_PACKED_SIZE(UNKNOWNS_MAX)];

    sum_up(direction, weight, count, n, a);
    out->degree = degree;
    out->condition = eigen_condition(a, n);
    const unsigned bits = find_open(a, count, n);
    if (!(out->condition <= CONDITION_MAX) || bits || !matrix_invert_packed(a, n)) {
        if (open) {
            *open = bits ? bits : (1u << (n - NINE)) - 1;
        }
        return 0;
    }
    for (unsigned r = 0; r < n; r++) {
        out->root[r] = sqrt(a[INVCAL_PACKED(r, r)]);
    }
    out->quadratic = largest(out->root, NINE);
    out->cubic = degree > 2 ? largest(out->root, NINE + 3) : NUMBER_UNKNOWN;
    return 1;
}

/* The directions of calibrated readings. To be freed; null if memory is short. */
static double (*directions(const double *raw, unsigned count, const invcal_calibration *c))[3]
{
    double(*eta)[3] = malloc(((size_t)count + 1) * sizeof *eta);

    for (unsigned i = 0; eta && i < count; i++) {
        invcal_apply(c, raw[3 * (size_t)i], raw[3 * (size_t)i + 1], raw[3 * (size_t)i + 2], eta[i]);
        const double length =
            sqrt(eta[i][0] * eta[i][0] + eta[i][1] * eta[i][1] + eta[i][2] * eta[i][2]);
        for (unsigned a = 0; a < 3; a++) {
            eta[i][a] /= length;
        }
    }
    return eta;
}

unsigned nonlinearity_open(const double *raw, unsigned count, const invcal_calibration *calibration,
                           unsigned degree)
{
    double(*eta)[3] = directions(raw, count, calibration);
    nonlinearity_prospect p;
    unsigned open = 0;

    if (eta) {
        (void)nonlinearity_judge((const double(*)[3])eta, NULL, count, degree, &p, &open);
    }
    free(eta);
    return open;
}

static double power(const fit_extension *self, unsigned position, unsigned kind, double eta)
{
    (void)self;
    (void)position;
    return kind == 0 ? eta * eta : eta * eta * eta;
}

invcal_status nonlinearity_fit(const double *raw, unsigned count, const fit_settings *settings,
                               unsigned degree, fit_solution *solution, fit_quality *quality,
                               double out[NONLINEARITY_TERMS], double sigma[NONLINEARITY_TERMS])
{
    const fit_extension extension = {.kinds = degree - 1, .value = power};
    fit_solution s;
    fit_quality q;
    double found[2][NONLINEARITY_TERMS];

    const invcal_status status =
        fit_extended_make(raw, count, settings, &extension, &s, &q, found[0], found[1]);
    if (status != INVCAL_OK) {
        return status;
    }
    if (nonlinearity_open(raw, count, &s.symmetric, degree) != 0) {
        return INVCAL_UNDETERMINED;
    }
    *solution = s;
    *quality = q;
    memcpy(out, found[0], (unknowns(degree) - NINE) * sizeof *out);
    memcpy(sigma, found[1], (unknowns(degree) - NINE) * sizeof *sigma);
    return INVCAL_OK;
}

const char *nonlinearity_name(unsigned e)
{
    static const char *const names[NONLINEARITY_TERMS] = {
        "quadratic x", "quadratic y", "quadratic z", "cubic x", "cubic y", "cubic z"};

    return names[e];
}
