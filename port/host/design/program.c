/* SPDX-License-Identifier: MIT */
#include "design/program.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "invcal/plan.h"
#include "maths/angles.h"

#define DEGREES 57.295779513082321
#define CAPTURE_ANGLE 20.0 /* degrees: farther off is another direction */
#define PREFERENCE 3.0     /* degrees that another one must be nearer than the requested one */
#define SAME_DIRECTION 0.1 /* degrees between two positions of one direction */
#define ROUNDING 1e-6      /* degrees */
#define RESIDUAL_MAX 0.1   /* over the field: above it, these are not readings of these positions */

enum { NOT_NEEDED = 1, VISITED };

/* The angle between two directions, degrees; the first of any length. */
static double angle_between(const double a[3], const double b[3])
{
    const double sine = hypot(hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2]),
                              a[0] * b[1] - a[1] * b[0]);

    return DEGREES * atan2(sine, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

static const double *vertical(const program *p, unsigned position)
{
    return p->set->position[position].vertical;
}

static stand_angles angles_at(const program *p, unsigned position)
{
    const design_position *at = &p->set->position[position];

    return (stand_angles){at->alpha, at->beta};
}

void program_begin(program *p, const design *set)
{
    p->set = set;
    memset(p->visited, 0, sizeof p->visited);
    p->next = 0;
    p->has_rest = 0;
    p->is_repeat = 0;
    p->current = PROGRAM_NO_POSITION;
}

/* The nearest within CAPTURE_ANGLE; of several of one direction, one that is still to be
 * visited. */
static unsigned nearest_to(const program *p, const double up[3], double *min)
{
    unsigned nearest = PROGRAM_NO_POSITION;

    *min = CAPTURE_ANGLE;
    for (unsigned i = 0; i < p->set->count; i++) {
        const double angle = angle_between(up, vertical(p, i));
        const int is_equal = nearest != PROGRAM_NO_POSITION && fabs(angle - *min) < ROUNDING;
        if (is_equal ? p->visited[i] < p->visited[nearest] : angle < *min) {
            *min = angle;
            nearest = i;
        }
    }
    return nearest;
}

unsigned program_find(const program *p, const double up[3])
{
    double min;
    const unsigned nearest = nearest_to(p, up, &min);

    if (p->next < p->set->count) {
        const double angle = angle_between(up, vertical(p, p->next));
        if (angle < CAPTURE_ANGLE && angle < min + PREFERENCE) {
            return p->next;
        }
    }
    return nearest;
}

/* Positions that follow in the same direction need not be visited: a rest cannot distinguish
 * them. */
static void mark(program *p, unsigned position)
{
    const double *up = vertical(p, position);

    p->visited[position] = VISITED;
    for (unsigned i = position + 1;
         i < p->set->count && angle_between(up, vertical(p, i)) < SAME_DIRECTION; i++) {
        p->visited[i] = p->visited[i] == VISITED ? VISITED : NOT_NEEDED;
    }
}

void program_visit(program *p, unsigned position, const double up[3])
{
    p->has_rest = 1;
    p->current = position;
    p->is_repeat = position < p->set->count && p->visited[position] == NOT_NEEDED;
    memcpy(p->up, up, sizeof p->up);
    if (position < p->set->count) {
        mark(p, position);
    }
    while (p->next < p->set->count && p->visited[p->next]) {
        p->next++;
    }
}

/* ---- zero and scale ---------------------------------------------------------------------------- */

/* to += share v. */
static void add(double to[3], const double v[3], double share)
{
    for (unsigned i = 0; i < 3; i++) {
        to[i] += share * v[i];
    }
}

int program_scale(const program *p, const double *mean, unsigned count, double zero[3],
                  double *length)
{
    double reading[3] = {0, 0, 0};
    double up[3] = {0, 0, 0};
    double product = 0;
    double square = 0;
    double rest = 0;

    for (unsigned n = 0; n < count; n++) {
        add(reading, &mean[3 * (size_t)n], 1.0 / count);
        add(up, vertical(p, n), 1.0 / count);
    }
    for (unsigned n = 0; n < count; n++) {
        for (unsigned i = 0; i < 3; i++) {
            const double eta = vertical(p, n)[i] - up[i];
            const double u = mean[3 * (size_t)n + i] - reading[i];
            product += eta * u;
            square += eta * eta;
            rest += u * u;
        }
    }
    *length = product / square;
    rest -= *length * product;
    for (unsigned i = 0; i < 3; i++) {
        zero[i] = reading[i] - *length * up[i];
    }
    return square > 0 && *length > 0 &&
           rest < RESIDUAL_MAX * RESIDUAL_MAX * *length * *length * count;
}

/* ---- in words ---------------------------------------------------------------------------------- */

/* The angles of the last rest: those of its position, else from the readings. */
static stand_angles current_angles(const program *p, unsigned requested)
{
    return p->current < p->set->count ? angles_at(p, p->current)
                                      : angles_near(p->up, angles_at(p, requested));
}

const char *program_angles_text(const program *p, char text[PROGRAM_TEXT_MAX])
{
    char angles[ANGLES_TEXT_MAX] = "";

    if (p->next < p->set->count) {
        (void)angles_text(angles_at(p, p->next), angles);
    }
    snprintf(text, PROGRAM_TEXT_MAX, "%s", angles);
    return text;
}

const char *program_next_text(const program *p, char text[PROGRAM_TEXT_MAX])
{
    char angles[ANGLES_TEXT_MAX];
    char turn[ANGLES_TEXT_MAX] = "";
    char words[INVCAL_TEXT_SIZE];

    text[0] = '\0';
    if (p->next >= p->set->count) {
        return text;
    }
    if (p->has_rest) {
        (void)angles_turn_text(current_angles(p, p->next), angles_at(p, p->next), turn);
    }
    snprintf(text, PROGRAM_TEXT_MAX, "position %u of %u: %s; %s%s%s", p->next + 1, p->set->count,
             angles_text(angles_at(p, p->next), angles), turn, *turn ? "; " : "",
             invcal_direction_text(vertical(p, p->next), words));
    return text;
}

const char *program_wrong_text(const program *p, unsigned requested, char text[PROGRAM_TEXT_MAX])
{
    char angles[ANGLES_TEXT_MAX];

    (void)angles_text(current_angles(p, requested), angles);
    if (p->current < p->set->count) {
        snprintf(text, PROGRAM_TEXT_MAX, "that is position %u (%s), not %u", p->current + 1, angles,
                 requested + 1);
    } else {
        snprintf(text, PROGRAM_TEXT_MAX, "that is %s, not a position of the program; go to %u",
                 angles, requested + 1);
    }
    return text;
}

const char *program_missing_text(const program *p, char text[PROGRAM_TEXT_MAX])
{
    size_t length = 0;

    text[0] = '\0';
    for (unsigned i = 0; i < p->set->count && length + 12 < PROGRAM_TEXT_MAX; i++) {
        if (!p->visited[i]) {
            length += (size_t)snprintf(text + length, PROGRAM_TEXT_MAX - length, "%s%u",
                                       length > 0 ? ", " : "", i + 1);
        }
    }
    if (length + 12 >= PROGRAM_TEXT_MAX) {
        snprintf(text + length, PROGRAM_TEXT_MAX - length, ", ...");
    }
    return text;
}
