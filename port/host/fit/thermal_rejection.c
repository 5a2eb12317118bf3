/* SPDX-License-Identifier: MIT */
#include "fit/thermal_rejection.h"

#include <math.h>

#include "fit/thermal_rows.h"
#include "maths/f_tail.h"

#define FALSE_ALARM 0.007 /* chance that a good position is left out */
#define SUSPECTS_MAX 24u
#define REDUNDANCY_MIN 0.0001 /* the part of an error that shows in its own residual */

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

/* Fits the kept positions. Returns 0 if there is no solution. */
static int fit(const rejection *r, const fit_settings *settings, const thermal_options *options,
               invcal_thermal *out)
{
    invcal_quality quality;

    return thermal_solve(r, settings, options, out, &quality) == INVCAL_OK;
}

/* Finds the kept position whose removal would reduce the sum of squares most, by the linear rows.
 * Returns 0 if there is none. */
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
        const double redundancy = 1 - thermal_rows_leverage(inverse, n, row.h);
        if (redundancy > REDUNDANCY_MIN && row.residual * row.residual / redundancy > most) {
            *kept = k;
            most = row.residual * row.residual / redundancy;
        }
    }
    return most > 0;
}

/* The sum of squares of the kept positions, including the stated noise. */
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

/* Whether leaving out k of `all` is significantly better than leaving out any smaller number,
 * squares[0] ... squares[k - 1], given the number of choices: Fisher's F and Bonferroni's
 * inequality. */
static int beats_fewer(const double *squares, unsigned k, unsigned all, unsigned dof)
{
    double choices = 1;

    for (unsigned j = k; j-- > 0;) {
        choices *= (double)(all - j) / (k - j);
        if (!(choices * f_tail(squares[k] / squares[j], k - j, dof) <= FALSE_ALARM)) {
            return 0;
        }
    }
    return 1;
}

/* Leaves out the most suspect position, again and again. All up to the last one that contradicts
 * the others are outliers; the rest is restored. Each time the sum of squares is that of a new fit:
 * for a position of high leverage, the linear rows are too optimistic. */
static void reject(rejection *r, const positions *p, const fit_settings *settings,
                   const thermal_options *options)
{
    const unsigned most = p->count / 8 < SUSPECTS_MAX ? p->count / 8 : SUSPECTS_MAX;
    const unsigned all = r->kept_count;
    const unsigned stated = settings->noise > 0;
    unsigned position[SUSPECTS_MAX];
    double squares[SUSPECTS_MAX + 1];
    unsigned count = 0;
    unsigned wrong = 0;
    unsigned suspect = 0;
    invcal_thermal c;

    int has_fit = fit(r, settings, options, &c);
    squares[0] = has_fit ? squares_of(&c, r, settings) : 0;
    while (has_fit && count < most && r->kept_count + stated >= thermal_rows_unknowns(&c) + 3 &&
           find_suspect(&c, r, &suspect)) {
        position[count++] = rejection_original(r, suspect);
        rejection_add(r, (rejected_position){.position = position[count - 1]});
        rejection_finish(r, p);
        has_fit = fit(r, settings, options, &c);
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
                            const thermal_options *options)
{
    invcal_thermal c;

    rejection_finish(r, p);
    if (p->count > THERMAL_REJECTION_MAX || !fit(r, settings, options, &c)) {
        return;
    }
    if (c.fitted > 0) {
        reject(r, p, settings, options);
    } else if (c.fallback == INVCAL_THERMAL_NARROW) {
        rejection_search(r, p, settings);
    }
}
