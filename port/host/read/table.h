/* SPDX-License-Identifier: MIT
 *
 * read/table.h: reads a text table (CSV and the like), one row at a time.
 *
 * Columns are separated by semicolons, tabs, commas or blanks: by the first of these, in this
 * order, that occurs in the first line that is neither empty nor a comment. Blanks and double
 * quotes around fields are removed. If no field of the first line is meant as a number, it is a
 * header. Comments begin with #, %, or //, or with ; unless that is the separator. A UTF-8 byte
 * order mark, lines that end with CR LF, the first line `sep=;` of spreadsheets, lines of `name,
 * value` before a header, and a trailing separator on every line are accepted; lines of text before
 * the header, if the caller asks for it (table_skip_text). Memory does not grow with the file.
 */
#ifndef TABLE_H
#define TABLE_H

#include <stdint.h>
#include <stdio.h>

#define TABLE_LINE_MAX 65536u
#define TABLE_COLUMNS_MAX 256u
#define TABLE_COMMENT_MAX 4096u

typedef struct {
    FILE *file;
    const char *name;         /* of the file, for messages */
    unsigned long line;       /* of the current row, from 1 */
    unsigned long first_line; /* the line that determined separator and columns */
    uint64_t bytes;           /* read so far */
    uint32_t crc;             /* of these bytes, CRC-32 */
    unsigned columns;         /* of the first line, as of all valid ones */
    unsigned found;           /* columns of the latest line after it, valid or not */
    char separator;           /* ';' ',' '\t' ' '; '\0': not known yet */
    int states_separator;     /* by a line `sep=;` */
    int has_header;
    int has_pairs;                  /* two columns of words are a header, not a setting */
    unsigned long preamble;         /* number of lines of `name, value` before the header */
    unsigned long text_lines;       /* number of lines of text before it (table_skip_text) */
    int is_trailing;                /* every row has a trailing separator */
    int has_row;                    /* the first row below the header has been read */
    int has_end;                    /* the latest line ends with a line feed */
    int is_log;                     /* the caller reports a cut last line */
    int is_forgiving;               /* the caller continues after a malformed line */
    int pending;                    /* table_next returns the current row again */
    int pending_result;             /* with this result */
    char *field[TABLE_COLUMNS_MAX]; /* of the current row, at first the header */
    char text[TABLE_LINE_MAX + 1];
    /* internal */
    unsigned long comment_line; /* of the last comment above the first row; 0: none */
    char comment[TABLE_COMMENT_MAX];
    int has_next; /* the next row has been read, too: */
    char *next[TABLE_COLUMNS_MAX];
    unsigned next_found; /* number of its columns */
    unsigned long next_line;
    char held[TABLE_LINE_MAX + 1]; /* the current row then */
} table;

/* Opens a table ("-": standard input) and reads its first line, which sets has_header, columns and
 * field. The structure is large, and must not be moved.
 *
 * Returns EXIT_GOOD; EXIT_FILE if the file cannot be read, or its first line is malformed or
 * missing. Close it with table_close in either case. */
int table_open(table *t, const char *path);

/* The same for a table that may have two columns: two words are a header, not a setting. */
int table_open_pairs(table *t, const char *path);

/* Skips lines of text above the table, such as "MPU6050 found", which a board sends when it starts;
 * their number is text_lines. Text begins with a word and has fewer than three numbers. It is a
 * header if is_known says so, or if the line below has as many columns, or both have three or more,
 * not separated by blanks; or if the two have 64 KiB together. To be called first.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if a line cannot be read. */
int table_skip_text(table *t, int (*is_known)(const table *t));

/* Goes to the next row, after a header to the first.
 *
 * Returns 1; 0 at the end of the file; -1, with a message, if the line is longer than
 * TABLE_LINE_MAX bytes, is not text, or has another number of columns than the first; reading may
 * continue with the next row. A caught signal ends the file. */
int table_next(table *t);

/* The last comment above the first row may be the header, as in files of EuRoC and numpy.savetxt.
 * If it has the same number of columns, all of them words, it becomes the header, with its fields
 * in field. Returns 1; else 0. To be called before table_next. */
int table_comment_header(table *t);

/* Undoes that: the comment is not a header, and field has the first row again. */
void table_drop_header(table *t);

/* If a recording began within a line, the beginning of the first one is missing: it has fewer
 * columns than the second, or its first field is the end of a number. In a log without a header,
 * such a line is dropped, and *cut is its number; else 0. To be called before table_next.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the second line cannot be read. */
int table_drop_cut_first(table *t, unsigned long *cut);

/* If a recording ended within a line, the end of the last one is missing: it begins with a number
 * and has fewer columns than the others, or it has no end of line and only the beginning of a
 * number in `column`, the last one that is used. Returns 1 if that is so for the current row. */
int table_is_cut(const table *t, unsigned column);

/* Looks at the row below the header: table_next will return the same row, unless pending is set to
 * 0. Returns 1 if there is such a row. */
int table_peek(table *t);

void table_close(table *t);

/* What separates the columns: "commas", ... */
const char *table_separator(const table *t);

/* What to do about a malformed line, to follow what is wrong with it. */
const char *table_remedy(const table *t);

/* The beginning of a field, for messages. Returns text. */
#define TABLE_EXCERPT_MAX 40
const char *table_excerpt(const char *field, char text[TABLE_EXCERPT_MAX]);

#endif
