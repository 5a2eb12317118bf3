/* SPDX-License-Identifier: MIT
 *
 * result/result.h: what `invcal calibrate` has found, and the ways to report it.
 */
#ifndef RESULT_H
#define RESULT_H

#include <stdio.h>

#include "fit/case_frame.h"
#include "fit/dip_frame.h"
#include "fit/fit.h"
#include "fit/gyro.h"
#include "text/json_write.h"
#include "fit/l1.h"
#include "fit/nominal.h"
#include "fit/nonlinearity.h"
#include "read/positions.h"
#include "fit/rejection.h"
#include "read/rests.h"
#include "read/magnetometer_log.h"
#include "stand/stand.h"
#include "fit/thermal_fit.h"
#include "cli/unit_style.h"
#include "result/record.h"
#include "result/uncertainty.h"

/* What is known of temperature. */
typedef enum {
    CALIBRATE_PLAIN,  /* nothing, or nothing that could be looked at */
    CALIBRATE_PROBED, /* it was not asked for: `fit` holds what --thermal 1 would find */
    CALIBRATE_THERMAL /* `fit` is the result; solution and quality are those at its reference */
} calibrate_temperature;

/* Why there is no calibration. Filled in by calibrate/refuse.h, reported by message, JSON and page. */
#define REFUSAL_MAX 1000u
typedef struct {
    const char *word;         /* "too few", ...; null: it was not refused */
    char reason[REFUSAL_MAX]; /* what is wrong, */
    char remedy[REFUSAL_MAX]; /* and what to do: clauses without a stop; the latter may be "" */
    uint16_t undetermined;    /* bit r: the positions leave parameter r open */
    int is_of_position;       /* one reading is wrong, */
    unsigned position;        /* this one, from 0 */
    int wants_positions;      /* others would help, */
    unsigned degree;          /* to determine a nonlinearity of this degree as well; 0: the nine */
} refusal;

typedef struct {
    refusal refused; /* then all below but data, log, rejected, nominal and settings is not known */
    const positions *data;
    const rests_summary *log;             /* what they were found in; null: they were given */
    const magnetometer_log *magnetometer; /* which was waved, and whose cells they are; or null */
    rejection rejected;
    nominal_choice nominal;
    fit_settings settings;
    fit_solution solution;
    fit_quality quality; /* worst counts among all positions */
    double limit
        [INVCAL_PARAMETERS]; /* what a good sensor may be off by, in the units of x; NaN: not */
    int has_limits;          /* stated; or is some */
    double field_sigma;      /* of the field, over itself: a part of sigma of the scales, */
    int is_field_stated;     /* as stated; or because it was not */
    reading_unit field_unit; /* as stated */
    double accuracy; /* 95 % of lengths are right within that, over the field, if the field is */
    double need;     /* what is asked of all of it, field units; 0: nothing; */
    display_unit need_unit; /* its unit */
    int is_drift_fitted;   /* the calibration holds in the middle of the session, and is freed of */
    double drift[3];       /* this: from the first position to the last, over the field, */
    double drift_sigma[3]; /* and how well that is known */
    unsigned
        degree; /* of the nonlinearity that was fitted as well: 2, 3; 0: none. The calibration */
    double nonlinear
        [NONLINEARITY_TERMS]; /* is freed of it: x y z quadratic, x y z cubic, over the field, */
    double nonlinear_sigma[NONLINEARITY_TERMS]; /* and how well that is known */
    int is_robust_wanted; /* a cross-check by the l1 estimate of all positions, */
    int has_robust;       /* which there is: */
    double robust[INVCAL_PARAMETERS];
    double robust_most;     /* largest difference, over what noise makes of it, */
    unsigned robust_worst;  /* in this parameter */
    int is_noise_given;     /* by --noise, not by the scatter of the samples */
    double residual_before; /* root mean square of |nominal calibration| / field - 1 */
    calibrate_temperature temperature;
    thermal_fit fit;
    stand stand;           /* results from the angles of a stand, if requested */
    int is_stand_frame;    /* the calibration is turned to the stand, */
    case_frame frame;      /* or to the case */
    int is_field_measured; /* settings.field is the mean length of a magnetometer's readings */
    dip_frame dip;         /* results from the accelerometer next to a magnetometer; */
    int is_dip_frame;      /* the calibration is turned to its axes */
    gyro_fit gyro;         /* the gyroscope, if there is one; */
    int is_joint;          /* its moves determine the accelerometer, which the rests alone do not */
    unit_style units;      /* the units of figures for people */
    record record;         /* what it is filed under */
    const double *place;   /* latitude and height that give the field; null: it was stated */
} calibrate_result;

/* Slopes were asked for, and are wanting over a range that needs some: other positions at the same
 * temperatures do not help. */
int calibrate_wants_slopes(const calibrate_result *result);

/* Times the slope of a parameter against nominal: what it is in the sensor's own scale, if no nominal scale
 * is stated; else 1. */
double calibrate_slope_scale(const calibrate_result *result, unsigned parameter);

/* What the frame of the calibration is called: "symmetric", ... */
const char *calibrate_frame(const calibrate_result *result);

/* The calibration that holds for a position. */
invcal_calibration calibrate_at(const calibrate_result *result, unsigned position);

/* That of a temperature. */
invcal_calibration calibrate_at_temperature(const calibrate_result *result, double temperature);

/* Takes the drift that was fitted off a reading at `tau`; the reading of a position without that and without
 * the nonlinearity that was fitted. */
void calibrate_take_drift(const calibrate_result *result, double tau, double reading[3]);
void calibrate_level(const calibrate_result *result, unsigned position, double out[3]);

/* What a position reads too much, over the field: the residual of one that was kept, the error of one that
 * was left out. */
double calibrate_excess(const calibrate_result *result, unsigned position);

/* The reading of a position kept, at the reference temperature. */
void calibrate_reading(const calibrate_result *result, unsigned kept, double out[3]);

/* When a position was taken, by the clock of the log or else by its number: from -1/2 at the first to 1/2
 * at the last; not finite, if they are one. */
double calibrate_tau(const positions *data, unsigned position);

/* The same of a time of the log, seconds. */
double calibrate_tau_at(const positions *data, double time);

/* The settings with the angles from the moves as a prior, if the solution is that of both. */
void calibrate_with_moves(const calibrate_result *result, fit_settings *with);

/* What the positions kept leave uncertain (at the reference temperature), for a noise of `unit`. */
void calibrate_spread(const calibrate_result *result, double unit, uncertainty *u);

/* 0 if the noise is unknown, neither stated nor from residuals: sigma then means nothing. */
int calibrate_knows_noise(const calibrate_result *result);

/* Ratio of the noise of a position mean to the stated one, or to that from the scatter of the
 * samples; 0: unknown. */
double calibrate_times(const calibrate_result *result);

/* The same where it is much; else 0. */
double calibrate_unexplained(const calibrate_result *result);

/* 1 if more than one position in six contradicts the others and is left out: whatever did that,
 * a knock or a step of an offset, has hardly spared the others. */
int calibrate_has_lost_many(const calibrate_result *result);

/* The residuals have more than twice the variance that the noise stated explains, and that is no
 * chance. */
int calibrate_is_disturbed(const calibrate_result *result);

/* The readings of the log have steps larger than their noise, and that explains the residuals. */
int calibrate_is_coarse(const calibrate_result *result);

/* Some direction is known far worse than so many positions could. */
int calibrate_is_uneven(const calibrate_result *result);

/* The field is gravity: people know it in g. */
int calibrate_is_gravity(const calibrate_result *result);

/* What the calibrated readings and the file's are in: "m/s²" or "field units"; "counts", ... */
const char *calibrate_field_unit(const calibrate_result *result);
const char *calibrate_input_unit(const calibrate_result *result);

/* The unit of lengths, offsets and residuals over the field, except in the report. */
display_unit calibrate_told_field(const calibrate_result *result);

/* What limits the accuracy: a sentence. Returns text. */
#define CALIBRATE_LIMIT_MAX 400
const char *calibrate_limit(const calibrate_result *result, const uncertainty *length,
                            char text[CALIBRATE_LIMIT_MAX]);

/* How the calibrated axes were turned to those of the case: a sentence. Returns text. Its member. */
const char *calibrate_case_text(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX]);
void calibrate_case_json(json_writer *w, const calibrate_result *result);

/* Of a magnetometer: what its samples were, lines of the table; why it may not be used, a sentence without
 * its subject, or null; and a member. */
void calibrate_waved_print(FILE *file, const calibrate_result *result);
const char *calibrate_waved_fault(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX]);
void calibrate_waved_json(json_writer *w, const calibrate_result *result);

/* How its axes are turned against those of the accelerometer next to it: sentences, or "" without one. Returns
 * text. */
#define CALIBRATE_AXES_MAX 800
const char *calibrate_axes_text(const calibrate_result *result, char text[CALIBRATE_AXES_MAX]);

/* What temperature does to the readings, if that was looked at and not asked for: a sentence, or
 * "". Returns text. */
const char *calibrate_advice(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX]);

/* One JSON object. */
void calibrate_json(FILE *file, const calibrate_result *result);

/* Members of the object that is open: deviations from nominal, null where nothing states it. */
void calibrate_parameters_json(json_writer *w, const calibrate_result *result,
                               const double x[INVCAL_PARAMETERS]);

/* What the user asked for that is not in the result. */
#define CALIBRATE_NAME_MAX 14u
typedef struct {
    const char *nominal_name; /* what the nominal is called, at most CALIBRATE_NAME_MAX bytes */
    const char *saved;        /* the file that the calibration goes to, or null */
    const char *report;       /* that of the report, or null */
    const char *command;      /* the command line, */
    const char *log;          /* and the log in it, "-" for the standard input */
} calibrate_wish;

/* Rows of the table (tabular.h), a line after it, and members of the object that is open: the nonlinearity that
 * was fitted, and the cross-check. */
void calibrate_nonlinear_rows(const calibrate_result *result);
void calibrate_nonlinear_json(json_writer *w, const calibrate_result *result);
void calibrate_robust_print(FILE *file, const calibrate_result *result);
void calibrate_robust_json(json_writer *w, const calibrate_result *result);

/* The table of slopes, and what they are good for. */
void calibrate_print_thermal(FILE *file, const calibrate_result *result);

/* A table for people, as wide as the stream shows. */
void calibrate_print(FILE *file, const calibrate_result *result, const calibrate_wish *wish);

#endif
