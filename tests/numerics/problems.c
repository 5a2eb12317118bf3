/* SPDX-License-Identifier: MIT
 *
 * problems SEED COUNT
 * Prints random sets of position means whose conditions are spread evenly in the logarithm, one
 * problem a line, every number exactly and as a float can hold it (format: solve.c).
 */
#include <stdio.h>
#include <stdlib.h>

#include "support.h"
#include "core/system.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

enum { LEAST = 9 };
static const double LOWEST = 150;   /* evenly spread positions have 130 */
static const double HIGHEST = 1e6;  /* the bound is stated up to here, */
static const double HOPELESS = 1e9; /* and refusals are expected up to here */

typedef double direction_set[MAX_POSITIONS][3];

static void set(double out[3], double x, double y, double z)
{
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

/* Directions that leave parameters open, each kind differently. */
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

/* EIGHT: the positions cluster about eight random directions. */
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

/* The same set, each direction moved by a random vector times spread. */
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

/* The same bound as quality.condition: tr H'H tr (H'H)^-1. */
static double condition_of(direction_set directions, unsigned count)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_sums sums;

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < count; i++) {
        (void)invcal_sums_add(&sums, &nominal, directions[i], 1);
    }
    const double trace = invcali_trace(sums.sum, INVCAL_PARAMETERS);
    if (invcali_factor(sums.sum, INVCAL_PARAMETERS, INVCAL_PARAMETERS, 1e-13) != INVCAL_OK) {
        return INFINITE;
    }
    invcali_invert(sums.sum, INVCAL_PARAMETERS);
    double of_inverse = 0;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        of_inverse += invcali_variance(sums.sum, INVCAL_PARAMETERS, r);
    }
    return trace * of_inverse;
}

/* Directions with the wanted condition, to a third; it is the higher, the smaller the spread. */
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

/* What the sensor's data sheet may say, in common fields and units. The matrix is scaled axes, or
 * an earlier calibration with cross terms. All numbers are rounded to float. */
static invcal_calibration nominal_of(random_source *source)
{
    static const double unit[][2] = {
        /* of the field in one count, largest zero */
        {1, 0},           {1 / 9.80665, 0},      {0.0024 / 9.81, 33000}, {0.000061, 100},
        {0.15 / 48, 300}, {0.0005986 / 9.8, 30}, {0.061 / 1000, 20},     {1e-7 / 9.80665, 1e7},
    };
    const double *u = unit[(int)random_uniform(source, 0, sizeof unit / sizeof unit[0])];
    const int is_crossed = random_uniform(source, 0, 1) < 0.3;
    invcal_calibration nominal;

    for (int i = 0; i < 3; i++) {
        const double sign = random_uniform(source, 0, 1) < 0.2 ? -1 : 1;
        nominal.offset[i] = (float)(u[1] * random_uniform(source, -1, 1));
        for (int j = 0; j < 3; j++) {
            const double cross = is_crossed ? random_uniform(source, -0.05, 0.05) : 0;
            nominal.matrix[i][j] = (float)(u[0] * (i == j ? sign : cross));
        }
    }
    return nominal;
}

static void print_nominal(const invcal_calibration *nominal)
{
    for (int i = 0; i < 3; i++) {
        printf(" %a", nominal->offset[i]);
    }
    for (int i = 0; i < 9; i++) {
        printf(" %a", nominal->matrix[i / 3][i % 3]);
    }
}

/* raw = zero + N^-1 u */
static void print_raw(const invcal_calibration *nominal, const double u[3])
{
    double inverse[3][3];

    inverse3((const double(*)[3])nominal->matrix, inverse);
    for (int i = 0; i < 3; i++) {
        const double *row = inverse[i];
        printf(" %a",
               (double)(float)(nominal->offset[i] + row[0] * u[0] + row[1] * u[1] + row[2] * u[2]));
    }
}

static void problem(random_source *source)
{
    const double top = random_uniform(source, 0, 1) < 0.1 ? HOPELESS : HIGHEST;
    const double bottom = top > HIGHEST ? HIGHEST : LOWEST;
    const double wanted = bottom * pow(top / bottom, random_uniform(source, 0, 1));
    const triad_truth truth = triad_random(source, random_uniform(source, 0, 0.2));
    /* Errors of parameters above 0.01 come from noise, not from rounding. */
    const double noise = random_uniform(source, 0, 1) < 0.2
                             ? 0
                             : 0.01 * pow(10, random_uniform(source, -4, 0)) / sqrt(wanted);
    const invcal_calibration nominal = nominal_of(source);
    const int is_triangular = random_uniform(source, 0, 1) < 0.25;
    const int is_stated = random_uniform(source, 0, 1) < 0.5;
    direction_set directions;
    double u[3];

    const unsigned count = directions_of(source, wanted, directions);
    printf("%u %d %a", count, is_triangular, (double)(is_stated ? (float)noise : 0));
    print_nominal(&nominal);
    for (unsigned i = 0; i < count; i++) {
        triad_read(&truth, directions[i], u);
        for (int r = 0; r < 3; r++) {
            u[r] += noise * random_normal(source);
        }
        print_raw(&nominal, u);
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
