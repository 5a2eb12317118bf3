/* SPDX-License-Identifier: MIT
 *
 * draw/page.h: reports as one HTML file that asks for nothing from outside: no script, no font, no
 * picture but its own. Readable on a phone, a desktop and on paper, light and dark.
 *
 * Every text is escaped. Write errors show in ferror(file) at the end.
 */
#ifndef PAGE_H
#define PAGE_H

#include <stdio.h>

#include "cli/message.h"

/* Pictures come in two widths: on a narrow screen the second is shown, so that words stay large
 * enough. */
#define PAGE_WIDE 688.0
#define PAGE_NARROW 336.0

typedef struct {
    FILE *file;
    int has_section; /* one is open */
} page;

void page_begin(page *p, FILE *file, const char *title);

/* The same with a line at the head of each sheet of paper; "" makes none. */
void page_begin_headed(page *p, FILE *file, const char *title, const char *head);
void page_end(page *p);

/* What it comes to, under the title: a word ("Good"), a sentence, and what to do next. */
typedef enum { PAGE_GOOD, PAGE_CAUTION, PAGE_BAD } page_mood;
void page_verdict(page *p, page_mood mood, const char *word, const char *sentence,
                  const char *next);

/* The same with a line between word and sentence that answers what was asked: "PASS: ...", "FAIL: ...". */
typedef struct {
    const char *text; /* null: nothing was asked */
    int is_passed;
} page_answer;
void page_verdict_of(page *p, page_mood mood, const char *word, const page_answer *answer,
                     const char *sentence, const char *next);

/* Begins a section; it ends with the next or with the page. */
void page_section(page *p, const char *heading);

/* A paragraph; the second is in small print. */
void page_say(page *p, const char *format, ...) MESSAGE_FORMAT(2, 3);
void page_note(page *p, const char *format, ...) MESSAGE_FORMAT(2, 3);

/* A few figures that are the heart of it: value, and what it is. */
void page_figures_begin(page *p);
void page_figure(page *p, const char *value, const char *what);
void page_figures_end(page *p);

/* A picture with a caption. `draw` is called for each width. */
typedef void page_drawing(FILE *file, const void *data, double width);
void page_picture(page *p, const char *caption, page_drawing *draw, const void *data);

/* The same across the whole sheet: on paper others stand in pairs. */
void page_panorama(page *p, const char *caption, page_drawing *draw, const void *data);

/* Parts of a picture side by side where there is room, else one below the other: draw into
 * p->file in between. */
void page_row_begin(page *p);
void page_row_end(page *p, const char *caption);

/* A table: the first column is of words, the others of figures unless is_text says so. */
typedef struct {
    const char *caption; /* stands above; a table that is too wide for a phone scrolls below it */
    const char *const *heading; /* count texts */
    unsigned count;
    unsigned text_columns; /* bit k: column k is of words */
} page_table;
void page_table_begin(page *p, const page_table *table);
void page_cells(page *p, const page_table *table, const char *const *cell);     /* one row */
void page_bad_cells(page *p, const page_table *table, const char *const *cell); /* a red one */
void page_table_end(page *p);

/* What is to be copied, letter by letter; or drawn into p->file in between, escaped as HTML wants it. */
void page_code(page *p, const char *text);
void page_code_begin(page *p);
void page_code_end(page *p);

/* What is folded up until somebody wants it. */
void page_fold_begin(page *p, const char *summary, int is_open);
void page_fold_end(page *p);

/* Facts: a name and what there is to say. */
void page_facts_begin(page *p);
void page_fact(page *p, const char *name, const char *format, ...) MESSAGE_FORMAT(3, 4);
/* The same of a command or a name: letter by letter, in a face of one width. */
void page_literal(page *p, const char *name, const char *text);
void page_facts_end(page *p);

#endif
