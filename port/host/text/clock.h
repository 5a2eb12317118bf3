/* SPDX-License-Identifier: MIT
 *
 * text/clock.h: times of day and dates, as loggers write them.
 */
#ifndef CLOCK_H
#define CLOCK_H

/* Parses a text [YYYY-MM-DD(T or blank)]HH:MM:SS[.digits][Z or +-HH:MM]. Seconds since midnight, or
 * with a date since 1970, of the local clock: the zone, which is the same in all lines, is ignored.
 *
 * Returns 1; 0, with out untouched, if it is not such a text. */
int clock_parse(const char *text, double *out);

#endif
