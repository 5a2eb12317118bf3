/* SPDX-License-Identifier: MIT
 *
 * Encodes and decodes the result of both sensors: the table is in gyro.h. The record of the
 * accelerometer is inside, complete with its own CRC, and record.c reads it. Reals are the first
 * members of the structure, in the order of the bytes, so that they are copied as one run.
 */
#include <stddef.h>
#include <string.h>

#include "../core/bytes.h"
#include "invcal/gyro.h"
#include "../core/solve.h"
#include "../core/vector.h"

enum { IMU_RECORD_AT = 4, IMU_WEAK_AT = IMU_RECORD_AT + INVCAL_RECORD_SIZE };
enum { IMU_DOF_AT = IMU_WEAK_AT + 2, IMU_VERDICT_AT = IMU_WEAK_AT + 4 };
enum { IMU_MOVES_AT = IMU_WEAK_AT + 5, IMU_G_AT = IMU_WEAK_AT + 6 };
enum { IMU_NOTHING_AT = IMU_WEAK_AT + 7, IMU_REALS_AT = IMU_WEAK_AT + 8, IMU_REALS = 48 };
#define IMU_WEAK 0x1FFu /* as a mask */

/* The reals come first in the structure, too, and in the same order. */
typedef char invcal_imu_is_in_order
    [offsetof(invcal_imu_record, accelerometer) == IMU_REALS * sizeof(invcal_real) ? 1 : -1];

/* A record is WEAK if and only if it has weak parameters. */
static int is_sensible(const invcal_imu_record *r)
{
    return (r->verdict & 15u) == 0 && r->verdict <= INVCAL_WEAK && r->weak <= IMU_WEAK &&
           r->g_is_used <= 1 &&
           (r->verdict == INVCAL_WEAK ? (r->weak | r->accelerometer.weak) > 0 : r->weak == 0);
}

/* r is lost on failure. */
static invcal_status read_imu(const uint8_t *bytes, uint32_t size, invcal_imu_record *r)
{
    invcal_status status = invcal_unseal(bytes, size, INVCAL_IMU_KIND);
    if (status != INVCAL_OK) {
        return status;
    }
    if (invcal_get_u16(bytes + 2) != INVCAL_IMU_RECORD_SIZE || bytes[IMU_NOTHING_AT] != 0) {
        return INVCAL_DAMAGED;
    }
    status = invcal_record_decode(bytes + IMU_RECORD_AT, INVCAL_RECORD_SIZE, &r->accelerometer);
    if (status != INVCAL_OK) {
        return status;
    }
    if (!invcal_get_reals(bytes + IMU_REALS_AT, r, IMU_REALS)) {
        return INVCAL_NOT_FINITE;
    }
    r->weak = invcal_get_u16(bytes + IMU_WEAK_AT);
    r->dof = invcal_get_u16(bytes + IMU_DOF_AT);
    r->verdict = invcal_swap(bytes[IMU_VERDICT_AT]);
    r->moves = bytes[IMU_MOVES_AT];
    r->g_is_used = bytes[IMU_G_AT];
    return is_sensible(r) ? invcal_nominal_check(&r->gyro) : INVCAL_DAMAGED;
}

/* The record of the accelerometer may be WEAK only for a parameter of its own. If just the
 * gyroscope is weak, the accelerometer is not good either: nothing has checked it. */
void invcal_imu_record_init(invcal_imu_record *record, const invcal_imu *imu)
{
    invcal_record *a = &record->accelerometer;

    INVCAL_ASSERT(record && imu);
    invcal_zero(record, sizeof *record);
    record->move_noise = imu->move_noise;
    record->move_rms = imu->move_rms;
    record->move_max = imu->move_max;
    record->gyro = imu->gyro;
    memcpy(record->sigma, imu->sigma, sizeof record->sigma);
    memcpy(record->slope, imu->slope, sizeof record->slope);
    memcpy(record->slope_sigma, imu->slope_sigma, sizeof record->slope_sigma);
    record->weak = (uint16_t)(imu->open & IMU_WEAK);
    record->dof = imu->dof;
    record->verdict = imu->verdict;
    record->moves = imu->moves;
    record->g_is_used = imu->g_is_used;
    a->noise = imu->noise;
    a->calibration = imu->accelerometer;
    memcpy(a->sigma, &imu->sigma[INVCAL_GYRO_PARAMETERS], sizeof a->sigma);
    a->weak = (uint16_t)(imu->open >> (unsigned)INVCAL_GYRO_PARAMETERS);
    a->verdict = imu->verdict == INVCAL_WEAK && a->weak == 0 ? (invcal_verdict)INVCAL_NO_REDUNDANCY
                                                             : imu->verdict;
}

/* Decodes what was encoded: after rounding to float it may not be a record. */
invcal_status invcal_imu_record_encode(const invcal_imu_record *record,
                                       uint8_t bytes[INVCAL_IMU_RECORD_SIZE])
{
    invcal_imu_record r;

    INVCAL_ASSERT(record && bytes);
    const invcal_status status =
        invcal_record_encode(&record->accelerometer, bytes + IMU_RECORD_AT);
    if (status != INVCAL_OK) {
        return status;
    }
    uint8_t *at = invcal_put_two(bytes + IMU_WEAK_AT, record->weak, record->dof);
    at = invcal_put_two(at, invcal_swap(record->verdict) | (unsigned)record->moves << 8,
                        record->g_is_used);
    (void)invcal_put_reals(at, record, IMU_REALS);
    invcal_seal(bytes, INVCAL_IMU_KIND, INVCAL_IMU_RECORD_SIZE);
    return read_imu(bytes, INVCAL_IMU_RECORD_SIZE, &r);
}

invcal_status invcal_imu_record_decode(const uint8_t *bytes, uint32_t size, invcal_imu_record *out)
{
    invcal_imu_record r;

    INVCAL_ASSERT(bytes && out);
    const invcal_status status = read_imu(bytes, size, &r);
    if (status == INVCAL_OK) {
        *out = r;
    }
    return status;
}

/* ---- in a memory ----------------------------------------------------------------------------- */

invcal_status invcal_imu_save(const invcal_imu *imu, const invcal_store *store)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    invcal_imu_record r;

    INVCAL_ASSERT(imu);
    invcal_imu_record_init(&r, imu);
    const invcal_status status = invcal_imu_record_encode(&r, bytes);
    return status == INVCAL_OK ? invcal_store_save(store, bytes, sizeof bytes) : status;
}

invcal_status invcal_imu_load(invcal_imu_record *out, const invcal_store *store)
{
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    uint32_t size = 0;

    const invcal_status status = invcal_store_load(store, bytes, sizeof bytes, &size);
    return status == INVCAL_OK ? invcal_imu_record_decode(bytes, size, out) : status;
}
