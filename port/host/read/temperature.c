/* SPDX-License-Identifier: MIT */
#include "read/temperature.h"

#include "cli/command.h"
#include "cli/message.h"
#include "read/columns_option.h"
#include "text/number.h"

static number_status status_of(const table *t, const columns *where)
{
    double number;

    return number_parse(t->field[where->index[COLUMN_TEMPERATURE]], &number);
}

int temperature_is_missing(const table *t, const columns *where)
{
    const number_status status = status_of(t, where);
    const int is_blank = status == NUMBER_EMPTY || status == NUMBER_NOT_FINITE;

    return status != NUMBER_OK && !columns_option_requires(COLUMN_TEMPERATURE) &&
           (is_blank || !t->is_forgiving);
}

void temperature_warn(const table *t, const columns *where, const char *becomes)
{
    const int index = where->index[COLUMN_TEMPERATURE];
    const number_status status = status_of(t, where);
    char excerpt[TABLE_EXCERPT_MAX];

    if (status == NUMBER_EMPTY) {
        message("warning: %s:%lu: temperature %s: column %d is empty", t->name, t->line, becomes,
                index + 1);
    } else {
        message("warning: %s:%lu: temperature %s: '%s' in column %d %s", t->name, t->line, becomes,
                table_excerpt(t->field[index], excerpt), index + 1, number_problem(status));
    }
}

int temperature_read(const table *t, columns *where, double *out)
{
    int *index = &where->index[COLUMN_TEMPERATURE];

    if (*index < 0) {
        return EXIT_GOOD;
    }
    if (!temperature_is_missing(t, where)) {
        return columns_number(t, where, COLUMN_TEMPERATURE, out);
    }
    temperature_warn(t, where, "ignored");
    *index = -1;
    where->seen.name[COLUMN_TEMPERATURE][0] = '\0';
    where->seen.ignored++;
    return EXIT_GOOD;
}
