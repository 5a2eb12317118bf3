/* SPDX-License-Identifier: MIT */
#include "any_thermal_record.h"
#include "bytes.h"
#include "thermal_record.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 128 -eva-slevel 200 -eva-slevel-merge-after-loop @all -eva-slevel-function invcal_crc32:0 -eva-split-return full
// stubs: record_v1 thermal_record
// config: -DINVCAL_THERMAL_DEGREE=0
// config: -DINVCAL_THERMAL_DEGREE=2

enum { LONGER = INVCAL_RECORD_SIZE_V1 - INVCAL_RECORD_SIZE };

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_record_decode_v1(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    (void)bytes[size - 1];
    ANY(*out);
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

void invcal_over_field(invcal_real *matrix, invcal_real field)
{
    (void)field;
    Frama_C_make_unknown((char *)matrix, 9 * sizeof *matrix);
}

invcal_status invcal_thermal_check_length(const uint8_t *bytes, unsigned at)
{
    const unsigned length = bytes[2] | (unsigned)bytes[3] << 8;

    for (unsigned degree = 0; degree <= INVCAL_THERMAL_DEGREE; degree++) {
        if (length > at && bytes[at] == degree &&
            length == INVCAL_THERMAL_RECORD_BYTES(degree) + LONGER) {
            return INVCAL_OK;
        }
    }
    return INVCAL_DAMAGED;
}

invcal_status invcal_thermal_read(const uint8_t *behind, invcal_thermal_record *r)
{
    (void)behind[3 + 4 * (16 + INVCAL_PARAMETERS * (behind[0] + 1u))];
    ANY(r->thermal);
    r->is_triangular = behind[3];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_NOT_FINITE;
}

invcal_status invcal_thermal_check(const invcal_thermal_record *r)
{
    (void)r->is_triangular;
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_DAMAGED;
}

void main(void)
{
    decode_any((version){invcal_thermal_record_decode_v1, LONGER});
}
