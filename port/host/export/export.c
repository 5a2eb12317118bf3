/* SPDX-License-Identifier: MIT
 *
 * invcal export: a calibration in the formats of other systems.
 */
#include "export/format.h"

#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "export/driver.h"
#include "cli/files.h"
#include "cli/input.h"
#include "cli/message.h"
#include "text/number.h"
#include "cli/options.h"
#include "cli/output.h"
#include "text/unit.h"

enum { FORMAT, NAME, ZERO, LSB, INSTANCE, DEVICE_ID, OUT, OPTIONS };

static const option options[OPTIONS] = {
    [FORMAT] = {"--format", 1}, [NAME] = {"--name", 1},         [ZERO] = {"--zero", 1},
    [LSB] = {"--lsb", 1},       [INSTANCE] = {"--instance", 1}, [DEVICE_ID] = {"--device-id", 1},
    [OUT] = {"--out", 1},
};
static const char *const operands[] = {"CAL.json"};
static const option_syntax syntax = {"export", options, OPTIONS, operands, 1, 0};

/* What a format must need for an option to make sense. */
static const unsigned option_needs[OPTIONS] = {
    [NAME] = EXPORT_NAMED,        [ZERO] = EXPORT_DRIVER,        [LSB] = EXPORT_DRIVER,
    [INSTANCE] = EXPORT_INSTANCE, [DEVICE_ID] = EXPORT_INSTANCE,
};

static const export_format *const formats[] = {
    &export_c,   &export_c_arrays, &export_px4,         &export_ardupilot,
    &export_ros, &export_imu_tk,   &export_imu_tk_gyro, &export_fusion,
};

#define FORMATS (sizeof formats / sizeof formats[0])
#define NAME_LENGTH 60u

typedef struct {
    const char *path;
    const char *value[OPTIONS];
    const export_format *format;
    double zero[3];
    double lsb[3];
} request;

static int usage(unsigned which, const char *what)
{
    return message_usage(syntax.command, "%s: %s", options[which].name, what);
}

static int read_format(request *r)
{
    for (unsigned i = 0; i < FORMATS && r->value[FORMAT]; i++) {
        if (strcmp(r->value[FORMAT], formats[i]->name) == 0) {
            r->format = formats[i];
        }
    }
    if (!r->format) {
        return usage(
            FORMAT, "must be one of c, c-arrays, px4, ardupilot, ros, imu_tk, imu_tk-gyro, fusion");
    }
    for (unsigned i = 0; i < OPTIONS; i++) {
        if (r->value[i] && (option_needs[i] & ~r->format->takes)) {
            return message_usage(syntax.command, "%s: --format %s does not use it", options[i].name,
                                 r->format->name);
        }
    }
    return EXIT_GOOD;
}

static int is_keyword(const char *word)
{
    static const char *const keywords[] = {
        "auto",    "break",  "case",     "char",   "const",    "continue", "default",
        "do",      "double", "else",     "enum",   "extern",   "float",    "for",
        "goto",    "if",     "inline",   "int",    "long",     "register", "restrict",
        "return",  "short",  "signed",   "sizeof", "static",   "struct",   "switch",
        "typedef", "union",  "unsigned", "void",   "volatile", "while",
    };

    for (unsigned i = 0; i < sizeof keywords / sizeof keywords[0]; i++) {
        if (strcmp(word, keywords[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

/* A name is copied into C source. A leading underscore is reserved. */
static int read_name(const char *name)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    static const char others[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

    if (name && (!strchr(letters, *name) || name[strspn(name, others)] != '\0' ||
                 strlen(name) > NAME_LENGTH || is_keyword(name))) {
        return usage(NAME, "must be a C identifier: a letter, then letters, digits or _, at most "
                           "60, and not a keyword");
    }
    return EXIT_GOOD;
}

static int read_scale(request *r)
{
    int failure = EXIT_GOOD;
    int single = 0;

    if (!r->value[ZERO] != !r->value[LSB]) {
        return usage(r->value[ZERO] ? ZERO : LSB, "state both --zero and --lsb");
    }
    if (r->value[LSB]) {
        failure = options_numbers(&syntax, ZERO, r->value[ZERO], 3, r->zero, NULL);
        failure =
            failure ? failure : options_numbers(&syntax, LSB, r->value[LSB], 3, r->lsb, &single);
        r->lsb[1] = single ? r->lsb[0] : r->lsb[1];
        r->lsb[2] = single ? r->lsb[0] : r->lsb[2];
    }
    for (unsigned i = 0; i < 3 && !failure && r->value[LSB]; i++) {
        failure = fabs(r->lsb[i]) > 0 ? EXIT_GOOD : usage(LSB, "a scale must not be 0");
    }
    return failure;
}

static int read_integer(unsigned which, const char *value, double low, double high, double *out)
{
    if (!value) {
        return EXIT_GOOD;
    }
    const int failure = options_numbers(&syntax, which, value, 1, out, NULL);
    if (!failure && !(*out >= low && *out <= high && !(floor(*out) < *out))) {
        return message_usage(syntax.command, "%s: must be a whole number from %.0f to %.0f",
                             options[which].name, low, high);
    }
    return failure;
}

static int check_files(const request *r)
{
    const named_file input = {"CAL.json", r->path};
    const named_file output_file = {"--out", r->value[OUT]};

    return files_check(syntax.command, &input, 1, &output_file, 1);
}

static int read_request(int argc, char **argv, request *r, export_job *job)
{
    double instance = 0;
    int failure = options_parse(&syntax, argc, argv, r->value, &r->path);

    failure = failure ? failure : read_format(r);
    failure = failure ? failure : read_name(r->value[NAME]);
    failure = failure ? failure : read_scale(r);
    failure = failure ? failure : read_integer(INSTANCE, r->value[INSTANCE], 0, 3, &instance);
    failure = failure
                  ? failure
                  : read_integer(DEVICE_ID, r->value[DEVICE_ID], 1, 2147483647, &job->device_id);
    failure = failure ? failure : check_files(r);
    job->instance = failure ? 0 : (unsigned)instance;
    job->name = r->value[NAME];
    job->source = failure ? NULL : input_name(r->path);
    job->format = failure ? NULL : r->format->name;
    return failure;
}

/* Warns of a calibration that is exported although it is not good. */
static void warn(const export_job *job)
{
    const calibration_file *c = &job->file;

    if (c->suspected > 0) {
        message("warning: %s: %.0f positions contradict one another; exported anyway", job->source,
                c->suspected);
    }
    if (*c->undetermined) {
        message("warning: %s: %s calibration: %s poorly determined; exported anyway", job->source,
                *c->verdict ? c->verdict : "this", c->undetermined);
    } else if (strcmp(c->verdict, "no redundancy") == 0) {
        message("warning: %s: no redundancy to check it; exported anyway", job->source);
    } else if (*c->verdict && strcmp(c->verdict, "good") != 0 && !(c->suspected > 0)) {
        message("warning: %s: %s calibration; exported anyway", job->source, c->verdict);
    }
}

/* The linear part alone is not the best linear calibration, which would include a part of the
 * nonlinear terms. */
static int refuse_nonlinear(const export_job *job)
{
    return message_usage(syntax.command,
                         "%s has quadratic or cubic errors, which --format %s cannot correct: "
                         "export a calibration made without --quadratic and --cubic",
                         job->source, job->format);
}

/* All checks, before anything is written. */
static int check_job(const request *r, export_job *job)
{
    const unsigned takes = r->format->takes;
    const double gravity = job->file.gravity;
    int failure = EXIT_GOOD;

    job->si = job->file.is_magnetometer ? 0 : unit_field_si(gravity);
    if (job->file.has_nonlinear) {
        return refuse_nonlinear(job);
    }
    if ((takes & EXPORT_GYRO) && !job->file.has_gyro) {
        return message_usage(syntax.command, "--format %s is for a gyroscope, and %s contains none",
                             job->format, job->source);
    }
    if ((takes & EXPORT_GRAVITY) && !(gravity > 0)) {
        message("%s: \"gravity\", the length of the field, is missing or not above 0, and "
                "--format %s needs it",
                job->source, job->format);
        return EXIT_FILE;
    }
    if ((takes & EXPORT_ACCELERATION) && !(job->si > 0)) {
        return message_usage(syntax.command,
                             "--format %s is for accelerometers, but in %s the field is %.6g: not "
                             "gravity in m/s^2, g or mg",
                             job->format, job->source, gravity);
    }
    if (takes & EXPORT_DRIVER) {
        failure =
            export_driver(job, r->value[ZERO] ? r->zero : NULL, r->value[LSB] ? r->lsb : NULL);
    }
    if (!failure && r->format->check) {
        failure = r->format->check(job);
    }
    if (!failure) {
        warn(job);
    }
    return failure;
}

static int deliver(const request *r, const export_job *job)
{
    output out;

    if (!r->value[OUT]) {
        r->format->write(stdout, job);
        return output_flush();
    }
    int failure = output_begin(&out, r->value[OUT]);
    if (!failure) {
        r->format->write(out.file, job);
        failure = output_finish(&out);
    }
    return output_end(&out, 1, failure);
}

static int run(int argc, char **argv)
{
    request r = {.path = NULL};
    export_job job = {.device_id = NUMBER_UNKNOWN};
    int failure = read_request(argc, argv, &r, &job);

    failure = failure ? failure : calibration_file_read_all(r.path, &job.file);
    failure = failure ? failure : check_job(&r, &job);
    if (!failure && job.file.has_thermal) {
        message("warning: %s: its temperature terms are not exported; the result holds at %.6g °C",
                job.source, job.file.thermal.reference);
    }
    return failure ? failure : deliver(&r, &job);
}

static const char *const help[] = {
    "usage: invcal export CAL.json --format NAME [options]\n"
    "\n"
    "Writes a calibration in the format of another system. CAL.json is the output of invcal\n"
    "calibrate --out; - reads the standard input.\n"
    "\n"
    "  --format c          C header, a constant for invcal_apply of this library\n"
    "  --format c-arrays   C, two plain arrays of float, for code without the library\n"
    "  --format fusion     C, matrix, sensitivity and offset for x-io Fusion, result in g; of\n"
    "                      a magnetometer, its soft-iron matrix and hard-iron offset\n"
    "  --format imu_tk     the file that imu_tk saves and loads; result in m/s^2\n"
    "  --format imu_tk-gyro\n"
    "                      the same for the gyroscope; result in rad/s\n"
    "  --format ros        YAML for apply_calib of the ROS package imu_calib\n"
    "  --format px4        CAL_ACC parameters, a file for QGroundControl\n"
    "  --format ardupilot  INS_ACC parameters, a .param file\n"
    "\n"
    "A calibration made with --quadratic or --cubic is refused: no format removes such\n"
    "errors. Of one made with --thermal, the calibration at its reference temperature is\n"
    "exported, with a warning.\n"
    "\n"
    "The length of the field implies the unit: 9.7 to 9.9 is gravity in m/s^2, 0.99 to 1.01\n"
    "in g, 990 to 1010 in mg. Any other is that of a magnetometer, for which only the three C\n"
    "formats exist.\n"
    "\n"
    "A gyroscope in CAL.json is included in c, c-arrays (NAME_gyro in rad/s) and fusion\n"
    "(degrees/s). px4 and ardupilot take its bias, if its columns have a unit (else a warning\n"
    "says so), and measure it again at each start unless configured otherwise. ros has no\n"
    "file for it.\n"
    "\n"
    "c, c-arrays, fusion and imu_tk correct readings in input units, those of the log. ros,\n"
    "px4 and ardupilot correct what their driver delivers in m/s^2, so its scale must be\n"
    "known: the log was in m/s^2, g or mg, or invcal calibrate was given --zero and --lsb, or\n"
    "they are stated here. px4 and ardupilot have no cross terms: they get the best fit of\n"
    "three scales and three offsets, and the remaining error over all directions is printed,\n"
    "rms and maximum, in mg (thousandths of the field). Their log must be uncorrected: PX4's\n"
    "sensor_accel is; ArduPilot's logs are corrected unless recorded with offsets 0 and\n"
    "scales 1.\n"
    "\n"
    "Kalibr has no file of such a calibration: it expects readings that invcal apply has\n"
    "corrected, and noise densities, which are N of invcal allan. invcal calibrate reads the\n"
    "table of kalibr_bagextractor.\n"
    "\n"
    "  --name WORD         c, c-arrays, fusion: prefix of the names in the C source\n"
    "  --zero X,Y,Z        px4, ardupilot, ros: reading that the driver turns into 0, input\n"
    "                      units\n"
    "  --lsb S | SX,SY,SZ  scale of the driver, m/s^2 per input unit\n"
    "  --instance N        px4, ardupilot: number of the sensor; default 0, the first\n"
    "  --device-id N       px4, ardupilot: write CAL_ACCn_ID or INS_ACCn_ID as well\n"
    "  --out FILE          write to a file instead of the standard output\n"
    "\n"
    "exit codes: 0 good; 1 the calibration is out of the range of the system; 2 usage, or the\n"
    "scale is not known; 3 CAL.json unreadable or malformed, or the output not writable\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/xsens_mti_positions.csv --positions --gravity 9.81744 \\\n"
    "      --zero 32768,32768,32768 --lsb 0.0024 --out cal.json\n"
    "  invcal export cal.json --format c --name accelerometer\n"
    "  invcal export cal.json --format px4 --zero 32768,32768,32768 --lsb 0.0024\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal export CAL.json --format NAME [options]\n"
    "\n"
    "Writes a calibration, made by invcal calibrate --out, in the format of another system.\n"
    "\n"
    "  --format c          C header for this library; c-arrays: two plain arrays\n"
    "  --format fusion     C for x-io Fusion\n"
    "  --format imu_tk     the file of imu_tk\n"
    "  --format ros        YAML for the ROS package imu_calib\n"
    "  --format px4        parameters for QGroundControl\n"
    "  --format ardupilot  parameters, a .param file\n"
    "  --zero X,Y,Z        px4, ardupilot, ros: reading that the driver turns into 0, input\n"
    "                      units\n"
    "  --lsb S | SX,SY,SZ  scale of the driver, m/s^2 per input unit\n"
    "  --out FILE          write to a file instead of the standard output\n"
    "\n"
    "example:\n"
    "  invcal calibrate tests/data/mpu9150_0_positions.csv --positions --out cal.json\n"
    "  invcal export cal.json --format c --name accelerometer\n",
    NULL};

const tool_command export_command = {
    "export", "write a calibration in the format of another system", help, run, brief};
