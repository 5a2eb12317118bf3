/* SPDX-License-Identifier: MIT */
#include "fit/nominal.h"

#include <float.h>

int nominal_from_range(const positions *p, double field, double zero[3], double lsb[3])
{
    double half[3]; /* of the range; halves do not overflow */
    double widest = 0;

    for (unsigned i = 0; i < 3; i++) {
        double low = p->mean[i];
        double high = low;
        for (unsigned n = 1; n < p->count; n++) {
            const double x = p->mean[3 * n + i];
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        zero[i] = low / 2 + high / 2;
        half[i] = high / 2 - low / 2;
        widest = half[i] > widest ? half[i] : widest;
    }
    for (unsigned i = 0; i < 3 && widest > 0; i++) {
        lsb[i] = field / (half[i] < widest / 2 ? widest : half[i]);
        widest = lsb[i] > 0 && lsb[i] <= DBL_MAX ? widest : 0;
    }
    return widest > 0;
}

int nominal_make(const double zero[3], const double lsb[3], double field, invcal_calibration *out)
{
    double counts[3];
    invcal_calibration over_field;

    for (unsigned i = 0; i < 3; i++) {
        counts[i] = field / lsb[i];
    }
    if (invcal_nominal(zero, counts, &over_field) != INVCAL_OK) {
        return 0;
    }
    *out = (invcal_calibration){.offset = {zero[0], zero[1], zero[2]}};
    for (unsigned i = 0; i < 3; i++) {
        out->matrix[i][i] = lsb[i];
    }
    return 1;
}

int nominal_is_guess(const nominal_choice *n)
{
    return n->zero == NOMINAL_RANGE || n->lsb == NOMINAL_RANGE;
}

int nominal_is_stated(const nominal_choice *n)
{
    return n->zero != NOMINAL_RANGE || n->lsb != NOMINAL_RANGE;
}

int nominal_knows(const nominal_choice *n, unsigned parameter)
{
    return parameter >= INVCAL_GAMMA_XY ||
           (parameter >= INVCAL_DK_X ? n->lsb : n->zero) != NOMINAL_RANGE;
}

const char *nominal_origin_text(nominal_origin origin)
{
    static const char *const texts[] = {"given", "not stated", "from an earlier calibration",
                                        "from the unit", "from the data sheet"};

    return texts[origin];
}

const char *nominal_origin_name(nominal_origin origin)
{
    static const char *const names[] = {"given", "range", "earlier", "unit", "sensor"};

    return names[origin];
}
