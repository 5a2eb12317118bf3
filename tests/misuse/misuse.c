/* SPDX-License-Identifier: MIT
 *
 * Calls every public function with what it should not be given, one argument at a time: null, zeros,
 * NaN, all bits 1, huge and tiny numbers, a structure that was not begun, the same object twice.
 * What must hold, by the rules of invcal.h:
 *
 *     null             INVCAL_ASSERT stops it, unless the header says that the argument may be null
 *     anything else    it returns; sanitizers watch that nothing else is read or written
 *     not INVCAL_OK    every output has its old bytes, unless the header says "overwritten"
 *     "may equal"      the same result as with separate objects
 *
 * generate.awk makes the table of functions from the headers.
 */
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/vector.h"
#include "headers.h"

typedef union {
    void *p;
    invcal_real real;
    long integer;
} argument;

typedef struct {
    const char *name, *type;
    size_t size;
    int is_pointer, is_const, is_nullable, is_overwritten, may_equal;
} parameter;

typedef struct {
    const char *name;
    int returns_status, returns_pointer;
    unsigned count;
    const parameter *parameter;
    long (*call)(const argument *a);
} function;

#include "functions.h"

enum { MOST = 10, BUFFER = 4096, ROWS = 70000 };
enum { WENT_WRONG = 3 }; /* not a status with which sanitizers end */

static jmp_buf assertion;

void misuse_assert(void)
{
    longjmp(assertion, 1);
}

/* ---- good arguments -------------------------------------------------------------------------- */

static invcal_vector mean[ROWS];
static invcal_real temperature[ROWS];
static invcal_calibration nominal;
static uint8_t memory[2][BUFFER];

static int read_memory(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context;
    memcpy(bytes, &memory[slot][offset], size);
    return 0;
}

static int erase_memory(void *context, unsigned slot)
{
    (void)context;
    memset(memory[slot], 0xFF, BUFFER);
    return 0;
}

static int program_memory(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                          uint32_t size)
{
    (void)context;
    memcpy(&memory[slot][offset], bytes, size);
    return 0;
}

static const invcal_store store = {read_memory, erase_memory, program_memory, NULL, BUFFER, 1};

/* The faces and edges of a cube, a little off; 18 of them. */
static void make_world(void)
{
    unsigned n = 0;

    for (int i = 0; n < ROWS; i++) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 % 3 - 1;
        const int ends = x * x + y * y + z * z;
        if (ends == 1 || ends == 2) {
            const double length = 16384 / sqrt(ends);
            mean[n].v[0] = (invcal_real)(1.01 * x * length + 100);
            mean[n].v[1] = (invcal_real)(0.99 * y * length - 50 + n % 3);
            mean[n].v[2] = (invcal_real)(z * length + 30);
            temperature[n] = (invcal_real)(n < 18 ? 10 : 40);
            n++;
        }
    }
    memset(&nominal, 0, sizeof nominal);
    for (unsigned i = 0; i < 3; i++) {
        nominal.matrix[i][i] = (invcal_real)(1 / 16384.0);
    }
    memset(memory, 0xFF, sizeof memory);
}

static void make_positions(invcal_positions *p, unsigned count)
{
    memset(p, 0, sizeof *p);
    p->mean = mean;
    p->count = count;
    p->nominal = &nominal;
    p->noise = (invcal_real)1e-3;
    p->temperature = temperature;
}

static void make_quality(invcal_quality *q)
{
    invcal_calibration c;
    invcal_positions p;

    make_positions(&p, 18);
    if (invcal_calibrate_plain(&p, &c, q) != INVCAL_OK) {
        abort();
    }
}

static void make_session(invcal_session *s)
{
    if (invcal_session_init(s, sizeof *s, 16384, 100) != INVCAL_OK) {
        abort();
    }
    memcpy(s->mean, mean, 12 * sizeof *mean);
    s->count = 12;
}

#include "made.h"

static int has_begun(const char *type)
{
    for (unsigned i = 0; i < sizeof begun / sizeof *begun; i++) {
        if (strcmp(begun[i], type) == 0) {
            return 1;
        }
    }
    return 0;
}

/* A good one, as far as it is known how to make it; else zeros. */
static void make(const parameter *p, void *object)
{
    memset(object, 0, p->size);
    for (unsigned i = 0; i < sizeof makers / sizeof *makers; i++) {
        if (strcmp(makers[i].type, p->type) == 0) {
            makers[i].make(object);
        }
    }
}

static int is(const parameter *p, const char *name)
{
    return strcmp(p->name, name) == 0;
}

static invcal_real good_real(const parameter *p)
{
    return is(p, "counts") ? 16384 : is(p, "rate") ? 100 : (invcal_real)0.5;
}

static long good_integer(const function *f, const parameter *p)
{
    return is(p, "size") && f->parameter->is_pointer && strstr(f->name, "_init")
               ? (long)f->parameter->size
           : is(p, "size") || is(p, "capacity") ? 256
           : is(p, "per_group")                 ? 6
           : is(p, "high")                      ? 1000
                                                : 1;
}

/* An array of unknown length, or bytes: as much as a size may say. */
static size_t bytes_of(const parameter *p)
{
    return strncmp(p->type, "invcal_", 7) == 0 && strcmp(p->type, "invcal_real") != 0 ? p->size
           : p->size > 8                                                              ? p->size
                                                                                      : BUFFER;
}

/* ---- bad ones -------------------------------------------------------------------------------- */

typedef enum { GOOD, ZEROS, NANS, ONES, SHORT, HUGE_COUNT, PATTERNS } pattern;

static void spoil(const function *f, unsigned i, pattern how, argument *a)
{
    static const invcal_real reals[PATTERNS] = {
        0, 0, (invcal_real)NAN, (invcal_real)INFINITY, -1, INVCAL_REAL_MAX};
    static const long integers[PATTERNS] = {0, 0, -1, 255, 2, 4096};
    const parameter *p = &f->parameter[i];
    invcal_real *const x = a->p;

    if (!p->is_pointer) {
        if (strcmp(p->type, "invcal_real") == 0) {
            a->real = reals[how];
        } else if (is(p, "size") || is(p, "capacity") || is(p, "count")) {
            a->integer = how == NANS ? 7 : integers[how];
        } else {
            a->integer = integers[how];
        }
    } else if (strcmp(p->type, "invcal_store") == 0) {
        ((invcal_store *)a->p)->granularity = how == ZEROS ? 0 : 7;
        ((invcal_store *)a->p)->slot_size = how == SHORT ? 3 : BUFFER;
    } else if (strcmp(p->type, "invcal_positions") == 0) {
        invcal_positions *positions = a->p;
        positions->count = how == ZEROS ? 0 : how == SHORT ? 5 : how == HUGE_COUNT ? ROWS : 18;
        positions->noise = how == NANS ? (invcal_real)NAN : how == ONES ? -1 : 0;
    } else if (strcmp(p->type, "invcal_imu_settings") == 0) {
        memset(a->p, 0, p->size);
    } else if (how == ZEROS) {
        memset(a->p, 0, p->size);
    } else if (has_begun(p->type)) {
        /* of these only zeros are promised: they are begun, or static */
    } else if (how == NANS) {
        for (size_t n = 0; n < p->size / sizeof *x; n++) {
            x[n] = (invcal_real)NAN;
        }
    } else {
        memset(a->p, how == ONES ? 0xFF : how == SHORT ? 0x01 : 0x7F, p->size);
    }
}

/* ---- a call ---------------------------------------------------------------------------------- */

static unsigned calls;

typedef struct {
    argument a[MOST];
    void *before[MOST];
} arguments;

static void begin(const function *f, arguments *args)
{
    for (unsigned i = 0; i < f->count; i++) {
        const parameter *p = &f->parameter[i];
        if (p->is_pointer) {
            args->a[i].p = calloc(1, bytes_of(p)); /* exactly: sanitizers see the ends */
            make(p, args->a[i].p);
        } else if (strcmp(p->type, "invcal_real") == 0) {
            args->a[i].real = good_real(p);
        } else {
            args->a[i].integer = good_integer(f, p);
        }
    }
}

static void end(const function *f, arguments *args)
{
    for (unsigned i = 0; i < f->count; i++) {
        if (f->parameter[i].is_pointer) {
            free(args->a[i].p);
        }
    }
}

static int is_output(const function *f, unsigned i)
{
    const parameter *p = &f->parameter[i];

    return p->is_pointer && !p->is_const && !p->is_overwritten &&
           !(i == 0 &&
             (strstr(f->name, "_init") || strstr(f->name, "_load") || strstr(f->name, "_resume")));
}

/* Returns the answer; -1 if an assertion stopped it. */
static long call(const function *f, const arguments *args)
{
    calls++;
    return setjmp(assertion) == 0 ? f->call(args->a) : -1;
}

static int fail(const function *f, const char *what, const char *where)
{
    printf("%s: %s%s\n", f->name, what, where);
    return WENT_WRONG;
}

static int check_outputs(const function *f, arguments *args)
{
    int wrong = 0;

    for (unsigned i = 0; i < f->count; i++) {
        if (is_output(f, i)) {
            args->before[i] = malloc(bytes_of(&f->parameter[i]));
            memcpy(args->before[i], args->a[i].p, bytes_of(&f->parameter[i]));
        }
    }
    const long answer = call(f, args);
    for (unsigned i = 0; i < f->count; i++) {
        if (is_output(f, i)) {
            if (f->returns_status && answer != INVCAL_OK && answer != -1 &&
                memcmp(args->before[i], args->a[i].p, bytes_of(&f->parameter[i])) != 0) {
                wrong |= fail(f, "refuses, but changes ", f->parameter[i].name);
            }
            free(args->before[i]);
        }
    }
    if (f->returns_pointer && answer == 1) {
        wrong |= fail(f, "returns null", "");
    }
    return wrong;
}

static int check_null(const function *f)
{
    int wrong = 0;

    for (unsigned i = 0; i < f->count; i++) {
        if (f->parameter[i].is_pointer) {
            arguments args;
            begin(f, &args);
            void *kept = args.a[i].p;
            args.a[i].p = NULL;
            const int stopped = call(f, &args) == -1;
            args.a[i].p = kept;
            end(f, &args);
            if (stopped == f->parameter[i].is_nullable) {
                wrong |= fail(f, stopped ? "asserts, though it may be null: " : "accepts null for ",
                              f->parameter[i].name);
            }
        }
    }
    return wrong;
}

static int check_patterns(const function *f)
{
    int wrong = 0;

    for (unsigned i = 0; i <= f->count; i++) { /* the last one: all good */
        for (pattern how = i < f->count ? ZEROS : GOOD; how < (i < f->count ? PATTERNS : ZEROS);
             how++) {
            arguments args;
            begin(f, &args);
            if (i < f->count) {
                spoil(f, i, how, &args.a[i]);
            }
            wrong |= check_outputs(f, &args);
            end(f, &args);
        }
    }
    return wrong;
}

/* An input and an output of the same type as one object. */
static int check_aliases(const function *f)
{
    int wrong = 0;

    for (unsigned i = 0; i < f->count; i++) {
        for (unsigned k = 0; k < f->count; k++) {
            const parameter *in = &f->parameter[i], *out = &f->parameter[k];
            if (!(in->is_pointer && out->is_pointer && in->is_const && !out->is_const &&
                  strcmp(in->type, out->type) == 0 && in->size == out->size)) {
                continue;
            }
            arguments apart, same;
            begin(f, &apart);
            begin(f, &same);
            void *kept = same.a[i].p;
            same.a[i].p = same.a[k].p;
            const long one = call(f, &apart), other = call(f, &same);
            if ((in->may_equal || out->may_equal) &&
                (one != other || memcmp(apart.a[k].p, same.a[k].p, out->size) != 0)) {
                wrong |= fail(f, "differs if they are one object: ", out->name);
            }
            same.a[i].p = kept;
            end(f, &apart);
            end(f, &same);
        }
    }
    return wrong;
}

/* In a process of its own: a function that stops it is named. */
static int check(const function *f)
{
    int status = 0;

    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const int wrong = check_null(f) | check_patterns(f) | check_aliases(f);
        fflush(stdout);
        _exit(wrong);
    }
    if (child < 0 || waitpid(child, &status, 0) != child) {
        return fail(f, "cannot be run", "");
    }
    if (!WIFEXITED(status) || (WEXITSTATUS(status) != 0 && WEXITSTATUS(status) != WENT_WRONG)) {
        return fail(f, "stopped the program", "");
    }
    return WEXITSTATUS(status);
}

int main(void)
{
    unsigned wrong = 0;
    const unsigned count = sizeof functions / sizeof *functions;

    make_world();
    for (unsigned i = 0; i < count; i++) {
        wrong += check(&functions[i]) != 0;
    }
    printf("%u of %u functions go wrong\n", wrong, count);
    return wrong > 0;
}
