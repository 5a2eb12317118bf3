/* SPDX-License-Identifier: MIT
 *
 * problems SEED COUNT
 * Prints random sets of position means whose conditions are spread evenly in the logarithm, one
 * problem a line, every number exactly and as a float can hold it (format: solve.c).
 */
#include <stdio.h>
#include <stdlib.h>

#include "support.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { LEAST = 9 };
static const double LOWEST = 5;     /* the condition of positions spread evenly over the sphere */
static const double HIGHEST = 1e6;  /* what the bound is stated up to, */
static const double HOPELESS = 1e9; /* and where refusals are looked for */

typedef double direction_set[MAX_POSITIONS][3];

static void set(double out[3], double x, double y, double z)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

/* Directions that leave parameters open, each kind in its own way. */
enum { PLANE, CONE, TWO_CIRCLES, FACES, EIGHT, POINT, KINDS };

static void open_direction(int kind, random_source *source, unsigned i, double angle, double out[3])
{
    const double turn = random_uniform(source, 0, 6.283185307179586);
    const int side = i % 2 ? 1 : -1;

    switch (kind) {
    case PLANE:
        set(out, cos(turn), sin(turn), 0);
        break;
    case CONE:
        set(out, cos(turn) * sin(angle), sin(turn) * sin(angle), cos(angle));
        break;
    case TWO_CIRCLES:
        set(out, cos(turn) * sin(angle), sin(turn) * sin(angle), side * cos(angle));
        break;
    case FACES:
        set(out, 0, 0, 0);
        out[i / 2 % 3] = side;
        break;
    default:
        set(out, 0, 0, 1);
    }
}

/* EIGHT: the positions cluster about eight directions drawn before. */
static void open_set(int kind, random_source *source, unsigned count, direction_set out)
{
    const double angle = random_uniform(source, 0.3, 1.2);
    double rotation[3][3];
    double turned[3];

    random_rotation(source, rotation);
    const int is_turned = random_uniform(source, 0, 1) < 0.7;
    for (unsigned i = 0; i < count; i++) {
        if (kind == EIGHT && i >= 8) {
            set(out[i], out[i % 8][0], out[i % 8][1], out[i % 8][2]);
        } else if (kind == EIGHT) {
            random_direction(source, out[i]);
        } else {
            open_direction(kind, source, i, angle, turned);
            for (int r = 0; r < 3; r++) {
                const double *row = rotation[r];
                out[i][r] = is_turned ? row[0] * turned[0] + row[1] * turned[1] + row[2] * turned[2]
                                      : turned[r];
            }
        }
    }
}

/* The same set, every direction moved by its own random vector times spread. */
static void spread_set(direction_set open, direction_set move, unsigned count, double spread,
                       direction_set out)
{
    for (unsigned i = 0; i < count; i++) {
        double v[3];
        for (int r = 0; r < 3; r++) {
            v[r] = open[i][r] + spread * move[i][r];
        }
        const double length = length3(v);
        set(out[i], v[0] / length, v[1] / length, v[2] / length);
    }
}

static double condition_of(direction_set directions, unsigned count)
{
    invcal_normal normal;
    invcal_observation row;
    invcal_real hth[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];

    invcal_normal_init(&normal);
    for (unsigned i = 0; i < count; i++) {
        if (invcal_observation_exact(directions[i], &row) == INVCAL_OK) {
            (void)invcal_normal_add(&normal, &row, 1);
        }
    }
    invcal_normal_matrix(&normal, hth);
    return invcal_condition(hth, INVCAL_PARAMETERS);
}

/* Directions whose condition is the wanted one within a third; the less the spread, the higher. */
static unsigned directions_of(random_source *source, double wanted, direction_set out)
{
    for (;;) {
        const unsigned count =
            LEAST + (unsigned)random_uniform(source, 0, MAX_POSITIONS - LEAST + 1);
        const int kind = (int)random_uniform(source, 0, KINDS);
        direction_set open;
        direction_set move;
        double low = 1e-6;
        double high = 10;

        open_set(kind, source, count, open);
        for (unsigned i = 0; i < count; i++) {
            random_direction(source, move[i]);
        }
        for (int i = 0; i < 40; i++) {
            const double spread = sqrt(low * high);
            spread_set(open, move, count, spread, out);
            const double condition = condition_of(out, count);
            if (condition < 1.33 * wanted && wanted < 1.33 * condition) {
                return count;
            }
            *(condition > wanted ? &low : &high) = spread;
        }
    }
}

/* What the sensor's data sheet may say: fields and units that occur. The matrix is scaled axes, or
 * an earlier calibration with cross terms. Everything as a float holds it. */
static invcal_settings nominal_of(random_source *source)
{
    static const double unit[][3] = {
        /* field, units of the field in one count, largest zero */
        {1, 1, 0},         {9.80665, 1, 0},      {9.81, 0.0024, 33000}, {1, 0.000061, 100},
        {48.5, 0.15, 300}, {9.8, 0.0005986, 30}, {1000, 0.061, 20},     {9.80665, 1e-7, 1e7},
    };
    const double *u = unit[(int)random_uniform(source, 0, sizeof unit / sizeof unit[0])];
    const int is_crossed = random_uniform(source, 0, 1) < 0.3;
    invcal_settings settings = {.field = (float)u[0]};

    for (int i = 0; i < 3; i++) {
        const double sign = random_uniform(source, 0, 1) < 0.2 ? -1 : 1;
        settings.nominal.offset[i] = (float)(u[2] * random_uniform(source, -1, 1));
        for (int j = 0; j < 3; j++) {
            const double cross = is_crossed ? random_uniform(source, -0.05, 0.05) : 0;
            settings.nominal.matrix[i][j] = (float)(u[1] * (i == j ? sign : cross));
        }
    }
    settings.frame =
        random_uniform(source, 0, 1) < 0.25 ? INVCAL_FRAME_TRIANGULAR : INVCAL_FRAME_SYMMETRIC;
    return settings;
}

static void print_settings(const invcal_settings *settings)
{
    printf(" %d %a %a", (int)settings->frame, settings->field, settings->noise);
    for (int i = 0; i < 3; i++) {
        printf(" %a", settings->nominal.offset[i]);
    }
    for (int i = 0; i < 9; i++) {
        printf(" %a", settings->nominal.matrix[i / 3][i % 3]);
    }
}

/* raw = zero + N^-1 field u */
static void print_raw(const invcal_settings *settings, double inverse[3][3], const double u[3])
{
    for (int i = 0; i < 3; i++) {
        const double *row = inverse[i];
        printf(" %a",
               (double)(float)(settings->nominal.offset[i] +
                               settings->field * (row[0] * u[0] + row[1] * u[1] + row[2] * u[2])));
    }
}

static void problem(random_source *source)
{
    const double top = random_uniform(source, 0, 1) < 0.1 ? HOPELESS : HIGHEST;
    const double bottom = top > HIGHEST ? HIGHEST : LOWEST;
    const double wanted = bottom * pow(top / bottom, random_uniform(source, 0, 1));
    const triad_truth truth = triad_random(source, random_uniform(source, 0, 0.2));
    /* What makes parameters worse than 0.01 is noise, not rounding. */
    const double noise = random_uniform(source, 0, 1) < 0.2
                             ? 0
                             : 0.01 * pow(10, random_uniform(source, -4, 0)) / sqrt(wanted);
    invcal_settings settings = nominal_of(source);
    direction_set directions;
    double inverse[3][3];
    double u[3];

    const unsigned count = directions_of(source, wanted, directions);
    settings.noise = random_uniform(source, 0, 1) < 0.5 ? 0 : (float)(noise * settings.field);
    (void)invcal_calibration_inverse(&settings.nominal, inverse);
    printf("%u", count);
    print_settings(&settings);
    for (unsigned i = 0; i < count; i++) {
        triad_read(&truth, directions[i], u);
        for (int r = 0; r < 3; r++) {
            u[r] += noise * random_normal(source);
        }
        print_raw(&settings, inverse, u);
    }
    putchar('\n');
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        return 2;
    }
    random_source source = random_start((uint32_t)strtoul(argv[1], NULL, 10));
    for (long left = strtol(argv[2], NULL, 10); left > 0; left--) {
        problem(&source);
    }
    return ferror(stdout) != 0;
}
