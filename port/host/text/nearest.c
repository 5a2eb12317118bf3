/* SPDX-License-Identifier: MIT */
#include "text/nearest.h"

#include <stdio.h>
#include <string.h>

#define WORD_MAX 24u    /* longer than any name */
#define UNLIMITED 1000u /* edits, before any name is offered */

static unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* The Damerau-Levenshtein distance of two words, without edits between transposed letters. */
static unsigned distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    unsigned d[WORD_MAX + 1][WORD_MAX + 1];

    for (unsigned i = 0; i <= a_length; i++) {
        for (unsigned j = 0; j <= b_length; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = smaller(d[i - 1][j - 1] + (a[i - 1] != b[j - 1]),
                              smaller(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = smaller(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a_length][b_length];
}

nearest nearest_begin(const char *typed, size_t length)
{
    while (length > 0 && *typed == '-') {
        typed++;
        length--;
    }
    return (nearest){typed, length, UNLIMITED, NULL};
}

void nearest_offer(nearest *n, const char *name)
{
    const char *letters = name + strspn(name, "-");
    const size_t length = strlen(letters);

    if (n->length == 0 || n->length > WORD_MAX || length > WORD_MAX) {
        return;
    }
    const int is_prefix = strncmp(letters, n->typed, n->length) == 0;
    const unsigned edits =
        is_prefix ? n->length < length : distance(n->typed, n->length, letters, length);
    if (edits < n->edits && (is_prefix || edits <= length / 3)) {
        n->edits = edits;
        n->name = name;
    }
}

const char *nearest_text(const nearest *n, char text[NEAREST_TEXT_MAX])
{
    text[0] = '\0';
    if (n->name) {
        snprintf(text, NEAREST_TEXT_MAX, " (did you mean %s?)", n->name);
    }
    return text;
}
