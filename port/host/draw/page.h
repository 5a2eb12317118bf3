/* SPDX-License-Identifier: MIT
 *
 * draw/page.h: reports as one self-contained HTML file, without scripts, fonts or pictures from
 * elsewhere. Readable on a phone, a desktop and on paper, light and dark.
 *
 * Every text is escaped. Write errors show in ferror(file) at the end.
 */
#ifndef PAGE_H
#define PAGE_H

#include <stdio.h>

#include "cli/message.h"

/* The two widths of each picture: a narrow screen shows the second, so that its text stays
 * legible. */
#define PAGE_WIDE 688.0
#define PAGE_NARROW 336.0

typedef struct {
    FILE *file;
    int has_section; /* one is open */
} page;

void page_begin(page *p, FILE *file, const char *title);

/* The same with a header on each sheet of paper; "" for none. */
void page_begin_headed(page *p, FILE *file, const char *title, const char *head);
void page_end(page *p);

/* The verdict, under the title: a word ("Good"), a sentence, and what to do next. */
typedef enum { PAGE_GOOD, PAGE_CAUTION, PAGE_BAD } page_severity;
void page_verdict(page *p, page_severity severity, const char *word, const char *sentence,
                  const char *next);

/* The same with the outcome of --need and --tolerance between word and sentence: "PASS: ...",
 * "FAIL: ...". */
typedef struct {
    const char *text; /* null: neither was given */
    int is_passed;
} page_answer;
void page_verdict_with_answer(page *p, page_severity severity, const char *word,
                              const page_answer *answer, const char *sentence, const char *next);

/* Begins a section; it ends with the next or with the page. */
void page_section(page *p, const char *heading);

/* A paragraph; the second is in small print. */
void page_say(page *p, const char *format, ...) MESSAGE_FORMAT(2, 3);
void page_note(page *p, const char *format, ...) MESSAGE_FORMAT(2, 3);

/* The most important figures: value, and what it is. */
void page_figures_begin(page *p);
void page_figure(page *p, const char *value, const char *what);
void page_figures_end(page *p);

/* A picture with a caption. `draw` is called for each width. */
typedef void page_drawing(FILE *file, const void *data, double width);
void page_picture(page *p, const char *caption, page_drawing *draw, const void *data);

/* The same over the full width of the sheet; on paper, other pictures are set in pairs. */
void page_wide_picture(page *p, const char *caption, page_drawing *draw, const void *data);

/* Parts of a picture side by side, or one below the other on a narrow screen: draw into p->file in
 * between. */
void page_row_begin(page *p);
void page_row_end(page *p, const char *caption);

/* A table. The first column is text, the others are figures unless text_columns says otherwise. */
typedef struct {
    const char *caption;        /* above the table, which scrolls if it is too wide for a phone */
    const char *const *heading; /* count texts */
    unsigned count;
    unsigned text_columns; /* bit k: column k is text */
} page_table;
void page_table_begin(page *p, const page_table *table);
void page_cells(page *p, const page_table *table, const char *const *cell);     /* one row */
void page_bad_cells(page *p, const page_table *table, const char *const *cell); /* a red row */
void page_table_end(page *p);

/* Text to be copied verbatim. Between begin and end, write to p->file, escaped for HTML. */
void page_code(page *p, const char *text);
void page_code_begin(page *p);
void page_code_end(page *p);

/* A part that can be folded. */
void page_fold_begin(page *p, const char *summary, int is_open);
void page_fold_end(page *p);

/* A list of facts: name and text. */
void page_facts_begin(page *p);
void page_fact(page *p, const char *name, const char *format, ...) MESSAGE_FORMAT(3, 4);
/* The same for a command or a name: verbatim, in a fixed-width font. */
void page_literal(page *p, const char *name, const char *text);
void page_facts_end(page *p);

#endif
