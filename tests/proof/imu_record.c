/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/gyro_store.h"
#include "core/solve.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 60 -eva-slevel 60 -eva-slevel-function invcali_crc32:0 -eva-split-return full
// stubs: record store nominal

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_record_encode(const invcal_record *record, uint8_t bytes[INVCAL_RECORD_SIZE])
{
    (void)record->temperature_known;
    Frama_C_make_unknown((char *)bytes, INVCAL_RECORD_SIZE);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    (void)bytes[size - 1];
    if (BETWEEN(0, 1)) {
        ANY(*out);
        return INVCAL_OK;
    }
    return INVCAL_DAMAGED;
}

invcal_status invcali_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

invcal_status invcal_store_save(const invcal_store *store, const uint8_t *bytes, uint32_t size)
{
    (void)store->slot_size;
    (void)bytes[size - 1];
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_IO);
}

static uint32_t loaded;  /* bytes in the store */
static unsigned is_long; /* whether they state the length of a record */

invcal_status invcal_store_load(const invcal_store *store, uint8_t *bytes, uint32_t capacity,
                                uint32_t *size)
{
    (void)store->slot_size;
    if (loaded > capacity || BETWEEN(0, 1)) {
        return (invcal_status)BETWEEN(INVCAL_BAD_STORE, INVCAL_IO);
    }
    Frama_C_make_unknown((char *)bytes, loaded);
    if (loaded >= 4) {
        bytes[2] = INVCAL_IMU_RECORD_SIZE % 256;
        bytes[3] = is_long ? INVCAL_IMU_RECORD_SIZE / 256 : 0;
    }
    *size = loaded;
    return INVCAL_OK;
}

/* ---- the record ------------------------------------------------------------------------------- */

/* From a buffer of exactly that many bytes, which state a length whose bytes are from range[0] to range[1] and
 * from range[2] to range[3]. */
static void decode(uint32_t size, const unsigned range[4])
{
    static uint8_t buffer[INVCAL_IMU_RECORD_SIZE + 2];
    uint8_t *bytes = &buffer[sizeof buffer - size];
    invcal_imu_result result;
    invcal_record about;

    ANY(buffer);
    if (size >= 4) {
        bytes[2] = (uint8_t)BETWEEN(range[0], range[1]);
        bytes[3] = (uint8_t)BETWEEN(range[2], range[3]);
    }
    (void)invcal_imu_decode(bytes, size, &result, BETWEEN(0, 1) ? &about : NULL);
}

/* All lengths, the right one separately from the others. */
static void decode_all(uint32_t size)
{
    enum { LOW = INVCAL_IMU_RECORD_SIZE % 256, HIGH = INVCAL_IMU_RECORD_SIZE / 256 };

    decode(size, (const unsigned[4]){LOW, LOW, HIGH, HIGH});
    decode(size, (const unsigned[4]){0, LOW - 1, HIGH, HIGH});
    decode(size, (const unsigned[4]){LOW + 1, LOW + 1, HIGH, HIGH});
    decode(size, (const unsigned[4]){LOW + 2, 255, HIGH, HIGH});
    decode(size, (const unsigned[4]){0, 255, 0, 0});
    decode(size, (const unsigned[4]){0, 255, HIGH + 1, 255});
}

void main(void)
{
    static const uint32_t sizes[] = {0,
                                     1,
                                     7,
                                     8,
                                     140,
                                     INVCAL_IMU_RECORD_SIZE - 1,
                                     INVCAL_IMU_RECORD_SIZE,
                                     INVCAL_IMU_RECORD_SIZE + 2};
    uint8_t bytes[INVCAL_IMU_RECORD_SIZE];
    invcal_imu_result result;
    invcal_record about;
    invcal_store store;

    ANY(result);
    ANY(about);
    (void)invcal_imu_encode(&result, NULL, bytes);
    (void)invcal_imu_encode(&result, &about, bytes);
    ANY(store);
    (void)invcal_imu_save_result(&result, &store);
    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        decode_all(sizes[i]);
        loaded = sizes[i];
        for (is_long = 0; is_long < 2; is_long++) {
            (void)invcal_imu_load_result(&result, &store);
        }
    }
}
