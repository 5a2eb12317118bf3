/* SPDX-License-Identifier: MIT
 *
 * Texts of statuses, parameters and verdicts. Each list is in the order of its enumeration in
 * invcal.h; the statuses of refused rests, from the middle of theirs, are a list of their own,
 * which a session links without the others.
 */
#include "status.h"

const char *invcal_text(const char *texts, unsigned n)
{
    while (n > 0) { /* at most as many steps as there are characters */
        n -= *texts++ == '\0';
    }
    return texts;
}

const char *invcal_refusal_text(invcal_status status)
{
    static const char texts[] = "far from the field: wrong scale or offset\0"
                                "too short: hold it still longer\0"
                                "it drifts: turned slowly, or not settled\0"
                                "at the end of the sensor's range\0"
                                "readings never change: is the sensor read?\0"
                                "too short: samples were lost\0"
                                "nothing new: the same place as before\0";
    enum { REFUSALS = INVCAL_REST_SAME - INVCAL_OUT_OF_RANGE + 1 };
    const unsigned n = (unsigned)status - INVCAL_OUT_OF_RANGE;

    return invcal_text(texts, status == INVCAL_OK ? REFUSALS : n < REFUSALS ? n : 0);
}

const char *invcal_status_text(invcal_status status)
{
    enum { REFUSALS = INVCAL_REST_SAME - INVCAL_OUT_OF_RANGE + 1 };
    static const char texts[] = "done\0"
                                "a reading is not a finite number\0"
                                "too few positions\0"
                                "the positions leave parameters undetermined\0"
                                "the readings do not lie on an ellipsoid\0"
                                "the nominal calibration is invalid\0"
                                "the sample rate is out of range\0"
                                "low is not below high\0"
                                "the noise is out of range\0"
                                "the prior is invalid\0"
                                "the field is not a length\0"
                                "the count is out of range\0"
                                "the direction is not a unit vector\0"
                                "the program has no such position\0"
                                "the temperature is invalid\0"
                                "the averaging times are invalid\0"
                                "the memory's slot or granularity is invalid\0"
                                "nothing is stored\0"
                                "the stored bytes are damaged\0"
                                "stored in an unknown format\0"
                                "not enough space\0"
                                "the memory cannot be read or written\0"
                                "samples were lost in the move\0"
                                "the move took more than 10 s\0"
                                "the move contradicts the others\0"
                                "gyroscope and accelerometer differ: axes, signs or unit\0"
                                "unknown status";
    const unsigned n = (unsigned)status;

    if (n >= INVCAL_OUT_OF_RANGE && n <= INVCAL_REST_SAME) {
        return invcal_refusal_text(status);
    }
    return invcal_text(texts, n < INVCAL_OUT_OF_RANGE   ? n
                              : n < INVCAL_STATUS_COUNT ? n - REFUSALS
                                                        : INVCAL_STATUS_COUNT - REFUSALS);
}

const char *invcal_parameter_name(unsigned parameter)
{
    static const char names[] = "delta_x\0delta_y\0delta_z\0"
                                "dk_x\0dk_y\0dk_z\0"
                                "gamma_xy\0gamma_xz\0gamma_zy\0"
                                "?";

    return invcal_text(names, parameter < INVCAL_PARAMETERS ? parameter : INVCAL_PARAMETERS);
}

const char *invcal_verdict_text(invcal_verdict verdict)
{
    static const char names[] = "good\0no redundancy\0rough\0drifting\0bent\0weak\0"
                                "unknown verdict";
    const unsigned n = (unsigned)verdict;

    return invcal_text(names, n <= INVCAL_WEAK ? n : INVCAL_WEAK + 1u);
}
