/* SPDX-License-Identifier: MIT
 *
 * cli/command.h: the commands of the tool, and the exit codes.
 *
 * To add a command: one file that defines a `tool_command`, one line here, one in main.c's table.
 */
#ifndef COMMAND_H
#define COMMAND_H

#include "invcal/invcal.h"

#if !INVCAL_DOUBLE
#error "the host tool is compiled with -DINVCAL_DOUBLE=1"
#endif

/* Exit codes, which every function of the tool that can fail returns, too. The function that fails
 * prints the reason on stderr (message.h); callers only pass the code on. */
enum {
    EXIT_GOOD = 0,
    EXIT_DATA = 1,  /* the data cannot be calibrated */
    EXIT_USAGE = 2, /* the command line is wrong */
    EXIT_FILE = 3   /* input unreadable or malformed, or output not writable */
};

typedef struct {
    const char *name;
    const char *purpose;               /* one line for `invcal --help` */
    const char *const *help;           /* parts (help.h) of the text of `invcal NAME --help all` */
    int (*run)(int argc, char **argv); /* the arguments after NAME; returns an exit code */
    /* The same of `invcal NAME --help`, with the line about `--help all` at most 24 lines of 80
     * columns; null: `help` is short enough. */
    const char *const *brief;
} tool_command;

extern const tool_command calibrate_command;
extern const tool_command apply_command;
extern const tool_command export_command;
extern const tool_command allan_command;
extern const tool_command plan_command;
extern const tool_command compare_command;
extern const tool_command simulate_command;
extern const tool_command watch_command;

#endif
