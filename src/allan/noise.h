/* SPDX-License-Identifier: MIT
 *
 * Internal: what the host tool needs of allan.h besides. Members of invcal_private_tau:
 *
 *     past       totals, a ring
 *     low, high  of the squares of all differences; all bits 1: overflow
 *     m          samples
 *     count      differences in the sum
 */
#ifndef INVCAL_NOISE_H
#define INVCAL_NOISE_H

#include "invcal/allan.h"
#include "../core/names.h"

#define INVCAL_ALLAN_LONGEST (UINT32_C(1) << 30) /* samples: differences then fit 63 bits */

/* adev(tau) of the model, counts; tau in s, above 0: else it means nothing. */
invcal_real invcali_noise_sigma(const invcal_noise *noise, invcal_real tau);

#endif
