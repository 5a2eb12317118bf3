/* SPDX-License-Identifier: MIT */
#include "invcal/result.h"
#include "../positions.h"
#include "core/vector.h"
#include "drive.h"
#include "plan/guidance.h"
#include "invcal/background.h"
#include "invcal/plan.h"
#include "session/rests.h"
#include "core/sums.h"

#include <math.h>
#include <string.h>

#include "invcal/store.h"

enum { SAMPLES_MOST = 40000 }; /* of one input: so it takes milliseconds */

/* What is happening, and what is known of it. */
typedef struct {
    invcal_session *session;
    invcal_background *background; /* null if there is none */
    source *s;
    unsigned left; /* samples that may still be fed */
    uint32_t random;
    int32_t place[3];          /* where the sensor is, counts */
    int32_t least[3], most[3]; /* of all samples */
} drive_state;

static uint32_t next_random(drive_state *d)
{
    d->random = d->random * UINT32_C(1664525) + UINT32_C(1013904223);
    return d->random >> 8;
}

/* ---- what must hold --------------------------------------------------------------------------- */

/* For any session, begun or resumed. */
static void look_at_session(const drive_state *d)
{
    const invcal_session *session = d->session;
    const unsigned most = INVCAL_MAX_POSITIONS - (d->background != NULL);
    invcali_row row;

    REQUIRE(session->count <= most);
    REQUIRE(session->noise >= 0 && session->noise < 1);
    REQUIRE(invcal_session_reason(session) < INVCAL_STATUS_END);
    REQUIRE(invcal_session_progress(session) <= 100);
    REQUIRE(strcmp(invcal_session_reason_text(session), "unknown status") != 0);
    for (unsigned i = 0; i < session->count; i++) {
        require_finite(session->mean[i].v, 3);
        REQUIRE(invcali_observe(&session->nominal, session->mean[i].v, &row) == INVCAL_OK);
        REQUIRE(!d->background || d->background->age[i] < 88);
    }
}

/* The mean lies within the range of the samples so far. */
static void look_at_rest(const drive_state *d, const invcali_rest *rest, invcal_real mean[3])
{
    REQUIRE(rest->count > 0 && rest->end - rest->begin >= rest->count);
    require_sigma(&rest->variance, 1);
    REQUIRE(invcali_rests_mean(&d->session->rests, mean));
    for (unsigned a = 0; a < 3; a++) {
        REQUIRE(rest->sum[a] >= (int64_t)d->least[a] * (int64_t)rest->count);
        REQUIRE(rest->sum[a] <= (int64_t)d->most[a] * (int64_t)rest->count);
        const invcal_real low = (invcal_real)d->least[a];
        const invcal_real high = (invcal_real)d->most[a];
        const invcal_real ulp =
            2 * INVCAL_EPSILON * (INVCAL_FABS(low) + INVCAL_FABS(high)); /* or more */
        REQUIRE(mean[a] >= low - ulp && mean[a] <= high + ulp);
    }
}

/* It has done since `before` what the event says. */
static void look_at_event(const drive_state *d, invcal_event event, const invcal_session *before)
{
    const invcal_session *session = d->session;
    const unsigned more = event == INVCAL_TAKEN && before->count < INVCAL_MAX_POSITIONS;
    invcal_real mean[3];
    invcali_rest rest;

    REQUIRE(event <= INVCAL_REFUSED);
    if (event == INVCAL_NOTHING) {
        REQUIRE(session->last == before->last && session->reason == before->reason);
        REQUIRE(session->good == before->good);
    } else {
        REQUIRE(event == (invcal_event)session->last);
    }
    if (event == INVCAL_READY || event == INVCAL_TAKEN) {
        REQUIRE(invcali_rests_get(&session->rests, &rest));
        look_at_rest(d, &rest, mean);
    }
    if (event == INVCAL_READY) {
        REQUIRE(invcal_session_progress(session) == 100);
    }
    if (event == INVCAL_REFUSED) {
        REQUIRE(session->reason == INVCAL_NOT_FINITE ||
                (session->reason >= INVCAL_OUT_OF_RANGE && session->reason <= INVCAL_REST_SAME));
    }
    if (!d->background) {
        REQUIRE(session->count == before->count + more);
        REQUIRE(event != INVCAL_TAKEN ||
                memcmp(&session->mean[session->count - 1u], mean, sizeof mean) == 0);
    }
    if (event != INVCAL_TAKEN) {
        REQUIRE(session->count == before->count);
        REQUIRE(memcmp(session->mean, before->mean, before->count * sizeof before->mean[0]) == 0);
    }
    look_at_session(d);
}

/* Checks what is_good and reaches say. */
static void look_at_answers(const drive_state *d, invcal_status status, const invcal_quality *q)
{
    const invcal_real any = INVCAL_REAL_MAX;
    const int is_good =
        status == INVCAL_OK && q->verdict == INVCAL_GOOD && (q->dof >= 3 || d->session->noise > 0);

    REQUIRE(invcal_session_is_good(d->session) == is_good);
    REQUIRE(invcal_session_is_good(d->session) == is_good); /* as known so far */
    if (status == INVCAL_OK) {
        REQUIRE(invcal_reaches(q, any, any, any) == (q->verdict == INVCAL_GOOD));
        REQUIRE(!invcal_reaches(q, 0, 0, 0));
    }
}

static void solve(const drive_state *d, int looks_at_answers)
{
    const invcal_session *session = d->session;
    const conditions c = {.nominal = session->nominal, .field = 1};
    invcal_calibration out;
    invcal_quality quality;

    mark(&out, sizeof out);
    mark(&quality, sizeof quality);
    const invcal_status status = invcal_session_solve(session, &out, &quality);
    if (status == INVCAL_OK) {
        require_solution(&out, &c);
        require_quality(&quality, session->count);
    } else {
        require_mark(&out, sizeof out);
        require_mark(&quality, sizeof quality);
    }
    if (looks_at_answers) {
        look_at_answers(d, status, &quality);
    }
}

static void ask_next(const drive_state *d, invcal_real up[3])
{
    char words[INVCAL_TEXT_SIZE];
    char again[INVCAL_TEXT_SIZE];

    invcal_session_next(d->session, up);
    require_direction(up);
    REQUIRE(invcal_session_next_text(d->session, words) == words);
    REQUIRE(memchr(words, '\0', sizeof words));
    REQUIRE(strcmp(invcal_direction_text(up, again), words) == 0);
    REQUIRE((invcal_session_is_at(d->session, up) & ~1) == 0);
}

/* What the positions so far determine, and what they leave open. */
static void prospect(const drive_state *d)
{
    const invcal_session *session = d->session;
    const invcal_positions *positions =
        POSITIONS_OF(session->mean, session->count, &session->nominal, 0);
    invcal_real before[INVCAL_PARAMETERS];
    invcal_real after[INVCAL_PARAMETERS];
    invcal_real up[3];

    ask_next(d, up);
    invcali_prospect(positions, NULL, before);
    invcali_prospect(positions, up, after);
    require_sigma(before, INVCAL_PARAMETERS);
    require_sigma(after, INVCAL_PARAMETERS);
    REQUIRE(invcal_undetermined(positions) < 1u << INVCAL_PARAMETERS);
    REQUIRE(invcal_bad_reading(positions) == session->count);
}

/* Power off and on: the session is begun as it was, and goes on. */
static void resume(const drive_state *d)
{
    invcal_session *session = d->session;
    const uint32_t size = invcal_session_size(session);
    invcal_session resumed;

    REQUIRE(size <= INVCAL_SESSION_SIZE);
    mark(&resumed, sizeof resumed);
    REQUIRE(invcal_session_init_nominal(&resumed, sizeof resumed, &session->nominal,
                                        session->rate) == INVCAL_OK);
    resumed.noise = session->noise;
    resumed.rests.dwell = session->rests.dwell;
    resumed.rests.low = session->rests.low;
    resumed.rests.between = session->rests.between;
    REQUIRE(invcal_session_resume(&resumed, (const uint8_t *)session, size) == INVCAL_OK);
    REQUIRE(resumed.count == session->count && resumed.rate == session->rate);
    REQUIRE(resumed.rests.pace == session->rests.pace && resumed.rests.low == session->rests.low &&
            resumed.rests.between == session->rests.between);
    REQUIRE(memcmp(&resumed.nominal, &session->nominal, sizeof resumed.nominal) == 0);
    REQUIRE(resumed.noise == session->noise);
    REQUIRE(memcmp(resumed.mean, session->mean, resumed.count * sizeof resumed.mean[0]) == 0);
    *session = resumed;
}

/* ---- what can be done to it ------------------------------------------------------------------- */

static void feed(drive_state *d, const int32_t raw[3])
{
    if (d->left == 0) {
        return;
    }
    d->left--;
    for (unsigned a = 0; a < 3; a++) {
        d->least[a] = raw[a] < d->least[a] ? raw[a] : d->least[a];
        d->most[a] = raw[a] > d->most[a] ? raw[a] : d->most[a];
    }
    const invcal_session before = *d->session;
    look_at_event(d,
                  d->background ? invcal_background_feed(d->background, raw[0], raw[1], raw[2])
                                : invcal_session_feed(d->session, raw[0], raw[1], raw[2]),
                  &before);
}

static int32_t saturated(int64_t x)
{
    return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (int32_t)x;
}

/* At `place`, noise of some counts. */
static void rest(drive_state *d, unsigned samples, uint32_t noise)
{
    int32_t raw[3];

    for (unsigned i = 0; i < samples; i++) {
        for (unsigned a = 0; a < 3; a++) {
            const int64_t n = noise > 0 ? (int64_t)(next_random(d) % (2 * noise + 1)) - noise : 0;
            raw[a] = saturated(d->place[a] + n);
        }
        feed(d, raw);
    }
}

/* From `place` to another one in a straight line, with a shake. */
static void move(drive_state *d, const int32_t to[3], unsigned samples)
{
    int32_t raw[3];

    for (unsigned i = 1; i <= samples; i++) {
        for (unsigned a = 0; a < 3; a++) {
            const int64_t part = ((int64_t)to[a] - d->place[a]) * i / samples;
            raw[a] = saturated(d->place[a] + part + (i % 2 ? 90 : -90));
        }
        feed(d, raw);
    }
    memcpy(d->place, to, sizeof d->place);
}

/* Roughly the field of a common nominal calibration: some thousand counts. */
static void turn(drive_state *d, const invcal_real up[3], unsigned samples)
{
    int32_t to[3];

    for (unsigned a = 0; a < 3; a++) {
        to[a] = (int32_t)(1000 * up[a] * (1 + (invcal_real)a / 100)) + 17 - 9 * (int32_t)a;
    }
    move(d, to, samples);
}

static void turn_to(drive_state *d, unsigned direction, unsigned samples)
{
    invcal_real up[3];

    direction_of(direction, up);
    turn(d, up, samples);
}

static unsigned second_of(const drive_state *d)
{
    return (unsigned)d->session->rate;
}

/* Rests in some directions, as a person would. */
static void tour(drive_state *d, unsigned count)
{
    const unsigned first = take_byte(d->s);
    const unsigned step = take_byte(d->s) % 8 + 1;
    const uint32_t noise = take_byte(d->s) % 32;

    for (unsigned i = 0; i < count; i++) {
        turn_to(d, first + i * step, second_of(d));
        rest(d, 2 * second_of(d) + 44, noise);
    }
    turn_to(d, first, second_of(d));
}

/* Rests where the session asks for it. */
static void follow(drive_state *d, unsigned count)
{
    const uint32_t noise = take_byte(d->s) % 32;
    invcal_real up[3];

    while (count-- > 0) {
        ask_next(d, up);
        turn(d, up, second_of(d));
        rest(d, 2 * second_of(d) + 44, noise);
    }
}

static void any_samples(drive_state *d)
{
    const unsigned count = take_byte(d->s);
    int32_t raw[3];

    for (unsigned a = 0; a < 3; a++) {
        raw[a] = take_i32(d->s);
    }
    for (unsigned i = 0; i < count; i++) {
        feed(d, raw);
    }
    memcpy(d->place, raw, sizeof raw);
}

/* Rails and a noise, which are refused, or apply from now on. */
static void restate(const drive_state *d)
{
    const invcal_session before = *d->session;
    const invcal_real noise = take_real(d->s, INVCAL_REAL(0.0001));
    const int32_t low = take_i32(d->s);
    const int32_t high = take_i32(d->s);

    if (invcal_session_set_noise(d->session, noise) != INVCAL_OK) {
        REQUIRE(memcmp(&before, d->session, sizeof before) == 0);
    } else {
        REQUIRE(d->session->noise == noise && noise > 0 && noise < 1);
    }
    const invcal_session between = *d->session;
    REQUIRE((invcal_session_set_limits(d->session, low, high) == INVCAL_OK) == (low < high));
    if (!(low < high)) {
        REQUIRE(memcmp(&between, d->session, sizeof between) == 0);
    }
}

/* In the background the stream never ends. */
static void end_stream(const drive_state *d)
{
    const invcal_session before = *d->session;

    if (!d->background) {
        const invcal_event event = invcal_session_end(d->session);
        REQUIRE(event == INVCAL_TAKEN || event == INVCAL_REFUSED || event == INVCAL_MOVING);
        look_at_event(d, event, &before);
    }
}

static void age(const drive_state *d)
{
    for (unsigned days = take_byte(d->s) % 64; days > 0 && d->background; days--) {
        invcal_background_age(d->background);
    }
}

static void act(drive_state *d, unsigned action)
{
    const unsigned amount = action >> 4; /* 0 ... 15 */

    switch (action & 15u) {
    case 0:
        tour(d, amount);
        break;
    case 1:
        rest(d, (amount + 1) * second_of(d), take_byte(d->s));
        break;
    case 2:
        turn_to(d, take_byte(d->s), (amount + 1) * second_of(d) / 4 + 1);
        break;
    case 3:
        any_samples(d);
        break;
    case 4:
        invcal_session_gap(d->session);
        break;
    case 5:
        invcal_session_set_hold(
            d->session, (invcal_real)(take_byte(d->s) == 1 ? take_u32(d->s) : amount * 500) / 1000);
        break;
    case 6:
        end_stream(d);
        break;
    case 7:
        follow(d, amount);
        break;
    case 8:
    case 9:
        solve(d, action & 1u);
        break;
    case 10:
        age(d);
        break;
    case 11:
        restate(d);
        break;
    case 12:
        resume(d);
        break;
    case 13:
        prospect(d);
        break;
    case 14:
        rest(d, (amount + 1) * second_of(d), take_u32(d->s) >> (take_byte(d->s) % 32));
        break;
    default:
        d->random = take_byte(d->s);
        break;
    }
    look_at_session(d);
}

void drive(invcal_session *session, invcal_background *background, source *s)
{
    drive_state d = {.session = session,
                     .background = background,
                     .s = s,
                     .left = SAMPLES_MOST,
                     .least = {INT32_MAX, INT32_MAX, INT32_MAX},
                     .most = {INT32_MIN, INT32_MIN, INT32_MIN}};

    look_at_session(&d);
    while (s->left > 0) {
        act(&d, take_byte(s));
    }
    end_stream(&d);
    solve(&d, 0);
    solve(&d, 1);
    prospect(&d);
    resume(&d);
}
