/* SPDX-License-Identifier: MIT
 *
 * Which turn to make next. Nothing is remembered between calls: which turns of the tour were made
 * follows from the means of the rests and the moves between them. So it makes no difference whether
 * the user did as told, whether a turn was refused, or whether there was a reset.
 */
#include <string.h>

#include "../plan/guidance.h"
#include "invcal/plan.h"
#include "../session/rests.h"
#include "../session/session.h"
#include "turns.h"
#include "../core/vector.h"

#define ON_FACE INVCAL_REAL(0.9) /* cosine of 26 degrees */

enum { NO_FACE = 6 };

/* Where the device has been: the faces of its last two rests, and the turns of the tour made. */
typedef struct {
    const invcal_imu *imu;
    invcal_real up[3]; /* in the last rest: a unit vector */
    unsigned face;     /* of it */
    unsigned made;     /* bit i: turn i */
    int is_held;       /* the last rest is not taken yet */
} path;

/* The up direction of a reading. */
static void find_up(const invcal_imu *imu, const invcal_real raw[3], invcal_real up[3])
{
    invcali_correct(&imu->session.nominal, raw, up);
    const invcal_real length = INVCAL_SQRT(invcali_dot3(up, up));
    for (unsigned i = 0; i < 3; i++) {
        up[i] /= length;
    }
}

/* The face that points up: x, -x, y, -y, z, -z. */
static unsigned face_of(const invcal_real up[3])
{
    for (unsigned i = 0; i < 3; i++) {
        if (INVCAL_FABS(up[i]) > ON_FACE) {
            return 2 * i + (up[i] < 0);
        }
    }
    return NO_FACE;
}

/* The other face of the turn, if it has this one; or NO_FACE. */
static unsigned other_face(unsigned i, unsigned face)
{
    const unsigned from = invcali_tour_face(i);
    const unsigned to = invcali_tour_face(i + 1);

    return from == face ? to : to == face ? from : NO_FACE;
}

/* Goes to a rest; is_made: by a move that is usable. */
static void go(path *p, const invcal_real raw[3], int is_made)
{
    const unsigned from = p->face;

    find_up(p->imu, raw, p->up);
    p->face = face_of(p->up);
    for (unsigned i = 0; is_made && p->face < NO_FACE && i < INVCAL_TOUR; i++) {
        if (other_face(i, from) == p->face) {
            p->made |= 1u << i;
        }
    }
}

/* Follows all rests, and the one that is READY. Returns 0 if there is none. */
static int follow_path(path *p)
{
    const invcal_session *s = &p->imu->session;
    const unsigned rests = p->imu->rests;
    const unsigned both = s->count < rests ? s->count : rests;
    invcal_real raw[3];

    for (unsigned i = 0; i < both; i++) {
        go(p, s->mean[s->count - both + i].v, p->imu->own.rest[rests - both + i].move > 0);
    }
    if (s->last != INVCAL_TAKEN && s->last != INVCAL_REFUSED &&
        invcali_rests_mean(&s->rests, raw)) {
        /* its move is not complete, but may have been refused already */
        go(p, raw, p->imu->own.fault == INVCAL_OK);
        p->is_held = 1;
    }
    return both > 0 || p->is_held;
}

/* The face to turn to: that of the first turn of the tour that was not made and begins or ends here;
 * else where the first one begins that was not made, or ends, if it begins on the other side. NO_FACE
 * if every turn was made. */
static unsigned next_face(const path *p)
{
    unsigned next = NO_FACE;

    for (unsigned i = 0; i < INVCAL_TOUR; i++) {
        if ((p->made >> i & 1u) == 0) {
            const unsigned other = other_face(i, p->face);
            if (other < NO_FACE) {
                return other;
            }
            if (next == NO_FACE) {
                const unsigned from = invcali_tour_face(i);
                next = (from ^ 1u) == p->face ? invcali_tour_face(i + 1) : from;
            }
        }
    }
    return next;
}

static void turn_to_face(const path *p, unsigned face, invcal_turn *turn)
{
    invcal_real up[3] = {0, 0, 0};

    up[face / 2] = face % 2 == 0 ? 1 : -1;
    (void)invcali_turn_to(p->up, up, turn);
}

/* The most informative turn, unless the rests are not readings. A turn to the rest that is READY
 * counts as the shortest. */
static void find_informative(const path *p, invcal_turn *turn)
{
    const invcal_positions positions = invcali_imu_positions(p->imu);
    invcali_turns turns;

    if (invcali_turns_after(&turns, p->imu, &positions, NULL) == INVCAL_OK) {
        if (p->is_held && invcali_turn_to(turns.up, p->up, turn) == INVCAL_OK) {
            (void)invcali_turns_add(&turns, turn);
        }
        memcpy(turns.up, p->up, sizeof turns.up);
        invcali_turns_next(&turns, turn);
    }
}

void invcal_imu_next(const invcal_imu *imu, invcal_turn *turn)
{
    path p;

    INVCAL_ASSERT(imu && turn);
    invcali_zero(turn, sizeof *turn);
    turn->up[2] = 1;
    invcali_zero(&p, sizeof p);
    p.imu = imu;
    p.face = NO_FACE;
    if (!invcali_imu_is_begun(imu) || !follow_path(&p)) {
        return;
    }
    const unsigned face = next_face(&p);
    if (face < NO_FACE) {
        turn_to_face(&p, face, turn);
    } else {
        find_informative(&p, turn);
    }
}

const char *invcal_imu_next_text(const invcal_imu *imu, char text[INVCAL_TEXT_SIZE])
{
    invcal_turn turn;

    invcal_imu_next(imu, &turn);
    return invcal_direction_text(turn.up, text);
}
