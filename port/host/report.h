/* SPDX-License-Identifier: MIT
 *
 * report.h: a calibration as a page that tells what it is worth (page.h).
 */
#ifndef REPORT_H
#define REPORT_H

#include "calibrate.h"

/* What the page cannot know from the result. */
typedef struct {
    const char *nominal_name;
    const char *saved;   /* the file that the calibration goes to, or null */
    const char *command; /* the command line */
} report_wish;

/* Writes the page. EXIT_GOOD; EXIT_FILE, with a message, without memory. Write errors show in
 * ferror(file). */
int report_write(FILE *file, const calibrate_result *result, const report_wish *wish);

#endif
