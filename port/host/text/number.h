/* SPDX-License-Identifier: MIT
 *
 * text/number.h: decimal numbers to and from text, strictly and in the C locale.
 */
#ifndef NUMBER_H
#define NUMBER_H

#include <math.h>

/* Stands for an unknown figure. */
#define NUMBER_UNKNOWN ((double)NAN)

typedef enum {
    NUMBER_OK,
    NUMBER_EMPTY,
    NUMBER_NOT_DECIMAL, /* a word, a hexadecimal number, or a number followed by something */
    NUMBER_COMMA,       /* a decimal comma */
    NUMBER_GROUPED,     /* thousands separators: 1,234,567  1.234,5  1'234 */
    NUMBER_NOT_FINITE,  /* nan, inf, infinity */
    NUMBER_TOO_LARGE /* beyond a double; a number too small for one is rounded, and not an error */
} number_status;

/* Parses a text [+-]digits[.digits][e[+-]digits] without blanks. */
number_status number_parse(const char *text, double *out);

/* What is wrong, as the end of a sentence that begins with the text: "is not a decimal number". */
const char *number_problem(number_status status);

/* 1 if the text is meant as a number, valid or not: it begins with a digit, or is nan or inf. */
int number_is_meant(const char *text);

/* The shortest text that reads back as the same number; x finite. Returns text. */
#define NUMBER_TEXT_MAX 32
const char *number_text(double x, char text[NUMBER_TEXT_MAX]);

#endif
