/* SPDX-License-Identifier: MIT
 *
 * The paper's H'H and H'J, one exact row at a time (mathematics.md, "The exact row", "Normal
 * equations").
 */
#include "sums.h"

#include <limits.h>
#include <stddef.h>

#include "vector.h"

void invcali_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS])
{
    INVCAL_ROLL
    for (unsigned i = 0; i < 3; i++) {
        const unsigned r = i / 2; /* xy, xz, yz */
        const unsigned c = (i + 3) / 2;
        g[INVCAL_DK_X + i] = g[i] * eta[i];
        g[INVCAL_GAMMA_XY + i] = (g[r] * eta[c] + g[c] * eta[r]) / 2;
    }
}

#if !INVCAL_FAST
INVCAL_NOINLINE void invcali_row_of(invcal_real h[INVCAL_PARAMETERS])
{
#ifdef __AVR__
    invcali_products(h, h); /* both factors the same: two equal halves, in less flash */
#else
    invcali_row_inline(h);
#endif
}

INVCAL_NOINLINE invcal_status invcali_read(const invcal_calibration *nominal,
                                           const invcal_real raw[3],
                                           invcal_real h[INVCAL_PARAMETERS + 1])
{
    return invcali_read_inline(nominal, raw, h);
}
#endif

#if INVCAL_FAST || !INVCAL_HAS_FPU
static INVCAL_ONCE void rank_one(invcal_real *restrict a, const invcal_real *restrict v, unsigned n,
                                 invcal_real weight)
{
    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < n; r++) {
        const invcal_real weighted = weight * v[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c <= r; c++) {
            *a++ += weighted * v[c];
        }
    }
}
#else
/* By pairs of rows, which share the elements of v. */
static INVCAL_ONCE void rank_one(invcal_real *restrict a, const invcal_real *restrict v, unsigned n,
                                 invcal_real weight)
{
    unsigned r = n % 2;

    if (r > 0) {
        *a++ += weight * v[0] * v[0];
    }
    for (; r < n; r += 2) {
        invcal_real *restrict below = a + r + 1;
        const invcal_real first = weight * v[r];
        const invcal_real second = weight * v[r + 1];
        INVCAL_ROLL
        for (unsigned c = 0; c <= r; c++) {
            *a++ += first * v[c];
            *below++ += second * v[c];
        }
        *below++ += second * v[r + 1];
        a = below;
    }
}
#endif

INVCAL_NOINLINE void invcali_rank_one(invcal_real *a, const invcal_real *v, unsigned n,
                                      invcal_real weight)
{
#if INVCAL_FAST
    if (n == INVCAL_PARAMETERS + 1) {
        rank_one(a, v, INVCAL_PARAMETERS + 1, weight);
        return;
    }
#endif
    rank_one(a, v, n, weight);
}

void invcal_sums_init(invcal_sums *sums)
{
    INVCAL_ASSERT(sums);
    invcali_zero_array(sums->sum, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS + 1));
    sums->count = 0;
}

invcal_status invcali_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                              invcali_row *row)
{
    INVCAL_ASSERT(nominal && raw && row);
    return invcali_read(nominal, raw, row->h);
}

static INVCAL_ONCE void add_weighted(invcal_sums *sums, const invcali_row *row, invcal_real weight)
{
    invcali_rank_one(sums->sum, row->h, INVCAL_PARAMETERS + 1, weight);
    sums->count += sums->count < UINT_MAX; /* 0 would mean empty */
}

void invcali_sums_add_row(invcal_sums *sums, const invcali_row *row, invcal_real weight)
{
    INVCAL_ASSERT(sums && row);
    add_weighted(sums, row, weight);
}

invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real mean[3], invcal_real weight)
{
    invcali_row row;

    INVCAL_ASSERT(sums && nominal && mean);
    if (!invcali_is_positive(weight)) {
        return INVCAL_BAD_NOISE;
    }
    const invcal_status status = invcali_read(nominal, mean, row.h);
    if (status == INVCAL_OK) {
        add_weighted(sums, &row, weight);
    }
    return status;
}
