/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "invcal/gravity.h"

void main(void)
{
    invcal_real latitude;
    invcal_real height;
    invcal_real gravity;

    ANY(latitude);
    ANY(height);
    (void)invcal_gravity(latitude, height, &gravity);
}
