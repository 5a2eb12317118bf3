/* SPDX-License-Identifier: MIT
 *
 * Internal: the cells of magnetometer.h, and what they come to.
 *
 * A row is (x y z x^2 y^2 z^2 xy xz yz), that of a sample or the mean of many. The equation of an ellipsoid
 * is linear in it, so it holds for the mean as well, however wide the cell: no mean of vectors, which are
 * too short, and no error when the readings are expressed in other units around another centre.
 */
#ifndef INVCAL_CELLS_H
#define INVCAL_CELLS_H

#include "invcal/magnetometer.h"
#include "vector.h"

/* The cell into which (x y z) of a row points, its products being those of these. */
unsigned invcal_cell_of(const invcal_real h[INVCAL_PARAMETERS]);

/* Cells have equal areas if faces end where the tangent is t, 4 asin(t^2 / (1 + t^2)) = 4 pi / 18. */
#define INVCAL_FACE_ENDS INVCAL_REAL(0.2101) /* t^2 */
enum { INVCAL_FACES = 6 };

/* Faces: axis and sign. Edges: the axis that they are square to, and the signs of the next two. */
static inline unsigned invcal_cell_of_inline(const invcal_real h[INVCAL_PARAMETERS])
{
    static const uint8_t in_turn[] = {0, 1, 2, 0, 1}; /* axes */
    static const uint8_t first[] = {INVCAL_FACES, INVCAL_FACES + 4, INVCAL_FACES + 8};
    unsigned least = 0;

    if (h[INVCAL_DK_Y] < h[INVCAL_DK_X]) {
        least = 1;
    }
    if (h[INVCAL_DK_Z] < h[INVCAL_DK_X + least]) {
        least = 2;
    }
    const unsigned a = in_turn[least + 1];
    const unsigned b = in_turn[least + 2];
    const invcal_real first_square = h[INVCAL_DK_X + a];
    const invcal_real second_square = h[INVCAL_DK_X + b];

    if (second_square < INVCAL_FACE_ENDS * first_square) {
        return 2 * a + (h[a] < 0);
    }
    if (first_square < INVCAL_FACE_ENDS * second_square) {
        return 2 * b + (h[b] < 0);
    }
    return first[least] + 2u * (h[a] < 0) + (h[b] < 0);
}

/* It, compiled into who needs it often where speed is asked for. */
#ifdef INVCAL_FAST
#define invcal_cell_of_often invcal_cell_of_inline
#else
#define invcal_cell_of_often invcal_cell_of
#endif

/* The middle of a cell, a unit vector. */
void invcal_cell_direction(unsigned k, invcal_real d[3]);

/* A cell that is full is halved: the mean stays, and what comes counts more. 16 bits hold two that are. */
enum { INVCAL_FULL_CELL = 16384 };
void invcal_cells_halve(invcal_cells *cells, unsigned k);

/* Adds a sample to cell k. */
static inline void invcal_cells_add(invcal_cells *cells, unsigned k,
                                    const invcal_real h[INVCAL_PARAMETERS])
{
    invcal_real *const sum = cells->sum[k];

    INVCAL_UNROLL
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        sum[i] += h[i];
    }
    cells->count[k]++;
    if (cells->count[k] >= INVCAL_FULL_CELL) {
        invcal_cells_halve(cells, k);
    }
}

/* All of `from` goes into `into`. */
void invcal_cells_merge(invcal_cells *into, invcal_cells *from);

/* Readings v become (v - shift) / scale; what then points into another cell goes there. */
void invcal_cells_move(invcal_cells *cells, const invcal_real shift[3], invcal_real scale);

/* ---- what they come to -------------------------------------------------------------------------- */

/* Two tables, as if they were one; the same twice is that one. */
typedef struct {
    const invcal_cells *early;
    const invcal_cells *late;
} invcal_cell_tables;

/* Samples in cell k, or about as many. */
unsigned invcal_cells_count(const invcal_cell_tables *tables, unsigned k);

/* The cosine of the gap, 1 if there is none, and the cell behind it, or the one with fewest samples. */
invcal_real invcal_cells_gap(const invcal_cell_tables *tables, unsigned *worst);

/* The solution of cells, in the coordinates of their rows. */
typedef struct {
    invcal_cell_tables tables;
    invcal_real p[INVCAL_PARAMETERS]; /* J + h p = 0 */
    invcal_calibration triad;
    invcal_quality quality; /* cells are its positions */
} invcal_cell_fit;

/* Of the tables: p only. Returns as invcal_calibrate. */
invcal_status invcal_cells_solve(invcal_cell_fit *fit);

/* The same, and all the rest. */
invcal_status invcal_cells_calibrate(invcal_cell_fit *fit);

/* Cell k as a position: along the mean, and as long as its samples by root mean square.
 *
 * triad  what calibrates the coordinates of the rows; of any frame.
 *
 * Returns how many samples that are; 0: none, point is as it was. */
unsigned invcal_cells_point(const invcal_cell_tables *tables, const invcal_calibration *triad,
                            unsigned k, invcal_real point[3]);

/* Noise and sigma again, now with what samples tell.
 *
 * power  the variance of a cell's mean times its samples: what these scatter by, times how many of them err
 *        as one. 0: not known, sigma stays what the cells scatter by. */
void invcal_cells_weigh(invcal_cell_fit *fit, invcal_real power);

/* Do late samples differ from early ones of the same cells as after a change of offset or length? In 999 of
 * 1000 cases they do not by chance.
 *
 * power  the same, from before the late ones. 0: not known, then they do not. */
int invcal_cells_step(const invcal_cell_fit *fit, invcal_real power);

/* 1 over the mean of the diagonal of its matrix: the length of the field. */
invcal_real invcal_cells_field(const invcal_cell_fit *fit);

#endif
