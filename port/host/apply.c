/* SPDX-License-Identifier: MIT
 *
 * invcal apply: corrects the readings of a log.
 */
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "calibration_file.h"
#include "columns.h"
#include "command.h"
#include "input.h"
#include "message.h"
#include "number.h"
#include "options.h"
#include "output.h"
#include "progress.h"

static const char *const operands[] = {"CAL.json", "LOG"};
static const option options[] = {{"--quiet", 0}};
static const option_syntax syntax = {"apply", options, 1, operands, 2, 0};

/* Checks a number, but hands it on as the text that it was: a time stamp has digits to lose. Only a
 * time in another unit becomes one in seconds. */
static int copy_number(FILE *spool, const table *log, const columns *where, column which)
{
    double number;
    const int failure = columns_number(log, where, which, &number);

    if (!failure && which == COLUMN_TIME && where->per_second > 1) {
        char text[NUMBER_TEXT_MAX];
        fputs(number_text(number, text), spool);
    } else if (!failure) {
        fputs(log->field[where->index[which]], spool);
    }
    return failure;
}

static int write_row(FILE *spool, const table *log, const columns *where,
                     const invcal_calibration *calibration)
{
    double v[3];
    int failure = EXIT_GOOD;

    if (where->index[COLUMN_TIME] >= 0) {
        failure = copy_number(spool, log, where, COLUMN_TIME);
        putc(',', spool);
    }
    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = columns_number(log, where, (column)(COLUMN_X + i), &v[i]);
    }
    if (failure) {
        return failure;
    }
    invcal_apply(calibration, v, v);
    if (!(fabs(v[0]) <= DBL_MAX && fabs(v[1]) <= DBL_MAX && fabs(v[2]) <= DBL_MAX)) {
        message("%s:%lu: too large a reading for any calculation", log->name, log->line);
        return EXIT_FILE;
    }
    fprintf(spool, "%.9g,%.9g,%.9g", v[0], v[1], v[2]);
    if (where->index[COLUMN_TEMPERATURE] >= 0) {
        putc(',', spool);
        failure = copy_number(spool, log, where, COLUMN_TEMPERATURE);
    }
    putc('\n', spool);
    return failure;
}

static int write_rows(FILE *spool, table *log, const invcal_calibration *calibration)
{
    columns where;
    unsigned long rows = 0;
    int more = 0;
    int failure = columns_find(log, COLUMNS_LOG, &where);

    if (failure) {
        return failure;
    }
    fprintf(spool, "%sx,y,z%s\n", where.index[COLUMN_TIME] >= 0 ? "t," : "",
            where.index[COLUMN_TEMPERATURE] >= 0 ? ",temperature" : "");
    while (!failure && !ferror(spool) && (more = table_next(log)) == 1) {
        failure = columns_check_instance(log, &where);
        failure = failure ? failure : write_row(spool, log, &where, calibration);
        rows++;
        progress_show(log, PROGRESS_ROWS);
    }
    progress_end();
    if (failure || more < 0) {
        return EXIT_FILE;
    }
    if (ferror(spool) || fflush(spool) != 0) {
        message("a temporary file cannot be written: %s", strerror(errno ? errno : EIO));
        return EXIT_FILE;
    }
    if (rows == 0) {
        message("%s: holds a header, but no reading", log->name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The whole log goes to a temporary file first: if its last line is bad, nothing is printed. */
static int apply(table *log, const invcal_calibration *calibration)
{
    FILE *spool = tmpfile();

    if (!spool) {
        message("no temporary file can be made: %s", strerror(errno));
        return EXIT_FILE;
    }
    int failure = write_rows(spool, log, calibration);
    if (!failure) {
        rewind(spool);
        failure = output_copy(spool);
    }
    fclose(spool);
    return failure;
}

static int run(int argc, char **argv)
{
    const char *quiet;
    const char *files[2];
    invcal_calibration calibration;
    table log;
    int failure = options_parse(&syntax, argc, argv, &quiet, files);

    if (!failure && input_is_stdin(files[0]) && input_is_stdin(files[1])) {
        failure = message_usage(syntax.command, "only one input can be the standard input");
    }
    failure = failure ? failure : calibration_file_read(files[0], &calibration);
    if (failure) {
        return failure;
    }
    if (quiet) {
        progress_quiet();
    }
    failure = table_open(&log, files[1]);
    failure = failure ? failure : apply(&log, &calibration);
    table_close(&log);
    return failure;
}

static const char *const help[] = {
    "usage: invcal apply CAL.json LOG [options]\n"
    "\n"
    "Corrects readings: calibrated = matrix (raw - offset). Prints CSV in field units (m/s^2,\n"
    "if the calibration was made with --gravity in m/s^2), with a header.\n"
    "\n"
    "CAL.json is what invcal calibrate --out has written. LOG is a table in input units; - is the\n"
    "standard input. Columns are x y z, or t x y z, or t x y z temperature, or any with a header\n"
    "that names them:\n",
    COLUMNS_NAMES,
    "t and temperature are copied as they are (a time in ms, us or ns becomes seconds), the\n"
    "others left out. The readings are in the unit of the log that CAL.json was made from.\n"
    "Logs of any length are read in fixed memory; the result waits in a temporary file, and is\n"
    "printed only if every line was good.\n"
    "\n"
    "  --quiet             show no progress, print only the result and errors\n"
    "\n"
    "exit codes: 0 good; 2 usage; 3 a file unreadable or malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/mpu9150_0_positions.csv --positions --out cal.json\n"
    "  invcal apply cal.json tests/data/mpu9150_0_positions.csv\n",
    NULL};

const tool_command apply_command = {"apply", "correct the readings of a log", help, run};
