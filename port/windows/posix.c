/* SPDX-License-Identifier: MIT */
#include "posix.h"

#include <errno.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <windows.h>

/* Before main: binary files and streams; UTF-8 and escape sequences on the console, and TERM for
 * it. */
__attribute__((constructor)) static void init(void)
{
    const HANDLE console = GetStdHandle(STD_OUTPUT_HANDLE);
    DWORD mode;

    _fmode = _O_BINARY;
    for (int stream = 0; stream < 3; stream++) {
        (void)_setmode(stream, _O_BINARY);
    }
    if (GetConsoleMode(console, &mode)) {
        SetConsoleOutputCP(CP_UTF8);
        if (SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) && !getenv("TERM")) {
            (void)_putenv("TERM=xterm");
        }
    }
}

/* ---- files -------------------------------------------------------------------------------------- */

static void identify(HANDLE file, struct posix_stat *status)
{
    BY_HANDLE_FILE_INFORMATION info;

    if (GetFileInformationByHandle(file, &info)) {
        status->st_dev = info.dwVolumeSerialNumber;
        status->st_ino = (unsigned long long)info.nFileIndexHigh << 32 | info.nFileIndexLow;
    }
}

static void copy_status(const struct _stat64 *from, struct posix_stat *to)
{
    *to = (struct posix_stat){.st_mode = from->st_mode, .st_size = from->st_size};
}

int posix_stat(const char *path, struct posix_stat *status)
{
    struct _stat64 found;

    if (_stat64(path, &found) != 0) {
        return -1;
    }
    copy_status(&found, status);
    /* With this flag, a folder can be opened, too. */
    const HANDLE file = CreateFileA(path, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (file != INVALID_HANDLE_VALUE) {
        identify(file, status);
        CloseHandle(file);
    }
    return 0;
}

int posix_fstat(int file, struct posix_stat *status)
{
    struct _stat64 found;

    if (_fstat64(file, &found) != 0) {
        return -1;
    }
    copy_status(&found, status);
    identify((HANDLE)_get_osfhandle(file), status);
    return 0;
}

int posix_open(const char *path, int flags, ...)
{
    va_list more;

    va_start(more, flags);
    const int mode = flags & _O_CREAT ? va_arg(more, int) : 0;
    va_end(more);
    return _open(strcmp(path, "/dev/null") == 0 ? "NUL" : path, flags | _O_BINARY, mode);
}

/* Replaces an existing file. */
int posix_rename(const char *from, const char *to)
{
    if (MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) {
        return 0;
    }
    errno = GetLastError() == ERROR_FILE_NOT_FOUND ? ENOENT : EACCES;
    return -1;
}

/* That of the C library would be in the root of the drive. T: in memory if possible; D: deleted
 * when closed. */
FILE *posix_tmpfile(void)
{
    char folder[MAX_PATH + 1];
    char path[MAX_PATH + 1];

    if (!GetTempPathA(sizeof folder, folder) || !GetTempFileNameA(folder, "inv", 0, path)) {
        errno = EACCES;
        return NULL;
    }
    return fopen(path, "w+bTD");
}

int fcntl(int file, int command)
{
    (void)command;
    return _get_osfhandle(file) < 0 ? -1 : 0;
}

/* ---- the rest ----------------------------------------------------------------------------------- */

char *strndup(const char *text, size_t length)
{
    const size_t size = strnlen(text, length);
    char *copy = malloc(size + 1);

    if (copy) {
        memcpy(copy, text, size);
        copy[size] = '\0';
    }
    return copy;
}

/* signal resets the handler before it calls it, as SA_RESETHAND does. */
int sigaction(int number, const struct sigaction *action, struct sigaction *old)
{
    (void)old;
    return signal(number, action->sa_handler) == SIG_ERR ? -1 : 0;
}

int ioctl(int file, int request, struct winsize *size)
{
    CONSOLE_SCREEN_BUFFER_INFO info;

    (void)request;
    if (!GetConsoleScreenBufferInfo((HANDLE)_get_osfhandle(file), &info)) {
        return -1;
    }
    size->ws_row = (unsigned short)(info.srWindow.Bottom - info.srWindow.Top + 1);
    size->ws_col = (unsigned short)(info.srWindow.Right - info.srWindow.Left + 1);
    return 0;
}
