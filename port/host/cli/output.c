/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with realpath */
#include "cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/message.h"

/* If a write had failed before, errno is still its: nothing since then has failed. */
static int cannot_write(const char *what)
{
    message("%s: cannot be written: %s", what, strerror(errno ? errno : EIO));
    return EXIT_FILE;
}

/* Opens a new file beside o->path. If there is one already, the new one gets its mode. */
static FILE *open_beside(output *o, const struct stat *old)
{
    const size_t size = strlen(o->path) + 32;

    o->temporary = malloc(size);
    if (!o->temporary) {
        return NULL;
    }
    snprintf(o->temporary, size, "%s.tmp-%ld", o->path, (long)getpid());
    const int fd = open(o->temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    FILE *file = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (!file) {
        if (fd >= 0) {
            close(fd);
            unlink(o->temporary);
        }
        free(o->temporary); /* what is there under this name is not ours */
        o->temporary = NULL;
    } else if (old) {
        (void)fchmod(fd, old->st_mode & 0777);
    }
    return file;
}

int output_is_same(const char *path, const char *other)
{
    struct stat a;
    struct stat b;

    return stat(path, &a) == 0 && stat(other, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino && S_ISREG(a.st_mode);
}

int output_begin(output *o, const char *path)
{
    struct stat old;

    *o = (output){0};
    const int is_link = lstat(path, &old) == 0 && S_ISLNK(old.st_mode);
    o->path = is_link ? realpath(path, NULL) : strdup(path);
    if (!o->path) {
        return cannot_write(path);
    }
    const int exists = stat(o->path, &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) {
        errno = EISDIR;
        return cannot_write(path);
    }
    o->file = exists && !S_ISREG(old.st_mode) ? fopen(o->path, "wb")
                                              : open_beside(o, exists ? &old : NULL);
    return o->file ? EXIT_GOOD : cannot_write(path);
}

int output_finish(output *o)
{
    int failed = ferror(o->file) || fflush(o->file) != 0;

    failed = failed || (o->temporary && fsync(fileno(o->file)) != 0);
    if (failed) {
        cannot_write(o->path);
    }
    if (fclose(o->file) != 0 && !failed) {
        failed = cannot_write(o->path);
    }
    o->file = NULL;
    return failed ? EXIT_FILE : EXIT_GOOD;
}

static void release(output *o)
{
    if (o->file) {
        fclose(o->file);
    }
    free(o->temporary);
    free(o->path);
    *o = (output){0};
}

int output_commit(output *o)
{
    int failure = EXIT_GOOD;

    if (o->temporary && rename(o->temporary, o->path) != 0) {
        failure = cannot_write(o->path);
        unlink(o->temporary);
    }
    release(o);
    return failure;
}

void output_discard(output *o)
{
    if (o->temporary) {
        unlink(o->temporary);
    }
    release(o);
}

int output_end(output *files, unsigned count, int failure)
{
    int result = failure;

    for (unsigned i = 0; i < count; i++) {
        if (failure) {
            output_discard(&files[i]);
        } else {
            const int committed = output_commit(&files[i]);
            result = result ? result : committed;
        }
    }
    return result;
}

int output_flush(void)
{
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_GOOD : cannot_write("standard output");
}

int output_copy(FILE *file)
{
    char block[16384];
    size_t size;

    while ((size = fread(block, 1, sizeof block, file)) > 0 && !ferror(stdout)) {
        fwrite(block, 1, size, stdout);
    }
    if (ferror(file)) {
        message("a temporary file cannot be read: %s", strerror(errno));
        return EXIT_FILE;
    }
    return output_flush();
}
