/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "magnetometer/cells.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 20 -eva-slevel 100 -eva-split-return full

void main(void)
{
    invcal_private_cells cells;
    invcal_private_cells other;
    invcal_real h[INVCAL_PARAMETERS];
    invcal_real shift[3];
    invcal_real scale;
    invcal_real d[3];

    ANY(cells);
    ANY(other);
    ANY(h);
    ANY(shift);
    ANY(scale);
    const unsigned k = invcali_cell_of(h);
    //@ assert k < INVCAL_CELLS;
    invcali_cell_direction(BETWEEN(0, INVCAL_CELLS - 1), d);
    invcali_cells_add(&cells, k, h);
    ANY(cells);
    invcali_cells_halve(&cells, BETWEEN(0, INVCAL_CELLS - 1));
    invcali_cells_merge(&cells, &other);
    ANY(cells);
    invcali_cells_move(&cells, shift, scale);
}
