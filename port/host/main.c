/* SPDX-License-Identifier: MIT
 *
 * invcal: the host tool. Finds the command and hands over to it.
 */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/nearest.h"
#include "cli/output.h"

static const tool_command *const commands[] = {
    &calibrate_command, &apply_command,    &export_command, &allan_command,
    &plan_command,      &simulate_command, &watch_command,
};

#define COMMANDS (sizeof commands / sizeof commands[0])

/* A standard stream that is closed would lend its number to the next file that is opened, and
 * results would go into that. Each gets a stand-in that fails when it is used. */
static void guard_streams(void)
{
    static const int wrong_way[] = {O_WRONLY, O_RDONLY, O_WRONLY};

    for (int fd = 0; fd < 3; fd++) {
        if (fcntl(fd, F_GETFD) == -1) {
            (void)open("/dev/null", wrong_way[fd]);
        }
    }
    /* A reader that goes away is a failed write, not the end of us: files are to be removed. */
    signal(SIGPIPE, SIG_IGN);
}

static void print_help(void)
{
    puts("usage: invcal COMMAND ...\n"
         "\n"
         "Calibrates accelerometer triads from rest positions, by gravity alone.\n");
    for (unsigned i = 0; i < COMMANDS; i++) {
        printf("  %-12s%s\n", commands[i]->name, commands[i]->purpose);
    }
    puts("\n"
         "  invcal COMMAND --help   what it does, its options, an example\n"
         "  invcal --version        the version\n"
         "\n"
         "exit codes: 0 good, of a calibration whatever the verdict (calibrate --strict: only if "
         "that\n"
         "is good); 1 the data cannot be calibrated; 2 usage; 3 input unreadable or malformed, or\n"
         "output not writable");
}

static const tool_command *find_command(const char *name)
{
    for (unsigned i = 0; i < COMMANDS; i++) {
        if (strcmp(commands[i]->name, name) == 0) {
            return commands[i];
        }
    }
    return NULL;
}

/* `--help` anywhere before a `--`. */
static int asks_help(int argc, char **argv)
{
    for (int i = 0; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            return 1;
        }
    }
    return 0;
}

static int run_command(const tool_command *c, int argc, char **argv)
{
    if (!asks_help(argc, argv)) {
        return c->run(argc, argv);
    }
    for (const char *const *part = c->help; *part; part++) {
        fputs(*part, stdout);
    }
    return EXIT_GOOD;
}

static int refuse_unknown(const char *word)
{
    nearest meant = nearest_begin(word, strlen(word));
    char hint[NEAREST_TEXT_MAX];

    for (unsigned i = 0; i < COMMANDS; i++) {
        nearest_offer(&meant, commands[i]->name);
    }
    nearest_offer(&meant, "--help");
    nearest_offer(&meant, "--version");
    return message_usage(NULL, "%s: unknown %s%s", word, word[0] == '-' ? "option" : "command",
                         nearest_text(&meant, hint));
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        return message_usage(NULL, "COMMAND is missing");
    }
    const tool_command *c = find_command(argv[1]);
    if (c) {
        return run_command(c, argc - 2, argv + 2);
    }
    const int is_help = strcmp(argv[1], "--help") == 0;
    if (!is_help && strcmp(argv[1], "--version") != 0) {
        return refuse_unknown(argv[1]);
    }
    if (argc > 2) {
        return message_usage(NULL, "'%s': one operand too many", argv[2]);
    }
    if (is_help) {
        print_help();
    } else {
        puts("invcal " INVCAL_VERSION);
    }
    return EXIT_GOOD;
}

int main(int argc, char **argv)
{
    guard_streams();
    const int code = run(argc, argv);
    const int printed = code == EXIT_GOOD || code == EXIT_DATA ? output_flush() : EXIT_GOOD;
    return printed == EXIT_GOOD ? code : printed;
}
