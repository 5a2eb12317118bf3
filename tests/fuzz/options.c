/* SPDX-License-Identifier: MIT
 *
 * Any command lines. Every line is an argument; standard input follows an empty line. Arguments may name
 * the files of tool.c, and write others next to them.
 * fuzz: at least 5 inputs a second
 */
#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tool.h"

enum { ARGUMENTS_MOST = 40, TEXT_MOST = 2048 };

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    tool_begin();
    return 0;
}

/* No paths: only units and /dev/null may contain a slash. */
static void disarm(char *argument)
{
    static const char *const good[] = {"m/s2", "m/s^2", "/dev/null"};
    const char *value = strchr(argument, '=');

    for (unsigned i = 0; i < sizeof good / sizeof good[0]; i++) {
        if (strcmp(value ? value + 1 : argument, good[i]) == 0) {
            return;
        }
    }
    for (char *c = argument; *c != '\0'; c++) {
        *c = *c == '/' ? '_' : *c;
    }
}

/* Is it one of the files that tool.c made? */
static int is_kept(const char *name)
{
    static const char *const kept[] = {"log.csv",       "rest.csv",       "cal.json",
                                       "noise.json",    "thermal.csv",    "slopes.json",
                                       "positions.csv", "directions.csv", "stand.csv"};

    for (unsigned i = 0; i < sizeof kept / sizeof kept[0]; i++) {
        if (strcmp(name, kept[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

static void remove_others(void)
{
    DIR *folder = opendir(".");

    for (struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        if (!is_kept(e->d_name)) {
            (void)unlink(e->d_name); /* . and .. stay */
        }
    }
    if (folder) {
        closedir(folder);
    }
}

/* Would one of them be written? The next input needs it as it is. */
static int spoils(int argc, char **argv)
{
    static const char *const writes[] = {"--out", "--report", "--svg", "--truth"};

    for (int i = 2; i < argc; i++) {
        for (unsigned k = 0; k < sizeof writes / sizeof writes[0]; k++) {
            const size_t length = strlen(writes[k]);
            const int is_joined =
                strncmp(argv[i], writes[k], length) == 0 && argv[i][length] == '=';
            if ((is_joined && is_kept(argv[i] + length + 1)) ||
                (strcmp(argv[i - 1], writes[k]) == 0 && is_kept(argv[i]))) {
                return 1;
            }
        }
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char name[] = "invcal";
    char text[TEXT_MOST + 1];
    char *argv[ARGUMENTS_MOST + 2] = {name};
    const size_t length = size < TEXT_MOST ? size : TEXT_MOST;
    int argc = 1;
    char *at = text;

    memcpy(text, data, length);
    text[length] = '\0';
    while (*at != '\0' && *at != '\n' && argc <= ARGUMENTS_MOST) {
        char *end = strchr(at, '\n');
        argv[argc++] = at;
        at = end ? end + 1 : at + strlen(at);
        if (end) {
            *end = '\0';
        }
        disarm(argv[argc - 1]);
    }
    const size_t used = (size_t)(at - text) + (*at == '\n');
    if (spoils(argc, argv)) {
        return -1;
    }
    tool_run(argc, argv, data + used, size - used);
    remove_others();
    return 0;
}
