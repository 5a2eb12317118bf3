/* SPDX-License-Identifier: MIT */
#include "any_record.h"
#include "solve.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 40 -eva-slevel 20 -eva-slevel-function read_all:400,invcal_crc32:0 -eva-split-return full
// stubs: store record nominal

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcal_record_decode(const uint8_t *bytes, uint32_t size, invcal_record *out)
{
    (void)bytes[size - 1];
    if (BETWEEN(0, 1)) {
        ANY(*out);
        return INVCAL_OK;
    }
    return INVCAL_DAMAGED;
}

invcal_status invcal_nominal_check(const invcal_calibration *nominal)
{
    (void)nominal->matrix[2][2];
    return BETWEEN(0, 1) ? INVCAL_OK : INVCAL_BAD_NOMINAL;
}

void main(void)
{
    read_all(invcal_record_decode_v1, invcal_load_v1, INVCAL_RECORD_SIZE_V1);
}
