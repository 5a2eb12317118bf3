/* SPDX-License-Identifier: MIT */
#include "watch/canvas.h"

#include <string.h>

#include "text/utf8.h"

void canvas_clear(canvas *c)
{
    memset(c, 0, sizeof *c);
}

void canvas_put(canvas *c, unsigned line, unsigned column, int colour, const char *glyph)
{
    if (line < CANVAS_LINES && column < CANVAS_COLUMNS) {
        snprintf(c->cell[line][column].glyph, sizeof c->cell[line][column].glyph, "%s", glyph);
        c->cell[line][column].colour = (signed char)colour;
    }
}

/* ---- text -------------------------------------------------------------------------------------- */

/* Characters that every terminal shows in one column: no control, combining, right-to-left or wide
 * ones. */
static int is_narrow(unsigned long code)
{
    return (code >= 0x20 && code < 0x7F) || (code > 0xA0 && code < 0x300 && code != 0xAD) ||
           (code >= 0x370 && code < 0x483) || (code >= 0x48A && code < 0x530);
}

/* Copies the next character to glyph. Returns the position of the one after it. */
static const char *next_glyph(const char *text, char glyph[5])
{
    const unsigned length = utf8_length(text);
    unsigned long code = (unsigned char)*text;

    if (length == 2) {
        code = (code & 0x1Fu) << 6 | ((unsigned char)text[1] & 0x3Fu);
    }
    const int is_shown = length > 0 && length <= 2 && is_narrow(code);
    snprintf(glyph, 5, "%.*s", is_shown ? (int)length : 1, is_shown ? text : "?");
    return text + (length > 0 ? length : 1);
}

unsigned canvas_text(canvas *c, unsigned line, unsigned column, unsigned end, int colour,
                     const char *text)
{
    char glyph[5];

    while (*text != '\0' && column < end) {
        text = next_glyph(text, glyph);
        canvas_put(c, line, column++, colour, glyph);
    }
    return column;
}

unsigned canvas_width(const char *text)
{
    char glyph[5];
    unsigned width = 0;

    while (*text != '\0') {
        text = next_glyph(text, glyph);
        width++;
    }
    return width;
}

/* The length of the words that fit into `columns`; if the first word does not fit, of its part that
 * does. */
static size_t fitting_length(const char *text, unsigned columns)
{
    char glyph[5];
    const char *at = text;
    const char *space = NULL;

    for (unsigned n = 0; *at != '\0' && n <= columns; n++) {
        if (n == columns) {
            return (size_t)((*at == ' ' || !space ? at : space) - text);
        }
        space = *at == ' ' ? at : space;
        at = next_glyph(at, glyph);
    }
    return (size_t)(at - text);
}

void canvas_wrapped(canvas *c, unsigned line, unsigned lines, unsigned column, int colour,
                    const char *text)
{
    char part[4 * CANVAS_COLUMNS + 1];

    for (unsigned n = 0; n < lines && *text != '\0'; n++) {
        const size_t length = fitting_length(text, CANVAS_COLUMNS - column);
        snprintf(part, sizeof part, "%.*s", (int)length, text);
        (void)canvas_text(c, line + n, column, CANVAS_COLUMNS, colour, part);
        text += length;
        text += *text == ' ';
    }
}

/* ---- as text ----------------------------------------------------------------------------------- */

static char *append(char *at, const char *text)
{
    const size_t length = strlen(text);

    memcpy(at, text, length + 1);
    return at + length;
}

static unsigned line_width(const canvas *c, unsigned line)
{
    unsigned width = CANVAS_COLUMNS;

    while (width > 0 && (c->cell[line][width - 1].glyph[0] == '\0' ||
                         strcmp(c->cell[line][width - 1].glyph, " ") == 0)) {
        width--;
    }
    return width;
}

static char *print_line(const canvas *c, unsigned line, FILE *out, char *at)
{
    const unsigned width = line_width(c, line);
    int current = CANVAS_PLAIN;

    for (unsigned column = 0; column < width; column++) {
        const char *glyph = c->cell[line][column].glyph;
        const int next = *glyph ? c->cell[line][column].colour : CANVAS_PLAIN;
        if (next != current) {
            at = append(at, current == CANVAS_PLAIN ? "" : paint_off(out));
            at = append(at, next == CANVAS_PLAIN ? "" : paint_on(out, (paint)next));
            current = next;
        }
        at = append(at, *glyph ? glyph : " ");
    }
    return append(at, current == CANVAS_PLAIN ? "" : paint_off(out));
}

const char *canvas_print(const canvas *c, FILE *out, const char *line_end, char text[CANVAS_BYTES])
{
    char *at = text;

    for (unsigned line = 0; line < CANVAS_LINES; line++) {
        at = append(print_line(c, line, out, at), line_end);
    }
    return text;
}
