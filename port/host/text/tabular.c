/* SPDX-License-Identifier: MIT */
#include "text/tabular.h"

#include <stdarg.h>
#include <string.h>

#include "text/utf8.h"
#include "text/wrapped.h"

#define GAP 2u      /* blanks before a right-aligned column and before a note */
#define GAP_LEFT 1u /* before a left-aligned column */

typedef struct {
    char cell[TABULAR_COLUMNS][TABULAR_CELL];
    char note[TABULAR_CELL];
    int is_painted;
    paint colour;
} row;

static struct {
    FILE *file;
    char alignment[TABULAR_COLUMNS + 1];
    unsigned columns;
    unsigned rows; /* complete */
    unsigned at;   /* the next cell of the row that is being filled */
    row row[TABULAR_ROWS];
    size_t width[TABULAR_COLUMNS]; /* of the widest cell; set by measure */
    size_t notes;                  /* width of the widest note, with its gap; the same */
} table;

static row *open_row(void)
{
    return &table.row[table.rows];
}

static int is_heading(const row *r)
{
    return r == table.row && r->is_painted && r->colour == PAINT_BOLD;
}

static void clear_row(void)
{
    memset(open_row(), 0, sizeof *open_row());
    table.at = 0;
}

void tabular_begin(FILE *file, const char *alignment)
{
    table.file = file;
    snprintf(table.alignment, sizeof table.alignment, "%s", alignment);
    table.columns = (unsigned)strlen(table.alignment);
    table.rows = 0;
    clear_row();
}

void tabular_cell(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    if (table.at < table.columns) {
        vsnprintf(open_row()->cell[table.at++], TABULAR_CELL, format, arguments);
    }
    va_end(arguments);
}

void tabular_note(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(open_row()->note, TABULAR_CELL, format, arguments);
    va_end(arguments);
}

void tabular_row(void)
{
    table.rows++;
    if (table.rows == TABULAR_ROWS) {
        tabular_end();
        table.rows = is_heading(table.row) ? 1 : 0;
    }
    clear_row();
}

void tabular_row_in(paint colour)
{
    open_row()->is_painted = 1;
    open_row()->colour = colour;
    tabular_row();
}

void tabular_heading(const char *names)
{
    const char *name = names;

    for (;;) {
        const size_t length = strcspn(name, "|");
        tabular_cell("%.*s", (int)length, name);
        if (name[length] == '\0') {
            break;
        }
        name += length + 1;
    }
    tabular_row_in(PAINT_BOLD);
}

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

static void measure(void)
{
    memset(table.width, 0, sizeof table.width);
    table.notes = 0;
    for (unsigned i = 0; i < table.rows; i++) {
        const row *r = &table.row[i];
        const size_t note = utf8_columns(r->note);
        for (unsigned c = 0; c < table.columns; c++) {
            table.width[c] = larger(table.width[c], utf8_columns(r->cell[c]));
        }
        table.notes = larger(table.notes, note > 0 ? note + GAP : 0);
    }
}

static size_t gap(unsigned column)
{
    return column == 0 ? 0 : table.alignment[column] == 'l' ? GAP_LEFT : GAP;
}

/* The end of the part of the table that begins with column `from`: as many columns as fit next to
 * the first one, and at least one. */
static unsigned part_end(unsigned from, size_t available)
{
    size_t used = table.width[0];
    unsigned end = from;

    for (unsigned c = from; c < table.columns; c++) {
        used += gap(c) + table.width[c];
        const int ends = c + 1 == table.columns || table.alignment[c + 1] != 'l';
        if (ends && used > available && end > from) {
            break;
        }
        end = ends ? c + 1 : end;
    }
    return end;
}

static int has_cell(const row *r, unsigned from, unsigned end)
{
    for (unsigned c = from; c < end; c++) {
        if (*r->cell[c] != '\0') {
            return 1;
        }
    }
    return 0;
}

/* Prints a cell. `blanks` counts the blanks due before the next cell, so that none end a line. */
static void print_cell(const row *r, unsigned column, size_t *blanks)
{
    const char *text = r->cell[column];
    const size_t free = table.width[column] - utf8_columns(text);
    const int is_left = table.alignment[column] == 'l';

    *blanks += gap(column) + (is_left ? 0 : free);
    if (*text != '\0') {
        fprintf(table.file, "%*s%s", (int)*blanks, "", text);
        *blanks = 0;
    }
    *blanks += is_left ? free : 0;
}

static void print_row(const row *r, unsigned from, unsigned end, int has_note)
{
    size_t blanks = 0;

    fputs(r->is_painted ? paint_on(table.file, r->colour) : "", table.file);
    print_cell(r, 0, &blanks);
    for (unsigned c = from; c < end; c++) {
        print_cell(r, c, &blanks);
    }
    if (has_note && *r->note != '\0') {
        fprintf(table.file, "%*s%s", (int)(blanks + GAP), "", r->note);
    }
    fprintf(table.file, "%s\n", r->is_painted ? paint_off(table.file) : "");
}

/* The columns from ... end - 1 of all rows. A note is printed once above consecutive rows that
 * share it. */
static void print_part(unsigned from, unsigned end, int notes_above, int notes_beside)
{
    const char *note = "";

    for (unsigned i = 0; i < table.rows; i++) {
        const row *r = &table.row[i];
        if (!is_heading(r) && !has_cell(r, from, end)) {
            continue;
        }
        if (notes_above && !is_heading(r) && strcmp(note, r->note) != 0) {
            note = r->note;
            fprintf(table.file, "%s%s\n", *note != '\0' ? "in " : "", note);
        }
        print_row(r, from, end, notes_beside);
    }
}

void tabular_end(void)
{
    const size_t available = wrapped_width(table.file);
    unsigned from = 1;

    if (table.rows <= (is_heading(table.row) ? 1u : 0u)) {
        return;
    }
    measure();
    size_t total = table.width[0] + table.notes;
    for (unsigned c = 1; c < table.columns; c++) {
        total += gap(c) + table.width[c];
    }
    const int notes_beside = total <= available;
    while (from < table.columns) {
        const unsigned end = part_end(from, notes_beside ? available - table.notes : available);
        if (from > 1) {
            putc('\n', table.file);
        }
        print_part(from, end, table.notes > 0 && !notes_beside && from == 1, notes_beside);
        from = end;
    }
}
