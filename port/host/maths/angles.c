/* SPDX-License-Identifier: MIT */
#include "maths/angles.h"

#include <math.h>
#include <stdio.h>

#define DEGREES 57.295779513082321
#define POLE_SINE 1e-12 /* sin alpha up to which beta is undetermined */

/* Reduced to a quarter turn, so that multiples of 90 degrees are exact. */
static void cos_sin(double degrees, double *cosine, double *sine)
{
    int quarters = 0;
    const double rest = remquo(degrees, 90, &quarters) / DEGREES;
    const double c = cos(rest);
    const double s = sin(rest);
    const double turned[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};

    *cosine = turned[quarters & 3][0] + 0.0;
    *sine = turned[quarters & 3][1] + 0.0;
}

void angles_direction(double alpha, double beta, double up[3])
{
    double cosine[2];
    double sine[2];

    cos_sin(alpha, &cosine[0], &sine[0]);
    cos_sin(beta, &cosine[1], &sine[1]);
    up[0] = sine[0] * sine[1] + 0.0;
    up[1] = cosine[0];
    up[2] = sine[0] * cosine[1] + 0.0;
}

void angles_vector(double alpha, double beta, const double v[3], double out[3])
{
    double cosine[2];
    double sine[2];

    cos_sin(alpha, &cosine[0], &sine[0]);
    cos_sin(beta, &cosine[1], &sine[1]);
    const double x = cosine[1] * v[0] - sine[1] * v[2];
    const double y = v[1];
    const double z = sine[1] * v[0] + cosine[1] * v[2];
    out[0] = x;
    out[1] = cosine[0] * y + sine[0] * z;
    out[2] = cosine[0] * z - sine[0] * y;
}

static int is_beta_free(const double up[3])
{
    return !(hypot(up[0], up[2]) > POLE_SINE);
}

stand_angles angles_of(const double up[3])
{
    const double alpha = DEGREES * atan2(hypot(up[0], up[2]), up[1]);

    return (stand_angles){alpha, is_beta_free(up) ? 0 : DEGREES * atan2(up[0], up[2])};
}

static double travel(stand_angles from, stand_angles to)
{
    return fabs(angles_turn(from.alpha, to.alpha)) + fabs(angles_turn(from.beta, to.beta));
}

stand_angles angles_near(const double up[3], stand_angles near)
{
    stand_angles one = angles_of(up);
    stand_angles other = {-one.alpha, angles_turn(0, one.beta + 180)};

    if (is_beta_free(up)) {
        one.beta = other.beta = near.beta;
    }
    return travel(near, other) < travel(near, one) ? other : one;
}

double angles_turn(double from, double to)
{
    const double change = fmod(to - from, 360) + 0.0; /* never -0 */

    return change > 180 ? change - 360 : change <= -180 ? change + 360 : change;
}

/* To 0.01 degrees, and never -0. */
static double rounded(double degrees)
{
    return nearbyint(100 * degrees) / 100 + 0.0;
}

const char *angles_text(stand_angles a, char text[ANGLES_TEXT_MAX])
{
    snprintf(text, ANGLES_TEXT_MAX, "alpha %.6g, beta %.6g°", rounded(a.alpha), rounded(a.beta));
    return text;
}

const char *angles_turn_text(stand_angles from, stand_angles to, char text[ANGLES_TEXT_MAX])
{
    const double alpha = rounded(angles_turn(from.alpha, to.alpha));
    const double beta = rounded(angles_turn(from.beta, to.beta));
    const int turns_alpha = fabs(alpha) > 0;
    const int turns_beta = fabs(beta) > 0;

    text[0] = '\0';
    if (turns_alpha && turns_beta) {
        snprintf(text, ANGLES_TEXT_MAX, "turn alpha %+.6g, beta %+.6g°", alpha, beta);
    } else if (turns_alpha || turns_beta) {
        snprintf(text, ANGLES_TEXT_MAX, "turn %s %+.6g°", turns_alpha ? "alpha" : "beta",
                 turns_alpha ? alpha : beta);
    }
    return text;
}
