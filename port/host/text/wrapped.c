/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "text/wrapped.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "text/utf8.h"

#define DEFAULT_WIDTH 80u
#define TEXT_WIDTH_MAX 100u /* on wider terminals, too: longer lines are hard to read */
#define COLUMNS_LIMIT 10000
#define TEXT_MAX 8192

static size_t terminal_width(FILE *file)
{
#ifdef TIOCGWINSZ
    struct winsize size;

    if (isatty(fileno(file)) && ioctl(fileno(file), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
        return size.ws_col;
    }
#endif
    (void)file;
    return DEFAULT_WIDTH;
}

/* COLUMNS, or 0. */
static size_t stated_width(void)
{
    const char *stated = getenv("COLUMNS");
    char *end = NULL;
    const long columns = stated ? strtol(stated, &end, 10) : 0;

    return columns > 0 && columns < COLUMNS_LIMIT && *end == '\0' ? (size_t)columns : 0;
}

size_t wrapped_width(FILE *file)
{
    const size_t stated = stated_width();
    const size_t width = stated > 0 ? stated : terminal_width(file);

    return width < WRAPPED_MIN ? WRAPPED_MIN : width;
}

/* The width of running text. */
static size_t text_width(FILE *file)
{
    const size_t width = wrapped_width(file);

    return width > TEXT_WIDTH_MAX && stated_width() == 0 ? TEXT_WIDTH_MAX : width;
}

/* The bytes up to the next blank; in a command, up to the next unquoted one. */
static size_t part_length(const char *text, int is_command)
{
    size_t length = 0;
    int is_quoted = 0;

    while (text[length] != '\0' && (is_quoted || text[length] != ' ')) {
        is_quoted ^= is_command && text[length] == '\'';
        length++;
    }
    return length;
}

/* The bytes up to the next blank where the line may be broken: not between an option and its value,
 * ± or % and its number, > and its file, nor in a command within quotes. */
static size_t word_length(const char *text, int is_command)
{
    const size_t length = part_length(text, is_command);
    const char *value = text + length + 1;
    const int binds_next = strncmp(text, "--", 2) == 0 || strncmp(text, "[--", 3) == 0 ||
                           strncmp(text, "± ", strlen("± ")) == 0 || strncmp(text, "> ", 2) == 0;
    const int has_value = text[length] == ' ' && *value != '\0' && strchr(" -|>&", *value) == NULL;

    const int is_percent = text[length] == ' ' && *value == '%';

    return (binds_next && has_value) || is_percent ? length + 1 + part_length(value, is_command)
                                                   : length;
}

/* `continuation`: printed at each line break; not empty for a command. */
static size_t fill(FILE *file, size_t at, size_t indent, const char *text, const char *continuation)
{
    const size_t width = text_width(file) - strlen(continuation);

    while (*text != '\0') {
        const size_t blanks = strspn(text, " ");
        const size_t length = word_length(text + blanks, *continuation != '\0');
        const size_t columns = utf8_columns_of(text + blanks, length);
        if (length > 0 && at > indent && at + blanks + columns > width) {
            fprintf(file, "%s\n%*s", continuation, (int)indent, "");
            at = indent;
        } else {
            fprintf(file, "%*s", (int)blanks, "");
            at += blanks;
        }
        fwrite(text + blanks, 1, length, file);
        at += columns;
        text += blanks + length;
    }
    return at;
}

size_t wrapped_words(FILE *file, size_t at, size_t indent, const char *text)
{
    return fill(file, at, indent, text, "");
}

void wrapped_line(FILE *file, size_t at, size_t indent, const char *text)
{
    (void)fill(file, at, indent, text, "");
    putc('\n', file);
}

void wrapped_printf(FILE *file, size_t indent, const char *format, ...)
{
    char text[TEXT_MAX];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    wrapped_line(file, 0, indent, text);
}

void wrapped_command(FILE *file, size_t at, size_t indent, const char *command)
{
    const size_t width = wrapped_width(file);
    const size_t columns = utf8_columns(command);

    if (at > indent && at + 1 + columns > width) {
        fprintf(file, "\n%*s", (int)indent, "");
        at = indent;
    } else if (at > indent) {
        putc(' ', file);
        at++;
    }
    (void)fill(file, at, at + columns > width ? indent + 2 : indent, command,
               at + columns > width ? " \\" : "");
    putc('\n', file);
}
