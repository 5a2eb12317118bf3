/* SPDX-License-Identifier: MIT
 *
 * Prints tests/unit/gyro_logs.h: what the library keeps of real logs, which are not carried with the project.
 *
 *     gcc -DINVCAL_DOUBLE=1 -Iinclude tests/reference/gyro_logs.c src/?*.c -lm -o gyro_logs
 *     ./gyro_logs xsens_mti_acc.txt xsens_mti_gyro.txt mpu9150_0.txt > tests/unit/gyro_logs.h
 *
 * Xsens MTi: imu_tk, bin/test_data (BSD), until the table of segments is full; MPU-9150: mikoff/imu-calib,
 * data/imu0.log (MIT).
 */
#include <math.h>
#include <stdio.h>

#include "invcal/gyro.h"

#define RAD (3.14159265358979324 / 180)

static invcal_moves moves;
static invcal_session session;

static void feed(const double x[6])
{
    int32_t a[3], g[3];

    for (int i = 0; i < 3; i++) {
        a[i] = (int32_t)lround(x[i]);
        g[i] = (int32_t)lround(x[3 + i]);
    }
    invcal_moves_feed(&moves, g);
    invcal_moves_follow(&moves, &session.rests, invcal_session_feed(&session, a));
}

static void begin(double zero, double acceleration, double rate)
{
    invcal_calibration c = {{0}, {{0}}};

    for (int i = 0; i < 3; i++) {
        c.offset[i] = (invcal_real)zero;
        c.matrix[i][i] = (invcal_real)acceleration;
    }
    (void)invcal_session_begin(&session, &c, 100);
    for (int i = 0; i < 3; i++) {
        c.matrix[i][i] = (invcal_real)rate;
    }
    (void)invcal_moves_init(&moves, &c, 100);
}

static void print(const char *name)
{
    const unsigned skip = session.count < moves.count ? moves.count - session.count : 0;

    printf("static const double %s_mean[][3] = {\n", name);
    for (unsigned i = 0; i < session.count; i++) {
        printf("    {%.3f, %.3f, %.3f},\n", (double)session.mean[i][0], (double)session.mean[i][1],
               (double)session.mean[i][2]);
    }
    printf("};\nstatic const invcal_still %s_rest[] = {\n", name);
    for (unsigned i = skip; i < moves.count; i++) {
        const invcal_still *r = &moves.rest[i];
        printf("    {{%d, %d, %d}, %u, %d},\n", r->bias[0], r->bias[1], r->bias[2], r->when, r->move);
    }
    printf("};\nstatic const invcal_segment %s_segment[] = {\n", name);
    for (unsigned i = 0; i < moves.first; i++) {
        const invcal_segment *s = &moves.segment[i];
        printf("    {{%d, %d, %d}, {%d, %d, %d}, %u},\n", s->v[0], s->v[1], s->v[2], s->kappa[0],
               s->kappa[1], s->kappa[2], s->time);
    }
    printf("};\n");
}

int main(int count, char **names)
{
    FILE *a = count == 4 ? fopen(names[1], "r") : NULL;
    FILE *g = a ? fopen(names[2], "r") : NULL;
    FILE *m = g ? fopen(names[3], "r") : NULL;
    double x[6], time;

    if (!m) {
        return 3;
    }
    printf("/* SPDX-License-Identifier: MIT\n *\n"
           " * Made by tests/reference/gyro_logs.c, which names the logs. */\n/* clang-format off */\n");
    begin(32768, 1 / (414.4 * 9.81744), 1 / 4772.0);
    while (moves.count < 16 && fscanf(a, "%lf %lf %lf %lf", &time, x, x + 1, x + 2) == 4 &&
           fscanf(g, "%lf %lf %lf %lf", &time, x + 3, x + 4, x + 5) == 4) {
        feed(x);
    }
    print("xsens");
    begin(0, 1 / 16384.0, RAD / 131);
    while (fscanf(m, "%lf %lf %lf %lf %lf %lf", x, x + 1, x + 2, x + 3, x + 4, x + 5) == 6) {
        for (int i = 0; i < 3; i++) {
            x[i] *= 16384 / 9.81;
            x[3 + i] *= 131 / RAD;
        }
        feed(x);
    }
    print("mpu");
    printf("/* clang-format on */\n");
    return 0;
}
