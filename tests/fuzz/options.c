/* SPDX-License-Identifier: MIT
 *
 * Command lines that may be anything. Every line is an argument; behind an empty line there is the
 * standard input. Arguments may name the files of tool.c, and write others beside them.
 * fuzz: at least 5 inputs a second
 */
#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tool.h"

enum { ARGUMENTS_MOST = 24, TEXT_MOST = 2048 };

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    tool_begin();
    return 0;
}

/* Paths lead nowhere: units and /dev/null are all that may have a slash. */
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

/* Everything but the files of tool.c, which are read-only. */
static void remove_others(void)
{
    static const char *const keep[] = {
        ".",          "..",          "log.csv",     "rest.csv",      "cal.json",
        "noise.json", "thermal.csv", "slopes.json", "positions.csv", "directions.csv"};
    DIR *folder = opendir(".");

    for (struct dirent *e = folder ? readdir(folder) : NULL; e; e = readdir(folder)) {
        unsigned i = 0;
        while (i < sizeof keep / sizeof keep[0] && strcmp(e->d_name, keep[i]) != 0) {
            i++;
        }
        if (i == sizeof keep / sizeof keep[0]) {
            unlink(e->d_name);
        }
    }
    if (folder) {
        closedir(folder);
    }
}

/* Is there an option that writes, which names a file of tool.c? The next input needs that. */
static int spoils(int argc, char **argv)
{
    for (int i = 2; i < argc; i++) {
        const size_t length = strlen(argv[i]);
        const int names = length > 4 && (strcmp(argv[i] + length - 4, ".csv") == 0 ||
                                         strcmp(argv[i] + length - 5, ".json") == 0);
        const char *option = strncmp(argv[i], "--", 2) == 0 ? argv[i] : argv[i - 1];
        if (names && (strncmp(option, "--out", 5) == 0 || strncmp(option, "--report", 8) == 0 ||
                      strncmp(option, "--svg", 5) == 0 || strncmp(option, "--truth", 7) == 0)) {
            return 1;
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
