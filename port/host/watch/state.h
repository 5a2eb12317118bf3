/* SPDX-License-Identifier: MIT
 *
 * watch/state.h: the state of a live calibration. live.c and wave.c update it; lines.c and screen.c
 * show it.
 */
#ifndef WATCH_STATE_H
#define WATCH_STATE_H

#include <stdio.h>

#include "cli/unit_style.h"
#include "design/program.h"
#include "read/columns.h"
#include "watch/gyro.h"

typedef enum {
    WATCH_BEGUN,    /* the columns of the stream have been recognised */
    WATCH_TICK,     /* a tenth of a second of the log has passed */
    WATCH_MOVING,   /* the device moves */
    WATCH_SETTLING, /* it rests: see progress */
    WATCH_READY,    /* it has rested long enough: once in a rest */
    WATCH_TAKEN,    /* a position has been taken, and the device moves */
    WATCH_REFUSED,  /* a rest has been refused: once in a rest */
    WATCH_ENDED,    /* end of the stream */
    WATCH_BROKEN    /* end by an error, which has been reported */
} watch_event;

/* The effect of the last position. */
typedef enum {
    WATCH_USED,
    WATCH_GOAL_REACHED, /* for the first time */
    WATCH_FINISHED      /* the program is complete */
} watch_outcome;

#define WATCH_KINDS 3u      /* offsets (over the field), scale errors, angles (rad) */
#define WATCH_WRONG_HINT 2u /* wrong positions in a row after which a hint is given */
#define WATCH_GOOD_MAX (PROGRAM_TEXT_MAX + 64)

typedef struct {
    FILE *out;
    unit_style units;
    int is_magnetometer;   /* one is waved: positions are visited cells, and up is the field */
    const char *disturbed; /* by what: a clause; "": by nothing */

    /* the log */
    const char *name;
    char recognised[COLUMNS_TEXT_MAX]; /* its columns, in words */
    double seconds;                    /* since its first sample */
    unsigned long skipped;             /* malformed lines */
    double hold;                       /* seconds, from the Allan deviation; 0: none */
    double hold_floor;                 /* smallest sigma that any time reaches; 0: no floor */

    /* the device */
    watch_event phase; /* WATCH_MOVING, WATCH_SETTLING, WATCH_READY, WATCH_ENDED */
    unsigned progress;
    int is_refused;      /* the current rest is */
    const char *refusal; /* why the current or last rest was refused */
    watch_event last;    /* the later one of WATCH_TAKEN and WATCH_REFUSED; else WATCH_BEGUN */
    int has_up;
    double up[3]; /* unit vector that points up, in the frame of the case */
    int is_guess; /* zero and scale are neither stated nor determined by positions yet */

    /* where to go */
    int has_target;
    double target[3];
    char next[PROGRAM_TEXT_MAX]; /* the same in words, or the turn to it; "": nowhere */
    char good[WATCH_GOOD_MAX];   /* of a READY rest: that it is good, and where to move on to */

    /* the result so far */
    unsigned taken; /* number of positions */
    watch_gyro gyro;
    unsigned covered;
    double direction[INVCAL_MAX_POSITIONS][3]; /* of the last positions; `covered` of them */
    unsigned wrong_count;         /* consecutive rests at wrong positions, up to the last */
    char wrong[PROGRAM_TEXT_MAX]; /* where the last one was */
    invcal_status status;
    invcal_quality quality;
    double accuracy;                  /* of lengths, 95 %, over the field */
    double target_sigma[WATCH_KINDS]; /* 0: no limit */
    double need;                      /* of accuracy; 0: no limit */
    int is_good;                      /* the verdict is good, or, with a goal, that is reached */
    watch_outcome outcome;            /* of the last position */
    char missing[PROGRAM_TEXT_MAX];   /* at the end: positions of the program not visited */
} watch_state;

/* Degrees from the current to the next up direction: 0 ... 180; below 0 if either is unknown. */
double watch_degrees_to_go(const watch_state *now);

/* 1 if sigma is known. */
int watch_knows_sigma(const watch_state *now);

/* Half the 95 % interval of the worst axis of a kind. */
double watch_interval(const watch_state *now, unsigned kind);

/* The same for the target; 0: no limit. */
double watch_goal(const watch_state *now, unsigned kind);

/* 1 if there is a target, or a need. */
int watch_has_goal(const watch_state *now);

/* The unit for output. */
display_unit watch_unit(const watch_state *now, unsigned kind);
extern const char *const watch_kinds[WATCH_KINDS];

/* The output. */
typedef void (*watch_view)(const watch_state *now, watch_event event);

#endif
