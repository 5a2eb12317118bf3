/* SPDX-License-Identifier: MIT */
#include "plan/facts.h"

#include <math.h>

#include "maths/matrix.h"
#include "core/system.h"

void plan_facts_find(plan_facts *f, const design *d, const choice_request *request, const choice *c)
{
    double *K = f->length_sigma.covariance;

    f->set = d;
    f->request = request;
    f->choice = c;
    f->noise = request->cost.noise > 0 ? design_noise(&request->cost) : 0;
    criteria_information(&d->sums, K);
    (void)matrix_invert_packed(K, INVCAL_PARAMETERS); /* it is solvable */
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        f->sigma[r] = sqrt(K[INVCAL_PACKED(r, r)]);
    }
    f->length_sigma.unit = f->noise > 0 ? unit_style_field(request->units, 1).scale * f->noise : 1;
    uncertainty_search(&f->length_sigma);
}

const char *plan_length_unit(const plan_facts *f)
{
    return f->noise > 0 ? unit_style_field(f->request->units, 1).unit : "× noise";
}
