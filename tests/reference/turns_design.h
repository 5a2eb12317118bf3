/* SPDX-License-Identifier: MIT
 *
 * Made by turns_design.py, which says what it is. */
#ifndef TURNS_DESIGN_H
#define TURNS_DESIGN_H

#include <stdint.h>

/* Sigma over the noise of a position mean, both sensors unknown; and the condition. */
static const double tour12_sigma[18] = {
    0.45016, 0.79057, 0.79057, 0.79057, 0.45016, 0.79057, 0.79057, 0.79057, 0.45016,
    0.35355, 0.35355, 0.33710, 0.50000, 0.50000, 0.45227, 0.70711, 0.70711, 0.70711};
static const double tour12_condition = 9.23607;
static const double tour9_sigma[18] = {
    0.59292, 0.98569, 0.98329, 0.98569, 0.59292, 0.98329, 0.98329, 0.98329, 0.59936,
    0.47970, 0.47970, 0.42081, 0.59908, 0.59908, 0.50000, 0.94147, 0.93136, 0.93136};
static const double tour9_condition = 15.67460;
static const double tour16_sigma[18] = {
    0.19770, 0.79057, 0.79057, 0.73598, 0.20132, 0.77638, 0.73598, 0.77638, 0.20132,
    0.35355, 0.32103, 0.31491, 0.50000, 0.42204, 0.40134, 0.70711, 0.70711, 0.64112};
static const double tour16_condition = 26.02637;
static const double tour24_sigma[18] = {
    0.31831, 0.55902, 0.55902, 0.55902, 0.31831, 0.55902, 0.55902, 0.55902, 0.31831,
    0.25000, 0.25000, 0.24333, 0.35355, 0.35355, 0.33443, 0.50000, 0.50000, 0.50000};
static const double tour24_condition = 8.56155;

/* The turns that add most, of 9 and of 18 unknowns, and det^(1/n) after 12 and 24. */
static const double greedy12_of_9_root = 5.43553;
static const double greedy24_of_9_root = 11.46260;
static const char greedy_of_9[] =
    "+z +y-z +x-y+z -x+y +x -x+z +x+y-z -x-y +y -x-y-z +y+z -y -x+y+z "
    "-y-z +z -x-z +x-y+z +y-z -x-y+z +x+y -x-y-z +x+z -x+y-z +x-y -x+y+z";

static const double greedy12_of_18_root = 4.52423;
static const double greedy12_sigma[18] = {
    0.38428, 0.62801, 0.56023, 0.72122, 0.40129, 0.55927, 0.54034, 0.52312, 0.48144,
    0.33772, 0.33076, 0.36505, 0.51354, 0.54065, 0.49353, 0.86524, 0.70219, 0.75524};
static const double greedy12_condition = 18.31197;
static const double greedy24_of_18_root = 9.71689;
static const double greedy24_sigma[18] = {
    0.25630, 0.35469, 0.36132, 0.34758, 0.27811, 0.36993, 0.38061, 0.39461, 0.25990,
    0.22974, 0.21772, 0.21603, 0.33471, 0.33552, 0.35936, 0.51384, 0.50412, 0.53256};
static const double greedy24_condition = 9.10109;
static const char greedy_of_18[] =
    "+z +y-z +x-y+z -x +x-y-z +y -x-y-z +x+y -x +x+z -y-z +z +x-z "
    "-x+y +x-y-z +y+z -x-y +y-z -y +x+y -x-y+z +x-z -x+y+z +x-y -x";

/* Turns about one axis, and about two. */
static const unsigned one_axis_rank = 8;
static const uint32_t one_axis_open = UINT32_C(0x193FE);
static const unsigned two_axes_rank = 14;
static const uint32_t two_axes_open = UINT32_C(0x0812E);

#endif
