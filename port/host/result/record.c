/* SPDX-License-Identifier: MIT */
#include "result/record.h"

#include <string.h>

#include "text/utf8.h"

const char *record_name(record_text which)
{
    static const char *const names[RECORD_TEXTS] = {"device", "serial", "operator", "date", "note"};

    return names[which];
}

/* `count` digits from `at` on as a number; -1 if one of them is not a digit. */
static int digits(const char *text, unsigned at, unsigned count)
{
    int number = 0;

    for (unsigned i = at; i < at + count; i++) {
        if (text[i] < '0' || text[i] > '9') {
            return -1;
        }
        number = 10 * number + (text[i] - '0');
    }
    return number;
}

/* A day of the Gregorian calendar, written 2026-11-23. */
static int is_date(const char *text)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

    if (strlen(text) != 10 || text[4] != '-' || text[7] != '-') {
        return 0;
    }
    const int year = digits(text, 0, 4);
    const int month = digits(text, 5, 2);
    const int day = digits(text, 8, 2);
    const int is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    return year >= 0 && month >= 1 && month <= 12 && day >= 1 &&
           day <= days[month - 1] + (month == 2 && is_leap);
}

/* UTF-8 without control characters (C1 is C2 80 ... C2 9F), which looks the same on a terminal, on
 * a page and in JSON. */
static int is_plain(const char *text)
{
    while (*text != '\0') {
        const unsigned char first = (unsigned char)text[0];
        const unsigned length = utf8_length(text);
        if (length == 0 || first < ' ' || first == 0x7f ||
            (first == 0xc2 && (unsigned char)text[1] < 0xa0)) {
            return 0;
        }
        text += length;
    }
    return 1;
}

const char *record_set(record *r, record_text which, const char *text)
{
    if (strlen(text) >= RECORD_MAX) {
        return "is too long: the maximum is 159 bytes";
    }
    if (!is_plain(text)) {
        return "is not plain UTF-8 text: remove control characters";
    }
    if (which == RECORD_DATE && !is_date(text)) {
        return "is not a date: write it like 2026-11-23";
    }
    memcpy(r->text[which], text, strlen(text) + 1);
    return NULL;
}

int record_is_empty(const record *r)
{
    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        if (*r->text[k] != '\0') {
            return 0;
        }
    }
    return 1;
}

void record_json(json_writer *w, const record *r)
{
    if (record_is_empty(r)) {
        return;
    }
    json_object(w, "record");
    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        if (*r->text[k] != '\0') {
            json_text(w, record_name((record_text)k), r->text[k]);
        }
    }
    json_object_end(w);
}

const char *record_line(const record *r, char text[RECORD_LINE_MAX])
{
    static const record_text shown[] = {RECORD_DEVICE, RECORD_SERIAL, RECORD_DATE};

    text[0] = '\0';
    for (unsigned k = 0; k < 3; k++) {
        const char *more = r->text[shown[k]];
        const size_t length = strlen(text);
        if (*more != '\0') {
            snprintf(text + length, RECORD_LINE_MAX - length, "%s%s%s", length > 0 ? " · " : "",
                     shown[k] == RECORD_SERIAL ? "serial " : "", more);
        }
    }
    return text;
}
