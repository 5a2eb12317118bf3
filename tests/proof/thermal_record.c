/* SPDX-License-Identifier: MIT */
#include "any_thermal_record.h"
#include "solve.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_crc32:0 -eva-split-return full
// stubs: record solve nominal
// config: -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2

/* ---- what other modules do -------------------------------------------------------------------- */

void invcal_record_init(invcal_record *record, const invcal_calibration *calibration,
                        const invcal_quality *quality)
{
    (void)calibration->matrix[2][2];
    (void)quality->verdict;
    ANY(*record);
}

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

invcal_status invcal_compose(const invcal_calibration *nominal, invcal_calibration *c)
{
    (void)nominal->matrix[2][2];
    (void)c->matrix[2][2];
    ANY(*c);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

/* For any X. */
invcal_status invcal_triad(const invcal_real x[INVCAL_PARAMETERS], invcal_calibration *triad)
{
    (void)x[INVCAL_PARAMETERS - 1];
    ANY(*triad);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_NOT_ELLIPSOID;
}

invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

/* ---- the record ------------------------------------------------------------------------------- */

static void encode(unsigned least, unsigned most)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal_record record;

    ANY(record);
    record.thermal.degree = (uint8_t)BETWEEN(least, most);
    (void)invcal_thermal_record_encode(&record, bytes);
}

static void init(void)
{
    invcal_thermal thermal;
    invcal_quality quality;
    invcal_thermal_record record;

    ANY(thermal);
    ANY(quality);
    (void)invcal_thermal_record_init(&record, &thermal, &quality);
}

void main(void)
{
    decode_any((version){invcal_thermal_record_decode, 0});
    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        encode(degree, degree);
    }
    encode(INVCAL_THERMAL_DEGREE + 1, 255);
    init();
}
