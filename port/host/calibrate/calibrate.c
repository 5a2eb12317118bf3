/* SPDX-License-Identifier: MIT
 *
 * invcal calibrate: a log or position means in, a calibration out.
 */
#include "calibrate/calibrate.h"

#include <string.h>

#include "calibrate/deliver.h"
#include "calibrate/refuse.h"
#include "calibrate/settle.h"
#include "calibrate/solve.h"
#include "cli/command.h"
#include "cli/output.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "design/design.h"
#include "fit/sensors.h"
#include "read/chosen.h"
#include "read/columns.h"
#include "result/pass.h"

/* What is written all the same may be no good: with --strict the exit code tells. */
static int hold(const request *r, const calibrate_result *result)
{
    char reason[PASS_MAX];

    if (!r->value[ASK_STRICT] || result->refused.word) {
        return EXIT_GOOD; /* what is refused has its own */
    }
    if (result->gyro.word) {
        message("%s: --strict: the gyroscope is not calibrated: %s", result->data->name,
                result->gyro.reason);
        return EXIT_DATA;
    }
    if (!*pass_strict(result, reason)) {
        return EXIT_GOOD;
    }
    message("%s: --strict: %s", result->data->name, reason);
    return EXIT_DATA;
}

/* What is known of the result before there is one. */
static calibrate_result ask(const request *r, const positions *data, const rests_summary *log)
{
    return (calibrate_result){
        .data = data,
        .log = r->value[ASK_POSITIONS] ? NULL : log,
        .settings = r->settings,
        .place = r->value[ASK_LATITUDE] ? r->place : NULL,
        .told = r->told,
        .need = r->need,
        .need_unit = r->need_unit,
        .record = r->record,
    };
}

/* `--sensor list` needs no log. */
static int asks_for_list(int argc, char **argv)
{
    int asks = 0;

    for (int i = 0; i < argc; i++) {
        asks = asks || strcmp(argv[i], "--sensor=list") == 0 ||
               (strcmp(argv[i], "list") == 0 && i > 0 && strcmp(argv[i - 1], "--sensor") == 0);
    }
    return asks;
}

/* The positions of the log, or the rests in it. */
static int solve_log(const request *r, positions *data, rests_summary *log, turns *gyro,
                     calibrate_result *result, positions_reader *read)
{
    const int failure = read(r, data, log, gyro);

    if (failure) {
        return failure;
    }
    if (data->count == 0 && !r->value[ASK_POSITIONS]) {
        return calibrate_no_rest(result);
    }
    settle_unit(r, data);
    return solve_positions(r, data, gyro, result);
}

/* No rest is looked for in it. */
static int solve_magnetometer(const request *r, positions *data, waved *log,
                              calibrate_result *result, waved_reader *read)
{
    int failure = settle_magnetometer(r, &result->nominal);

    result->log = NULL;
    result->magnetometer = log;
    failure = failure ? failure : read(r, &result->nominal.calibration, data, log);
    return failure                    ? failure
           : log->status != INVCAL_OK ? calibrate_refuse_waved(result)
                                      : solve_waved(r, data, result);
}

int calibrate_run(int argc, char **argv, int is_live, const calibrate_readers *read)
{
    request r;
    positions data = {.name = NULL};
    waved waving = {.samples = 0};
    rests_summary log;
    calibrate_result result = {.data = NULL};
    turns gyro = {.file = NULL};

    if (asks_for_list(argc, argv)) {
        sensors_list(stdout);
        return output_flush();
    }
    int failure = request_read(argc, argv, is_live, &r);
    if (failure) {
        return failure;
    }
    if (r.value[ASK_QUIET]) {
        progress_quiet();
    }
    json_lines(r.value[ASK_JSON_LINES] ? r.file : NULL);
    result = ask(&r, &data, &log);
    settle_limits(&r, &result);
    gyro.file = r.value[ASK_GYRO];
    failure = r.value[ASK_MAGNETOMETER]
                  ? solve_magnetometer(&r, &data, &waving, &result, read->waved)
                  : solve_log(&r, &data, &log, &gyro, &result, read->rests);
    failure = result.refused.word ? deliver_refusal(&r, &result)
              : failure           ? failure
                                  : deliver(&r, &result);
    if (failure == EXIT_FILE && r.value[ASK_JSON_LINES]) {
        deliver_unreadable();
    }
    failure = failure ? failure : hold(&r, &result);
    stand_free(&result.stand);
    rejection_free(&result.rejected);
    positions_free(&data);
    waved_free(&waving);
    turns_free(&gyro);
    json_lines(NULL);
    return failure;
}

/* The positions of the file, or those that a log rests in. */
static int read_positions(const request *r, positions *data, rests_summary *log, turns *gyro)
{
    const double *clip = r->value[ASK_CLIP] ? r->clip : NULL;

    return r->value[ASK_POSITIONS]
               ? positions_read(data, r->file)
               : rests_read(data, r->file, r->rate, clip,
                            r->value[ASK_ACCELEROMETER_ONLY] ? NULL : gyro, log);
}

static int read_waved(const request *r, const invcal_calibration *nominal, positions *data,
                      waved *log)
{
    const waved_wish wish = {.path = r->file, .rate = r->rate, .nominal = nominal};

    return waved_read(data, &wish, log);
}

static int run_calibrate(int argc, char **argv)
{
    static const calibrate_readers readers = {read_positions, read_waved};

    return calibrate_run(argc, argv, 0, &readers);
}

static const char *const help[] = {
    "usage: invcal calibrate LOG [options]\n"
    "\n"
    "Calibrates a triad of accelerometers (or magnetometers) that has been held still in a dozen\n"
    "orientations or more, in any order and at any angle. In each it feels one and the same\n"
    "field; only its length must be known, no direction. Result:\n"
    "\n"
    "  calibrated = matrix (raw - offset)\n"
    "\n"
    "LOG is a table of samples, - the standard input; the rests in it, of two seconds or more,\n"
    "are found. Turn briskly from one to the next: a turn of more than five seconds may pass for\n"
    "a rest where it begins and ends slowly. Columns are x y z, or t x y z (t in seconds), or\n"
    "t x y z temperature; the first two also with the three of a gyroscope behind; or any with a\n"
    "header that names them:\n",
    COLUMNS_NAMES,
    "Separators are semicolons, commas, tabs or blanks; lines beginning with #, % or // are\n"
    "comments. What LOG was taken for is told in the first line of the result.\n"
    "Nine positions are the least, twelve to eighteen in all directions are good. A position\n"
    "that contradicts the others is left out and named, if eleven or more are there to tell.\n"
    "\n"
    "A gyroscope (columns gx gy gz, or w_x .., gyro_x .., GyrX .., angular_velocity.x ..) is\n"
    "calibrated with it: between two rests it must turn the one way up into the other. Twelve\n"
    "quarter turns between the six faces, each within ten seconds, tell both sensors whole.\n"
    "\n" CHOSEN_OPTION,
    "  --positions         each row of LOG is the mean of one position: x y z, or x y z std n\n"
    "                      (standard deviation and number of the samples), or\n"
    "                      x y z std_x std_y std_z n, or with a header\n"
    "  --rate HZ           samples a second; default: by the column t, else 100\n"
    "  --clip LOW,HIGH     the least and the greatest reading of the sensor, in input units:\n"
    "                      rests that touch them are refused\n"
    "  --keep-all          leaves no position out\n"
    "  --gyro FILE         the gyroscope is in a file of its own, columns x y z or t x y z, by "
    "the\n"
    "                      same clock or with as many rows\n"
    "  --gyro-lsb S        degrees/s in one unit of it, as 1/131; or rad/s or deg/s; default: by "
    "the\n"
    "                      header, else by the moves\n"
    "  --gyro-axes X,Y,Z   its axes that turn about the accelerometer's x, y, z, as y,-x,z\n"
    "  --accelerometer-only\n"
    "                      leaves a gyroscope out\n",
    "  --gravity G[+-S]    length of the field, in the unit of the result, and what it may be "
    "wrong\n"
    "                      by; default 9.80665+-0.027 (m/s^2), as is true anywhere on Earth. For "
    "a\n"
    "                      magnetometer that of the earth's field, e.g. 48.5 (uT). The scales "
    "inherit\n"
    "                      its error, all alike\n"
    "  --latitude DEG      in place of --gravity: normal gravity there (WGS 84), north positive;\n"
    "                      the real one differs by some 0.0005 m/s^2, which scales all readings\n"
    "                      alike and does nothing else\n"
    "  --height M          above the sea, m; default 0\n"
    "  --frame symmetric|triangular|stand|accelerometer\n"
    "                      symmetric (default): axes as near to the case as can be;\n"
    "                      triangular: only the x sensor feels a field along the x axis;\n"
    "                      stand: turned to the axes of the stand, by its angles;\n"
    "                      accelerometer: a magnetometer's turned to those of the accelerometer\n"
    "                      that LOG has as well\n"
    "  --case +z,-x,.,...  which way of the case was up in the first positions of LOG, a dot where "
    "it\n"
    "                      is not known: turns the result to the axes of the case. Two ways or\n"
    "                      more tell it; one levels. Each face twice, turned by half between,\n"
    "                      cancels the tilt of the table\n"
    "  --sensor NAME[:RANGE]\n"
    "                      what the log holds counts of, as mpu6050:4g: the data sheet gives "
    "zero,\n"
    "                      scale and limits, unless --zero, --lsb, --tolerance do. --sensor list\n"
    "                      names those that are known, and needs no LOG\n"
    "  --zero X,Y,Z        nominal reading in no field, in input units\n"
    "  --lsb S | SX,SY,SZ  nominal scale, in field units per input unit: 9.80665/16384 of 16384\n"
    "                      counts per g\n"
    "                      Both come from the unit of the readings (zero 0) where that is g, mg "
    "or\n"
    "                      m/s^2. Where nothing states them, how far the sensor is from nominal "
    "is\n"
    "                      not told\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts; default: by the header,\n"
    "                      else by their size. That counts as stated if nine in ten are as long "
    "as\n"
    "                      gravity in g or m/s2 and they do not all point one way; of mg it names\n"
    "                      the unit only, for sensors of 1000 counts a g are common\n"
    "  --units everyday|ins\n"
    "                      of figures for people, in the table and the report: mg, % and degrees\n"
    "                      (default), or those of inertial navigation, ug, ppm and arcsec. JSON\n"
    "                      has units of its own\n"
    "  --nominal CAL.json  an earlier calibration in place of --zero and --lsb\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n",
    "  --noise S           standard deviation of one position mean on each axis, in field units;\n"
    "                      default: from std and n, else not known\n"
    "  --prior D,K,G       standard deviations of what the nominal calibration may be wrong by:\n"
    "                      offsets (over the field: 0.02 is 20 mg), scale errors (0.01 is 1 %),\n"
    "                      angles (rad); up to about 0.2; 0 says nothing. Then fewer\n"
    "                      positions will do. Needs the noise, and --sensor, --unit, --zero and\n"
    "                      --lsb, or --nominal\n"
    "  --six-faces         each axis up and down, six positions, tells offsets and scales but no\n"
    "                      angles: takes these as 0 with the standard deviation 0.01 rad (0.57\n"
    "                      degrees, a data sheet's 1 % cross-axis), or G of --prior 0,0,G, and\n"
    "                      tells what that costs. Needs the noise\n"
    "  --magnetometer      LOG is a magnetometer that was waved for a minute, not held still: its\n"
    "                      columns (mx my mz) beside others. Needs no rests and no field: without\n"
    "                      --gravity the result is in the unit of the readings, by their mean\n"
    "                      scale. Names a magnet that passed by, a step, a field that differs "
    "from\n"
    "                      place to place. Of an accelerometer beside it, how the axes of both "
    "are\n"
    "                      turned against each other\n"
    "  --with CAL.json     the calibration of that accelerometer; else it is taken as it reads\n"
    "  --robust            a cross-check: does the estimate with the least sum of absolute "
    "residuals\n"
    "                      (l1) of all positions agree with this one, outliers left out?\n"
    "  --quadratic         each axis may read q eta^2 more, too: what 14 positions or more tell of "
    "q\n"
    "  --cubic             and c eta^3: 17 or more. The calibration is what is linear; invcal "
    "apply\n"
    "                      takes the others off before, invcal export has no place for them\n"
    "  --stand             LOG has the angles of a two-axis stand, degrees, in columns alpha "
    "(outer)\n"
    "                      and beta (inner); up is (sin a sin b, cos a, sin a cos b). Tells how "
    "the\n"
    "                      unit is turned on the stand, what its directions make of the "
    "parameters\n"
    "                      (J1), and positions that are misset, swapped or repeated\n"
    "  --plan SET          the same, with no columns: the positions of a program of invcal plan "
    "were\n"
    "                      visited in its order:\n",
    DESIGN_WORDS,
    "  --stand-sense A,B   1 or -1: sense in which the stand counts alpha and beta; default 1,1\n"
    "  --stand-zero A,B    what it reads, degrees, where alpha and beta are 0; default 0,0\n",
    "  --thermal 1|2       offsets, scales and angles as straight lines (1) or parabolas (2) of\n"
    "                      the column temperature: nine positions or more at each of 2 (3)\n"
    "                      temperatures, 5 K (10 K) apart at least. Rests in which it drifted are\n"
    "                      left out. Where the data tell no slopes, there are none, and why\n"
    "  --slope D,K,G       standard deviations of what slopes may be, per K: of offsets (over the\n"
    "                      field), scale errors, angles (rad); 0 says nothing. Needs the noise\n"
    "  --tolerance D,K,G   limits of the data sheet for offsets (over the field), scale errors\n"
    "                      and angles (rad): PASS if all are within, their 95 % included, else\n"
    "                      FAIL, and which are not. Needs --sensor, --unit, --zero and --lsb,\n"
    "                      or --nominal\n"
    "  --need U            what calibrated lengths may be wrong by in 95 % of cases: 1mg, "
    "0.01m/s2,\n"
    "                      0.1% (mg, g, ug, m/s2, %), or a number in the unit of --gravity. PASS\n"
    "                      or FAIL, by which margin, and what is missing\n"
    "  --strict            exit code 1, with all files written, unless the verdict is good and\n"
    "                      --tolerance and --need are passed\n" RECORD_OPTIONS
    "  --out CAL.json      write the result to a file, as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures: one file that\n"
    "                      needs nothing else, for screen and paper; of what is refused, too\n"
    "  --json              print the result as JSON in place of the table\n"
    "  --json-lines        the same, or why there is none, on one line that begins with the name "
    "of\n"
    "                      LOG: for pipes\n"
    "  --quiet             print neither table nor progress, only errors\n"
    "\n"
    "exit codes: 0 calibrated, whatever the verdict; 1 the data cannot be calibrated or, with\n"
    "--strict, the verdict is not good, a limit or the need not kept; 2 usage; 3 LOG unreadable "
    "or\n"
    "malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --gravity 9.81744 \\\n"
    "      --zero 33123,33276,32360 --lsb 0.0024096,0.0024213,0.0024096 --out cal.json\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal calibrate LOG [options]\n"
    "\n"
    "Calibrates accelerometers that were held still in a dozen orientations or more, at any "
    "angle.\n"
    "LOG is a table of samples, columns x y z or t x y z, and a gyroscope's; - is the standard "
    "input.\n"
    "\n"
    "  --positions         each row of LOG is the mean of one position, not a sample\n"
    "  --gravity G[+-S]    length of the field; default 9.80665+-0.027 (m/s^2)\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts\n"
    "  --sensor NAME       the sensor, as mpu6050:4g; --sensor list names them\n"
    "  --zero X,Y,Z        or what the data sheet says: the reading in no field,\n"
    "  --lsb S             and field units per input unit\n"
    "  --six-faces         each axis up and down only: offsets and scales, no angles\n"
    "  --plan SET          the positions are those of a program, in its order\n"
    "  --magnetometer      LOG is a magnetometer that was waved, not held still\n"
    "  --need U            what lengths may be wrong by: says if they are worse\n"
    "  --out CAL.json      write the result to a file, for invcal apply and export\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON in place of the table\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --out cal.json\n",
    NULL};

const tool_command calibrate_command = {"calibrate", "a log, or position means, to a calibration",
                                        help, run_calibrate, brief};
