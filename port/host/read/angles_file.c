/* SPDX-License-Identifier: MIT */
#include "read/angles_file.h"

#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/number.h"
#include "read/table.h"

enum { ALPHA, BETA, DWELL, COLUMNS };

#define ABSENT TABLE_COLUMNS_MAX
#define DWELL_MAX 1e6

static const char *const names[COLUMNS] = {"alpha", "beta", "dwell"};

/* Finds the columns by name or, without a header, by position. */
static int find_columns(const table *t, unsigned at[COLUMNS])
{
    for (unsigned k = 0; k < COLUMNS; k++) {
        at[k] = !t->has_header && k < t->columns ? k : ABSENT;
        for (unsigned i = 0; i < t->columns && t->has_header; i++) {
            at[k] = strcmp(t->field[i], names[k]) == 0 ? i : at[k];
        }
    }
    if (at[BETA] != ABSENT && at[ALPHA] != ABSENT && (t->has_header || t->columns <= COLUMNS)) {
        return EXIT_GOOD;
    }
    message("%s:%lu: columns alpha and beta expected; without a header, two or three columns: "
            "alpha beta dwell",
            t->name, t->line);
    return EXIT_FILE;
}

/* Reads a number of the current row, between two bounds. */
static int read_number(const table *t, unsigned column, const char *name, double least, double most,
                       double *out)
{
    char text[TABLE_EXCERPT_MAX];
    const number_status status = number_parse(t->field[column], out);

    if (status != NUMBER_OK) {
        message("%s:%lu: %s '%s' %s", t->name, t->line, name, table_excerpt(t->field[column], text),
                number_problem(status));
        return EXIT_FILE;
    }
    if (!(*out >= least && *out <= most)) {
        message("%s:%lu: %s %s is out of range, %g ... %g", t->name, t->line, name,
                table_excerpt(t->field[column], text), least, most);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

static int read_row(angles_list *a, const table *t, const unsigned at[COLUMNS])
{
    double number[COLUMNS] = {0};
    int failure = EXIT_GOOD;

    if (a->count == a->capacity) {
        message("%s:%lu: more than %u positions", t->name, t->line, a->capacity);
        return EXIT_FILE;
    }
    for (unsigned k = 0; k < COLUMNS && !failure; k++) {
        if (at[k] != ABSENT) {
            failure = read_number(t, at[k], names[k], k == DWELL ? 0 : -360,
                                  k == DWELL ? DWELL_MAX : 360, &number[k]);
        }
    }
    a->angle[a->count] =
        (stand_angles){angles_turn(0, number[ALPHA]), angles_turn(0, number[BETA])};
    a->dwell[a->count++] = number[DWELL];
    return failure;
}

static int check(const angles_list *a, const table *t, int has_dwell)
{
    double sum = 0;

    for (unsigned i = 0; i < a->count; i++) {
        sum += a->dwell[i];
    }
    if (a->count == 0) {
        message("%s: contains no position", t->name);
        return EXIT_FILE;
    }
    if (has_dwell && !(sum > 0)) {
        message("%s: no position has a dwell above 0", t->name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

int angles_file_read(angles_list *a, const char *path)
{
    static table t; /* large */
    unsigned at[COLUMNS] = {ABSENT, ABSENT, ABSENT};
    int next = 0;
    int failure = table_open_pairs(&t, path);

    a->count = 0;
    failure = failure ? failure : find_columns(&t, at);
    while (!failure && (next = table_next(&t)) > 0) {
        failure = read_row(a, &t, at);
    }
    failure = failure || next < 0 ? EXIT_FILE : check(a, &t, at[DWELL] != ABSENT);
    table_close(&t);
    return failure;
}
