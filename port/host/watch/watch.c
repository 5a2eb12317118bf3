/* SPDX-License-Identifier: MIT
 *
 * invcal watch: guides the user through a calibration while the samples come in.
 */
#include <string.h>

#include "calibrate/calibrate.h"
#include "cli/command.h"
#include "design/design.h"
#include "read/columns_option.h"
#include "read/noise_file.h"
#include "result/calibration_file.h"
#include "watch/live.h"
#include "watch/wave.h"

/* The guidance goes to stdout, with JSON to stderr, and with --quiet to the null device, which is
 * returned to be
 * closed. */
static FILE *open_output(const request *r, live_options *options)
{
    FILE *null_device = r->value[OPT_QUIET] ? fopen("/dev/null", "w") : NULL;

    options->out = null_device ? null_device : r->value[OPT_JSON] ? stderr : stdout;
    return null_device;
}

static void close_output(FILE *null_device)
{
    if (null_device) {
        fclose(null_device);
    }
}

/* For both kinds of sensors. */
static live_options common_options(const request *r)
{
    live_options options = {.rate = r->rate, .field = r->settings.field, .units = r->units};

    memcpy(options.target, r->target, sizeof options.target);
    options.need = r->need / r->settings.field;
    options.field_sigma = r->field_sigma / r->settings.field;
    return options;
}

/* The rests of a live stream. */
static int read_live(const request *r, positions *data, rests_summary *log, gyro_log *gyro)
{
    invcal_calibration nominal;
    invcal_noise noise[3];
    live_options options = common_options(r);

    options.unit = r->unit;
    options.clip = r->value[OPT_CLIP] ? r->clip : NULL;
    options.gyro = r->gyro;
    options.set = r->program;
    if (r->value[OPT_NOMINAL]) {
        const int failure = calibration_file_read(r->value[OPT_NOMINAL], &nominal);
        if (failure) {
            return failure;
        }
        options.nominal = &nominal;
    }
    options.sensor = r->sensor;
    options.zero = r->value[OPT_ZERO] ? r->zero : NULL;
    options.lsb = r->value[OPT_LSB] ? r->lsb : NULL;
    options.stated = r->settings.noise;
    options.mean_sigma = r->mean_sigma;
    if (r->value[OPT_ALLAN]) {
        const int failure = noise_file_read(r->value[OPT_ALLAN], noise);
        if (failure) {
            return failure;
        }
        options.noise = noise;
    }
    FILE *null_device = open_output(r, &options);
    const int failure =
        live_read(data, r->file, &options, r->value[OPT_ACCELEROMETER_ONLY] ? NULL : gyro, log);
    close_output(null_device);
    return failure;
}

/* A magnetometer that is waved. If its field is not stated, --need is in % of it, or in the unit of
 * the readings. */
static int read_waved(const request *r, const invcal_calibration *nominal, positions *data,
                      magnetometer_log *log)
{
    live_options options = common_options(r);

    if (!r->value[OPT_GRAVITY] && r->value[OPT_NEED] && !strchr(r->value[OPT_NEED], '%')) {
        options.field = 0;
    }
    FILE *null_device = open_output(r, &options);
    const int failure = wave_read(data, r->file, nominal, &options, log);
    close_output(null_device);
    return failure;
}

static int run_watch(int argc, char **argv)
{
    static const calibrate_readers readers = {read_live, read_waved};

    return calibrate_run(argc, argv, 1, &readers);
}

static const char *const watch_help[] = {
    "usage: invcal watch LOG [options]\n"
    "\n"
    "Guides you through a calibration while the samples come in: when to hold still, when to\n"
    "move on, where to turn next, and how accurate the result is so far. At the end of the\n"
    "stream, it prints what invcal calibrate prints for the same samples.\n"
    "\n"
    "On a terminal of at least 80 by 24 it is a screen: @ is the side that points up, X the\n"
    "one that should, dots are positions taken, bars show the uncertainty. A bell rings when\n"
    "a position is taken or refused, and when you may stop. Elsewhere, and with --json, it\n"
    "prints lines.\n"
    "\n"
    "LOG is a stream of samples, usually - for the standard input: a serial port, or invcal\n"
    "simulate. Columns are those of invcal calibrate. With a gyroscope, it reports from the\n"
    "fifth position on what the moves determine, or what is wrong with it, and asks for the\n"
    "turn that is most informative for both sensors. Malformed lines are reported and\n"
    "skipped. Ctrl-C ends it and prints the result.\n"
    "\n"
    "  --plan SET          follow a set of positions, with the angles of a stand. A rest\n"
    "                      elsewhere is reported, and used. Default: the most informative\n"
    "                      direction, given the positions so far. One of\n",
    DESIGN_WORDS,
    "  --mean-sigma S      hold each position until its mean has this standard deviation, in\n"
    "                      field units; the noise of the first rest shows how long that takes.\n"
    "                      Default: hold it for 2 seconds\n"
    "  --allan NOISE.json  the same with the noise that invcal allan --out found in a long\n"
    "                      rest, including what does not average out\n"
    "  --target D,K,G      report when the sigmas of offsets (over the field), scale errors\n"
    "                      and angles (rad) have come down to these; 0: any\n"
    "  --zero X,Y,Z        nominal reading at zero field. Default for the guidance: 0; from\n"
    "                      the fourth position on, the middle of each axis' range; with\n"
    "                      --plan, if that is far off, an estimate from its first three\n"
    "                      positions\n"
    "  --lsb S | SX,SY,SZ  field units per input unit. Default for the guidance: from the unit or\n"
    "                      --sensor, else from the first samples\n",
    "\n"
    "These options are explained in the help of invcal calibrate:\n"
    "\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --latitude DEG      instead: normal gravity at this latitude\n"
    "  --height M          and this height above sea level, m\n"
    "  --frame symmetric|triangular|accelerometer\n"
    "                      axes of the result; default symmetric\n"
    "  --case +z,-x,.,...  which axis of the case pointed up in the first positions\n"
    "  --unit g|mg|m/s2|counts\n"
    "                      unit of the readings\n"
    "  --units everyday|ins\n"
    "                      units of the table: mg, % and degrees, or ug, ppm and arcsec\n"
    "  --nominal CAL.json  an earlier calibration instead of --zero and --lsb\n"
    "  --sensor NAME[:RANGE]\n"
    "                      zero, scale and limits from a data sheet; --sensor list names them\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n"
    "  --noise S           standard deviation of one position mean, in field units\n"
    "  --prior D,K,G       standard deviations of the errors of the nominal calibration\n"
    "  --six-faces         take the angles as 0 +- 0.01 rad: six faces do not determine them\n"
    "  --magnetometer      LOG is of a magnetometer that you wave: turn it until the field,\n"
    "                      @, has been through all white parts of the screen\n"
    "  --with CAL.json     calibration of the accelerometer in LOG\n"
    "  --thermal 1|2       straight lines or parabolas over temperature\n"
    "  --slope D,K,G       standard deviations of the slopes to expect, per K\n",
    COLUMNS_OPTION_HELP,
    "  --rate HZ           samples per second; default: from column t, else 100\n"
    "  --clip LOW,HIGH     limits of the sensor's range, in input units\n"
    "  --keep-all          keep outliers: leave no position out\n"
    "  --gyro-lsb S        degrees/s per input unit of a gyroscope, or rad/s or deg/s\n"
    "  --gyro-axes X,Y,Z   which of its axes turn about x, y, z of the accelerometer, such as\n"
    "                      y,-x,z\n"
    "  --accelerometer-only\n"
    "                      ignore the gyroscope\n"
    "  --need U            largest acceptable error of calibrated lengths in 95 % of cases:\n"
    "                      1mg, 0.1%, or a number in the unit of --gravity. Reports when it\n"
    "                      is reached\n"
    "  --tolerance D,K,G   limits of the data sheet, as 50mg,3%,2deg: PASS, or FAIL with the\n"
    "                      parameters that exceed them\n"
    "  --strict            exit with 1 unless the verdict is good, and --tolerance and --need\n"
    "                      pass\n",
    RECORD_OPTIONS,
    "  --out CAL.json      write the result as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON instead of the table; the guidance goes\n"
    "                      to stderr\n"
    "  --json-lines        the same on one line, for pipes\n"
    "  --quiet             print neither guidance nor table, only errors\n"
    "\n"
    "exit codes: 0 calibrated, whatever the verdict; 1 the data cannot be calibrated or, with\n"
    "--strict, are not good; 2 usage; 3 LOG unreadable or malformed, or the output not\n"
    "writable\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges | invcal watch -\n",
    NULL};

static const char *const watch_brief[] = {
    "usage: invcal watch LOG [options]\n"
    "\n"
    "Guides you through a calibration while the samples come in, usually from the standard\n"
    "input (-): when to hold still, when to move on, where to turn next. Calibrates at the\n"
    "end. Ctrl-C ends it.\n"
    "\n"
    "  --plan SET          follow a set of positions: edges, faces, per-group:N, optimal:N\n"
    "                      ...\n"
    "  --target D,K,G      report when the sigmas of offsets (over the field), scale errors\n"
    "                      and angles (rad) have come down to these\n"
    "  --need U            largest acceptable error of calibrated lengths: reports when it is\n"
    "                      reached\n"
    "  --magnetometer      LOG is of a magnetometer that you wave, not hold still\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts\n"
    "  --rate HZ           samples per second; default: from column t, else 100\n"
    "  --out CAL.json      write the result to a file, for invcal apply and export\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON; the guidance goes to stderr\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges | invcal watch -\n",
    NULL};

const tool_command watch_command = {"watch", "guide you through a calibration, live", watch_help,
                                    run_watch, watch_brief};
