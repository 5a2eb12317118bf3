/* SPDX-License-Identifier: MIT
 *
 * invcal/session.h: the whole procedure in one structure: samples in, what to tell the person out.
 *
 *     invcal_session session;
 *     invcal_session_init(&session, &setup);
 *     for every sample:
 *         what = invcal_session_feed(&session, raw, temperature, &event);
 *         show event to the person; where to turn next: invcal_session_next
 *     at any moment: invcal_session_solve
 *
 * The session watches for rests (still.h), adds each to the normal equations, keeps its mean in a
 * table, and knows what is still missing: positions of a program (plan.h) or, free hand, the
 * direction that would tell most (guidance.h).
 *
 * How long to stay is not a fixed time. With mean_sigma the noise of the first rest decides: its
 * samples scatter by s, and the mean of a time T by s / sqrt(T rate). That is white noise; slower
 * noise does not average out so, and the time ends at INVCAL_SESSION_HOLD_MAX. Who has measured
 * it, by allan.h, says so to invcal_session_hold.
 *
 * In the background the same structure serves a device that nobody calibrates on purpose: it is
 * fed with whatever comes in days. A rest in a direction that is well covered is passed over; the
 * table keeps what tells most; old positions fade; and a new calibration replaces the old one only
 * if it is the better one (invcal_session_improves).
 */
#ifndef INVCAL_SESSION_H
#define INVCAL_SESSION_H

#include "invcal/guidance.h"
#include "invcal/outlier.h"
#include "invcal/plan.h"
#include "invcal/quality.h"
#include "invcal/still.h"

#ifdef __cplusplus
extern "C" {
#endif

#define INVCAL_SESSION_HOLD_MAX 60       /* seconds: what the first rest tells is cut off there */
#define INVCAL_SESSION_HOLD_LONGEST 3600 /* seconds that can be demanded */

/* What a session is for. */
typedef struct {
    invcal_settings settings; /* nominal calibration: raw units are the counts of the samples */
    invcal_plan plan;         /* the program to follow; per_group 0: any directions */
    invcal_real target[3];    /* sigma of delta, dk, gamma that is enough; 0: any */
    invcal_real mean_sigma;   /* of a position mean on each axis, field units, that is wanted: how
                                 long to stay follows from the noise of the first rest; 0: as short
                                 as can be, see still.h */
    invcal_real rate;         /* samples per second, 8 ... 8000 */
    int32_t low, high;        /* the sensor's least and greatest counts: what lies there is
                                 clipped. Both 0: not known, clipping is not noticed */
    uint8_t background;       /* 1: nobody follows a procedure */
} invcal_session_setup;

/* What a sample brought about. */
typedef enum {
    INVCAL_SESSION_NOTHING,  /* nothing new: most samples */
    INVCAL_SESSION_MOVING,   /* no rest */
    INVCAL_SESSION_SETTLING, /* at rest: hold still, event.progress */
    INVCAL_SESSION_READY,    /* the position is good: move on. Staying makes its mean better */
    INVCAL_SESSION_TAKEN,    /* it has been left, and its mean added */
    INVCAL_SESSION_COVERED,  /* background: it has been left, but would tell hardly anything new */
    INVCAL_SESSION_REFUSED, /* it is no good: event.reason, or event.status (said again when left) */
    INVCAL_SESSION_ENOUGH,  /* as TAKEN, and sigma is within the target for the first time */
    INVCAL_SESSION_FINISHED /* as TAKEN, and it was the last of the program */
} invcal_session_what;

/* What there is to tell. */
typedef struct {
    invcal_session_what what;  /* as it was returned */
    unsigned progress;         /* percent of what a position takes at least, mean_sigma included */
    invcal_rest_reason reason; /* REFUSED: why no rest; INVCAL_REST_GOOD: it was one, see status */
    invcal_status status; /* REFUSED: why the mean of such a rest is no reading of this field */
    unsigned positions;   /* taken so far */
    int is_asked;     /* TAKEN: within 20 degrees of what was to be next; without a program: 1 */
    invcal_rest rest; /* TAKEN, COVERED: its sum, variance and place in the stream */
} invcal_event;

/* A session. Nothing in it is meant to be changed. */
typedef struct {
    invcal_session_setup setup;                /* as it began */
    invcal_still still;                        /* the detector of rests */
    invcal_normal normal;                      /* of all positions taken, outliers too */
    invcal_real mean[INVCAL_MAX_POSITIONS][3]; /* raw units; the first, or in the background the
                                               most telling ones */
    uint8_t age[INVCAL_MAX_POSITIONS];         /* background: days, by invcal_session_age */
    uint16_t stored;                           /* of the table */
    uint16_t step;                             /* of the program: the position that is to be next */
    invcal_real temperature;                   /* mean over the positions, degrees Celsius */
    invcal_real coldest;                       /* temperature of a position */
    invcal_real warmest;                       /* likewise */
    invcal_real latest;                        /* temperature of the latest sample */
    invcal_real hold;  /* seconds that a rest must be measured, as known by now */
    unsigned measured; /* positions in the mean of temperature */
    uint8_t is_enough; /* the target has been reached */
    uint8_t is_ready;  /* said of the rest that is going on */
} invcal_session;

/* Begins: nothing taken yet.
 *
 * setup  copied; not the one inside of session.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING if invcal_settings_check, invcal_plan_check or
 * invcal_still_init refuses the setup, or a target or mean_sigma is negative or NaN; INVCAL_TOO_FEW by
 * invcal_plan_check. */
invcal_status invcal_session_init(invcal_session *session, const invcal_session_setup *setup);

/* Feeds one sample.
 *
 * raw          counts.
 * temperature  degrees Celsius; anything, always the same, if there is no thermometer. A NaN, or
 *              what is too large for a mean, leaves the figures of temperature as they are.
 * event        what there is to tell; complete whenever the answer is not
 *              INVCAL_SESSION_NOTHING, else untouched.
 *
 * Returns event->what, or INVCAL_SESSION_NOTHING.
 * Cost: that of invcal_still_push; at the end of a position, with a target, that of
 * invcal_calibrate_sums. Stack: about 1,450 bytes. */
invcal_session_what invcal_session_feed(invcal_session *session, const int32_t raw[3],
                                        invcal_real temperature, invcal_event *event);

/* From now on a rest must be measured for so many seconds, or it is refused as too short, in place
 * of what the first rest told: for who knows its noise better, by invcal_noise_dwell. 0: as short
 * as can be. In the background nobody waits, and this has no effect, nor has mean_sigma.
 *
 * seconds  0 ... INVCAL_SESSION_HOLD_LONGEST; NaN and negative ones count as 0, longer ones as
 *          that. */
void invcal_session_hold(invcal_session *session, invcal_real seconds);

/* Samples were lost here. */
void invcal_session_gap(invcal_session *session);

/* No more samples come: takes the position that is held, if it is ready. Returns as feed. */
invcal_session_what invcal_session_finish(invcal_session *session, invcal_event *event);

/* Where to turn next: the program's next position, or the direction that would tell most. A
 * position that is READY and still held counts as taken.
 *
 * next  next->up; in the frame of the case; words by invcal_guidance_words.
 *
 * Returns INVCAL_OK; INVCAL_TOO_FEW if the program is complete, and nothing is left to do. */
invcal_status invcal_session_next(const invcal_session *session, invcal_guidance *next);

/* Goes on with another nominal calibration, for one that was far off: the sums are made anew from
 * the table.
 *
 * Returns INVCAL_OK; INVCAL_BAD_SETTING for an unusable one; INVCAL_NO_SPACE if more positions were
 * taken than the table holds; INVCAL_OUT_OF_RANGE if with it one of them is no reading of this
 * field. The session is untouched then. */
invcal_status invcal_session_renew(invcal_session *session, const invcal_calibration *nominal);

/* Solves what has been taken so far. The session is not changed: more may follow.
 *
 * outliers  null; or the positions of the table that contradict the others, which are then left
 *           out. None are looked for with fewer than INVCAL_OUTLIERS_FEWEST positions.
 *
 * Returns as invcal_calibrate. Stack: about 1,600 bytes. */
invcal_status invcal_session_solve(const invcal_session *session, invcal_solution *solution,
                                   invcal_quality *quality, invcal_outliers *outliers);

/* Background: a day has gone by. Positions fade: each day takes 1/32 of their weight. */
void invcal_session_age(invcal_session *session);

/* Is `found` the better calibration? 1 if its verdict is no worse, and the sum of its squared
 * sigma of delta, dk and gamma, times its coverage, is smaller. */
int invcal_session_improves(const invcal_quality *found, const invcal_quality *present);

#ifdef __cplusplus
}
#endif

#endif
