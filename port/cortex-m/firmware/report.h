/* SPDX-License-Identifier: MIT
 *
 * report.h: messages to the user, lines on the UART.
 */
#ifndef REPORT_H
#define REPORT_H

#include "invcal/invcal.h"

/* "what: text" and "what: count". */
void report(const char *what, const char *text);
void report_count(const char *what, unsigned count);

/* Where to turn next. */
void report_next(const invcal_session *session);

/* The event of a sample. */
void report_event(const invcal_session *session, invcal_event event);

/* The calibration, and the errors of the sensor against nominal. */
void report_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal,
                        const invcal_quality *quality);

/* A calibrated reading, g, and its length. */
void report_reading(const invcal_real a[3]);

#endif
