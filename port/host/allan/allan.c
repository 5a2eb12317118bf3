/* SPDX-License-Identifier: MIT
 *
 * invcal allan: the noise of a log at rest, and the dwell that it requires.
 */
#include "allan/allan.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "read/columns_option.h"

enum {
    COLUMNS,
    RATE,
    TAU,
    APART,
    SIGMA,
    LSB,
    UNIT,
    GRAVITY,
    FROM,
    TO,
    OUT,
    REPORT,
    JSON,
    QUIET,
    OPTIONS
};

static const option options[OPTIONS] = {
    [COLUMNS] = {"--columns", 1}, [RATE] = {"--rate", 1},       [TAU] = {"--tau", 1},
    [APART] = {"--apart", 0},     [SIGMA] = {"--sigma", 1},     [LSB] = {"--lsb", 1},
    [UNIT] = {"--unit", 1},       [GRAVITY] = {"--gravity", 1}, [FROM] = {"--from", 1},
    [TO] = {"--to", 1},           [OUT] = {"--out", 1},         [REPORT] = {"--report", 1},
    [JSON] = {"--json", 0},       [QUIET] = {"--quiet", 0},
};
static const char *const operands[] = {"LOG"};
static const option_syntax syntax = {"allan", options, OPTIONS, operands, 1, 0};

#define COMMAND_MAX 2000u
#define NUMBER_MAX 1e12

typedef struct {
    const char *value[OPTIONS];
    allan_settings settings;
    char command[COMMAND_MAX];
} request;

/* A number above `min`, if it is stated. */
static int read_number(const request *r, unsigned which, double min, double *out)
{
    if (!r->value[which]) {
        return EXIT_GOOD;
    }
    const int failure = options_numbers(&syntax, which, r->value[which], 1, out, NULL);
    if (!failure && !(*out > min && *out <= NUMBER_MAX)) {
        return message_usage(syntax.command, "%s %s: must be above %g, at most %g",
                             options[which].name, r->value[which], min, NUMBER_MAX);
    }
    return failure;
}

static int read_taus(request *r)
{
    const char *text = r->value[TAU];
    unsigned count = 1;

    if (!text) {
        return EXIT_GOOD;
    }
    for (const char *c = text; *c != '\0'; c++) {
        count += *c == ',';
    }
    if (count > INVCAL_ALLAN_TAUS) {
        return message_usage(syntax.command, "--tau: at most %u times",
                             (unsigned)INVCAL_ALLAN_TAUS);
    }
    r->settings.taus = count;
    return options_numbers(&syntax, TAU, text, count, r->settings.tau, NULL);
}

static int read_unit(request *r)
{
    if (r->value[UNIT] && !unit_parse(r->value[UNIT], &r->settings.unit)) {
        return message_usage(syntax.command, "--unit %s: must be g, mg, m/s2 or counts",
                             r->value[UNIT]);
    }
    if (r->value[UNIT] && r->value[LSB]) {
        return message_usage(syntax.command, "--lsb: states the unit; leave out --unit");
    }
    return EXIT_GOOD;
}

static int check_files(const request *r)
{
    const named_file inputs[] = {{"LOG", r->settings.file}};
    const named_file outputs[] = {{"--out", r->value[OUT]}, {"--report", r->value[REPORT]}};

    return files_check(syntax.command, inputs, 1, outputs, 2);
}

static int read_request(int argc, char **argv, request *r)
{
    allan_settings *s = &r->settings;

    *r = (request){.settings = {.to = HUGE_VAL}};
    int failure = options_parse(&syntax, argc, argv, r->value, &s->file);
    s->is_apart = r->value[APART] != NULL;
    s->command = r->command;
    options_command(syntax.command, argc, argv, r->command, sizeof r->command);
    failure = failure ? failure : check_files(r);
    failure = failure ? failure : columns_option_parse(syntax.command, r->value[COLUMNS]);
    failure = failure ? failure : read_number(r, RATE, 0, &s->rate);
    failure = failure ? failure : read_taus(r);
    failure = failure ? failure : read_number(r, SIGMA, 0, &s->sigma);
    failure = failure ? failure : read_number(r, LSB, 0, &s->lsb);
    failure = failure ? failure : read_unit(r);
    failure = failure ? failure : read_number(r, GRAVITY, 0, &s->gravity);
    failure = failure ? failure : read_number(r, FROM, -NUMBER_MAX, &s->from);
    failure = failure ? failure : read_number(r, TO, -NUMBER_MAX, &s->to);
    if (!failure && !(s->from <= s->to)) {
        return message_usage(syntax.command, "--to: is before --from");
    }
    return failure;
}

typedef void result_writer(FILE *file, const allan_result *result, const allan_settings *settings);

/* Writes a file, if it is requested, under a temporary name. */
static int begin_file(output *out, const char *path, result_writer *write, const request *r,
                      const allan_result *result)
{
    if (!path) {
        return EXIT_GOOD;
    }
    const int failure = output_begin(out, path);
    if (failure) {
        return failure;
    }
    write(out->file, result, &r->settings);
    return output_finish(out);
}

static int print(const request *r, const allan_result *result)
{
    if (r->value[JSON]) {
        allan_json(stdout, result, &r->settings);
    } else if (!r->value[QUIET]) {
        allan_print(stdout, result, &r->settings);
    }
    return output_flush();
}

/* Files get their names only after everything has been written. */
static int deliver(const request *r, const allan_result *result)
{
    output files[2] = {{0}};
    int failure = begin_file(&files[0], r->value[OUT], allan_json, r, result);

    failure = failure ? failure : begin_file(&files[1], r->value[REPORT], allan_report, r, result);
    failure = failure ? failure : print(r, result);
    return output_end(files, 2, failure);
}

static int run(int argc, char **argv)
{
    static request r;
    static allan_result result;
    int failure = read_request(argc, argv, &r);

    if (failure) {
        return failure;
    }
    if (r.value[QUIET]) {
        progress_quiet();
    }
    failure = allan_read(&result, &r.settings);
    return failure ? failure : deliver(&r, &result);
}

static const char *const help[] = {
    "usage: invcal allan LOG [options]\n"
    "\n"
    "Shows how long to hold each position, from a log at rest of some minutes or hours: the\n"
    "Allan deviation of each axis, and the components of its noise where they are visible:\n"
    "white noise N, bias instability B, rate random walk K. After a time tau in a position,\n"
    "the standard deviation of its mean is\n"
    "\n"
    "  sqrt(N^2 / tau + 0.441 B^2 + K^2 tau / 3)\n"
    "\n"
    "LOG is a table of samples as for invcal calibrate; - reads the standard input. The\n"
    "sensor must be at rest, and the samples neither averaged nor filtered. Results are in\n"
    "m/s^2 if the unit of the readings is known, from the header, --unit or --lsb, else in\n"
    "input units. For a gyroscope, name its columns: --columns gx,gy,gz; results are then in\n"
    "the unit of the header (rad/s, deg/s), in rad/s with --lsb, else in input units.\n"
    "\n",
    COLUMNS_OPTION_HELP,
    "  --rate HZ           samples per second, any above 0; default: from the times in LOG\n"
    "  --tau T1,T2,...     averaging times in seconds, ascending. Each must be a multiple of\n"
    "                      the sample interval; one longer than 4096 samples, of a power of\n"
    "                      two of them. Default: octaves\n"
    "  --apart             windows do not overlap: one begins where another ends; default:\n"
    "                      they overlap, which is more accurate\n"
    "  --sigma S           required standard deviation of a position mean, in the unit of the\n"
    "                      result; default: as good as possible\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts; default: from the\n"
    "                      header\n"
    "  --lsb S             what one input unit (one count) is, in m/s^2, or in the unit of\n"
    "                      --gravity, such as 9.80665/16384; of a gyroscope, in rad/s\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --from T            leave out the samples before T, seconds after the first one\n"
    "  --to T              leave out those after T\n"
    "  --out NOISE.json    write the result as JSON, for invcal plan --allan\n"
    "  --report R.html     write a page with the verdict, figures and a chart: one\n"
    "                      self-contained file, for screen and paper\n"
    "  --json              print the result as JSON instead of the table\n"
    "  --quiet             print neither table nor progress, only errors\n"
    "\n"
    "exit codes: 0 good; 1 LOG moves or is too short; 2 usage; 3 LOG unreadable or malformed,\n"
    "or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan faces --dwell 300 > rest.csv\n"
    "  invcal allan rest.csv --to 299 --lsb 0.0006 --sigma 0.0005 --out noise.json\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal allan LOG [options]\n"
    "\n"
    "Shows how long to hold each position, and the components of the sensor's noise: from a\n"
    "log at rest, of some minutes or hours, neither averaged nor filtered.\n"
    "\n"
    "  --rate HZ           samples per second; default: from the times in LOG\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts\n"
    "  --lsb S             what one input unit (one count) is, in m/s^2\n"
    "  --sigma S           required standard deviation of a position mean\n"
    "  --from T, --to T    use only the samples between, seconds after the first\n"
    "  --out NOISE.json    write the result to a file, for invcal plan --allan\n"
    "  --report R.html     write a page with the verdict, figures and a chart\n"
    "  --json              print the result as JSON instead of the table\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan faces --dwell 300 > rest.csv\n"
    "  invcal allan rest.csv --to 299 --lsb 0.0006 --sigma 0.0005 --out noise.json\n",
    NULL};

const tool_command allan_command = {
    "allan", "measure the noise at rest, and how long to hold still", help, run, brief};
