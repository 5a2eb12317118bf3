/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/screen.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "watch/frame.h"

/* Lines of the terminal; 0 if it is too small, or it is unknown. */
static unsigned lines_of(FILE *talk)
{
    struct winsize size;

    return ioctl(fileno(talk), TIOCGWINSZ, &size) == 0 && size.ws_row > CANVAS_LINES &&
                   size.ws_col > CANVAS_COLUMNS
               ? size.ws_row
               : 0;
}

int screen_is_possible(FILE *talk)
{
    const char *terminal = getenv("TERM");

    return talk == stdout && isatty(fileno(talk)) && terminal && *terminal != '\0' &&
           strcmp(terminal, "dumb") != 0 && strcmp(terminal, "linux") != 0 && lines_of(talk) > 0;
}

/* In one write, unless a signal comes between. */
static void put_out(FILE *talk, const char *text)
{
    size_t left = strlen(text);

    fflush(talk);
    while (left > 0) {
        const ssize_t written = write(fileno(talk), text, left);
        if (written < 0 && errno != EINTR) {
            return; /* what is printed at the end says so */
        }
        text += written > 0 ? written : 0;
        left -= written > 0 ? (size_t)written : 0;
    }
}

#define HOME "\033[H"
#define CLEAR_LINE "\033[K"
#define CLEAR_BELOW "\033[J"
#define HIDE_CURSOR "\033[?25l"
#define SHOW_CURSOR "\033[?25h"

static struct {
    int is_ringing; /* with the next frame */
    int has_rung;   /* for the rest that goes on */
    int is_good;    /* has been reported */
} told;

/* A bell for each turn of things: the person looks at the device. */
static void listen(const watch_state *now, watch_news what)
{
    const int is_ready = now->phase == WATCH_READY && !now->is_refused && !told.has_rung;
    const int is_good = now->is_good && !told.is_good;

    told.is_ringing = told.is_ringing || is_ready || is_good || what == WATCH_REFUSED;
    told.has_rung = what != WATCH_TAKEN && what != WATCH_REFUSED && (told.has_rung || is_ready);
    told.is_good = now->is_good;
}

static void draw(const watch_state *now)
{
    static char frame[CANVAS_BYTES];
    static char text[CANVAS_BYTES + 64];

    snprintf(text, sizeof text, HIDE_CURSOR HOME "%s" CLEAR_BELOW SHOW_CURSOR "%s",
             lines_of(now->talk) > 0
                 ? frame_print(now, CLEAR_LINE "\n", frame)
                 : "the window is too small: 80 columns and 24 lines are needed" CLEAR_LINE "\n",
             told.is_ringing ? "\a" : "");
    put_out(now->talk, text);
    told.is_ringing = 0;
}

/* What stood on the screen is scrolled up, not drawn upon. */
static void begin(FILE *talk)
{
    memset(&told, 0, sizeof told);
    for (unsigned i = lines_of(talk); i > 0; i--) {
        fputc('\n', talk);
    }
    put_out(talk, HOME CLEAR_BELOW);
}

void screen_tell(const watch_state *now, watch_news what)
{
    if (what == WATCH_BEGUN) {
        begin(now->talk);
    }
    listen(now, what);
    if (what == WATCH_PASSED || what == WATCH_ENDED) {
        draw(now);
    }
    if (what == WATCH_ENDED && *now->missing) {
        fprintf(now->talk, "positions of the program not visited: %s\n", now->missing);
    }
    if (what == WATCH_ENDED) {
        fprintf(now->talk, "\n");
    }
}
