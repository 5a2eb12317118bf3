/* SPDX-License-Identifier: MIT */
#include "thermal_rejection.h"

#include <float.h>
#include <math.h>

#include "invcal/fisher.h"
#include "thermal_fit.h"
#include "thermal_rows.h"

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

/* The position that stands out most. */
typedef struct {
    unsigned kept;
    double drop;    /* of the sum of squares without it */
    double checked; /* 1 - h K h' */
    double residual;
    double squares; /* of all */
} suspect;

static suspect find_suspect(const invcal_thermal_calibration *c, const rejection *r,
                            const double *l)
{
    double row[THERMAL_COEFFICIENTS];
    double residual;
    suspect most = {0, 0, 1, 0, 0};

    for (unsigned n = 0; n < r->kept_count; n++) {
        double checked = 1;
        if (!thermal_row(c, &r->kept[3 * (size_t)n], r->temperature[n], row, &residual)) {
            continue;
        }
        const unsigned count = INVCAL_PARAMETERS * (c->fitted + 1u);
        invcal_cholesky_forward(l, count, row);
        for (unsigned i = 0; i < count; i++) {
            checked -= row[i] * row[i];
        }
        most.squares += residual * residual;
        if (checked > CHECKED && residual * residual / checked > most.drop) {
            most.kept = n;
            most.drop = residual * residual / checked;
            most.checked = checked;
            most.residual = residual;
        }
    }
    return most;
}

/* What stands out most of those that are left, and whether it contradicts them. */
typedef enum { NOTHING, DOUBTFUL, CONTRADICTS } judgement;

static judgement judge(const rejection *r, const invcal_thermal_calibration *c,
                       const invcal_settings *settings, rejected_position *one)
{
    const unsigned unknowns = INVCAL_PARAMETERS * (c->fitted + 1u);
    const unsigned stated = settings->noise > 0;
    const double expected = settings->noise / settings->field;
    double l[INVCAL_PACKED_SIZE(THERMAL_COEFFICIENTS)];

    if (r->kept_count + stated < unknowns + 3 || !thermal_rows_factor(c, r, settings, NULL, 0, l)) {
        return NOTHING;
    }
    const suspect most = find_suspect(c, r, l);
    const unsigned dof = r->kept_count + stated - unknowns - 1;
    const double squares = most.squares + expected * expected;
    const double left = fmax(0, squares - most.drop);
    *one = (rejected_position){.position = rejection_original(r, most.kept),
                               .error = most.residual / most.checked,
                               .w = sqrt(most.drop / fmax(left / dof, DBL_MIN))};
    return invcal_fisher_tail(left / squares, 1, dof) * r->kept_count <= ALLOWED ? CONTRADICTS
                                                                                 : DOUBTFUL;
}

/* Beside others that were still there an error is not what it is beside the good ones. */
static void restate_errors(rejection *r, const positions *p, const unsigned *position,
                           unsigned count, const invcal_thermal_calibration *c)
{
    double row[THERMAL_COEFFICIENTS];
    double residual;

    for (unsigned i = 0; i < r->count; i++) {
        rejected_position *one = &r->list[i];
        for (unsigned k = 0; k < count; k++) {
            if (position[k] == one->position &&
                thermal_row(c, &p->mean[3 * (size_t)one->position],
                            p->origin[one->position].temperature, row, &residual)) {
                one->error = residual;
            }
        }
    }
}

/* Leaves out, one after another, what stands out most. Those up to the last that contradicts are
 * wrong; the others come back. */
static void reject(rejection *r, const positions *p, const invcal_settings *settings,
                   const invcal_thermal_settings *thermal)
{
    const unsigned most = p->count / 8 < SUSPECTS_MOST ? p->count / 8 : SUSPECTS_MOST;
    unsigned position[SUSPECTS_MOST];
    unsigned count = 0;
    unsigned wrong = 0;
    invcal_thermal_calibration c;
    invcal_quality quality;
    rejected_position one;

    while (count < most &&
           invcal_thermal_calibrate(r->kept, r->temperature, r->kept_count, settings, thermal, &c,
                                    &quality, NULL) == INVCAL_OK) {
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
    if (wrong > 1 && invcal_thermal_calibrate(r->kept, r->temperature, r->kept_count, settings,
                                              thermal, &c, &quality, NULL) == INVCAL_OK) {
        restate_errors(r, p, position, wrong, &c);
    }
}

void thermal_rejection_find(rejection *r, const positions *p, const invcal_settings *settings,
                            const invcal_thermal_settings *thermal)
{
    invcal_thermal_calibration c;
    invcal_quality quality;

    rejection_finish(r, p);
    if (p->count > THERMAL_REJECTION_MOST ||
        invcal_thermal_calibrate(r->kept, r->temperature, r->kept_count, settings, thermal, &c,
                                 &quality, NULL) != INVCAL_OK) {
        return;
    }
    if (c.fitted > 0) {
        reject(r, p, settings, thermal);
    } else if (c.fallback == INVCAL_THERMAL_NARROW) {
        rejection_search(r, p, settings);
    }
}
