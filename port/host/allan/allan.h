/* SPDX-License-Identifier: MIT
 *
 * allan/allan.h: the result of `invcal allan`, and its output as text, JSON and a page.
 */
#ifndef ALLAN_H
#define ALLAN_H

#include <stdio.h>

#include "read/columns.h"
#include "allan/noise.h"

#define ALLAN_MICRO_G (1e-6 * UNIT_STANDARD_GRAVITY) /* m/s^2 */

/* From the command line. */
typedef struct {
    const char *file;
    double rate;   /* samples per second; 0: unknown */
    unsigned taus; /* of --tau; 0: octaves */
    double tau[INVCAL_ALLAN_TAUS];
    int is_apart;        /* windows do not overlap: one begins where another ends */
    double sigma;        /* required, of a position mean; 0: unknown */
    double lsb;          /* field units per input unit; 0: unknown */
    double gravity;      /* length of the field; 0: unknown */
    reading_unit unit;   /* of the readings, from --unit */
    double from, to;     /* seconds from the first sample */
    const char *command; /* the command line, for the report */
} allan_settings;

/* One averaging time. */
typedef struct {
    double seconds;
    uint32_t count; /* differences */
    double edf;
    double relative; /* standard deviation of adev, over it */
    double adev[3];  /* units of the result */
} allan_row;

/* What limits a dwell. */
typedef enum {
    ALLAN_REACHED, /* as invcal_dwell_end */
    ALLAN_BEYOND,
    ALLAN_FLOOR,
    ALLAN_LONGEST /* no sigma is required, and there is no floor: the longest averaging time */
} allan_end;

typedef struct {
    double seconds;
    double sigma; /* of the mean after that time */
    allan_end end;
    unsigned limit; /* the kind of noise that contributes most to it */
} allan_dwell;

typedef struct {
    const char *name; /* of the file */
    uint64_t bytes;
    uint32_t crc;
    recognition seen;
    int is_ms2;       /* results are in m/s^2 */
    double rate_unit; /* of a gyroscope: rad/s per unit of the results; 0: unknown, or not one */
    const char *unit; /* of the results, for output */
    double gravity;   /* length of the field in that unit; NaN: unknown */
    double rate;
    double from, to; /* seconds from the first sample: the part used */
    unsigned long samples;
    unsigned long gaps;
    allan_row row[INVCAL_ALLAN_TAUS];
    unsigned rows;
    invcal_noise noise[3];
    allan_dwell dwell[3];
    unsigned worst; /* the axis that sets the dwell */
} allan_result;

/* Reads a log at rest. EXIT_GOOD; with a message EXIT_FILE, EXIT_USAGE (the rate is unknown, or
 * --tau is not a multiple of its interval), EXIT_DATA (it moves, or is too short). */
int allan_read(allan_result *r, const allan_settings *settings);

/* ---- words ------------------------------------------------------------------------------------ */

#define ALLAN_WORDS_MAX 400

extern const char *const allan_kinds[INVCAL_NOISE_KINDS]; /* "white noise", ... */

/* The estimator: "overlapping", "windows apart". */
const char *allan_estimator(const allan_settings *settings);

/* A deviation with its unit, in µg if possible: "12.3 µg". Returns text. */
const char *allan_deviation(const allan_result *r, double deviation, char text[ALLAN_WORDS_MAX]);

/* The lines of the table of noise components. */
typedef struct {
    const char *name;
    const char *unit; /* for results in m/s^2; else null, and `power` follows the result's unit */
    const char *power;
    unsigned kind;
    double scale; /* units of the result */
} allan_line;
#define ALLAN_LINES 7u
extern const allan_line allan_lines[ALLAN_LINES];

/* 1 if the line applies to this result. */
int allan_has_line(const allan_result *r, const allan_line *line);

/* "white noise N, µg/√Hz". Returns text. */
const char *allan_label(const allan_result *r, const allan_line *line, char text[ALLAN_WORDS_MAX]);

/* The coefficient of an axis, "99.8 ± 0.5" or "not visible". Returns text. */
const char *allan_coefficient(const allan_result *r, const allan_line *line, unsigned axis,
                              char text[ALLAN_WORDS_MAX]);

/* The conclusion: how long to hold each position, and what limits it; and what to do next. Both
 * return text. */
const char *allan_advice(const allan_result *r, const allan_settings *settings,
                         char text[ALLAN_WORDS_MAX]);
const char *allan_next(const allan_result *r, char text[ALLAN_WORDS_MAX]);

/* The axes that the three kinds of noise do not explain, "x z"; "" if they do. Returns text. */
const char *allan_misfits(const allan_result *r, char text[ALLAN_WORDS_MAX]);
extern const char allan_misfit_words[];

/* ---- reports ----------------------------------------------------------------------------------- */

void allan_print(FILE *file, const allan_result *r, const allan_settings *settings);
void allan_json(FILE *file, const allan_result *r, const allan_settings *settings);
void allan_report(FILE *file, const allan_result *r, const allan_settings *settings);

/* The chart of deviations against averaging time, as a part of a page. */
void allan_chart(FILE *file, const allan_result *r, double width);

#endif
