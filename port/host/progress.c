/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <sys/stat.h>
#include <unistd.h>

#define EVERY 20000u /* rows */
#define WIDTH 30     /* of the bar */

static int is_shown;

/* How much of the file has been read, 0 ... 1; below 0 if it has no end that is known. */
static double share(const table *t)
{
    struct stat status;
    const long at = ftell(t->file);

    if (fstat(fileno(t->file), &status) != 0 || !S_ISREG(status.st_mode) || at < 0 ||
        status.st_size <= 0) {
        return -1;
    }
    return (double)at / (double)status.st_size;
}

void progress_show(const table *t, unsigned found)
{
    if (t->line % EVERY != 0 || !isatty(STDERR_FILENO)) {
        return;
    }
    const double done = share(t);
    is_shown = 1;
    if (done >= 0) {
        const int full = (int)(done * WIDTH);
        fprintf(stderr, "\r[%.*s%*s] %3.0f %%", full, "##############################",
                WIDTH - full, "", 100 * done);
    } else {
        fprintf(stderr, "\r%lu lines", t->line);
    }
    fprintf(stderr, ", %u position%s ", found, found == 1 ? "" : "s");
    fflush(stderr);
}

void progress_end(void)
{
    if (is_shown) {
        fprintf(stderr, "\r%60s\r", "");
        fflush(stderr);
        is_shown = 0;
    }
}
