/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "read/table.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>
#include <strings.h>

#include "cli/command.h"
#include "read/crc.h"
#include "cli/input.h"
#include "cli/message.h"
#include "text/number.h"
#include "read/signature.h"

#define PREAMBLE_MAX 10000u

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

/* Recognises other kinds of files by their first bytes. */
static int check_signature(const table *t, size_t length)
{
    const char *what = t->line == 1 ? signature_find(t->text, length) : NULL;

    if (what) {
        message("%s: this is %s", t->name, what);
    }
    return what ? -1 : 1;
}

/* A line with control characters is most likely not of a text file. */
static int check_text(const table *t, size_t length)
{
    if (check_signature(t, length) != 1) {
        return -1;
    }
    for (size_t i = 0; i < length; i++) {
        const unsigned char c = (unsigned char)t->text[i];
        if (c == '\r') {
            message("%s:%lu: byte %lu of the line is a carriage return (CR), which alone does not "
                    "end a line: tr '\\r' '\\n' < log.csv > lines.csv",
                    t->name, t->line, (unsigned long)i + 1);
            return -1;
        }
        if (c < ' ' && c != '\t') {
            message("%s:%lu: byte %lu of the line has the value %u: not a text file; export the "
                    "readings as CSV",
                    t->name, t->line, (unsigned long)i + 1, (unsigned)c);
            return -1;
        }
    }
    return 1;
}

/* For reports, which identify the file by its size and CRC. */
static void count_bytes(table *t, size_t length, int has_end)
{
    t->crc = crc_update(t->crc, t->text, length);
    t->crc = crc_update(t->crc, "\n", (size_t)has_end);
    t->bytes += length + (size_t)has_end;
}

/* Reads a line without its end into t->text. 1, 0 at the end of the file, -1. */
static int read_line(table *t)
{
    size_t length = 0;
    int c = getc_unlocked(t->file);

    if (c == EOF && !ferror(t->file)) {
        return 0;
    }
    t->line++;
    for (; c != EOF && c != '\n'; c = getc_unlocked(t->file)) {
        if (length == TABLE_LINE_MAX && check_text(t, length) != 1) {
            return -1;
        }
        if (length == TABLE_LINE_MAX) {
            message("%s:%lu: the line is longer than %u bytes: a table has one sample per line",
                    t->name, t->line, TABLE_LINE_MAX);
            return -1;
        }
        t->text[length++] = (char)c;
    }
    if (ferror(t->file) && errno == EINTR) {
        return 0; /* a caught signal ends the file */
    }
    if (ferror(t->file)) {
        message("%s:%lu: cannot be read: %s", t->name, t->line, strerror(errno));
        return -1;
    }
    t->has_end = c == '\n';
    count_bytes(t, length, t->has_end);
    length -= length > 0 && t->text[length - 1] == '\r';
    t->text[length] = '\0';
    return check_text(t, length);
}

/* Removes a UTF-8 byte order mark from the first line. */
static void strip_bom(table *t)
{
    if (t->line == 1 && strncmp(t->text, "\xef\xbb\xbf", 3) == 0) {
        memmove(t->text, t->text + 3, strlen(t->text + 3) + 1);
    }
}

/* The first line `sep=;` of a spreadsheet, which is not a row. */
static int read_separator_line(table *t)
{
    const char *text = t->text + (*t->text == '"');

    if (t->line != 1 || strncasecmp(text, "sep=", 4) != 0 || text[4] == '\0' ||
        !strchr(";,\t", text[4])) {
        return 0;
    }
    t->separator = text[4];
    t->states_separator = 1;
    return 1;
}

/* `%time` is a heading of ROS. If a second ; follows, the ; is a separator. */
static int is_comment(const table *t, const char *start)
{
    switch (*start) {
    case '#':
        return 1;
    case '%':
        return strncmp(start, "%time", 5) != 0;
    case '/':
        return start[1] == '/';
    case ';':
        return t->separator == '\0' ? !strchr(start + 1, ';') : t->separator != ';';
    default:
        return 0;
    }
}

/* Saves the last comment above the table, without its marker. */
static void save_comment(table *t, const char *start)
{
    start += strspn(
        start, (const char[]){*start, '\0'}); /* only this one: "#;t;x" has a column called # */
    start += strspn(start, " \t");
    if (t->first_line == 0 && strlen(start) < sizeof t->comment) {
        memcpy(t->comment, start, strlen(start) + 1);
        t->comment_line = t->line;
    }
}

/* Reads the next line that is neither empty nor a comment. */
static int read_row(table *t)
{
    for (;;) {
        const int more = read_line(t);
        if (more != 1) {
            return more;
        }
        strip_bom(t);
        const char *start = skip_blanks(t->text);
        if (*start != '\0' && is_comment(t, start)) {
            save_comment(t, start);
        } else if (*start != '\0' && !read_separator_line(t)) {
            return 1;
        }
    }
}

/* Every comma of the line is between digits, and there are blanks: "1,5 2,5 3,5". */
static int has_decimal_commas(const char *start, const char *end)
{
    int blanks = 0;

    for (const char *c = start; c < end; c++) {
        if (*c == ',' &&
            !(c > start && isdigit((unsigned char)c[-1]) && isdigit((unsigned char)c[1]))) {
            return 0;
        }
        blanks += is_blank(*c);
    }
    return blanks > 0;
}

/* Semicolons and tabs take precedence over commas, which are then decimal ones; but a tab after a
 * comma is a blank. */
static char find_separator(const char *line)
{
    const char *order = ";\t,";
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
        const char *here = quoted || (*c == '\t' && c[-1] == ',') ? NULL : strchr(order, *c);
        if (here && here < rank) {
            rank = here;
            found = *c;
        }
    }
    return found == ',' && has_decimal_commas(start, end) ? ' ' : found;
}

static int is_separator(const table *t, char c)
{
    return t->separator == ' ' ? is_blank(c) : c == t->separator;
}

/* Ends a text at `end`, without trailing blanks. */
static void strip_end(const char *start, char *end)
{
    while (end > start && is_blank(end[-1])) {
        end--;
    }
    *end = '\0';
}

/* Finds the end of a quoted field, and removes the quotes. Returns the separator after it or the
 * end of the line; null if anything else follows. */
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

/* Splits a line into fields. Their number; 0 if it is malformed, and then *at is the column whose
 * quotes do not match, or TABLE_COLUMNS_MAX + 1. */
static unsigned cut_fields(table *t, char *c, unsigned *at)
{
    unsigned count = 0;
    int last = 0;

    while (!last) {
        while (is_blank(*c) && !(t->separator == '\t' && *c == '\t')) {
            c++;
        }
        if (*c == '\0' && t->separator == ' ') {
            return count; /* trailing blanks are not a separator */
        }
        if (count == TABLE_COLUMNS_MAX) {
            *at = count + 1;
            return 0;
        }
        char *end = *c == '"' ? end_quoted(t, &c) : end_plain(t, c);
        t->field[count++] = c;
        if (!end) {
            *at = count;
            return 0;
        }
        last = *end == '\0';
        strip_end(c, end);
        c = end + 1;
    }
    return count;
}

/* Splits the current line. Its number of fields; 0, with a message, if it is malformed. */
static unsigned split(table *t)
{
    unsigned at = 0;
    const unsigned count = cut_fields(t, t->text, &at);

    if (count == 0 && at > TABLE_COLUMNS_MAX) {
        message("%s:%lu: more than %u columns: keep those of the accelerometer", t->name, t->line,
                TABLE_COLUMNS_MAX);
    } else if (count == 0) {
        message("%s:%lu: column %u: the quotes do not match%s", t->name, t->line, at,
                table_remedy(t));
    }
    return count;
}

/* A line of words without any number. */
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

/* Splits the current line as the first of the table. 1, -1. */
static int split_first(table *t)
{
    t->first_line = t->line;
    t->separator = t->separator ? t->separator : find_separator(t->text);
    t->columns = split(t);
    t->has_header = is_header(t);
    return t->columns > 0 ? 1 : -1;
}

/* Reads and splits the first line, or a line of the preamble. 1, 0 at the end of the file, -1. */
static int read_first(table *t)
{
    const int more = read_row(t);

    if (more == 1 && t->preamble > 0 && !t->states_separator && !strchr(t->text, t->separator)) {
        t->separator = '\0'; /* that of the settings is not that of the table */
    }
    return more == 1 ? split_first(t) : more;
}

/* A setting: a word followed by one or more values. */
static int is_preamble(const table *t)
{
    if (t->has_pairs && t->has_header) {
        return 0;
    }
    return t->separator != ' ' && *t->field[0] != '\0' && !number_is_meant(t->field[0]) &&
           (t->columns == 2 || (t->preamble > 0 && !t->has_header));
}

/* Skips settings before the header, with a name and a value in each line. */
static int skip_preamble(table *t)
{
    int more;

    while ((more = read_first(t)) == 1 && is_preamble(t) && t->preamble < PREAMBLE_MAX) {
        t->preamble++;
    }
    if (more == 0 && t->preamble > 0) {
        message("%s:%lu: lines of two columns, the first one a name, are not a table of x, y, z: "
                "save one sample per line",
                t->name, t->first_line);
    } else if (more == 0) {
        message("%s: is empty: was it copied whole?", t->name);
    }
    return more == 1 ? EXIT_GOOD : EXIT_FILE;
}

/* An empty last column, due to a trailing separator. */
static int ends_empty(const table *t, unsigned columns)
{
    return t->separator != ' ' && columns > 1 && *t->field[columns - 1] == '\0';
}

/* To be called when the first line, the header or the first row, is known. */
static void begin_rows(table *t)
{
    t->is_trailing = !t->has_header && ends_empty(t, t->columns);
    t->columns -= (unsigned)t->is_trailing;
    t->found = t->columns;
    t->has_row = !t->has_header;
    t->pending = !t->has_header;
    t->pending_result = 1;
}

static int open_table(table *t, const char *path, int has_pairs)
{
    t->has_pairs = has_pairs;
    t->name = input_name(path);
    t->line = t->first_line = 0;
    t->comment_line = 0;
    t->has_next = 0;
    t->is_log = t->is_forgiving = 0;
    t->bytes = t->crc = 0;
    t->separator = '\0';
    t->states_separator = 0;
    t->preamble = t->text_lines = 0;
    t->file = input_open(path);
    if (!t->file || skip_preamble(t)) {
        return EXIT_FILE;
    }
    begin_rows(t);
    return EXIT_GOOD;
}

int table_open(table *t, const char *path)
{
    return open_table(t, path, 0);
}

int table_open_pairs(table *t, const char *path)
{
    return open_table(t, path, 1);
}

/* If commas separate, and no number has a point, some of the commas may be decimal ones. */
static int may_be_decimal_commas(const table *t)
{
    for (unsigned i = 0; i < t->found; i++) {
        if (!number_is_meant(t->field[i]) || strpbrk(t->field[i], ".eE")) {
            return 0;
        }
    }
    return t->separator == ',' && t->found > t->columns && t->found <= 2 * t->columns;
}

/* Whether nothing follows. Not for a live stream, on which it would block. */
static int is_at_end(const table *t)
{
    const int c = getc_unlocked(t->file);

    return c == EOF || ungetc(c, t->file) == EOF;
}

/* Whether a field is not a number, but would be one between these texts. */
static int is_part(const char *before, const char *field, const char *after)
{
    char text[TABLE_EXCERPT_MAX];
    double number;

    return strlen(field) + 3 < sizeof text && number_parse(field, &number) != NUMBER_OK &&
           snprintf(text, sizeof text, "%s%s%s", before, field, after) > 0 &&
           number_parse(text, &number) == NUMBER_OK;
}

int table_is_cut(const table *t, unsigned column)
{
    const int is_short = t->found > 0 && t->found < t->columns && is_at_end(t);

    return (is_short && (number_is_meant(t->field[0]) || is_part("", t->field[0], "0"))) ||
           (!t->has_end && t->found == t->columns && column + 1 == t->columns &&
            is_part("", t->field[column], "0"));
}

/* Checks the number of columns of a row. 1; -1, with a message, if it differs from that of the
 * first line. */
static int check_columns(table *t, unsigned columns)
{
    if (columns == 0) {
        t->found = 0;
        return -1;
    }
    const int is_first = !t->has_row;
    if (is_first) { /* the header above it may lack the trailing separator */
        t->is_trailing = columns == t->columns + 1 && ends_empty(t, columns);
        t->has_row = 1;
    }
    columns -= t->is_trailing && columns == t->columns + 1 && ends_empty(t, columns);
    t->found = columns;
    if (columns != t->columns && (is_first || !t->is_log || !table_is_cut(t, 0))) {
        message("%s:%lu: %u column%s, but line %lu has %u, separated by %s%s", t->name, t->line,
                columns, columns == 1 ? "" : "s", t->first_line, t->columns, table_separator(t),
                may_be_decimal_commas(t)
                    ? ": if these are decimal commas, save the table with decimal points"
                    : table_remedy(t));
    }
    return columns == t->columns ? 1 : -1;
}

/* Makes the row that was read ahead the current one. */
static void take_next(table *t)
{
    memcpy((void *)t->field, (const void *)t->next, sizeof t->next);
    t->line = t->next_line;
    t->has_next = 0;
}

int table_next(table *t)
{
    if (t->pending) {
        t->pending = 0;
        return t->pending_result;
    }
    if (t->has_next) {
        take_next(t);
        return check_columns(t, t->next_found);
    }
    const int more = read_row(t);
    t->found = more < 0 ? 0 : t->found;
    return more == 1 ? check_columns(t, split(t)) : more;
}

/* ---- irregular first lines ---------------------------------------------------------------------- */

int table_comment_header(table *t)
{
    const char separator = t->separator;
    unsigned at;

    if (t->has_header || !t->pending || t->comment_line == 0 || t->has_next) {
        return 0;
    }
    memcpy((void *)t->next, (const void *)t->field, sizeof t->next);
    t->next_line = t->line;
    t->next_found = t->columns;
    t->has_next = 1;
    t->pending = 0;
    t->separator = find_separator(t->comment);
    unsigned columns = cut_fields(t, t->comment, &at);
    columns -= columns > 0 && ends_empty(t, columns);
    t->separator = separator;
    t->line = t->first_line = t->comment_line;
    t->has_header = columns == t->columns && is_header(t);
    if (!t->has_header) {
        table_drop_header(t);
    }
    return t->has_header;
}

void table_drop_header(table *t)
{
    take_next(t);
    t->has_header = t->has_next = 0;
    t->first_line = t->line;
    t->comment_line = 0;
    t->pending = 1;
}

/* Saves the current row, so that the next line can be read. */
static void save_row(table *t, char *row[TABLE_COLUMNS_MAX])
{
    memcpy(t->held, t->text, sizeof t->held);
    for (unsigned i = 0; i < t->columns; i++) {
        row[i] = t->held + (t->field[i] - t->text);
    }
}

/* Makes the row that was read ahead the next one, and the saved one current again. */
static void put_back(table *t, char *const row[TABLE_COLUMNS_MAX], unsigned long line,
                     unsigned found)
{
    memcpy((void *)t->next, (const void *)t->field, sizeof t->next);
    memcpy((void *)t->field, (const void *)row, t->columns * sizeof *row);
    t->next_found = found;
    t->next_line = t->line;
    t->line = line;
}

/* Whether a first row is the end of a row like the current one. */
static int is_end_of_row(const table *t, char *const row[TABLE_COLUMNS_MAX], unsigned columns)
{
    return columns > t->columns || (columns == t->columns && row[0] && is_part("1", row[0], ""));
}

int table_drop_cut_first(table *t, unsigned long *cut)
{
    const unsigned long line = t->line;
    char *row[TABLE_COLUMNS_MAX] = {NULL};

    *cut = 0;
    if (t->has_header || !t->pending || t->has_next ||
        t->comment_line > 0) { /* text or a comment first: nothing is cut */
        return EXIT_GOOD;
    }
    save_row(t, row);
    const int more = read_row(t);
    if (more == 1 && t->columns == 1) { /* the first line may lack the separator */
        t->separator = find_separator(t->text);
    }
    const unsigned found = more == 1 ? split(t) : 0;
    const int is_trailing = found > 0 && ends_empty(t, found);
    if (more != 0 && found == 0) {
        return EXIT_FILE;
    }
    if (found > 0 && is_end_of_row(t, row, found - (unsigned)is_trailing)) {
        t->columns = t->found = found - (unsigned)is_trailing;
        t->is_trailing = is_trailing;
        t->first_line = t->line;
        *cut = line;
        return EXIT_GOOD;
    }
    put_back(t, row, line, found);
    t->has_next = more != 0;
    return EXIT_GOOD;
}

/* A line of words, possibly with numbers among them: "MPU6050 found at 0x68". */
static int is_text(const table *t, unsigned columns)
{
    unsigned numbers = 0;
    double number;

    for (unsigned i = 0; i < columns; i++) {
        numbers += number_parse(t->field[i], &number) == NUMBER_OK;
    }
    return columns > 0 && numbers < 3 && !number_is_meant(t->field[0]);
}

/* Whether the saved line is the header of the current one, which has `found` columns: they have as
 * many columns; or both have three or more, not separated by blanks, and the current one is a row. */
static int is_header_of(const table *t, char *const row[TABLE_COLUMNS_MAX], unsigned found)
{
    const int has_separator = t->separator != ' ';
    const unsigned named = t->columns - (has_separator && *row[t->columns - 1] == '\0');
    const int is_row = !is_text(t, found);

    found -= found > 0 && ends_empty(t, found);
    return found >= 3 && ((has_separator && is_row && named >= 3) ||
                          ((has_separator || is_row) && found == named));
}

/* A copy of the current line before it is split, behind the saved one; null if that leaves no room. */
static const char *copy_line(table *t, char *const row[TABLE_COLUMNS_MAX])
{
    const char *last = row[t->columns - 1];
    const size_t used = (size_t)(last - t->held) + strlen(last) + 1;
    const size_t size = strlen(t->text) + 1;

    return size <= sizeof t->held - used ? memcpy(t->held + used, t->text, size) : NULL;
}

/* Reads the line below the current one, which is text. 1: that is the first line now; 0: the current
 * one is; -1. */
static int try_next(table *t)
{
    const unsigned long line = t->line;
    char *row[TABLE_COLUMNS_MAX] = {NULL};
    unsigned at = 0;

    save_row(t, row);
    t->first_line = 0; /* so that a comment below it is saved */
    const int more = read_row(t);
    if (more != 1) {
        memcpy(t->text, t->held, sizeof t->text); /* a comment may have been read */
        t->line = t->first_line = line;
        return more;
    }
    const char *copy = copy_line(t, row);
    const unsigned found = cut_fields(t, t->text, &at);
    if (!copy || is_header_of(t, row, found)) {
        put_back(t, row, line, found);
        t->first_line = line;
        t->has_next = 1;
        return 0;
    }
    memcpy(t->text, copy, strlen(copy) + 1);
    t->separator = t->states_separator ? t->separator : '\0';
    return split_first(t);
}

int table_skip_text(table *t, int (*is_known)(const table *t))
{
    int more = 1;

    while (more == 1 && t->text_lines < PREAMBLE_MAX && is_text(t, t->columns) &&
           !(t->has_header && is_known(t))) {
        more = try_next(t);
        t->text_lines += more == 1;
        if (more == 1) {
            begin_rows(t);
        }
    }
    return more < 0 ? EXIT_FILE : EXIT_GOOD;
}

int table_peek(table *t)
{
    t->pending_result = table_next(t);
    t->pending = 1;
    return t->pending_result == 1;
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

const char *table_remedy(const table *t)
{
    return t->is_forgiving ? ": skipped" : ": correct the line, or delete it";
}

const char *table_excerpt(const char *field, char text[TABLE_EXCERPT_MAX])
{
    const int is_long = strlen(field) >= TABLE_EXCERPT_MAX;

    snprintf(text, TABLE_EXCERPT_MAX, "%.*s%s", is_long ? TABLE_EXCERPT_MAX - 4 : 1000, field,
             is_long ? "..." : "");
    return text;
}
