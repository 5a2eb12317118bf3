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
#include "cli/input.h"
#include "cli/message.h"

#define LINKS_MAX 40u /* symbolic links in a row, as Linux allows */
#define SUFFIX_MAX 99u

/* errno is that of the write that failed, even if it failed earlier: nothing has failed since. */
static int cannot_write(const char *what)
{
    /* NOLINTNEXTLINE(clang-analyzer-unix.Errno): every caller comes from a call that failed */
    const int error = errno ? errno : EIO;

    message("%s: cannot be written: %s%s", what, strerror(error),
            error == ENOENT   ? ": make its folder first"
            : error == EISDIR ? ": name a file in it"
                              : "");
    return EXIT_FILE;
}

static int refuse_leftover(const char *path, const char *temporary)
{
    message("%s: cannot be written: %s exists, left by a run that was killed; remove it and files "
            "of similar names",
            path, temporary);
    return EXIT_FILE;
}

/* Follows symbolic links; takes over and returns allocated memory. Null, with errno, on failure. */
static char *follow_links(char *path)
{
    struct stat status;
    char target[4096];

    for (unsigned links = 0; path && lstat(path, &status) == 0 && S_ISLNK(status.st_mode);
         links++) {
        const ssize_t length = readlink(path, target, sizeof target - 1);
        if (links == LINKS_MAX || length < 0) {
            free(path);
            errno = ELOOP;
            return NULL;
        }
        target[length] = '\0';
        const char *slash = target[0] == '/' ? NULL : strrchr(path, '/');
        const size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
        /* NOLINTNEXTLINE(clang-analyzer-optin.taint.TaintedAlloc): length is below sizeof target */
        char *next = malloc(folder + (size_t)length + 1);
        if (next) {
            memcpy(next, path, folder);
            memcpy(next + folder, target, (size_t)length + 1);
        }
        free(path);
        path = next;
    }
    return path;
}

/* The path to write to: links are followed, even to a target that does not exist yet. If it is not
 * a regular file, the path itself: the target of /dev/stdout may have no name. To be freed. */
static char *target_of(const char *path, const struct stat *old)
{
    if (!old) {
        return follow_links(strdup(path));
    }
    return S_ISREG(old->st_mode) ? realpath(path, NULL) : strdup(path);
}

/* The folder of a path. To be freed. */
static char *folder_of(const char *target)
{
    const char *slash = strrchr(target, '/');

    return slash ? strndup(target, slash == target ? 1 : (size_t)(slash - target)) : strdup(".");
}

/* Whether a file can be written there. A read-only file is refused, although renaming could replace
 * it, and although access() permits everything to root. */
static int check_target(const char *path, const char *target, const struct stat *old)
{
    if (old && S_ISDIR(old->st_mode)) {
        errno = EISDIR;
        return cannot_write(path);
    }
    if (old && ((S_ISREG(old->st_mode) && !(old->st_mode & 0222)) || access(target, W_OK) != 0)) {
        message("%s: is read-only: name another file, or make it writable", path);
        return EXIT_FILE;
    }
    char *folder = old && !S_ISREG(old->st_mode) ? NULL : folder_of(target);
    const int is_closed = folder && access(folder, W_OK | X_OK) != 0;
    free(folder);
    return is_closed ? cannot_write(path) : EXIT_GOOD;
}

int output_check(const char *path)
{
    struct stat status;
    const struct stat *old = stat(path, &status) == 0 ? &status : NULL;
    char *target = target_of(path, old);
    const int failure = target ? check_target(path, target, old) : cannot_write(path);

    free(target);
    return failure;
}

int output_is_same(const char *path, const char *input)
{
    struct stat a;
    struct stat b;
    const int has_input = input_is_stdin(input) ? fstat(STDIN_FILENO, &b) : stat(input, &b);

    return has_input == 0 && stat(path, &a) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino &&
           S_ISREG(a.st_mode);
}

/* The same name in the same folder. */
static int is_same_target(const char *a, const char *b)
{
    const char *slash_a = strrchr(a, '/');
    const char *slash_b = strrchr(b, '/');
    char *folder_a = folder_of(a);
    char *folder_b = folder_of(b);
    struct stat in_a;
    struct stat in_b;
    const int same = strcmp(slash_a ? slash_a + 1 : a, slash_b ? slash_b + 1 : b) == 0 &&
                     folder_a && folder_b && stat(folder_a, &in_a) == 0 &&
                     stat(folder_b, &in_b) == 0 && in_a.st_dev == in_b.st_dev &&
                     in_a.st_ino == in_b.st_ino;

    free(folder_a);
    free(folder_b);
    return same;
}

int output_collide(const char *path, const char *other)
{
    struct stat a;
    struct stat b;
    const int has_a = stat(path, &a) == 0;
    const int has_b = stat(other, &b) == 0;

    if (has_a || has_b) {
        return has_a && has_b && S_ISREG(a.st_mode) && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
    }
    char *target_a = target_of(path, NULL);
    char *target_b = target_of(other, NULL);
    const int same = target_a && target_b && is_same_target(target_a, target_b);
    free(target_a);
    free(target_b);
    return same;
}

/* Creates a file next to o->path under an unused name: a killed run with the same process id (in a
 * container it is always 1) may have left its file. Returns a descriptor; -1 with errno. */
static int create_beside(output *o)
{
    const size_t size = strlen(o->path) + 48;

    o->temporary = malloc(size);
    for (unsigned n = 0; o->temporary; n++) {
        const int length = snprintf(o->temporary, size, "%s.tmp-%ld", o->path, (long)getpid());
        if (n > 0) {
            snprintf(o->temporary + length, size - (size_t)length, "-%u", n);
        }
        const int fd = open(o->temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (fd >= 0 || errno != EEXIST || n == SUFFIX_MAX) {
            return fd;
        }
    }
    return -1;
}

/* Opens a new file next to o->path. It gets the mode of the file that it will replace. */
static int open_beside(output *o, const char *path, const struct stat *old)
{
    const int fd = create_beside(o);

    o->file = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (o->file) {
        if (old) {
            (void)fchmod(fd, old->st_mode & 0777);
        }
        return EXIT_GOOD;
    }
    if (fd >= 0) {
        close(fd);
        unlink(o->temporary);
    }
    const int failure = fd < 0 && errno == EEXIST && o->temporary
                            ? refuse_leftover(path, o->temporary)
                            : cannot_write(path);
    free(o->temporary); /* a file of this name is not ours */
    o->temporary = NULL;
    return failure;
}

int output_begin(output *o, const char *path)
{
    struct stat status;
    const struct stat *old = stat(path, &status) == 0 ? &status : NULL;

    *o = (output){0};
    o->path = target_of(path, old);
    if (!o->path) {
        return cannot_write(path);
    }
    const int failure = check_target(path, o->path, old);
    if (failure) {
        return failure;
    }
    if (!old || S_ISREG(old->st_mode)) {
        return open_beside(o, path, old);
    }
    o->file = fopen(o->path, "wb");
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
