/* SPDX-License-Identifier: MIT
 *
 * The library for the page: one session. Numbers are returned in `out`, texts in `text`.
 */
#include <math.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/plan.h"
#include "invcal/result.h"
#include "invcal/store.h"
#include "core/system.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

enum { DIRECTIONS = 512, RESULTS = 64 };

static invcal_session session;
static double out[RESULTS];
static double directions[3 * DIRECTIONS];
static char text[INVCAL_TEXT_SIZE];
static uint8_t record[INVCAL_RECORD_SIZE];

double *EXPORT(results)(void)
{
    return out;
}

double *EXPORT(direction_buffer)(void)
{
    return directions;
}

uint8_t *EXPORT(record_buffer)(void)
{
    return record;
}

/* ---- the session: see invcal.h ---------------------------------------------------------------- */

int EXPORT(begin)(double counts, unsigned rate)
{
    return (int)invcal_session_init(&session, sizeof session, counts, rate);
}

int EXPORT(feed)(int32_t x, int32_t y, int32_t z)
{
    const int32_t raw[3] = {x, y, z};

    return (int)invcal_session_feed(&session, raw[0], raw[1], raw[2]);
}

void EXPORT(gap)(void)
{
    invcal_session_gap(&session);
}

int EXPORT(finish)(void)
{
    return (int)invcal_session_end(&session);
}

unsigned EXPORT(progress)(void)
{
    return invcal_session_progress(&session);
}

unsigned EXPORT(count)(void)
{
    return session.count;
}

const char *EXPORT(why)(void)
{
    return invcal_session_reason_text(&session);
}

const char *EXPORT(status_text)(int status)
{
    return invcal_status_text((invcal_status)status);
}

const char *EXPORT(verdict_text)(int verdict)
{
    return invcal_verdict_text((invcal_verdict)verdict);
}

/* The direction to take next, and its words. */
const char *EXPORT(next)(void)
{
    invcal_session_next(&session, out);
    return invcal_direction_text(out, text);
}

/* Position i as a reading over field. */
void EXPORT(position)(unsigned i)
{
    const invcal_real *mean = session.mean[i].v;

    invcal_apply(&session.nominal, mean[0], mean[1], mean[2], out);
}

/* ---- the result so far ------------------------------------------------------------------------ */

/* For each of n directions, x y z in the buffer: replaces x by the standard deviation of a
 * calibrated length there, over that of a position. With a ridge, like that of the guidance, so
 * that it is finite from the first position on. */
void EXPORT(uncertainty)(unsigned n)
{
    invcal_sums sums;
    invcal_real h[INVCAL_PARAMETERS];

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < session.count; i++) {
        (void)invcal_sums_add(&sums, &session.nominal, session.mean[i].v, 1);
    }
    const invcal_real ridge = 1e-5 * (10 + invcali_trace(sums.sum, INVCAL_PARAMETERS));
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        sums.sum[INVCAL_PACKED(r, r)] += ridge;
    }
    (void)invcali_factor(sums.sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS, INVCAL_EPSILON);
    invcali_invert(sums.sum, INVCAL_PARAMETERS);
    for (unsigned i = 0; i < n && i < DIRECTIONS; i++) {
        const double *u = &directions[3 * i];
        const invcal_real row[INVCAL_PARAMETERS] = {u[0],        u[1],        u[2],
                                                    u[0] * u[0], u[1] * u[1], u[2] * u[2],
                                                    u[0] * u[1], u[0] * u[2], u[1] * u[2]};
        memcpy(h, row, sizeof h);
        directions[3 * i] = INVCAL_SQRT(invcali_leverage(sums.sum, h));
    }
}

/* Offset (3), matrix (9), sigma (9), coverage, verdict, left out, rms, systematic, axis, weak,
 * good; for readings whose unit is `unit` counts. The record is for a board that prints such
 * readings. */
int EXPORT(solve)(double unit)
{
    invcal_calibration c;
    invcal_quality q;
    invcal_record r;
    const invcal_status status = invcal_session_solve(&session, &c, &q);

    if (status != INVCAL_OK) {
        return (int)status;
    }
    for (int i = 0; i < 3; i++) {
        out[i] = c.offset[i] /= unit;
        for (int k = 0; k < 3; k++) {
            out[3 + 3 * i + k] = c.matrix[i][k] *= unit;
        }
    }
    memcpy(&out[12], q.sigma, sizeof q.sigma);
    out[21] = invcal_coverage(q.sigma_dof);
    out[22] = q.verdict;
    out[23] = (double)__builtin_popcountll(q.left_out);
    out[24] = q.rms;
    out[25] = q.systematic;
    out[26] = q.axis;
    out[27] = q.weak;
    out[28] = invcal_session_is_good(&session);
    invcal_record_init(&r, &c, &q);
    return (int)invcal_record_encode(&r, record);
}
