/* SPDX-License-Identifier: MIT
 *
 * This release reads what earlier ones wrote, from 0.2.0 on: devices in the field keep their
 * calibration when their firmware is updated. What 0.1.0 wrote, version 1 of everything, is
 * recognized, and refused. The bytes are in tests/reference/releases. They are never regenerated to
 * please this test, only added to with each release; a script that shares no code with the library
 * read from them what they mean.
 */
#include <string.h>

#include "invcal/gyro_store.h"
#include "invcal/thermal_store.h"
#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- what was written ---------------------------------------------------------------------------- */

enum { REFUSED = 1 }; /* the version that is not read; a plain record of it is the longest: */
enum { LONGEST = 184 };

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
        struct {
            uint8_t degree, fitted, fallback;
            invcal_real reference, span, min, max;
            invcal_calibration nominal;
        } thermal;
        uint8_t is_triangular;
        invcal_real x[3][INVCAL_PARAMETERS];
    } is;
} stored_thermal;

typedef struct {
    const char *name;
    const uint8_t *bytes;
    uint32_t size;
    struct {
        invcal_record accelerometer;
        invcal_calibration gyro;
        invcal_real move_noise, move_rms, move_max;
        invcal_real sigma[INVCAL_IMU_PARAMETERS - INVCAL_PARAMETERS]; /* of the gyroscope */
        invcal_real slope[3][4], slope_sigma[3][4];
        unsigned weak, dof, verdict, moves, g_is_used;
    } is;
} stored_imu;

typedef struct {
    const char *name;
    const uint8_t *bytes;
    uint32_t size;
    struct {
        unsigned version;
    } is;
} stored_session;

typedef stored_record stored_flash; /* of two slots; `is` is the expected one */

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
    same(expected->matrix[0], actual->matrix[0], 9, name);
}

static void same_record(const invcal_record *expected, const invcal_record *actual,
                        const char *name)
{
    same_calibration(&expected->calibration, &actual->calibration, name);
    same(expected->sigma, actual->sigma, INVCAL_PARAMETERS, name);
    same(&expected->field, &actual->field, 1, name);
    same(&expected->field_sigma, &actual->field_sigma, 1, name);
    same(&expected->temperature, &actual->temperature, 1, name);
    same(&expected->noise, &actual->noise, 1, name);
    same(&expected->rms, &actual->rms, 1, name);
    same(&expected->condition, &actual->condition, 1, name);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected->sensor, actual->sensor, 8, name);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(expected->date, actual->date, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->temperature_known, actual->temperature_known, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->verdict, actual->verdict, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->positions, actual->positions, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->weak, actual->weak, name);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(expected->held, actual->held, name);
}

static invcal_status status_of(const uint8_t *bytes)
{
    return bytes[1] == REFUSED ? INVCAL_OTHER_VERSION : INVCAL_OK;
}

/* ---- tests ---------------------------------------------------------------------------------------- */

static void records_of_every_release_are_read(void)
{
    for (unsigned i = 0; i < COUNT(records); i++) {
        const stored_record *old = &records[i];
        uint8_t bytes[INVCAL_RECORD_SIZE];
        invcal_record now;

        memset(&now, 0, sizeof now);
        TEST_ASSERT_EQUAL_MESSAGE(status_of(old->bytes),
                                  invcal_record_decode(old->bytes, old->size, &now), old->name);
        if (old->bytes[1] == REFUSED) {
            continue;
        }
        same_record(&old->is, &now, old->name);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_record_encode(&now, bytes), old->name);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(old->bytes, bytes, sizeof bytes, old->name);
    }
}

/* Of every degree, whichever this build can fit. The byte for the triangular frame, which 0.2.0 set,
 * is ignored, and comes back as 0. */
static void thermal_records_of_every_release_are_read(void)
{
    enum { FRAME_AT = 143 };

    for (unsigned i = 0; i < COUNT(thermals); i++) {
        const stored_thermal *old = &thermals[i];
        const invcal_status expected = status_of(old->bytes);
        uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
        uint8_t again[INVCAL_THERMAL_RECORD_SIZE];
        invcal_thermal now;
        invcal_record about;

        memset(&now, 0, sizeof now);
        memset(&about, 0, sizeof about);
        TEST_ASSERT_EQUAL_MESSAGE(
            expected, invcal_thermal_decode(old->bytes, old->size, &now, &about), old->name);
        if (expected != INVCAL_OK) {
            continue;
        }
        same_record(&old->is.record, &about, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.thermal.degree, now.degree, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.thermal.fitted, now.fitted, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.thermal.fallback, now.fallback, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.is_triangular, old->bytes[FRAME_AT], old->name);
        same(&old->is.thermal.reference, &now.reference, 1, old->name);
        same(&old->is.thermal.span, &now.span, 1, old->name);
        same(&old->is.thermal.min, &now.min, 1, old->name);
        same(&old->is.thermal.max, &now.max, 1, old->name);
        same_calibration(&old->is.thermal.nominal, &now.nominal, old->name);
        same(&old->is.x[0][0], &now.x[0][0], (now.degree + 1u) * INVCAL_PARAMETERS, old->name);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_thermal_encode(&now, &about, bytes), old->name);
        memcpy(again, old->bytes, old->size);
        again[FRAME_AT] = 0;
        seal_bytes(again, old->size - 4);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(again, bytes, old->size, old->name);
    }
}

static void records_of_both_sensors_of_every_release_are_read(void)
{
    for (unsigned i = 0; i < COUNT(imus); i++) {
        const stored_imu *old = &imus[i];
        uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
        invcal_imu_result now;
        invcal_record about;

        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_imu_decode(old->bytes, old->size, &now, &about),
                                  old->name);
        same_record(&old->is.accelerometer, &about, old->name);
        same_calibration(&about.calibration, &now.accelerometer, old->name);
        same_calibration(&old->is.gyro, &now.gyro, old->name);
        same(&old->is.move_noise, &now.move_noise, 1, old->name);
        same(&old->is.move_rms, &now.move_rms, 1, old->name);
        same(&old->is.move_max, &now.move_max, 1, old->name);
        same(about.sigma, now.sigma, INVCAL_PARAMETERS, old->name);
        same(old->is.sigma, &now.sigma[INVCAL_GYRO_XX], INVCAL_IMU_PARAMETERS - INVCAL_PARAMETERS,
             old->name);
        same(old->is.slope[0], now.slope[0], 12, old->name);
        same(old->is.slope_sigma[0], now.slope_sigma[0], 12, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.weak, now.weak >> INVCAL_PARAMETERS, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.dof, now.dof, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.verdict, now.verdict, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.moves, now.moves, old->name);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(old->is.g_is_used, now.g_is_used, old->name);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_imu_encode(&now, &about, bytes), old->name);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(old->bytes, bytes, sizeof bytes, old->name);
    }
}

/* The procedure of 0.1.0 was different: its sessions are refused, and a device begins again. */
static void sessions_of_earlier_releases_are_refused_by_name(void)
{
    for (unsigned i = 0; i < COUNT(sessions); i++) {
        static invcal_session session; /* too large for a stack */
        const stored_session *old = &sessions[i];
        const uint32_t size = old->size < INVCAL_SESSION_SIZE ? old->size : INVCAL_SESSION_SIZE;

        TEST_ASSERT_EQUAL(INVCAL_OK, invcal_session_init(&session, sizeof session, 16384, 100));
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OTHER_SETTINGS,
                                  invcal_session_resume(&session, old->bytes, size), old->name);
        TEST_ASSERT_EQUAL_MESSAGE(0, session.count, old->name);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_NOTHING, invcal_session_feed(&session, 0, 0, 16384),
                                  old->name);
    }
}

/* The flash of a release, as found. */
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

static void the_latest_calibration_is_found_in_a_flash_of_every_release(void)
{
    for (unsigned i = 0; i < COUNT(flashes); i++) {
        stored_flash old = flashes[i];
        const invcal_store store = {read_flash, refuse_erase, refuse_program,
                                    &old,       old.size / 2, 8};
        uint8_t bytes[LONGEST];
        invcal_calibration calibration;
        invcal_record now;
        uint32_t size = 0;

        memset(&now, 0, sizeof now);
        memset(&calibration, 0, sizeof calibration);
        TEST_ASSERT_EQUAL_MESSAGE(INVCAL_OK, invcal_store_load(&store, bytes, sizeof bytes, &size),
                                  old.name);
        TEST_ASSERT_EQUAL_MESSAGE(status_of(bytes), invcal_record_decode(bytes, size, &now),
                                  old.name);
        /* that of version 1 is larger */
        const invcal_status expected = bytes[1] == REFUSED ? INVCAL_NO_SPACE : INVCAL_OK;
        TEST_ASSERT_EQUAL_MESSAGE(expected, invcal_load(&calibration, &store), old.name);
        if (expected == INVCAL_OK) {
            same_calibration(&old.is.calibration, &calibration, old.name);
            same_record(&old.is, &now, old.name);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(records_of_every_release_are_read);
    RUN_TEST(thermal_records_of_every_release_are_read);
    RUN_TEST(records_of_both_sensors_of_every_release_are_read);
    RUN_TEST(sessions_of_earlier_releases_are_refused_by_name);
    RUN_TEST(the_latest_calibration_is_found_in_a_flash_of_every_release);
    return UNITY_END();
}
