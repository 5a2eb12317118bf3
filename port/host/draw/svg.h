/* SPDX-License-Identifier: MIT
 *
 * draw/svg.h: pictures for reports: lines, curves, markers, text.
 *
 * A picture is one <svg> element without an XML declaration, as a file of its own or inside an HTML
 * page. It is self-contained, draws its own background, and follows a dark screen. Coordinates are
 * in pixels, y down, printed to 0.01, independent of the locale. Write errors show in ferror(file)
 * at the end.
 *
 * `style` is a list of these words, separated by blanks:
 *   c0 c1 c2 c3   a colour: grey, blue, orange, green; for the styles of the next line
 *   curve full hollow over    a line; a shape: filled, outlined, filled with a margin in the
 *                             colour of the background
 *   area bar column outline   a surface: pale, solid; a thick line; an outline, filled
 *   side      a pale surface with a solid edge
 *   dashed whisker            lines: coloured, black
 *   shade s0 ... s5    surfaces of classes 0 to 5 of a quantity; swatch: in a legend
 *   grid rule     lines: faint, solid
 *   ink soft      text: black, grey
 *   title heading small   text: 17 pixels and bold, 13 and bold, 12; else 14
 *   halo          text with a margin in the colour of the background
 */
#ifndef SVG_H
#define SVG_H

#include <stdio.h>

typedef enum { SVG_START, SVG_MIDDLE, SVG_END } svg_anchor;

/* Markers that can be distinguished without colour. */
typedef enum { SVG_CIRCLE, SVG_SQUARE, SVG_TRIANGLE, SVG_CROSS, SVG_TARGET, SVG_DIAMOND } svg_shape;

/* `title` and `description` are for screen readers; a browser also shows the title as a tooltip. */
void svg_begin(FILE *file, double width, double height, const char *title, const char *description);
void svg_end(FILE *file);

/* The same inside a page, which has the styles (svg_styles) once for all its pictures. */
void svg_begin_inline(FILE *file, double width, double height, const char *title,
                      const char *description);
void svg_styles(FILE *file);

/* Everything drawn between the two is moved by x, y. */
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

/* The same for a closed shape: its corners. */
void svg_polygon_begin(FILE *file, const char *style);

/* y is that of the base line. */
void svg_text(FILE *file, const char *style, svg_anchor anchor, double x, double y,
              const char *text);

/* Writes text into XML or HTML, between tags or in a quoted attribute. Control characters
 * and bytes that are not UTF-8 become U+FFFD. */
void svg_escape(FILE *file, const char *text);

/* The same, but a hyphen before a number or an axis becomes a minus, U+2212, which is as wide as +
 * and allows no line break after it. Not for commands and file names. */
void svg_prose(FILE *file, const char *text);

/* A number with 0 ... 6 decimals and a decimal point in any locale, never "-0". It is clipped
 * to +-1e9; NaN gives 0. Returns text. */
#define SVG_NUMBER_MAX 24
const char *svg_fixed(double x, unsigned places, char text[SVG_NUMBER_MAX]);

#endif
