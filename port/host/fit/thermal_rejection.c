/* SPDX-License-Identifier: MIT */
#include "fit/thermal_rejection.h"

#include <math.h>

#include "fit/thermal_rows.h"
#include "maths/f_tail.h"

#define ALLOWED 0.007 /* chance to leave out a good one */
#define SUSPECTS_MOST 24u
#define CHECKED 0.0001 /* of an error shows in the own residual, at least */

void thermal_rejection_drifting(rejection *r, const positions *p, double limit)
{
    const unsigned before = r->count;

    for (unsigned i = 0; i < p->count; i++) {
        const double drift = p->origin[i].drift;
        if (!isnan(drift) && !(drift <= limit) && !rejection_has(r, before, i)) {
            rejection_add(r, (rejected_position){.position = i, .drift = drift});
        }
    }
}

/* A fit to those that are left. Returns 0 if there is none. */
static int fit(const rejection *r, const fit_settings *settings, const thermal_wish *wish,
               invcal_thermal *out)
{
    invcal_quality quality;

    return thermal_solve(r, settings, wish, out, &quality) == INVCAL_OK;
}

/* The position that stands out most, number `kept` of those that are left, by the linear rows: what
 * the sum of squares would lose without it. Returns 0 if none can be found. */
static int find_suspect(const invcal_thermal *c, const rejection *r, unsigned *kept)
{
    const unsigned n = thermal_rows_unknowns(c);
    double inverse[THERMAL_PACKED];
    double most = 0;
    thermal_row row;

    if (!thermal_rows_inverse(c, r, inverse)) {
        return 0;
    }
    for (unsigned k = 0; k < r->kept_count; k++) {
        if (!thermal_rows_one(c, &r->kept[3 * (size_t)k], r->temperature[k], &row)) {
            continue;
        }
        const double checked = 1 - thermal_rows_leverage(inverse, n, row.h);
        if (checked > CHECKED && row.residual * row.residual / checked > most) {
            *kept = k;
            most = row.residual * row.residual / checked;
        }
    }
    return most > 0;
}

/* Of those that are left, the stated noise among them. */
static double squares_of(const invcal_thermal *c, const rejection *r, const fit_settings *settings)
{
    double squares = settings->noise * settings->noise;
    thermal_row row;

    for (unsigned k = 0; k < r->kept_count; k++) {
        if (thermal_rows_one(c, &r->kept[3 * (size_t)k], r->temperature[k], &row)) {
            squares += row.residual * row.residual;
        }
    }
    return squares;
}

/* Is leaving out k of `all` better than leaving out any fewer, squares[0] ... squares[k - 1], and not by the
 * chance of so many choices? Fisher's F and Bonferroni's inequality. */
static int beats_fewer(const double *squares, unsigned k, unsigned all, unsigned dof)
{
    double choices = 1;

    for (unsigned j = k; j-- > 0;) {
        choices *= (double)(all - j) / (k - j);
        if (!(choices * f_tail(squares[k] / squares[j], k - j, dof) <= ALLOWED)) {
            return 0;
        }
    }
    return 1;
}

/* Leaves out, one after another, what stands out most. Those up to the last that contradicts are
 * wrong; the others come back. What is left without one is found by a fit: where a position is hardly
 * checked by the others, the linear rows are too optimistic. */
static void reject(rejection *r, const positions *p, const fit_settings *settings,
                   const thermal_wish *wish)
{
    const unsigned most = p->count / 8 < SUSPECTS_MOST ? p->count / 8 : SUSPECTS_MOST;
    const unsigned all = r->kept_count;
    const unsigned stated = settings->noise > 0;
    unsigned position[SUSPECTS_MOST];
    double squares[SUSPECTS_MOST + 1];
    unsigned count = 0;
    unsigned wrong = 0;
    unsigned suspect = 0;
    invcal_thermal c;

    int has_fit = fit(r, settings, wish, &c);
    squares[0] = has_fit ? squares_of(&c, r, settings) : 0;
    while (has_fit && count < most && r->kept_count + stated >= thermal_rows_unknowns(&c) + 3 &&
           find_suspect(&c, r, &suspect)) {
        position[count++] = rejection_original(r, suspect);
        rejection_add(r, (rejected_position){.position = position[count - 1]});
        rejection_finish(r, p);
        has_fit = fit(r, settings, wish, &c);
        if (has_fit) {
            const unsigned dof = r->kept_count + stated - thermal_rows_unknowns(&c);
            squares[count] = squares_of(&c, r, settings);
            wrong = beats_fewer(squares, count, all, dof) ? count : wrong;
        }
    }
    while (count > wrong) {
        rejection_remove(r, position[--count]);
    }
    rejection_finish(r, p);
}

void thermal_rejection_find(rejection *r, const positions *p, const fit_settings *settings,
                            const thermal_wish *wish)
{
    invcal_thermal c;

    rejection_finish(r, p);
    if (p->count > THERMAL_REJECTION_MOST || !fit(r, settings, wish, &c)) {
        return;
    }
    if (c.fitted > 0) {
        reject(r, p, settings, wish);
    } else if (c.fallback == INVCAL_THERMAL_NARROW) {
        rejection_search(r, p, settings);
    }
}
