/* SPDX-License-Identifier: MIT
 *
 * The tool in a browser: what wasi-libc has not. Its files lie in the memory of the page: they have no
 * permissions, no symbolic links, and one folder. There is no terminal, either, so watch has nothing to read
 * from: the page leads through a live calibration itself (live.c).
 */
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "watch/live.h"
#include "watch/wave.h"

int fchmod(int file, mode_t mode)
{
    (void)file;
    (void)mode;
    return 0;
}

char *realpath(const char *path, char *resolved)
{
    return resolved ? strcpy(resolved, path) : strdup(path);
}

FILE *tmpfile(void)
{
    return fopen(".spool", "w+b");
}

static int refuse(void)
{
    return message_usage("watch", "there is no terminal in a browser: calibrate live on the page");
}

int live_read(positions *p, const char *path, const live_options *options, turns *gyro,
              rests_summary *summary)
{
    (void)path;
    (void)options;
    (void)gyro;
    *p = (positions){0};
    memset(summary, 0, sizeof *summary);
    return refuse();
}

int wave_read(positions *p, const char *path, const invcal_calibration *nominal,
              const live_options *options, waved *out)
{
    (void)path;
    (void)nominal;
    (void)options;
    *p = (positions){0};
    memset(out, 0, sizeof *out);
    return refuse();
}
