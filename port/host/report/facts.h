/* SPDX-License-Identifier: MIT
 *
 * report/facts.h: what the sections of the report share: figures of every position and of every
 * direction, in units that people use.
 */
#ifndef REPORT_FACTS_H
#define REPORT_FACTS_H

#include "text/figure.h"
#include "draw/page.h"
#include "result/pass.h"
#include "result/result.h"
#include "result/uncertainty.h"

typedef struct {
    double up[3];  /* where up was, in the calibrated frame: unit vector */
    double length; /* of what was refused, over the mean of all */
    double before; /* |nominal calibration| - field, in the unit of lengths (report_facts.parts) */
    double after;  /* the same, calibrated */
    int is_left_out;
} report_position;

typedef struct {
    const calibrate_result *result;
    const calibrate_wish *wish;
    pass asked;         /* --need and --tolerance, and whether they are kept */
    int is_gravity;     /* the field is that of gravity, in m/s^2 */
    double parts;       /* of the field that lengths are printed in: thousandths or millionths, */
    const char *unit;   /* and what these are called */
    const char *length; /* symbol of the length of a reading */
    int has_before;     /* a nominal calibration that means something; else there is no before */
    int knows_noise;    /* else all ± are in multiples of the noise of a position mean */
    double coverage;    /* times sigma makes ±, what holds the truth in 95 % of cases; NaN: the
                           noise is not known */
    unsigned count;
    int has_up;                /* which way up was is known */
    report_position *position; /* count of them */
    sphere_mark *mark;         /* the same for the sphere, followed by the next one */
    double noise;              /* of a position mean, in these parts; 1 if not known */
    uncertainty length_spread; /* ± of the calibrated length, from the noise above */
    double
        length_worst; /* the same in the worst direction, with parameters from a prior on their own */
    double field_spread; /* and ± of the field itself, which is no part of that */
    double next[3];      /* the direction to take next, in the calibrated frame, */
    char next_words[INVCAL_WORDS];
} report_facts;

#define REPORT_NORMAL 1.959964 /* the same where sigma is known for sure */

/* EXIT_GOOD; EXIT_FILE, with a message, without memory. To be released in either case. */
int report_facts_find(report_facts *f, const calibrate_result *result, const calibrate_wish *wish);
void report_facts_release(report_facts *f);

/* The units of offsets (0), scale errors (1) and angles (2). */
display_unit report_unit(const report_facts *f, unsigned kind);

/* The sections, in this order. */
void report_use(page *p, const report_facts *f);
void report_parameters(page *p, const report_facts *f);
void report_positions(page *p, const report_facts *f);
void report_stand(page *p, const report_facts *f);
void report_temperature(page *p, const report_facts *f);
void report_gyro(page *p, const report_facts *f);
void report_gyro_summary(page *p, const report_facts *f); /* a sentence, under the verdict */
void report_sphere(page *p, const report_facts *f);
void report_timeline(page *p, const report_facts *f);
void report_numbers(page *p, const report_facts *f);

/* Pictures in those of the positions and of the log. */
void report_histogram(page *p, const report_facts *f);
void report_lengths(page *p, const report_facts *f);
/* Facts of the last section: the file that it was, and the command. */
void report_file(page *p, const report_facts *f);

/* A picture in that of the stand: the unit on its two axes. Data: nothing. */
page_drawing report_stand_figure;

#endif
