/* SPDX-License-Identifier: MIT
 *
 * report/facts.h: what the sections of the report share: figures of positions and directions, in
 * the units of the report.
 */
#ifndef REPORT_FACTS_H
#define REPORT_FACTS_H

#include "text/figure.h"
#include "draw/page.h"
#include "result/pass.h"
#include "result/result.h"
#include "result/uncertainty.h"

typedef struct {
    double up[3];  /* up in the calibrated frame, a unit vector */
    double length; /* of refused data only: relative to the mean of all */
    double before; /* |nominal calibration| - field, in the unit of lengths (report_facts.scale) */
    double after;  /* the same, calibrated */
    int is_left_out;
} report_position;

typedef struct {
    const calibrate_result *result;
    const calibrate_invocation *invocation;
    pass outcome;       /* of --need and --tolerance */
    int is_gravity;     /* the field is gravity, in m/s^2 */
    double scale;       /* lengths over the field are printed times this: 1e3 or 1e6 */
    const char *unit;   /* of lengths that are printed so */
    const char *length; /* symbol of the length of a reading */
    int has_before;     /* there is a nominal calibration, not only a guess from the range */
    int knows_noise;    /* else all ± are multiples of the noise of a position mean */
    double coverage;    /* ± / sigma, for 95 %; NaN if the noise is unknown */
    unsigned count;
    int has_up;                /* the up directions are known */
    report_position *position; /* count of them */
    sphere_mark *mark;         /* the same for the sphere, followed by the next direction */
    double noise;              /* of a position mean, in `unit`; 1 if unknown */
    uncertainty length_spread; /* ± of the calibrated length, from that noise */
    double length_worst; /* ± in the worst direction, with 1.96 sigma of parameters from a prior */
    double field_spread; /* ± of the field itself, not included in the above */
    double next[3];      /* the direction to measure next, in the calibrated frame */
    char next_words[INVCAL_TEXT_SIZE];
} report_facts;

#define REPORT_NORMAL 1.959964 /* ± / sigma for 95 %, if sigma is known exactly */

/* Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. To be released in either case. */
int report_facts_find(report_facts *f, const calibrate_result *result,
                      const calibrate_invocation *invocation);
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

/* Pictures in the sections of the positions and of the log. */
void report_histogram(page *p, const report_facts *f);
void report_lengths(page *p, const report_facts *f);

/* Facts in the last section: the file, and the command. */
void report_file(page *p, const report_facts *f);

/* A picture in the section of the stand: the unit on its two axes. `data` is not used. */
page_drawing report_stand_figure;

#endif
