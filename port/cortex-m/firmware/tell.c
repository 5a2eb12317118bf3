/* SPDX-License-Identifier: MIT */
#include "tell.h"

#include <math.h>

#include "print.h"

void tell(const char *what, const char *text)
{
    print(what);
    print(": ");
    print(text);
    print("\n");
}

void tell_count(const char *what, unsigned count)
{
    print(what);
    print(": ");
    print_integer((int32_t)count);
    print("\n");
}

void tell_next(const invcal_session *session)
{
    invcal_guidance next;
    char words[INVCAL_GUIDANCE_WORDS];
    const invcal_status status = invcal_session_next(session, &next);

    if (status == INVCAL_OK) {
        invcal_guidance_words(next.up, words);
    }
    tell("next", status == INVCAL_OK ? words : invcal_status_text(status));
}

void tell_event(const invcal_event *event)
{
    switch (event->what) {
    case INVCAL_SESSION_SETTLING:
        if (event->progress > 0 && event->progress < 100) {
            tell_count("hold still, percent", event->progress);
        }
        break;
    case INVCAL_SESSION_READY:
        print("good: move on\n");
        break;
    case INVCAL_SESSION_REFUSED:
        tell("refused", event->reason != INVCAL_REST_GOOD ? invcal_rest_reason_text(event->reason)
                                                          : invcal_status_text(event->status));
        break;
    case INVCAL_SESSION_TAKEN:
    case INVCAL_SESSION_ENOUGH:
        tell_count(event->what == INVCAL_SESSION_ENOUGH ? "enough, position taken"
                                                        : "position taken",
                   event->positions);
        break;
    default:
        break; /* moving */
    }
}

static void tell_vector(const char *name, const invcal_real v[3], unsigned digits)
{
    print(name);
    for (unsigned i = 0; i < 3; i++) {
        print(" ");
        print_fixed(v[i], digits);
    }
    print("\n");
}

void tell_calibration(const invcal_solution *solution, const invcal_quality *quality)
{
    tell("verdict", invcal_verdict_text(quality->verdict));
    tell_vector("offset, counts:     ", solution->calibration.offset, 2);
    tell_vector("sigma:              ", quality->sigma_offset, 2);
    for (unsigned i = 0; i < 3; i++) {
        invcal_real row[3];
        for (unsigned k = 0; k < 3; k++) {
            row[k] = 1e6f * solution->calibration.matrix[i][k];
        }
        tell_vector("matrix, ug per count:", row, 3);
    }
    tell_vector("scale errors:       ", solution->dk, 5);
    tell_vector("sigma:              ", quality->sigma_dk, 5);
    tell_vector("cross terms, rad:   ", solution->gamma, 5);
    tell_vector("sigma:              ", quality->sigma_gamma, 5);
}

void tell_reading(const invcal_real a[3])
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
