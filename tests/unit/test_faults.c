/* SPDX-License-Identifier: MIT
 *
 * Things that go wrong, a row each, and what the library reports: about the sensor in a session,
 * and about the memory that keeps its result. A fault that is not reported must cause no error
 * beyond sigma.
 */
#include <math.h>
#include <string.h>

#include "expected.h"
#include "invcal/background.h"
#include "invcal/expert.h"
#include "invcal/result.h"
#include "invcal/store.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a sensor that fails --------------------------------------------------------------------- */

#define COUNTS 16384.0 /* per g */
#define NOISE 1e-3     /* g, of a sample on each axis */

enum { RATE = 50, REST = 125, MOVE = 50, POSITIONS = 18, HALF = POSITIONS / 2 };

typedef enum {
    NO_FAULT,
    NOTHING_BUT_ZEROS,
    FROZEN,
    STUCK_AXIS,
    CLIPS,
    SWAPS_AXES,
    GLITCHES,
    SLOWER,
    FASTER,
    CLOCK_JUMPS
} fault;

/* One fault, and what must come of it. */
typedef struct {
    const char *name;
    fault what;
    int from;             /* the position from which it occurs */
    int rails;            /* stated? */
    unsigned taken;       /* positions; the others are refused, or never seen: */
    unsigned refused;     /* so often, all of them */
    invcal_status reason; /* for this reason */
    int reaches;          /* sigma of 1 mg, 0.1 %, 1 mrad: is that said to be reached? */
    invcal_status
        status;   /* of the solution; OK: its verdict is GOOD if that is reached and DRIFTING
                             if not, no position is left out, */
    double noise; /* it says a noise of no less, g, and it is right within its sigma */
} sensor_fault;

#define ANY_ERROR 5e-5 /* of a position: the noise of a mean is at least that */

typedef struct {
    const sensor_fault *row;
    invcal_background background; /* contains the session */
    invcal_session *session;
    triad_truth truth;
    random_source random;
    int32_t latest[3]; /* what a part that does not change keeps reading */
    unsigned long samples;
    int position;
    double up[3];
    unsigned refused[INVCAL_STATUS_END];
    unsigned all_refused;
} bench;

static bench b;

static int has_begun(void)
{
    return b.position >= b.row->from;
}

static void break_reading(int32_t raw[3])
{
    const int32_t x = raw[0];

    switch (b.row->what) {
    case NOTHING_BUT_ZEROS:
        memset(raw, 0, 3 * sizeof raw[0]);
        break;
    case FROZEN:
        memcpy(raw, b.latest, sizeof b.latest);
        break;
    case STUCK_AXIS:
        raw[2] = b.latest[2];
        break;
    case CLIPS: /* at 0.8 g */
        for (int i = 0; i < 3; i++) {
            raw[i] = raw[i] > 13107 ? 13107 : raw[i] < -13107 ? -13107 : raw[i];
        }
        break;
    case SWAPS_AXES:
        raw[0] = raw[1];
        raw[1] = x;
        break;
    case GLITCHES: /* in the middle of the fourth rest */
        raw[1] = b.samples % 10000 == 640 ? 32767 : raw[1];
        break;
    default:
        break;
    }
}

static void note(invcal_event event)
{
    if (event == INVCAL_REFUSED) {
        b.refused[invcal_session_reason(b.session)]++;
        b.all_refused++;
    }
}

static void sample(double shake)
{
    const double force[3] = {b.up[0] + shake, b.up[1] - shake, b.up[2] + shake};
    double u[3];
    int32_t raw[3];

    triad_read(&b.truth, force, u);
    for (int i = 0; i < 3; i++) {
        raw[i] = (int32_t)floor((u[i] + NOISE * random_normal(&b.random)) * COUNTS + 0.5);
    }
    b.samples++;
    if (has_begun()) {
        break_reading(raw);
    }
    memcpy(b.latest, raw, sizeof raw);
    note(invcal_session_feed(b.session, raw[0], raw[1], raw[2]));
}

/* How many samples come in n / RATE seconds. */
static int number(int n)
{
    return !has_begun() ? n : b.row->what == SLOWER ? n / 2 : b.row->what == FASTER ? 2 * n : n;
}

/* A turn of a second, and a rest of 2.5 s. */
static void visit(const double to[3])
{
    const double from[3] = {b.up[0], b.up[1], b.up[2]};
    const int steps = number(MOVE);

    for (int i = 0; i < steps; i++) {
        const double s = (double)(i + 1) / steps;
        for (int k = 0; k < 3; k++) {
            b.up[k] = from[k] + (to[k] - from[k]) * s + 0.3 * s * (1 - s);
        }
        const double length = length3(b.up);
        for (int k = 0; k < 3; k++) {
            b.up[k] /= length;
        }
        sample(0.1 * s * (1 - s) * (i % 3 - 1));
    }
    for (int i = number(REST); i > 0; i--) {
        if (b.row->what == CLOCK_JUMPS && i == REST / 2) {
            invcal_session_gap(b.session); /* all that the library knows of a clock */
        }
        sample(0);
    }
}

static void run_session(const sensor_fault *row)
{
    memset(&b, 0, sizeof b);
    b.row = row;
    b.session = &b.background.session;
    b.random = random_start(7);
    b.truth = triad_random(&b.random, 0.02);
    memcpy(b.up, expected_plan18[0], sizeof b.up);
    TEST_ASSERT_EQUAL_INT_MESSAGE(
        INVCAL_OK, invcal_session_init(b.session, sizeof *b.session, (invcal_real)COUNTS, RATE),
        row->name);
    if (row->rails) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_set_limits(b.session, -13107, 13107));
    }
    for (b.position = 0; b.position < POSITIONS; b.position++) {
        visit(expected_plan18[b.position]);
    }
    note(invcal_session_end(b.session));
}

/* A triad whose x and y axes are always exchanged is one with exchanged errors. */
static void exchange_truth(void)
{
    static const unsigned char pair[3][2] = {{INVCAL_DELTA_X, INVCAL_DELTA_Y},
                                             {INVCAL_DK_X, INVCAL_DK_Y},
                                             {INVCAL_GAMMA_XZ, INVCAL_GAMMA_ZY}};

    for (int i = 0; i < 3; i++) {
        const double first = b.truth.x[pair[i][0]];
        b.truth.x[pair[i][0]] = b.truth.x[pair[i][1]];
        b.truth.x[pair[i][1]] = first;
    }
}

/* Every parameter is within 1.5 half widths of its 95 % interval. */
static void check_parameters(const sensor_fault *row, const invcal_calibration *c,
                             const invcal_quality *q)
{
    const triad_truth found = truth_of(c, &b.session->nominal);

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const double width = (double)q->sigma[r] * (double)invcal_coverage(q->sigma_dof);
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1.5 * width, b.truth.x[r], found.x[r], row->name);
    }
}

static void check_sensor(const sensor_fault *row)
{
    invcal_calibration calibration;
    invcal_quality quality;

    run_session(row);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(row->taken, b.session->count, row->name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(row->refused, b.all_refused, row->name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(row->refused, b.refused[row->reason], row->name);
    const invcal_status status = invcal_session_solve(b.session, &calibration, &quality);
    TEST_ASSERT_EQUAL_INT_MESSAGE(row->status, status, row->name);
    if (status != INVCAL_OK) {
        TEST_ASSERT_FALSE_MESSAGE(row->reaches, row->name);
        return;
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(
        row->reaches,
        invcal_reaches(&quality, INVCAL_REAL(0.001), INVCAL_REAL(0.001), INVCAL_REAL(0.001)),
        row->name);
    TEST_ASSERT_EQUAL_INT_MESSAGE(row->reaches ? INVCAL_GOOD : INVCAL_DRIFTING, quality.verdict,
                                  row->name);
    TEST_ASSERT_TRUE_MESSAGE(quality.left_out == 0, row->name);
    TEST_ASSERT_TRUE_MESSAGE((double)quality.noise >= row->noise, row->name);
    TEST_ASSERT_TRUE_MESSAGE((double)quality.noise < 4 * row->noise, row->name);
    if (row->what == SWAPS_AXES && row->from == 0) {
        exchange_truth();
    }
    check_parameters(row, &calibration, &quality);
}

static const sensor_fault sensor_faults[] = {
    {"none", NO_FAULT, 0, 0, 18, 0, INVCAL_OK, 1, INVCAL_OK, ANY_ERROR},
    {"nothing but zeros", NOTHING_BUT_ZEROS, 0, 0, 0, 1, INVCAL_REST_FROZEN, 0, INVCAL_TOO_FEW, 0},
    {"frozen from the beginning", FROZEN, 0, 0, 0, 1, INVCAL_REST_FROZEN, 0, INVCAL_TOO_FEW, 0},
    {"freezes half-way", FROZEN, HALF, 0, 9, 1, INVCAL_REST_FROZEN, 0, INVCAL_UNDETERMINED, 0},
    {"one axis frozen", STUCK_AXIS, 0, 0, 0, 18, INVCAL_REST_FROZEN, 0, INVCAL_TOO_FEW, 0},
    {"one axis freezes half-way", STUCK_AXIS, HALF, 0, 9, 9, INVCAL_REST_FROZEN, 0,
     INVCAL_UNDETERMINED, 0},
    {"clips at a rail that was stated", CLIPS, 0, 1, 0, 18, INVCAL_REST_CLIPPED, 0, INVCAL_TOO_FEW,
     0},
    {"clips at a rail that was not", CLIPS, 0, 0, 0, 18, INVCAL_REST_FROZEN, 0, INVCAL_TOO_FEW, 0},
    /* Lengths do not show a mirrored triad: it is calibrated as it reads. */
    {"two axes exchanged", SWAPS_AXES, 0, 0, 18, 0, INVCAL_OK, 1, INVCAL_OK, ANY_ERROR},
    /* The disagreement is noise, 100 times as large as without, and changes like a drift. */
    {"two axes exchanged half-way", SWAPS_AXES, HALF, 0, 18, 0, INVCAL_OK, 0, INVCAL_OK,
     100 * ANY_ERROR},
    {"one sample of 10,000 is wrong", GLITCHES, 0, 0, 18, 0, INVCAL_OK, 1, INVCAL_OK, ANY_ERROR},
    {"half as many samples a second, half-way", SLOWER, HALF, 0, 9, 9, INVCAL_REST_SHORT, 0,
     INVCAL_UNDETERMINED, 0},
    {"twice as many", FASTER, HALF, 0, 18, 0, INVCAL_OK, 1, INVCAL_OK, ANY_ERROR},
    {"the clock jumps in every rest", CLOCK_JUMPS, 0, 0, 18, 0, INVCAL_OK, 1, INVCAL_OK, ANY_ERROR},
};

static void each_fault_of_the_sensor_is_reported_or_does_no_harm(void)
{
    for (unsigned i = 0; i < sizeof sensor_faults / sizeof sensor_faults[0]; i++) {
        check_sensor(&sensor_faults[i]);
    }
}

/* A calendar that jumps ahead by years drops the positions of the background: there is no
 * calibration from them any more, but no wrong one, either. */
static void a_calendar_that_jumps_ends_in_too_few_positions(void)
{
    const sensor_fault row = {.name = "calendar"};
    invcal_calibration calibration;
    invcal_quality quality;

    run_session(&row);
    TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_session_solve(b.session, &calibration, &quality));
    for (int day = 0; day < 3650; day++) {
        invcal_background_age(&b.background);
    }
    TEST_ASSERT_EQUAL_INT(INVCAL_TOO_FEW, invcal_session_solve(b.session, &calibration, &quality));
    TEST_ASSERT_EQUAL_UINT(0, b.session->count);
}

/* ---- a memory that fails --------------------------------------------------------------------- */

enum { SLOT = 64, SIZE = 20, GRANULE = 4 };
enum { OLDER = 'a', OLD = 'b', NEW = 'c' }; /* records: all bytes are this */

typedef enum {
    SOUND,
    CUT_IN_ERASE,
    CUT_IN_PROGRAM,
    CUT_BEFORE_CONFIRMED,
    ERASE_FAILS,
    ERASE_DOES_NOTHING,
    PROGRAM_FAILS,
    PROGRAM_DOES_NOTHING,
    CELL_IS_WORN,
    BITS_ROT,
    BITS_ROT_IN_BOTH,
    SLOT_IS_UNREADABLE,
    BOTH_ARE_UNREADABLE
} memory_failure;

typedef struct {
    const char *name;
    memory_failure what;
    invcal_status save; /* of the new record, */
    invcal_status load; /* and what is then loaded */
    int record;
} memory_fault;

static struct {
    uint8_t bytes[2][SLOT];
    memory_failure what;
    int is_off; /* no power */
} flash;

static unsigned newest_slot(void)
{
    return flash.bytes[1][SIZE / 2] == NEW;
}

static int nor_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &flash.bytes[slot][offset], size);
    return flash.is_off || flash.what == BOTH_ARE_UNREADABLE ||
           (flash.what == SLOT_IS_UNREADABLE && slot == newest_slot());
}

static int nor_erase(void *context, unsigned slot)
{
    (void)context;
    if (flash.is_off || flash.what == ERASE_FAILS) {
        return 1;
    }
    if (flash.what == CUT_IN_ERASE) { /* half done, bit by bit */
        for (unsigned i = 0; i < SLOT; i++) {
            flash.bytes[slot][i] |= (uint8_t)(i % 3 ? 0x5A : 0xFF);
        }
        flash.is_off = 1;
        return 1;
    }
    if (flash.what != ERASE_DOES_NOTHING) {
        memset(flash.bytes[slot], 0xFF, SLOT);
    }
    return 0;
}

static int nor_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                       uint32_t size)
{
    const int confirms = size == GRANULE && bytes[0] == 0 && bytes[GRANULE - 1] == 0;

    (void)context;
    if (flash.is_off || flash.what == PROGRAM_FAILS) {
        return 1;
    }
    for (uint32_t i = 0; i < size && flash.what != PROGRAM_DOES_NOTHING; i++) {
        const int is_torn = (flash.what == CUT_IN_PROGRAM && i == size / 2) ||
                            (flash.what == CUT_BEFORE_CONFIRMED && confirms);
        if (is_torn) {
            flash.is_off = 1;
            return 1;
        }
        const int is_worn = flash.what == CELL_IS_WORN && offset + i == 13;
        flash.bytes[slot][offset + i] &= (uint8_t)(bytes[i] | (is_worn ? 4 : 0));
    }
    return 0;
}

static const invcal_store store = {nor_read, nor_erase, nor_program, NULL, SLOT, GRANULE};

static invcal_status save(int record)
{
    uint8_t bytes[SIZE];

    memset(bytes, record, sizeof bytes);
    return invcal_store_save(&store, bytes, sizeof bytes);
}

static void check_memory(const memory_fault *row)
{
    uint8_t bytes[SIZE];
    uint32_t size = 0;

    memset(flash.bytes, 0xFF, sizeof flash.bytes);
    flash.what = SOUND;
    flash.is_off = 0;
    TEST_ASSERT_EQUAL_INT_MESSAGE(INVCAL_OK, save(OLDER), row->name);
    TEST_ASSERT_EQUAL_INT_MESSAGE(INVCAL_OK, save(OLD), row->name);
    const int after = row->what >= BITS_ROT;
    flash.what = after ? SOUND : row->what;
    TEST_ASSERT_EQUAL_INT_MESSAGE(row->save, save(NEW), row->name);
    flash.what = after ? row->what : SOUND; /* power is back, or time has passed */
    flash.is_off = 0;
    if (row->what == BITS_ROT || row->what == BITS_ROT_IN_BOTH) {
        flash.bytes[newest_slot()][20] ^= 0x10;
        flash.bytes[!newest_slot()][9] ^= row->what == BITS_ROT ? 0 : 0x01;
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(row->load, invcal_store_load(&store, bytes, SIZE, &size),
                                  row->name);
    if (row->load == INVCAL_OK) {
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(SIZE, size, row->name);
        for (unsigned i = 0; i < SIZE; i++) {
            TEST_ASSERT_EQUAL_INT_MESSAGE(row->record, bytes[i], row->name);
        }
    }
}

static const memory_fault memory_faults[] = {
    {"none", SOUND, INVCAL_OK, INVCAL_OK, NEW},
    {"power cut while it erases", CUT_IN_ERASE, INVCAL_IO, INVCAL_OK, OLD},
    {"power cut while it programs", CUT_IN_PROGRAM, INVCAL_IO, INVCAL_OK, OLD},
    {"power cut before it is confirmed", CUT_BEFORE_CONFIRMED, INVCAL_IO, INVCAL_OK, OLD},
    {"erasing fails", ERASE_FAILS, INVCAL_IO, INVCAL_OK, OLD},
    {"erasing does nothing, and says it did", ERASE_DOES_NOTHING, INVCAL_IO, INVCAL_OK, OLD},
    {"programming fails", PROGRAM_FAILS, INVCAL_IO, INVCAL_OK, OLD},
    {"programming does nothing, and says it did", PROGRAM_DOES_NOTHING, INVCAL_IO, INVCAL_OK, OLD},
    {"a cell reads back wrong", CELL_IS_WORN, INVCAL_IO, INVCAL_OK, OLD},
    {"a bit of the record rots", BITS_ROT, INVCAL_OK, INVCAL_OK, OLD},
    {"bits of both records rot", BITS_ROT_IN_BOTH, INVCAL_OK, INVCAL_NO_RECORD, 0},
    {"a slot cannot be read any more", SLOT_IS_UNREADABLE, INVCAL_OK, INVCAL_OK, OLD},
    {"neither can be read", BOTH_ARE_UNREADABLE, INVCAL_OK, INVCAL_IO, 0},
};

static void each_fault_of_the_memory_is_reported_and_leaves_an_older_record(void)
{
    for (unsigned i = 0; i < sizeof memory_faults / sizeof memory_faults[0]; i++) {
        check_memory(&memory_faults[i]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_SLOW_TEST(each_fault_of_the_sensor_is_reported_or_does_no_harm);
    RUN_SLOW_TEST(a_calendar_that_jumps_ends_in_too_few_positions);
    RUN_TEST(each_fault_of_the_memory_is_reported_and_leaves_an_older_record);
    return UNITY_END();
}
