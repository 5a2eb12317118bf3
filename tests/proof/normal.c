/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/normal.h"

void main(void)
{
    invcal_normal normal;
    invcal_normal other;
    invcal_observation observation;
    invcal_real number;
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    ANY(normal);
    ANY(other);
    ANY(observation);
    ANY(number);
    invcal_normal_matrix(&normal, hth);
    (void)invcal_normal_merge(&normal, &other);
    (void)invcal_normal_merge(&normal, &normal);
    (void)invcal_normal_scale(&normal, number);
    (void)invcal_normal_add(&normal, &observation, number);
    (void)invcal_normal_remove(&normal, &observation, number);
    invcal_normal_init(&normal);
}
