/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "watch/interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include "cli/input.h"

/* The stream, and an empty file that replaces it after an interrupt. */
static volatile sig_atomic_t stream_file;
static volatile sig_atomic_t empty_file;

/* A blocked read is interrupted and ends the stream, see table.c; any later one is at the end of
 * file. */
static void stop(int signal_number)
{
    (void)signal_number;
    if (empty_file >= 0 && stream_file >= 0) {
        (void)dup2(empty_file, stream_file);
    }
}

void interrupt_catch(const char *path)
{
    struct sigaction action = {.sa_handler = stop};

    stream_file = input_is_stdin(path) ? STDIN_FILENO : -1;
    empty_file = open("/dev/null", O_RDONLY);
    sigemptyset(&action.sa_mask);
    action.sa_flags = (int)SA_RESETHAND;
    (void)sigaction(SIGINT, &action, NULL);
    (void)sigaction(SIGTERM, &action, NULL);
}

void interrupt_stream(FILE *file)
{
    stream_file = file ? fileno(file) : -1;
}
