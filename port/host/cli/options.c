/* SPDX-License-Identifier: MIT */
#include "cli/options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "text/append.h"
#include "text/nearest.h"
#include "text/number.h"

#define NOT_FOUND (~0u)

/* The option with this name, or NOT_FOUND. */
static unsigned find(const option_syntax *syntax, const char *argument, size_t length)
{
    for (unsigned i = 0; i < syntax->option_count; i++) {
        const char *name = syntax->options[i].name;
        if (strlen(name) == length && strncmp(name, argument, length) == 0) {
            return i;
        }
    }
    return NOT_FOUND;
}

static int refuse_unknown(const option_syntax *syntax, const char *argument, size_t length)
{
    nearest meant = nearest_begin(argument, length);
    char hint[NEAREST_TEXT_MAX];

    nearest_offer(&meant, "--help");
    for (unsigned i = 0; i < syntax->option_count; i++) {
        nearest_offer(&meant, syntax->options[i].name);
    }
    return message_usage(syntax->command, "%.*s: unknown option%s", (int)length, argument,
                         nearest_text(&meant, hint));
}

/* Parses the option at argv[*at]; its value follows '=' or is the next argument. */
static int take_option(const option_syntax *syntax, int argc, char **argv, int *at,
                       const char **values)
{
    const char *argument = argv[*at];
    const char *equals = strchr(argument, '=');
    const size_t length = equals ? (size_t)(equals - argument) : strlen(argument);
    const unsigned which = find(syntax, argument, length);

    if (which == NOT_FOUND) {
        return refuse_unknown(syntax, argument, length);
    }
    const option *o = &syntax->options[which];
    if (values[which]) {
        return message_usage(syntax->command, "%s: given twice", o->name);
    }
    if (!o->takes_value) {
        values[which] = "";
        return equals ? message_usage(syntax->command, "%s: takes no value", o->name) : EXIT_GOOD;
    }
    if (equals) {
        values[which] = equals + 1;
    } else if (*at + 1 < argc && strncmp(argv[*at + 1], "--", 2) != 0) {
        values[which] = argv[++*at];
    } else {
        return message_usage(syntax->command, "%s: its value is missing", o->name);
    }
    if (*values[which] == '\0') {
        return message_usage(syntax->command,
                             "%s: its value is empty: is a shell variable not set?", o->name);
    }
    return EXIT_GOOD;
}

static int refuse_surplus(const option_syntax *syntax, const char *operand)
{
    char names[120] = "";

    for (unsigned i = 0; i < syntax->operand_count; i++) {
        append(names, sizeof names, "%s%s", i ? " and " : "", syntax->operands[i]);
    }
    return message_usage(
        syntax->command,
        "'%s': one operand too many: it takes only %s; options begin with --, and a "
        "name that holds blanks needs quotes",
        operand, *names ? names : "options");
}

int options_parse(const option_syntax *syntax, int argc, char **argv, const char **values,
                  const char **operands)
{
    unsigned found = 0;
    int only_operands = 0;
    const int repeats = syntax->operand_optional == OPTIONS_REPEATS;
    const unsigned operands_min = syntax->operand_count - (repeats ? 0 : syntax->operand_optional);

    for (unsigned i = 0; i < syntax->option_count; i++) {
        values[i] = NULL;
    }
    for (unsigned i = 0; i < syntax->operand_count; i++) {
        operands[i] = NULL;
    }
    for (int i = 0; repeats && i <= argc; i++) {
        operands[i] = NULL;
    }
    for (int i = 0; i < argc; i++) {
        if (!only_operands && strcmp(argv[i], "--") == 0) {
            only_operands = 1;
        } else if (!only_operands && argv[i][0] == '-' && argv[i][1] != '\0') {
            const int failure = take_option(syntax, argc, argv, &i, values);
            if (failure) {
                return failure;
            }
        } else if (found == syntax->operand_count && !repeats) {
            return refuse_surplus(syntax, argv[i]);
        } else if (argv[i][0] == '\0') {
            return message_usage(syntax->command, "%s is empty: is a shell variable not set?",
                                 syntax->operands[found]);
        } else {
            operands[found++] = argv[i];
        }
    }
    if (found < operands_min || (found > operands_min && found < syntax->operand_count)) {
        return message_usage(syntax->command, "%s is missing", syntax->operands[found]);
    }
    return EXIT_GOOD;
}

/* Copies the text up to the next comma. Returns the text after the comma; null at the end. */
static const char *next_item(const char *text, char *item, size_t size)
{
    const size_t length = strcspn(text, ",");

    snprintf(item, size, "%.*s", (int)length, text);
    return text[length] == ',' ? text + length + 1 : NULL;
}

/* A number, or a quotient of two: data sheets state counts per unit, the option is units per
 * count. */
static number_status parse_quotient(char *item, double *out)
{
    char *slash = strchr(item, '/');
    double divisor = 1;
    number_status status = NUMBER_OK;

    if (slash) {
        *slash = '\0';
        status = number_parse(slash + 1, &divisor);
    }
    status = status == NUMBER_OK ? number_parse(item, out) : status;
    if (slash) {
        *slash = '/';
    }
    if (status == NUMBER_OK) {
        *out /= divisor;
        status = isfinite(*out) ? NUMBER_OK : NUMBER_NOT_FINITE;
    }
    return status;
}

int options_numbers(const option_syntax *syntax, unsigned which, const char *value,
                    unsigned expected, double *out, int *single)
{
    const char *name = syntax->options[which].name;
    const char *rest = value;
    char item[400]; /* longer than any number that makes sense */
    unsigned n = 0;

    while (rest && n < expected) {
        rest = next_item(rest, item, sizeof item);
        const number_status status = parse_quotient(item, &out[n++]);
        if (status != NUMBER_OK) {
            return message_usage(syntax->command, "%s %s: '%s' %s", name, value, item,
                                 number_problem(status));
        }
    }
    if (rest || (n < expected && !(single && n == 1))) {
        return message_usage(
            syntax->command, "%s %s: %u number%s expected%s%s", name, value, expected,
            expected > 1 ? "s separated by commas" : "", single ? ", or one" : "",
            expected == 1 ? "; decimals are written with a point, such as 9.81" : "");
    }
    if (single) {
        *single = n < expected;
    }
    return EXIT_GOOD;
}

/* Appends a character if it fits. */
static size_t put(char *text, size_t size, size_t at, char c)
{
    if (at + 1 < size) {
        text[at++] = c;
        text[at] = '\0';
    }
    return at;
}

/* Appends an argument, in quotes if the shell needs them. */
static size_t put_argument(char *text, size_t size, size_t at, const char *argument)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=:,./@%";
    const int is_plain = *argument != '\0' && argument[strspn(argument, plain)] == '\0';

    at = is_plain ? at : put(text, size, at, '\'');
    for (const char *c = argument; *c != '\0'; c++) {
        for (const char *out = *c == '\'' ? "'\\''" : NULL; out && *out != '\0'; out++) {
            at = put(text, size, at, *out);
        }
        at = *c == '\'' ? at : put(text, size, at, *c);
    }
    return is_plain ? at : put(text, size, at, '\'');
}

char *options_quoted(const char *argument, char *text, size_t size)
{
    text[0] = '\0';
    (void)put_argument(text, size, 0, argument);
    return text;
}

void options_command(const char *command, int argc, char **argv, char *text, size_t size)
{
    size_t at;

    snprintf(text, size, "invcal %s", command);
    at = strlen(text);
    for (int i = 0; i < argc; i++) {
        at = put_argument(text, size, put(text, size, at, ' '), argv[i]);
    }
}
