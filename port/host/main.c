/* SPDX-License-Identifier: MIT
 *
 * invcal: the host tool. Finds the command and runs it.
 */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/help.h"
#include "cli/message.h"
#include "text/nearest.h"
#include "cli/output.h"
#include "text/wrapped.h"

static const tool_command *const commands[] = {
    &calibrate_command, &apply_command,   &export_command,   &allan_command,
    &plan_command,      &compare_command, &simulate_command, &watch_command,
};

#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

/* If a standard stream is closed, the next file that is opened gets its descriptor, and the results
 * would go there. A closed stream is replaced by one that fails when it is used. */
static void guard_streams(void)
{
    static const int failing_mode[] = {O_WRONLY, O_RDONLY, O_WRONLY};

    for (int fd = 0; fd < 3; fd++) {
        if (fcntl(fd, F_GETFD) == -1) {
            (void)open("/dev/null", failing_mode[fd]);
        }
    }
    /* A closed pipe must be a failed write, not a signal: temporary files have to be removed. */
    signal(SIGPIPE, SIG_IGN);
}

static void print_help(void)
{
    static const char *const head[] = {"usage: invcal COMMAND ...\n"
                                       "\n"
                                       "Calibrates accelerometers, gyroscopes and magnetometers "
                                       "from logs.\n"
                                       "\n",
                                       NULL};
    static const char *const tail[] = {
        "\n"
        "exit codes: 0 done, whatever the verdict; 1 the data cannot be calibrated; 2 usage; 3\n"
        "input unreadable or malformed, or output not writable\n",
        NULL};

    help_print(stdout, head);
    for (unsigned i = 0; i < COMMAND_COUNT; i++) {
        wrapped_printf(stdout, 14, "  %-12s%s", commands[i]->name, commands[i]->purpose);
    }
    putchar('\n');
    wrapped_printf(stdout, 28, "  invcal COMMAND --help     purpose, common options, an example");
    wrapped_printf(stdout, 28, "  invcal COMMAND --help all all options, in detail");
    wrapped_printf(stdout, 28, "  invcal help COMMAND [all] the same");
    wrapped_printf(stdout, 28, "  invcal --version          the version");
    help_print(stdout, tail);
}

static const tool_command *find_command(const char *name)
{
    for (unsigned i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(commands[i]->name, name) == 0) {
            return commands[i];
        }
    }
    return NULL;
}

/* What `--help` or `--help all` asks for, anywhere before a `--`. */
typedef enum { NO_HELP, BRIEF_HELP, ALL_HELP } help_level;

static help_level requested_help(int argc, char **argv)
{
    for (int i = 0; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            return i + 1 < argc && strcmp(argv[i + 1], "all") == 0 ? ALL_HELP : BRIEF_HELP;
        }
        if (strcmp(argv[i], "--help=all") == 0) {
            return ALL_HELP;
        }
    }
    return NO_HELP;
}

static int print_help_of(const tool_command *c, help_level level)
{
    if (level == ALL_HELP || !c->brief) {
        help_print(stdout, c->help);
    } else {
        help_print(stdout, c->brief);
        printf("\nAll options, in detail: invcal %s --help all\n", c->name);
    }
    return EXIT_GOOD;
}

static int run_command(const tool_command *c, int argc, char **argv)
{
    const help_level level = requested_help(argc, argv);

    return level == NO_HELP ? c->run(argc, argv) : print_help_of(c, level);
}

static int refuse_unknown(const char *word)
{
    nearest meant = nearest_begin(word, strlen(word));
    char hint[NEAREST_TEXT_MAX];

    for (unsigned i = 0; i < COMMAND_COUNT; i++) {
        nearest_offer(&meant, commands[i]->name);
    }
    nearest_offer(&meant, "help");
    nearest_offer(&meant, "--help");
    nearest_offer(&meant, "--version");
    return message_usage(NULL, "%s: unknown %s%s", word, word[0] == '-' ? "option" : "command",
                         nearest_text(&meant, hint));
}

/* `invcal help`, `invcal help COMMAND`, `invcal help COMMAND all`. */
static int run_help(int argc, char **argv)
{
    const int is_all = argc > 1 && strcmp(argv[1], "all") == 0;

    if (argc == 0) {
        print_help();
        return EXIT_GOOD;
    }
    if (argc > 1 + is_all) {
        return message_usage(NULL, "'%s': one operand too many: help takes one command, and all",
                             argv[1 + is_all]);
    }
    const tool_command *c = find_command(argv[0]);
    return c ? print_help_of(c, is_all ? ALL_HELP : BRIEF_HELP) : refuse_unknown(argv[0]);
}

static int run(int argc, char **argv)
{
    if (argc < 2 || argv[1][0] == '\0') {
        return message_usage(NULL, "COMMAND is missing");
    }
    const tool_command *c = find_command(argv[1]);
    if (c) {
        return run_command(c, argc - 2, argv + 2);
    }
    if (strcmp(argv[1], "help") == 0) {
        return run_help(argc - 2, argv + 2);
    }
    const int is_help = strcmp(argv[1], "--help") == 0;
    if (!is_help && strcmp(argv[1], "--version") != 0) {
        return refuse_unknown(argv[1]);
    }
    if (argc > 2) {
        return message_usage(NULL, "'%s': one operand too many: %s stands alone", argv[2], argv[1]);
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
