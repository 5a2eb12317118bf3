/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "cli/progress.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define EVERY 32768u /* rows; a power of two, since every row asks */
#define WIDTH 30     /* of the bar */
#define TEXT_MAX 100

static int is_quiet;
static char shown[TEXT_MAX]; /* what stands on the line, empty: nothing */

/* How much of the file has been read, 0 ... 1; below 0 if it has no end that is known. */
static double share(FILE *file)
{
    struct stat status;
    const long at = ftell(file);

    if (fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode) || at < 0 ||
        status.st_size <= 0) {
        return -1;
    }
    return (double)at / (double)status.st_size;
}

void progress_quiet(void)
{
    is_quiet = 1;
}

/* The new text over the old one, in one piece and only if it differs: so nothing flickers. */
static void renew(const char *text)
{
    const size_t length = strlen(text);
    const size_t old = strlen(shown);

    if (strcmp(text, shown) != 0) {
        fprintf(stderr, "\r%s%*s", text, old > length ? (int)(old - length) : 0, "");
        memcpy(shown, text, length + 1);
    }
}

static void draw(FILE *file, unsigned long line, unsigned found)
{
    char text[TEXT_MAX];
    char positions[TEXT_MAX / 3] = "";
    const double done = share(file);

    if (found != PROGRESS_ROWS) {
        snprintf(positions, sizeof positions, ", %u position%s", found, found == 1 ? "" : "s");
    }
    if (done >= 0) {
        const int full = (int)(done * WIDTH);
        snprintf(text, sizeof text, "[%.*s%*s] %3.0f %%%s", full, "##############################",
                 WIDTH - full, "", 100 * done, positions);
    } else {
        snprintf(text, sizeof text, "%lu lines%s", line, positions);
    }
    renew(text);
}

void progress_show(FILE *file, unsigned long line, unsigned found)
{
    if (line % EVERY == 0 && !is_quiet && isatty(STDERR_FILENO)) {
        draw(file, line, found);
    }
}

void progress_end(void)
{
    if (shown[0] != '\0') {
        renew("");
        fputc('\r', stderr);
    }
}
