/* SPDX-License-Identifier: MIT
 *
 * text/nearest.h: suggests the known word that is nearest to a mistyped one.
 */
#ifndef NEAREST_H
#define NEAREST_H

#include <stddef.h>

typedef struct {
    const char *typed;
    size_t length;    /* of typed */
    unsigned edits;   /* from typed to the nearest name so far */
    const char *name; /* the nearest one; null: none is near */
} nearest;

/* Starts with the first `length` characters of `typed`, without leading dashes. */
nearest nearest_begin(const char *typed, size_t length);

/* Offers a known word. It is near if it begins with the typed text, or if the number of edits is at
 * most a third of its length: a letter inserted, deleted, replaced, or two transposed. */
void nearest_offer(nearest *n, const char *name);

/* " (did you mean NAME?)", or nothing if none is near. Returns text. */
#define NEAREST_TEXT_MAX 64
const char *nearest_text(const nearest *n, char text[NEAREST_TEXT_MAX]);

#endif
