/* SPDX-License-Identifier: MIT
 *
 * read/table.h: a text table (CSV and its relatives), one row at a time.
 *
 * Columns are separated by semicolons, tabs, commas or blanks; the first line that is neither
 * empty nor a comment decides, in this order. Fields lose the blanks and double quotes around
 * them. If nothing in the first line is meant as a number, it is a header. Comments begin with #,
 * %, or //, or with ; where that does not separate. A mark of byte order (UTF-8), lines ended by
 * CR LF, the first line `sep=;` of spreadsheets, lines of `name, value` before a header, and one
 * separator too many at the end of every line are fine. Memory does not grow with the file.
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
    unsigned long line;       /* the one that the current row stands in, from 1 */
    unsigned long first_line; /* the one that decided */
    uint64_t bytes;           /* read so far, */
    uint32_t crc;             /* and their CRC-32 */
    unsigned columns;         /* of the first line, and so of all */
    unsigned found;           /* of the latest line after the first, right or wrong */
    char separator;           /* ';' ',' '\t' ' '; '\0': not known yet */
    int has_header;
    int has_pairs;                  /* two columns of words are a header, and no setting */
    unsigned long preamble;         /* lines of `name, value` before the header */
    int is_trailing;                /* every row ends with a separator that separates nothing */
    int has_row;                    /* 1 when the first row below the header has been read */
    int has_end;                    /* the latest line is ended, as all should be */
    int is_log;                     /* the reader reports a last line that is cut */
    int is_forgiving;               /* who reads goes on behind a malformed line */
    int pending;                    /* a row has been read, but not handed out, */
    int pending_result;             /* with this result of table_next */
    char *field[TABLE_COLUMNS_MAX]; /* of the current row (first: of the header), until the next */
    char text[TABLE_LINE_MAX + 1];
    /* inside */
    unsigned long comment_line; /* the last one above the first row; 0: none */
    char comment[TABLE_COMMENT_MAX];
    int has_next; /* the row behind the current one has been read, */
    char *next[TABLE_COLUMNS_MAX];
    unsigned next_found;           /* with so many columns, */
    unsigned long next_line;       /* from here */
    char held[TABLE_LINE_MAX + 1]; /* the current row meanwhile */
} table;

/* Opens a table ("-": standard input) and reads its first line: has_header, columns and field
 * are then set. The structure is large, and must not be moved.
 *
 * Returns EXIT_GOOD; EXIT_FILE if the file cannot be read, or its first line is malformed or
 * missing. To be closed with table_close in either case. */
int table_open(table *t, const char *path);

/* The same for a table that may have two columns: two words are its header, and no setting. */
int table_open_pairs(table *t, const char *path);

/* Goes to the next row, after a header to the first.
 *
 * Returns 1; 0 at the end of the file; -1, with a message, if the line is longer than
 * TABLE_LINE_MAX bytes, is no text, or has another number of columns than the first; the next
 * row may be asked for all the same. A signal that is caught ends the file. */
int table_next(table *t);

/* A comment just above the first row may be its header, as EuRoC and numpy.savetxt write it. If it has
 * as many columns, words all of them, the table has this header from now on, and field is that; returns
 * 1. Else 0. To be called before the first row is asked for. */
int table_comment_header(table *t);

/* That was none, but a comment indeed: field is the first row again. */
void table_drop_header(table *t);

/* The first line of a log without a header may have been cut at its front, when the recording began: it
 * has fewer columns than the second, or a first field that is the end of a number. If so it is left
 * out, and *cut is its number; else 0. To be called before the first row is asked for.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the second line cannot be read. */
int table_drop_cut_first(table *t, unsigned long *cut);

/* The current row has been cut at its end, when the recording ended: it is the last line, and has fewer
 * columns than the others, the first a number; or without an end of line only the beginning of a number
 * in `column`, the last that counts. */
int table_is_cut(const table *t, unsigned column);

/* Reads the row below the header, for a look at its fields: table_next goes to the same row again,
 * unless pending is set to 0. Returns 1 if there is such a row. */
int table_peek(table *t);

void table_close(table *t);

/* What separates the columns: "commas", ... */
const char *table_separator(const table *t);

/* What to do about a malformed line, to be set behind what is wrong with it. */
const char *table_remedy(const table *t);

/* The field for messages: the first characters of it. Returns text. */
#define TABLE_EXCERPT_MAX 40
const char *table_excerpt(const char *field, char text[TABLE_EXCERPT_MAX]);

#endif
