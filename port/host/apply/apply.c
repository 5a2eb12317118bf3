/* SPDX-License-Identifier: MIT
 *
 * invcal apply: corrects the readings of a log.
 */
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "read/columns_option.h"
#include "read/columns.h"
#include "cli/command.h"
#include "cli/files.h"
#include "cli/input.h"
#include "cli/message.h"
#include "apply/nonlinear_correction.h"
#include "read/temperature.h"
#include "text/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "apply/thermal_correction.h"

static const char *const operands[] = {"CAL.json", "LOG"};
enum { COLUMNS, TEMPERATURE, GYRO, QUIET, OPTIONS };
static const option options[OPTIONS] = {
    [COLUMNS] = {"--columns", 1},
    [TEMPERATURE] = {"--temperature", 1},
    [GYRO] = {"--gyro", 0},
    [QUIET] = {"--quiet", 0},
};
static const option_syntax syntax = {"apply", options, OPTIONS, operands, 2, 0};

#define FAR_MIN 0.1 /* of the field; a median length beyond is not that of a device on earth */
#define FAR_MAX 10.0

/* How a log is corrected. */
typedef struct {
    calibration_file file;
    double temperature; /* of all readings; NaN: from the column */
    thermal_correction thermal;
    nonlinear_correction nonlinear;
    int is_gyro;      /* the log is of the gyroscope alone */
    recognition seen; /* how the columns were understood */
    unsigned long rows;
    unsigned long small; /* rows whose result is shorter than FAR_MIN times the field, */
    unsigned long large; /* or longer than FAR_MAX times */
    int is_quiet;        /* no warning of readings outside the calibrated range */
    int is_left_empty;   /* a warning about an empty cell of temperature has been printed */
} job;

/* Checks a number, but copies its text, so that a time stamp keeps its digits, unless the unit is
 * converted. */
static int copy_number(FILE *spool, const table *log, const columns *where, column which)
{
    double number;
    const int failure = columns_number(log, where, which, &number);

    const int is_converted = which == COLUMN_TIME
                                 ? where->per_second > 1
                                 : where->degrees.scale < 1 || where->degrees.zero < 0;
    if (!failure && is_converted) {
        char text[NUMBER_TEXT_MAX];
        fputs(number_text(number, text), spool);
    } else if (!failure) {
        fputs(log->field[where->index[which]], spool);
    }
    return failure;
}

static int write_three(FILE *spool, const table *log, const double v[3])
{
    if (!(fabs(v[0]) <= DBL_MAX && fabs(v[1]) <= DBL_MAX && fabs(v[2]) <= DBL_MAX)) {
        message("%s:%lu: the reading is too large", log->name, log->line);
        return EXIT_FILE;
    }
    fprintf(spool, "%.9g,%.9g,%.9g", v[0], v[1], v[2]);
    return EXIT_GOOD;
}

/* The calibrated rate, rad/s. acceleration: calibrated; 0 if it is unknown. */
static int write_gyro(FILE *spool, const table *log, const columns *where, const job *j,
                      const double acceleration[3])
{
    double v[3];
    const int failure = columns_gyro(log, where, v);

    if (failure) {
        return failure;
    }
    invcal_apply(&j->file.gyro, v[0], v[1], v[2], v);
    for (unsigned i = 0; i < 9; i++) {
        v[i / 3] -= j->file.gyro_g[i / 3][i % 3] * acceleration[i % 3];
    }
    return write_three(spool, log, v);
}

static int write_accelerometer(FILE *spool, const table *log, const columns *where, job *j,
                               double v[3])
{
    double temperature = j->temperature;
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = columns_number(log, where, (column)(COLUMN_X + i), &v[i]);
    }
    if (!failure && j->file.has_thermal && isnan(temperature)) {
        failure = columns_number(log, where, COLUMN_TEMPERATURE, &temperature);
    }
    if (failure) {
        return failure;
    }
    nonlinear_correction_remove(&j->nonlinear, v);
    invcal_apply(thermal_correction_at(&j->thermal, temperature), v[0], v[1], v[2], v);
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    j->small += length < FAR_MIN * j->file.gravity;
    j->large += length > FAR_MAX * j->file.gravity;
    return write_three(spool, log, v);
}

/* A cell of temperature may be empty unless the calibration depends on temperature. */
static int write_temperature(FILE *spool, const table *log, const columns *where, job *j)
{
    if (!temperature_is_missing(log, where)) {
        return copy_number(spool, log, where, COLUMN_TEMPERATURE);
    }
    if (!j->is_left_empty) {
        temperature_warn(log, where, "left empty");
        j->is_left_empty = 1;
    }
    return EXIT_GOOD;
}

static int has_gyro(const columns *where, const job *j)
{
    return where->gyro[0] >= 0 && j->file.has_gyro && !j->is_gyro;
}

static int write_row(FILE *spool, const table *log, const columns *where, job *j)
{
    int failure = EXIT_GOOD;
    double acceleration[3] = {0, 0, 0};

    if (where->index[COLUMN_TIME] >= 0) {
        failure = copy_number(spool, log, where, COLUMN_TIME);
        putc(',', spool);
    }
    failure = failure      ? failure
              : j->is_gyro ? write_gyro(spool, log, where, j, acceleration)
                           : write_accelerometer(spool, log, where, j, acceleration);
    if (!failure && has_gyro(where, j)) {
        putc(',', spool);
        failure = write_gyro(spool, log, where, j, acceleration);
    }
    if (!failure && where->index[COLUMN_TEMPERATURE] >= 0) {
        putc(',', spool);
        failure = write_temperature(spool, log, where, j);
    }
    putc('\n', spool);
    return failure;
}

/* The next complete row. Returns 1; 0 at the end; -1 after a message. */
static int next_row(table *log, const columns *where, unsigned long rows)
{
    const int more = table_next(log);

    if (more != 0 && rows > 0 && columns_is_cut(log, where)) {
        columns_warn_cut(log, "last", log->line);
        return 0;
    }
    return more;
}

static int find_columns(table *log, const job *j, columns *where)
{
    unsigned long cut = 0;
    int failure = columns_skip_text(log);

    failure = failure ? failure : table_drop_cut_first(log, &cut);
    if (cut > 0) {
        columns_warn_cut(log, "first", cut);
    }
    log->is_log = 1;
    const columns_kind kind = j->is_gyro                ? COLUMNS_GYRO
                              : j->file.has_gyro        ? COLUMNS_IMU
                              : j->file.is_magnetometer ? COLUMNS_MAGNETOMETER
                                                        : COLUMNS_LOG;
    return failure ? failure : columns_find(log, kind, where);
}

/* After the rows: the line below the text may be bad, and an error is the last line. */
static void warn_of_text(const table *log)
{
    if (log->text_lines > 0) {
        message("warning: %s: %lu line%s of text before the %s ignored", log->name, log->text_lines,
                log->text_lines == 1 ? "" : "s", log->has_header ? "header" : "readings");
    }
}

/* The calibration of a magnetometer, and columns x y z that are perhaps of an accelerometer: the
 * unit in their header may be g instead of gauss. Returns 1 if it warned. */
static int warn_of_other_sensor(const table *log, const job *j)
{
    const reading_unit here = j->seen.unit;
    const reading_unit there = unit_of_name(j->file.unit);
    const int is_different = here != UNIT_UNKNOWN && there != UNIT_UNKNOWN && here != there;

    if (!j->file.is_magnetometer || j->seen.sensor == COLUMNS_OF_MAGNETOMETER ||
        !(is_different || j->seen.states_foreign_unit)) {
        return 0;
    }
    message("warning: %s: the header states readings in %s, but the calibration is of a "
            "magnetometer, from readings in %s: give it the log of the magnetometer, or convert "
            "them",
            log->name,
            here == UNIT_GAUSS        ? "g, or in gauss"
            : here == UNIT_MILLIGAUSS ? "mg, or in milligauss"
            : here == UNIT_UNKNOWN    ? "a unit of another sensor"
                                      : unit_words(here),
            unit_words(there));
    return 1;
}

/* Warns if the unit of the readings differs from that of the calibration. Readings of the size of
 * mg may be counts. Returns 1 if so. */
static int warn_of_unit(const table *log, const job *j)
{
    const reading_unit here = j->seen.unit;
    const reading_unit there = unit_of_name(j->file.unit);
    const int may_be_same = (here == UNIT_COUNTS && there == UNIT_MG) || here == there;

    if (here == UNIT_UNKNOWN || there == UNIT_UNKNOWN || may_be_same) {
        return 0;
    }
    message("warning: %s: the header states readings in %s, but the calibration was made from "
            "readings in %s: convert them, or correct the header",
            log->name, unit_words(here), unit_words(there));
    return 1;
}

/* Warns if the result is far from the field, as when the readings are in another unit than those of
 * the calibration and no header says so. */
static void check_size(const table *log, const job *j)
{
    const unsigned long most = j->rows / 2;
    const reading_unit there = unit_of_name(j->file.unit);

    if (j->small > most || j->large > most) {
        message("warning: %s: most corrected readings are %s times the field: the calibration was "
                "made from readings in %s, and these are in another unit or of another range",
                log->name, j->small > most ? "less than 0.1" : "more than 10",
                there == UNIT_UNKNOWN ? "input units" : unit_words(there));
    }
}

/* 1 if the correction depends on a column of temperature. */
static int needs_temperature(const job *j)
{
    return j->file.has_thermal && !j->is_gyro && isnan(j->temperature);
}

static int check_temperature(const table *log, const columns *where, const job *j)
{
    if (needs_temperature(j) && where->index[COLUMN_TEMPERATURE] < 0) {
        message("%s: this calibration needs a column of temperature in °C, K or °F: name it "
                "temperature, or state --temperature for all readings",
                log->name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

static int write_rows(FILE *spool, table *log, job *j)
{
    columns where;
    int more = 0;
    int failure = find_columns(log, j, &where);

    if (failure) {
        return failure;
    }
    j->seen = where.seen;
    fprintf(spool, "%s%s%s%s\n", where.index[COLUMN_TIME] >= 0 ? "t," : "",
            j->is_gyro ? "gx,gy,gz" : "x,y,z", has_gyro(&where, j) ? ",gx,gy,gz" : "",
            where.index[COLUMN_TEMPERATURE] >= 0 ? ",temperature" : "");
    while (!failure && !ferror(spool) && (more = next_row(log, &where, j->rows)) == 1) {
        failure = check_temperature(log, &where, j);
        failure = failure ? failure : columns_check_instance(log, &where);
        failure = failure ? failure : write_row(spool, log, &where, j);
        j->rows++;
        progress_show(log->file, log->line, PROGRESS_ROWS);
    }
    progress_end();
    if (failure || more < 0) {
        return EXIT_FILE;
    }
    if (ferror(spool) || fflush(spool) != 0) {
        message("a temporary file cannot be written: %s", strerror(errno ? errno : EIO));
        return EXIT_FILE;
    }
    if (j->rows == 0) {
        message("%s: has a header, but no readings", log->name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The result goes to a temporary file first: if any line is bad, nothing is printed. */
static int apply(table *log, job *j)
{
    FILE *spool = tmpfile();

    if (!spool) {
        message("cannot create a temporary file: %s", strerror(errno));
        return EXIT_FILE;
    }
    int failure = write_rows(spool, log, j);
    if (!failure && fseek(spool, 0, SEEK_SET) != 0) {
        message("the temporary file cannot be read: %s", strerror(errno));
        failure = EXIT_FILE;
    }
    if (!failure) {
        failure = output_copy(spool);
    }
    fclose(spool);
    if (!failure && !j->is_quiet) {
        warn_of_text(log);
        if (!j->is_gyro && !warn_of_other_sensor(log, j) && !warn_of_unit(log, j)) {
            check_size(log, j);
        }
        if (j->is_gyro && j->file.has_gyro_g) {
            message("warning: %s: the gyroscope's g-sensitivity is not corrected: that needs the "
                    "accelerometer's columns in the same log",
                    log->name);
        }
        thermal_correction_end(&j->thermal, log->name);
        nonlinear_correction_end(&j->nonlinear, log->name);
    }
    return failure;
}

static int read_temperature(const char *value, job *j)
{
    j->temperature = NUMBER_UNKNOWN;
    if (!value) {
        return EXIT_GOOD;
    }
    if (!j->file.has_thermal) {
        return message_usage(syntax.command, "--temperature: this calibration has no slopes "
                                             "(invcal calibrate --thermal): leave it out");
    }
    return options_numbers(&syntax, TEMPERATURE, value, 1, &j->temperature, NULL);
}

static int run(int argc, char **argv)
{
    const char *value[OPTIONS];
    const char *files[2];
    job j;
    table log;
    int failure = options_parse(&syntax, argc, argv, value, files);

    const named_file inputs[] = {{"CAL.json", files[0]}, {"LOG", files[1]}};
    failure = failure ? failure : files_check(syntax.command, inputs, 2, NULL, 0);
    failure = failure ? failure : columns_option_parse(syntax.command, value[COLUMNS]);
    failure = failure ? failure : calibration_file_read_correction(files[0], &j.file);
    failure = failure ? failure : read_temperature(value[TEMPERATURE], &j);
    failure =
        failure ? failure : nonlinear_correction_begin(&j.nonlinear, &j.file, input_name(files[0]));
    if (failure) {
        return failure;
    }
    thermal_correction_begin(&j.thermal, &j.file);
    j.is_gyro = value[GYRO] != NULL;
    if (j.is_gyro && !j.file.has_gyro) {
        return message_usage(syntax.command, "--gyro: %s contains no gyroscope",
                             input_name(files[0]));
    }
    j.is_quiet = value[QUIET] != NULL;
    if (j.is_quiet) {
        progress_quiet();
    }
    if (needs_temperature(&j)) {
        columns_option_require(COLUMN_TEMPERATURE);
    }
    j.is_left_empty = 0;
    j.rows = j.small = j.large = 0;
    failure = table_open(&log, files[1]);
    failure = failure ? failure : apply(&log, &j);
    table_close(&log);
    return failure;
}

static const char *const help[] = {
    "usage: invcal apply CAL.json LOG [options]\n"
    "\n"
    "Corrects readings: calibrated = matrix (raw - offset). Prints CSV with a header, in\n"
    "field units (m/s^2, if the calibration was made with --gravity in m/s^2).\n"
    "\n"
    "CAL.json is the output of invcal calibrate --out. LOG is a table in input units; - reads\n"
    "the standard input. Columns are x y z, or t x y z, or t x y z temperature. Any other\n"
    "order needs a header with these names:\n",
    COLUMNS_NAMES,
    "If CAL.json holds a gyroscope, its columns in LOG (gx gy gz) are corrected too, and\n"
    "printed in rad/s; its g-sensitivity, if known, is corrected with the acceleration of the\n"
    "same line. t and temperature are copied (a time in ms, us or ns becomes seconds, a\n"
    "temperature in K or °F becomes °C); other columns are left out. The readings must be in\n"
    "the unit of the log that CAL.json was made from; if most results are not 0.1 to 10 times\n"
    "the field, there is a warning. Logs of any length are read in constant memory. The result\n"
    "goes to a temporary file first, and is printed only if every line was good.\n"
    "\n"
    "A calibration made with --thermal needs the column temperature, and corrects each\n"
    "reading at its own. Outside the calibrated range, the calibration at its edge is used,\n"
    "with a warning beyond 1 % of the range.\n"
    "\n"
    "If it was made with --quadratic or --cubic, the nonlinear error is removed first. It is\n"
    "known up to the field along each axis; beyond 1.1 times the field, its value there is\n"
    "used, with a warning.\n"
    "\n",
    COLUMNS_OPTION_HELP,
    "  --temperature T     temperature of all readings, instead of the column; for a\n"
    "                      calibration made with --thermal\n"
    "  --gyro              LOG is of the gyroscope alone, x y z or t x y z\n"
    "  --quiet             print only the result and errors: no progress, no warning of\n"
    "                      readings outside the calibrated range\n"
    "\n"
    "exit codes: 0 good; 2 usage; 3 a file unreadable or malformed, or the output not\n"
    "writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/mpu9150_0_positions.csv --positions --out cal.json\n"
    "  invcal apply cal.json tests/data/mpu9150_0_positions.csv\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal apply CAL.json LOG [options]\n"
    "\n"
    "Corrects readings: calibrated = matrix (raw - offset). Prints CSV in field units,\n"
    "usually m/s^2. CAL.json is the output of invcal calibrate --out. LOG has the columns x y\n"
    "z, or t x y z, or a header that names them; - reads the standard input.\n"
    "\n"
    "  --temperature T     temperature of all readings, instead of the column; for a\n"
    "                      calibration made with --thermal\n"
    "  --gyro              LOG is of the gyroscope alone\n"
    "  --quiet             show no progress, print only the result and errors\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/mpu9150_0_positions.csv --positions --out cal.json\n"
    "  invcal apply cal.json tests/data/mpu9150_0_positions.csv\n",
    NULL};

const tool_command apply_command = {"apply", "correct the readings of a log", help, run, brief};
