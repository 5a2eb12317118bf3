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
    for (unsigned i = 0; i < p->count; i++) {
        const double drift = p->origin[i].drift;
        if (!isnan(drift) && !(drift <= limit) && !rejection_has(r, i)) {
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

/* The position that stands out most. */
typedef struct {
    unsigned kept;
    double drop;    /* of the sum of squares without it */
    double squares; /* of all */
} suspect;

static suspect find_suspect(const invcal_thermal *c, const rejection *r, const double *inverse)
{
    const unsigned n = thermal_rows_unknowns(c);
    suspect most = {0, 0, 0};
    thermal_row row;

    for (unsigned k = 0; k < r->kept_count; k++) {
        if (!thermal_rows_one(c, &r->kept[3 * (size_t)k], r->temperature[k], &row)) {
            continue;
        }
        const double square = row.residual * row.residual;
        const double checked = 1 - thermal_rows_leverage(inverse, n, row.h);
        most.squares += square;
        if (checked > CHECKED && square / checked > most.drop) {
            most.kept = k;
            most.drop = square / checked;
        }
    }
    return most;
}

/* What stands out most of those that are left, and whether it contradicts them. */
typedef enum { NOTHING, DOUBTFUL, CONTRADICTS } judgement;

static judgement judge(const rejection *r, const invcal_thermal *c, const fit_settings *settings,
                       rejected_position *one)
{
    const unsigned unknowns = thermal_rows_unknowns(c);
    const unsigned stated = settings->noise > 0;
    double inverse[THERMAL_PACKED];

    if (r->kept_count + stated < unknowns + 3 || !thermal_rows_inverse(c, r, inverse)) {
        return NOTHING;
    }
    const suspect most = find_suspect(c, r, inverse);
    const unsigned dof = r->kept_count + stated - unknowns - 1;
    const double squares = most.squares + settings->noise * settings->noise;
    const double left = fmax(0, squares - most.drop);
    *one = (rejected_position){.position = rejection_original(r, most.kept)};
    return f_tail(left / squares, 1, dof) * r->kept_count <= ALLOWED ? CONTRADICTS : DOUBTFUL;
}

/* Leaves out, one after another, what stands out most. Those up to the last that contradicts are
 * wrong; the others come back. */
static void reject(rejection *r, const positions *p, const fit_settings *settings,
                   const thermal_wish *wish)
{
    const unsigned most = p->count / 8 < SUSPECTS_MOST ? p->count / 8 : SUSPECTS_MOST;
    unsigned position[SUSPECTS_MOST];
    unsigned count = 0;
    unsigned wrong = 0;
    invcal_thermal c;
    rejected_position one;

    while (count < most && fit(r, settings, wish, &c)) {
        const judgement seen = judge(r, &c, settings, &one);
        if (seen == NOTHING) {
            break;
        }
        position[count++] = one.position;
        wrong = seen == CONTRADICTS ? count : wrong;
        rejection_add(r, one);
        rejection_finish(r, p);
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
