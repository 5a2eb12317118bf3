/* SPDX-License-Identifier: MIT */
#include "text/clock.h"

#include <ctype.h>
#include <stddef.h>

/* A number of so many digits, in a range, and the separator after it ('\0': none). Returns what
 * follows, or NULL. */
static const char *read_digits(const char *s, unsigned digits, const long range[2], char separator,
                               long *out)
{
    *out = 0;
    for (unsigned i = 0; i < digits; i++, s++) {
        if (!isdigit((unsigned char)*s)) {
            return NULL;
        }
        *out = 10 * *out + (*s - '0');
    }
    if (*out < range[0] || *out > range[1] || (separator != '\0' && *s != separator)) {
        return NULL;
    }
    return s + (separator != '\0');
}

/* Days since 1970-01-01 in the Gregorian calendar. Years begin in March, so that a leap day comes
 * last. */
static long days_since_1970(long year, long month, long day)
{
    const long y = month > 2 ? year : year - 1;
    const long m = month > 2 ? month - 3 : month + 9;

    return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 719468;
}

/* An optional date. Returns what follows, or NULL. */
static const char *read_date(const char *s, double *days)
{
    static const long years[2] = {1, 9999};
    static const long months[2] = {1, 12};
    static const long days_of_month[2] = {1, 31};
    long year;
    long month;
    long day;
    const char *end = read_digits(s, 4, years, '-', &year);

    *days = 0;
    if (!end) {
        return s;
    }
    end = read_digits(end, 2, months, '-', &month);
    end = end ? read_digits(end, 2, days_of_month, '\0', &day) : NULL;
    if (!end || (*end != 'T' && *end != ' ')) {
        return NULL;
    }
    *days = (double)days_since_1970(year, month, day);
    return end + 1;
}

static const char *read_fraction(const char *s, double *seconds)
{
    if (*s != '.' || !isdigit((unsigned char)s[1])) {
        return s;
    }
    double numerator = 0;
    double denominator = 1;
    for (s++; isdigit((unsigned char)*s); s++) {
        numerator = 10 * numerator + (*s - '0');
        denominator *= 10;
    }
    *seconds += numerator / denominator;
    return s;
}

static const char *skip_zone(const char *s)
{
    static const long hours[2] = {0, 14};
    static const long minutes[2] = {0, 59};
    long unused;

    if (*s == 'Z') {
        return s + 1;
    }
    if (*s != '+' && *s != '-') {
        return s;
    }
    s = read_digits(s + 1, 2, hours, ':', &unused);
    return s ? read_digits(s, 2, minutes, '\0', &unused) : NULL;
}

int clock_parse(const char *text, double *out)
{
    static const long hours[2] = {0, 23};
    static const long minutes[2] = {0, 59};
    static const long seconds[2] = {0, 60}; /* a leap second */
    long hour;
    long minute;
    long second;
    double days;
    const char *s = read_date(text, &days);

    s = s ? read_digits(s, 2, hours, ':', &hour) : NULL;
    s = s ? read_digits(s, 2, minutes, ':', &minute) : NULL;
    s = s ? read_digits(s, 2, seconds, '\0', &second) : NULL;
    if (!s) {
        return 0;
    }
    double time = 86400 * days + 3600 * (double)hour + 60 * (double)minute + (double)second;
    s = read_fraction(s, &time);
    s = skip_zone(s);
    if (!s || *s != '\0') {
        return 0;
    }
    *out = time;
    return 1;
}
