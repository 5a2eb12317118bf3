/* SPDX-License-Identifier: MIT
 *
 * Prints tests/unit/gyro_logs.h: what the library keeps of real logs, which are not carried with the project.
 *
 *     gcc -DINVCAL_DOUBLE=1 -Iinclude -Isrc tests/reference/gyro_logs.c $(find src -name '*.c') -lm -o gyro_logs
 *     ./gyro_logs xsens_mti_acc.txt xsens_mti_gyro.txt mpu9150_0.txt mpu9150_1.txt > tests/unit/gyro_logs.h
 *
 * Xsens MTi: imu_tk, bin/test_data (BSD), until the table of segments is full; MPU-9150: mikoff/imu-calib,
 * data/imu0.log and imu1.log (MIT), of the first with the rests that its authors' own method takes
 * (code/utilities.py): 0.13 rad/s are not exceeded 0.6 s before and after.
 */
#include <math.h>
#include <stdio.h>

#include "imu/imu.h"

#define RAD (3.14159265358979324 / 180)

static invcal_imu both;
static invcal_session *const session = &both.session;

static void feed(const double x[6])
{
    int32_t a[3], g[3];

    for (int i = 0; i < 3; i++) {
        a[i] = (int32_t)lround(x[i]);
        g[i] = (int32_t)lround(x[3 + i]);
    }
    invcal_imu_feed_gyro(&both, g[0], g[1], g[2]);
    (void)invcal_imu_feed(&both, a[0], a[1], a[2]);
}

static void begin(double zero, double acceleration, double rate)
{
    invcal_calibration c = {{0}, {{0}}};

    for (int i = 0; i < 3; i++) {
        c.offset[i] = (invcal_real)zero;
        c.matrix[i][i] = (invcal_real)acceleration;
    }
    if (invcal_session_init_nominal(session, sizeof *session, &c, 100) != INVCAL_OK) {
        fputs("a scale is wrong\n", stderr);
    }
    for (int i = 0; i < 3; i++) {
        c.matrix[i][i] = (invcal_real)rate;
    }
    if (invcal_imu_init_nominal(&both, sizeof both, &c, 100) != INVCAL_OK) {
        fputs("a scale is wrong\n", stderr);
    }
}

/* ---- with stated rests -------------------------------------------------------------------------- */

enum { ROWS = 20000, BLOCK = 4, LEAST = 8, QUIET = 60 };

static double row[ROWS][6];
static char rests[ROWS];

static int read_rows(FILE *file)
{
    double x[6];
    int rows = 0;

    while (rows < ROWS &&
           fscanf(file, "%lf %lf %lf %lf %lf %lf", x, x + 1, x + 2, x + 3, x + 4, x + 5) == 6) {
        for (int i = 0; i < 3; i++) {
            row[rows][i] = x[i] * 16384 / 9.81;
            row[rows][3 + i] = x[3 + i] * 131 / RAD;
        }
        rows++;
    }
    return rows;
}

static void find_rests(int rows)
{
    int since = QUIET;

    for (int n = 0; n < rows; n++) {
        const double *x = row[n] + 3;
        since = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) * RAD / 131 < 0.13 ? since + 1 : 0;
        rests[n] = since > QUIET;
        for (int k = since == 0 && n > QUIET ? n - QUIET : n; k < n; k++) {
            rests[k] = 0;
        }
    }
}

/* Its mean to the session, which is no more than a table here. */
static void take(const double sum[3], int samples)
{
    for (int i = 0; i < 3; i++) {
        session->mean[session->count].v[i] = (invcal_real)(sum[i] / samples);
    }
    session->count++;
}

static void feed_stated(int rows)
{
    invcal_private_rests *r = &session->rests;
    double sum[3] = {0, 0, 0};
    int blocks = 0, since = 0;

    session->count = 0;
    *r = (invcal_private_rests){0};
    r->bits = 2;
    for (int n = 0; n < rows; n++) {
        int32_t g[3];
        int is_quiet = 1;
        invcal_event event = INVCAL_MOVING;
        for (int i = 0; i < 3; i++) {
            g[i] = (int32_t)lround(row[n][3 + i]);
        }
        invcal_imu_feed_gyro(&both, g[0], g[1], g[2]);
        if (n % BLOCK != BLOCK - 1) {
            continue;
        }
        for (int k = n - BLOCK + 1; k <= n; k++) {
            is_quiet &= rests[k];
        }
        r->begin = r->pended > 0 ? r->begin : r->time;
        r->time += BLOCK;
        if (is_quiet) {
            r->pended = 2;
            r->end = r->time;
            blocks++;
            event = blocks == LEAST ? INVCAL_READY : INVCAL_SETTLING;
            for (int i = 0; i < 3 * BLOCK; i++) {
                sum[i % 3] += row[n - i / 3][i % 3];
            }
        } else if (blocks > 0) {
            since++;
            event = since < 3 ? INVCAL_MOVING : blocks < LEAST ? INVCAL_REFUSED : INVCAL_TAKEN;
        }
        invcali_imu_follow(&both, event);
        if (event == INVCAL_TAKEN) {
            take(sum, BLOCK * blocks);
        }
        if (since == 3) {
            r->pended = 0;
            blocks = since = 0;
            sum[0] = sum[1] = sum[2] = 0;
        }
    }
}

/* ---- what is printed ---------------------------------------------------------------------------- */

/* The number of segments, or why there are none, by its name. */
static void print_move(int move)
{
    if (move == -INVCAL_REST_DRIFT) {
        printf("-INVCAL_REST_DRIFT},\n");
    } else if (move == -INVCAL_TOO_FEW) {
        printf("-INVCAL_TOO_FEW},\n");
    } else {
        printf("%d},\n", move);
    }
}

static void print(const char *name)
{
    const unsigned skip = session->count < both.rests ? both.rests - session->count : 0;

    printf("static const double %s_mean[][3] = {\n", name);
    for (unsigned i = 0; i < session->count; i++) {
        printf("    {%.3f, %.3f, %.3f},\n", (double)session->mean[i].v[0],
               (double)session->mean[i].v[1], (double)session->mean[i].v[2]);
    }
    printf("};\nstatic const invcal_private_still %s_rest[] = {\n", name);
    for (unsigned i = skip; i < both.rests; i++) {
        const invcal_private_still *r = &both.own.rest[i];
        printf("    {{%d, %d, %d}, %u, ", r->bias[0], r->bias[1], r->bias[2], r->when);
        print_move(r->move);
    }
    printf("};\nstatic const invcal_private_segment %s_segment[] = {\n", name);
    for (unsigned i = 0; i < both.own.first; i++) {
        const invcal_private_segment *s = &both.own.segment[i];
        printf("    {{%d, %d, %d}, {%d, %d, %d}, %u},\n", s->v[0], s->v[1], s->v[2], s->kappa[0],
               s->kappa[1], s->kappa[2], s->time);
    }
    printf("};\n");
}

int main(int count, char **names)
{
    FILE *a = count == 5 ? fopen(names[1], "r") : NULL;
    FILE *g = a ? fopen(names[2], "r") : NULL;
    FILE *m = g ? fopen(names[3], "r") : NULL;
    FILE *m1 = m ? fopen(names[4], "r") : NULL;
    double x[6], time;

    if (!m1) {
        fputs("usage: gyro_logs XSENS_ACC XSENS_GYRO MPU_0 MPU_1, as the head of this source says; "
              "each must be "
              "readable\n",
              stderr);
        return 3;
    }
    printf("/* SPDX-License-Identifier: MIT\n *\n"
           " * Made by tests/reference/gyro_logs.c, which names the logs. */\n/* clang-format off "
           "*/\n");
    begin(32768, 1 / (414.4 * 9.81744), 1 / 4772.0);
    while (both.rests < 16 && fscanf(a, "%lf %lf %lf %lf", &time, x, x + 1, x + 2) == 4 &&
           fscanf(g, "%lf %lf %lf %lf", &time, x + 3, x + 4, x + 5) == 4) {
        feed(x);
    }
    print("xsens");
    begin(0, 1 / 16384.0, RAD / 131);
    int rows = read_rows(m);
    find_rests(rows);
    feed_stated(rows);
    print("mpu0");
    begin(0, 1 / 16384.0, RAD / 131);
    rows = read_rows(m1);
    for (int n = 0; n < rows; n++) {
        feed(row[n]);
    }
    print("mpu1");
    printf("/* clang-format on */\n");
    return 0;
}
