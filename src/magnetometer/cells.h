/* SPDX-License-Identifier: MIT
 *
 * Internal: the cells of magnetometer.h, and their solution.
 *
 * A row is (x y z x^2 y^2 z^2 xy xz yz), of a sample or the mean of many. The equation of an
 * ellipsoid is linear in it, so it also holds for the mean, however wide the cell is; a mean of
 * vectors would be too short. Changes of unit or centre are exact.
 *
 * Members of invcal_private_cells: the sums of the rows of the samples of each cell, and their
 * number. Of invcal_private_magnetometer:
 *
 *     unit         length 1 of the cells, in the unit of nominal
 *     p            the solution so far; before it, the box of the readings
 *     squares      sum of squared residuals of samples, over field
 *     products     sum over blocks of |sum eta r|^2, r being the residual
 *     before       products over samples, at the last look
 *     block        sum eta r of the current block
 *     blocked      samples in squares, without those of the current block
 *     samples      accepted since the first; above 16 million fewer
 *     due          number of samples at the next look; 0: not begun
 *     dropped      samples that contradicted the solution so far
 *     in_block     samples in the current block
 *     stage        of the solution
 *     has_step     one was seen
 *     early, late  of the samples up to the last look, and since then: a difference is a step
 */
#ifndef INVCAL_CELLS_H
#define INVCAL_CELLS_H

#include "invcal/magnetometer.h"
#include "../core/vector.h"

/* The cell into which (x y z) of a row points; its products must be those of (x y z). */
unsigned invcali_cell_of(const invcal_real h[INVCAL_PARAMETERS]);

/* Cells have equal areas if faces end where the tangent is t, 4 asin(t^2 / (1 + t^2)) = 4 pi / 18
 * (mathematics_magnetometer.md, "Cells"). */
#define INVCAL_FACE_ENDS INVCAL_REAL(0.2101) /* t^2 */
enum { INVCAL_FACES = 6 };

/* Faces: axis and sign. Edges: the axis perpendicular to them, and the signs of the next two. */
static inline unsigned invcali_cell_of_inline(const invcal_real h[INVCAL_PARAMETERS])
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

/* Inlined where it is called often, if speed matters. */
#if INVCAL_FAST
#define invcali_cell_of_often invcali_cell_of_inline
#else
#define invcali_cell_of_often invcali_cell_of
#endif

/* The centre of a cell, a unit vector. */
void invcali_cell_direction(unsigned k, invcal_real d[3]);

/* A full cell is halved: its mean stays, and later samples count more. 16 bits hold two full
 * cells. */
enum { INVCAL_FULL_CELL = 16384 };
void invcali_cells_halve(invcal_private_cells *cells, unsigned k);

/* Adds a sample to cell k. */
static inline void invcali_cells_add(invcal_private_cells *cells, unsigned k,
                                     const invcal_real h[INVCAL_PARAMETERS])
{
    invcal_real *const sum = cells->sum[k];

    INVCAL_UNROLL
    for (unsigned i = 0; i < INVCAL_PARAMETERS; i++) {
        sum[i] += h[i];
    }
    cells->count[k]++;
    if (cells->count[k] >= INVCAL_FULL_CELL) {
        invcali_cells_halve(cells, k);
    }
}

/* Moves all of `from` into `into`. */
void invcali_cells_merge(invcal_private_cells *into, invcal_private_cells *from);

/* Readings v become (v - shift) / scale; a mean that then points into another cell moves there. */
void invcali_cells_move(invcal_private_cells *cells, const invcal_real shift[3], invcal_real scale);

/* ---- their solution -------------------------------------------------------------------------- */

/* Two tables, as if they were one; the same table twice counts as one. */
typedef struct {
    const invcal_private_cells *early;
    const invcal_private_cells *late;
} invcali_cell_tables;

/* The number of samples in cell k; less once it was halved. */
unsigned invcali_cells_count(const invcali_cell_tables *tables, unsigned k);

/* Returns the cosine of the gap, 1 if there is none. worst: its cell, or the one with the fewest
 * samples. */
invcal_real invcali_cells_gap(const invcali_cell_tables *tables, unsigned *worst);

/* The solution of cells, in the coordinates of their rows. */
typedef struct {
    invcali_cell_tables tables;
    invcal_real p[INVCAL_PARAMETERS]; /* J + h p = 0 */
    invcal_calibration triad;
    invcal_quality quality; /* cells are its positions */
} invcali_cell_fit;

/* Solves the tables: p and triad. Returns as invcal_calibrate_plain. */
invcal_status invcali_cells_solve(invcali_cell_fit *fit);

/* Solves them, with the quality. */
invcal_status invcali_cells_calibrate(invcali_cell_fit *fit);

/* Cell k as a position: along the mean, with the root-mean-square length of its samples.
 *
 * triad  calibration of the coordinates of the rows; of any frame.
 *
 * Returns the number of samples; if 0, point is unchanged. */
unsigned invcali_cells_point(const invcali_cell_tables *tables, const invcal_calibration *triad,
                             unsigned k, invcal_real point[3]);

/* Computes noise and sigma again, now with the scatter of the samples.
 *
 * power  the variance of a cell's mean times the number of its samples: their variance, times how
 *        many in a row have a common error. 0: unknown, sigma remains that of the scatter of the
 *        cells. */
void invcali_cells_weigh(invcali_cell_fit *fit, invcal_real power);

/* Returns whether late samples differ from early ones of the same cells as after a change of offset
 * or length. In 999 of 1000 cases without a change they do not.
 *
 * power  the same, from before the late ones. 0: unknown, then it returns 0. */
int invcali_cells_step(const invcali_cell_fit *fit, invcal_real power);

/* 1 over the mean of the diagonal of its matrix: the length of the field. */
invcal_real invcali_cells_field(const invcali_cell_fit *fit);

/* A cell as a position, for display by the host tool: along the mean of its samples, with the
 * root-mean-square length of the calibrated samples.
 *
 * calibration  from invcal_magnetometer_solve; not scaled.
 * k            0 ... INVCAL_CELLS - 1.
 * raw          out: raw counts.
 *
 * Returns the number of its samples; if 0, raw is unchanged. */
unsigned invcali_magnetometer_cell(const invcal_magnetometer *magnetometer,
                                   const invcal_calibration *calibration, unsigned k,
                                   invcal_real raw[3]);

#endif
