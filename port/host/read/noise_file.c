/* SPDX-License-Identifier: MIT */
#include "read/noise_file.h"

#include <string.h>

#include "cli/command.h"
#include "cli/input.h"
#include "read/json_read.h"
#include "cli/message.h"
#include "text/unit.h"

#define NAME_MAX_LENGTH 24

typedef struct {
    invcal_noise *noise; /* of three axes */
    double gravity;      /* 0: not known */
    char unit[8];        /* of the noise, truncated */
    unsigned axes;       /* bits of the axes that have been read */
} noise_file;

typedef int (*member_reader)(json_reader *r, const char *name, void *into);

static int read_object(json_reader *r, member_reader read, void *into)
{
    char name[NAME_MAX_LENGTH];
    int more = 0;
    int failure = json_enter(r, '{');

    for (unsigned i = 0; !failure && (more = json_member(r, i, name, sizeof name)) == 1; i++) {
        failure = read(r, name, into);
    }
    return more < 0 ? EXIT_FILE : failure;
}

static int read_coefficient(json_reader *r, const char *name, void *into)
{
    static const char *const names[] = {"white", "instability", "walk", "shortest", "longest"};
    invcal_noise *n = into;
    double *const numbers[] = {&n->coefficient[INVCAL_NOISE_WHITE],
                               &n->coefficient[INVCAL_NOISE_INSTABILITY],
                               &n->coefficient[INVCAL_NOISE_WALK], &n->shortest, &n->longest};

    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(name, names[i]) == 0) {
            const int failure = json_read_number(r, numbers[i]);
            return failure            ? failure
                   : *numbers[i] >= 0 ? EXIT_GOOD
                                      : json_error(r, "negative noise");
        }
    }
    return json_skip(r);
}

static int read_axis(json_reader *r, const char *name, void *into)
{
    noise_file *all = into;
    const int axis = name[0] - 'x';

    if (name[0] == '\0' || name[1] != '\0' || axis < 0 || axis > 2) {
        return json_skip(r);
    }
    all->axes |= 1u << axis;
    return read_object(r, read_coefficient, &all->noise[axis]);
}

static int read_member(json_reader *r, const char *name, void *into)
{
    noise_file *all = into;

    if (strcmp(name, "noise") == 0) {
        return read_object(r, read_axis, all);
    }
    if (strcmp(name, "gravity") == 0 && json_peek(r) != 'n') {
        return json_read_number(r, &all->gravity);
    }
    if (strcmp(name, "unit") == 0 && json_peek(r) == '"') {
        return json_read_text(r, all->unit, sizeof all->unit);
    }
    return json_skip(r);
}

/* Checks what is required, and divides the noise by the field. */
static int finish(const noise_file *all, const char *name)
{
    for (unsigned i = 0; i < 3; i++) {
        invcal_noise *n = &all->noise[i];
        if (!(all->axes >> i & 1u) || !(n->coefficient[INVCAL_NOISE_WHITE] > 0 ||
                                        n->coefficient[INVCAL_NOISE_INSTABILITY] > 0 ||
                                        n->coefficient[INVCAL_NOISE_WALK] > 0)) {
            message("%s: does not hold the noise of three axes; make it with invcal allan --out",
                    name);
            return EXIT_FILE;
        }
        for (unsigned k = 0; k < INVCAL_NOISE_KINDS && all->gravity > 0; k++) {
            n->coefficient[k] /= all->gravity;
        }
    }
    if (unit_parse_angular_rate(all->unit) > 0) {
        message("%s: is the noise of a gyroscope (%s): run invcal allan with the columns of the "
                "accelerometer",
                name, all->unit);
        return EXIT_FILE;
    }
    if (!(all->gravity > 0)) {
        message("%s: the length of the field is not known in its unit: run invcal allan with "
                "--unit, --lsb or --gravity",
                name);
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

int noise_file_read(const char *path, invcal_noise noise[3])
{
    noise_file all = {.noise = noise};
    const char *name = input_name(path);
    json_reader r;
    FILE *file = input_open(path);

    if (!file) {
        return EXIT_FILE;
    }
    memset(noise, 0, 3 * sizeof *noise);
    json_start(&r, file, name);
    int failure = read_object(&r, read_member, &all);
    failure = failure ? failure : json_finish(&r);
    input_close(file);
    return failure ? failure : finish(&all, name);
}
