/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "read/columns_option.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/number.h"

/* The name or number of each column that --columns states; empty: it does not. */
static char chosen[COLUMN_COUNT][HEADING_NAME_MAX];
static char option_text[COLUMNS_OPTION_MAX]; /* the whole value; empty: not given */
static int required[COLUMN_COUNT];

/* The column with this name; COLUMN_COUNT: none. */
static column column_of_name(const char *name)
{
    static const struct {
        const char *name;
        column which;
    } others[] = {{"time", COLUMN_TIME}, {"temp", COLUMN_TEMPERATURE}};

    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (strcmp(name, others[i].name) == 0) {
            return others[i].which;
        }
    }
    for (unsigned c = 0; c < COLUMN_COUNT; c++) {
        if (strcmp(name, column_name((column)c)) == 0) {
            return (column)c;
        }
    }
    return COLUMN_COUNT;
}

static int refuse_option(const char *command, const char *what)
{
    return message_usage(command,
                         "--columns %s: %s; give three, for x, y and z, such as 2,3,4 or ax,ay,az, "
                         "or name each: t=1,x=2,y=3,z=4,temperature=5",
                         option_text, what);
}

/* Parses an item: `ax`, the next of x, y and z; or `t=1`. */
static int choose_column(const char *command, char *item, unsigned *unnamed)
{
    char *equals = strchr(item, '=');
    column which = COLUMN_COUNT;

    if (!equals) {
        which = *unnamed < 3 ? (column)(COLUMN_X + *unnamed) : COLUMN_COUNT;
        *unnamed += 1;
    } else {
        *equals = '\0';
        which = column_of_name(item);
        item = equals + 1;
    }
    if (which == COLUMN_COUNT) {
        return refuse_option(command, equals ? "unknown name before '='"
                                             : "more than three without a name before '='");
    }
    if (*item == '\0' || *chosen[which] != '\0' || strlen(item) >= HEADING_NAME_MAX) {
        return refuse_option(command,
                             *item == '\0' ? "one is empty" : "one is given twice or too long");
    }
    memcpy(chosen[which], item, strlen(item) + 1);
    return EXIT_GOOD;
}

int columns_option_parse(const char *command, const char *text)
{
    char copy[COLUMNS_OPTION_MAX];
    unsigned unnamed = 0;
    int failure = EXIT_GOOD;

    memset(chosen, 0, sizeof chosen);
    memset(required, 0, sizeof required);
    snprintf(option_text, sizeof option_text, "%s", text ? text : "");
    snprintf(copy, sizeof copy, "%s", option_text);
    if (text && strlen(text) >= sizeof copy) {
        return refuse_option(command, "is too long");
    }
    for (char *item = text ? copy : NULL; item && !failure;) {
        char *comma = strchr(item, ',');
        if (comma) {
            *comma = '\0';
        }
        failure = choose_column(command, item, &unnamed);
        item = comma ? comma + 1 : NULL;
    }
    const int has_x = *chosen[COLUMN_X] != '\0';
    const int is_complete =
        (*chosen[COLUMN_Y] != '\0') == has_x && (*chosen[COLUMN_Z] != '\0') == has_x;
    return failure || is_complete ? failure
                                  : refuse_option(command, "x, y and z must all be given");
}

int columns_option_has(column which)
{
    return *chosen[which] != '\0';
}

void columns_option_require(column which)
{
    required[which] = 1;
}

int columns_option_requires(column which)
{
    return required[which] || columns_option_has(which);
}

const char *columns_option_text(void)
{
    return option_text;
}

static int report_missing(const table *t, const heading *headings, column which)
{
    char names[256] = "";

    for (unsigned i = 0; i < t->columns && t->has_header; i++) {
        const size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, "%s%s", i ? ", " : ": ", headings[i].name);
    }
    message("%s:%lu: --columns: no column '%s' for %s among the %u%s", t->name, t->line,
            chosen[which], column_name(which), t->columns, names);
    return EXIT_FILE;
}

/* By its name, with or without the unit, else by its number. */
int columns_option_find(const table *t, const heading *headings, column which, int *index)
{
    double number = 0;

    *index = -1;
    if (which > COLUMN_Z && strcmp(chosen[which], "none") == 0) {
        return EXIT_GOOD;
    }
    for (unsigned i = 0; i < t->columns && t->has_header && *index < 0; i++) {
        *index = strcasecmp(t->field[i], chosen[which]) == 0 ||
                         strcasecmp(headings[i].name, chosen[which]) == 0
                     ? (int)i
                     : -1;
    }
    if (*index < 0 && number_parse(chosen[which], &number) == NUMBER_OK && number >= 1 &&
        number <= t->columns && !(fabs(number - floor(number)) > 0)) {
        *index = (int)number - 1;
    }
    return *index < 0 ? report_missing(t, headings, which) : EXIT_GOOD;
}

int columns_option_find_axes(const table *t, const heading *headings, int index[3])
{
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = columns_option_find(t, headings, (column)(COLUMN_X + i), &index[i]);
    }
    if (!failure && (index[0] == index[1] || index[1] == index[2] || index[0] == index[2])) {
        message("%s:%lu: --columns %s: x, y and z must be three different columns", t->name,
                t->line, option_text);
        failure = EXIT_FILE;
    }
    return failure;
}
