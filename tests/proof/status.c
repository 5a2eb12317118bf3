/* SPDX-License-Identifier: MIT */
#include "invcal/result.h"
#include "core/texts.h"

#include "arbitrary.h"

// eva: -eva-precision 0 -eva-slevel 2000
void main(void)
{
    for (unsigned n = 0; n <= INVCAL_STATUS_END; n++) {
        (void)invcal_status_text((invcal_status)n);
        (void)invcali_refusal_text((invcal_status)n);
        (void)invcal_parameter_text(n);
        (void)invcal_verdict_text((invcal_verdict)n);
        (void)invcal_systematic_text((invcal_systematic)n);
    }
    (void)invcal_status_text((invcal_status)BETWEEN(INVCAL_STATUS_END, 0xFFFFFFFF));
    (void)invcali_refusal_text((invcal_status)BETWEEN(INVCAL_STATUS_END, 0xFFFFFFFF));
    (void)invcal_parameter_text(BETWEEN(INVCAL_STATUS_END, 0xFFFFFFFF));
    (void)invcal_verdict_text((invcal_verdict)BETWEEN(INVCAL_STATUS_END, 0xFFFFFFFF));
    (void)invcal_systematic_text((invcal_systematic)BETWEEN(INVCAL_STATUS_END, 0xFFFFFFFF));
}
