/* SPDX-License-Identifier: MIT
 *
 * Overlapping Allan deviation of one axis, sample by sample (NIST SP 1065, 5.2.4). The second
 * difference of running totals, x(i) - 2 x(i - m) + x(i - 2m), is m times the step from one mean of
 * m samples to the next, so no window is ever summed. Totals wrap modulo 2^64, which does no harm:
 * the difference is exact as long as it fits 63 bits.
 *
 * Each averaging time has its own ring of totals, one at every 2^t-th sample: its size does not
 * depend on m. Squares of 63 bits need a sum of 128, kept in two halves, since C99 has no such
 * type.
 */
#include "invcal/allan.h"

#include "noise.h"
#include "../core/vector.h"

#define RING (2u * INVCAL_PRIVATE_OVERLAP) /* a power of two */
#define TWO_32 INVCAL_REAL(4294967296.0)

/* ---- sums of 128 bits ------------------------------------------------------------------------ */

/* Adds size^2, at most 2^126. On overflow all bits are set, and stay set. */
static void add_square(invcal_private_tau *sum, uint64_t size)
{
    const uint64_t a = size >> 32;
    const uint64_t b = size & UINT32_MAX;
    uint64_t low = b * b;
    uint64_t high = 0;

    if (a > 0) {
        const uint64_t middle = a * b; /* counts twice, 2^33 of it */
        high = a * a + (middle >> 31);
        low += middle << 33;
        high += low < middle << 33;
    }
    sum->low += low;
    high += sum->low < low;
    sum->high += high;
    if (sum->high < high) {
        sum->low = UINT64_MAX;
        sum->high = UINT64_MAX;
    }
}

static int has_overflowed(const invcal_private_tau *sum)
{
    return (sum->low & sum->high) == UINT64_MAX;
}

/* In halves: libgcc converts 64 bits by way of double, even if only float is in hardware. */
static invcal_real to_real(uint64_t x)
{
    return TWO_32 * (invcal_real)(uint32_t)(x >> 32) + (invcal_real)(uint32_t)x;
}

/* sqrt(sum / (2 count)), from the sum over 2^64, since 2^128 exceeds float. */
static invcal_real root_mean(const invcal_private_tau *sum)
{
    const invcal_real total = to_real(sum->high) + to_real(sum->low) / TWO_32 / TWO_32;

    return TWO_32 * INVCAL_SQRT(total / (2 * (invcal_real)sum->count));
}

/* ---- averaging times ------------------------------------------------------------------------- */

/* t of an averaging time: the smallest, from `t` on, whose ring reaches back 2 m. */
static unsigned stride_bits(uint32_t m, unsigned t)
{
    while (m > (uint32_t)INVCAL_PRIVATE_OVERLAP << t) { /* at most 30 steps: m is 2^30 or less */
        //@ assert t < 30;
        t++;
    }
    return t;
}

/* Windows begin only at multiples of the stride 2^t, so m must be one. */
static int is_usable(uint32_t m)
{
    return m >= 1 && m <= INVCAL_ALLAN_LONGEST && m >> stride_bits(m, 0) << stride_bits(m, 0) == m;
}

invcal_status invcal_allan_init(invcal_allan *allan, size_t size)
{
    INVCAL_ASSERT(allan);
    allan->taus = 0; /* not begun */
    if (size != sizeof *allan) {
        return INVCAL_OTHER_BUILD;
    }
    invcali_zero(allan, sizeof *allan);
    for (; allan->taus < INVCAL_ALLAN_TAUS; allan->taus++) {
        allan->own[allan->taus].m = UINT32_C(1) << allan->taus;
    }
    return INVCAL_OK;
}

invcal_status invcal_allan_init_taus(invcal_allan *allan, size_t size, const uint32_t *m,
                                     unsigned count, int is_apart)
{
    INVCAL_ASSERT(allan && m);
    allan->taus = 0; /* not begun */
    if (size != sizeof *allan) {
        return INVCAL_OTHER_BUILD;
    }
    if (count < 1 || count > INVCAL_ALLAN_TAUS) {
        return INVCAL_BAD_TIME;
    }
    for (unsigned k = 0; k < count; k++) {
        if (!is_usable(m[k]) || (k > 0 && m[k] <= m[k - 1])) {
            return INVCAL_BAD_TIME;
        }
    }
    invcali_zero(allan, sizeof *allan);
    allan->taus = (uint8_t)count;
    allan->own_apart = is_apart != 0;
    for (unsigned k = 0; k < count; k++) {
        allan->own[k].m = m[k];
    }
    return INVCAL_OK;
}

/* The difference that ends at a total, number `at` of its ring. */
static void add_difference(invcal_private_tau *tau, uint64_t total, uint32_t lag, uint32_t at)
{
    const uint64_t middle = tau->past[(at - lag) % RING];
    const uint64_t d = (total - middle) - (middle - tau->past[(at - 2 * lag) % RING]);

    add_square(tau, d >> 63 ? 0 - d : d); /* modulo 2^64, as the totals */
    tau->count++;
}

void invcal_allan_feed(invcal_allan *allan, int32_t raw)
{
    INVCAL_ASSERT(allan);
    invcal_private_tau *tau = allan->own;
    unsigned t = 0;

    const uint64_t total = allan->own_total + (uint64_t)(int64_t)raw;
    const uint32_t samples = allan->samples + 1;
    allan->own_total = total;
    allan->samples = samples;
    for (unsigned k = 0; k < allan->taus; k++) {
        //@ assert \valid(tau); // number k
        t = stride_bits(tau->m, t);
        const uint32_t lag = tau->m >> t;
        //@ assert lag > 0; // t is as small as can be
        const uint32_t at = samples >> t;
        if (at << t != samples) {
            break; /* longer strides do not end here either */
        }
        if (at >= 2 * lag && tau->count < UINT32_MAX && (!allan->own_apart || at % lag == 0)) {
            add_difference(tau, total, lag, at);
        }
        tau->past[at % RING] = total;
        tau++;
    }
}

/* Counts samples from 0 again. Only the total at 0 is entered: the first difference ends 2 lag
 * totals later, and all those after it reach back to new totals. */
void invcal_allan_gap(invcal_allan *allan)
{
    INVCAL_ASSERT(allan);
    allan->samples = 0;
    for (unsigned k = 0; k < allan->taus; k++) {
        allan->own[k].past[0] = allan->own_total;
    }
}

/* ---- the result ------------------------------------------------------------------------------ */

/* edf of white noise by NIST SP 1065, table 5, as in allan.h, with lag as m'. Without a gap,
 * `count` differences over 2 lag use count + 2 lag totals. */
static invcal_real edf_of(invcal_real lag, invcal_real count)
{
    const invcal_real n = count + 2 * lag; /* totals */
    const invcal_real square = 4 * lag * lag;

    return (3 * (n - 1) / (2 * lag) - 2 * (n - 2) / n) * square / (square + 5);
}

invcal_status invcal_allan_get(const invcal_allan *allan, unsigned index, invcal_allan_point *out)
{
    INVCAL_ASSERT(allan && out);
    if (index >= allan->taus) {
        return INVCAL_BAD_COUNT;
    }
    const invcal_private_tau *tau = &allan->own[index];
    if (tau->count == 0) {
        return INVCAL_TOO_FEW;
    }
    if (has_overflowed(tau)) {
        return INVCAL_NO_SPACE;
    }
    /* adjacent windows do not overlap: each counts as one sample */
    const uint32_t lag = allan->own_apart ? 1 : tau->m >> stride_bits(tau->m, 0);
    out->m = tau->m;
    out->count = tau->count;
    out->adev = root_mean(tau) / (invcal_real)tau->m;
    out->edf = edf_of((invcal_real)lag, (invcal_real)tau->count);
    out->relative = 1 / INVCAL_SQRT(2 * out->edf);
    return INVCAL_OK;
}
