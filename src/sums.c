/* SPDX-License-Identifier: MIT
 *
 * The paper's H'H and H'J, one exact row at a time (mathematics.md, "The exact row", "Normal
 * equations"). Elements are products of at most four of x, y, z, so 14 of the 45 repeat others:
 * they are filled in only when the system is solved.
 */
#include "sums.h"

#include <limits.h>
#include <stddef.h>

#include "invcal/expert.h"
#include "vector.h"

void invcal_products(const invcal_real eta[3], invcal_real g[INVCAL_PARAMETERS])
{
    invcal_products_inline(eta, g);
}

void invcal_rank_one(invcal_real *a, const invcal_real *v, unsigned n, invcal_real weight)
{
#ifdef INVCAL_FAST
    if (n == INVCAL_PARAMETERS + 1) {
        invcal_rank_one_inline(a, v, INVCAL_PARAMETERS + 1, weight);
        return;
    }
#endif
    invcal_rank_one_inline(a, v, n, weight);
}

/* Elements of H'H are products of two, three or four of x, y, z; 31 of 45 are distinct: each in the
 * first column repeats the earlier one in the second. */
enum { REPEATED = 14 };
/* cppcheck-suppress misra-c2012-8.9 ; where speed is asked for, two functions use it */
static const uint8_t again[REPEATED][2] = {
    {21, 7},  {22, 10}, {27, 13},                                         /* xy */
    {28, 8},  {29, 23}, {30, 15}, {35, 18},                               /* xz */
    {36, 23}, {37, 12}, {38, 16}, {39, 34}, {42, 32}, {43, 26}, {44, 19}, /* yz */
};

#ifdef INVCAL_FAST
static INVCAL_INLINE int is_repeated(unsigned i)
{
    INVCAL_UNROLL
    for (unsigned k = 0; k < REPEATED; k++) {
        if (again[k][0] == i) {
            return 1;
        }
    }
    return 0;
}
#endif

/* H'H += w h h', H'J += w h J, J'J += w J J. If optimised for speed, nothing is summed twice. */
static INVCAL_INLINE void add(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
#ifdef INVCAL_FAST
    unsigned i = 0;

    INVCAL_UNROLL_ROWS
    for (unsigned r = 0; r < INVCAL_PARAMETERS + 1; r++) {
        const invcal_real weighted = weight * row->h[r];
        INVCAL_UNROLL_ROWS
        for (unsigned c = 0; c <= r; c++) {
            if (!is_repeated(i)) {
                sums->sum[i] += weighted * row->h[c];
            }
            i++;
        }
    }
#else
    invcal_rank_one(sums->sum, row->h, INVCAL_PARAMETERS + 1, weight);
#endif
    sums->count += sums->count < UINT_MAX; /* 0 would mean empty */
}

void invcal_sums_init(invcal_sums *sums)
{
    INVCAL_ASSERT(sums);
    invcal_zero(sums, sizeof *sums);
}

invcal_status invcal_observe(const invcal_calibration *nominal, const invcal_real raw[3],
                             invcal_row *row)
{
    INVCAL_ASSERT(nominal && raw && row);
    return invcal_observe_inline(nominal, raw, row);
}

void invcal_sums_add_row(invcal_sums *sums, const invcal_row *row, invcal_real weight)
{
    INVCAL_ASSERT(sums && row);
    add(sums, row, weight);
}

invcal_status invcal_sums_add(invcal_sums *sums, const invcal_calibration *nominal,
                              const invcal_real raw[3])
{
    invcal_row row;

    INVCAL_ASSERT(sums && nominal && raw);
    const invcal_status status = invcal_observe_often(nominal, raw, &row);
    if (status == INVCAL_OK) {
        add(sums, &row, 1);
    }
    return status;
}

/* Only H'H has repeats; H'J and J'J come after it. */
void invcal_sums_system(invcal_sums *sums)
{
    INVCAL_UNROLL
    for (unsigned i = 0; i < REPEATED; i++) {
        sums->sum[again[i][0]] = sums->sum[again[i][1]];
    }
}
