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
static unsigned terminal_lines(FILE *out)
{
    struct winsize size;

    return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_row > CANVAS_LINES &&
                   size.ws_col > CANVAS_COLUMNS
               ? size.ws_row
               : 0;
}

int screen_is_possible(FILE *out)
{
    const char *terminal = getenv("TERM");

    return out == stdout && isatty(fileno(out)) && terminal && *terminal != '\0' &&
           strcmp(terminal, "dumb") != 0 && strcmp(terminal, "linux") != 0 &&
           terminal_lines(out) > 0;
}

/* In one write, unless a signal comes between. */
static void write_all(FILE *out, const char *text)
{
    size_t left = strlen(text);

    fflush(out);
    while (left > 0) {
        const ssize_t written = write(fileno(out), text, left);
        if (written < 0 && errno != EINTR) {
            return; /* the output at the end reports the error */
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
    int has_rung;   /* for the current rest */
    int is_good;    /* has been reported */
} bell;

/* A bell for each important event, since the user looks at the device. */
static void update_bell(const watch_state *now, watch_event event)
{
    const int is_ready = now->phase == WATCH_READY && !now->is_refused && !bell.has_rung;
    const int is_good = now->is_good && !bell.is_good;

    bell.is_ringing = bell.is_ringing || is_ready || is_good || event == WATCH_REFUSED;
    bell.has_rung = event != WATCH_TAKEN && event != WATCH_REFUSED && (bell.has_rung || is_ready);
    bell.is_good = now->is_good;
}

static void draw(const watch_state *now)
{
    static char frame[CANVAS_BYTES];
    static char text[CANVAS_BYTES + 64];

    snprintf(text, sizeof text, HIDE_CURSOR HOME "%s" CLEAR_BELOW SHOW_CURSOR "%s",
             terminal_lines(now->out) > 0
                 ? frame_print(now, CLEAR_LINE "\n", frame)
                 : "the window is too small: 80 columns and 24 lines are needed" CLEAR_LINE "\n",
             bell.is_ringing ? "\a" : "");
    write_all(now->out, text);
    bell.is_ringing = 0;
}

/* Scrolls the present contents up, so that they are not overwritten. */
static void begin(FILE *out)
{
    memset(&bell, 0, sizeof bell);
    for (unsigned i = terminal_lines(out); i > 0; i--) {
        fputc('\n', out);
    }
    write_all(out, HOME CLEAR_BELOW);
}

void screen_update(const watch_state *now, watch_event event)
{
    if (event == WATCH_BEGUN) {
        begin(now->out);
    }
    update_bell(now, event);
    if (event == WATCH_TICK || event == WATCH_ENDED) {
        draw(now);
    }
    if (event == WATCH_ENDED && *now->missing) {
        fprintf(now->out, "positions of the program not visited: %s\n", now->missing);
    }
    if (event == WATCH_ENDED) {
        fprintf(now->out, "\n");
    }
}
