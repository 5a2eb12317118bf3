/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "text/paint.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* See no-color.org. Without TERM it is unknown whether the terminal supports colours. */
static int is_wanted(FILE *file)
{
    const char *no = getenv("NO_COLOR");
    const char *terminal = getenv("TERM");

    return !(no && *no != '\0') && terminal && *terminal != '\0' && strcmp(terminal, "dumb") != 0 &&
           isatty(fileno(file));
}

const char *paint_on(FILE *file, paint which)
{
    static const char *const sequence[] = {
        [PAINT_BOLD] = "\033[1m",
        [PAINT_GREEN] = "\033[1;32m",
        [PAINT_YELLOW] = "\033[1;33m",
        [PAINT_RED] = "\033[1;31m",
    };
    return is_wanted(file) ? sequence[which] : "";
}

const char *paint_off(FILE *file)
{
    return is_wanted(file) ? "\033[0m" : "";
}
