/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "text/number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char *skip_sign(const char *s)
{
    return s + (*s == '+' || *s == '-');
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static const char *skip_digits(const char *s)
{
    while (is_digit(*s)) {
        s++;
    }
    return s;
}

/* strtod alone would take blanks, hexadecimal numbers and words. */
static int is_decimal(const char *text)
{
    const char *whole = skip_sign(text);
    const char *s = skip_digits(whole);
    int digits = s > whole;

    if (*s == '.') {
        const char *fraction = s + 1;
        s = skip_digits(fraction);
        digits = digits || s > fraction;
    }
    if (digits && (*s == 'e' || *s == 'E')) {
        const char *exponent = skip_sign(s + 1);
        s = skip_digits(exponent);
        digits = s > exponent;
    }
    return digits && *s == '\0';
}

static int is_not_finite(const char *text)
{
    const char *word = skip_sign(text);

    return strcasecmp(word, "nan") == 0 || strcasecmp(word, "inf") == 0 ||
           strcasecmp(word, "infinity") == 0;
}

/* What is wrong: a number in another locale's notation, or none. */
static number_status find_fault(const char *text)
{
    const char *s = skip_sign(text);
    const char *end = s + strspn(s, "0123456789.,'");
    unsigned marks = 0;

    if (*end == 'e' || *end == 'E') {
        end = skip_digits(skip_sign(end + 1));
    }
    if (!number_is_meant(text) || *end != '\0' || !strpbrk(s, ",'")) {
        return NUMBER_NOT_DECIMAL;
    }
    for (; *s != '\0'; s++) {
        marks += strchr(".,'", *s) != NULL;
    }
    return marks == 1 && strchr(text, ',') ? NUMBER_COMMA : NUMBER_GROUPED;
}

number_status number_parse(const char *text, double *out)
{
    if (*text == '\0') {
        return NUMBER_EMPTY;
    }
    if (!is_decimal(text)) {
        return is_not_finite(text) ? NUMBER_NOT_FINITE : find_fault(text);
    }
    const double x = strtod(text, NULL);
    if (!(fabs(x) <= DBL_MAX)) {
        return NUMBER_TOO_LARGE;
    }
    *out = x;
    return NUMBER_OK;
}

const char *number_problem(number_status status)
{
    switch (status) {
    case NUMBER_OK:
        return "is a number";
    case NUMBER_EMPTY:
        return "is empty";
    case NUMBER_NOT_FINITE:
        return "is not a finite number";
    case NUMBER_TOO_LARGE:
        return "is too large a number";
    case NUMBER_COMMA:
        return "has a decimal comma: save with decimal points";
    case NUMBER_GROUPED:
        return "has thousands separators: save without them";
    case NUMBER_NOT_DECIMAL:
        break;
    }
    return "is not a decimal number";
}

int number_is_meant(const char *text)
{
    const char *s = skip_sign(text);

    return is_digit(*s) || (*s == '.' && is_digit(s[1])) || is_not_finite(text);
}

static int reads_back(const char *text, double x)
{
    const double back = strtod(text, NULL);

    return !(back < x || back > x);
}

const char *number_text(double x, char text[NUMBER_TEXT_MAX])
{
    int digits = 14;

    do {
        snprintf(text, NUMBER_TEXT_MAX, "%.*g", ++digits, x);
    } while (digits < 17 && !reads_back(text, x));
    return text;
}
