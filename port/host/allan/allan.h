/* SPDX-License-Identifier: MIT
 *
 * allan/allan.h: what `invcal allan` has found, and the ways to report it.
 */
#ifndef ALLAN_H
#define ALLAN_H

#include <stdio.h>

#include "read/columns.h"
#include "invcal/allan.h"

#define ALLAN_MICRO_G (1e-6 * UNIT_STANDARD_GRAVITY) /* m/s^2 */

/* What the command line asks for. */
typedef struct {
    const char *file;
    double rate;   /* samples per second; 0: unknown */
    unsigned taus; /* of --tau; 0: octaves */
    double tau[INVCAL_ALLAN_TAUS];
    int is_apart;        /* one window begins where another ends; else they overlap */
    double sigma;        /* of a position mean that is wanted; 0: unknown */
    double lsb;          /* field units per input unit; 0: unknown */
    double gravity;      /* length of the field; 0: unknown */
    reading_unit unit;   /* of the readings, from --unit */
    double from, to;     /* seconds from the first sample */
    const char *command; /* the command line, for the report */
} allan_wish;

/* One averaging time; what all axes share, and sigma. */
typedef struct {
    double seconds;
    uint32_t count; /* differences */
    double edf;
    double relative; /* standard deviation of adev, over it */
    double adev[3];  /* units of the result */
} allan_row;

/* How a dwell has been found. */
typedef enum {
    ALLAN_REACHED, /* as invcal_dwell_end */
    ALLAN_BEYOND,
    ALLAN_FLOOR,
    ALLAN_LONGEST /* nothing was wanted and no floor is in sight: the longest time seen */
} allan_end;

typedef struct {
    double seconds;
    double sigma; /* of the mean after that time */
    allan_end end;
    unsigned limit; /* the kind of noise that has the largest part in it */
} allan_dwell;

typedef struct {
    const char *name; /* of the file */
    uint64_t bytes;
    uint32_t crc;
    recognition seen;
    int is_ms2;       /* results are in m/s^2; */
    double rate_unit; /* or rad/s in their unit, of a gyroscope; 0: not known, or of another */
    const char *unit; /* their unit for people */
    double gravity;   /* length of the field in that unit; NaN: not known */
    double rate;
    double from, to; /* seconds from the first sample, of what was used */
    unsigned long samples;
    unsigned long gaps;
    allan_row row[INVCAL_ALLAN_TAUS];
    unsigned rows;
    invcal_noise noise[3];
    allan_dwell dwell[3];
    unsigned worst; /* the axis that sets the dwell */
} allan_result;

/* Reads a log at rest. EXIT_GOOD; with a message EXIT_FILE, EXIT_USAGE (the rate is not known, or
 * --tau does not go with it), EXIT_DATA (it moves, or is too short). */
int allan_read(allan_result *r, const allan_wish *wish);

/* ---- words ------------------------------------------------------------------------------------ */

#define ALLAN_WORDS_MAX 400

extern const char *const allan_kinds[INVCAL_NOISE_KINDS]; /* "white noise", ... */

/* The estimator: "overlapping", "windows apart". */
const char *allan_estimator(const allan_wish *wish);

/* A deviation with its unit, in µg where that is known: "12.3 µg". Returns text. */
const char *allan_deviation(const allan_result *r, double deviation, char text[ALLAN_WORDS_MAX]);

/* What the noise is made of, line by line. */
typedef struct {
    const char *name;
    const char *unit; /* of a result in m/s^2; else null, and `power` follows the result's unit */
    const char *power;
    unsigned kind;
    double scale; /* units of the result */
} allan_line;
#define ALLAN_LINES 7u
extern const allan_line allan_lines[ALLAN_LINES];

/* 1 if the line has a meaning for this result. */
int allan_has_line(const allan_result *r, const allan_line *line);

/* "white noise N, µg/√Hz". Returns text. */
const char *allan_label(const allan_result *r, const allan_line *line, char text[ALLAN_WORDS_MAX]);

/* The coefficient of an axis, "99.8 ± 0.5" or "not visible". Returns text. */
const char *allan_coefficient(const allan_result *r, const allan_line *line, unsigned axis,
                              char text[ALLAN_WORDS_MAX]);

/* What it comes to: how long to hold each position, and what limits it. Both return text. */
const char *allan_advice(const allan_result *r, const allan_wish *wish, char text[ALLAN_WORDS_MAX]);
const char *allan_next(const allan_result *r, char text[ALLAN_WORDS_MAX]);

/* The axes that the three kinds of noise do not explain, "x z"; "" if they do. Returns text. */
const char *allan_misfits(const allan_result *r, char text[ALLAN_WORDS_MAX]);
extern const char allan_misfit_words[];

/* ---- reports ----------------------------------------------------------------------------------- */

void allan_print(FILE *file, const allan_result *r, const allan_wish *wish);
void allan_json(FILE *file, const allan_result *r, const allan_wish *wish);
void allan_report(FILE *file, const allan_result *r, const allan_wish *wish);

/* The chart of deviations against averaging time, as a part of a page. */
void allan_chart(FILE *file, const allan_result *r, double width);

#endif
