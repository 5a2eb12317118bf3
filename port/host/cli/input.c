/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "cli/input.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

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
    FILE *file = input_is_stdin(path) ? stdin : fopen(path, "rb");

    if (!file) {
        message("%s: cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    /* A directory can be opened; only reading from it fails, and not in plain words. */
    if (fstat(fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
        message("%s: is a directory: state a file in it", input_name(path));
        input_close(file);
        return NULL; /* NOLINT(clang-analyzer-unix.Stream): closed, unless it is stdin */
    }
    return file;
}

void input_close(FILE *file)
{
    if (file && file != stdin) {
        fclose(file);
    }
}
