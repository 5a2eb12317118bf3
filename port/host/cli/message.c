/* SPDX-License-Identifier: MIT */
#include "cli/message.h"

#include <stdarg.h>
#include <stdio.h>

#include "cli/command.h"
#include "text/paint.h"
#include "text/plain.h"
#include "cli/progress.h"

static char last[MESSAGE_MAX];

/* File names and input may hold control characters, which must not reach the terminal. The progress
 * bar is cleared first. */
static void print_line(char *text, const char *tail)
{
    snprintf(last, sizeof last, "%s", plain(text));
    progress_end();
    fprintf(stderr, "%sinvcal:%s %s%s\n", paint_on(stderr, PAINT_RED), paint_off(stderr), last,
            tail);
}

const char *message_last(void)
{
    return last;
}

void message(const char *format, ...)
{
    char text[MESSAGE_MAX];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    print_line(text, "");
}

int message_usage(const char *command, const char *format, ...)
{
    char text[MESSAGE_MAX];
    char tail[64];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(tail, sizeof tail, "; see invcal%s%s --help", command ? " " : "",
             command ? command : "");
    print_line(text, tail);
    return EXIT_USAGE;
}
