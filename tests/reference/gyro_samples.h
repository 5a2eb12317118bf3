/* SPDX-License-Identifier: MIT
 *
 * Made by gyro_samples.py of logs that are not kept here: see there. */
#ifndef GYRO_SAMPLES_H
#define GYRO_SAMPLES_H

/* M by rows, and delta, dk and gamma of the accelerometer, over the data sheet's scales; and the root mean square
 * of the moves' residuals on an axis, rad. */
static const double xsens_gyro[9] = {
    0.99817, 0.00681, 0.00658, 0.00624, 1.00219, -0.04247, 0.02005, -0.01168, 1.00156};
static const double xsens_accelerometer[9] = {
    0.08756, 0.12480, -0.09924, 0.00020, -0.00549, 0.00037, 0.00376, 0.00892, 0.02093};
static const double xsens_residual = 0.00164;
static const double xsens_slope[9] = { /* degrees/s per g */
    0.0124, 0.0369, 0.0662, -0.1444, 0.0051, 0.1020, -0.0790, -0.0782, 0.0227};
static const double mpu_gyro[9] = {
    0.99970, 0.00067, -0.00623, 0.00091, 0.99601, 0.00290, -0.01059, -0.00143, 0.99250};
static const double mpu_accelerometer[9] = {
    0.01050, 0.00985, 0.03510, 0.00363, 0.00308, 0.00634, 0.00041, 0.00571, 0.00199};
static const double mpu_residual = 0.00233;

#endif
