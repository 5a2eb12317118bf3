/* SPDX-License-Identifier: MIT
 *
 * text/nearest.h: which word somebody may have meant.
 */
#ifndef NEAREST_H
#define NEAREST_H

#include <stddef.h>

typedef struct {
    const char *typed;
    size_t length;    /* of it */
    unsigned edits;   /* from it to the nearest so far */
    const char *name; /* that; null: none is near */
} nearest;

/* A search for `length` characters of `typed`; dashes before it do not count. */
nearest nearest_begin(const char *typed, size_t length);

/* One of the words that there are. Near is one that goes on as it was typed, or one that a third
 * as many edits lead to as it has letters: a letter more, less or another, or two exchanged. */
void nearest_offer(nearest *n, const char *name);

/* " (did you mean NAME?)", or nothing if none is near. Returns text. */
#define NEAREST_TEXT_MAX 64
const char *nearest_text(const nearest *n, char text[NEAREST_TEXT_MAX]);

#endif
