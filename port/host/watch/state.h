/* SPDX-License-Identifier: MIT
 *
 * watch/state.h: what is known at any time of a calibration that goes on. live.c keeps it; lines.c and
 * screen.c show it, and only read.
 */
#ifndef WATCH_STATE_H
#define WATCH_STATE_H

#include <stdio.h>

#include "cli/unit_style.h"
#include "design/program.h"
#include "read/columns.h"
#include "watch/gyro.h"

/* What has just come about. */
typedef enum {
    WATCH_BEGUN,    /* the stream has been recognised */
    WATCH_PASSED,   /* a tenth of a second of the log has passed */
    WATCH_MOVING,   /* the device moves, */
    WATCH_SETTLING, /* rests: see progress, */
    WATCH_READY,    /* or has rested long enough: once in a rest */
    WATCH_TAKEN,    /* it has left a position, */
    WATCH_REFUSED,  /* or a rest is none: once in a rest */
    WATCH_ENDED,    /* the stream has come to its end, */
    WATCH_BROKEN    /* or to an error, which has been reported */
} watch_news;

/* What the last position has brought about. */
typedef enum {
    WATCH_USED,
    WATCH_ENOUGH,  /* what is wanted is reached for the first time */
    WATCH_FINISHED /* the program is complete */
} watch_outcome;

#define WATCH_KINDS 3u  /* offsets (over the field), scale errors, angles (rad) */
#define WATCH_ASTRAY 2u /* positions in a row that were not asked for: worth a word */
#define WATCH_GOOD_MAX (PROGRAM_TEXT_MAX + 64)

typedef struct {
    FILE *talk; /* where it is printed */
    unit_style units;
    int is_magnetometer; /* one is waved: positions are cells that have been passed through, and up
                            stands for the field */
    const char *disturbed; /* by what: a clause; "": by nothing */

    /* the log */
    const char *name;
    char recognised[COLUMNS_TEXT_MAX]; /* what it was taken for */
    double seconds;                    /* since its first sample */
    unsigned long skipped;             /* malformed lines */
    double hold;       /* of each position, by the noise that was measured; 0: no, */
    double hold_floor; /* and what a mean is good to however long; 0: no end */

    /* the device */
    watch_news
        phase; /* WATCH_MOVING, WATCH_SETTLING, WATCH_READY: good, and still held; WATCH_ENDED */
    unsigned progress;
    int is_refused;      /* the rest that goes on is no position, */
    const char *refusal; /* and why, or why the last was none */
    watch_news last;     /* WATCH_TAKEN or WATCH_REFUSED, whichever was later; else WATCH_BEGUN */
    int has_up;
    double up[3]; /* the direction that points upwards, in the frame of the case: a unit vector */
    int is_guess; /* directions are by a zero or a scale that is not stated, nor positions
                        have told yet */

    /* where to go */
    int has_target;
    double target[3];
    char next[PROGRAM_TEXT_MAX]; /* the same in words, or the turn to it; "": nowhere */
    char good
        [WATCH_GOOD_MAX]; /* of a rest that is READY: that it is good, and where to move on to */

    /* what there is */
    unsigned taken;  /* positions, */
    watch_gyro gyro; /* what the moves determine of a gyroscope */
    unsigned covered;
    double direction[INVCAL_MAX_POSITIONS][3]; /* and where the last of them point */
    unsigned astray;                           /* rests in a row that were not those asked for, */
    char wrong[PROGRAM_TEXT_MAX];              /* and where the last of them was */
    invcal_status status;                      /* of these: */
    invcal_quality quality;
    double accuracy;                  /* of lengths, 95 %, over the field */
    double target_sigma[WATCH_KINDS]; /* that is enough; 0: any */
    double need;                      /* accuracy that is enough; 0: any */
    int is_good;                      /* they are good, and what is wanted is reached */
    watch_outcome outcome;            /* of the last */
    char missing[PROGRAM_TEXT_MAX]; /* positions of the program that were not visited; at the end */
} watch_state;

/* Degrees from where the device points to where it should: 0 ... 180; below 0 if either is not known. */
double watch_to_go(const watch_state *now);

/* sigma is known. */
int watch_knows_sigma(const watch_state *now);

/* The half-width of the interval of 95 % of the worst axis of a kind. */
double watch_interval(const watch_state *now, unsigned kind);

/* The same of what is wanted; 0: anything. */
double watch_wanted(const watch_state *now, unsigned kind);

/* There is a target, or a need. */
int watch_is_anything_wanted(const watch_state *now);

/* The unit that it is printed in. */
display_unit watch_unit(const watch_state *now, unsigned kind);
extern const char *const watch_kinds[WATCH_KINDS];

/* The output. */
typedef void (*watch_teller)(const watch_state *now, watch_news what);

#endif
