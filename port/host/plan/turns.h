/* SPDX-License-Identifier: MIT
 *
 * plan/turns.h: a program of turns for a gyroscope and an accelerometer, and the expected accuracy
 * (invcal/gyro.h).
 */
#ifndef PLAN_TURNS_H
#define PLAN_TURNS_H

#include <stdio.h>

#include "cli/unit_style.h"
#include "design/turn_words.h"

#define TURNS_MAX (INVCAL_MAX_MOVES - 1) /* a device keeps INVCAL_MAX_MOVES rests */
#define TURNS_SECONDS_MAX 10.0           /* seconds; in longer moves, the bias is unknown */
#define TURNS_LIST_MAX 1200

/* The names of programs, for messages. */
#define TURNS_PROGRAMS "tour12|tour16|tour24|faces|greedyN|LIST"

/* Noise and times. */
typedef struct {
    double noise;       /* of a position mean, over field */
    double rate_noise;  /* rad/s/sqrt(Hz) */
    double instability; /* rad/s */
    double rest, turn;  /* seconds in each rest; of a quarter turn */
    unit_style units;
} turns_request;

typedef struct {
    invcal_turn turn;
    unsigned open;     /* number of parameters undetermined after it */
    unsigned improves; /* bits of the parameters, at most two, whose sigma it reduces most */
} turns_step;

typedef struct {
    const char *program;
    turns_request request;
    invcal_real start[3]; /* points up in the first rest */
    unsigned count;
    turns_step step[TURNS_MAX];
    int is_determined;
    unsigned open; /* bits of the undetermined, or, if all are determined, weak parameters */
    unsigned rank;
    double sigma[INVCAL_IMU_PARAMETERS]; /* over the noise of a position mean */
    double condition;
    double seconds;   /* total */
    invcal_turn next; /* the most informative next turn */
    char refusal[TURNS_LIST_MAX];
} turns_plan;

/* Makes the program of this name, or list, and evaluates it.
 *
 * Returns EXIT_GOOD; EXIT_USAGE, with a message: no such program; EXIT_DATA, without one: some
 * parameters are undetermined, see refusal. */
int turns_make(turns_plan *plan, const char *word, const turns_request *request);

/* The kind of a parameter, as in words.h: 0 an offset, 1 a scale, 2 an angle. */
unsigned turns_kind(unsigned parameter);

/* A table; one JSON object; a page. */
void turns_print(FILE *file, const turns_plan *plan);
void turns_json(FILE *file, const turns_plan *plan);
void turns_report(FILE *file, const turns_plan *plan, const char *command);

#endif
