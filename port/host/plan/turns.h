/* SPDX-License-Identifier: MIT
 *
 * plan/turns.h: a program of turns for a gyroscope and an accelerometer, and what it will determine
 * (invcal/gyro.h), before anything is measured.
 */
#ifndef PLAN_TURNS_H
#define PLAN_TURNS_H

#include <stdio.h>

#include "cli/unit_style.h"
#include "design/turn_words.h"

#define TURNS_MAX (INVCAL_MAX_MOVES - 1) /* a device keeps INVCAL_MAX_MOVES rests */
#define TURNS_LONGEST 10.0               /* seconds: of longer moves the bias is not known */
#define TURNS_LIST_MAX 1200

/* The words of programs, as help names them. */
#define TURNS_PROGRAMS "tour12|tour16|tour24|faces|greedyN|LIST"

/* Noise, as stated, and times, s. */
typedef struct {
    double noise;       /* of a position mean, over field */
    double rate_noise;  /* rad/s/sqrt(Hz) */
    double instability; /* rad/s */
    double rest, turn;  /* in each rest; a quarter turn */
    unit_style units;
} turns_request;

typedef struct {
    invcal_turn turn;
    unsigned open;     /* parameters that are undetermined after it */
    unsigned improves; /* those whose sigma it lowers most, at most two, as bits */
} turns_step;

typedef struct {
    const char *program;
    turns_request asked;
    invcal_real start[3]; /* points up in the first rest */
    unsigned count;
    turns_step step[TURNS_MAX];
    int is_determined;
    unsigned open; /* parameters undetermined; or weak */
    unsigned rank;
    double sigma[INVCAL_IMU_PARAMETERS]; /* over the noise of a position mean */
    double condition;
    double seconds;   /* in all */
    invcal_turn next; /* the one that would add most */
    char refusal[TURNS_LIST_MAX];
} turns_plan;

/* Makes the program of a word, and finds what it determines.
 *
 * Returns EXIT_GOOD; EXIT_USAGE, with a message: no such program; EXIT_DATA, without one: it leaves
 * parameters undetermined, see refusal. */
int turns_make(turns_plan *plan, const char *word, const turns_request *request);

/* The kind of a parameter, as in words.h: 0 an offset, 1 a scale, 2 an angle. */
unsigned turns_kind(unsigned parameter);

/* A table for people; one JSON object; a page. */
void turns_print(FILE *file, const turns_plan *plan);
void turns_json(FILE *file, const turns_plan *plan);
void turns_report(FILE *file, const turns_plan *plan, const char *command);

#endif
