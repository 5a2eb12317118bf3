/* SPDX-License-Identifier: MIT
 *
 * result/record.h: the record of a calibration: which device, when, by whom.
 */
#ifndef RECORD_H
#define RECORD_H

#include "text/json_write.h"

typedef enum {
    RECORD_DEVICE, /* its type */
    RECORD_SERIAL,
    RECORD_OPERATOR,
    RECORD_DATE, /* 2026-11-23, so that dates sort as texts */
    RECORD_NOTE,
    RECORD_TEXTS
} record_text;

#define RECORD_MAX 160 /* bytes of a text, with the terminating zero */

/* The options, for help texts. */
#define RECORD_OPTIONS                                                                             \
    "  --device TEXT       type of the device; like the next four, it is recorded in\n"            \
    "                      CAL.json, table and page\n"                                             \
    "  --serial TEXT       its serial number, by which invcal compare recognises it\n"             \
    "  --operator TEXT     who calibrated it\n"                                                    \
    "  --date YYYY-MM-DD   date of the calibration\n"                                              \
    "  --note TEXT         any remark\n"

/* A text that is not given is "". */
typedef struct {
    char text[RECORD_TEXTS][RECORD_MAX];
} record;

/* "device", "serial", "operator", "date", "note". */
const char *record_name(record_text which);

/* Sets a text. Returns null; or what is wrong with it, a clause to follow it, the record untouched:
 * too long, not plain UTF-8 text, not a valid date. */
const char *record_set(record *r, record_text which, const char *text);

int record_is_empty(const record *r);

/* Writes the member "record", with the texts that are given, if any. */
void record_json(json_writer *w, const record *r);

/* A line for headings: "ADXL355 · serial 4711 · 2026-11-23"; "" if none of the three is given. Cut
 * to size. Returns text. */
#define RECORD_LINE_MAX (3 * RECORD_MAX + 32)
const char *record_line(const record *r, char text[RECORD_LINE_MAX]);

#endif
