/* SPDX-License-Identifier: MIT
 *
 * tell.h: the messages to the user, lines on the UART.
 */
#ifndef TELL_H
#define TELL_H

#include "invcal/invcal.h"

/* "what: text" and "what: count". */
void tell(const char *what, const char *text);
void tell_count(const char *what, unsigned count);

/* Where to turn next. */
void tell_next(const invcal_session *session);

/* What a sample brought about. */
void tell_event(const invcal_session *session, invcal_event event);

/* The calibration, and what it says of the sensor against nominal. */
void tell_calibration(const invcal_calibration *calibration, const invcal_calibration *nominal,
                      const invcal_quality *quality);

/* A calibrated reading, g, and its length. */
void tell_reading(const invcal_real a[3]);

#endif
