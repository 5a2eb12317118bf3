/* SPDX-License-Identifier: MIT
 *
 * The packages' test program, as C and as C++: six faces and twelve edges of a cube, read by a sensor of
 * 16384 counts per g whose x axis reads 1 % too much and whose z axis is 300 counts off. Encodes the
 * calibration as bytes, decodes it, and applies it. Prints what expected.txt says.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "invcal/allan.h"
#include "invcal/expert.h"
#include "invcal/invcal.h"
#include "invcal/plan.h"
#include "invcal/result.h"
#include "invcal/store.h"
#include "invcal/thermal.h"

static unsigned measure(invcal_vector mean[18])
{
    unsigned n = 0;

    for (int i = 0; i < 27; i++) {
        const int side[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        const int square = side[0] * side[0] + side[1] * side[1] + side[2] * side[2];
        if (square == 1 || square == 2) {
            const invcal_real counts = 16384 / (invcal_real)sqrt((double)square);
            mean[n].v[0] = counts * (invcal_real)side[0] * INVCAL_REAL(1.01);
            mean[n].v[1] = counts * (invcal_real)side[1];
            mean[n].v[2] = counts * (invcal_real)side[2] + 300;
            n++;
        }
    }
    return n;
}

int main(void)
{
    const invcal_real zero[3] = {0, 0, 0};
    const invcal_real counts[3] = {16384, 16384, 16384};
    invcal_vector mean[18];
    invcal_real x[INVCAL_PARAMETERS];
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_calibration nominal, calibration;
    invcal_positions positions;
    invcal_quality quality;
    invcal_record record;

    invcal_status status = invcal_nominal(zero, counts, &nominal);
    memset(&positions, 0, sizeof positions);
    positions.mean = mean;
    positions.count = measure(mean);
    positions.nominal = &nominal;
    if (status == INVCAL_OK) {
        status = invcal_calibrate_plain(&positions, &calibration, &quality);
    }
    if (status == INVCAL_OK) {
        invcal_record_init(&record, &calibration, &quality);
        status = invcal_record_encode(&record, bytes);
    }
    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes, sizeof bytes, &record);
    }
    if (status != INVCAL_OK) {
        printf("%s\n", invcal_status_text(status));
        return 1;
    }
    invcal_deviation(&record.calibration, &nominal, x);
    printf("%u positions, %s\n", positions.count, invcal_verdict_text(quality.verdict));
    printf("scale error of x %.4f, offset of z %.1f\n", (double)x[INVCAL_DK_X],
           (double)record.calibration.offset[2]);
    invcal_real *const v = mean[0].v;
    invcal_apply(&record.calibration, v[0], v[1], v[2], v);
    printf("length %.3f\n", sqrt((double)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])));
    return 0;
}
