/* SPDX-License-Identifier: MIT */
#include "arbitrary.h"
#include "magnetometer/cells.h"
#include "calibrate/judge.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 20 -eva-slevel 100 -eva-slevel-function invcali_text:2000 -eva-split-return full
// stubs: cell_fit

/* ---- what other modules do -------------------------------------------------------------------- */

/* Reads all of it, so that none may be uninitialised. */
static void read_tables(const invcali_cell_tables *tables)
{
    const unsigned k = BETWEEN(0, INVCAL_CELLS - 1);

    (void)(tables->early->count[k] + tables->late->count[k]);
    (void)(tables->early->sum[k][0] + tables->late->sum[k][INVCAL_PARAMETERS - 1]);
}

static void read_fit(const invcali_cell_fit *fit)
{
    read_tables(&fit->tables);
    (void)fit->triad.offset[BETWEEN(0, 2)];
    (void)fit->triad.matrix[BETWEEN(0, 2)][BETWEEN(0, 2)];
}

static invcal_real any_real(void)
{
    invcal_real x;

    ANY(x);
    return x;
}

static invcal_status any_fit(invcali_cell_fit *fit)
{
    read_tables(&fit->tables);
    ANY(fit->p);
    ANY(fit->triad);
    return (invcal_status)BETWEEN(INVCAL_OK, INVCAL_STATUS_END - 1);
}

invcal_real invcali_cells_gap(const invcali_cell_tables *tables, unsigned *worst)
{
    read_tables(tables);
    *worst = BETWEEN(0, INVCAL_CELLS - 1);
    return any_real();
}

invcal_status invcali_cells_solve(invcali_cell_fit *fit)
{
    return any_fit(fit);
}

invcal_status invcali_cells_calibrate(invcali_cell_fit *fit)
{
    ANY(fit->quality);
    return any_fit(fit);
}

void invcali_cells_weigh(invcali_cell_fit *fit, invcal_real power)
{
    (void)power;
    read_fit(fit);
    ANY(fit->quality);
}

int invcali_cells_step(const invcali_cell_fit *fit, invcal_real power)
{
    (void)power;
    read_fit(fit);
    return (int)BETWEEN(0, 1);
}

invcal_real invcali_cells_field(const invcali_cell_fit *fit)
{
    read_fit(fit);
    return any_real();
}

unsigned invcali_cells_point(const invcali_cell_tables *tables, const invcal_calibration *triad,
                             unsigned k, invcal_real point[3])
{
    (void)(triad->offset[2] + triad->matrix[2][2]);
    read_tables(tables);
    (void)k;
    point[0] = any_real();
    point[1] = any_real();
    point[2] = any_real();
    return BETWEEN(0, 32768);
}

/* ---- any state, any sample ---------------------------------------------------------------------- */

void main(void)
{
    invcal_magnetometer magnetometer;
    invcal_magnetometer_found found;
    invcal_calibration calibration;
    invcal_quality quality;
    invcal_real raw[3];

    ANY(calibration);
    ANY(raw);
    (void)invcal_magnetometer_init(&magnetometer, &calibration);
    (void)invcal_magnetometer_init(&magnetometer, 0);
    ANY(magnetometer);
    (void)invcal_magnetometer_feed(&magnetometer, raw[0], raw[1], raw[2]);
    ANY(magnetometer);
    invcal_magnetometer_next(&magnetometer, raw);
    (void)invcal_magnetometer_solve(&magnetometer, &calibration, &quality, &found);
    (void)invcal_magnetometer_solve(&magnetometer, &calibration, &quality, 0);
    ANY(calibration);
    (void)invcali_magnetometer_cell(&magnetometer, &calibration, BETWEEN(0, INVCAL_CELLS - 1), raw);
    for (uint8_t n = 0; n <= INVCAL_STEP; n++) {
        (void)invcal_disturbance_text(n);
    }
    (void)invcal_disturbance_text((uint8_t)BETWEEN(INVCAL_STEP + 1, UINT8_MAX));
}
