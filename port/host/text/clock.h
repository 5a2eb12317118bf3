/* SPDX-License-Identifier: MIT
 *
 * text/clock.h: times of the day, as loggers write them.
 */
#ifndef CLOCK_H
#define CLOCK_H

/* Reads [YYYY-MM-DD(T or blank)]HH:MM:SS[.digits][Z or +-HH:MM], the whole text, and no other. Seconds since midnight;
 * with a date since 1970, as the clock shows them: the zone, which is the same in all lines, is left aside.
 *
 * Returns 1; 0, out untouched, if it is no such time. */
int clock_parse(const char *text, double *out);

#endif
