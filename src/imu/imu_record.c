/* SPDX-License-Identifier: MIT
 *
 * Encodes and decodes the result of both sensors: the table is in frozen.md. The record of
 * the accelerometer is inside, complete with its own CRC, and record.c reads it. Reals are the first
 * members of the structure, in the order of the bytes, so that they are copied as two runs: sigma of
 * the accelerometer is between them.
 */
#include <stddef.h>
#include <string.h>

#include "../core/bytes.h"
#include "invcal/gyro_store.h"
#include "../session/session.h"
#include "../core/solve.h"
#include "../core/vector.h"

enum { IMU_RECORD_AT = 4, IMU_WEAK_AT = IMU_RECORD_AT + INVCAL_RECORD_SIZE };
enum { IMU_DOF_AT = IMU_WEAK_AT + 2, IMU_VERDICT_AT = IMU_WEAK_AT + 4 };
enum { IMU_MOVES_AT = IMU_WEAK_AT + 5, IMU_G_AT = IMU_WEAK_AT + 6 };
enum { IMU_NOTHING_AT = IMU_WEAK_AT + 7, IMU_REALS_AT = IMU_WEAK_AT + 8 };
enum { FIRST_REALS = 15, LAST_REALS = 33, LAST_AT = IMU_REALS_AT + 4 * FIRST_REALS };
#define IMU_WEAK 0x1FFu /* as a mask */

/* The reals come first in the structure, too, and in the same order. */
typedef char invcali_imu_is_in_order[offsetof(invcal_imu_result, sigma) ==
                                                 FIRST_REALS * sizeof(invcal_real) &&
                                             offsetof(invcal_imu_result, accelerometer) ==
                                                 (FIRST_REALS + INVCAL_PARAMETERS + LAST_REALS) *
                                                     sizeof(invcal_real)
                                         ? 1
                                         : -1];

/* A result is WEAK if and only if it has weak parameters. */
static int is_sensible(const invcal_imu_result *r, unsigned weak)
{
    return (r->verdict & 15u) == 0 && r->verdict <= INVCAL_WEAK && weak <= IMU_WEAK &&
           r->g_is_used <= 1 && (r->verdict == INVCAL_WEAK ? r->weak > 0 : weak == 0);
}

/* Both are lost on failure. */
static invcal_status read_imu(const uint8_t *bytes, uint32_t size, invcal_imu_result *r,
                              invcal_record *a)
{
    invcal_status status = invcali_unseal(bytes, size, INVCAL_IMU_KIND);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcali_get_u16(bytes + 2) != INVCAL_IMU_RECORD_SIZE || bytes[IMU_NOTHING_AT] != 0) {
        return INVCAL_DAMAGED;
    }
    status = invcal_record_decode(bytes + IMU_RECORD_AT, INVCAL_RECORD_SIZE, a);
    if (status != INVCAL_OK) {
        return status;
    }
    invcali_zero(r, sizeof *r);
    const int are_finite =
        invcali_get_reals(bytes + IMU_REALS_AT, r, FIRST_REALS) &
        invcali_get_reals(bytes + LAST_AT, &r->sigma[INVCAL_PARAMETERS], LAST_REALS);
    if (!are_finite) {
        return INVCAL_NOT_FINITE;
    }
    const unsigned weak = invcali_get_u16(bytes + IMU_WEAK_AT);
    memcpy(r->sigma, a->sigma, sizeof a->sigma);
    r->accelerometer = a->calibration;
    r->noise = a->noise;
    r->weak = (uint32_t)weak << INVCAL_PARAMETERS | a->weak;
    r->dof = invcali_get_u16(bytes + IMU_DOF_AT);
    r->verdict = invcali_swap(bytes[IMU_VERDICT_AT]);
    r->moves = bytes[IMU_MOVES_AT];
    r->g_is_used = bytes[IMU_G_AT];
    return is_sensible(r, weak) ? invcali_nominal_check(&r->gyro) : INVCAL_DAMAGED;
}

/* The record of the accelerometer: its own, or one made from the result. It may be WEAK only for a
 * parameter of its own. If just the gyroscope is weak, the accelerometer is not good either: nothing
 * has checked it. */
static void make_record(const invcal_imu_result *r, const invcal_record *about, invcal_record *a)
{
    if (about != NULL) {
        *a = *about;
        if (invcali_is_same((const uint8_t *)&about->calibration,
                            (const uint8_t *)&r->accelerometer,
                            (unsigned)sizeof r->accelerometer)) {
            return;
        }
    } else {
        invcali_zero(a, sizeof *a);
    }
    a->noise = r->noise;
    a->rms = 0;
    a->condition = 0;
    a->calibration = r->accelerometer;
    memcpy(a->sigma, r->sigma, sizeof a->sigma);
    a->positions = 0;
    a->held = 0;
    a->weak = (uint16_t)(r->weak & IMU_WEAK);
    a->verdict = r->verdict == INVCAL_WEAK && a->weak == 0 ? (invcal_verdict)INVCAL_NO_REDUNDANCY
                                                           : r->verdict;
}

/* Decodes what was encoded: after rounding to float it may not be a record. */
invcal_status invcal_imu_encode(const invcal_imu_result *result, const invcal_record *about,
                                uint8_t bytes[INVCAL_IMU_RECORD_SIZE])
{
    invcal_record a;
    invcal_imu_result r;

    INVCAL_ASSERT(result && bytes);
    make_record(result, about, &a);
    const invcal_status status = invcal_record_encode(&a, bytes + IMU_RECORD_AT);
    if (status != INVCAL_OK) {
        return status;
    }
    uint8_t *at = invcali_put_two(bytes + IMU_WEAK_AT,
                                  (unsigned)(result->weak >> INVCAL_PARAMETERS), result->dof);
    at = invcali_put_two(at, invcali_swap(result->verdict) | (unsigned)result->moves << 8,
                         result->g_is_used);
    at = invcali_put_reals(at, result, FIRST_REALS);
    (void)invcali_put_reals(at, &result->sigma[INVCAL_PARAMETERS], LAST_REALS);
    invcali_seal(bytes, INVCAL_IMU_KIND, INVCAL_IMU_RECORD_SIZE);
    return read_imu(bytes, INVCAL_IMU_RECORD_SIZE, &r, &a);
}

invcal_status invcal_imu_decode(const uint8_t *bytes, uint32_t size, invcal_imu_result *out,
                                invcal_record *about)
{
    invcal_imu_result r;
    invcal_record a;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_imu(bytes, size, &r, &a);
    if (status == INVCAL_OK) {
        *out = r;
        if (about != NULL) {
            *about = a;
        }
    }
    return status;
}

/* ---- in a memory ----------------------------------------------------------------------------- */

invcal_status invcal_imu_save_result(const invcal_imu_result *result, const invcal_store *store)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];

    INVCAL_ASSERT(result && store);
    const invcal_status status = invcal_imu_encode(result, NULL, bytes);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, sizeof bytes) : status;
}

invcal_status invcal_imu_load_result(invcal_imu_result *out, const invcal_store *store)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    uint32_t size = 0;

    INVCAL_ASSERT(out && store);
    const invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_imu_decode(bytes, size, out, NULL) : status;
}
