/* SPDX-License-Identifier: MIT
 *
 * A device that calibrates itself: samples of a sensor in a hand that goes where the session says,
 * with the mishaps of a hand, a sensor and a memory; then what it keeps.
 */
#include "digest.h"
#include "invcal/plan.h"
#include "invcal/positions.h"
#include "invcal/result.h"
#include "session/rests.h"

enum { RATE = 50, TURN = RATE, REST = 9 * RATE / 4, SHORT_REST = 6 * RATE / 5 };

/* What goes wrong at a place, or in the turn to it. */
enum {
    NOTHING,
    TOO_SHORT, /* the hand leaves too soon, */
    KNOCK,     /* hits it, */
    PULL,      /* or pulls it: a position that is wrong by 2 % */
    CLIPPED,   /* x is at its rail */
    WILD,      /* a sample in five is far off */
    FAR,       /* not a reading of this field: the range has been changed */
    GAP,       /* samples are lost */
    POWER_CUT  /* while the last position is saved */
};
static const uint8_t mishaps[] = {NOTHING, TOO_SHORT, NOTHING, CLIPPED, KNOCK,     NOTHING,
                                  WILD,    NOTHING,   PULL,    FAR,     NOTHING,   NOTHING,
                                  NOTHING, GAP,       NOTHING, NOTHING, POWER_CUT, NOTHING,
                                  NOTHING, NOTHING,   NOTHING};

/* z points down. */
static const input_sensor accelerometer = {
    {490, -820, 330}, {{16712, 66, -98}, {66, 16138, 164}, {98, -164, -16548}}, 8};

static invcal_session session;
static invcal_calibration nominal;
static unsigned mishap;
static uint32_t events[INVCAL_REFUSED + 1], progress; /* at this place */

/* ---- what the session says ------------------------------------------------------------------ */

static void rest_results(void)
{
    invcali_rest rest = {{0, 0, 0}, 0, 0, 0, 0};

    digest_bits("is_rest", (uint32_t)invcali_rests_get(&session.rests, &rest));
    for (int a = 0; a < 3; a++) {
        digest_bits("sum", (uint32_t)((uint64_t)rest.sum[a] >> 32));
        digest_bits("sum", (uint32_t)(uint64_t)rest.sum[a]);
    }
    digest_bits("count", rest.count);
    digest_bits("begin", rest.begin);
    digest_bits("end", rest.end);
    digest_reals("variance", &rest.variance, 1);
}

static void begin_stream(void)
{
    digest_bits("session", invcal_session_init_nominal(&session, sizeof session, &nominal, RATE));
    digest_bits("rails", invcal_session_set_limits(&session, -32768, 32767));
    invcal_session_set_hold(&session, INVCAL_REAL(0.7));
}

/* After a power cut the positions are those that had been saved before. */
static void save(void)
{
    const uint32_t size = invcal_session_size(&session);

    memory_power(mishap == POWER_CUT ? size / 2 : UINT32_MAX);
    digest_bits("saved", invcal_session_save(&session, &memory));
    memory_power(UINT32_MAX);
    if (mishap == POWER_CUT) {
        begin_stream();
        digest_bits("resumed", invcal_session_load(&session, &memory));
    }
    digest_bits("positions", session.count);
}

static void event_results(invcal_event event)
{
    digest_bits("event", event);
    switch (event) {
    case INVCAL_READY:
        rest_results();
        break;
    case INVCAL_TAKEN:
        rest_results();
        digest_reals("mean", session.mean[session.count - 1].v, 3);
        digest_bits("is_good", (uint32_t)invcal_session_is_good(&session));
        save();
        break;
    default:
        digest_bits("reason", invcal_session_reason(&session));
        digest_text("why", invcal_session_reason_text(&session));
        break;
    }
}

static void feed(const int32_t raw[3])
{
    const invcal_event event = invcal_session_feed(&session, raw[0], raw[1], raw[2]);

    events[event]++;
    progress += invcal_session_progress(&session);
    if (event >= INVCAL_READY) {
        event_results(event);
    }
}

static void place_results(void)
{
    for (unsigned event = INVCAL_NOTHING; event < INVCAL_READY; event++) {
        digest_bits("events", events[event]);
    }
    digest_bits("progress", progress);
    memset(events, 0, sizeof events);
    progress = 0;
}

/* Where to turn next. */
static void ask(float up[3])
{
    char words[INVCAL_TEXT_SIZE];

    digest_bits("is_at", (uint32_t)invcal_session_is_at(&session, up));
    invcal_session_next(&session, up);
    digest_reals("next", up, 3);
    digest_text("words", invcal_session_next_text(&session, words));
}

/* ---- the hand ------------------------------------------------------------------------------- */

static void read_sensor(const float force[3], unsigned step)
{
    const int is_halfway = step == REST / 2;
    int32_t raw[3];

    input_sample(&accelerometer, force, raw);
    if (mishap == CLIPPED) {
        raw[0] = 32767;
    }
    if ((mishap == WILD && step % 5 == 1) || (mishap == KNOCK && is_halfway)) {
        raw[1] += INT32_C(1) << 20;
    }
    for (int a = 0; a < 3; a++) {
        raw[a] += mishap == PULL ? raw[a] / 50 : 0;
        raw[a] /= mishap == FAR ? 16 : 1;
    }
    if (mishap == GAP && is_halfway) {
        invcal_session_gap(&session);
    }
    feed(raw);
}

/* Roughly to that direction, with some shaking. */
static void turn(float up[3], const float to[3])
{
    const float from[3] = {up[0], up[1], up[2]};
    float target[3], force[3];

    for (int i = 0; i < 3; i++) {
        target[i] = to[i] + 0.1f * input_noise();
    }
    input_to_unit(target);
    for (unsigned step = 1; step <= TURN; step++) {
        const float part = (float)step / TURN;
        const float done = part * part * (3 - 2 * part);
        for (int i = 0; i < 3; i++) {
            up[i] = from[i] + done * (target[i] - from[i]);
        }
        input_to_unit(up);
        for (int i = 0; i < 3; i++) {
            force[i] = up[i] + 0.1f * input_noise();
        }
        read_sensor(force, 0);
    }
}

static void hold(const float up[3])
{
    const unsigned steps = mishap == TOO_SHORT ? SHORT_REST : REST;

    for (unsigned step = 0; step < steps; step++) {
        read_sensor(up, step);
    }
}

static void begin_session(void)
{
    static const float zero[3] = {0, 0, 0};
    static const float counts[3] = {16384, 16384, -16384};

    digest_set("begin");
    digest_bits("nominal", invcal_nominal(zero, counts, &nominal));
    begin_stream();
    memory_power(UINT32_MAX);
    digest_bits("erased", invcal_store_erase(&memory));
}

static void tour(void)
{
    float up[3] = {0, 0, 1};
    float next[3] = {0, 0, 1};

    for (unsigned place = 0; place < sizeof mishaps; place++) {
        digest_numbered("place", place);
        mishap = mishaps[place];
        turn(up, next);
        hold(up);
        place_results();
        ask(next);
    }
    digest_set("finish");
    event_results(invcal_session_end(&session));
}

/* ---- the result ----------------------------------------------------------------------------- */

static void solve(invcal_calibration *calibration, invcal_quality *quality)
{
    digest_set("result");
    digest_bits("status", invcal_session_solve(&session, calibration, quality));
    digest_calibration(calibration, &nominal);
    digest_quality(quality, &nominal);
    digest_bits("reaches", (uint32_t)invcal_reaches(quality, 0.001f, 0.001f, 0.002f));
    digest_bits("stated", invcal_session_set_noise(&session, 2e-4f));
    digest_bits("is_good", (uint32_t)invcal_session_is_good(&session));
}

static void record_results(const invcal_calibration *calibration, const invcal_quality *quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    digest_set("record");
    invcal_record_init(&record, calibration, quality);
    record.temperature = 25.5f;
    record.temperature_known = 1;
    record.date = UINT32_C(1234567890);
    memcpy(record.sensor, "12345678", 8);
    digest_bits("encoded", invcal_record_encode(&record, bytes));
    digest_bytes("bytes", bytes, sizeof bytes);
    memset(&record, 0, sizeof record);
    digest_bits("decoded", invcal_record_decode(bytes, sizeof bytes, &record));
    digest_calibration(&record.calibration, &nominal);
    digest_reals("sigma", record.sigma, INVCAL_PARAMETERS);
    digest_reals("temperature", &record.temperature, 1);
    bytes[100] ^= 16;
    digest_bits("damaged", invcal_record_decode(bytes, sizeof bytes, &record));
}

/* The nominal calibration is stored, then the calibration over it, with power cut after ever more
 * bytes: a load finds the old one or, at last, the new one. */
static void store_results(const invcal_calibration *calibration, const invcal_quality *quality)
{
    for (uint32_t bytes = 4; bytes < INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 8) + 20; bytes += 20) {
        invcal_calibration loaded;
        digest_numbered("power fails after bytes", bytes);
        memory_power(UINT32_MAX);
        digest_bits("erased", invcal_store_erase(&memory));
        digest_bits("old", invcal_save(&nominal, quality, &memory));
        memory_power(bytes);
        digest_bits("new", invcal_save(calibration, quality, &memory));
        memory_power(UINT32_MAX);
        digest_bits("loaded", invcal_load(&loaded, &memory));
        digest_reals("offset", loaded.offset, 3);
    }
}

static void texts(void)
{
    digest_set("texts");
    for (unsigned i = 0; i <= INVCAL_STATUS_END; i++) {
        digest_text("status", invcal_status_text((invcal_status)i));
    }
    for (unsigned i = 0; i <= INVCAL_WEAK + 16; i += 16) {
        digest_text("verdict", invcal_verdict_text((invcal_verdict)i));
    }
    for (unsigned i = 0; i <= INVCAL_PARAMETERS; i++) {
        digest_text("parameter", invcal_parameter_text(i));
    }
}

static void use(const invcal_calibration *calibration)
{
    invcal_calibration scaled = *calibration;

    digest_set("use");
    digest_bits("scaled", invcal_scale(&scaled, 9.80665f));
    for (int i = 0; i < 4; i++) {
        float up[3], out[3];
        int32_t raw[3];
        input_direction(up);
        input_sample(&accelerometer, up, raw);
        invcal_apply(calibration, (float)raw[0], (float)raw[1], (float)raw[2], out);
        digest_reals("g", out, 3);
        const float reading[3] = {(float)raw[0], (float)raw[1], (float)raw[2]};
        invcal_apply(&scaled, reading[0], reading[1], reading[2], out);
        digest_reals("m_per_s2", out, 3);
    }
}

void part_device(void)
{
    invcal_calibration calibration;
    invcal_quality quality;

    begin_session();
    tour();
    solve(&calibration, &quality);
    record_results(&calibration, &quality);
    store_results(&calibration, &quality);
    use(&calibration);
    texts();
}
