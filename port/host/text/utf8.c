/* SPDX-License-Identifier: MIT */
#include "text/utf8.h"

#include <string.h>

static int continues(char c)
{
    return ((unsigned char)c & 0xC0u) == 0x80u;
}

/* The code point at `text`; *size is its length, 0 if it is invalid. */
static unsigned long decode(const char *text, unsigned *size)
{
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char first = (unsigned char)*text;
    const unsigned length = first < 0x80   ? 1
                            : first < 0xC0 ? 0
                            : first < 0xE0 ? 2
                            : first < 0xF0 ? 3
                                           : 4;
    unsigned long code = length < 2 ? first : first & (0xFFul >> (length + 1));

    for (unsigned i = 1; i < length; i++) {
        if (!continues(text[i])) { /* the end of the text, too */
            *size = 0;
            return 0;
        }
        code = code << 6 | ((unsigned char)text[i] & 0x3Fu);
    }
    const int is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    *size = first >= 0xF8 || code < least[length] || code > 0x10FFFF || is_surrogate ? 0 : length;
    return code;
}

unsigned utf8_length(const char *text)
{
    unsigned length;

    (void)decode(text, &length);
    return length;
}

/* Combining marks and joiners take no column, blocks of wide characters (East Asian Width W or F)
 * two. */
static size_t columns_of(unsigned long code)
{
    static const struct {
        unsigned long first, last;
        size_t columns;
    } blocks[] = {
        {0x0300, 0x036F, 0}, {0x1100, 0x115F, 2}, {0x200B, 0x200F, 0},   {0x20D0, 0x20FF, 0},
        {0x2E80, 0xA4CF, 2}, {0xAC00, 0xD7A3, 2}, {0xF900, 0xFAFF, 2},   {0xFE00, 0xFE0F, 0},
        {0xFE30, 0xFE6F, 2}, {0xFF00, 0xFF60, 2}, {0x1F300, 0x1FAFF, 2}, {0x20000, 0x3FFFD, 2},
    };

    for (unsigned i = 0; i < sizeof blocks / sizeof blocks[0]; i++) {
        if (code >= blocks[i].first && code <= blocks[i].last) {
            return blocks[i].columns;
        }
    }
    return 1;
}

/* The length of an escape sequence that sets a colour, or 0. */
static size_t colour_length(const char *text)
{
    const size_t digits = text[0] == '\033' && text[1] == '[' ? strspn(text + 2, "0123456789;") : 0;

    return digits > 0 && text[2 + digits] == 'm' ? digits + 3 : 0;
}

size_t utf8_columns_of(const char *text, size_t size)
{
    size_t columns = 0;

    for (size_t at = 0; at < size && text[at] != '\0';) {
        unsigned length;
        const size_t colour = colour_length(text + at);
        const unsigned long code = decode(text + at, &length);
        columns += colour > 0 ? 0 : length > 0 ? columns_of(code) : 1;
        at += colour > 0 ? colour : length > 0 ? length : 1;
    }
    return columns;
}

size_t utf8_columns(const char *text)
{
    return utf8_columns_of(text, strlen(text));
}
