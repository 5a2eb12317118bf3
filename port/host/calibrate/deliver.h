/* SPDX-License-Identifier: MIT
 *
 * calibrate/deliver.h: the result to where it is wanted: a table or JSON, a file, a page.
 */
#ifndef CALIBRATE_DELIVER_H
#define CALIBRATE_DELIVER_H

#include "calibrate/request.h"
#include "result/result.h"

/* The files appear only after all else has been written. Returns EXIT_GOOD; EXIT_FILE after a message. */
int deliver(const request *r, const calibrate_result *result);

/* What was refused: a line on stderr, JSON, a page; no calibration. Returns EXIT_DATA; EXIT_FILE after a message. */
int deliver_refusal(const request *r, const calibrate_result *result);

/* A log that could not be read, as a line of JSON: what the last message said. */
void deliver_unreadable(void);

#endif
