/* SPDX-License-Identifier: MIT */
#include "invcal/normal.h"

#include <string.h>

#include "vector.h"

enum { SUMS = INVCAL_PACKED_SIZE(INVCAL_PARAMETERS) };

void invcal_normal_init(invcal_normal *normal)
{
    INVCAL_ASSERT(normal);
    memset(normal, 0, sizeof *normal);
}

static int is_mixed(const invcal_normal *normal, invcal_model model)
{
    return normal->count > 0 && normal->model != model;
}

/* H'H += w h h', H'J += w h j, J'J += w j j. */
static void accumulate(invcal_normal *normal, const invcal_observation *o, invcal_real weight)
{
    invcal_real *sum = normal->hth;

    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        const invcal_real wh = weight * o->h[r];
        for (unsigned c = 0; c <= r; c++) {
            *sum++ += wh * o->h[c];
        }
        normal->htj[r] += wh * o->j;
    }
    normal->jtj += weight * o->j * o->j;
}

static invcal_status check(const invcal_normal *normal, const invcal_observation *observation,
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
    const invcal_status status = check(normal, observation, weight);

    if (status == INVCAL_OK) {
        accumulate(normal, observation, weight);
        normal->count++;
        normal->model = observation->model;
    }
    return status;
}

invcal_status invcal_normal_remove(invcal_normal *normal, const invcal_observation *observation,
                                   invcal_real weight)
{
    const invcal_status status = check(normal, observation, weight);

    if (status != INVCAL_OK) {
        return status;
    }
    if (normal->count == 0) {
        return INVCAL_TOO_FEW;
    }
    accumulate(normal, observation, -weight);
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
    for (unsigned i = 0; i < SUMS; i++) {
        normal->hth[i] += other->hth[i];
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal->htj[r] += other->htj[r];
    }
    normal->jtj += other->jtj;
    if (other->count > 0) {
        normal->model = other->model;
    }
    normal->count += other->count;
    return INVCAL_OK;
}

invcal_status invcal_normal_scale(invcal_normal *normal, invcal_real factor)
{
    INVCAL_ASSERT(normal);
    if (!(factor > 0 && factor <= 1)) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned i = 0; i < SUMS; i++) {
        normal->hth[i] *= factor;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal->htj[r] *= factor;
    }
    normal->jtj *= factor;
    return INVCAL_OK;
}

static int is_prior(const invcal_real sigma[INVCAL_PARAMETERS])
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (!(sigma[r] >= 0 && sigma[r] <= INVCAL_REAL_MAX)) {
            return 0;
        }
    }
    return 1;
}

invcal_status invcal_normal_add_prior(invcal_normal *normal,
                                      const invcal_real sigma[INVCAL_PARAMETERS], invcal_real noise)
{
    INVCAL_ASSERT(normal && sigma);
    if (!(invcal_is_positive(noise) && is_prior(sigma))) {
        return INVCAL_BAD_SETTING;
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        if (sigma[r] > 0) {
            const invcal_real ratio = noise / sigma[r];
            normal->hth[INVCAL_PACKED(r, r)] += ratio * ratio;
        }
    }
    return INVCAL_OK;
}
