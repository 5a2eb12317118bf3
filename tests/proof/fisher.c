/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "fisher.h"

void main(void)
{
    invcal_real z;
    unsigned m;
    unsigned dof;

    ANY(z);
    ANY(m);
    ANY(dof);
    (void)invcal_fisher_tail(z, m, dof);
}
