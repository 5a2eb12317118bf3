/* SPDX-License-Identifier: MIT
 *
 * POSIX functions that the tool uses and wasi-libc does not declare; included before everything
 * else.
 */
#ifndef WASI_H
#define WASI_H

#include <sys/types.h>

int fchmod(int file, mode_t mode);
char *realpath(const char *path, char *resolved);

#endif
