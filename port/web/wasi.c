/* SPDX-License-Identifier: MIT
 *
 * The tool in a browser: POSIX functions that wasi-libc lacks. Its files are in the memory of the
 * page, without permissions or symbolic links, in one folder. There is no terminal, so watch is
 * refused: the page has its own live calibration (live.c).
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

int live_read(positions *p, const char *path, const live_options *options, gyro_log *gyro,
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
              const live_options *options, magnetometer_log *out)
{
    (void)path;
    (void)nominal;
    (void)options;
    *p = (positions){0};
    memset(out, 0, sizeof *out);
    return refuse();
}
