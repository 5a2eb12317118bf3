/* SPDX-License-Identifier: MIT
 *
 * compare/compare.h: comparison of calibrations: drift of a device since its previous and since its
 * first one, and outliers among devices.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include <stdint.h>
#include <stdio.h>

#include "cli/unit_style.h"
#include "result/calibration_file.h"

#define COMPARE_FALSE_ALARM 0.05 /* for all nine parameters, and all devices, together */
#define COMPARE_FLEET_MIN 3u     /* devices needed to find an outlier */
#define COMPARE_NAME_MAX 256
#define COMPARE_TEXT_MAX 1600

/* One file. Parameters p: offsets (0 ... 2, input units), scales (3 ... 5, input units per field unit),
 * angles off square (6 ... 8, rad). */
typedef struct {
    const char *path;
    record record;
    char verdict[CALIBRATION_FILE_WORD];
    double x[INVCAL_PARAMETERS];
    double sigma[INVCAL_PARAMETERS]; /* NaN: unknown */
    double field_sigma[3];           /* the part of the sigma of scales that is due to the field */
    unsigned dof;                    /* degrees of freedom of sigma */
    unsigned device;                 /* from 0, in the order of the arguments */
    unsigned argument;               /* position of the file among the arguments, from 0 */
} compare_item;

/* From one calibration to a later one of the same device: deviations as in invcal calibrate, with
 * the older one as nominal. */
typedef struct {
    const compare_item *before;
    const compare_item *now;
    double x[INVCAL_PARAMETERS]; /* offsets over the field, scale errors, angles (rad) */
    double sigma[INVCAL_PARAMETERS];
    double half_width[INVCAL_PARAMETERS]; /* of the 95 % interval of x */
    double in_sigma[INVCAL_PARAMETERS];   /* x over sigma */
    double chance[INVCAL_PARAMETERS]; /* of at least that much if nothing changed; NaN: unknown */
    uint16_t changed;                 /* bit p: significantly */
} compare_drift;

/* The calibrations of one device, oldest first. */
typedef struct {
    unsigned first; /* item */
    unsigned count;
    int is_dated;        /* all have a date: in the order of these, else of the arguments */
    compare_drift whole; /* from the first to the newest; of three or more: small steps add up */
} compare_device;

/* Statistics of the x of all devices, from their newest calibrations. */
typedef struct {
    double median[INVCAL_PARAMETERS];
    double spread[INVCAL_PARAMETERS];     /* robust standard deviation: 1.4826 times the median of
                                             |x - median| */
    double deviation[INVCAL_PARAMETERS];  /* standard deviation */
    unsigned farthest[INVCAL_PARAMETERS]; /* device that is farthest from the median */
    uint16_t *outliers;                   /* of each device, bit p: it is one in parameter p */
} compare_fleet;

typedef struct {
    compare_item *item; /* sorted by device, then oldest first */
    unsigned count;
    compare_device *device;
    unsigned devices;
    compare_drift *drift; /* to each item from the previous one of its device, if there is one */
    compare_fleet fleet;  /* of two devices or more */
    double field;         /* length of the field of the first file: the unit of offsets */
    int is_gravity;       /* the field is gravity in m/s^2 */
    char unit[CALIBRATION_FILE_WORD];
    int is_same_field; /* sigma excludes the uncertainty of the field */
    unit_style units;
    const char *command; /* the command line */
} compare_result;

/* How files belong to devices: by serial number; all to one; each to its own. */
typedef enum { COMPARE_BY_SERIAL, COMPARE_HISTORY, COMPARE_FLEET } compare_grouping;

/* ---- parameters.c: from a file to nine parameters ---- */

/* Fills x, sigma, of_field and dof. */
void compare_parameters(const calibration_file *file, const invcal_calibration *calibration,
                        compare_item *item);

/* The divisor that makes a difference of parameter p a deviation from this nominal: the field in
 * input units, the scale, or 1. */
double compare_divisor(const double nominal[INVCAL_PARAMETERS], double field, unsigned p);

/* ---- set.c: from paths to items ---- */

/* Reads the files, checks that they can be compared, and sorts them. Release the result even after
 * a failure. Returns EXIT_GOOD; EXIT_FILE, EXIT_USAGE, with a message; EXIT_DATA, with a message
 * and, if `json`, an object on stdout: they cannot be compared. */
int compare_read(compare_result *r, const char *const *paths, compare_grouping grouping, int json);
void compare_release(compare_result *r);

/* ---- drift.c, fleet.c: the arithmetic ---- */

/* `tests`: how many such comparisons share the false alarms: 1, or 2 with compare_device.whole. */
compare_drift compare_drift_of(const compare_item *before, const compare_item *now, double field,
                               unsigned tests);

/* Finds the outliers among n values, 3 or more: Rosner's generalised ESD test, at most a quarter of
 * them.
 *
 * which  their indices, the farthest first; n elements.
 *
 * Returns their number; for normally distributed values it is above 0 in a part `alarm` of all
 * cases. */
unsigned compare_outliers(const double *x, unsigned n, double alarm, unsigned *which);

/* Computes r->fleet. Returns 0 if there is not enough memory. */
int compare_fleet_find(compare_result *r);

/* Fills r->drift and r->device[].whole. */
void compare_drifts_find(compare_result *r);

/* The newest calibration of a device. */
const compare_item *compare_newest(const compare_result *r, unsigned device);

/* ---- words.c ---- */

/* Units of drifts and deviations of parameter p, and of its values. */
display_unit compare_drift_unit(const compare_result *r, unsigned p);
display_unit compare_page_unit(const compare_result *r, unsigned p); /* the same with ° */
display_unit compare_value_unit(const compare_result *r, unsigned p, char name[COMPARE_NAME_MAX]);

/* The first characters of a text for output: an ellipsis shows that it was cut, and control
 * characters are replaced by '?'. Returns text. */
const char *compare_cut(const char *from, unsigned columns, char text[COMPARE_NAME_MAX]);

/* The different serial numbers of a device's calibrations, as a list. Returns how many. */
unsigned compare_serials(const compare_result *r, unsigned device, char text[COMPARE_NAME_MAX]);

/* "serial 47", or the name of the newest file; of `columns` characters at most. Returns text. */
const char *compare_device_name(const compare_result *r, unsigned device, unsigned columns,
                                char text[COMPARE_NAME_MAX]);
const char *compare_file_name(const compare_item *item, unsigned columns,
                              char text[COMPARE_NAME_MAX]);

/* The number of a calibration in the history of its device, from 1. */
unsigned compare_number(const compare_result *r, const compare_item *item);

/* The date of an item, or "". */
const char *compare_date(const compare_item *item);

/* Whether a device has changed since its previous or since its first calibration. */
int compare_has_changed(const compare_result *r, unsigned device);

/* The verdict. */
typedef enum { COMPARE_STEADY, COMPARE_UNKNOWN, COMPARE_DIFFERENT } compare_outcome;
compare_outcome compare_verdict(const compare_result *r);
const char *compare_verdict_word(const compare_result *r);
const char *compare_sentence(const compare_result *r, char text[COMPARE_TEXT_MAX]);
const char *compare_next(const compare_result *r);

/* The criteria of these decisions, in words. */
const char *compare_drift_rule(void);
const char *compare_fleet_rule(void);

/* The largest contribution of the field to the sigma of a scale, over the scale, if it is more than
 * half of that sigma; else 0. */
double compare_field_part(const compare_result *r);

/* ---- print.c, json.c, report.c, chart.c ---- */

void compare_print(FILE *file, const compare_result *r); /* 80 columns at most */
void compare_json(FILE *file, const compare_result *r);
void compare_report(FILE *file, const compare_result *r);

/* The data of a picture. */
typedef struct {
    const compare_result *result;
    unsigned device; /* of a history, */
    unsigned kind;   /* and which of its parameters: offsets (0), scales (1), angles (2) */
} compare_picture;
void compare_draw_history(FILE *file, const void *picture, double width);
void compare_draw_fleet(FILE *file, const void *picture, double width);

#endif
