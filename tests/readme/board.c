/* SPDX-License-Identifier: MIT
 *
 * A board for the programs of README.md and of the manual: sensors with errors of some percent, 16384 counts per g
 * and 65.5 per degree/s, a memory in the file BOARD_MEMORY, and a hand that follows the words that are shown, and
 * nothing else. Prints what is shown. BOARD_RESET=N: exits with 3 in the middle of move N. Otherwise it exits after
 * some seconds of calibrated samples, with 0 if they are right, or with 2 when the hand loses patience.
 */
#include "board.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hand.h"

enum { PATIENCE = 600 * HAND_RATE };
#define COUNTS 16384.0                                    /* for 1 g */
#define RATE_COUNTS (65.5 * 180 / 3.14159265358979323846) /* for 1 rad/s */

/* ---- the sensors, and the hand that turns them --------------------------------------------------- */

enum { ACCELEROMETER = 1, GYRO = 2 };
static double rate[3], force[3]; /* of this step */
static int is_read = ACCELEROMETER | GYRO;
static unsigned moving; /* steps of the present move; 0: at rest */
enum { COLD = 5, USUAL = 25, WARM = 45 };
static double temperature = USUAL;
static int has_thermometer; /* which the program reads */

static void step(void)
{
    static unsigned steps, moves;
    const char *reset = getenv("BOARD_RESET");

    if (++steps > PATIENCE) {
        exit(2);
    }
    moving = hand_moves(rate, force) ? moving + 1 : 0;
    moves += moving == 1;
    if (reset && moves == strtoul(reset, NULL, 10) && moving == HAND_TURN / 2) {
        exit(3);
    }
}

/* Both have the same rate. A new step begins when one of them is read again. */
static void read_sensor(int which, const double v[3], const double gain[3][3],
                        const double offset[3], double noise, int16_t raw[3])
{
    if (is_read & which) {
        is_read = 0;
        step();
    }
    is_read |= which;
    for (int i = 0; i < 3; i++) {
        const double x = gain[i][0] * v[0] + gain[i][1] * v[1] + gain[i][2] * v[2];
        raw[i] = (int16_t)lround(x + offset[i] + noise * hand_noise());
    }
}

/* Offsets, and the scale of x, follow the temperature: 1 mg/K and 2e-4/K. */
void board_read(int16_t v[3])
{
    const double t = temperature - USUAL;
    const double gain[3][3] = {{(1.02 + 2e-4 * t) * COUNTS, 0.004 * COUNTS, -0.006 * COUNTS},
                               {0.004 * COUNTS, 0.985 * COUNTS, 0.01 * COUNTS},
                               {-0.006 * COUNTS, 0.01 * COUNTS, 1.01 * COUNTS}};
    const double offset[3] = {490 + 16.4 * t, -820 - 8.2 * t, 330};

    read_sensor(ACCELEROMETER, force, gain, offset, 8, v);
}

/* To the nearest 1/16 K. */
invcal_real board_temperature(void)
{
    has_thermometer = 1;
    return (invcal_real)(floor(16 * temperature + 0.5) / 16);
}

void board_await(const char *climate)
{
    puts(climate);
    temperature = strcmp(climate, "cold") == 0 ? COLD : WARM;
}

void board_read_gyro(int16_t v[3])
{
    static const double gain[3][3] = {
        {0.975 * RATE_COUNTS, 0.012 * RATE_COUNTS, -0.004 * RATE_COUNTS},
        {-0.015 * RATE_COUNTS, 1.018 * RATE_COUNTS, 0.007 * RATE_COUNTS},
        {0.003 * RATE_COUNTS, -0.009 * RATE_COUNTS, 1.009 * RATE_COUNTS}};
    static const double offset[3] = {85, -131, 24.5};

    read_sensor(GYRO, rate, gain, offset, 3.3, v);
}

void board_show(const char *text)
{
    puts(text);
    fflush(stdout); /* a mistaken program does not end */
    (void)hand_reads(text, HAND_TURN);
}

/* ---- what the device is for: it checks itself ----------------------------------------------------- */

/* At rest the length must be 1. A NaN is worse than any number, and stays. */
static void note_length(const invcal_real g[3], double *worst)
{
    const double error =
        fabs(sqrt((double)g[0] * g[0] + (double)g[1] * g[1] + (double)g[2] * g[2]) - 1);

    if (moving == 0 && !(error <= *worst) && !isnan(*worst)) {
        *worst = error;
    }
}

/* Where the device is, and then along each axis; and, if it has a thermometer, at another temperature. */
void board_use(const invcal_real g[3])
{
    static const char *const axes[] = {"+x up", "+y up", "+z up", NULL};
    static unsigned steps, axis;
    static double worst;

    note_length(g, &worst);
    if (++steps % (3 * HAND_RATE) != 0) {
        return;
    }
    if (!axes[axis]) {
        printf("calibrated: at rest |a| is 1 g within %s\n",
               worst < 0.003 ? "3 mg" : "more than 3 mg");
        exit(worst < 0.003 ? 0 : 1);
    }
    (void)hand_reads(axes[axis++], HAND_TURN);
    if (has_thermometer) {
        temperature = COLD + 10.0 * axis;
    }
}

/* The gyroscope alone turns the up direction from before a turn; after it, the accelerometer must agree. */
void board_use_both(const invcal_real g[3], const invcal_real w[3])
{
    static double up[3];
    static unsigned still;

    for (int n = 0; n < 200; n++) { /* parts of a step */
        const double was[3] = {up[0], up[1], up[2]};
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            up[i] += (was[j] * (double)w[k] - was[k] * (double)w[j]) / (200 * HAND_RATE);
        }
    }
    still = moving == 0 ? still + 1 : 0;
    for (int i = 0; i < 3 && still == 1; i++) {
        if (!(fabs(up[i] - (double)g[i]) <= 0.005) && (up[0] != 0 || up[1] != 0 || up[2] != 0)) {
            printf("axis %d: %.4f by the gyroscope, %.4f by the accelerometer\n", i, up[i],
                   (double)g[i]);
            exit(1);
        }
    }
    for (int i = 0; i < 3 && moving == 0; i++) {
        up[i] = (double)g[i];
    }
    board_use(g);
}

/* ---- a watch ------------------------------------------------------------------------------------ */

static double worst_of_day;

void board_count_steps(const invcal_real g[3])
{
    note_length(g, &worst_of_day);
}

/* A day has 20 s. Every 5 s it is put down in another orientation. */
int board_has_a_day_passed(void)
{
    static unsigned steps;
    const unsigned day = ++steps / (20 * HAND_RATE);

    if (steps % (5 * HAND_RATE) == 0) {
        double any[3] = {hand_noise(), hand_noise(), hand_noise()};
        const double length = sqrt(any[0] * any[0] + any[1] * any[1] + any[2] * any[2]);
        for (int i = 0; i < 3; i++) {
            any[i] /= length;
        }
        hand_turns(any, HAND_TURN);
    }
    if (steps % (20 * HAND_RATE) != 0) {
        return 0;
    }
    printf("day %u: |a| is 1 g within %.1f mg\n", day, 1000 * worst_of_day);
    if (day == 30) {
        exit(worst_of_day < 0.003 ? 0 : 1);
    }
    worst_of_day = 0;
    return 1;
}

/* ---- the memory: four slots in a file ------------------------------------------------------------ */

enum { SLOT = 4096 };
static unsigned first[2] = {0, 2};

static FILE *open_at(const void *context, unsigned slot, uint32_t offset)
{
    const char *name = getenv("BOARD_MEMORY");
    FILE *file = name ? fopen(name, "r+b") : NULL;

    if (file) {
        fseek(file, (long)((*(const unsigned *)context + slot) * SLOT + offset), SEEK_SET);
    }
    return file;
}

static int slot_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    FILE *file = open_at(context, slot, offset);
    const int failed = !file || fread(bytes, 1, size, file) != size;

    return (file && fclose(file)) || failed;
}

static int slot_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                        uint32_t size)
{
    FILE *file = open_at(context, slot, offset);
    const int failed = !file || fwrite(bytes, 1, size, file) != size;

    return (file && fclose(file)) || failed;
}

static int slot_erase(void *context, unsigned slot)
{
    uint8_t blank[SLOT];

    memset(blank, 0xFF, sizeof blank);
    return slot_program(context, slot, 0, blank, sizeof blank);
}

const invcal_store board_result = {slot_read, slot_erase, slot_program, &first[0], SLOT, 1};
const invcal_store board_progress = {slot_read, slot_erase, slot_program, &first[1], SLOT, 1};
