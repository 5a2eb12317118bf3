/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/status.h"

// eva: -eva-precision 0 -eva-slevel 1000
void main(void)
{
    for (unsigned n = 0; n <= INVCAL_STATUS_COUNT; n++) {
        invcal_status_text((invcal_status)n);
        invcal_parameter_name(n);
    }
    invcal_status_text((invcal_status)BETWEEN(INVCAL_STATUS_COUNT, 0xFFFFFFFF));
    invcal_parameter_name(BETWEEN(INVCAL_STATUS_COUNT, 0xFFFFFFFF));
}
