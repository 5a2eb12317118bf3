/* SPDX-License-Identifier: MIT */
#include "text/utf8.h"

static int continues(char c)
{
    return ((unsigned char)c & 0xC0u) == 0x80u;
}

unsigned utf8_length(const char *text)
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
        if (!continues(text[i])) {
            return 0; /* the end of the text, too */
        }
        code = code << 6 | ((unsigned char)text[i] & 0x3Fu);
    }
    const int is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    return first >= 0xF8 || code < least[length] || code > 0x10FFFF || is_surrogate ? 0 : length;
}
