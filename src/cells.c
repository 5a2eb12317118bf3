/* SPDX-License-Identifier: MIT */
#include "cells.h"

#include <string.h>

#include "sums.h"
#include "vector.h"

/* Cells have equal areas if faces end where the tangent is t, 4 asin(t^2 / (1 + t^2)) = 4 pi / 18. */
#define FACE_ENDS INVCAL_REAL(0.2101) /* t^2 */
#define ROOT_HALF INVCAL_REAL(0.70710678118654752)
enum { FACES = 6, PRODUCTS = 6 };

static const uint8_t cyclic[] = {0, 1, 2, 0, 1};

/* Faces: axis and sign. Edges: the axis that they are square to, and the signs of the next two. */
unsigned invcal_cell_of(const invcal_real h[INVCAL_PARAMETERS])
{
    static const uint8_t first[] = {FACES, FACES + 4, FACES + 8};
    unsigned least = 0;

    if (h[INVCAL_DK_Y] < h[INVCAL_DK_X]) {
        least = 1;
    }
    if (h[INVCAL_DK_Z] < h[INVCAL_DK_X + least]) {
        least = 2;
    }
    const unsigned a = cyclic[least + 1];
    const unsigned b = cyclic[least + 2];
    const invcal_real first_square = h[INVCAL_DK_X + a];
    const invcal_real second_square = h[INVCAL_DK_X + b];

    if (second_square < FACE_ENDS * first_square) {
        return 2 * a + (h[a] < 0);
    }
    if (first_square < FACE_ENDS * second_square) {
        return 2 * b + (h[b] < 0);
    }
    return first[least] + 2u * (h[a] < 0) + (h[b] < 0);
}

void invcal_cell_direction(unsigned k, invcal_real d[3])
{
    d[0] = 0;
    d[1] = 0;
    d[2] = 0;
    if (k < FACES) {
        d[k / 2] = k & 1u ? (invcal_real)-1 : 1;
    } else {
        const unsigned edge = k - FACES;
        d[cyclic[edge / 4 + 1]] = edge & 2u ? -ROOT_HALF : ROOT_HALF;
        d[cyclic[edge / 4 + 2]] = edge & 1u ? -ROOT_HALF : ROOT_HALF;
    }
}

void invcal_cells_halve(invcal_cells *cells, unsigned k)
{
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        cells->sum[k][i] /= 2;
    }
    cells->count[k] = (uint16_t)(cells->count[k] / 2u);
}

static void move_cell(invcal_cells *into, unsigned to, invcal_cells *from, unsigned k)
{
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        into->sum[to][i] += from->sum[k][i];
        from->sum[k][i] = 0;
    }
    into->count[to] = (uint16_t)(into->count[to] + from->count[k]);
    from->count[k] = 0;
    if (into->count[to] >= INVCAL_FULL_CELL) {
        invcal_cells_halve(into, to);
    }
}

void invcal_cells_merge(invcal_cells *into, invcal_cells *from)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        move_cell(into, k, from, k);
    }
}

/* sum (v - s)(v - s)' = sum v v' - s sum v' - sum v s' + n s s' */
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

static unsigned cell_of_mean(const invcal_cells *cells, unsigned k)
{
    invcal_real h[INVCAL_PARAMETERS];

    memcpy(h, cells->sum[k], 3 * sizeof *h);
    invcal_row_of(h);
    return invcal_cell_of(h);
}

void invcal_cells_move(invcal_cells *cells, const invcal_real shift[3], invcal_real scale)
{
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        move_sum(cells->sum[k], invcal_number(cells->count[k]), shift, scale);
    }
    for (unsigned k = 0; k < INVCAL_CELLS; k++) {
        const unsigned to = cell_of_mean(cells, k);
        if (cells->count[k] > 0 && to != k) {
            move_cell(cells, to, cells, k);
        }
    }
}
