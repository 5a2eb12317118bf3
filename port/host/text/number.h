/* SPDX-License-Identifier: MIT
 *
 * text/number.h: decimal numbers to and from text, strictly and in the C locale.
 */
#ifndef NUMBER_H
#define NUMBER_H

#include <math.h>

/* Stands for a figure that nobody knows. */
#define NUMBER_UNKNOWN ((double)NAN)

typedef enum {
    NUMBER_OK,
    NUMBER_EMPTY,
    NUMBER_NOT_DECIMAL, /* a word, a hexadecimal number, something after it */
    NUMBER_COMMA,       /* digits with one comma between */
    NUMBER_GROUPED,     /* thousands are separated: 1,234,567  1.234,5  1'234 */
    NUMBER_NOT_FINITE,  /* nan, inf, infinity */
    NUMBER_TOO_LARGE    /* beyond a double; too small a number is rounded, which is no fault */
} number_status;

/* Reads [+-]digits[.digits][e[+-]digits], the whole text, without blanks. */
number_status number_parse(const char *text, double *out);

/* What is wrong, to follow the text in a sentence: "is not a decimal number". */
const char *number_problem(number_status status);

/* 1 if somebody meant a number, right or wrong: a digit comes first, or it is nan or inf. */
int number_is_meant(const char *text);

/* The shortest text that reads back as the same number; x finite. Returns text. */
#define NUMBER_TEXT_MAX 32
const char *number_text(double x, char text[NUMBER_TEXT_MAX]);

#endif
