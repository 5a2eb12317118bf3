/* SPDX-License-Identifier: MIT
 *
 * A board for the program of README.md: a sensor of 16384 counts per g and 100 Hz with errors of some
 * percent, a memory that is the file named by BOARD_MEMORY, and a hand that does what it is told in
 * words and nothing else. Prints what is shown; ends after a second of calibrated samples, with 0 if
 * their length is that of the field, or with 2 where the hand has lost patience.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "board.h"

enum { RATE = 100, MOVE = RATE / 2, HELD = 3 * RATE, PATIENCE = 600 * RATE };
static const double COUNTS = 16384;
static const double PI = 3.14159265358979323846;

/* ---- the sensor, and the hand that turns it ----------------------------------------------------- */

static double from[3] = {0, 0, 1};
static double up[3] = {0.05, -0.04, 1};
static unsigned time_there; /* samples since the hand set out */
static uint32_t random_state = 1;

/* Nearly normal: the sum of four uniform numbers. */
static double noise(void)
{
    double sum = 0;

    for (int i = 0; i < 4; i++) {
        random_state = random_state * UINT32_C(1664525) + UINT32_C(1013904223);
        sum += (double)(random_state >> 8) / (1 << 24) - 0.5;
    }
    return sum * sqrt(3);
}

static void read_sensor(const double eta[3], int32_t raw[3])
{
    static const double S[3][3] = {
        {1.02, 0.004, -0.006}, {0.004, 0.985, 0.01}, {-0.006, 0.01, 1.01}};
    static const double offset[3] = {0.03, -0.05, 0.02};

    for (int i = 0; i < 3; i++) {
        const double g = S[i][0] * eta[0] + S[i][1] * eta[1] + S[i][2] * eta[2] + offset[i];
        raw[i] = (int32_t)lround(COUNTS * (g + 0.0005 * noise()));
    }
}

/* Half a second from one direction to the next, and then at rest. */
const int32_t *board_sample(void)
{
    static int32_t raw[3];
    static unsigned samples;
    double eta[3];
    double square = 0;

    if (++samples > PATIENCE) {
        exit(2);
    }
    const double way = ++time_there < MOVE ? (1 - cos(PI * time_there / MOVE)) / 2 : 1;
    const double swing = time_there < MOVE ? 0.3 * sin(PI * time_there / MOVE) : 0;
    for (int i = 0; i < 3; i++) {
        eta[i] = from[i] + way * (up[i] - from[i]) + swing * (0.3 + 0.4 * i);
        square += eta[i] * eta[i];
    }
    for (int i = 0; i < 3; i++) {
        eta[i] /= sqrt(square);
    }
    read_sensor(eta, raw);
    return raw;
}

/* A direction, if these are words for one: of all that a cube has the one with the same words. */
static int is_direction(const char *text, double direction[3])
{
    char words[INVCAL_WORDS];

    for (int n = 0; n < 27; n++) {
        const int sign[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        const double length = sqrt(sign[0] * sign[0] + sign[1] * sign[1] + sign[2] * sign[2]);
        if (length > 0) {
            invcal_real v[3];
            for (int i = 0; i < 3; i++) {
                direction[i] = sign[i] / length;
                v[i] = (invcal_real)direction[i];
            }
            if (strcmp(invcal_words(v, words), text) == 0) {
                return 1;
            }
        }
    }
    return 0;
}

/* It holds on for a moment, and places the device only roughly. */
void board_show(const char *text)
{
    double direction[3];

    puts(text);
    if (is_direction(text, direction)) {
        memcpy(from, up, sizeof from);
        for (int i = 0; i < 3; i++) {
            up[i] = direction[i] + 0.1 * noise();
        }
        time_there = 0;
    }
}

/* Where the device is, and then along each axis. */
void board_use(const invcal_real g[3])
{
    static unsigned samples;
    static double worst;
    const double error = sqrt((double)g[0] * g[0] + (double)g[1] * g[1] + (double)g[2] * g[2]) - 1;

    if (time_there >= MOVE) {
        worst = fabs(error) > worst ? fabs(error) : worst;
    }
    if (++samples % RATE != 0) {
        return;
    }
    if (samples == 4 * RATE) {
        printf("calibrated: at rest |a| is 1 g within %s\n",
               worst < 0.003 ? "3 mg" : "more than 3 mg");
        exit(worst < 0.003 ? 0 : 1);
    }
    for (unsigned i = 0; i < 3; i++) {
        from[i] = up[i];
        up[i] = i == samples / RATE - 1;
    }
    time_there = 0;
}

/* ---- the memory: four slots in a file ------------------------------------------------------------ */

enum { SLOT = 1024 };
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
