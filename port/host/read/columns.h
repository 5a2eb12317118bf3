/* SPDX-License-Identifier: MIT
 *
 * read/columns.h: which column of a table means what, by its header or by the number of columns.
 */
#ifndef COLUMNS_H
#define COLUMNS_H

#include <stddef.h>

#include "read/column.h"
#include "read/heading.h"
#include "read/table.h"

/* What a heading with an axis is of. */
typedef enum {
    OF_NOTHING, /* what nobody knows */
    OF_GYROSCOPE,
    OF_MAGNETOMETER,
    OF_ANYTHING, /* x, y and z alone */
    OF_ACCELEROMETER
} columns_origin;

/* What was recognised, to be printed; the table is no longer needed. */
typedef struct {
    const char *separator;     /* "commas", ... */
    unsigned long header_line; /* 0: none */
    unsigned long preamble;    /* lines of `name, value` before it */
    unsigned long unit_line;   /* a row of units; 0: none */
    int is_magnetometer;       /* one was asked for */
    columns_origin of;         /* what the headings of x, y and z say; without them nothing */
    char set_aside[HEADING_NAME_MAX]; /* x of the other one, of a magnetometer or accelerometer;
                                       * empty: none */
    char gyro[3][HEADING_NAME_MAX];   /* of a gyroscope, as in the header; empty: there is none */
    double turn; /* rad/s in one of its units, if the headings state it; else 0 */
    int is_gyro; /* x, y and z themselves are those of a gyroscope; `turn` is theirs */
    char chosen[COLUMNS_CHOICE_MAX]; /* by --columns, as it was stated; empty: it was not */
    unsigned others;                 /* columns that have a heading, but are ignored */
    int states_foreign_unit;         /* the headings state a unit that unit.h does not know */
    reading_unit unit;               /* of x, y and z */
    unit_origin unit_from;           /* header or none; who knows more may put it in */
    const char *time_unit;           /* "s", "ms", "µs", "ns" */
    char name[COLUMN_COUNT][HEADING_NAME_MAX]; /* as in the header; empty: there is none */
} recognition;

/* For each meaning the index into table.field, or -1. */
typedef struct {
    int index[COLUMN_COUNT];
    int aside[3];      /* of the accelerometer next to a magnetometer, or -1: */
    int gyro[3];       /* the same of a gyroscope's x y z; -1: there is none, or it is not wanted */
    int last;          /* the greatest of them */
    double per_second; /* units of the time column in a second */
    temperature_unit degrees; /* of the temperature column */
    double per_degree[2];     /* units of the columns alpha and beta in a degree */
    int instance;             /* column that numbers the sensor of each row, or -1 */
    char first_instance[8];
    recognition seen;
} columns;

/* How the columns of a table without a header are understood. */
typedef enum {
    COLUMNS_POSITIONS, /* x y z; x y z std n; x y z std_x std_y std_z n */
    COLUMNS_LOG,       /* x y z; t x y z; t x y z temperature; the first two also with the three of
                           a gyroscope behind, which are ignored, */
    COLUMNS_IMU,       /* or not */
    COLUMNS_GYRO,      /* x y z are those of a gyroscope */
    COLUMNS_MAGNETOMETER /* as a log; of two sensors that a header names the magnetometer */
} columns_kind;

/* Names that a header may use, for help texts. */
#define COLUMNS_NAMES                                                                              \
    "  x y z (or ax ay az, acc_x .., AccX .., \"Acceleration x\" .., accSmooth[0] ..,\n"           \
    "  accelerometer_m_s2[0] .., xyz[0] .., mx my mz, mag_x .., mean_x ..);\n"                     \
    "  std or std_x std_y std_z; n, n_samples or count; t, time or timestamp;\n"                   \
    "  temperature or temp; alpha and beta. A unit may follow: ax (g), ax [m/s^2], acc_x_mg,\n"    \
    "  time (us), t_ms, temp (K). Case does not matter. Other columns are ignored, as are\n"       \
    "  those of a magnetometer next to an accelerometer. The header may begin with #. Logs of\n"   \
    "  phyphox and EuRoC are recognised by their headers, and those converted by ulog2csv\n"       \
    "  (PX4), blackbox_decode (Betaflight, INAV), mavlogdump.py (ArduPilot), rostopic echo -p\n"   \
    "  (ROS) and kalibr_bagextractor (Kalibr: timestamp, omega_x .., alpha_x ..).\n"

/* Finds the columns of a table that has just been opened. Where it has an accelerometer and a
 * magnetometer, x, y and z are those of the accelerometer, unless the kind says otherwise.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if x, y and z are not there or there twice, or
 * another name is there twice, or x, y and z are in different units, or the number of columns
 * is not sufficient. A temperature in an unknown unit is ignored. */
int columns_find(table *t, columns_kind kind, columns *out);

/* The first line has been left out (table_drop_cut_first), or the current one, the last, is to be: it is
 * cut, as columns_is_cut shows after table_next has not come to the end. Says so. */
void columns_say_cut(const table *t, const char *which, unsigned long line);
int columns_is_cut(const table *t, const columns *where);

/* Reads a number from the current row; the column must be there. A time, also one as of clock.h, is in seconds, a
 * temperature in degrees C.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message that names line and column. */
int columns_number(const table *t, const columns *where, column which, double *out);

/* An axis of the accelerometer next to a magnetometer. NaN if there is none, or the current row holds no number
 * there. */
double columns_aside(const table *t, const columns *where, unsigned axis);
/* What the gyroscope reads in the current row; it must be there. EXIT_GOOD; EXIT_FILE, with a message. */
int columns_turn(const table *t, const columns *where, double out[3]);

/* An angle of the stand, COLUMN_ALPHA or COLUMN_BETA, in degrees. NaN if there is no such column, or the
 * current row holds no number there: only a caller that needs angles has to complain. */
double columns_angle(const table *t, const columns *where, column which);

/* Checks that the current row is of the same sensor as those before.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int columns_check_instance(const table *t, columns *where);

/* One sentence for people: "CSV with semicolons, header in line 1; time (µs), ax ay az in g;
 * ignored: 12 other columns". Cut off to `size` bytes. Returns text. */
#define COLUMNS_TEXT_MAX 512
const char *columns_describe(const recognition *seen, char *text, size_t size);

#endif
