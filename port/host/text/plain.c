/* SPDX-License-Identifier: MIT */
#include "text/plain.h"

#include <stdio.h>
#include <string.h>

#include "text/utf8.h"

/* The length of the character; 0 if it is a control character or not valid UTF-8. */
static unsigned harmless_length(const char *text)
{
    const unsigned length = utf8_length(text);
    const unsigned char first = (unsigned char)text[0];
    const int is_control = length == 1
                               ? first < ' ' || first == 0x7f
                               : length == 2 && first == 0xC2 && (unsigned char)text[1] < 0xA0;

    return is_control ? 0 : length;
}

int plain_is(const char *text)
{
    while (*text != '\0' && harmless_length(text) > 0) {
        text += harmless_length(text);
    }
    return *text == '\0';
}

char *plain(char *text)
{
    for (char *c = text; *c != '\0';) {
        const unsigned length = harmless_length(c);
        if (length == 0) {
            *c = '?';
        }
        c += length > 0 ? length : 1;
    }
    return text;
}

const char *plain_copy(const char *text, char out[PLAIN_MAX])
{
    snprintf(out, PLAIN_MAX, "%s", text);
    return plain(out);
}
