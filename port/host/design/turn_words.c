/* SPDX-License-Identifier: MIT */
#include "design/turn_words.h"
#include "text/unit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "invcal/plan.h"

#define ANGLE_MAX 24
#define AXES_MAX 16
#define NEAR 1e-3 /* of a component, or of degrees */

static int is_near(double a, double b)
{
    return fabs(a - b) < NEAR;
}

/* A face, an edge or a corner of the cube: components are 0 or of one length. */
static int is_cube_direction(const invcal_real up[3])
{
    double squares = 0;

    for (unsigned i = 0; i < 3; i++) {
        squares += !is_near(up[i], 0);
    }
    for (unsigned i = 0; i < 3; i++) {
        if (!is_near(up[i], 0) && !is_near(fabs(up[i]), 1 / sqrt(squares))) {
            return 0;
        }
    }
    return 1;
}

const char *turns_up_words(const invcal_real up[3], char text[TURNS_UP_MAX])
{
    static const char *const kinds[] = {"", "", "edge ", "corner "};
    char words[INVCAL_TEXT_SIZE];
    char axes[AXES_MAX] = "";
    unsigned named = 0;

    if (!is_cube_direction(up)) {
        snprintf(text, TURNS_UP_MAX, "%s", invcal_direction_text(up, words));
        return text;
    }
    for (unsigned i = 0; i < 3; i++) {
        if (!is_near(up[i], 0)) {
            const size_t length = strlen(axes);
            snprintf(axes + length, sizeof axes - length, "%s%c%c", named > 0 ? " " : "",
                     up[i] > 0 ? '+' : '-', "xyz"[i]);
            named++;
        }
    }
    snprintf(text, TURNS_UP_MAX, "%s%s up", kinds[named], axes);
    return text;
}

/* "a quarter turn", "70 degrees" */
static const char *angle_words(double degrees, char text[ANGLE_MAX])
{
    static const struct {
        double degrees;
        const char *words;
    } known[] = {
        {90, "a quarter turn"}, {180, "half a turn"}, {360, "a full turn"}, {720, "two turns"}};

    for (unsigned i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (is_near(degrees, known[i].degrees)) {
            return known[i].words;
        }
    }
    snprintf(text, ANGLE_MAX, "%.0f degrees", degrees);
    return text;
}

/* The axis that a vector is along: 0, 1, 2; or 3 for none. */
static unsigned along(const invcal_real v[3])
{
    for (unsigned i = 0; i < 3; i++) {
        if (is_near(fabs(v[i]), 1)) {
            return i;
        }
    }
    return 3;
}

double turns_degrees(const invcal_turn *turn)
{
    const double degrees = turn->angle / UNIT_DEGREE;
    const double whole = nearbyint(degrees);

    return fabs(degrees - whole) < 1e-9 ? whole : degrees;
}

const char *turns_words(const invcal_turn *turn, const invcal_real from[3],
                        char text[TURNS_WORDS_MAX])
{
    char angle[ANGLE_MAX];
    char up[TURNS_UP_MAX];
    const char *turned = angle_words(turns_degrees(turn), angle);
    const unsigned axis = along(turn->axis);
    double vertical = 0;

    for (unsigned i = 0; i < 3; i++) {
        vertical += turn->axis[i] * from[i];
    }
    turns_up_words(turn->up, up);
    if (is_near(fabs(vertical), 1)) {
        snprintf(text, TURNS_WORDS_MAX, "%s: %s as it stands, %s", up, turned,
                 vertical > 0 ? "left" : "right");
    } else if (axis > 2) {
        snprintf(text, TURNS_WORDS_MAX, "%s: %s", up, turned);
    } else if (turns_degrees(turn) < 180 - NEAR && is_cube_direction(turn->up)) {
        snprintf(text, TURNS_WORDS_MAX, "%s: %s about %c", up, turned, "xyz"[axis]);
    } else { /* up does not show the sense of rotation */
        snprintf(text, TURNS_WORDS_MAX, "%s about %c%c: %s", turned,
                 turn->axis[axis] > 0 ? '+' : '-', "xyz"[axis], up);
    }
    return text;
}
