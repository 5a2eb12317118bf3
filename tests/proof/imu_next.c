/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "imu/turns.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 60 -eva-split-return full
// stubs: turns imu rests words

/* ---- what other modules do ---------------------------------------------------------------------- */

unsigned invcali_tour_face(unsigned i)
{
    (void)(1 / (i <= INVCAL_TOUR));
    return BETWEEN(0, 5);
}

invcal_status invcali_turn_to(const invcal_real from[3], const invcal_real up[3], invcal_turn *out)
{
    (void)(from[2] + up[2]);
    ANY(*out);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_DIRECTION;
}

invcal_status invcali_turns_after(invcali_turns *turns, const invcal_imu *imu,
                                  const invcal_positions *positions,
                                  const invcal_imu_settings *settings)
{
    (void)imu->rests;
    (void)positions->count;
    (void)(settings != NULL);
    ANY(*turns);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_OUT_OF_RANGE;
}

invcal_status invcali_turns_add(invcali_turns *turns, const invcal_turn *turn)
{
    (void)turn->up[2];
    ANY(*turns);
    return INVCAL_OK;
}

void invcali_turns_next(const invcali_turns *turns, invcal_turn *out)
{
    (void)turns->n;
    ANY(*out);
}

invcal_positions invcali_imu_positions(const invcal_imu *imu)
{
    const invcal_session *s = &imu->session;
    const invcal_positions positions = {s->mean, s->count, &s->nominal, s->noise, NULL};

    return positions;
}

int invcali_rests_mean(const invcal_private_rests *rests, invcal_real mean[3])
{
    (void)rests->time;
    Frama_C_make_unknown((char *)mean, 3 * sizeof *mean);
    return BETWEEN(0, 1);
}

const char *invcal_direction_text(const invcal_real up[3], char text[INVCAL_TEXT_SIZE])
{
    (void)up[2];
    Frama_C_make_unknown(text, INVCAL_TEXT_SIZE);
    return text;
}

/* Their numbers are exact, as where the means of rests begin follows from both. */
static void next(unsigned rests, unsigned count)
{
    static invcal_imu imu;
    invcal_turn turn;
    char text[INVCAL_TEXT_SIZE];

    ANY(imu);
    imu.rests = (uint8_t)rests;
    imu.session.count = (uint8_t)count;
    invcal_imu_next(&imu, &turn);
    (void)invcal_imu_next_text(&imu, text);
}

void main(void)
{
    next(0, 0);
    next(0, 3);
    next(1, 1);
    next(13, 13);
    next(INVCAL_MAX_MOVES, INVCAL_MAX_POSITIONS);
    next(INVCAL_MAX_MOVES, 2);
    next(5, INVCAL_MAX_POSITIONS);
}
