/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "cli/input.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/message.h"

int input_is_stdin(const char *path)
{
    return strcmp(path, "-") == 0;
}

const char *input_name(const char *path)
{
    return input_is_stdin(path) ? "standard input" : path;
}

const char *input_file_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash && slash[1] != '\0' ? slash + 1 : path;
}

FILE *input_open(const char *path)
{
    struct stat status;
    const int is_stdin = input_is_stdin(path);
    const int missing = is_stdin ? fstat(STDIN_FILENO, &status) : stat(path, &status);

    /* A directory can be opened; only reading from it fails, with an unclear message. */
    if (missing == 0 && S_ISDIR(status.st_mode)) {
        message("%s: is a directory: name a file in it", input_name(path));
        return NULL;
    }
    FILE *file = is_stdin ? stdin : fopen(path, "rb");
    if (!file) {
        message("%s: cannot be read: %s", path, strerror(errno));
    }
    return file;
}

void input_close(FILE *file)
{
    if (file && file != stdin) {
        fclose(file);
    }
}
