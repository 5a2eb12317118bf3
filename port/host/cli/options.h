/* SPDX-License-Identifier: MIT
 *
 * cli/options.h: the command line, by a table.
 *
 * An option is `--name`, `--name VALUE` or `--name=VALUE`, anywhere among the operands; `--`
 * ends the options. A value never begins with `--`, so a forgotten one is noticed. `--help` is
 * dealt with before (main.c).
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stddef.h>

typedef struct {
    const char *name; /* with its dashes */
    int takes_value;
} option;

/* In place of the number: more of the last operand may follow, and a null at the end. */
#define OPTIONS_REPEATS (~0u)

typedef struct {
    const char *command; /* whose help an error points to */
    const option *options;
    unsigned option_count;
    const char *const *operands; /* their names; */
    unsigned operand_count;
    unsigned operand_optional; /* so many at the end may be left out, all or none; or: */
} option_syntax;

/* Takes the arguments apart.
 *
 * values    one for each option: null if it is not there, else its text ("" without a value).
 * operands  one for each operand; null if it was left out. OPTIONS_REPEATS: room for argc + 1.
 * Both point into argv.
 *
 * Returns EXIT_GOOD; EXIT_USAGE for an unknown option, one given twice, a value that is missing
 * or not wanted, a missing, empty or surplus operand. */
int options_parse(const option_syntax *syntax, int argc, char **argv, const char **values,
                  const char **operands);

/* Reads finite numbers, or quotients of two (9.80665/16384), with commas between from the value of
 * option `which`.
 *
 * out     `wanted` numbers.
 * single  null; or set to 1 if there was one number only, which is then allowed, else to 0.
 *
 * Returns EXIT_GOOD; EXIT_USAGE. */
int options_numbers(const option_syntax *syntax, unsigned which, const char *value, unsigned wanted,
                    double *out, int *single);

/* An argument as one would type it: in quotes if a shell would take it apart. Cut to size. Returns
 * text. */
char *options_quoted(const char *argument, char *text, size_t size);

/* The command line as one would type it: "invcal calibrate 'my log.csv' --json". Cut to size. */
void options_command(const char *command, int argc, char **argv, char *text, size_t size);

#endif
