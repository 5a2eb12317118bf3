/* SPDX-License-Identifier: MIT
 *
 * compare/compare.h: several calibrations next to each other: what has changed since the last of the same
 * device, and which device differs from the others.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include <stdint.h>
#include <stdio.h>

#include "cli/unit_style.h"
#include "result/calibration_file.h"

#define COMPARE_FALSE_ALARM 0.05 /* of all nine parameters, and of all devices, together */
#define COMPARE_FLEET_LEAST 3u   /* devices needed to find an outlier */
#define COMPARE_NAME_MAX 256
#define COMPARE_TEXT_MAX 1600

/* One file. Parameters p: offsets (0 ... 2, input units), scales (3 ... 5, input units per field unit),
 * angles off square (6 ... 8, rad). */
typedef struct {
    const char *path;
    record record;
    char verdict[CALIBRATION_FILE_WORD];
    double x[INVCAL_PARAMETERS];
    double sigma[INVCAL_PARAMETERS]; /* NaN: not known */
    double of_field[3];              /* the part of sigma of the scales that stems from the field */
    unsigned dof;                    /* degrees of freedom behind sigma */
    unsigned device;                 /* whose it is, from 0 in the order in which they came */
    unsigned place;                  /* of the file among the arguments, from 0 */
} compare_item;

/* All of one device, first the oldest. */
typedef struct {
    unsigned first; /* item */
    unsigned count;
    int is_dated; /* each has a date, which gives the order; else that of the arguments */
} compare_device;

/* From one calibration to the next of the same device: deviations as in invcal calibrate, with the
 * older one for nominal. */
typedef struct {
    double x[INVCAL_PARAMETERS]; /* offsets over the field, scale errors, angles (rad) */
    double sigma[INVCAL_PARAMETERS];
    double wide[INVCAL_PARAMETERS];  /* half of the interval that holds x in 95 % of cases */
    double times[INVCAL_PARAMETERS]; /* x over sigma */
    double chance
        [INVCAL_PARAMETERS]; /* of as much or more where nothing has changed; NaN: not known */
    uint16_t changed;        /* bit p: beyond chance */
} compare_drift;

/* The newest calibrations of all devices: figures of x. */
typedef struct {
    double median[INVCAL_PARAMETERS];
    double
        spread[INVCAL_PARAMETERS]; /* 1.4826 times the median of |x - median|: a standard deviation
                                            that some devices cannot spoil */
    double deviation[INVCAL_PARAMETERS];  /* the usual one */
    unsigned farthest[INVCAL_PARAMETERS]; /* device that is farthest from the median */
    uint16_t *outside;                    /* of each device, bit p */
} compare_fleet;

typedef struct {
    compare_item *item; /* by devices, each by age */
    unsigned count;
    compare_device *device;
    unsigned devices;
    compare_drift
        *drift; /* to each item, from the one before of the same device; the first has none */
    compare_fleet fleet; /* of two devices or more */
    double field;        /* length of the field of the first file: offsets are over that, */
    int is_gravity;      /* which is gravity in m/s^2 */
    char unit[CALIBRATION_FILE_WORD];
    int is_same_field; /* what the field may be wrong by is no part of sigma */
    unit_style units;
    const char *command; /* the command line */
} compare_result;

/* What the files are to each other: by their serial numbers, or as somebody says. */
typedef enum { COMPARE_BY_SERIAL, COMPARE_HISTORY, COMPARE_FLEET } compare_kinship;

/* ---- nine.c: from a file to nine parameters ---- */

/* Fills x, sigma, of_field and dof. */
void compare_nine(const calibration_file *file, const invcal_calibration *calibration,
                  compare_item *item);

/* What a difference of parameter p is divided by, to be a deviation from this nominal: the field in input
 * units, the scale, 1. */
double compare_per(const double nominal[INVCAL_PARAMETERS], double field, unsigned p);

/* ---- set.c: from paths to items ---- */

/* Reads the files, checks that they can be compared, and sets them in order. To be released in either
 * case. Returns EXIT_GOOD; EXIT_FILE, EXIT_USAGE, with a message; EXIT_DATA, with a message and, if `json`,
 * an object on stdout: they cannot be compared. */
int compare_read(compare_result *r, const char *const *paths, compare_kinship kinship, int json);
void compare_release(compare_result *r);

/* ---- drift.c, fleet.c: the arithmetic ---- */

compare_drift compare_drift_of(const compare_item *before, const compare_item *now, double field);

/* Which of n figures, 3 or more, stand outside: Rosner's generalised ESD test, at most a quarter of them.
 *
 * who  their numbers, the farthest first; room for n.
 *
 * Returns how many; with a normal family there are any in `alarm` of all cases. */
unsigned compare_outside(const double *x, unsigned n, double alarm, unsigned *who);

/* Finds the fleet. Returns 0 without memory. */
int compare_fleet_find(compare_result *r);

/* The newest calibration of a device. */
const compare_item *compare_newest(const compare_result *r, unsigned device);

/* ---- words.c ---- */

/* Units of drifts and deviations of parameter p, and of its values themselves. */
display_unit compare_drift_unit(const compare_result *r, unsigned p);
display_unit compare_page_unit(const compare_result *r, unsigned p); /* the same with ° */
display_unit compare_value_unit(const compare_result *r, unsigned p, char name[COMPARE_NAME_MAX]);

/* The first characters of a text for people: what is cut ends with an ellipsis, and what no terminal should get
 * is '?'. Returns text. */
const char *compare_cut(const char *from, unsigned columns, char text[COMPARE_NAME_MAX]);

/* "serial 47", or the name of the file; of `columns` characters at most. Returns text. */
const char *compare_device_name(const compare_item *item, unsigned columns,
                                char text[COMPARE_NAME_MAX]);
const char *compare_file_name(const compare_item *item, unsigned columns,
                              char text[COMPARE_NAME_MAX]);

/* The date of an item, or "". */
const char *compare_date(const compare_item *item);

/* What it comes to. */
typedef enum { COMPARE_STEADY, COMPARE_UNKNOWN, COMPARE_STANDS_OUT } compare_outcome;
compare_outcome compare_judge(const compare_result *r);
const char *compare_word(const compare_result *r);
const char *compare_sentence(const compare_result *r, char text[COMPARE_TEXT_MAX]);
const char *compare_next(const compare_result *r);

/* The rules of these decisions. */
const char *compare_drift_rule(void);
const char *compare_fleet_rule(void);

/* The largest part of the field in sigma of a scale, if it is more than half of that; else 0. */
double compare_field_part(const compare_result *r);

/* ---- print.c, json.c, report.c, chart.c ---- */

void compare_print(FILE *file, const compare_result *r); /* 80 columns at most */
void compare_json(FILE *file, const compare_result *r);
void compare_report(FILE *file, const compare_result *r);

/* Pictures of a page: what they are of. */
typedef struct {
    const compare_result *result;
    unsigned device; /* of a history, */
    unsigned kind;   /* and which of its parameters: offsets (0), scales (1), angles (2) */
} compare_picture;
void compare_draw_history(FILE *file, const void *picture, double width);
void compare_draw_fleet(FILE *file, const void *picture, double width);

#endif
