/* SPDX-License-Identifier: MIT */
#include "watch/gyro.h"

#include <math.h>
#include <string.h>

#define LEAST 5u /* rests: with fewer, neither unit nor axes can be found */
#define SURE 12u /* from this many on an error is certain */
#define SPARE 6u /* equations that confirm it */

/* More moves do not help: it is reported at once. */
static int is_mistake(const char *word)
{
    return strcmp(word, "axes") == 0 || strcmp(word, "unit") == 0 || strcmp(word, "stuck") == 0;
}

/* Half the 95 % interval of the worst of these parameters. */
static double worst(const gyro_fit *g, int is_scale)
{
    double most = 0;

    for (unsigned i = 0; i < INVCAL_GYRO_PARAMETERS; i++) {
        most = (i % 4 == 0) == is_scale ? fmax(most, g->imu.sigma[i]) : most;
    }
    return g->interval * most;
}

int watch_gyro(const turns *t, const gyro_wish *wish, unsigned rate, const double *clip,
               const positions *p, const invcal_calibration *start, char text[WATCH_GYRO_MAX])
{
    static gyro_fit g; /* large */
    const rejection none = {0};

    text[0] = '\0';
    if (t->readings == 0 || p->count < LEAST ||
        gyro_make(&g, t, wish, rate, clip, p, &none, start) || !g.is_there) {
        return 0;
    }
    if (g.word && p->count < SURE && !is_mistake(g.word)) {
        snprintf(text, WATCH_GYRO_MAX,
                 "gyroscope: too few moves so far; turn about all three axes");
        return 0;
    }
    if (g.word) {
        snprintf(text, WATCH_GYRO_MAX, "gyroscope: %.*s", WATCH_GYRO_MAX - 20, g.reason);
        return 0;
    }
    snprintf(text, WATCH_GYRO_MAX, "gyroscope: %u moves; scale ± %.2g %%, cross ± %.2g degrees%s",
             g.imu.moves, 100 * worst(&g, 1), worst(&g, 0) / UNIT_DEGREE,
             g.imu.open ? "; turn about other axes, too" : "");
    return g.imu.verdict == INVCAL_GOOD && g.imu.dof >= SPARE;
}
