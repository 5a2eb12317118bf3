/* SPDX-License-Identifier: MIT
 *
 * The table of cells follows each change of centre and unit (mathematics_magnetometer.md, "Cells").
 * Sums of x, y, z and of their products determine the same sums about any other centre, so no
 * sample is needed again.
 */
#include "cells.h"

#include <string.h>

#include "../core/sums.h"
#include "../core/vector.h"

#define ROOT_HALF INVCAL_REAL(0.70710678118654752)
enum { PRODUCTS = 6 };

unsigned invcali_cell_of(const invcal_real h[INVCAL_PARAMETERS])
{
    return invcali_cell_of_inline(h);
}

void invcali_cell_direction(unsigned k, invcal_real d[3])
{
    static const uint8_t after[] = {1, 2, 0, 1}; /* this axis, and the next */

    d[0] = 0;
    d[1] = 0;
    d[2] = 0;
    if (k < INVCAL_FACES) {
        d[k / 2] = k & 1u ? (invcal_real)-1 : 1;
    } else {
        const unsigned edge = k - INVCAL_FACES;
        d[after[edge / 4]] = edge & 2u ? -ROOT_HALF : ROOT_HALF;
        d[after[edge / 4 + 1]] = edge & 1u ? -ROOT_HALF : ROOT_HALF;
    }
}

void invcali_cells_halve(invcal_private_cells *cells, unsigned k)
{
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        cells->sum[k][i] /= 2;
    }
    cells->count[k] = (uint16_t)(cells->count[k] / 2u);
}

static void move_cell(invcal_private_cells *into, unsigned to, invcal_private_cells *from,
                      unsigned k)
{
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        into->sum[to][i] += from->sum[k][i];
        from->sum[k][i] = 0;
    }
    into->count[to] = (uint16_t)(into->count[to] + from->count[k]);
    from->count[k] = 0;
    if (into->count[to] >= INVCAL_FULL_CELL) {
        invcali_cells_halve(into, to);
    }
}

void invcali_cells_merge(invcal_private_cells *into, invcal_private_cells *from)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        move_cell(into, k, from, k);
    }
}

/* sum (v - s)(v - s)' = sum v v' - s sum v' - sum v s' + n s s'. Products first: they need the old
 * sums of v. */
static void move_sum(invcal_real *sum, invcal_real n, const invcal_real s[3], invcal_real scale)
{
    static const uint8_t pair[PRODUCTS][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

    for (unsigned i = 0; i < PRODUCTS; i++) {
        const unsigned a = pair[i][0];
        const unsigned b = pair[i][1];
        sum[INVCAL_DK_X + i] += (n * s[a] - sum[a]) * s[b] - s[a] * sum[b];
        sum[INVCAL_DK_X + i] /= scale * scale;
    }
    for (unsigned a = 0; a < 3; a++) {
        sum[a] = (sum[a] - n * s[a]) / scale;
    }
}

/* The products of the mean, not the mean products: only it has a direction. Its length does not
 * matter, so the sum serves. */
static unsigned cell_of_mean(const invcal_private_cells *cells, unsigned k)
{
    invcal_real h[INVCAL_PARAMETERS];

    memcpy(h, cells->sum[k], 3 * sizeof *h);
    invcali_row_of(h);
    return invcali_cell_of(h);
}

/* Converts all sums before any cell moves: those that come together must have the same
 * coordinates. */
void invcali_cells_move(invcal_private_cells *cells, const invcal_real shift[3], invcal_real scale)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        move_sum(cells->sum[k], invcali_number(cells->count[k]), shift, scale);
    }
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        const unsigned to = cell_of_mean(cells, k);
        if (cells->count[k] > 0 && to != k) {
            move_cell(cells, to, cells, k);
        }
    }
}
