/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "table.h"

#include <errno.h>
#include <string.h>

#include "command.h"
#include "crc.h"
#include "input.h"
#include "message.h"
#include "number.h"

static int is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static const char *skip_blanks(const char *s)
{
    while (is_blank(*s)) {
        s++;
    }
    return s;
}

/* Control characters have no place in a text: most likely it is none. */
static int check_text(const table *t, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        const unsigned char c = (unsigned char)t->text[i];
        if (c < ' ' && c != '\t') {
            message("%s:%lu: byte %lu of the line has the value %u: this is not a text file",
                    t->name, t->line, (unsigned long)i + 1, (unsigned)c);
            return -1;
        }
    }
    return 1;
}

/* So that a report can say which file it was. */
static void count_bytes(table *t, size_t length, size_t has_end)
{
    t->crc = crc_update(t->crc, t->text, length);
    t->crc = crc_update(t->crc, "\n", has_end);
    t->bytes += length + has_end;
}

/* Reads a line into text, without its end. 1, 0 at the end of the file, -1. */
static int read_line(table *t)
{
    size_t length = 0;
    int c = getc_unlocked(t->file);

    if (c == EOF && !ferror(t->file)) {
        return 0;
    }
    t->line++;
    for (; c != EOF && c != '\n'; c = getc_unlocked(t->file)) {
        if (length == TABLE_LINE_MAX) {
            message("%s:%lu: the line is longer than %u bytes", t->name, t->line, TABLE_LINE_MAX);
            return -1;
        }
        t->text[length++] = (char)c;
    }
    if (ferror(t->file) && errno == EINTR) {
        return 0; /* whoever catches a signal wants to come to an end */
    }
    if (ferror(t->file)) {
        message("%s:%lu: cannot be read: %s", t->name, t->line, strerror(errno));
        return -1;
    }
    count_bytes(t, length, c == '\n');
    length -= length > 0 && t->text[length - 1] == '\r';
    t->text[length] = '\0';
    return check_text(t, length);
}

/* Takes a UTF-8 mark of byte order off the first line. */
static void strip_mark(table *t)
{
    if (t->line == 1 && strncmp(t->text, "\xef\xbb\xbf", 3) == 0) {
        memmove(t->text, t->text + 3, strlen(t->text + 3) + 1);
    }
}

/* Reads up to the next line that holds something. */
static int read_row(table *t)
{
    for (;;) {
        const int more = read_line(t);
        if (more != 1) {
            return more;
        }
        strip_mark(t);
        const char *start = skip_blanks(t->text);
        if (*start != '\0' && *start != '#') {
            return 1;
        }
    }
}

/* Semicolons before commas: where both stand, the commas are decimal ones. */
static char find_separator(const char *line)
{
    const char *order = ";,\t";
    char found = ' ';
    const char *rank = order + strlen(order);
    const char *start = skip_blanks(line);
    const char *end = start + strlen(start);
    int quoted = 0;

    while (end > start && is_blank(end[-1])) {
        end--;
    }
    for (const char *c = start; c < end; c++) {
        quoted ^= *c == '"';
        const char *here = quoted ? NULL : strchr(order, *c);
        if (here && here < rank) {
            rank = here;
            found = *c;
        }
    }
    return found;
}

static int is_separator(const table *t, char c)
{
    return t->separator == ' ' ? is_blank(c) : c == t->separator;
}

/* Ends a text at `end` or before, so that no blank is its last. */
static void strip_end(char *start, char *end)
{
    while (end > start && is_blank(end[-1])) {
        end--;
    }
    *end = '\0';
}

/* Finds the end of a field that begins with a quote, and takes the quotes off. Returns the place
 * of the separator behind it, or of the end of the line; null if there is something else. */
static char *end_quoted(const table *t, char **start)
{
    char *end = strchr(*start + 1, '"');

    if (!end) {
        return NULL;
    }
    *start += 1 + strspn(*start + 1, " \t");
    strip_end(*start, end);
    end++;
    while (is_blank(*end) && !is_separator(t, *end)) {
        end++;
    }
    return *end == '\0' || is_separator(t, *end) ? end : NULL;
}

static char *end_plain(const table *t, char *start)
{
    while (*start != '\0' && !is_separator(t, *start)) {
        start++;
    }
    return start;
}

/* Cuts the line into fields. Their number; 0, with a message, if it is malformed. */
static unsigned split(table *t)
{
    char *c = t->text;
    unsigned count = 0;
    int last = 0;

    while (!last) {
        while (is_blank(*c) && !(t->separator == '\t' && *c == '\t')) {
            c++;
        }
        if (*c == '\0' && t->separator == ' ') {
            return count; /* blanks at the end of a line separate nothing */
        }
        if (count == TABLE_COLUMNS_MAX) {
            message("%s:%lu: more than %u columns", t->name, t->line, TABLE_COLUMNS_MAX);
            return 0;
        }
        char *end = *c == '"' ? end_quoted(t, &c) : end_plain(t, c);
        t->field[count++] = c;
        if (!end) {
            message("%s:%lu: column %u: the quotes do not match", t->name, t->line, count);
            return 0;
        }
        last = *end == '\0';
        strip_end(c, end);
        c = end + 1;
    }
    return count;
}

/* Some words and no number. */
static int is_header(const table *t)
{
    int words = 0;

    for (unsigned i = 0; i < t->columns; i++) {
        if (number_is_meant(t->field[i])) {
            return 0;
        }
        words += *t->field[i] != '\0';
    }
    return words > 0;
}

int table_open(table *t, const char *path)
{
    t->name = input_name(path);
    t->line = 0;
    t->bytes = t->crc = 0;
    t->file = input_open(path);
    if (!t->file) {
        return EXIT_FILE;
    }
    const int more = read_row(t);
    if (more == 0) {
        message("%s: is empty", t->name);
    }
    if (more != 1) {
        return EXIT_FILE;
    }
    t->first_line = t->line;
    t->separator = find_separator(t->text);
    t->columns = split(t);
    t->has_header = is_header(t);
    t->pending = !t->has_header;
    return t->columns > 0 ? EXIT_GOOD : EXIT_FILE;
}

int table_next(table *t)
{
    if (t->pending) {
        t->found = t->columns;
        t->pending = 0;
        return 1;
    }
    const int more = read_row(t);
    if (more != 1) {
        return more;
    }
    const unsigned columns = t->found = split(t);
    if (columns != t->columns && columns > 0) {
        message("%s:%lu: %u column%s, but line %lu has %u, separated by %s", t->name, t->line,
                columns, columns == 1 ? "" : "s", t->first_line, t->columns, table_separator(t));
    }
    return columns == t->columns ? 1 : -1;
}

void table_close(table *t)
{
    input_close(t->file);
    t->file = NULL;
}

const char *table_separator(const table *t)
{
    switch (t->separator) {
    case ';':
        return "semicolons";
    case ',':
        return "commas";
    case '\t':
        return "tabs";
    default:
        return "blanks";
    }
}

const char *table_excerpt(const char *field, char text[TABLE_EXCERPT_MAX])
{
    const int is_long = strlen(field) >= TABLE_EXCERPT_MAX;

    snprintf(text, TABLE_EXCERPT_MAX, "%.*s%s", is_long ? TABLE_EXCERPT_MAX - 4 : 1000, field,
             is_long ? "..." : "");
    return text;
}
