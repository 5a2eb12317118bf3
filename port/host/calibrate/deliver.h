/* SPDX-License-Identifier: MIT
 *
 * calibrate/deliver.h: writes the result: table or JSON on stdout, CAL.json, the report.
 */
#ifndef CALIBRATE_DELIVER_H
#define CALIBRATE_DELIVER_H

#include "calibrate/request.h"
#include "result/result.h"

/* Writes a calibration. The files get their names only after everything has been written. Returns
 * EXIT_GOOD; EXIT_FILE after a message. */
int deliver(const request *r, const calibrate_result *result);

/* Writes why data were refused: a line on stderr, JSON, the report; no calibration. Returns
 * EXIT_DATA; EXIT_FILE after a message. */
int deliver_refusal(const request *r, const calibrate_result *result);

/* Writes one line of JSON for a log that could not be read, with the text of the last message. */
void deliver_unreadable(void);

#endif
