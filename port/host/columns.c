/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "columns.h"

#include <string.h>
#include <strings.h>

#include "command.h"
#include "message.h"
#include "number.h"

#define TWICE (-2)

/* Index of the column with this name; -1 if there is none, TWICE. */
static int find_name(const table *t, const char *name)
{
    int found = -1;

    for (unsigned i = 0; i < t->columns; i++) {
        if (strcasecmp(t->field[i], name) == 0) {
            found = found == -1 ? (int)i : TWICE;
        }
    }
    return found;
}

/* A column that may have one of several names (ended by null), and may be missing. */
static int find_optional(const table *t, const char *const *names, int *index)
{
    *index = -1;
    for (; *names; names++) {
        const int found = find_name(t, *names);
        if (found == TWICE || (found >= 0 && *index >= 0)) {
            message("%s:%lu: more than one column could be '%s'", t->name, t->line, *names);
            return EXIT_FILE;
        }
        *index = found >= 0 ? found : *index;
    }
    return EXIT_GOOD;
}

/* Three columns of one family of names. 1, or 0 if one is not there; TWICE. */
static int find_three(const table *t, const char *const names[3], int index[3])
{
    int there = 1;

    for (unsigned i = 0; i < 3; i++) {
        index[i] = find_name(t, names[i]);
        if (index[i] == TWICE) {
            return TWICE;
        }
        there = there && index[i] >= 0;
    }
    return there;
}

/* x, y and z come from one family: a log with an accelerometer and a magnetometer has two, and
 * nobody can guess which one is meant. */
static int find_xyz(const table *t, int index[3])
{
    static const char *const families[][3] = {
        {"x", "y", "z"},
        {"ax", "ay", "az"},
        {"acc_x", "acc_y", "acc_z"},
        {"accel_x", "accel_y", "accel_z"},
        {"mx", "my", "mz"},
        {"mag_x", "mag_y", "mag_z"},
        {"mean_x", "mean_y", "mean_z"},
    };
    const char *const *first = NULL;

    for (unsigned f = 0; f < sizeof families / sizeof families[0]; f++) {
        int found[3];
        const int there = find_three(t, families[f], found);
        if (there == TWICE || (there && first)) {
            message("%s:%lu: x, y and z are there twice ('%s' and '%s'): leave one set of columns",
                    t->name, t->line, there == TWICE ? families[f][0] : first[0], families[f][0]);
            return EXIT_FILE;
        }
        for (unsigned i = 0; there && i < 3; i++) {
            first = families[f];
            index[i] = found[i];
        }
    }
    if (!first) {
        message("%s:%lu: the header names no columns x, y, z (nor ax, ay, az; mean_x, ..)", t->name,
                t->line);
    }
    return first ? EXIT_GOOD : EXIT_FILE;
}

static int find_by_header(const table *t, columns *out)
{
    static const char *const optional[COLUMN_COUNT][4] = {
        [COLUMN_STD_X] = {"std_x"},
        [COLUMN_STD_Y] = {"std_y"},
        [COLUMN_STD_Z] = {"std_z"},
        [COLUMN_SAMPLES] = {"n", "n_samples", "count"},
        [COLUMN_TIME] = {"t", "time", "timestamp"},
        [COLUMN_TEMPERATURE] = {"temperature", "temp"},
    };
    static const char *const one_std[] = {"std", NULL};
    int *index = out->index;
    int std;
    int failure = find_xyz(t, &index[COLUMN_X]);

    failure = failure ? failure : find_optional(t, one_std, &std);
    for (unsigned c = COLUMN_STD_X; c < COLUMN_COUNT && !failure; c++) {
        failure = find_optional(t, optional[c], &index[c]);
    }
    if (failure) {
        return failure;
    }
    if (index[COLUMN_STD_X] < 0 || index[COLUMN_STD_Y] < 0 || index[COLUMN_STD_Z] < 0) {
        /* only all three of them are of use */
        index[COLUMN_STD_X] = index[COLUMN_STD_Y] = index[COLUMN_STD_Z] = std;
    }
    return EXIT_GOOD;
}

/* Without a header the number of columns tells; each letter is one column. */
static int find_by_count(const table *t, columns_kind kind, columns *out)
{
    static const char *const layouts[2][5] = {{"xyz", "xyzsn", "xyzabcn"},
                                              {"xyz", "txyz", "txyzT", "xyz...", "txyz..."}};
    static const char letters[] = "xyzabcntT"; /* in the order of `column`; '.': a rate */

    for (unsigned i = 0; i < 5; i++) {
        const char *layout = layouts[kind][i];
        if (!layout || strlen(layout) != t->columns) {
            continue;
        }
        for (unsigned c = 0; c < COLUMN_COUNT; c++) {
            const char *place = strchr(layout, letters[c]);
            const int is_std = c >= COLUMN_STD_X && c <= COLUMN_STD_Z;
            place = place || !is_std ? place : strchr(layout, 's');
            out->index[c] = place ? (int)(place - layout) : -1;
        }
        return EXIT_GOOD;
    }
    message("%s:%lu: %u column%s, separated by %s, without a header: %s, or a header that names "
            "them, is expected",
            t->name, t->line, t->columns, t->columns == 1 ? "" : "s", table_separator(t),
            kind == COLUMNS_POSITIONS
                ? "3 (x y z), 5 (x y z std n), 7 (x y z std_x std_y std_z n)"
                : "3 (x y z), 4 (t x y z), 5 (t x y z temperature), 6 or 7 (with a gyro's three)");
    return EXIT_FILE;
}

int columns_find(const table *t, columns_kind kind, columns *out)
{
    return t->has_header ? find_by_header(t, out) : find_by_count(t, kind, out);
}

int columns_number(const table *t, const columns *where, column which, double *out)
{
    const int index = where->index[which];
    const number_status status = number_parse(t->field[index], out);
    char excerpt[TABLE_EXCERPT_MAX];

    if (status == NUMBER_EMPTY) {
        message("%s:%lu: column %d (%s) is empty", t->name, t->line, index + 1,
                columns_name(which));
        return EXIT_FILE;
    }
    if (status != NUMBER_OK) {
        message("%s:%lu: column %d (%s): '%s' %s", t->name, t->line, index + 1, columns_name(which),
                table_excerpt(t->field[index], excerpt), number_problem(status));
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

const char *columns_name(column which)
{
    static const char *const names[COLUMN_COUNT] = {"x",     "y", "z", "std_x",      "std_y",
                                                    "std_z", "n", "t", "temperature"};

    return names[which];
}
