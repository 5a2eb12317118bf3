/* SPDX-License-Identifier: MIT */
#include "cli/files.h"

#include "cli/command.h"
#include "cli/input.h"
#include "cli/message.h"
#include "cli/output.h"

static int check_standard_input(const char *command, const named_file *inputs, unsigned count)
{
    unsigned readers = 0;

    for (unsigned i = 0; i < count; i++) {
        readers += inputs[i].path && input_is_stdin(inputs[i].path);
        if (readers > 1) {
            return message_usage(command, "%s: only one input can be read from the standard input",
                                 inputs[i].name);
        }
    }
    return EXIT_GOOD;
}

/* Compares one output with all inputs and with the outputs before it. */
static int check_output(const char *command, const named_file *checked, const named_file *inputs,
                        unsigned input_count, const named_file *outputs)
{
    for (unsigned i = 0; i < input_count; i++) {
        if (inputs[i].path && output_is_same(checked->path, inputs[i].path)) {
            const int is_option = inputs[i].name[0] == '-';
            return message_usage(command, "%s: would overwrite %s%s", checked->name,
                                 is_option ? "the file of " : "", inputs[i].name);
        }
    }
    for (const named_file *o = outputs; o < checked; o++) {
        if (o->path && output_collide(checked->path, o->path)) {
            return message_usage(command, "%s: is the file of %s", checked->name, o->name);
        }
    }
    return EXIT_GOOD;
}

int files_check(const char *command, const named_file *inputs, unsigned input_count,
                const named_file *outputs, unsigned output_count)
{
    int failure = check_standard_input(command, inputs, input_count);

    for (unsigned i = 0; i < output_count && !failure; i++) {
        failure = outputs[i].path ? check_output(command, &outputs[i], inputs, input_count, outputs)
                                  : EXIT_GOOD;
    }
    for (unsigned i = 0; i < output_count && !failure; i++) {
        failure = outputs[i].path ? output_check(outputs[i].path) : EXIT_GOOD;
    }
    return failure;
}
