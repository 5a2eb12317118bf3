/* SPDX-License-Identifier: MIT
 *
 * invcal watch: leads through a calibration while the samples come in.
 */
#include <string.h>

#include "calibrate/calibrate.h"
#include "cli/command.h"
#include "design/design.h"
#include "read/chosen.h"
#include "read/noise_file.h"
#include "result/calibration_file.h"
#include "watch/live.h"
#include "watch/wave.h"

/* Where there is talk: to stdout, beside JSON to stderr, and with --quiet nowhere, which is to be closed. */
static FILE *begin_talk(const request *r, live_wish *wish)
{
    FILE *nowhere = r->value[ASK_QUIET] ? fopen("/dev/null", "w") : NULL;

    wish->talk = nowhere ? nowhere : r->value[ASK_JSON] ? stderr : stdout;
    return nowhere;
}

static void end_talk(FILE *nowhere)
{
    if (nowhere) {
        fclose(nowhere);
    }
}

/* What is asked of both. */
static live_wish wish_of(const request *r)
{
    live_wish wish = {.rate = r->rate, .field = r->settings.field, .told = r->told};

    memcpy(wish.target, r->target, sizeof wish.target);
    wish.need = r->need / r->settings.field;
    wish.field_sigma = r->field_sigma / r->settings.field;
    return wish;
}

/* The positions that a live stream rests in. */
static int read_live(const request *r, positions *data, rests_summary *log, turns *gyro)
{
    invcal_calibration nominal;
    invcal_noise noise[3];
    live_wish wish = wish_of(r);

    wish.unit = r->unit;
    wish.clip = r->value[ASK_CLIP] ? r->clip : NULL;
    wish.gyro = r->gyro;
    wish.set = r->program;
    if (r->value[ASK_NOMINAL]) {
        const int failure = calibration_file_read(r->value[ASK_NOMINAL], &nominal);
        if (failure) {
            return failure;
        }
        wish.nominal = &nominal;
    }
    wish.sensor = r->sensor;
    wish.zero = r->value[ASK_ZERO] ? r->zero : NULL;
    wish.lsb = r->value[ASK_LSB] ? r->lsb : NULL;
    wish.mean_sigma = r->mean_sigma;
    if (r->value[ASK_ALLAN]) {
        const int failure = noise_file_read(r->value[ASK_ALLAN], noise);
        if (failure) {
            return failure;
        }
        wish.noise = noise;
    }
    FILE *nowhere = begin_talk(r, &wish);
    const int failure =
        live_read(data, r->file, &wish, r->value[ASK_ACCELEROMETER_ONLY] ? NULL : gyro, log);
    end_talk(nowhere);
    return failure;
}

/* A magnetometer that is waved. Of a field that is not stated a part is asked for by %, else a number in the unit of
 * the readings. */
static int read_waved(const request *r, const invcal_calibration *nominal, positions *data,
                      waved *log)
{
    live_wish wish = wish_of(r);

    if (!r->value[ASK_GRAVITY] && r->value[ASK_NEED] && !strchr(r->value[ASK_NEED], '%')) {
        wish.field = 0;
    }
    FILE *nowhere = begin_talk(r, &wish);
    const int failure = wave_read(data, r->file, nominal, &wish, log);
    end_talk(nowhere);
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
    "Leads through a calibration while the samples come in: tells when to hold still and when to\n"
    "move on, where to turn next, and how exactly everything is known so far. At the end of the\n"
    "stream it prints what invcal calibrate prints of the same samples.\n"
    "\n"
    "On a terminal of at least 80 by 24 it is a screen: @ is the side that is up, X the one that\n"
    "should be, dots are directions done, bars what is uncertain; a bell when a position is good,\n"
    "one is refused, and when you may stop. Elsewhere, and with --json, it prints lines.\n"
    "\n"
    "LOG is a stream of samples, as a rule - for the standard input: a serial port, or invcal\n"
    "simulate. Its columns are those of invcal calibrate; of a gyroscope among them it tells from "
    "the\n"
    "fifth position on what the moves tell, or what is wrong with it, and where to turn is the "
    "turn\n"
    "that tells most of both sensors. Ctrl-C ends it, with the result.\n"
    "Malformed lines are told and skipped.\n"
    "\n"
    "  --plan SET          follows a set of positions, with the angles of a stand; a rest in "
    "another\n"
    "                      position is named, and used. Default: the direction that tells most, "
    "from\n"
    "                      what has been taken. One of\n",
    DESIGN_WORDS,
    "  --mean-sigma S      holds each position until its mean is as good, in field units, by the\n"
    "                      noise of the first rest; default: 2 seconds\n"
    "  --allan NOISE.json  the same by all that invcal allan --out has found in a long rest:\n"
    "                      what does not average out, too\n"
    "  --target D,K,G      sigma of offsets (over the field), scale errors and angles (rad) that\n"
    "                      is enough; 0: any\n"
    "  --zero X,Y,Z        nominal reading in no field; default for the guidance: 0, from the\n"
    "                      fourth position on the middle of each axis' range; with --plan, where\n"
    "                      that is far off, what its first three positions tell\n"
    "  --lsb S | SX,SY,SZ  nominal scale; default for the guidance: by the unit that is\n"
    "                      stated or --sensor, else from the first samples\n",
    "\n"
    "These are the options of invcal calibrate, whose help says more of them:\n"
    "\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --latitude DEG      normal gravity there in its place,\n"
    "  --height M          so high above the sea, m\n"
    "  --frame symmetric|triangular|accelerometer\n"
    "                      of the result; default symmetric\n"
    "  --case +z,-x,.,...  which way of the case was up in the first positions\n"
    "  --unit g|mg|m/s2|counts\n"
    "                      of the readings\n"
    "  --units everyday|ins\n"
    "                      of figures for people: mg, % and degrees, or ug, ppm and arcsec\n"
    "  --nominal CAL.json  an earlier calibration in place of --zero and --lsb\n"
    "  --sensor NAME[:RANGE]\n"
    "                      of a data sheet, zero, scale and limits; --sensor list names them\n"
    "  --nominal-name WORD heading of the nominal column; default nominal\n"
    "  --noise S           standard deviation of one position mean, in field units\n"
    "  --prior D,K,G       standard deviations of what the nominal may be wrong by\n"
    "  --six-faces         takes the angles, which six faces do not tell, as 0 +- 0.01 rad\n"
    "  --magnetometer      one is waved, not held still: turn the field, @, through the white "
    "part\n"
    "  --with CAL.json     the calibration of the accelerometer beside it\n"
    "  --thermal 1|2       straight lines or parabolas of temperature\n"
    "  --slope D,K,G       standard deviations of what slopes may be, per K\n" CHOSEN_OPTION,
    "  --rate HZ           samples a second; default: by the column t, else 100\n"
    "  --clip LOW,HIGH     the least and the greatest reading of the sensor\n"
    "  --keep-all          leaves no position out\n"
    "  --gyro-lsb S        degrees/s in one unit of a gyroscope, or rad/s or deg/s\n"
    "  --gyro-axes X,Y,Z   its axes that turn about the accelerometer's x, y, z, as y,-x,z\n"
    "  --accelerometer-only\n"
    "                      leaves a gyroscope out\n"
    "  --need U            what calibrated lengths may be wrong by in 95 % of cases, 1mg, 0.1% or "
    "in\n"
    "                      the unit of --gravity: says when that is reached\n"
    "  --tolerance D,K,G   limits of the data sheet: PASS or FAIL, and which are not kept\n"
    "  --strict            exit code 1 unless the verdict is good and both are "
    "passed\n" RECORD_OPTIONS
    "  --out CAL.json      write the result to a file, as JSON, for invcal apply\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON in place of the table, the guidance on\n"
    "                      stderr\n"
    "  --json-lines        the same on one line, for pipes\n"
    "  --quiet             print neither guidance nor table, only errors\n"
    "\n"
    "exit codes: 0 calibrated, whatever the verdict; 1 the data cannot be calibrated or, with\n"
    "--strict, are not good; 2 usage; 3 LOG unreadable or malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges | invcal watch -\n",
    NULL};

static const char *const watch_brief[] = {
    "usage: invcal watch LOG [options]\n"
    "\n"
    "Leads through a calibration while the samples come in, as a rule on the standard input (-): "
    "tells\n"
    "when to hold still, when to move on and where to, and calibrates at the end. Ctrl-C ends it.\n"
    "\n"
    "  --plan SET          follows a set of positions: edges, faces, per-group:N, optimal:N ...\n"
    "  --target D,K,G      sigma of offsets (over the field), scale errors and angles (rad) that "
    "is\n"
    "                      enough\n"
    "  --need U            what calibrated lengths may be wrong by: says when that is reached\n"
    "  --magnetometer      one is waved: turn the field through the white part\n"
    "  --gravity G         length of the field; default 9.80665 (m/s^2)\n"
    "  --unit U            unit of the readings: g, mg, m/s2 or counts\n"
    "  --rate HZ           samples a second; default: by the column t, else 100\n"
    "  --out CAL.json      write the result to a file, for invcal apply and export\n"
    "  --report R.html     write a page with the verdict, figures and pictures\n"
    "  --json              print the result as JSON, the guidance on stderr\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges | invcal watch -\n",
    NULL};

const tool_command watch_command = {"watch", "lead through a calibration, live", watch_help,
                                    run_watch, watch_brief};
