/* SPDX-License-Identifier: MIT
 *
 * cli/options.h: parses the command line with a table of options.
 *
 * An option is `--name`, `--name VALUE` or `--name=VALUE`, anywhere among the operands; `--`
 * ends the options. A value never begins with `--`, so that a forgotten one is noticed. main.c
 * handles `--help` before.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stddef.h>

typedef struct {
    const char *name; /* with the dashes */
    int takes_value;
} option;

/* As operand_optional: the last operand may be repeated; a null ends the list. */
#define OPTIONS_REPEATS (~0u)

typedef struct {
    const char *command; /* whose help the error messages refer to */
    const option *options;
    unsigned option_count;
    const char *const *operands; /* their names */
    unsigned operand_count;
    unsigned operand_optional; /* number of the last ones that may be omitted, all or none; or
                                * OPTIONS_REPEATS */
} option_syntax;

/* Parses the arguments.
 *
 * values    one for each option: null if it is not given, else its text ("" if it takes none).
 * operands  one for each operand; null if it is omitted. With OPTIONS_REPEATS argc + 1 elements.
 * Both point into argv.
 *
 * Returns EXIT_GOOD; EXIT_USAGE for an unknown or repeated option, a missing or unexpected value, a
 * missing, empty or surplus operand. */
int options_parse(const option_syntax *syntax, int argc, char **argv, const char **values,
                  const char **operands);

/* Parses the value of option `which`: finite numbers, or quotients of two (9.80665/16384),
 * separated by commas.
 *
 * out     `expected` numbers.
 * single  null: all numbers are required. Else a single one is allowed, and this is set to 1 for
 *         it, to 0 for all.
 *
 * Returns EXIT_GOOD; EXIT_USAGE. */
int options_numbers(const option_syntax *syntax, unsigned which, const char *value,
                    unsigned expected, double *out, int *single);

/* An argument as typed in a shell, in quotes if needed. Truncated to size. Returns text. */
char *options_quoted(const char *argument, char *text, size_t size);

/* The command line as typed in a shell: "invcal calibrate 'my log.csv' --json". Truncated to
 * size. */
void options_command(const char *command, int argc, char **argv, char *text, size_t size);

#endif
