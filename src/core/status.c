/* SPDX-License-Identifier: MIT
 *
 * Texts of statuses, parameters, verdicts and systematic errors. Each list is in the order of its
 * enumeration. Why a session refuses a sample is a list of its own, which it links without the
 * others.
 */
#include <limits.h>

#include "bytes.h"
#include "invcal/gyro.h"
#include "invcal/result.h"
#include "texts.h"

const char *invcali_text(const char *texts, unsigned n, unsigned count)
{
    n = n < count ? n : count;
    while (n > 0) { /* at most as many steps as there are characters */
        n -= *texts++ == '\0';
    }
    return texts;
}

enum { REFUSALS = INVCAL_BAD_RATE - INVCAL_OUT_OF_RANGE + 1 };

const char *invcali_refusal_text(invcal_status status)
{
    static const char texts[] = "far from the field: wrong scale or offset\0"
                                "too short: hold still longer\0"
                                "drifts: turning or settling\0"
                                "at the end of the range\0"
                                "readings never change: sensor not read?\0"
                                "too short: samples lost\0"
                                "nothing new: same place\0"
                                "not begun\0"
                                "other build\0"
                                "invalid scale\0"
                                "invalid rate\0";

    return invcali_text(texts, (unsigned)status - INVCAL_OUT_OF_RANGE, REFUSALS);
}

const char *invcal_status_text(invcal_status status)
{
    static const struct {
        uint8_t first, last;
    } groups[] = {{INVCAL_OK, INVCAL_OK},
                  {INVCAL_NOT_FINITE, INVCAL_MOUNTING},
                  {INVCAL_MOVE_GAP, INVCAL_MOVE_APART},
                  {INVCAL_BAD_LIMITS, INVCAL_BAD_STORE},
                  {INVCAL_NO_RECORD, INVCAL_IO}};
    static const char texts[] = "done\0"
                                "a reading is not a finite number\0"
                                "too few positions\0"
                                "the positions leave parameters undetermined\0"
                                "the readings do not lie on an ellipsoid\0"
                                "gyroscope and accelerometer differ: axes, signs or unit\0"
                                "samples were lost in the move\0"
                                "the move took more than 10 s\0"
                                "the move contradicts the others\0"
                                "low is not below high\0"
                                "the noise is out of range\0"
                                "the prior is invalid\0"
                                "the field is not a length\0"
                                "the count is out of range\0"
                                "the direction is not a unit vector\0"
                                "the angle is out of range\0"
                                "the temperature is invalid\0"
                                "the time is out of range\0"
                                "the memory's slot or granularity is invalid\0"
                                "nothing is stored\0"
                                "the stored bytes are damaged\0"
                                "stored in an unknown format\0"
                                "stored with other settings\0"
                                "not enough space\0"
                                "the memory cannot be read or written\0"
                                "unknown status";
    const unsigned n = (unsigned)status;
    unsigned before = 0;

    if (n - INVCAL_OUT_OF_RANGE < REFUSALS) {
        return invcali_refusal_text(status);
    }
    for (unsigned i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        if (n >= groups[i].first && n <= groups[i].last) {
            return invcali_text(texts, before + n - groups[i].first, UINT_MAX);
        }
        before += groups[i].last - (unsigned)groups[i].first + 1;
    }
    return invcali_text(texts, before, before);
}

const char *invcal_parameter_text(unsigned parameter)
{
    static const char names[] = "delta_x\0delta_y\0delta_z\0"
                                "dk_x\0dk_y\0dk_z\0"
                                "gamma_xy\0gamma_xz\0gamma_zy\0"
                                "gyro_xx\0gyro_xy\0gyro_xz\0"
                                "gyro_yx\0gyro_yy\0gyro_yz\0"
                                "gyro_zx\0gyro_zy\0gyro_zz\0"
                                "?";

    return invcali_text(names, parameter, INVCAL_IMU_PARAMETERS);
}

const char *invcal_verdict_text(invcal_verdict verdict)
{
    static const char names[] = "good\0no redundancy\0rough\0drifting\0bent\0weak\0"
                                "unknown verdict";

    return invcali_text(names, invcali_swap(verdict), invcali_swap(INVCAL_WEAK) + 1u);
}

const char *invcal_systematic_text(invcal_systematic systematic)
{
    static const char names[] = "\0"
                                "drift\0"
                                "nonlinearity x^2\0"
                                "nonlinearity x^3\0"
                                "hysteresis\0"
                                "unknown error";

    return invcali_text(names, systematic, INVCAL_HYSTERESIS + 1u);
}
