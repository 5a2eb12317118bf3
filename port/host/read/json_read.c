/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "read/json_read.h"

#include <errno.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/number.h"

static void advance(json_reader *r)
{
    r->line += r->next == '\n';
    r->next = getc_unlocked(r->file);
}

static void skip_space(json_reader *r)
{
    while (r->next == ' ' || r->next == '\t' || r->next == '\n' || r->next == '\r') {
        advance(r);
    }
}

int json_error(const json_reader *r, const char *what)
{
    if (ferror(r->file)) {
        message("%s:%lu: cannot be read: %s", r->name, r->line, strerror(errno));
    } else {
        message("%s:%lu: %s%s", r->name, r->line, what,
                r->next == EOF ? ", but the file ends here" : "");
    }
    return EXIT_FILE;
}

int json_peek(json_reader *r)
{
    skip_space(r);
    return r->next;
}

void json_start(json_reader *r, FILE *file, const char *name)
{
    *r = (json_reader){.file = file, .name = name, .line = 1};
    advance(r);
}

int json_enter(json_reader *r, char bracket)
{
    skip_space(r);
    if (r->next != bracket) {
        if (r->depth == 0 && !ferror(r->file)) {
            message("%s:%lu: %s: name a file that invcal wrote with --out", r->name, r->line,
                    r->next == EOF ? "is empty" : "is not a JSON object");
            return EXIT_FILE;
        }
        return json_error(r, bracket == '{' ? "a JSON object, {...}, expected"
                                            : "a JSON list, [...], expected");
    }
    if (r->depth == JSON_DEPTH_MAX) {
        return json_error(r, "JSON objects and lists are nested too deep");
    }
    r->depth++;
    advance(r);
    return EXIT_GOOD;
}

/* Goes to the next item. 1; 0 after the closing bracket, which is consumed; -1, with a message. */
static int next_item(json_reader *r, unsigned index, char close)
{
    skip_space(r);
    if (r->next == close) {
        r->depth--;
        advance(r);
        return 0;
    }
    if (index > 0) {
        if (r->next != ',') {
            json_error(r, close == '}' ? "',' or '}' is expected" : "',' or ']' is expected");
            return -1;
        }
        advance(r);
        skip_space(r);
    }
    return 1;
}

int json_element(json_reader *r, unsigned index)
{
    return next_item(r, index, ']');
}

/* The character of an escape sequence; 0 if the sequence is unknown. Those beyond ASCII, which are
 * not needed here, become '?'. */
static char escaped(json_reader *r)
{
    static const char letters[] = "\"\\/bfnrt";
    static const char meanings[] = "\"\\/\b\f\n\r\t";
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *letter = r->next > 0 ? strchr(letters, r->next) : NULL;
    unsigned code = 0;

    if (letter) {
        return meanings[letter - letters];
    }
    if (r->next != 'u') {
        return 0;
    }
    for (int i = 0; i < 4; i++) {
        advance(r);
        const char *digit = r->next > 0 ? strchr(digits, r->next) : NULL;
        if (!digit) {
            return 0;
        }
        code = 16 * code + (unsigned)(digit - digits) % 16;
    }
    return code > 0 && code < 0x80 ? (char)code : '?';
}

int json_read_text(json_reader *r, char *out, size_t size)
{
    size_t length = 0;

    skip_space(r);
    if (r->next != '"') {
        return json_error(r, "a name or text in double quotes expected");
    }
    for (advance(r); r->next != '"'; advance(r)) {
        if (r->next == EOF || r->next < ' ') {
            return json_error(r, "a text is not closed by a quote on its line");
        }
        char c = (char)r->next;
        if (c == '\\') {
            advance(r);
            c = escaped(r);
            if (c == 0) {
                return json_error(r, "unknown escape sequence");
            }
        }
        if (length + 1 < size) {
            out[length++] = c;
        }
    }
    out[length] = '\0';
    advance(r);
    return EXIT_GOOD;
}

int json_member(json_reader *r, unsigned index, char *name, size_t size)
{
    const int more = next_item(r, index, '}');

    if (more != 1) {
        return more;
    }
    if (json_read_text(r, name, size) != EXIT_GOOD) {
        return -1;
    }
    skip_space(r);
    if (r->next != ':') {
        json_error(r, "':' expected after a name");
        return -1;
    }
    advance(r);
    return 1;
}

/* Reads a number, or one of the words true, false, null. */
static int read_token(json_reader *r, char *out, size_t size)
{
    static const char alphabet[] = "0123456789+-.abcdefghijklmnopqrstuvwxyz"
                                   "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    size_t length = 0;

    while (r->next > 0 && strchr(alphabet, r->next)) {
        if (length + 1 == size) {
            return json_error(r, "a number or word is too long");
        }
        out[length++] = (char)r->next;
        advance(r);
    }
    out[length] = '\0';
    return EXIT_GOOD;
}

/* JSON requires a digit on both sides of the point, no plus sign, no leading zero. */
static int is_json_number(const char *text)
{
    const char *s = text + (*text == '-');
    const size_t whole = strspn(s, "0123456789");
    const char *point = strchr(s, '.');

    return whole > 0 && (whole == 1 || *s != '0') &&
           (!point || (point[1] >= '0' && point[1] <= '9'));
}

static int parse_number(const json_reader *r, const char *text, double *out)
{
    char what[160];
    const number_status status = number_parse(text, out);

    if (status == NUMBER_OK && is_json_number(text)) {
        return EXIT_GOOD;
    }
    snprintf(what, sizeof what, "'%.100s' %s", text,
             status == NUMBER_OK ? "is not a number in JSON" : number_problem(status));
    return json_error(r, *text == '\0' ? "a number expected" : what);
}

int json_read_number(json_reader *r, double *out)
{
    char token[400];

    skip_space(r);
    const int failure = read_token(r, token, sizeof token);
    return failure ? failure : parse_number(r, token, out);
}

/* NOLINTNEXTLINE(misc-no-recursion): JSON_DEPTH_MAX deep at most, see json_enter */
static int skip_items(json_reader *r, char bracket)
{
    char name[2];
    int more = 0;
    int failure = json_enter(r, bracket);

    for (unsigned index = 0; !failure; index++) {
        more = bracket == '{' ? json_member(r, index, name, sizeof name) : json_element(r, index);
        if (more != 1) {
            break;
        }
        failure = json_skip(r);
    }
    return more < 0 ? EXIT_FILE : failure;
}

/* NOLINTNEXTLINE(misc-no-recursion): as skip_items */
int json_skip(json_reader *r)
{
    char token[400];
    double number;

    skip_space(r);
    if (r->next == '{' || r->next == '[') {
        return skip_items(r, (char)r->next);
    }
    if (r->next == '"') {
        return json_read_text(r, token, sizeof token);
    }
    const int failure = read_token(r, token, sizeof token);
    if (failure) {
        return failure;
    }
    if (*token == '\0') {
        return json_error(r, "a value expected");
    }
    if (strcmp(token, "true") == 0 || strcmp(token, "false") == 0 || strcmp(token, "null") == 0) {
        return EXIT_GOOD;
    }
    return parse_number(r, token, &number);
}

int json_finish(json_reader *r)
{
    skip_space(r);
    return r->next == EOF && !ferror(r->file) ? EXIT_GOOD
                                              : json_error(r, "nothing may follow the JSON object");
}
