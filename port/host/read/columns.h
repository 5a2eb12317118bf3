/* SPDX-License-Identifier: MIT
 *
 * read/columns.h: finds the meanings of a table's columns, by its header or by their number.
 */
#ifndef COLUMNS_H
#define COLUMNS_H

#include <stddef.h>

#include "read/column.h"
#include "read/heading.h"
#include "read/table.h"

/* The sensor that a heading with an axis belongs to. */
typedef enum {
    COLUMNS_OF_UNKNOWN,
    COLUMNS_OF_GYROSCOPE,
    COLUMNS_OF_MAGNETOMETER,
    COLUMNS_OF_ANY, /* plain x, y and z */
    COLUMNS_OF_ACCELEROMETER
} columns_sensor;

/* A summary of what was recognised, for texts and JSON. It outlives the table. */
typedef struct {
    const char *separator;     /* "commas", ... */
    unsigned long header_line; /* 0: none */
    unsigned long preamble;    /* number of lines of `name, value` before the header */
    unsigned long text_lines;  /* number of lines of text before the header (table_skip_text) */
    unsigned long unit_line;   /* of a row of units; 0: none */
    int is_magnetometer;       /* a magnetometer was asked for */
    columns_sensor sensor;     /* of x, y and z, by their headings; else COLUMNS_OF_UNKNOWN */
    char other_sensor[HEADING_NAME_MAX]; /* x of the magnetometer or accelerometer that is not used;
                                          * empty: none */
    char gyro[3][HEADING_NAME_MAX];      /* of a gyroscope, as in the header; empty: none */
    double rate_unit; /* rad/s in one unit of the gyroscope, if the headings state it; else 0 */
    int is_gyro;      /* x, y and z themselves are those of a gyroscope, with unit rate_unit */
    char chosen[COLUMNS_OPTION_MAX]; /* the value of --columns; empty: not given */
    unsigned ignored;                /* number of columns that have a heading, but are ignored */
    const char *corrected;           /* topic of an autopilot that has corrected them; null: raw */
    int states_foreign_unit;         /* the headings state a unit that unit.h does not know */
    reading_unit unit;               /* of x, y and z */
    unit_origin unit_from;           /* header or none; a caller that knows the unit may set it */
    const char *time_unit;           /* "s", "ms", "µs", "ns" */
    char name[COLUMN_COUNT][HEADING_NAME_MAX]; /* as in the header; empty: no such column */
} recognition;

/* Indices into table.field; -1: no such column. */
typedef struct {
    int index[COLUMN_COUNT];
    int accelerometer[3];     /* x y z of the accelerometer next to a magnetometer */
    int gyro[3];              /* x y z of a gyroscope, unless it is ignored */
    int last;                 /* the largest of them */
    double per_second;        /* units of the time column in a second */
    int is_time_unit_known;   /* by the heading or the kind of log; else seconds are assumed */
    temperature_unit degrees; /* of the temperature column */
    double per_degree[2];     /* units of the columns alpha and beta in a degree */
    int instance;             /* column with the number of the sensor of each row */
    char first_instance[8];
    recognition seen;
} columns;

/* How to interpret the columns of a table without a header. */
typedef enum {
    COLUMNS_POSITIONS, /* x y z; x y z std n; x y z std_x std_y std_z n */
    /* x y z; t x y z; t x y z temperature; the first two also followed by the three of a
     * gyroscope, which are ignored */
    COLUMNS_LOG,
    COLUMNS_IMU,         /* the same, but the gyroscope is used */
    COLUMNS_GYRO,        /* as COLUMNS_LOG, of a gyroscope */
    COLUMNS_MAGNETOMETER /* as COLUMNS_LOG; if the header names two sensors, the magnetometer */
} columns_kind;

/* The names that a header may use, for help texts. */
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

/* Skips lines of text above the header or the first row; see table_skip_text. To be called first.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int columns_skip_text(table *t);

/* Finds the columns of a table that has just been opened. If it has an accelerometer and a
 * magnetometer, x, y and z are those of the accelerometer, unless the kind is COLUMNS_MAGNETOMETER.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if x, y and z are missing or ambiguous, another
 * column is ambiguous, x, y and z are in different units, or, without a header, the number of
 * columns is not one of those above. A temperature in an unknown unit is ignored. */
int columns_find(table *t, columns_kind kind, columns *out);

/* Warns that a line is cut off and ignored: the "first" (table_drop_cut_first) or the "last". */
void columns_warn_cut(const table *t, const char *which, unsigned long line);

/* 1 if the current row, the last of the table, is cut off; to be asked after table_next, unless
 * that returned 0. */
int columns_is_cut(const table *t, const columns *where);

/* Reads a number of the current row; the column must exist. A time, which may be one of clock.h, is
 * in seconds, a temperature in degrees C.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message that names line and column. */
int columns_number(const table *t, const columns *where, column which, double *out);

/* Reads an axis of the accelerometer next to a magnetometer. NaN if there is none, or no number in
 * the current row. */
double columns_accelerometer(const table *t, const columns *where, unsigned axis);

/* Reads the gyroscope in the current row; its columns must exist. EXIT_GOOD; EXIT_FILE, with a
 * message. */
int columns_gyro(const table *t, const columns *where, double out[3]);

/* Reads an angle of the stand, COLUMN_ALPHA or COLUMN_BETA, in degrees. NaN if there is no such
 * column, or no number in the current row: only a caller that needs angles reports it. */
double columns_angle(const table *t, const columns *where, column which);

/* Checks that the current row is of the same sensor as the rows before.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message. */
int columns_check_instance(const table *t, columns *where);

/* One sentence for people: "CSV with semicolons, header in line 1; time (µs), ax ay az in g;
 * ignored: 12 other columns". Truncated to `size` bytes. Returns text. */
#define COLUMNS_TEXT_MAX 512
const char *columns_describe(const recognition *seen, char *text, size_t size);

#endif
