/* SPDX-License-Identifier: MIT */
#include "stand/group_series.h"

#include <math.h>
#include <string.h>

#include "maths/angles.h"
#include "maths/f_tail.h"
#include "maths/matrix.h"
#include "text/number.h"
#include "core/system.h"

#define SAME_ANGLE 0.5 /* degrees: tolerance of the constant angle of a group */

enum { GROUPS = INVCAL_PLAN_GROUPS, NINE = INVCAL_PARAMETERS, TERMS = SERIES_TERMS };

/* The axes of cosine and sine in each group, and their sign: the directions of series.h. */
static const struct {
    unsigned p, q; /* axis of the cosine, axis of the sine */
    double sign;   /* of both */
    unsigned gamma;
} circle[GROUPS] = {
    {1, 2, 1, INVCAL_GAMMA_ZY}, {2, 0, -1, INVCAL_GAMMA_XZ}, {1, 0, 1, INVCAL_GAMMA_XY}};

/* ---- which group --------------------------------------------------------------------------------- */

static int is_near(double degrees, double wanted)
{
    return fabs(angles_turn(wanted, degrees)) <= SAME_ANGLE;
}

/* Bit g: the position may belong to group g. */
static unsigned groups_of(const mounting_position *p)
{
    return (unsigned)is_near(p->beta, 0) << 1 | (unsigned)is_near(p->alpha, -90) << 2 |
           (unsigned)is_near(p->beta, 90) << 3;
}

static unsigned only_group(unsigned bits)
{
    return bits == 2 ? 1 : bits == 4 ? 2 : bits == 8 ? 3 : 0;
}

void group_series_groups(const mounting_position *p, unsigned count, unsigned *group)
{
    for (unsigned i = 0; i < count; i++) {
        group[i] = only_group(groups_of(&p[i]));
    }
    for (unsigned i = 1; i < count; i++) { /* as the one before */
        group[i] = group[i] == 0 && groups_of(&p[i]) >> group[i - 1] & 1 ? group[i - 1] : group[i];
    }
    for (unsigned i = count; i-- > 1;) { /* else as the one after */
        group[i - 1] =
            group[i - 1] == 0 && groups_of(&p[i - 1]) >> group[i] & 1 ? group[i] : group[i - 1];
    }
}

/* ---- fifteen coefficients ------------------------------------------------------------------------ */

/* Normal equations of a group; row TERMS holds H5'J. */
typedef struct {
    double sum[INVCAL_PACKED_SIZE(TERMS + 1)];
} equations;

static void add_row(double *a, const double *row, unsigned n, double weight)
{
    for (unsigned r = 0; r < n; r++) {
        for (unsigned c = 0; c <= r; c++) {
            a[INVCAL_PACKED(r, c)] += weight * row[r] * row[c];
        }
    }
}

/* J1 of a reading. */
static double vertical_composition(const mounting_position *p, const mounting *m,
                                   const invcal_calibration *nominal)
{
    double up[3];
    double u[3];

    mounting_turn(m, p->eta, up);
    invcal_apply(nominal, p->raw[0], p->raw[1], p->raw[2], u);
    return u[0] * up[0] + u[1] * up[1] + u[2] * up[2] - 1;
}

static void solve_group(const equations *e, unsigned g, group_series *out)
{
    double a[INVCAL_PACKED_SIZE(TERMS + 1)];

    memcpy(a, e->sum, sizeof a);
    out->is_determined[g] = matrix_invert_packed(a, TERMS);
    for (unsigned r = 0; r < TERMS; r++) {
        double sum = 0;
        for (unsigned c = 0; c < TERMS && out->is_determined[g]; c++) {
            sum += a[r >= c ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)] *
                   e->sum[INVCAL_PACKED(TERMS, c)];
        }
        out->coefficient[g][r] = out->is_determined[g] ? sum : NUMBER_UNKNOWN;
        out->root[g][r] = out->is_determined[g] ? sqrt(a[INVCAL_PACKED(r, r)]) : NUMBER_UNKNOWN;
    }
    out->count[g] = (unsigned)lround(e->sum[0]);
}

/* ---- nine parameters ----------------------------------------------------------------------------- */

/* Five rows: the coefficients of a group as functions of the nine parameters. */
static void rows_of(unsigned g, double row[TERMS][NINE])
{
    const unsigned p = INVCAL_DK_X + circle[g].p;
    const unsigned q = INVCAL_DK_X + circle[g].q;

    memset(row, 0, TERMS * sizeof *row);
    row[0][p] = row[0][q] = 0.5;
    row[1][INVCAL_DELTA_X + circle[g].p] = circle[g].sign;
    row[2][INVCAL_DELTA_X + circle[g].q] = circle[g].sign;
    row[3][p] = 0.5;
    row[3][q] = -0.5;
    row[4][circle[g].gamma] = 0.5;
}

/* T'H5'H5 T and T'H5'J. */
static void add_group(const equations *e, unsigned g, double *a)
{
    double row[TERMS][NINE];

    rows_of(g, row);
    for (unsigned r = 0; r < TERMS; r++) {
        for (unsigned c = 0; c < TERMS; c++) {
            const double h = e->sum[r >= c ? INVCAL_PACKED(r, c) : INVCAL_PACKED(c, r)];
            for (unsigned i = 0; i < NINE; i++) {
                for (unsigned k = 0; k <= i; k++) {
                    a[INVCAL_PACKED(i, k)] += row[r][i] * h * row[c][k];
                }
            }
        }
        for (unsigned i = 0; i < NINE; i++) {
            a[INVCAL_PACKED(NINE, i)] += row[r][i] * e->sum[INVCAL_PACKED(TERMS, r)];
        }
    }
}

static int solve_nine(const equations e[GROUPS], double x[NINE], double root[NINE])
{
    double a[INVCAL_PACKED_SIZE(NINE + 1)] = {0};

    for (unsigned g = 0; g < GROUPS; g++) {
        add_group(&e[g], g, a);
    }
    if (invcali_factor(a, NINE, NINE + 1, INVCAL_FLOOR) != INVCAL_OK) {
        return 0;
    }
    invcali_back_substitute(a, NINE);
    for (unsigned i = 0; i < NINE; i++) {
        x[i] = -a[INVCAL_PACKED(NINE, i)];
    }
    invcali_invert(a, NINE);
    for (unsigned i = 0; i < NINE; i++) {
        root[i] = sqrt(invcali_variance(a, NINE, i));
    }
    return 1;
}

/* ---- closure ------------------------------------------------------------------------------------- */

/* Parameter r from the coefficients of one group, and its variance / noise^2. Returns 0 if the
 * group does not depend on it. */
static int parameter_of_group(const group_series *s, unsigned g, unsigned r, const double *k,
                              double *value, double *variance)
{
    const unsigned axis = r % 3;
    const int is_p = axis == circle[g].p;

    if (!is_p && axis != circle[g].q) {
        return 0;
    }
    if (r < INVCAL_DK_X) {
        const unsigned term = is_p ? 1 : 2;
        *value = circle[g].sign * s->coefficient[g][term];
        *variance = k[INVCAL_PACKED(term, term)];
    } else {
        const double sign = is_p ? 1 : -1;
        *value = s->coefficient[g][0] + sign * s->coefficient[g][3];
        *variance =
            k[INVCAL_PACKED(0, 0)] + k[INVCAL_PACKED(3, 3)] + 2 * sign * k[INVCAL_PACKED(3, 0)];
    }
    return 1;
}

static void find_closures(const equations e[GROUPS], group_series *out)
{
    for (unsigned r = 0; r < GROUP_SERIES_CLOSURES; r++) {
        double square = 0;
        unsigned found = 0;
        for (unsigned g = 0; g < GROUPS; g++) {
            double k[INVCAL_PACKED_SIZE(TERMS + 1)];
            double value;
            double variance;
            memcpy(k, e[g].sum, sizeof k);
            (void)matrix_invert_packed(k, TERMS); /* regular: all groups are determined */
            if (parameter_of_group(out, g, r, k, &value, &variance)) {
                out->by_group[r][found++] = value;
                square += variance;
            }
        }
        out->closure[r] = out->by_group[r][1] - out->by_group[r][0];
        out->closure_root[r] = sqrt(square);
    }
}

/* ---- statistics ---------------------------------------------------------------------------------- */

/* Adds the squared residuals of J: of the fifteen coefficients, and of the nine parameters. */
static void add_residuals(const double terms[TERMS], double j, unsigned g, const group_series *s,
                          double squares[2])
{
    double row[TERMS][NINE];
    double by_fifteen = j;
    double by_nine = j;

    rows_of(g, row);
    for (unsigned t = 0; t < TERMS; t++) {
        by_fifteen -= terms[t] * s->coefficient[g][t];
        for (unsigned i = 0; i < NINE; i++) {
            by_nine -= terms[t] * row[t][i] * s->x[i];
        }
    }
    squares[0] += by_fifteen * by_fifteen;
    squares[1] += by_nine * by_nine;
}

static void find_statistics(const mounting_position *p, const unsigned *group, unsigned count,
                            const mounting *m, const invcal_calibration *nominal, group_series *out)
{
    double squares[2] = {0, 0};
    double terms[TERMS];

    for (unsigned i = 0; i < count; i++) {
        if (group[i] > 0 && !p[i].is_left_out) {
            series_terms(group[i], p[i].eta, terms);
            add_residuals(terms, vertical_composition(&p[i], m, nominal), group[i] - 1, out,
                          squares);
        }
    }
    out->dof = out->count[0] + out->count[1] + out->count[2] - GROUPS * TERMS;
    out->noise = sqrt(squares[1] / (out->dof + GROUP_SERIES_CLOSURES));
    out->f = out->dof > 0 ? (squares[1] - squares[0]) * out->dof /
                                (squares[0] * (double)GROUP_SERIES_CLOSURES)
                          : NUMBER_UNKNOWN;
    out->chance = out->dof > 0 ? f_tail(squares[0] / squares[1], GROUP_SERIES_CLOSURES, out->dof)
                               : NUMBER_UNKNOWN;
}

void group_series_find(const mounting_position *p, const unsigned *group, unsigned count,
                       const mounting *m, const invcal_calibration *nominal, group_series *out)
{
    equations e[GROUPS];
    double row[TERMS + 1];

    memset(e, 0, sizeof e);
    memset(out, 0, sizeof *out);
    out->noise = NUMBER_UNKNOWN;
    for (unsigned i = 0; i < count; i++) {
        if (group[i] > 0 && !p[i].is_left_out) {
            series_terms(group[i], p[i].eta, row);
            row[TERMS] = vertical_composition(&p[i], m, nominal);
            add_row(e[group[i] - 1].sum, row, TERMS + 1, 1);
        }
    }
    out->has_closures = 1;
    for (unsigned g = 0; g < GROUPS; g++) {
        solve_group(&e[g], g, out);
        out->has_closures = out->has_closures && out->is_determined[g];
    }
    out->has_closures = out->has_closures && solve_nine(e, out->x, out->x_root);
    if (out->has_closures) {
        find_closures(e, out);
        find_statistics(p, group, count, m, nominal, out);
    }
}
