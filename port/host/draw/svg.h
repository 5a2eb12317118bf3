/* SPDX-License-Identifier: MIT
 *
 * draw/svg.h: pictures for reports: lines, curves, markers, words.
 *
 * A picture is one <svg> element without an XML declaration: it stands as a file of its own or
 * inside an HTML page. It draws its own background, turns dark where the reader's screen is, and
 * asks for nothing from outside. Coordinates are in pixels, y down, printed to 0.01 and without
 * regard to the locale. Write errors show in ferror(file) at the end.
 *
 * `style` is words from this list, with blanks between:
 *   c0 c1 c2 c3   a colour: grey, blue, orange, green; for the styles of the next line
 *   curve full hollow over    a line; a filled shape, one with an outline only, and one that is
 *                             set off from what lies below it
 *   area bar column outline   a surface of a colour: pale, firm; a thick line; an outline filled
 *   side      a pale surface with a firm edge
 *   dashed whisker            lines: of a colour, black
 *   shade s0 ... s5    surfaces for a figure that grows from class to class; swatch: in a legend
 *   grid rule     lines: faint, firm
 *   ink soft      text: black, grey
 *   title heading small   text: 17 pixels and bold, 13 and bold, 12; else 14
 *   halo          text set off from what lies below it
 */
#ifndef SVG_H
#define SVG_H

#include <stdio.h>

typedef enum { SVG_START, SVG_MIDDLE, SVG_END } svg_anchor;

/* Markers that differ without colour. */
typedef enum { SVG_CIRCLE, SVG_SQUARE, SVG_TRIANGLE, SVG_CROSS, SVG_TARGET, SVG_DIAMOND } svg_shape;

/* `title` and `description` are read out to those who cannot see the picture; a browser also
 * shows the title as a tool tip. */
void svg_begin(FILE *file, double width, double height, const char *title, const char *description);
void svg_end(FILE *file);

/* The same as a part of a page that has the styles once for all its pictures. */
void svg_begin_inline(FILE *file, double width, double height, const char *title,
                      const char *description);
void svg_styles(FILE *file);

/* What is drawn between the two is moved by x, y. */
void svg_group_begin(FILE *file, double x, double y);
void svg_group_end(FILE *file);

void svg_line(FILE *file, const char *style, double x1, double y1, double x2, double y2);
void svg_circle(FILE *file, const char *style, double x, double y, double radius);
void svg_rectangle(FILE *file, const char *style, double x, double y, double width, double height);

/* A marker with about the area of a circle of this radius. */
void svg_marker(FILE *file, const char *style, svg_shape shape, double x, double y, double radius);

/* A line through points: begin, any number of points, end. */
void svg_polyline_begin(FILE *file, const char *style);
void svg_polyline_point(FILE *file, double x, double y);
void svg_polyline_end(FILE *file);

/* The same as a surface with these corners. */
void svg_polygon_begin(FILE *file, const char *style);

/* y is that of the base line. */
void svg_text(FILE *file, const char *style, svg_anchor anchor, double x, double y,
              const char *text);

/* Writes text into markup, XML or HTML, between tags or in a quoted attribute. Control characters
 * and bytes that are not UTF-8 become U+FFFD. */
void svg_escape(FILE *file, const char *text);

/* The same, and a hyphen before a figure or an axis, as programs write a minus, becomes that sign: U+2212
 * is as wide as +, and no line breaks behind it. Not for commands and names of files. */
void svg_prose(FILE *file, const char *text);

/* A number with 0 ... 6 decimals and a decimal point, whatever the locale, and never "-0".
 * Beyond +-1e9 it is cut off there; NaN gives 0. Returns text. */
#define SVG_NUMBER_MAX 24
const char *svg_fixed(double x, unsigned places, char text[SVG_NUMBER_MAX]);

#endif
