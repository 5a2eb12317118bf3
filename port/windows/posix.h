/* SPDX-License-Identifier: MIT
 *
 * POSIX functions that the tool uses and MinGW-w64 lacks or implements differently; included before
 * everything else.
 */
#ifndef WINDOWS_POSIX_H
#define WINDOWS_POSIX_H

#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A file is identified by its volume and number, for which the st_ino of Windows is too small. */
struct posix_stat {
    unsigned long long st_dev, st_ino;
    unsigned short st_mode;
    long long st_size;
};
int posix_stat(const char *path, struct posix_stat *status);
int posix_fstat(int file, struct posix_stat *status);
int posix_open(const char *path, int flags, ...);
int posix_rename(const char *from, const char *to);
FILE *posix_tmpfile(void);
#define stat posix_stat
#define fstat posix_fstat
#define lstat posix_stat
#define open posix_open
#define rename posix_rename
#define tmpfile posix_tmpfile

/* The system follows symbolic links. */
#define S_ISLNK(mode) ((void)(mode), 0)
#define readlink(path, target, size) ((ssize_t)(0 * ((path) - (target)) - 1))
#define realpath(path, resolved) _fullpath(resolved, path, 0)

/* Files have no mode, and folders no search permission. */
#define fchmod(file, mode) (0 * ((file) + (mode)))
#undef X_OK
#define X_OK 0
#define fsync _commit

/* There are no threads, so streams need no locks. */
#define getc_unlocked _getc_nolock

char *strndup(const char *text, size_t length);

/* Is a descriptor open? */
#define F_GETFD 1
int fcntl(int file, int command);

/* A write to a closed pipe fails, without a signal. */
#define SIGPIPE 13

#define SA_RESETHAND 1
struct sigaction {
    void (*sa_handler)(int);
    int sa_mask, sa_flags;
};
#define sigemptyset(mask) (*(mask) = 0)
int sigaction(int number, const struct sigaction *action, struct sigaction *old);

#endif
