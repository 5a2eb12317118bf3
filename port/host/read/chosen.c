/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "read/chosen.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/number.h"

/* By --columns: for each meaning a name or a number; empty: it is found. */
static char chosen[COLUMN_COUNT][HEADING_NAME_MAX];
static char stated[COLUMNS_CHOICE_MAX]; /* all of it; empty: nothing is stated */
static int needed[COLUMN_COUNT];

/* The meaning with this name, or COLUMN_COUNT. */
static column meaning_of(const char *name)
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

static int refuse_choice(const char *command, const char *what)
{
    return message_usage(command,
                         "--columns %s: %s; give three, for x, y and z, such as 2,3,4 or ax,ay,az, "
                         "or name each: t=1,x=2,y=3,z=4,temperature=5",
                         stated, what);
}

/* `ax`, the next of x, y and z; or `t=1`. */
static int choose(const char *command, char *item, unsigned *unnamed)
{
    char *equals = strchr(item, '=');
    column which = COLUMN_COUNT;

    if (!equals) {
        which = *unnamed < 3 ? (column)(COLUMN_X + *unnamed) : COLUMN_COUNT;
        *unnamed += 1;
    } else {
        *equals = '\0';
        which = meaning_of(item);
        item = equals + 1;
    }
    if (which == COLUMN_COUNT) {
        return refuse_choice(command, equals ? "unknown name before '='"
                                             : "more than three without a name before '='");
    }
    if (*item == '\0' || *chosen[which] != '\0' || strlen(item) >= HEADING_NAME_MAX) {
        return refuse_choice(command,
                             *item == '\0' ? "one is empty" : "one is given twice or too long");
    }
    memcpy(chosen[which], item, strlen(item) + 1);
    return EXIT_GOOD;
}

int chosen_read(const char *command, const char *text)
{
    char copy[COLUMNS_CHOICE_MAX];
    unsigned unnamed = 0;
    int failure = EXIT_GOOD;

    memset(chosen, 0, sizeof chosen);
    memset(needed, 0, sizeof needed);
    snprintf(stated, sizeof stated, "%s", text ? text : "");
    snprintf(copy, sizeof copy, "%s", stated);
    if (text && strlen(text) >= sizeof copy) {
        return refuse_choice(command, "is too long");
    }
    for (char *item = text ? copy : NULL; item && !failure;) {
        char *comma = strchr(item, ',');
        if (comma) {
            *comma = '\0';
        }
        failure = choose(command, item, &unnamed);
        item = comma ? comma + 1 : NULL;
    }
    const int one = *chosen[COLUMN_X] != '\0';
    const int are_alike = (*chosen[COLUMN_Y] != '\0') == one && (*chosen[COLUMN_Z] != '\0') == one;
    return failure || are_alike ? failure : refuse_choice(command, "x, y and z must all be given");
}

int chosen_is(column which)
{
    return *chosen[which] != '\0';
}

void chosen_need(column which)
{
    needed[which] = 1;
}

int chosen_is_needed(column which)
{
    return needed[which] || chosen_is(which);
}

const char *chosen_text(void)
{
    return stated;
}

static int say_no_column(const table *t, const heading *headings, column which)
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

/* Which column it is: by its name, with or without its unit, else by its number. */
int chosen_find(const table *t, const heading *headings, column which, int *index)
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
    return *index < 0 ? say_no_column(t, headings, which) : EXIT_GOOD;
}

int chosen_find_axes(const table *t, const heading *headings, int index[3])
{
    int failure = EXIT_GOOD;

    for (unsigned i = 0; i < 3 && !failure; i++) {
        failure = chosen_find(t, headings, (column)(COLUMN_X + i), &index[i]);
    }
    if (!failure && (index[0] == index[1] || index[1] == index[2] || index[0] == index[2])) {
        message("%s:%lu: --columns %s: x, y and z must be three different columns", t->name,
                t->line, stated);
        failure = EXIT_FILE;
    }
    return failure;
}
