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

#define LINKS_MAX 40u /* one link after the other, as many as Linux follows */
#define NAMES_MAX 99u

/* If a write had failed before, errno is still its: nothing since then has failed. */
static int cannot_write(const char *what)
{
    /* NOLINTNEXTLINE(clang-analyzer-unix.Errno): every caller comes from a call that failed */
    const int why = errno ? errno : EIO;

    message("%s: cannot be written: %s%s", what, strerror(why),
            why == ENOENT   ? ": make its folder first"
            : why == EISDIR ? ": name a file in it"
                            : "");
    return EXIT_FILE;
}

static int in_the_way(const char *path, const char *temporary)
{
    message("%s: cannot be written: %s exists, left by a run that was killed; remove it and files "
            "of similar names",
            path, temporary);
    return EXIT_FILE;
}

/* What a symbolic link leads to. Null, with errno, if there is not enough memory. */
static char *follow(char *path)
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

/* Where a file is to go: links are followed, also one whose target does not exist yet. What is no
 * regular file is named as it was: what /dev/stdout leads to may have no name. */
static char *place_of(const char *path, const struct stat *old)
{
    if (!old) {
        return follow(strdup(path));
    }
    return S_ISREG(old->st_mode) ? realpath(path, NULL) : strdup(path);
}

/* The folder that a file is or will be in. To be freed. */
static char *folder_of(const char *place)
{
    const char *slash = strrchr(place, '/');

    return slash ? strndup(place, slash == place ? 1 : (size_t)(slash - place)) : strdup(".");
}

/* Can a file be put there? The owner of a file that is read-only has said what should not be done,
 * though renaming would replace it, and the superuser may do everything. */
static int check_place(const char *path, const char *place, const struct stat *old)
{
    if (old && S_ISDIR(old->st_mode)) {
        errno = EISDIR;
        return cannot_write(path);
    }
    if (old && ((S_ISREG(old->st_mode) && !(old->st_mode & 0222)) || access(place, W_OK) != 0)) {
        message("%s: is read-only: name another file, or make it writable", path);
        return EXIT_FILE;
    }
    char *folder = old && !S_ISREG(old->st_mode) ? NULL : folder_of(place);
    const int is_closed = folder && access(folder, W_OK | X_OK) != 0;
    free(folder);
    return is_closed ? cannot_write(path) : EXIT_GOOD;
}

int output_check(const char *path)
{
    struct stat status;
    const struct stat *old = stat(path, &status) == 0 ? &status : NULL;
    char *place = place_of(path, old);
    const int failure = place ? check_place(path, place, old) : cannot_write(path);

    free(place);
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

/* The same name in one and the same folder. */
static int is_same_place(const char *a, const char *b)
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
    char *place_a = place_of(path, NULL);
    char *place_b = place_of(other, NULL);
    const int same = place_a && place_b && is_same_place(place_a, place_b);
    free(place_a);
    free(place_b);
    return same;
}

/* Creates a file next to o->path under a name that is free: one that was killed under the same number
 * of process (in a container that is always 1) may have left its own. A descriptor; -1 with errno. */
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
        if (fd >= 0 || errno != EEXIST || n == NAMES_MAX) {
            return fd;
        }
    }
    return -1;
}

/* Opens a new file next to o->path. If there is one already, the new one gets its mode. */
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
    const int failure = fd < 0 && errno == EEXIST && o->temporary ? in_the_way(path, o->temporary)
                                                                  : cannot_write(path);
    free(o->temporary); /* what is there under this name is not ours */
    o->temporary = NULL;
    return failure;
}

int output_begin(output *o, const char *path)
{
    struct stat status;
    const struct stat *old = stat(path, &status) == 0 ? &status : NULL;

    *o = (output){0};
    o->path = place_of(path, old);
    if (!o->path) {
        return cannot_write(path);
    }
    const int failure = check_place(path, o->path, old);
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
