/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "history_session.h"

// eva: -eva-precision 0 -eva-auto-loop-unroll 31 -eva-slevel 40 -eva-slevel-merge-after-loop @all -eva-slevel-function extreme:2000,compare:500,nth_kept:500,invcal_faded:0
// What is written only if a function returns this is told apart by it.
// eva: -eva-split-return-function check_setup:0,read_mean:0,held_row:0,solve_positions:0,solve_without_outliers:0,invcal_session_init:0
// eva: -eva-split-return-function invcal_still_init:0,invcal_still_push:4,decide:4,judge_moment:4,agree:4,announce_still:4,disagree:4,freeze:4,finish:4,invcal_still_finish:4,invcal_still_current:0,fault:0
// eva: -eva-split-return-function invcal_settings_check:0,check_settings:0,invcal_calibration_inverse:0,divide:0,invcal_plan_check:0,invcal_plan_position_at:0
// eva: -eva-split-return-function invcal_observe:0,invcal_observation_reading:0,invcal_observation_exact:0,exact:0,invcal_observation_vertical:0,linear:0,scale:0,check_reading:0,check_vertical:0,invcal_normal_add:0
// eva: -eva-split-return-function invcal_calibrate_sums:0,solve_and_assess:0,weigh_prior_again:0,compare:0,invcal_residuals_add:0
// eva: -eva-split-return-function invcal_solve:0,solve_normal:0,invcal_triad_of_ellipsoid:0,invcal_triad_join:0,invcal_information_factor:0,invcal_cholesky_factor:0,step_towards:0
// eva: -eva-split-return-function invcal_assess:0,judge:0,judge_noise:0,judge_condition:0,parameters_of_data:0,invert:0,invcal_evidence_parameters:0
// eva: -eva-split-return-function invcal_outliers_find:0,fit_without:0,solve_without:0,sum_rows:0,read_position:0,factor_with:0,direction:0
// config: -DINVCAL_MAX_POSITIONS=64
// trusted: 15
// A position that is dropped is one of the table's; a share of seconds is one of numbers that have
// been compared. The others are those of the rooms that it calls, which say why.

static invcal_session session;

static void any_begin(void)
{
    invcal_session_setup setup;
    invcal_session begun;

    ANY(setup);
    if (invcal_session_init(&begun, &setup) == INVCAL_OK) {
        HOLDS(begun.stored == 0);
    }
}

static void any_feed(void)
{
    int32_t raw[3];
    invcal_real temperature;
    invcal_event event;

    ANY(raw);
    ANY(temperature);
    any_session(&session);
    (void)invcal_session_feed(&session, raw, temperature, &event);
    check_session(&session);
}

static void any_finish(void)
{
    invcal_event event;

    any_session(&session);
    (void)invcal_session_finish(&session, &event);
    check_session(&session);
}

static void any_change(void)
{
    invcal_real seconds;
    invcal_calibration nominal;

    ANY(seconds);
    ANY(nominal);
    any_session(&session);
    invcal_session_hold(&session, seconds);
    invcal_session_gap(&session);
    (void)invcal_session_renew(&session, &nominal);
    invcal_session_age(&session);
    check_session(&session);
}

static void any_look(void)
{
    invcal_guidance next;
    invcal_solution solution;
    invcal_quality found;
    invcal_quality present;
    invcal_outliers outliers;

    any_session(&session);
    (void)invcal_session_next(&session, &next);
    (void)invcal_session_solve(&session, &solution, &found, NULL);
    (void)invcal_session_solve(&session, &solution, &found, &outliers);
    ANY(found);
    ANY(present);
    (void)invcal_session_improves(&found, &present);
}

void main(void)
{
    any_begin();
    any_feed();
    any_finish();
    any_change();
    any_look();
}
