/* SPDX-License-Identifier: MIT
 *
 * result/result.h: the result of `invcal calibrate`, as table, sentences and JSON.
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
#include "read/log_rests.h"
#include "read/magnetometer_log.h"
#include "stand/stand.h"
#include "fit/thermal_fit.h"
#include "cli/unit_style.h"
#include "result/record.h"
#include "result/uncertainty.h"

/* How temperature was treated. */
typedef enum {
    CALIBRATE_PLAIN,  /* unknown, or not sufficient for a fit */
    CALIBRATE_PROBED, /* without --thermal: `fit` holds what --thermal 1 would find */
    CALIBRATE_THERMAL /* `fit` is the result; solution and quality are those at its reference */
} calibrate_temperature;

/* Why there is no calibration. Filled in by calibrate/refuse.h, reported by message, JSON and
 * page. */
#define REFUSAL_MAX 1000u
typedef struct {
    const char *word;         /* "too few", ...; null: not refused */
    char reason[REFUSAL_MAX]; /* what is wrong: a clause without a full stop */
    char remedy[REFUSAL_MAX]; /* what to do: the same; may be "" */
    uint16_t undetermined;    /* bit r: the positions do not determine parameter r */
    int is_of_position;       /* one reading is wrong: */
    unsigned position;        /* its position, from 0 */
    int wants_positions;      /* more positions would help */
    unsigned degree;          /* of the nonlinearity that they must also determine; 0: none */
} refusal;

typedef struct {
    refusal refused; /* if refused, only data, log, rejected, nominal and settings are valid */
    const positions *data;
    const rests_summary *log; /* the log that they were found in; null: a file of positions */
    const magnetometer_log *magnetometer; /* its log, whose cells are the positions; or null */
    rejection rejected;
    nominal_choice nominal;
    fit_settings settings;
    fit_solution solution;
    fit_quality quality;             /* its `worst` is a number among all positions */
    double limit[INVCAL_PARAMETERS]; /* of the parameters of a good sensor; NaN: not stated */
    int has_limits;                  /* at least one is stated */
    double field_sigma;              /* of the field, relative; included in sigma of the scales */
    int is_field_stated;             /* by --gravity or --latitude */
    reading_unit field_unit;         /* as stated */
    double accuracy;        /* of lengths over the field, 95 %, without the error of the field */
    double need;            /* --need, field units; 0: none */
    display_unit need_unit; /* the unit that it was stated in */
    int is_drift_fitted;    /* the calibration is that of the middle of the session */
    double drift[3];        /* from the first position to the last, over the field */
    double drift_sigma[3];
    unsigned degree; /* of the fitted nonlinearity, not in the calibration; 0: none */
    double nonlinear[NONLINEARITY_TERMS]; /* x y z quadratic, x y z cubic, over the field */
    double nonlinear_sigma[NONLINEARITY_TERMS];
    int is_robust_wanted; /* --robust: cross-check by the l1 estimate of all positions */
    int has_robust;       /* there is such an estimate */
    double robust[INVCAL_PARAMETERS];
    double robust_max;      /* largest difference from it, over that expected from noise */
    unsigned robust_worst;  /* the parameter with that difference */
    int is_noise_given;     /* by --noise, not from the scatter of the samples */
    double residual_before; /* root mean square of |nominal calibration| / field - 1 */
    calibrate_temperature temperature;
    thermal_fit fit;
    stand stand;           /* results from the angles of a stand, if requested */
    int is_stand_frame;    /* the calibration is turned to the axes of the stand */
    case_frame frame;      /* the calibration is turned to the axes of the case, if used > 0 */
    int is_field_measured; /* settings.field is the mean length of a magnetometer's readings */
    dip_frame dip;         /* results from the accelerometer next to a magnetometer */
    int is_dip_frame;      /* the calibration is turned to the axes of that accelerometer */
    gyro_fit gyro;         /* the gyroscope, if there is one */
    int is_joint;     /* the solution is that of rests and moves, as rests alone do not suffice */
    unit_style units; /* units of table and report */
    record record;
    const double *place; /* latitude and height that the field follows from; null: it was stated */
} calibrate_result;

/* 1 if slopes were requested but not fitted, over a range of temperature that needs them. More
 * positions at the same temperatures do not help. */
int calibrate_lacks_slopes(const calibrate_result *result);

/* The factor of the slope of a parameter to show: 1; if no nominal scale is stated, the one that
 * refers the slope to the sensor's own scale. */
double calibrate_slope_scale(const calibrate_result *result, unsigned parameter);

/* The name of the frame: "symmetric", ... */
const char *calibrate_frame(const calibrate_result *result);

/* The calibration at the temperature of a position. */
invcal_calibration calibrate_at_position(const calibrate_result *result, unsigned position);

/* The calibration at a temperature. */
invcal_calibration calibrate_at_temperature(const calibrate_result *result, double temperature);

/* Removes the fitted drift from a reading at `tau`. */
void calibrate_remove_drift(const calibrate_result *result, double tau, double reading[3]);

/* The mean reading of a position without the fitted drift and nonlinearity. */
void calibrate_linear_reading(const calibrate_result *result, unsigned position, double out[3]);

/* Excess of the length at a position, over the field: its residual if it was kept, its error if it
 * was left out. */
double calibrate_excess(const calibrate_result *result, unsigned position);

/* The mean reading of a position that was kept, converted to the reference temperature. */
void calibrate_reference_reading(const calibrate_result *result, unsigned kept, double out[3]);

/* The time of a position, by the clock of the log or else its number, from -1/2 at the first to 1/2
 * at the last; not finite if there is only one. */
double calibrate_tau(const positions *data, unsigned position);

/* The same for a time of the log, seconds. */
double calibrate_tau_at(const positions *data, double time);

/* The settings, with the angles from the moves as a prior if is_joint. */
void calibrate_with_moves(const calibrate_result *result, fit_settings *with);

/* The uncertainty of lengths (at the reference temperature) from the positions kept, for a noise of
 * `unit`. */
void calibrate_uncertainty(const calibrate_result *result, double unit, uncertainty *u);

/* 0 if the noise is unknown, neither stated nor from residuals: then sigma is meaningless. */
int calibrate_knows_noise(const calibrate_result *result);

/* Ratio of the noise of a position mean, from the residuals, to the stated one or that from the
 * scatter of the samples; 0: unknown. */
double calibrate_noise_ratio(const calibrate_result *result);

/* The same if it is 3 or more; else 0. */
double calibrate_unexplained(const calibrate_result *result);

/* 1 if more than one position in six contradicts the others and is left out: the cause, such as a
 * knock or a step of an offset, probably affected the others too. */
int calibrate_many_left_out(const calibrate_result *result);

/* 1 if the residuals have more than twice the variance that the stated noise explains,
 * significantly. */
int calibrate_is_disturbed(const calibrate_result *result);

/* 1 if the readings have steps larger than their noise, which explain the residuals. */
int calibrate_is_coarse(const calibrate_result *result);

/* 1 if the uncertainty in the worst direction is far above that of as many well-spread
 * positions. */
int calibrate_is_uneven(const calibrate_result *result);

/* 1 if the field is gravity, so that figures can be in g. */
int calibrate_is_gravity(const calibrate_result *result);

/* The units of calibrated readings, "m/s²" or "field units", and of those of the file, "counts",
 * ... */
const char *calibrate_field_unit(const calibrate_result *result);
const char *calibrate_input_unit(const calibrate_result *result);

/* The unit of lengths, offsets and residuals over the field in the table. */
display_unit calibrate_display_unit(const calibrate_result *result);

/* What limits the accuracy: a sentence. Returns text. */
#define CALIBRATE_LIMIT_MAX 400
const char *calibrate_limit(const calibrate_result *result, const uncertainty *length,
                            char text[CALIBRATE_LIMIT_MAX]);

/* How the calibrated axes were turned to those of the case: a sentence. Returns text. And the
 * member of JSON. */
const char *calibrate_case_text(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX]);
void calibrate_case_json(json_writer *w, const calibrate_result *result);

/* Of a magnetometer: lines of the table about its samples; a sentence about what is wrong; and the
 * member of JSON. */
void calibrate_magnetometer_print(FILE *file, const calibrate_result *result);
const char *calibrate_magnetometer_fault(const calibrate_result *result,
                                         char text[CALIBRATE_LIMIT_MAX]);
void calibrate_magnetometer_json(json_writer *w, const calibrate_result *result);

/* The rotation of its axes relative to those of the accelerometer in the same log: sentences; ""
 * without one. Returns text. */
#define CALIBRATE_AXES_MAX 800
const char *calibrate_axes_text(const calibrate_result *result, char text[CALIBRATE_AXES_MAX]);

/* The effect of temperature if CALIBRATE_PROBED: a sentence; else "". Returns text. */
const char *calibrate_temperature_advice(const calibrate_result *result,
                                         char text[CALIBRATE_LIMIT_MAX]);

/* One JSON object. */
void calibrate_json(FILE *file, const calibrate_result *result);

/* Writes members: deviations from nominal, null where that is not stated. */
void calibrate_parameters_json(json_writer *w, const calibrate_result *result,
                               const double x[INVCAL_PARAMETERS]);

/* What table and report show of the command line. */
#define CALIBRATE_NAME_MAX 14u
typedef struct {
    const char *nominal_name; /* heading of the nominal column, at most CALIBRATE_NAME_MAX bytes */
    const char *saved;        /* --out, or null */
    const char *report;       /* --report, or null */
    const char *command;      /* the command line */
    const char *log;          /* LOG in it; "-" is the standard input */
} calibrate_invocation;

/* The nonlinearity that was fitted, and the cross-check: rows of the table (tabular.h), a line
 * after it, members of JSON. */
void calibrate_nonlinear_rows(const calibrate_result *result);
void calibrate_nonlinear_json(json_writer *w, const calibrate_result *result);
void calibrate_robust_print(FILE *file, const calibrate_result *result);
void calibrate_robust_json(json_writer *w, const calibrate_result *result);

/* The table of slopes over temperature, and their effect on the residuals. */
void calibrate_print_thermal(FILE *file, const calibrate_result *result);

/* The table, as wide as the terminal. */
void calibrate_print(FILE *file, const calibrate_result *result,
                     const calibrate_invocation *invocation);

#endif
