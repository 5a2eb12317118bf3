/* SPDX-License-Identifier: MIT */
#include "draw/page.h"

#include <ctype.h>
#include <stdarg.h>

#include "cli/command.h"
#include "draw/svg.h"

#define TEXT_MAX 4096

/* Colours as in svg.c; the width holds two halves of a sphere (sphere.h). */
static const char styles[] =
    ":root{color-scheme:light "
    "dark;--paper:#fff;--ink:#1a1a1a;--soft:#555;--line:#d4d4d4;--shade:#0004;"
    "--good:#00694f;--goodback:#e5f4ef;--caution:#7d4800;--cautionback:#fdf1e0;"
    "--bad:#a3261d;--badback:#fdeae8}\n"
    "@media screen and (prefers-color-scheme:dark){:root{--paper:#16181b;--ink:#eee;"
    "--soft:#b4b4b4;--line:#3d4147;--shade:#fff4;--good:#6fdcb8;--goodback:#12291f;--caution:#"
    "f3b562;"
    "--cautionback:#2e2210;--bad:#ff9d93;--badback:#341815}}\n"
    "@media print{:root{color-scheme:light}}\n"
    "@page{size:A4;margin:12mm 14mm}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0 auto;padding:20px 12px 40px;max-width:712px;background:var(--paper);"
    "color:var(--ink);font:16px/1.5 system-ui,sans-serif;overflow-wrap:anywhere}\n"
    "h1{font-size:1.5rem;line-height:1.25;margin:0 0 16px}\n"
    "h2{font-size:1.2rem;line-height:1.3;margin:36px 0 8px}\n"
    "p{margin:8px 0}\n"
    ".note,figcaption{color:var(--soft);font-size:.875rem}\n"
    ".verdict{border-left:6px solid;border-radius:4px;padding:12px 16px;margin:0 0 16px}\n"
    ".verdict p{color:var(--ink)}\n"
    ".verdict .word{font-size:1.25rem;font-weight:bold;margin:0}\n"
    ".good{color:var(--good);background:var(--goodback)}\n"
    ".caution{color:var(--caution);background:var(--cautionback)}\n"
    ".bad{color:var(--bad);background:var(--badback)}\n"
    ".good .word{color:var(--good)}.caution .word{color:var(--caution)}"
    ".bad .word{color:var(--bad)}\n"
    ".verdict .answer{border-radius:4px;padding:4px 10px;margin:8px 0;font-weight:bold}\n"
    ".verdict .answer.good{color:var(--good);background:var(--goodback)}"
    ".verdict .answer.bad{color:var(--bad);background:var(--badback)}\n"
    ".figures{display:flex;flex-wrap:wrap;gap:8px 32px;margin:16px 0;padding:0}\n"
    ".figures div{flex:1 1 140px}\n"
    ".figures dt{color:var(--soft);font-size:.875rem}\n"
    ".figures dd{margin:0;font-size:1.25rem;font-weight:bold}\n"
    ".figures div{display:flex;flex-direction:column-reverse;justify-content:flex-end}\n"
    "figure{margin:16px 0;break-inside:avoid}\n"
    "figure svg{display:block}\n"
    ".row{display:flex;flex-wrap:wrap;gap:8px 16px}\n"
    ".row svg{flex:0 1 auto}\n"
    ".narrow{display:none}\n"
    "@media screen and (max-width:640px){.wide{display:none}.narrow{display:block}}\n"
    "@media screen and (max-width:480px){.facts.facts{display:block}.facts dd{margin-bottom:6px}}\n"
    /* Shadows at the edges where there is more to scroll to; the first two layers, which move with
     * the table, hide them at its ends. */
    ".scroll{overflow-x:auto;background:"
    "linear-gradient(to right,var(--paper) 30%,transparent) left/40px 100% no-repeat local,"
    "linear-gradient(to left,var(--paper) 30%,transparent) right/40px 100% no-repeat local,"
    "linear-gradient(to right,var(--shade),transparent) left/14px 100% no-repeat scroll,"
    "linear-gradient(to left,var(--shade),transparent) right/14px 100% no-repeat scroll}\n"
    ".code{white-space:pre-wrap;margin:8px 0;padding:8px 12px;border:1px solid var(--line);"
    "border-radius:4px;font:.8125rem/1.45 ui-monospace,monospace}\n"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.8125rem;"
    "margin:8px 0;overflow-wrap:normal}\n"
    "th,td{padding:3px 12px 3px 0;text-align:right;vertical-align:baseline;"
    "border-bottom:1px solid var(--line);white-space:nowrap}\n"
    "th{font-weight:600}\n"
    "thead th{vertical-align:bottom}\n"
    ".text{text-align:left}\n"
    "tr{break-inside:avoid}\n"
    "h2,summary{break-after:avoid}\n"
    "summary{cursor:pointer;margin:8px 0}\n"
    ".facts{display:grid;grid-template-columns:minmax(90px,max-content) 1fr;gap:4px 16px;"
    "margin:8px 0;font-size:.875rem}\n"
    ".facts dt{color:var(--soft)}\n"
    ".facts dd{margin:0}\n"
    ".literal{font-family:ui-monospace,monospace}\n"
    "footer{margin-top:40px;border-top:1px solid var(--line);padding-top:8px}\n";

/* On paper, folded parts are open and pictures are in pairs; a report of 18 positions takes three
 * sheets. */
static const char on_paper[] =
    "@media print{body{padding:0;max-width:none;font-size:9.5pt;line-height:1.35}"
    ".scroll{overflow:visible;background:none}"
    "details::details-content{content-visibility:visible;display:block;block-size:auto}"
    "summary{list-style:none;margin:2px 0}"
    "table{font-size:8pt}th,td{padding:1px 8px 1px "
    "0}h1{font-size:14pt}h2{font-size:11.5pt;margin:14px 0 4px}"
    "p,figure{margin:4px 0}main{zoom:.78}"
    ".half{display:inline-block;width:46%;vertical-align:top}"
    ".half .wide{display:none}.half .narrow{display:block}.row svg{width:36%;height:auto}"
    ".facts{display:block;columns:2;font-size:8pt}.facts dt{float:left;margin-right:6px}"
    "section:has(>.scroll~.half)>.scroll{float:left;margin-right:8px}h2{clear:both}"
    ".scroll~.half{width:34%}.half svg{max-width:100%;height:auto}"
    ".code{margin:2px 0;padding:2px 8px;font-size:7.5pt;line-height:1.25}"
    "footer{margin-top:4px;padding:0;break-before:avoid}}\n";

static void say(const page *p, const char *format, va_list arguments)
{
    char text[TEXT_MAX];

    vsnprintf(text, sizeof text, format, arguments);
    svg_prose(p->file, text);
}

/* An element; `open` may have attributes. */
static void element(const page *p, const char *open, const char *text, const char *close)
{
    fputs(open, p->file);
    svg_prose(p->file, text);
    fprintf(p->file, "%s\n", close);
}

/* A line in the upper margin of each sheet. Characters with a meaning in CSS or HTML are
 * escaped. */
static void write_head(FILE *file, const char *head)
{
    if (*head == '\0') {
        return;
    }
    fputs("<style>\n@page{@top-right{font:9pt system-ui,sans-serif;color:#555;content:\"", file);
    for (const char *c = head; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x80 && !isalnum((unsigned char)*c) && *c != ' ') {
            fprintf(file, "\\%x ", (unsigned)*c); /* the blank ends the figure */
        } else {
            putc(*c, file);
        }
    }
    fputs("\"}}\n</style>\n", file);
}

void page_begin(page *p, FILE *file, const char *title)
{
    page_begin_headed(p, file, title, "");
}

void page_begin_headed(page *p, FILE *file, const char *title, const char *head)
{
    *p = (page){.file = file};
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n",
          file);
    element(p, "<title>", title, "</title>");
    fprintf(file, "<style>\n%s%s</style>\n", styles, on_paper);
    write_head(file, head);
    svg_styles(file);
    fputs("</head>\n<body>\n<main>\n", file);
    element(p, "<h1>", title, "</h1>");
}

static void end_section(page *p)
{
    fputs(p->has_section ? "</section>\n" : "", p->file);
    p->has_section = 0;
}

void page_end(page *p)
{
    end_section(p);
    fputs("</main>\n", p->file);
    element(p, "<footer class=\"note\">", "Made by invcal " INVCAL_VERSION ".", "</footer>");
    fputs("</body>\n</html>\n", p->file);
}

void page_verdict(page *p, page_severity severity, const char *word, const char *sentence,
                  const char *next)
{
    static const page_answer none = {NULL, 0};

    page_verdict_with_answer(p, severity, word, &none, sentence, next);
}

void page_verdict_with_answer(page *p, page_severity severity, const char *word,
                              const page_answer *answer, const char *sentence, const char *next)
{
    static const char *const class[] = {"good", "caution", "bad"};

    fprintf(p->file, "<div class=\"verdict %s\">\n", class[severity]);
    element(p, "<p class=\"word\">", word, "</p>");
    if (answer->text) {
        element(p, answer->is_passed ? "<p class=\"answer good\">✓ " : "<p class=\"answer bad\">✗ ",
                answer->text, "</p>");
    }
    element(p, "<p>", sentence, "</p>");
    fputs("<p><b>Next:</b> ", p->file);
    element(p, "", next, "</p>");
    fputs("</div>\n", p->file);
}

void page_section(page *p, const char *heading)
{
    end_section(p);
    p->has_section = 1;
    element(p, "<section>\n<h2>", heading, "</h2>");
}

void page_say(page *p, const char *format, ...)
{
    va_list arguments;

    fputs("<p>", p->file);
    va_start(arguments, format);
    say(p, format, arguments);
    va_end(arguments);
    fputs("</p>\n", p->file);
}

void page_note(page *p, const char *format, ...)
{
    va_list arguments;

    fputs("<p class=\"note\">", p->file);
    va_start(arguments, format);
    say(p, format, arguments);
    va_end(arguments);
    fputs("</p>\n", p->file);
}

void page_figures_begin(page *p)
{
    fputs("<dl class=\"figures\">\n", p->file);
}

void page_figure(page *p, const char *value, const char *what)
{
    element(p, "<div><dt>", what, "</dt>");
    element(p, "<dd>", value, "</dd></div>");
}

void page_figures_end(page *p)
{
    fputs("</dl>\n", p->file);
}

static void picture(page *p, const char *open, const char *caption, page_drawing *draw,
                    const void *data)
{
    fprintf(p->file, "%s\n<div class=\"wide\">\n", open);
    draw(p->file, data, PAGE_WIDE);
    fputs("</div>\n<div class=\"narrow\">\n", p->file);
    draw(p->file, data, PAGE_NARROW);
    fputs("</div>\n", p->file);
    element(p, "<figcaption>", caption, "</figcaption>\n</figure>");
}

void page_picture(page *p, const char *caption, page_drawing *draw, const void *data)
{
    picture(p, "<figure class=\"half\">", caption, draw, data);
}

void page_wide_picture(page *p, const char *caption, page_drawing *draw, const void *data)
{
    picture(p, "<figure>", caption, draw, data);
}

void page_row_begin(page *p)
{
    fputs("<figure>\n<div class=\"row\">\n", p->file);
}

void page_row_end(page *p, const char *caption)
{
    fputs("</div>\n", p->file);
    element(p, "<figcaption>", caption, "</figcaption>\n</figure>");
}

static const char *cell_class(const page_table *table, unsigned column)
{
    return column == 0 || table->text_columns >> column & 1u ? " class=\"text\"" : "";
}

void page_table_begin(page *p, const page_table *table)
{
    element(p, "<p class=\"note\">", table->caption, "</p>");
    fputs("<div class=\"scroll\" tabindex=\"0\">\n<table aria-label=\"", p->file);
    svg_prose(p->file, table->caption);
    fputs("\">\n<thead><tr>\n", p->file);
    for (unsigned k = 0; k < table->count; k++) {
        fprintf(p->file, "<th scope=\"col\"%s>", cell_class(table, k));
        element(p, "", table->heading[k], "</th>");
    }
    fputs("</tr></thead>\n<tbody>\n", p->file);
}

static void write_cells(page *p, const page_table *table, const char *const *cell, const char *row)
{
    fprintf(p->file, "%s<th scope=\"row\" class=\"text\">", row);
    svg_prose(p->file, cell[0]);
    fputs("</th>", p->file);
    for (unsigned k = 1; k < table->count; k++) {
        fprintf(p->file, "<td%s>", cell_class(table, k));
        svg_prose(p->file, cell[k]);
        fputs("</td>", p->file);
    }
    fputs("</tr>\n", p->file);
}

void page_cells(page *p, const page_table *table, const char *const *cell)
{
    write_cells(p, table, cell, "<tr>");
}

void page_bad_cells(page *p, const page_table *table, const char *const *cell)
{
    write_cells(p, table, cell, "<tr class=\"bad\">");
}

void page_table_end(page *p)
{
    fputs("</tbody>\n</table>\n</div>\n", p->file);
}

void page_code_begin(page *p)
{
    fputs("<pre class=\"code\">", p->file);
}

void page_code_end(page *p)
{
    fputs("</pre>\n", p->file);
}

void page_code(page *p, const char *text)
{
    page_code_begin(p);
    svg_escape(p->file, text);
    page_code_end(p);
}

void page_fold_begin(page *p, const char *summary, int is_open)
{
    fputs(is_open ? "<details open>\n" : "<details>\n", p->file);
    element(p, "<summary>", summary, "</summary>");
}

void page_fold_end(page *p)
{
    fputs("</details>\n", p->file);
}

void page_facts_begin(page *p)
{
    fputs("<dl class=\"facts\">\n", p->file);
}

void page_fact(page *p, const char *name, const char *format, ...)
{
    va_list arguments;

    element(p, "<dt>", name, "</dt>");
    fputs("<dd>", p->file);
    va_start(arguments, format);
    say(p, format, arguments);
    va_end(arguments);
    fputs("</dd>\n", p->file);
}

void page_literal(page *p, const char *name, const char *text)
{
    element(p, "<dt>", name, "</dt>");
    fputs("<dd class=\"literal\">", p->file);
    svg_escape(p->file, text);
    fputs("</dd>\n", p->file);
}

void page_facts_end(page *p)
{
    fputs("</dl>\n", p->file);
}
