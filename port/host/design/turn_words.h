/* SPDX-License-Identifier: MIT
 *
 * design/turn_words.h: turns (turns.h of the library) in words.
 */
#ifndef TURN_WORDS_H
#define TURN_WORDS_H

#include "imu/turns.h"

#define TURNS_WORDS_MAX 160
#define TURNS_UP_MAX 80

/* The angle of a turn; whole degrees are exact. */
double turns_degrees(const invcal_turn *turn);

/* The turn from one rest to the next: "+x up: a quarter turn about y", or, if that does not show
 * the sense of rotation, "a full turn about +x: +z up". */
const char *turns_words(const invcal_turn *turn, const invcal_real from[3],
                        char text[TURNS_WORDS_MAX]);

/* "+x up", "edge +x -y up", "corner +x -y +z up", or as invcal_direction_text. */
const char *turns_up_words(const invcal_real up[3], char text[TURNS_UP_MAX]);

#endif
