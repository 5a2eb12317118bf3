/* SPDX-License-Identifier: MIT
 *
 * The size of the console.
 */
#ifndef WINDOWS_IOCTL_H
#define WINDOWS_IOCTL_H

#define TIOCGWINSZ 1

struct winsize {
    unsigned short ws_row, ws_col;
};

int ioctl(int file, int request, struct winsize *size);

#endif
