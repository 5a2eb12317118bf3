/* SPDX-License-Identifier: MIT
 *
 * Internal: cosine and sine. Those of libc take 4 KB, for angles never needed.
 */
#ifndef INVCAL_CIRCLE_H
#define INVCAL_CIRCLE_H

#include "invcal/invcal.h"
#include "names.h"

/* Of -720 ... 720 degrees, to 1.2e-7 (float) and 2.2e-16 (double); 0 and 1 are exact. */
void invcali_circle(invcal_real degrees, invcal_real *cosine, invcal_real *sine);

#endif
