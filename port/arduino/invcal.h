/* SPDX-License-Identifier: MIT
 *
 * invcal.h: for sketches, which find libraries by a header in src/ itself.
 */
#include "invcal/store.h"
