/* SPDX-License-Identifier: MIT */
#include "report.h"

#include <math.h>

#include "invcal/result.h"
#include "print.h"

void report(const char *what, const char *text)
{
    print(what);
    print(": ");
    print(text);
    print("\n");
}

void report_count(const char *what, unsigned count)
{
    print(what);
    print(": ");
    print_integer((int32_t)count);
    print("\n");
}

void report_next(const invcal_session *session)
{
    char text[INVCAL_TEXT_SIZE];

    report("next", invcal_session_next_text(session, text));
}

void report_event(const invcal_session *session, invcal_event event)
{
    const unsigned progress = invcal_session_progress(session);

    switch (event) {
    case INVCAL_SETTLING:
        if (progress > 0 && progress < 100) {
            report_count("hold still, percent", progress);
        }
        break;
    case INVCAL_READY:
        print("good: move on\n");
        break;
    case INVCAL_REFUSED:
        report("refused", invcal_session_reason_text(session));
        break;
    case INVCAL_TAKEN:
        report_count("position taken", session->count);
        break;
    default:
        break; /* moving */
    }
}

static void report_vector(const char *name, const invcal_real v[3], unsigned digits)
{
    print(name);
    for (unsigned i = 0; i < 3; i++) {
        print(" ");
        print_fixed(v[i], digits);
    }
    print("\n");
}

void report_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal,
                        const invcal_quality *quality)
{
    invcal_real sigma[3];
    invcal_real x[INVCAL_PARAMETERS];

    invcal_sigma_offset(quality, nominal, sigma);
    invcal_deviation(calibration, nominal, x);
    report("verdict", invcal_verdict_text(quality->verdict));
    for (unsigned k = INVCAL_DRIFT; k <= INVCAL_HYSTERESIS; k++) {
        if (quality->unchecked >> k & 1u) {
            report("not checked for", invcal_systematic_text((invcal_systematic)k));
        }
    }
    report_vector("offset, counts:     ", calibration->offset, 2);
    report_vector("sigma:              ", sigma, 2);
    for (unsigned i = 0; i < 3; i++) {
        invcal_real row[3];
        for (unsigned k = 0; k < 3; k++) {
            row[k] = 1e6f * calibration->matrix[i][k];
        }
        report_vector("matrix, ug per count:", row, 3);
    }
    report_vector("scale errors:       ", &x[INVCAL_DK_X], 5);
    report_vector("sigma:              ", &quality->sigma[INVCAL_DK_X], 5);
    report_vector("cross terms, rad:   ", &x[INVCAL_GAMMA_XY], 5);
    report_vector("sigma:              ", &quality->sigma[INVCAL_GAMMA_XY], 5);
}

void report_reading(const invcal_real a[3])
{
    print("a, g:");
    for (unsigned i = 0; i < 3; i++) {
        print(" ");
        print_fixed(a[i], 4);
    }
    print("; length ");
    print_fixed(sqrtf(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]), 4);
    print("\n");
}
