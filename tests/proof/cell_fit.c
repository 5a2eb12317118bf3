/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "magnetometer/cells.h"
#include "calibrate/judge.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 60 -eva-slevel 300 -eva-split-return full
// stubs: judge

/* ---- what other modules do -------------------------------------------------------------------- */

invcal_status invcali_positions_calibrate(const invcali_selection *selection,
                                          invcal_calibration *out, invcal_quality *quality)
{
    for (unsigned i = 0; i < selection->given.count; i++) {
        const invcal_real *mean = selection->given.mean[i].v;
        (void)(mean[0] + mean[1] + mean[2]);
    }
    ANY(*out);
    ANY(*quality);
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);
}

void invcali_judge_parameters(const invcal_real a[3][3], invcal_quality *q)
{
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        (void)q->sigma[r];
    }
    (void)a[2][2];
    ANY(*q);
}

/* ---- any tables, any solution of them ----------------------------------------------------------- */

void main(void)
{
    invcal_private_cells early;
    invcal_private_cells late;
    invcali_cell_fit fit;
    invcal_real power;
    unsigned worst;

    ANY(early);
    ANY(late);
    ANY(fit);
    ANY(power);
    fit.tables.early = &early;
    fit.tables.late = &late;
    (void)invcali_cells_count(&fit.tables, BETWEEN(0, INVCAL_CELLS - 1));
    (void)invcali_cells_gap(&fit.tables, &worst);
    //@ assert worst < INVCAL_CELLS;
    (void)invcali_cells_solve(&fit);
    (void)invcali_cells_calibrate(&fit);
    ANY(fit.triad);
    ANY(fit.quality);
    invcal_real point[3];
    (void)invcali_cells_point(&fit.tables, &fit.triad, BETWEEN(0, INVCAL_CELLS - 1), point);
    (void)invcali_cells_step(&fit, power);
    (void)invcali_cells_field(&fit);
    invcali_cells_weigh(&fit, power);
}
