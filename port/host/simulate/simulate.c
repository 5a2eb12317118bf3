/* SPDX-License-Identifier: MIT
 *
 * invcal simulate: the log of a triad that is carried through a set of positions.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/files.h"
#include "text/json_write.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/output.h"
#include "simulate/gyro.h"
#include "simulate/scene.h"
#include "simulate/wave_write.h"
#include "text/number.h"
#include "text/unit.h"

enum {
    PLAN,
    OFFSET,
    DK,
    GAMMA,
    NOISE,
    RATE,
    DWELL,
    MOVE,
    SEED,
    ZERO,
    LSB,
    GRAVITY,
    RANGE,
    INSTABILITY,
    TREMOR,
    TEMPERATURE,
    DRIFT,
    OUTLIERS,
    OUTLIER_SIZE,
    STAND,
    GYRO,
    GYRO_SCALE,
    GYRO_CROSS,
    GYRO_BIAS,
    GYRO_G,
    GYRO_NOISE,
    GYRO_LSB,
    GYRO_RANGE,
    MAGNETOMETER,
    MAG_FIELD,
    MAG_OFFSET,
    MAG_SOFT,
    MAG_TURN,
    MAG_NOISE,
    MAGNET,
    SECONDS,
    TRUTH,
    OPTIONS
};

static const option options[OPTIONS] = {
    [PLAN] = {"--plan", 1},
    [OFFSET] = {"--offset", 1},
    [DK] = {"--dk", 1},
    [GAMMA] = {"--gamma", 1},
    [NOISE] = {"--noise", 1},
    [RATE] = {"--rate", 1},
    [DWELL] = {"--dwell", 1},
    [MOVE] = {"--move", 1},
    [SEED] = {"--seed", 1},
    [ZERO] = {"--zero", 1},
    [LSB] = {"--lsb", 1},
    [GRAVITY] = {"--gravity", 1},
    [RANGE] = {"--range", 1},
    [INSTABILITY] = {"--instability", 1},
    [TREMOR] = {"--tremor", 1},
    [TEMPERATURE] = {"--temperature", 1},
    [DRIFT] = {"--drift", 1},
    [OUTLIERS] = {"--outliers", 1},
    [OUTLIER_SIZE] = {"--outlier-size", 1},
    [STAND] = {"--stand", 0},
    [GYRO] = {"--gyro", 0},
    [GYRO_SCALE] = {"--gyro-scale", 1},
    [GYRO_CROSS] = {"--gyro-cross", 1},
    [GYRO_BIAS] = {"--gyro-bias", 1},
    [GYRO_G] = {"--gyro-g", 1},
    [GYRO_NOISE] = {"--gyro-noise", 1},
    [GYRO_LSB] = {"--gyro-lsb", 1},
    [GYRO_RANGE] = {"--gyro-range", 1},
    [MAGNETOMETER] = {"--magnetometer", 0},
    [MAG_FIELD] = {"--mag-field", 1},
    [MAG_OFFSET] = {"--mag-offset", 1},
    [MAG_SOFT] = {"--mag-soft", 1},
    [MAG_TURN] = {"--mag-turn", 1},
    [MAG_NOISE] = {"--mag-noise", 1},
    [MAGNET] = {"--magnet", 1},
    [SECONDS] = {"--seconds", 1},
    [TRUTH] = {"--truth", 1},
};
#define WAVED_TREMOR 0.02 /* over the field */
static const option_syntax syntax = {"simulate", options, OPTIONS, NULL, 0, 0};

/* An option that is one number or a list of numbers, each within bounds. */
typedef struct {
    unsigned which;
    unsigned count;
    double *out;
    double min;
    double max;
} number_option;

static int read_option(const char *const *value, const number_option *o)
{
    double read[9];
    int failure = EXIT_GOOD;

    if (!value[o->which]) {
        return EXIT_GOOD;
    }
    failure = options_numbers(&syntax, o->which, value[o->which], o->count, read, NULL);
    for (unsigned i = 0; i < o->count && !failure; i++) {
        if (!(read[i] >= o->min && read[i] <= o->max)) {
            return message_usage(syntax.command, "%s %s: must be within %.6g ... %.10g",
                                 options[o->which].name, value[o->which], o->min, o->max);
        }
        o->out[i] = read[i];
    }
    return failure;
}

static scene_model defaults(void)
{
    return (scene_model){
        .delta = {0.02, -0.015, 0.03},
        .dk = {0.01, -0.008, 0.012},
        .gamma = {0.01, -0.006, 0.008},
        .field = 9.80665,
        .range = 2,
        .noise = 1e-3,
        .temperature = {25, 25},
        .rate = 100,
        .dwell = 5,
        .move = 2,
        .outlier_size = 0.05,
    };
}

/* Number options that need another option. */
static int read_options_of(const char *const *value, unsigned with, const number_option *numbers,
                           unsigned count)
{
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < count && !failure; i++) {
        if (value[numbers[i].which] && !value[with]) {
            return message_usage(syntax.command, "%s: needs %s", options[numbers[i].which].name,
                                 options[with].name);
        }
        failure = read_option(value, &numbers[i]);
    }
    return failure;
}

static int read_gyro(const char *const *value, gyro_model *g)
{
    const number_option numbers[] = {
        {GYRO_SCALE, 3, g->scale, -0.3, 0.3}, {GYRO_CROSS, 6, g->cross, -0.3, 0.3},
        {GYRO_BIAS, 3, g->bias, -1000, 1000}, {GYRO_G, 9, g->g, -10, 10},
        {GYRO_NOISE, 1, &g->noise, 0, 100},   {GYRO_LSB, 1, &g->lsb, 1e-9, 100},
        {GYRO_RANGE, 1, &g->range, 1, 1e5},
    };

    return read_options_of(value, GYRO, numbers, sizeof numbers / sizeof numbers[0]);
}

static wave_model wave_defaults(void)
{
    return (wave_model){
        .field = {48, 60},
        .hard = {12, -30, 5},
        .soft = {0.03, -0.02, 0.015, 0.02, -0.01, 0.015},
        .turn = {2, -1, 1.5},
        .noise = 0.48,
        .seconds = 60,
        .magnet = NUMBER_UNKNOWN,
    };
}

static int read_wave(const char *const *value, wave_model *m, scene_model *accelerometer)
{
    static const unsigned at_rest[] = {PLAN,  DWELL,    MOVE,         INSTABILITY, TEMPERATURE,
                                       DRIFT, OUTLIERS, OUTLIER_SIZE, STAND,       GYRO};
    const number_option numbers[] = {
        {MAG_FIELD, 2, m->field, -90, 1e6}, {MAG_OFFSET, 3, m->hard, -1e6, 1e6},
        {MAG_SOFT, 6, m->soft, -0.3, 0.3},  {MAG_TURN, 3, m->turn, -180, 180},
        {MAG_NOISE, 1, &m->noise, 0, 1e6},  {MAGNET, 1, &m->magnet, 0, 1e5},
        {SECONDS, 1, &m->seconds, 1, 1e5},
    };
    int failure = read_options_of(value, MAGNETOMETER, numbers, sizeof numbers / sizeof numbers[0]);

    for (unsigned i = 0; i < sizeof at_rest / sizeof at_rest[0] && !failure; i++) {
        if (value[MAGNETOMETER] && value[at_rest[i]]) {
            failure = message_usage(
                syntax.command,
                "--magnetometer: cannot be combined with %s, which is for rests: leave one out",
                options[at_rest[i]].name);
        }
    }
    if (!failure && !(m->field[0] > 0 && m->field[1] <= 90)) {
        failure = message_usage(
            syntax.command,
            "--mag-field: must be a length above 0, uT, and a dip within -90 ... 90 degrees");
    }
    if (value[MAGNETOMETER] && !value[TREMOR]) {
        accelerometer->tremor = WAVED_TREMOR;
    }
    return failure;
}

/* The model of the sensor, without the set of positions. */
static int read_model(const char *const *value, scene_model *m, uint32_t *seed)
{
    double seed_number = 1;
    double outliers = 0;
    const number_option numbers[] = {
        {OFFSET, 3, m->delta, -0.5, 0.5},
        {DK, 3, m->dk, -0.5, 0.5},
        {GAMMA, 3, m->gamma, -0.5, 0.5},
        {NOISE, 1, &m->noise, 0, 1},
        {RATE, 1, &m->rate, 1, 1e5},
        {DWELL, 1, &m->dwell, 1e-3, 1e5},
        {MOVE, 1, &m->move, 1e-3, 1e5},
        {SEED, 1, &seed_number, 0, UINT32_MAX},
        {ZERO, 3, m->zero, -1e9, 1e9},
        {GRAVITY, 1, &m->field, 1e-6, 1e6},
        {RANGE, 1, &m->range, 0.1, 1000},
        {INSTABILITY, 1, &m->instability, 0, 1},
        {TREMOR, 1, &m->tremor, 0, 1},
        {TEMPERATURE, 2, m->temperature, -100, 300},
        {DRIFT, 1, &m->drift, -0.1, 0.1},
        {OUTLIERS, 1, &outliers, 0, DESIGN_MAX},
        {OUTLIER_SIZE, 1, &m->outlier_size, 1e-9, 1},
    };
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < sizeof numbers / sizeof numbers[0] && !failure; i++) {
        failure = read_option(value, &numbers[i]);
    }
    m->lsb = m->field / 16384; /* 16 bits for +-2 g */
    const number_option lsb = {LSB, 1, &m->lsb, 1e-9 * m->field, m->field};
    failure = failure ? failure : read_option(value, &lsb);
    if (!failure && (floor(seed_number) < seed_number || floor(outliers) < outliers)) {
        failure = message_usage(syntax.command, "--seed and --outliers must be whole numbers");
    }
    *seed = (uint32_t)seed_number;
    m->outliers = (unsigned)outliers;
    return failure;
}

/* The positions: when they were held, and their errors. */
static void write_truth_positions(json_writer *w, const scene *s)
{
    json_list(w, "positions");
    for (unsigned i = 0; i < s->route->count; i++) {
        uint64_t begin;
        uint64_t end;
        scene_interval(s, i, &begin, &end);
        json_object(w, NULL);
        json_number(w, "begin", (double)begin / s->model->rate);
        json_number(w, "end", (double)end / s->model->rate);
        json_vector(w, "vertical", s->route->position[i].vertical);
        json_number(w, "wrong", s->wrong[i]);
        json_object_end(w);
    }
    json_list_end(w);
}

static void write_truth_g(json_writer *w, const scene_model *m)
{
    double g[3][3];

    if (gyro_scene_g(m->gyro, g)) {
        for (unsigned i = 0; i < 9; i++) {
            g[i / 3][i % 3] /= m->field;
        }
        json_matrix(w, "g_correction", (const double(*)[3])g);
    }
}

static void write_truth(FILE *file, const scene *s)
{
    const scene_model *m = s->model;
    const invcal_calibration truth = scene_truth(m);
    json_writer w;

    json_begin(&w, file);
    json_text(&w, "invcal", INVCAL_VERSION);
    json_number(&w, "gravity", m->field);
    json_vector(&w, "offset", truth.offset);
    json_matrix(&w, "matrix", truth.matrix);
    json_vector(&w, "delta", m->delta);
    json_vector(&w, "dk", m->dk);
    json_vector(&w, "gamma", m->gamma);
    json_number(&w, "noise", m->noise);
    json_number(&w, "rate", m->rate);
    if (m->gyro) {
        const invcal_calibration gyro = gyro_scene_truth(m->gyro);
        json_object(&w, "gyroscope");
        json_vector(&w, "offset", gyro.offset);
        json_matrix(&w, "matrix", gyro.matrix);
        json_number(&w, "lsb", m->gyro->lsb * UNIT_DEGREE);
        write_truth_g(&w, m);
        json_object_end(&w);
    }
    write_truth_positions(&w, s);
    json_end(&w);
}

/* The log; columns of temperature and angles are optional. */
static int write_log(scene *s, int has_temperature, int has_angles)
{
    scene_sample sample;

    printf("t,x,y,z%s%s%s\n", s->model->gyro ? ",gx,gy,gz" : "",
           has_temperature ? ",temperature" : "", has_angles ? ",alpha,beta" : "");
    while (scene_next(s, &sample) && !ferror(stdout)) {
        printf("%.6f,%ld,%ld,%ld", sample.time, (long)sample.raw[0], (long)sample.raw[1],
               (long)sample.raw[2]);
        if (s->model->gyro) {
            printf(",%ld,%ld,%ld", (long)sample.gyro[0], (long)sample.gyro[1],
                   (long)sample.gyro[2]);
        }
        if (has_temperature) {
            printf(",%.3f", sample.temperature);
        }
        if (has_angles) {
            printf(",%.4f,%.4f", sample.alpha + 0.0, sample.beta + 0.0);
        }
        putchar('\n');
    }
    return output_flush();
}

/* The log of positions, or that of a wave if w is not null. */
static int print_log(scene *s, wave *w, const char *const *value)
{
    return w ? wave_write_log(w) : write_log(s, value[TEMPERATURE] != NULL, value[STAND] != NULL);
}

static int deliver(scene *s, wave *w, const char *const *value)
{
    output out;
    int failure = EXIT_GOOD;

    if (!value[TRUTH]) {
        return print_log(s, w, value);
    }
    failure = output_begin(&out, value[TRUTH]);
    if (!failure && w) {
        wave_write_truth(out.file, w);
    } else if (!failure) {
        write_truth(out.file, s);
    }
    failure = failure ? failure : output_finish(&out);
    failure = failure ? failure : print_log(s, w, value);
    return output_end(&out, 1, failure);
}

static int check_files(const char *const *value)
{
    const named_file input = {"--plan", design_file(value[PLAN])};
    const named_file truth = {"--truth", value[TRUTH]};

    return files_check(syntax.command, &input, 1, &truth, 1);
}

static int run(int argc, char **argv)
{
    static design route; /* both are too large for the stack */
    static scene s;
    const char *value[OPTIONS];
    scene_model model = defaults();
    gyro_model gyro = {.scale = {0.01, -0.008, 0.006},
                       .cross = {0.01, -0.006, -0.004, 0.008, 0.005, -0.01},
                       .bias = {0.5, -0.8, 0.3},
                       .noise = 0.05,
                       .lsb = 1 / 131.0,
                       .range = 250};
    wave_model waved = wave_defaults();
    uint32_t seed;
    int failure = options_parse(&syntax, argc, argv, value, NULL);

    failure = failure ? failure : read_model(value, &model, &seed);
    failure = failure ? failure : read_gyro(value, &gyro);
    model.gyro = !failure && value[GYRO] ? &gyro : NULL;
    failure = failure ? failure : read_wave(value, &waved, &model);
    failure = failure ? failure : check_files(value);
    if (failure) {
        return failure;
    }
    if (value[MAGNETOMETER]) {
        wave w;
        wave_begin(&w, &waved, &model, seed);
        return deliver(NULL, &w, value);
    }
    failure = design_make(&route, syntax.command, value[PLAN] ? value[PLAN] : "per-group:6");
    if (failure == EXIT_DATA && route.count == 0) {
        message("%s", route.refusal);
    }
    if (failure && !(failure == EXIT_DATA && route.count > 0)) { /* a poor set still makes a log */
        return failure;
    }
    scene_begin(&s, &model, &route, seed);
    return deliver(&s, NULL, value);
}

static const char *const help[] = {
    "usage: invcal simulate [options]\n"
    "\n"
    "Prints the log of a triad that is carried by hand through a set of positions and rests\n"
    "in each: CSV with the columns t x y z, in seconds and counts. Quantities over the field\n"
    "are in g.\n"
    "\n"
    "  --plan SET          set of positions; default per-group:6. One of\n",
    DESIGN_WORDS,
    "  --offset X,Y,Z      true offsets, g; default 0.02,-0.015,0.03\n"
    "  --dk X,Y,Z          true scale errors; default 0.01,-0.008,0.012\n"
    "  --gamma XY,XZ,ZY    true non-orthogonality, rad; default 0.01,-0.006,0.008\n"
    "  --noise S           standard deviation of a sample, g; default 0.001\n"
    "  --rate HZ           samples per second; default 100\n"
    "  --dwell T           seconds in each position; default 5\n"
    "  --move T            seconds from one position to the next; default 2\n"
    "  --seed N            seed of the random numbers; default 1\n"
    "  --lsb S             m/s^2 per count; default 1/16384 of gravity\n"
    "  --zero X,Y,Z        counts at zero field; default 0\n"
    "  --gravity G         length of the field, m/s^2; default 9.80665\n"
    "  --range R           clip readings at +-R g; default 2\n"
    "  --instability S     slow drift of the offsets about the true ones, standard deviation,\n"
    "                      g; correlation time 100 s\n"
    "  --tremor S          tremor of the hand, below 3 Hz, standard deviation, g\n"
    "  --temperature A,B   temperature of the first and the last sample, degrees C; adds a\n"
    "                      column\n"
    "  --drift D           drift of the offsets, g per degree from 25 degrees C\n"
    "  --outliers N        number of outliers: positions with an error along the vertical\n"
    "  --outlier-size S    size of that error, g; default 0.05\n"
    "  --stand             add columns alpha and beta: angles of a two-axis stand, degrees\n"
    "  --gyro              add a gyroscope: columns gx gy gz, counts\n"
    "  --gyro-scale X,Y,Z  its true scale errors; default 0.01,-0.008,0.006\n"
    "  --gyro-cross XY,XZ,YX,YZ,ZX,ZY\n"
    "                      its cross-axis terms: what each axis reads of turns about another,\n"
    "                      rad; default 0.01,-0.006,-0.004,0.008,0.005,-0.01\n"
    "  --gyro-bias X,Y,Z   its bias, degrees/s; default 0.5,-0.8,0.3\n"
    "  --gyro-g XX,XY,XZ,YX,..\n"
    "                      its g-sensitivity, nine numbers: what its x reads for 1 g along x,\n"
    "                      y, z, then its y and z, degrees/s; default 0\n"
    "  --gyro-noise S      standard deviation of a sample, degrees/s; default 0.05\n"
    "  --gyro-lsb S        degrees/s per count; default 1/131\n"
    "  --gyro-range R      clip at +-R degrees/s; default 250\n"
    "  --magnetometer      instead of rests: a device that a hand turns to all sides, with an\n"
    "                      accelerometer and a magnetometer: columns t ax ay az, counts, and\n"
    "                      mx my mz, uT\n"
    "  --mag-field B,DIP   field of the earth: length, uT, and degrees below the horizon;\n"
    "                      default 48,60\n"
    "  --mag-offset X,Y,Z  hard iron, uT; default 12,-30,5\n"
    "  --mag-soft X,Y,Z,XY,XZ,ZY\n"
    "                      soft iron: scale errors, and angles, rad; default\n"
    "                      0.03,-0.02,0.015,0.02,-0.01,0.015\n"
    "  --mag-turn X,Y,Z    rotation of its axes relative to the accelerometer's, as a\n"
    "                      rotation vector, degrees; default 2,-1,1.5\n"
    "  --mag-noise S       standard deviation of the noise, correlated over half a second,\n"
    "                      uT; default 0.48\n"
    "  --magnet T          a magnet passes by at T seconds\n"
    "  --seconds T         duration; default 60\n"
    "  --truth FILE        write the true parameters as JSON; invcal apply reads it\n"
    "\n"
    "exit codes: 0 good; 1 the set of positions is refused; 2 usage; 3 the output not\n"
    "writable\n"
    "\n"
    "example:\n"
    "  invcal simulate --truth truth.json > log.csv\n",
    NULL};

static const char *const brief[] = {
    "usage: invcal simulate [options]\n"
    "\n"
    "Prints the log of a triad that is carried by hand through a set of positions: CSV with\n"
    "the columns t x y z, in seconds and counts. Quantities over the field are in g.\n"
    "\n"
    "  --plan SET          set of positions: edges, faces, per-group:N, optimal:N ...\n"
    "  --offset X,Y,Z      true offsets, g\n"
    "  --dk X,Y,Z          true scale errors\n"
    "  --gamma XY,XZ,ZY    true non-orthogonality, rad\n"
    "  --noise S           standard deviation of a sample, g\n"
    "  --rate HZ           samples per second\n"
    "  --dwell T           seconds in each position\n"
    "  --outliers N        number of outliers\n"
    "  --seed N            seed of the random numbers\n"
    "  --gyro              add a gyroscope\n"
    "  --magnetometer      a waved magnetometer and accelerometer, instead of rests\n"
    "  --truth FILE        write the true parameters as JSON; invcal apply reads it\n"
    "\n"
    "example:\n"
    "  invcal simulate --plan edges --truth truth.json > log.csv\n",
    NULL};

const tool_command simulate_command = {"simulate", "print the log of a simulated sensor", help, run,
                                       brief};
