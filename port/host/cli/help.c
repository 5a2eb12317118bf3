/* SPDX-License-Identifier: MIT */
#include "cli/help.h"

#include <string.h>

#include "text/utf8.h"
#include "text/wrapped.h"

#define MEANING_COLUMN 22u /* where the meaning of an option begins, from 0 */
#define USAGE_COLUMN 7u    /* where the forms of a command begin */
#define HANGING_INDENT 4u  /* of their continuation lines */
#define LINE_SIZE 400
#define COMMAND_MAX 1000

typedef enum { NOTHING, PARAGRAPH, OPTION, USE, EXAMPLES } block;

typedef struct {
    FILE *file;
    block open;
    size_t at;     /* current column */
    size_t indent; /* of the lines after the first */
    char command[COMMAND_MAX];
} layout;

static int begins(const char *text, const char *prefix)
{
    return strncmp(text, prefix, strlen(prefix)) == 0;
}

static void close_block(layout *l)
{
    if (l->open == PARAGRAPH || l->open == OPTION || l->open == USE) {
        putc('\n', l->file);
    }
    l->open = NOTHING;
}

static void open_block(layout *l, block kind, size_t at, size_t indent)
{
    close_block(l);
    fprintf(l->file, "%*s", (int)at, "");
    l->open = kind;
    l->at = at;
    l->indent = indent;
}

static void put(layout *l, const char *text)
{
    l->at = wrapped_words(l->file, l->at, l->indent, text);
}

/* Appends a line to the open block. */
static void continue_block(layout *l, const char *text)
{
    char more[LINE_SIZE + 1];

    snprintf(more, sizeof more, "%s%s", l->at > l->indent ? " " : "", text);
    put(l, more);
}

/* The name of an option ends before two blanks, before a single blank in the column in front of the
 * meaning, or with the line. */
static size_t name_length(const char *line)
{
    const size_t length = strlen(line);
    const char *blanks = strstr(line + strspn(line, " "), "  ");

    if (length <= MEANING_COLUMN || line[MEANING_COLUMN - 1] != ' ') {
        return length;
    }
    return blanks && blanks < line + MEANING_COLUMN ? (size_t)(blanks - line) : MEANING_COLUMN - 1;
}

/* An option, or a word that is listed like one. */
static int is_option(const char *line)
{
    return begins(line, "  --") ||
           (begins(line, "    ") && line[4] != ' ' && strlen(line) > MEANING_COLUMN &&
            line[MEANING_COLUMN - 1] == ' ');
}

static void print_option(layout *l, const char *line)
{
    const size_t length = name_length(line);
    const char *meaning = line + length + strspn(line + length, " ");
    const size_t columns = utf8_columns_of(line, length);

    open_block(l, OPTION, 0, MEANING_COLUMN);
    fprintf(l->file, "%.*s", (int)length, line);
    if (columns < MEANING_COLUMN) {
        fprintf(l->file, "%*s", (int)(MEANING_COLUMN - columns), "");
    } else {
        fprintf(l->file, "\n%*s", (int)MEANING_COLUMN, "");
    }
    l->at = MEANING_COLUMN;
    put(l, meaning);
}

/* A command, or a part of one that ends with a backslash. */
static void print_example(layout *l, const char *line)
{
    const size_t used = strlen(l->command);
    const char *text = line + strspn(line, " ");
    const size_t length = strlen(text);

    if (length > 0 && text[length - 1] == '\\') {
        snprintf(l->command + used, COMMAND_MAX - used, "%.*s", (int)length - 1, text);
        return;
    }
    snprintf(l->command + used, COMMAND_MAX - used, "%s", text);
    fprintf(l->file, "  ");
    wrapped_command(l->file, 2, 2, l->command);
    l->command[0] = '\0';
}

static void print_text(layout *l, const char *line)
{
    const size_t indent = strspn(line, " ");
    const char *text = line + indent;

    if (l->open == USE && begins(text, "invcal ")) {
        open_block(l, USE, USAGE_COLUMN, USAGE_COLUMN + HANGING_INDENT);
        put(l, text);
    } else if (l->open == USE || (l->open == OPTION && indent == MEANING_COLUMN) ||
               (l->open == PARAGRAPH && l->indent == indent)) {
        continue_block(l, text);
    } else if (is_option(line)) {
        print_option(l, line);
    } else {
        open_block(l, PARAGRAPH, indent, indent);
        put(l, text);
    }
}

static void print_line(layout *l, const char *line)
{
    if (l->open == EXAMPLES) {
        print_example(l, line);
    } else if (*line == '\0') {
        close_block(l);
        putc('\n', l->file);
    } else if (begins(line, "usage:")) {
        open_block(l, USE, 0, USAGE_COLUMN + HANGING_INDENT);
        put(l, line);
    } else if (begins(line, "example")) {
        close_block(l);
        fprintf(l->file, "%s\n", line);
        l->open = EXAMPLES;
    } else {
        print_text(l, line);
    }
}

void help_print(FILE *file, const char *const *parts)
{
    layout l = {.file = file};
    char line[LINE_SIZE];

    for (; *parts; parts++) {
        for (const char *text = *parts; *text != '\0';) {
            const size_t length = strcspn(text, "\n");
            snprintf(line, sizeof line, "%.*s", (int)length, text);
            print_line(&l, line);
            text += length + (text[length] == '\n');
        }
    }
    close_block(&l);
}
