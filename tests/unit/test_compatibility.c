/* SPDX-License-Identifier: MIT
 *
 * What earlier releases wrote is read by this one: devices in the field keep their calibration when
 * their firmware is renewed. The bytes are in tests/reference/releases. They are never made anew to
 * please this test, only added to with each release; what they mean was read from them by a script
 * that shares no code with the library.
 */
#include <string.h>

#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- what was written ---------------------------------------------------------------------------- */

enum { TABLE = 32, SUMS = INVCAL_MOMENTS + INVCAL_PARAMETERS + 1 };

typedef struct {
    const char *name;
    const uint8_t *bytes;
    uint32_t size;
    invcal_record is;
} stored_record;

typedef struct {
    const char *name;
    const uint8_t *bytes;
    uint32_t size;
    struct {
        invcal_record record;
        uint8_t degree, fitted, fallback, frame;
        invcal_real reference, span, least, greatest;
        invcal_calibration nominal;
        invcal_real x[3][INVCAL_PARAMETERS];
    } is;
} stored_thermal;

typedef struct {
    const char *name;
    const uint8_t *bytes;
    uint32_t size;
    struct {
        invcal_session_setup setup;
        unsigned stored, step, taken, is_enough;
        invcal_real temperature, coldest, warmest, hold;
        invcal_real mean[TABLE][3];
        uint8_t age[TABLE];
        invcal_real sums[SUMS]; /* if more were taken than are stored */
    } is;
} stored_session;

typedef stored_record stored_flash; /* of two slots; `is` is what is loaded */

#include "releases/values.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

/* ---- comparisons: all values are floats, which every build reads as they are --------------------- */

static void same(const invcal_real *expected, const invcal_real *actual, unsigned count,
                 const char *what)
{
    for (unsigned i = 0; i < count; i++) {
        TEST_ASSERT_MESSAGE(expected[i] == actual[i], what);
    }
}

static void same_calibration(const invcal_calibration *expected, const invcal_calibration *actual,
                             const char *name)
{
    same(expected->offset, actual->offset, 3, name);
    same(&expected->matrix[0][0], &actual->matrix[0][0], 9, name);
}

static void same_record(const invcal_record *expected, const invcal_record *actual,
                        const char *name)
{
    same_calibration(&expected->calibration, &actual->calibration, name);
    same(expected->delta, actual->delta, 3, name);
    same(expected->dk, actual->dk, 3, name);
    same(expected->gamma, actual->gamma, 3, name);
    same(expected->sigma_offset, actual->sigma_offset, 3, name);
    same(expected->sigma_delta, actual->sigma_delta, 3, name);
    same(expected->sigma_dk, actual->sigma_dk, 3, name);
    same(expected->sigma_gamma, actual->sigma_gamma, 3, name);
    same(&expected->field, &actual->field, 1, name);
    same(&expected->field_sigma, &actual->field_sigma, 1, name);
    same(&expected->temperature, &actual->temperature, 1, name);
    same(&expected->noise, &actual->noise, 1, name);
    same(&expected->residual_rms, &actual->residual_rms, 1, name);
    same(&expected->condition, &actual->condition, 1, name);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected->sensor, actual->sensor, 8, name);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(expected->date, actual->date, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->temperature_known, actual->temperature_known, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->verdict, actual->verdict, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->positions, actual->positions, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->undetermined, actual->undetermined, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->from_prior, actual->from_prior, name);
}

/* ---- tests ---------------------------------------------------------------------------------------- */

static void records_of_every_release_are_read(void)
{
    for (unsigned i = 0; i < COUNT(records); i++) {
        const stored_record *old = &records[i];
        invcal_record now;

        memset(&now, 0, sizeof now);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_record_decode(old->bytes, old->size, &now),
                                  old->name);
        same_record(&old->is, &now, old->name);
    }
}

static void thermal_records_of_every_release_are_read(void)
{
    for (unsigned i = 0; i < COUNT(thermals); i++) {
        const stored_thermal *old = &thermals[i];
        const invcal_status expected =
            old->is.degree > INVCAL_THERMAL_DEGREE ? INVCAL_OTHER_VERSION : INVCAL_OK;
        const invcal_thermal_calibration *now;
        invcal_thermal_record found;

        memset(&found, 0, sizeof found);
        TEST_ASSERT_EQUAL_MESSAGE(
            expected, invcal_thermal_record_decode(old->bytes, old->size, &found), old->name);
        if (expected != INVCAL_OK) {
            continue;
        }
        same_record(&old->is.record, &found.record, old->name);
        now = &found.thermal;
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.degree, now->degree, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.fitted, now->fitted, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.fallback, now->fallback, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.frame, now->frame, old->name);
        same(&old->is.record.field, &now->field, 1, old->name);
        same(&old->is.reference, &now->reference, 1, old->name);
        same(&old->is.span, &now->span, 1, old->name);
        same(&old->is.least, &now->least, 1, old->name);
        same(&old->is.greatest, &now->greatest, 1, old->name);
        same_calibration(&old->is.nominal, &now->nominal, old->name);
        same(&old->is.x[0][0], &now->x[0][0], (now->degree + 1u) * INVCAL_PARAMETERS, old->name);
    }
}

static void same_setup(const invcal_session_setup *expected, const invcal_session_setup *actual,
                       const char *name)
{
    same_calibration(&expected->settings.nominal, &actual->settings.nominal, name);
    same(&expected->settings.field, &actual->settings.field, 1, name);
    same(&expected->settings.noise, &actual->settings.noise, 1, name);
    same(expected->settings.prior, actual->settings.prior, INVCAL_PARAMETERS, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->settings.frame, actual->settings.frame, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->plan.per_group, actual->plan.per_group, name);
    same(expected->plan.start, actual->plan.start, INVCAL_PLAN_GROUPS, name);
    same(expected->target, actual->target, 3, name);
    same(&expected->mean_sigma, &actual->mean_sigma, 1, name);
    same(&expected->rate, &actual->rate, 1, name);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(expected->low, actual->low, name);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(expected->high, actual->high, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->background, actual->background, name);
}

static void same_sums(const invcal_real sums[SUMS], const invcal_normal *normal, const char *name)
{
    same(sums, normal->moment, INVCAL_MOMENTS, name);
    same(sums + INVCAL_MOMENTS, normal->htj, INVCAL_PARAMETERS, name);
    same(sums + SUMS - 1, &normal->jtj, 1, name);
}

static invcal_session session; /* large for a stack */

static void sessions_of_every_release_are_read_and_can_be_solved(void)
{
    for (unsigned i = 0; i < COUNT(sessions); i++) {
        const stored_session *old = &sessions[i];
        const invcal_status expected =
            old->is.stored > INVCAL_MAX_POSITIONS ? INVCAL_NO_SPACE : INVCAL_OK;
        invcal_solution solution;
        invcal_quality quality;

        memset(&session, 0, sizeof session);
        TEST_ASSERT_EQUAL_MESSAGE(expected, invcal_resume_decode(old->bytes, old->size, &session),
                                  old->name);
        if (expected != INVCAL_OK) {
            continue;
        }
        same_setup(&old->is.setup, &session.setup, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.stored, session.stored, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.step, session.step, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.taken, session.normal.count, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.is_enough, session.is_enough, old->name);
        same(&old->is.temperature, &session.temperature, 1, old->name);
        same(&old->is.coldest, &session.coldest, 1, old->name);
        same(&old->is.warmest, &session.warmest, 1, old->name);
        same(&old->is.hold, &session.hold, 1, old->name);
        same(&old->is.mean[0][0], &session.mean[0][0], 3 * old->is.stored, old->name);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(old->is.age, session.age, old->is.stored, old->name);
        if (old->is.taken > old->is.stored) {
            same_sums(old->is.sums, &session.normal, old->name);
        }
        TEST_ASSERT_EQUAL_MESSAGE(
            INVCAL_OK, invcal_session_solve(&session, &solution, &quality, NULL), old->name);
    }
}

/* The flash of a release, as it was found. */
static int read_flash(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    const stored_flash *flash = context;

    memcpy(bytes, flash->bytes + slot * (flash->size / 2) + offset, size);
    return 0;
}

static int refuse_erase(void *context, unsigned slot)
{
    (void)context;
    (void)slot;
    return 1;
}

static int refuse_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                          uint32_t size)
{
    (void)context;
    (void)slot;
    (void)offset;
    (void)bytes;
    (void)size;
    return 1;
}

static void the_latest_record_is_found_in_a_flash_of_every_release(void)
{
    for (unsigned i = 0; i < COUNT(flashes); i++) {
        stored_flash old = flashes[i];
        const invcal_store store = {read_flash, refuse_erase, refuse_program,
                                    &old,       old.size / 2, 8};
        uint8_t bytes[INVCAL_RECORD_SIZE];
        invcal_record now;
        uint32_t size = 0;

        memset(&now, 0, sizeof now);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_store_load(&store, bytes, sizeof bytes, &size),
                                  old.name);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_record_decode(bytes, size, &now), old.name);
        same_record(&old.is, &now, old.name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(records_of_every_release_are_read);
    RUN_TEST(thermal_records_of_every_release_are_read);
    RUN_TEST(sessions_of_every_release_are_read_and_can_be_solved);
    RUN_TEST(the_latest_record_is_found_in_a_flash_of_every_release);
    return UNITY_END();
}
