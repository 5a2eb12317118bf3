/* SPDX-License-Identifier: MIT */
#include "draw/svg.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "text/utf8.h"

#define LARGEST 1e9
#define REPLACEMENT "\xEF\xBF\xBD" /* U+FFFD */
#define MINUS "\xE2\x88\x92"       /* U+2212 */

/* Colours for all kinds of colour vision (Okabe and Ito), lighter on black. Only plain classes and
 * currentColor, as word processors know nothing else. Print is on white. */
static const char styles[] = ".invcal .paper{fill:#fff}\n"
                             ".invcal .ink{fill:#1a1a1a}\n"
                             ".invcal .soft{fill:#555}\n"
                             ".invcal .title{font-size:17px;font-weight:bold}\n"
                             ".invcal .heading{font-size:13px;font-weight:bold}\n"
                             ".invcal .small{font-size:12px}\n"
                             ".invcal .grid{fill:none;stroke:#ddd}\n"
                             ".invcal .rule{fill:none;stroke:#5f5f5f}\n"
                             ".invcal .c0{color:#666}\n"
                             ".invcal .c1{color:#0072b2}\n"
                             ".invcal .c2{color:#d55e00}\n"
                             ".invcal .c3{color:#14532d}\n"
                             ".invcal .curve{fill:none;stroke:currentColor;stroke-width:1.5}\n"
                             ".invcal .full{fill:currentColor;stroke:currentColor}\n"
                             ".invcal .hollow{fill:#fff;stroke:currentColor;stroke-width:1.5}\n"
                             ".invcal .over{fill:currentColor;stroke:#fff}\n"
                             ".invcal .area{fill:currentColor;fill-opacity:.16;"
                             "stroke:currentColor;stroke-opacity:.22;stroke-width:.75}\n"
                             ".invcal .side{fill:currentColor;fill-opacity:.16;stroke:#5f5f5f;"
                             "stroke-linejoin:round}\n"
                             ".invcal .bar{fill:currentColor}\n"
                             ".invcal .column{stroke:currentColor}\n"
                             ".invcal .outline{fill:currentColor;stroke:currentColor;"
                             "stroke-linejoin:round}\n"
                             ".invcal .dashed{fill:none;stroke:currentColor;stroke-width:1.5;"
                             "stroke-dasharray:5 3}\n"
                             ".invcal .whisker{stroke:#1a1a1a;stroke-width:1.5}\n"
                             ".invcal .swatch{stroke:#777;stroke-width:.5}\n"
                             ".invcal .halo{paint-order:stroke;stroke:#fff;stroke-width:3px;"
                             "stroke-linejoin:round}\n"
                             ".invcal .shade{shape-rendering:crispEdges}\n"
                             ".invcal .s0{fill:#f2f6f9}\n"
                             ".invcal .s1{fill:#dfeaf2}\n"
                             ".invcal .s2{fill:#c8dcea}\n"
                             ".invcal .s3{fill:#b0cde1}\n"
                             ".invcal .s4{fill:#98bdd8}\n"
                             ".invcal .s5{fill:#80adcf}\n"
                             "@media screen and (prefers-color-scheme:dark){\n"
                             ".invcal .paper,.invcal .hollow{fill:#16181b}\n"
                             ".invcal .over,.invcal .halo{stroke:#16181b}\n"
                             ".invcal .whisker{stroke:#eee}\n"
                             ".invcal .s0{fill:#1b2126}\n"
                             ".invcal .s1{fill:#212d35}\n"
                             ".invcal .s2{fill:#273945}\n"
                             ".invcal .s3{fill:#2e4656}\n"
                             ".invcal .s4{fill:#355367}\n"
                             ".invcal .s5{fill:#3c6078}\n"
                             ".invcal .ink{fill:#eee}\n"
                             ".invcal .soft{fill:#b4b4b4}\n"
                             ".invcal .grid{stroke:#383b40}\n"
                             ".invcal .rule,.invcal .side{stroke:#a4a4a4}\n"
                             ".invcal .c0{color:#aaa}\n"
                             ".invcal .c1{color:#56b4e9}\n"
                             ".invcal .c2{color:#f0a040}\n"
                             ".invcal .c3{color:#98ecb0}\n"
                             "}\n";

const char *svg_fixed(double x, unsigned places, char text[SVG_NUMBER_MAX])
{
    const double size = fabs(x) < LARGEST ? fabs(x) : isnan(x) ? 0 : LARGEST;
    unsigned long long unit = 1;

    for (unsigned i = 0; i < places; i++) {
        unit *= 10;
    }
    const unsigned long long n = (unsigned long long)(size * (double)unit + 0.5);
    const char *sign = x < 0 && n > 0 ? "-" : "";
    if (places == 0) {
        snprintf(text, SVG_NUMBER_MAX, "%s%llu", sign, n);
    } else {
        snprintf(text, SVG_NUMBER_MAX, "%s%llu.%0*llu", sign, n / unit, (int)places, n % unit);
    }
    return text;
}

/* A coordinate, without trailing zeros: this makes files with thousands of them smaller. */
static void write_coordinate(FILE *file, double x)
{
    char text[SVG_NUMBER_MAX];
    char *last = text + strlen(svg_fixed(x, 2, text)) - 1;

    while (*last == '0') {
        *last-- = '\0';
    }
    if (*last == '.') {
        *last = '\0';
    }
    fputs(text, file);
}

static void write_attribute(FILE *file, const char *name, double x)
{
    fprintf(file, " %s=\"", name);
    write_coordinate(file, x);
    putc('"', file);
}

/* Control characters, C0 and C1, and the noncharacters U+FFFE and U+FFFF. */
static int is_banned(const char *c, unsigned length)
{
    const unsigned char *byte = (const unsigned char *)c;

    switch (length) {
    case 1:
        return byte[0] < ' ' || byte[0] == 0x7F;
    case 2:
        return byte[0] == 0xC2 && byte[1] < 0xA0;
    case 3:
        return byte[0] == 0xEF && byte[1] == 0xBF && byte[2] >= 0xBE;
    default:
        return length == 0;
    }
}

static const char *entity(char c)
{
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

/* A sign before a number, or before an axis: -1.5, -z. */
static int is_minus(const char *text, char before)
{
    const int is_axis = text[1] >= 'x' && text[1] <= 'z' && !isalnum((unsigned char)text[2]);

    return *text == '-' && strchr(" ([", before) &&
           (isdigit((unsigned char)text[1]) || text[1] == '.' || is_axis);
}

static void write_text(FILE *file, const char *text, int is_prose)
{
    char before = ' ';

    while (*text != '\0') {
        const unsigned length = utf8_length(text);
        if (is_banned(text, length)) {
            fputs(REPLACEMENT, file);
        } else if (entity(*text)) {
            fputs(entity(*text), file);
        } else if (is_prose && is_minus(text, before)) {
            fputs(MINUS, file);
        } else {
            fwrite(text, 1, length, file);
        }
        before = *text;
        text += length > 0 ? length : 1;
    }
}

void svg_escape(FILE *file, const char *text)
{
    write_text(file, text, 0);
}

void svg_prose(FILE *file, const char *text)
{
    write_text(file, text, 1);
}

void svg_styles(FILE *file)
{
    fprintf(file, "<style>\n%s</style>\n", styles);
}

static void begin(FILE *file, double width, double height, const char *title,
                  const char *description)
{
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"invcal\" role=\"img\"", file);
    write_attribute(file, "width", width);
    write_attribute(file, "height", height);
    fputs(" viewBox=\"0 0 ", file);
    write_coordinate(file, width);
    putc(' ', file);
    write_coordinate(file, height);
    fputs("\"\n style=\"max-width:100%;height:auto\" font-family=\"sans-serif\""
          " font-size=\"14\">\n<title>",
          file);
    svg_escape(file, title);
    fputs("</title>\n<desc>", file);
    svg_prose(file, description);
    fputs("</desc>\n", file);
}

void svg_begin(FILE *file, double width, double height, const char *title, const char *description)
{
    begin(file, width, height, title, description);
    svg_styles(file);
    fputs("<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n", file);
}

void svg_begin_inline(FILE *file, double width, double height, const char *title,
                      const char *description)
{
    begin(file, width, height, title, description);
}

void svg_end(FILE *file)
{
    fputs("</svg>\n", file);
}

void svg_group_begin(FILE *file, double x, double y)
{
    fputs("<g transform=\"translate(", file);
    write_coordinate(file, x);
    putc(' ', file);
    write_coordinate(file, y);
    fputs(")\">\n", file);
}

void svg_group_end(FILE *file)
{
    fputs("</g>\n", file);
}

void svg_line(FILE *file, const char *style, double x1, double y1, double x2, double y2)
{
    fprintf(file, "<line class=\"%s\"", style);
    write_attribute(file, "x1", x1);
    write_attribute(file, "y1", y1);
    write_attribute(file, "x2", x2);
    write_attribute(file, "y2", y2);
    fputs("/>\n", file);
}

void svg_circle(FILE *file, const char *style, double x, double y, double radius)
{
    fprintf(file, "<circle class=\"%s\"", style);
    write_attribute(file, "cx", x);
    write_attribute(file, "cy", y);
    write_attribute(file, "r", radius);
    fputs("/>\n", file);
}

void svg_rectangle(FILE *file, const char *style, double x, double y, double width, double height)
{
    fprintf(file, "<rect class=\"%s\"", style);
    write_attribute(file, "x", x);
    write_attribute(file, "y", y);
    write_attribute(file, "width", width);
    write_attribute(file, "height", height);
    fputs("/>\n", file);
}

void svg_polygon_begin(FILE *file, const char *style)
{
    fprintf(file, "<polygon class=\"%s\" points=\"", style);
}

static void write_polygon(FILE *file, const char *style, const double (*corner)[2], unsigned count)
{
    svg_polygon_begin(file, style);
    for (unsigned i = 0; i < count; i++) {
        svg_polyline_point(file, corner[i][0], corner[i][1]);
    }
    svg_polyline_end(file);
}

void svg_marker(FILE *file, const char *style, svg_shape shape, double x, double y, double radius)
{
    const double side = 0.9 * radius; /* half the side of a square */
    const double up = 1.45 * radius;  /* centre to corner of a triangle or a diamond */
    const double arm = 0.95 * radius; /* of a cross, along x and y */
    const double thick = 0.42 * radius;
    const double cross[][2] = {
        {x, y - thick}, {x + arm - thick, y - arm}, {x + arm, y - arm + thick},
        {x + thick, y}, {x + arm, y + arm - thick}, {x + arm - thick, y + arm},
        {x, y + thick}, {x - arm + thick, y + arm}, {x - arm, y + arm - thick},
        {x - thick, y}, {x - arm, y - arm + thick}, {x - arm + thick, y - arm}};
    const double square[][2] = {
        {x - side, y - side}, {x + side, y - side}, {x + side, y + side}, {x - side, y + side}};
    const double diamond[][2] = {{x, y - up}, {x + up, y}, {x, y + up}, {x - up, y}};
    const double triangle[][2] = {
        {x, y - up}, {x + 0.866 * up, y + 0.5 * up}, {x - 0.866 * up, y + 0.5 * up}};

    char part[16];

    switch (shape) {
    case SVG_SQUARE:
        write_polygon(file, style, square, 4);
        break;
    case SVG_TRIANGLE:
        write_polygon(file, style, triangle, 3);
        break;
    case SVG_CROSS:
        write_polygon(file, style, cross, 12);
        break;
    case SVG_DIAMOND:
        write_polygon(file, style, diamond, 4);
        break;
    case SVG_TARGET: /* a dot and a ring, on the colour of the background */
        svg_circle(file, "paper", x, y, 1.8 * radius);
        snprintf(part, sizeof part, "%.2s curve", style);
        svg_circle(file, part, x, y, 1.5 * radius);
        snprintf(part, sizeof part, "%.2s full", style);
        svg_circle(file, part, x, y, 0.45 * radius);
        break;
    case SVG_CIRCLE:
        svg_circle(file, style, x, y, radius);
        break;
    }
}

void svg_polyline_begin(FILE *file, const char *style)
{
    fprintf(file, "<polyline class=\"%s\" points=\"", style);
}

void svg_polyline_point(FILE *file, double x, double y)
{
    write_coordinate(file, x);
    putc(',', file);
    write_coordinate(file, y);
    putc(' ', file);
}

void svg_polyline_end(FILE *file)
{
    fputs("\"/>\n", file);
}

void svg_text(FILE *file, const char *style, svg_anchor anchor, double x, double y,
              const char *text)
{
    static const char *const anchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};

    fprintf(file, "<text class=\"%s\"%s", style, anchors[anchor]);
    write_attribute(file, "x", x);
    write_attribute(file, "y", y);
    putc('>', file);
    svg_prose(file, text);
    fputs("</text>\n", file);
}
