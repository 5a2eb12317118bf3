/* SPDX-License-Identifier: MIT */
#include "drive.h"

#include <string.h>

enum { SAMPLES_MOST = 40000 }; /* of one input: so it takes milliseconds */

/* What goes on, and what is known of it. */
typedef struct {
    invcal_session *session;
    source *s;
    unsigned left; /* samples that may still be fed */
    uint32_t random;
    int32_t place[3];          /* where the sensor is, counts */
    int32_t least[3], most[3]; /* of all samples */
    unsigned positions;        /* of the event before */
    invcal_real temperature;
} drive_state;

static uint32_t next_random(drive_state *d)
{
    d->random = d->random * UINT32_C(1664525) + UINT32_C(1013904223);
    return d->random >> 8;
}

/* ---- what must hold --------------------------------------------------------------------------- */

static int is_taken(invcal_session_what what)
{
    return what == INVCAL_SESSION_TAKEN || what == INVCAL_SESSION_ENOUGH ||
           what == INVCAL_SESSION_FINISHED;
}

/* Of any session, begun or resumed. */
static void look_at_session(const drive_state *d)
{
    const invcal_session *session = d->session;

    REQUIRE(session->stored <= INVCAL_MAX_POSITIONS);
    REQUIRE(session->stored <= session->normal.count);
    REQUIRE(session->hold >= 0 && session->hold <= INVCAL_SESSION_HOLD_LONGEST);
    REQUIRE(session->is_enough <= 1 && session->is_ready <= 1);
    REQUIRE(session->step <= INVCAL_PLAN_GROUPS * session->setup.plan.per_group);
    REQUIRE(session->coldest <= session->warmest);
    require_finite(&session->temperature, 1);
    for (unsigned i = 0; i < session->stored; i++) {
        require_finite(session->mean[i], 3);
    }
}

/* The mean lies among the samples that there have been. */
static void look_at_rest(const drive_state *d, const invcal_rest *rest)
{
    invcal_real mean[3];

    REQUIRE(rest->count > 0 && rest->end - rest->begin >= rest->count);
    require_sigma(&rest->variance, 1);
    invcal_rest_mean(rest, mean);
    for (unsigned a = 0; a < 3; a++) {
        REQUIRE(rest->sum[a] >= (int64_t)d->least[a] * (int64_t)rest->count);
        REQUIRE(rest->sum[a] <= (int64_t)d->most[a] * (int64_t)rest->count);
        REQUIRE(mean[a] >= (invcal_real)d->least[a] && mean[a] <= (invcal_real)d->most[a]);
    }
}

static void look_at_event(drive_state *d, invcal_session_what what, const invcal_event *event)
{
    const int is_background = d->session->setup.background != 0;

    REQUIRE(what == event->what && what <= INVCAL_SESSION_FINISHED);
    REQUIRE(event->progress <= 100);
    REQUIRE(event->positions == d->session->normal.count);
    REQUIRE(event->reason <= INVCAL_REST_SAME);
    REQUIRE(event->status < INVCAL_STATUS_COUNT);
    if (what == INVCAL_SESSION_REFUSED) {
        REQUIRE((event->reason == INVCAL_REST_GOOD) == (event->status != INVCAL_OK));
    }
    if (is_taken(what) || what == INVCAL_SESSION_COVERED) {
        look_at_rest(d, &event->rest);
    }
    if (!is_background) {
        const unsigned more = is_taken(what) && d->positions < UINT32_MAX;
        REQUIRE(event->positions == d->positions + more);
        REQUIRE(what != INVCAL_SESSION_COVERED);
    }
    d->positions = event->positions;
    look_at_session(d);
}

static void solve(const drive_state *d, int looks_for_outliers)
{
    invcal_outliers outliers;
    invcal_solution solution;
    invcal_quality quality;

    mark(&solution, sizeof solution);
    mark(&quality, sizeof quality);
    if (invcal_session_solve(d->session, &solution, &quality,
                             looks_for_outliers ? &outliers : NULL) != INVCAL_OK) {
        require_mark(&solution, sizeof solution);
        require_mark(&quality, sizeof quality);
        return;
    }
    require_solution(&solution);
    require_quality(&quality);
    REQUIRE(quality.worst < d->session->stored);
}

/* Returns 1 if there is something left to do. */
static int ask_next(const drive_state *d, invcal_real up[3])
{
    char words[INVCAL_GUIDANCE_WORDS];
    invcal_guidance next;

    mark(&next, sizeof next);
    if (invcal_session_next(d->session, &next) != INVCAL_OK) {
        require_mark(&next, sizeof next);
        return 0;
    }
    require_finite(next.up, 3);
    REQUIRE(is_finite(next.gain) && next.gain >= 0);
    require_sigma(next.before, INVCAL_PARAMETERS);
    require_sigma(next.after, INVCAL_PARAMETERS);
    invcal_guidance_words(next.up, words);
    REQUIRE(memchr(words, '\0', sizeof words));
    memcpy(up, next.up, sizeof next.up);
    return 1;
}

/* Power off and on: the session goes on, and its bytes are the same again. */
static void resume(drive_state *d)
{
    uint8_t bytes[INVCAL_RESUME_SIZE];
    uint8_t again[INVCAL_RESUME_SIZE];
    invcal_session resumed;
    uint32_t size;
    uint32_t size_again;

    if (invcal_resume_encode(d->session, bytes, &size) != INVCAL_OK) {
        return;
    }
    REQUIRE(size <= sizeof bytes);
    REQUIRE(invcal_resume_decode(bytes, size, &resumed) == INVCAL_OK);
    REQUIRE(invcal_resume_encode(&resumed, again, &size_again) == INVCAL_OK);
    REQUIRE(size_again == size && memcmp(bytes, again, size) == 0);
    if (!INVCAL_DOUBLE && d->session->normal.count <= d->session->stored) {
        REQUIRE(memcmp(&resumed.normal, &d->session->normal, sizeof resumed.normal) == 0);
    }
    *d->session = resumed;
    d->positions = resumed.normal.count;
}

/* ---- what can be done to it ------------------------------------------------------------------- */

static void feed(drive_state *d, const int32_t raw[3])
{
    invcal_event event;

    if (d->left == 0) {
        return;
    }
    d->left--;
    for (unsigned a = 0; a < 3; a++) {
        d->least[a] = raw[a] < d->least[a] ? raw[a] : d->least[a];
        d->most[a] = raw[a] > d->most[a] ? raw[a] : d->most[a];
    }
    mark(&event, sizeof event);
    const invcal_session_what what = invcal_session_feed(d->session, raw, d->temperature, &event);
    if (what == INVCAL_SESSION_NOTHING) {
        require_mark(&event, sizeof event);
    } else {
        look_at_event(d, what, &event);
    }
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
            const int64_t way = ((int64_t)to[a] - d->place[a]) * i / samples;
            raw[a] = saturated(d->place[a] + way + (i % 2 ? 90 : -90));
        }
        feed(d, raw);
    }
    memcpy(d->place, to, sizeof d->place);
}

/* About the field of settings with usual numbers: some thousand counts. */
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
    const invcal_real rate = d->session->setup.rate;

    return rate < 8000 ? (unsigned)rate : 8000;
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

    while (ask_next(d, up) && count-- > 0) {
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

static void renew(drive_state *d)
{
    const invcal_settings other = take_settings(d->s);
    const invcal_session before = *d->session;

    if (invcal_session_renew(d->session, &other.nominal) != INVCAL_OK) {
        REQUIRE(memcmp(&before, d->session, sizeof before) == 0);
    }
}

static void end_stream(drive_state *d)
{
    invcal_event event;

    mark(&event, sizeof event);
    const invcal_session_what what = invcal_session_finish(d->session, &event);
    if (what != INVCAL_SESSION_NOTHING) {
        look_at_event(d, what, &event);
    }
}

static void age(drive_state *d)
{
    for (unsigned days = take_byte(d->s) % 64; days > 0; days--) {
        invcal_session_age(d->session);
    }
    d->positions = d->session->normal.count;
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
        invcal_session_hold(d->session, take_real(d->s, (invcal_real)amount));
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
        renew(d);
        break;
    case 12:
        resume(d);
        break;
    case 13:
        d->temperature = take_real(d->s, (invcal_real)amount * 5);
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

void drive(invcal_session *session, source *s)
{
    invcal_real up[3];
    drive_state d = {.session = session,
                     .s = s,
                     .left = SAMPLES_MOST,
                     .least = {INT32_MAX, INT32_MAX, INT32_MAX},
                     .most = {INT32_MIN, INT32_MIN, INT32_MIN},
                     .positions = session->normal.count};

    look_at_session(&d);
    while (s->left > 0) {
        act(&d, take_byte(s));
    }
    end_stream(&d);
    solve(&d, 0);
    solve(&d, 1);
    (void)ask_next(&d, up);
    resume(&d);
}
