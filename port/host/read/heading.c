/* SPDX-License-Identifier: MIT */
#include "read/heading.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* In the C locale, independently of the user's. */
static char to_lower(char c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

static int axis_of(char c)
{
    const char lower = to_lower(c);

    return lower >= 'x' && lower <= 'z'   ? lower - 'x'
           : lower >= '0' && lower <= '2' ? lower - '0'
                                          : -1;
}

static void strip_end(char *text)
{
    size_t length = strlen(text);

    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '_')) {
        text[--length] = '\0';
    }
}

/* Parses a unit. Returns 1; 0 if it is none that a heading can have as a suffix. */
static int parse_unit(const char *unit, heading *out)
{
    out->per_second = unit_parse_time(unit);
    out->rate_unit = unit_parse_angular_rate(unit);
    const int is_magnetic = unit_parse_magnetic(unit, &out->magnetic);
    return unit_parse(unit, &out->unit) || is_magnetic || out->per_second > 0 || out->rate_unit > 0;
}

/* The brackets at the end of a text: where they open; null if there are none. */
static char *find_brackets(char *text)
{
    char *c = text + strlen(text);
    int depth = 0;

    while (c > text) {
        c--;
        depth += *c == ')' || *c == ']';
        depth -= *c == '(' || *c == '[';
        if (depth <= 0) {
            break;
        }
    }
    return c > text && depth == 0 && (*c == '(' || *c == '[') ? c : NULL;
}

/* Takes off the unit of `name (unit)` or `name [unit]`; brackets around an axis stay. */
static void cut_bracketed_unit(heading *out)
{
    char unit[HEADING_NAME_MAX];
    char *open = find_brackets(out->name);

    if (!open || (strlen(open) == 3 && axis_of(open[1]) >= 0)) {
        return;
    }
    snprintf(unit, sizeof unit, "%.*s", (int)strlen(open) - 2, open + 1);
    (void)parse_unit(unit, out);
    out->degrees = unit_parse_temperature(unit);
    out->states_unit = 1;
    *open = '\0';
    strip_end(out->name);
}

/* Takes off the unit of `name_unit`: the longest suffix after a _ that is a unit. */
static void cut_suffixed_unit(char *name, heading *out)
{
    for (char *c = strchr(name, '_'); c && !out->states_unit; c = strchr(c + 1, '_')) {
        if (c > name && parse_unit(c + 1, out)) {
            out->states_unit = 1;
            *c = '\0';
            return;
        }
    }
}

/* Lower-case letters and digits only. */
static void make_key(const char *name, char key[HEADING_NAME_MAX])
{
    unsigned length = 0;

    for (; *name != '\0'; name++) {
        const char c = to_lower(*name);
        if ((c >= 'a' && c <= 'z') || isdigit((unsigned char)c)) {
            key[length++] = c;
        }
    }
    key[length] = '\0';
}

/* Takes off the axis at the end or the beginning of the key: accx, xacc. */
static void cut_axis(heading *out)
{
    char *key = out->key;
    const size_t length = strlen(key);

    if (length == 0) {
        return;
    }
    if (!isdigit((unsigned char)key[length - 1]) && axis_of(key[length - 1]) >= 0) {
        out->axis = axis_of(key[length - 1]);
        key[length - 1] = '\0';
    } else if (!isdigit((unsigned char)key[0]) && axis_of(key[0]) >= 0) {
        out->axis = axis_of(key[0]);
        memmove(key, key + 1, length);
    }
}

/* Takes off the unit of `TimeUS`, where nothing separates it. */
static void cut_time_unit(heading *out)
{
    static const char *const names[] = {"timestamp", "time"};

    for (unsigned i = 0; i < 2 && !out->states_unit; i++) {
        const size_t length = strlen(names[i]);
        const double per_second =
            strncmp(out->key, names[i], length) == 0 ? unit_parse_time(out->key + length) : 0;
        if (per_second > 0) {
            out->per_second = per_second;
            out->states_unit = 1;
            out->key[length] = '\0';
        }
    }
}

/* Copies a name, truncated between characters of UTF-8, with '?' for control characters. */
static void copy_name(const char *text, char name[HEADING_NAME_MAX])
{
    size_t length = strlen(text);

    if (length >= HEADING_NAME_MAX) {
        length = HEADING_NAME_MAX - 1;
        while (length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80) {
            length--;
        }
    }
    memcpy(name, text, length);
    name[length] = '\0';
    for (char *c = name; *c != '\0'; c++) {
        if ((unsigned char)*c < ' ' || *c == 0x7f) {
            *c = '?';
        }
    }
}

void heading_read(const char *text, heading *out)
{
    char stem[HEADING_NAME_MAX];

    *out = (heading){.axis = -1};
    copy_name(text, out->name);
    cut_bracketed_unit(out);
    memcpy(stem, out->name, sizeof stem);
    char *index = find_brackets(stem);
    if (index && strlen(index) == 3) {
        out->axis = axis_of(index[1]);
        *index = '\0';
    }
    cut_suffixed_unit(stem, out);
    make_key(stem, out->key);
    if (out->axis < 0) {
        cut_axis(out);
    }
    cut_time_unit(out);
}
