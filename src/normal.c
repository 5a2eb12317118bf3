/* SPDX-License-Identifier: MIT */
#include "invcal/normal.h"

#include <limits.h>
#include <string.h>

#include "vector.h"

void invcal_normal_init(invcal_normal *normal)
{
    INVCAL_ASSERT(normal);
    memset(normal, 0, sizeof *normal);
}

static int is_mixed(const invcal_normal *normal, invcal_model model)
{
    return normal->model != model && normal->count > 0;
}

/* All products of degree d + 1 of x, y, z behind those of degree d: x times each, y times those
 * without x, z times the last. So they stand in the order xx xy xz yy yz zz, xxx xxy ... zzz. */
static invcal_real *raised(invcal_real *list, unsigned degree, const invcal_real a[3])
{
    const unsigned without_x = degree + 1;
    const unsigned all = without_x * (degree + 2) / 2;
    invcal_real *next = list + all;

    INVCAL_UNROLL
    for (unsigned i = 0; i < all; i++) {
        *next++ = a[0] * list[i];
    }
    INVCAL_UNROLL
    for (unsigned i = all - without_x; i < all; i++) {
        *next++ = a[1] * list[i];
    }
    *next = a[2] * list[all - 1];
    return list + all;
}

/* H'H += w h h', H'J += w h j, J'J += w j j. */
static void add_weighted(invcal_normal *normal, const invcal_observation *o, invcal_real weight)
{
    const invcal_real wj = weight * o->j;
    /* cppcheck-suppress misra-c2012-9.3 ; raised() fills the rest */
    invcal_real product[3 + INVCAL_MOMENTS] = {weight * o->h[0], weight * o->h[1],
                                               weight * o->h[2]};

    (void)raised(raised(raised(product, 1, o->h), 2, o->h), 3, o->h);
    INVCAL_UNROLL
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        normal->moment[i] += product[3 + i];
    }
    INVCAL_UNROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal->htj[r] += wj * o->h[r];
    }
    normal->jtj += wj * o->j;
}

static invcal_status check_row(const invcal_normal *normal, const invcal_observation *observation,
                               invcal_real weight)
{
    INVCAL_ASSERT(normal && observation);
    if (!invcal_is_positive(weight)) {
        return INVCAL_BAD_SETTING;
    }
    return is_mixed(normal, observation->model) ? INVCAL_MIXED : INVCAL_OK;
}

invcal_status invcal_normal_add(invcal_normal *normal, const invcal_observation *observation,
                                invcal_real weight)
{
    const invcal_status status = check_row(normal, observation, weight);

    if (status == INVCAL_OK) {
        add_weighted(normal, observation, weight);
        /* Sums that fade may go on for ever, and a count of 0 would say that they are empty. */
        normal->count += normal->count < UINT_MAX;
        normal->model = observation->model;
    }
    return status;
}

invcal_status invcal_normal_remove(invcal_normal *normal, const invcal_observation *observation,
                                   invcal_real weight)
{
    const invcal_status status = check_row(normal, observation, weight);

    if (status != INVCAL_OK) {
        return status;
    }
    if (normal->count == 0) {
        return INVCAL_TOO_FEW;
    }
    add_weighted(normal, observation, -weight);
    if (--normal->count == 0) {
        invcal_normal_init(normal); /* no rounding errors of what has gone */
    }
    return INVCAL_OK;
}

invcal_status invcal_normal_merge(invcal_normal *normal, const invcal_normal *other)
{
    INVCAL_ASSERT(normal && other);
    if (other->count > 0 && is_mixed(normal, other->model)) {
        return INVCAL_MIXED;
    }
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        normal->moment[i] += other->moment[i];
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal->htj[r] += other->htj[r];
    }
    normal->jtj += other->jtj;
    if (other->count > 0) {
        normal->model = other->model;
    }
    normal->count =
        other->count < UINT_MAX - normal->count ? normal->count + other->count : UINT_MAX;
    return INVCAL_OK;
}

invcal_status invcal_normal_scale(invcal_normal *normal, invcal_real factor)
{
    INVCAL_ASSERT(normal);
    if (!(factor > 0 && factor <= 1)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        normal->moment[i] *= factor;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal->htj[r] *= factor;
    }
    normal->jtj *= factor;
    return INVCAL_OK;
}

/* Element (r, c) is the sum of one product: it stands behind those of lower degree, and of those
 * with fewer factors other than x, and fewer z. */
void invcal_normal_matrix(const invcal_normal *normal,
                          invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)])
{
    /* of x y z xx yy zz xy xz yz */
    static const unsigned char not_x[INVCAL_PARAMETERS] = {0, 1, 1, 0, 2, 2, 1, 1, 2};
    static const unsigned char is_z[INVCAL_PARAMETERS] = {0, 0, 1, 0, 0, 2, 0, 1, 1};

    INVCAL_ASSERT(normal && hth);
    INVCAL_UNROLL
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        INVCAL_UNROLL
        for (unsigned c = 0; c <= r; c++) {
            /* cppcheck-suppress misra-c2012-10.6 ; constants, no wider than they are */
            const unsigned start = c >= INVCAL_DK_X ? 16 : r >= INVCAL_DK_X ? 6 : 0;
            const unsigned others = (unsigned)not_x[r] + not_x[c];
            *hth++ = normal->moment[start + INVCAL_PACKED(others, (unsigned)is_z[r] + is_z[c])];
        }
    }
}
