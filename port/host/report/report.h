/* SPDX-License-Identifier: MIT
 *
 * report/report.h: the report of a calibration, one HTML page (page.h).
 */
#ifndef REPORT_H
#define REPORT_H

#include "result/result.h"

/* Writes the page. Returns EXIT_GOOD; EXIT_FILE, with a message, without memory. Write errors show
 * in ferror(file). */
int report_write(FILE *file, const calibrate_result *result,
                 const calibrate_invocation *invocation);

/* The page about data that were refused: what is missing, where the positions lie, which to add.
 * Returns as above. */
int report_refusal(FILE *file, const calibrate_result *result,
                   const calibrate_invocation *invocation);

#endif
