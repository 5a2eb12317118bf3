/* SPDX-License-Identifier: MIT
 *
 * invcal calibrate: from a log or position means to a calibration.
 */
#include "calibrate/calibrate.h"

#include <string.h>

#include "calibrate/deliver.h"
#include "calibrate/refuse.h"
#include "calibrate/resolve.h"
#include "calibrate/solve.h"
#include "cli/command.h"
#include "cli/output.h"
#include "cli/message.h"
#include "cli/progress.h"
#include "design/design.h"
#include "fit/sensors.h"
#include "read/columns_option.h"
#include "read/columns.h"
#include "result/gyro.h"
#include "result/pass.h"

/* With --strict the exit code depends on the verdict. All files have been written. */
static int check_strict(const request *r, const calibrate_result *result)
{
    char reason[PASS_MAX];
    char fault[GYRO_TEXT_MAX];

    if (!r->value[OPT_STRICT] || result->refused.word) {
        return EXIT_GOOD; /* data that were refused have an exit code already */
    }
    if (*pass_strict(result, reason)) {
        message("%s: --strict: %s", result->data->name, reason);
        return EXIT_DATA;
    }
    if (*gyro_fault(&result->gyro, fault)) {
        message("%s: --strict: the gyroscope is %s", result->data->name, fault);
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}

/* What is known before the data are read. */
static calibrate_result begin_result(const request *r, const positions *data,
                                     const rests_summary *log)
{
    return (calibrate_result){
        .data = data,
        .log = r->value[OPT_POSITIONS] ? NULL : log,
        .settings = r->settings,
        .field_unit = r->field_unit,
        .place = r->value[OPT_LATITUDE] ? r->place : NULL,
        .units = r->units,
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

/* From positions, or from the rests of a log. */
static int solve_log(const request *r, positions *data, rests_summary *log, gyro_log *gyro,
                     calibrate_result *result, positions_reader *read)
{
    const int failure = read(r, data, log, gyro);

    if (failure) {
        return failure;
    }
    if (data->count == 0 && !r->value[OPT_POSITIONS]) {
        return calibrate_refuse_no_rest(result);
    }
    resolve_unit(r, data);
    return solve_positions(r, data, gyro, result);
}

/* From the log of a magnetometer, which has no rests. */
static int solve_magnetometer_log(const request *r, positions *data, magnetometer_log *log,
                                  calibrate_result *result, magnetometer_reader *read)
{
    int failure = resolve_magnetometer(r, &result->nominal);

    result->log = NULL;
    result->magnetometer = log;
    failure = failure ? failure : read(r, &result->nominal.calibration, data, log);
    return failure                    ? failure
           : log->status != INVCAL_OK ? calibrate_refuse_magnetometer(result)
                                      : solve_magnetometer(r, data, result);
}

int calibrate_run(int argc, char **argv, int is_live, const calibrate_readers *read)
{
    request r;
    positions data = {.name = NULL};
    magnetometer_log magnetometer = {.samples = 0};
    rests_summary log;
    calibrate_result result = {.data = NULL};
    gyro_log gyro = {.file = NULL};

    if (asks_for_list(argc, argv)) {
        sensors_list(stdout);
        return output_flush();
    }
    int failure = request_read(argc, argv, is_live, &r);
    if (failure) {
        return failure;
    }
    if (r.value[OPT_QUIET]) {
        progress_quiet();
    }
    json_lines(r.value[OPT_JSON_LINES] ? r.file : NULL);
    result = begin_result(&r, &data, &log);
    resolve_limits(&r, &result);
    gyro.file = r.value[OPT_GYRO];
    failure = r.value[OPT_MAGNETOMETER]
                  ? solve_magnetometer_log(&r, &data, &magnetometer, &result, read->magnetometer)
                  : solve_log(&r, &data, &log, &gyro, &result, read->rests);
    failure = result.refused.word ? deliver_refusal(&r, &result)
              : failure           ? failure
                                  : deliver(&r, &result);
    if (failure == EXIT_FILE && r.value[OPT_JSON_LINES]) {
        deliver_unreadable();
    }
    failure = failure ? failure : check_strict(&r, &result);
    stand_free(&result.stand);
    rejection_free(&result.rejected);
    positions_free(&data);
    magnetometer_log_free(&magnetometer);
    gyro_log_free(&gyro);
    json_lines(NULL);
    return failure;
}

/* The positions of the file, or the rests of a log. */
static int read_positions(const request *r, positions *data, rests_summary *log, gyro_log *gyro)
{
    const double *clip = r->value[OPT_CLIP] ? r->clip : NULL;

    return r->value[OPT_POSITIONS]
               ? positions_read(data, r->file)
               : rests_read(data, r->file, r->rate, clip,
                            r->value[OPT_ACCELEROMETER_ONLY] ? NULL : gyro, log);
}

static int read_magnetometer(const request *r, const invcal_calibration *nominal, positions *data,
                             magnetometer_log *log)
{
    const magnetometer_log_options options = {.path = r->file, .rate = r->rate, .nominal = nominal};

    return magnetometer_log_read(data, &options, log);
}

static int run_calibrate(int argc, char **argv)
{
    static const calibrate_readers readers = {read_positions, read_magnetometer};

    return calibrate_run(argc, argv, 0, &readers);
}

static const char *const help[] = {
    "usage: invcal calibrate LOG [options]\n"
    "\n"
    "Calibrates a triad of accelerometers (or magnetometers) from a dozen or more static\n"
    "positions, in any order and at any angle. Every position measures the same field. Only\n"
    "the length of the field must be known, not its direction. Result:\n"
    "\n"
    "  calibrated = matrix (raw - offset)\n"
    "\n"
    "LOG is a table of samples; - reads the standard input. Static intervals of two seconds\n"
    "or more (rests) are found in it. Turn briskly between them: a turn of more than five\n"
    "seconds may pass for a rest where it starts and ends slowly. Columns are x y z, or t x y\n"
    "z (t in seconds), or t x y z temperature; the first two may be followed by the three of\n"
    "a gyroscope. Any other order needs a header with these names:\n",
    COLUMNS_NAMES,
    "Separators are semicolons, commas, tabs or blanks. Lines that begin with #, % or // are\n"
    "comments. The first line of the result says what was recognised in LOG. Nine positions\n"
    "are the minimum; use twelve to eighteen, in all directions. With eleven or more, a\n"
    "position that contradicts the others is reported and left out.\n"
    "\n"
    "A gyroscope (columns gx gy gz, or w_x .., gyro_x .., GyrX .., angular_velocity.x ..) is\n"
    "calibrated from the turns between the rests; each must change which way is up. Twelve\n"
    "quarter turns through the six faces, each within ten seconds, determine both sensors\n"
    "completely.\n"
    "\n",
    COLUMNS_OPTION_HELP,
    "  --positions         each row of LOG is the mean of one position: x y z; or x y z std n\n"
    "                      (standard deviation and number of samples); or x y z std_x std_y\n"
    "                      std_z n; or any order with a header\n"
    "  --rate HZ           samples per second; default: from column t, else 100\n"
    "  --clip LOW,HIGH     limits of the sensor's range, in input units: rests that reach\n"
    "                      them are refused\n"
    "  --keep-all          keep outliers: leave no position out\n"
    "  --gyro FILE         read the gyroscope from a second file, columns x y z or t x y z,\n"
    "                      with the same clock or the same number of rows\n"
    "  --gyro-lsb S        scale of the gyroscope, degrees/s per input unit, such as 1/131;\n"
    "                      or rad/s or deg/s; default: from the header, else from the moves\n"
    "  --gyro-axes X,Y,Z   which of its axes turn about x, y, z of the accelerometer, such as\n"
    "                      y,-x,z\n"
    "  --accelerometer-only\n"
    "                      ignore the gyroscope\n",
    "  --gravity G[+-S]    length of the field, and its standard deviation; default\n"
    "                      9.80665+-0.027 (m/s^2), which holds anywhere on Earth. Its unit is\n"
    "                      that of the result (field unit): 1 gives g. For a magnetometer,\n"
    "                      the length of the earth's field, e.g. 48.5 or 48.5uT. Its error\n"
    "                      scales all readings alike\n"
    "  --latitude DEG      instead of --gravity: normal gravity at this latitude (WGS 84),\n"
    "                      north positive. Local gravity differs from it by about 0.0005\n"
    "                      m/s^2, which scales all readings alike\n"
    "  --height M          with --latitude: height above sea level, m; default 0\n"
    "  --frame symmetric|triangular|stand|accelerometer\n"
    "                      axes of the result. symmetric (default): as close as possible to\n"
    "                      those of the three sensors; triangular: only the x sensor responds\n"
    "                      to a field along the x axis; stand: those of the stand, by its\n"
    "                      angles; accelerometer: for a magnetometer, those of the\n"
    "                      accelerometer in LOG\n"
    "  --case +z,-x,.,...  which axis of the case pointed up in the first positions of LOG, a\n"
    "                      dot where unknown: rotates the result to the axes of the case. Two\n"
    "                      axes or more determine the rotation; one only levels it. To\n"
    "                      cancel the tilt of the table, put down all faces, then all again,\n"
    "                      each turned by half a turn: --case +x,-z,+z,+y,+x,-z,+z,+y\n"
    "  --sensor NAME[:RANGE]\n"
    "                      the sensor whose counts LOG holds, such as mpu6050:4g. Takes zero,\n"
    "                      scale and limits from its data sheet, unless --zero, --lsb or\n"
    "                      --tolerance state them. --sensor list prints the known sensors and\n"
    "                      needs no LOG\n"
    "  --zero X,Y,Z        reading at zero field by the data sheet, in input units: 0,0,0 for\n"
    "                      signed counts, 32768,32768,32768 for unsigned ones of 16 bits\n"
    "  --lsb S | SX,SY,SZ  what one input unit (one count) is by the data sheet, in m/s^2, or\n"
    "                      in the unit of --gravity: 9.80665/16384 for 16384 counts per g;\n"
    "                      one number, or one for each axis. Refused if the readings do not\n"
    "                      fit it. Readings in g, mg or m/s^2 need neither --zero nor --lsb.\n"
    "                      Without them the calibration is the same, but errors of offset and\n"
    "                      scale are not reported\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts; default: from the\n"
    "                      header, else from their size. The size decides for g and m/s2 if\n"
    "                      nine readings in ten have the length of gravity and they do not\n"
    "                      all point one way. Readings of the size of mg may be counts, since\n"
    "                      many sensors have 1000 counts per g: state --unit mg\n"
    "  --units everyday|ins\n"
    "                      units in the table and the report: mg, % and degrees (default), or\n"
    "                      those of inertial navigation: ug, ppm and arcsec. JSON has its own\n"
    "                      units\n"
    "  --nominal CAL.json  an earlier calibration as the nominal one, instead of --zero and\n"
    "                      --lsb\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n",
    "  --noise S           standard deviation of one position mean on each axis, in field\n"
    "                      units; default: from the samples of each rest, or from std and n;\n"
    "                      else unknown\n"
    "  --prior D,K,G       standard deviations of the errors of the nominal calibration:\n"
    "                      offsets (over the field: 0.02 is 20 mg), scale errors (0.01 is 1\n"
    "                      %), angles (rad). 0 means unknown, the maximum is about 0.2. Fewer\n"
    "                      positions are then sufficient. Needs the noise, and --sensor,\n"
    "                      --unit, --zero and --lsb, or --nominal\n"
    "  --six-faces         each axis up and down: six positions, which determine offsets and\n"
    "                      scales but not the angles. Takes the angles as 0 with a standard\n"
    "                      deviation of 0.01 rad (0.57 degrees, the 1 % cross-axis of data\n"
    "                      sheets), or G of --prior 0,0,G, and reports the accuracy that this\n"
    "                      costs. Needs the noise\n"
    "  --magnetometer      LOG is of a magnetometer that was waved for a minute, not held\n"
    "                      still: columns mx my mz, others are allowed. Needs neither rests\n"
    "                      nor the field: without --gravity, the result is in the unit of the\n"
    "                      readings, by their mean scale. Reports a magnet that passed by, a\n"
    "                      step, and a field that differs from place to place; with an\n"
    "                      accelerometer in LOG, also the rotation between the axes of the\n"
    "                      two sensors\n"
    "  --with CAL.json     with --magnetometer: calibration of the accelerometer in LOG;\n"
    "                      default: its readings are used as they are\n"
    "  --robust            cross-check: compare with the least-absolute-residuals (l1)\n"
    "                      estimate from all positions, outliers included\n"
    "  --quadratic         also estimate a quadratic error q e^2 of each axis, where e is the\n"
    "                      field along the axis over its length, -1 to 1. Needs 14 positions\n"
    "  --cubic             and a cubic one, c e^3. Needs 17 positions. invcal apply removes\n"
    "                      these errors before it applies offset and matrix; invcal export\n"
    "                      refuses them\n"
    "  --stand             LOG has the angles of a two-axis stand, degrees, in columns alpha\n"
    "                      (outer) and beta (inner); up is (sin a sin b, cos a, sin a cos b).\n"
    "                      Reports how the sensor is mounted on the stand, the parameters as\n"
    "                      its angles give them (J1), and positions that are wrongly set,\n"
    "                      swapped or repeated\n"
    "  --plan SET          the same without the columns: the positions are those of a set of\n"
    "                      invcal plan, in its order:\n",
    DESIGN_WORDS,
    "  --stand-sense A,B   1 or -1: the sense in which the stand counts alpha and beta;\n"
    "                      default 1,1\n"
    "  --stand-zero A,B    angles that the stand shows, degrees, where alpha and beta are 0;\n"
    "                      default 0,0\n",
    "  --thermal 1|2       fit offsets, scales and angles as straight lines (1) or parabolas\n"
    "                      (2) over the column temperature. Needs nine positions or more at\n"
    "                      each of 2 (3) temperatures, which span 5 K (10 K) or more. Rests\n"
    "                      in which the temperature drifted are left out. If the data do not\n"
    "                      determine the slopes, they are not fitted, and the result says why\n"
    "  --slope D,K,G       standard deviations of the slopes to expect, per K: of offsets\n"
    "                      (over the field), scale errors, angles (rad); 0 means unknown.\n"
    "                      Needs the noise\n"
    "  --tolerance D,K,G   limits of the data sheet for offsets, scale errors and angles, as\n"
    "                      50mg,3%,2deg; without units over the field, as ratios and in rad:\n"
    "                      0.05,0.03,0.035. PASS if all nine errors are within them,\n"
    "                      including their 95 % uncertainty; else FAIL, naming those that are\n"
    "                      not. Needs --sensor, --unit, --zero and --lsb, or --nominal\n"
    "  --need U            largest acceptable error of calibrated lengths in 95 % of cases:\n"
    "                      1mg, 0.01m/s2, 0.1% (mg, g, ug, m/s2, %), or a number in the unit\n"
    "                      of --gravity; at most a tenth of the field. PASS or FAIL, with the\n"
    "                      margin and what is missing\n"
    "  --strict            exit with 1, after writing all files, unless the verdict is good\n"
    "                      and --tolerance and --need pass\n",
    RECORD_OPTIONS,
    "  --out CAL.json      write the result as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures: one\n"
    "                      self-contained file, for screen and paper; also if the data are\n"
    "                      refused\n"
    "  --json              print the result as JSON instead of the table\n"
    "  --json-lines        the same on one line, which begins with the name of LOG, for\n"
    "                      pipes; an error, too, is printed as JSON\n"
    "  --quiet             print neither table nor progress, only errors\n"
    "\n"
    "exit codes: 0 calibrated, whatever the verdict; 1 the data cannot be calibrated or, with\n"
    "--strict, the verdict is not good, or a limit or the need is exceeded; 2 usage; 3 LOG\n"
    "unreadable or malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --gravity 9.81744 \\\n"
    "      --zero 33123,33276,32360 --lsb 0.0024096,0.0024213,0.0024096 --out cal.json\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal calibrate LOG [options]\n"
    "\n"
    "Calibrates accelerometers from a dozen or more static positions, at any angle. LOG is a\n"
    "table of samples, columns x y z or t x y z, optionally with those of a gyroscope; -\n"
    "reads the standard input.\n"
    "\n"
    "  --positions         each row of LOG is the mean of one position, not a sample\n"
    "  --gravity G[+-S]    length of the field; default 9.80665+-0.027 (m/s^2)\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts\n"
    "  --sensor NAME       the sensor, such as mpu6050:4g; --sensor list names them\n"
    "  --zero X,Y,Z        or, by its data sheet, the reading at zero field,\n"
    "  --lsb S             and what one count is, in m/s^2: 9.80665/16384\n"
    "  --six-faces         each axis up and down only: offsets and scales, no angles\n"
    "  --plan SET          the positions are those of invcal plan, in its order\n"
    "  --magnetometer      LOG is of a magnetometer that was waved, not held still\n"
    "  --need U            largest acceptable error of lengths: PASS or FAIL\n"
    "  --out CAL.json      write the result to a file, for invcal apply and export\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON instead of the table\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --out cal.json\n",
    NULL};

const tool_command calibrate_command = {
    "calibrate", "compute a calibration from a log or position means", help, run_calibrate, brief};
