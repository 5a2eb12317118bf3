/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "cli/progress.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define INTERVAL 32768u /* lines; a power of two, as it is checked at each line */
#define BAR_WIDTH 30
#define TEXT_MAX 100

static int is_quiet;
static char shown[TEXT_MAX]; /* the text on the terminal's line; empty: none */

/* The part of the file that has been read, 0 ... 1; negative if its size is unknown. */
static double fraction_read(FILE *file)
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

/* Overwrites the old text in a single write, and only if it differs, to avoid flicker. */
static void redraw(const char *text)
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
    const double fraction = fraction_read(file);

    if (found != PROGRESS_ROWS) {
        snprintf(positions, sizeof positions, ", %u position%s", found, found == 1 ? "" : "s");
    }
    if (fraction >= 0) {
        const int full = (int)(fraction * BAR_WIDTH);
        snprintf(text, sizeof text, "[%.*s%*s] %3.0f %%%s", full, "##############################",
                 BAR_WIDTH - full, "", 100 * fraction, positions);
    } else {
        snprintf(text, sizeof text, "%lu lines%s", line, positions);
    }
    redraw(text);
}

void progress_show(FILE *file, unsigned long line, unsigned found)
{
    if (line % INTERVAL == 0 && !is_quiet && isatty(STDERR_FILENO)) {
        draw(file, line, found);
    }
}

void progress_end(void)
{
    if (shown[0] != '\0') {
        redraw("");
        fputc('\r', stderr);
    }
}
