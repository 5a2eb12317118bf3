/* SPDX-License-Identifier: MIT
 *
 * invcal compare: drift of a device, and outliers among devices, from their calibrations.
 */
#include "compare/compare.h"

#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"

enum { AS, SAME_FIELD, UNITS, REPORT, JSON, QUIET, OPTIONS };

static const option options[OPTIONS] = {
    [AS] = {"--as", 1},       [SAME_FIELD] = {"--same-field", 0},
    [UNITS] = {"--units", 1}, [REPORT] = {"--report", 1},
    [JSON] = {"--json", 0},   [QUIET] = {"--quiet", 0},
};
static const char *const operands[] = {"CAL.json", "a second CAL.json"};
static const option_syntax syntax = {"compare", options, OPTIONS, operands, 2, OPTIONS_REPEATS};

#define COMMAND_MAX 2000u

/* The command line. */
typedef struct {
    const char *value[OPTIONS];
    const char **paths; /* ended by null */
    compare_grouping grouping;
    unit_style units;
    char command[COMMAND_MAX];
} request;

static int read_grouping(request *r)
{
    static const char *const words[] = {"serial", "history", "fleet"};

    for (unsigned k = 0; r->value[AS] && k < 3; k++) {
        if (strcmp(r->value[AS], words[k]) == 0) {
            r->grouping = (compare_grouping)k;
            return EXIT_GOOD;
        }
    }
    return r->value[AS]
               ? message_usage("compare", "--as %s: must be serial, history or fleet", r->value[AS])
               : EXIT_GOOD;
}

/* Messages name each input by its path. */
static int check_files(const request *r)
{
    const named_file made = {"--report", r->value[REPORT]};
    unsigned count = 0;

    while (r->paths[count]) {
        count++;
    }
    named_file *inputs = (named_file *)calloc((size_t)count + 1, sizeof *inputs);
    if (!inputs) {
        message("not enough memory for %u files", count);
        return EXIT_FILE;
    }
    for (unsigned k = 0; k < count; k++) {
        inputs[k] = (named_file){r->paths[k], r->paths[k]};
    }
    const int failure = files_check("compare", inputs, count, &made, 1);
    free(inputs);
    return failure;
}

static int read_request(int argc, char **argv, request *r)
{
    int failure = options_parse(&syntax, argc, argv, r->value, r->paths);

    if (!failure && r->value[UNITS] && !unit_style_parse(r->value[UNITS], &r->units)) {
        failure = message_usage("compare", "--units %s: must be everyday or ins", r->value[UNITS]);
    }
    options_command("compare", argc, argv, r->command, sizeof r->command);
    failure = failure ? failure : read_grouping(r);
    return failure ? failure : check_files(r);
}

/* --as history: whether they really are of one device. */
static void warn_of_serials(const compare_result *r)
{
    char list[COMPARE_NAME_MAX];
    char text[COMPARE_NAME_MAX];
    const unsigned count = compare_serials(r, 0, list);

    if (count > 1) {
        message("warning: --as history, but the files name %u serial numbers: %s", count,
                compare_cut(list, 60, text));
    }
}

static int print(const request *r, const compare_result *result)
{
    if (r->value[JSON]) {
        compare_json(stdout, result);
    } else if (!r->value[QUIET]) {
        compare_print(stdout, result);
    }
    return output_flush();
}

/* The page gets its name only after everything has been written. */
static int deliver(const request *r, const compare_result *result)
{
    output page = {0};
    int failure = EXIT_GOOD;

    if (r->value[REPORT]) {
        failure = output_begin(&page, r->value[REPORT]);
        if (!failure) {
            compare_report(page.file, result);
            failure = output_finish(&page);
        }
    }
    failure = failure ? failure : print(r, result);
    return output_end(&page, 1, failure);
}

static int compare(int argc, char **argv, request *r)
{
    compare_result result = {.command = r->command};
    int failure = read_request(argc, argv, r);

    result.units = r->units;
    result.is_same_field = r->value[SAME_FIELD] != NULL;
    failure =
        failure ? failure : compare_read(&result, r->paths, r->grouping, r->value[JSON] != NULL);
    if (!failure && r->grouping == COMPARE_HISTORY && !r->value[QUIET]) {
        warn_of_serials(&result);
    }
    failure = failure ? failure : deliver(r, &result);
    compare_release(&result);
    return failure;
}

static int run_compare(int argc, char **argv)
{
    request r = {.paths = (const char **)calloc((size_t)argc + 3, sizeof *r.paths)};
    int failure = EXIT_FILE;

    if (r.paths) {
        failure = compare(argc, argv, &r);
    } else {
        message("not enough memory for %d arguments", argc);
    }
    free((void *)r.paths);
    return failure;
}

static const char *const help[] = {
    "usage: invcal compare CAL.json CAL.json ... [options]\n"
    "\n"
    "Compares calibrations written by invcal calibrate --out. Those with one serial number\n"
    "(--serial) are the history of a device, in the order of their dates, or of the arguments\n"
    "if a date is missing: how far each parameter has drifted since the previous calibration,\n"
    "and, of three or more, since the first, with its sigma, and whether the drift is\n"
    "significant. Several serial numbers are a fleet: median and spread of the newest\n"
    "calibrations, and which device is an outlier, of three or more. Two files without serial\n"
    "numbers are a history.\n"
    "\n"
    "Drift is defined like the errors of invcal calibrate, with the older calibration as the\n"
    "nominal one. A parameter has changed if chance alone would change any of the nine by as\n"
    "much in at most 5 % of cases (Student's t, Welch's degrees of freedom, Bonferroni; of\n"
    "three calibrations, half of it for each of the two comparisons). A device is an outlier\n"
    "if Rosner's generalised ESD test finds it; in a fleet of equal devices, it finds any, in\n"
    "any parameter, in 5 % of cases. Files of different frames, units, fields, or sensors and\n"
    "ranges (if both state them) are refused.\n"
    "\n"
    "  --as serial|history|fleet\n"
    "                      serial (default): files with one serial number are of one device;\n"
    "                      history: all are of one device; fleet: each is of another device\n"
    "  --same-field        all were made in one place with one --gravity: its error is the\n"
    "                      same in all, and left out of sigma\n"
    "  --units everyday|ins\n"
    "                      units of the tables: mg, % and degrees, or ug, ppm and arcsec\n"
    "  --report R.html     write a page with the verdict, tables and pictures: one\n"
    "                      self-contained file\n"
    "  --json              print the result as JSON instead of the table\n"
    "  --quiet             print neither, only errors\n"
    "\n"
    "exit codes: 0 good; 1 the files cannot be compared; 2 usage; 3 a file unreadable or\n"
    "malformed, or the output not writable. Drift and outliers do not change them\n"
    "\n"
    "example:\n"
    "  invcal simulate --seed 1 | invcal calibrate - --serial 47 --date 2026-01-05 --out old.json\n"
    "  invcal simulate --seed 2 --offset 0.021,-0.015,0.03 |\n"
    "  invcal calibrate - --serial 47 --date 2026-06-01 --out new.json\n"
    "  invcal compare old.json new.json --same-field --report drift.html\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal compare CAL.json CAL.json ... [options]\n"
    "\n"
    "Compares calibrations written by invcal calibrate --out: how far a device has drifted,\n"
    "if they have one --serial, or which device of a fleet is an outlier.\n"
    "\n"
    "  --as serial|history|fleet\n"
    "                      serial (default): files with one serial number are of one device;\n"
    "                      history: all are of one device; fleet: each is of another device\n"
    "  --same-field        all were made in one place with one --gravity\n"
    "  --report R.html     write a page with the verdict, tables and pictures\n"
    "  --json              print the result as JSON instead of the table\n"
    "\n"
    "example:\n"
    "  invcal simulate --seed 1 | invcal calibrate - --date 2026-01-05 --out old.json\n"
    "  invcal simulate --seed 2 | invcal calibrate - --date 2026-06-01 --out new.json\n"
    "  invcal compare old.json new.json --same-field --report drift.html\n",
    NULL};

const tool_command compare_command = {"compare",
                                      "compare calibrations: drift of a device, spread of a fleet",
                                      help, run_compare, brief};
