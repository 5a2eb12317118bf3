/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* fopencookie */
#include "tool.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "design/grid.h"

#define REQUIRE(condition) ((condition) ? (void)0 : fail(__LINE__, #condition))

/* main of the tool, renamed. */
int tool_main(int argc, char **argv);

/* Not worth waiting for: these files are not read again. */
int fsync(int file)
{
    (void)file;
    return 0;
}

/* ---- optimal sets: the search takes seconds for many positions -------------------------------- */

enum { REAL_MOST = 12 };

__typeof__(optimal_directions) __real_optimal_directions, __wrap_optimal_directions;
__typeof__(optimal_within) __real_optimal_within, __wrap_optimal_within;
__typeof__(grid_directions) __real_grid_directions, __wrap_grid_directions;

/* Up to REAL_MOST positions it is the tool's own set; above, a repeated one. */
static unsigned real_count(unsigned n)
{
    return n < REAL_MOST ? n : REAL_MOST;
}

static void repeat(double (*direction)[3], unsigned from, unsigned n)
{
    for (unsigned i = from; i < n; i++) {
        memcpy(direction[i], direction[i - from], sizeof direction[i]);
    }
}

void __wrap_optimal_directions(unsigned n, int with_axes, double (*direction)[3])
{
    __real_optimal_directions(real_count(n), with_axes, direction);
    repeat(direction, real_count(n), n);
}

/* On stops of 45 degrees, whatever the request. */
void __wrap_grid_directions(unsigned n, unsigned step, int with_axes, double (*direction)[3])
{
    (void)step;
    __real_grid_directions(real_count(n), 45, with_axes, direction);
    repeat(direction, real_count(n), n);
}

/* Keeps the sets of the previous limits. */
double __wrap_optimal_within(unsigned n, const double limits[3], int with_axes,
                             double (*direction)[3])
{
    static struct {
        double limits[3];
        double ratio;
        double direction[REAL_MOST][3];
    } all[REAL_MOST + 1][2];
    const unsigned real = real_count(n);

    if (memcmp(all[real][with_axes].limits, limits, 3 * sizeof *limits) != 0) {
        memcpy(all[real][with_axes].limits, limits, 3 * sizeof *limits);
        all[real][with_axes].ratio =
            __real_optimal_within(real, limits, with_axes, all[real][with_axes].direction);
    }
    memcpy(direction, all[real][with_axes].direction, real * sizeof direction[0]);
    repeat(direction, real, n);
    return all[real][with_axes].ratio * sqrt((double)real / n);
}

/* ---- streams ---------------------------------------------------------------------------------- */

enum { TEXT_MOST = 1 << 18 };

/* What the tool prints. */
typedef struct {
    size_t size;
    char text[TEXT_MOST + 1];
} sink;

static sink printed;
static sink said;
static FILE *own_stderr;
static FILE *own_stdin;
static FILE *own_stdout;
static int first_file; /* the first descriptor that the tool opens */

static ssize_t take(void *cookie, const char *text, size_t size)
{
    sink *s = cookie;

    if (size > TEXT_MOST - s->size) {
        errno = ENOSPC;
        return 0;
    }
    memcpy(s->text + s->size, text, size);
    s->size += size;
    return (ssize_t)size;
}

static FILE *open_sink(sink *s)
{
    const cookie_io_functions_t functions = {.write = take};
    FILE *file = fopencookie(s, "w", functions);

    s->size = 0;
    if (!file) {
        abort();
    }
    return file;
}

static void close_sink(FILE *file, sink *s)
{
    fclose(file);
    s->text[s->size] = '\0';
}

static void fail(int line, const char *condition)
{
    fprintf(own_stderr, "tests/fuzz/tool.c:%d: does not hold: %s\nstderr was: %s\n", line,
            condition, said.text);
    abort();
}

/* ---- the folder ------------------------------------------------------------------------------- */

static void make_file(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");

    if (!file || fputs(text, file) < 0 || fclose(file) != 0) {
        perror(name);
        exit(1);
    }
}

/* Positions with a temperature, samples of rests, directions. */
static void run(const char *line, const char *out)
{
    char words[256];
    char *argv[32] = {NULL};
    int argc = 0;

    snprintf(words, sizeof words, "%s", line);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " ")) {
        argv[argc++] = word;
    }
    tool_run(argc, argv, (const uint8_t *)"", 0);
    if (out) {
        make_file(out, printed.text);
    }
}

static void make_thermal_positions(void)
{
    char text[4096];
    char row[80];

    snprintf(text, sizeof text, "x,y,z,temperature\n");
    for (int i = 0; i < 36; i++) {
        const int d = i % 18;
        const double x = d < 6 ? (d == 0) - (d == 1) : (double)(d % 3 - 1) * 0.7;
        const double y = d < 6 ? (d == 2) - (d == 3) : (double)(d / 3 % 3 - 1) * 0.7;
        const double z = d < 6 ? (d == 4) - (d == 5) : (d % 2 ? 0.7 : -0.7);
        const double over = 1000 / (x * x + y * y + z * z > 1.2 ? 1.2124 : 1);
        snprintf(row, sizeof row, "%.2f,%.2f,%.2f,%d\n", over * x + 20 + i / 18, over * y - 7,
                 over * z + 3 - i / 18, i < 18 ? 0 : 40);
        strncat(text, row, sizeof text - strlen(text) - 1);
    }
    make_file("thermal.csv", text);
}

static void make_files(void)
{
    run("invcal simulate --rate 10 --dwell 6 --move 1 --plan icosahedron", "log.csv");
    run("invcal simulate --rate 10 --dwell 40 --move 1 --plan faces", "rest.csv");
    run("invcal allan rest.csv --to 40 --lsb 0.0006 --out noise.json", NULL);
    make_thermal_positions();
    run("invcal calibrate thermal.csv --positions --thermal 1 --out slopes.json", NULL);
    make_file("directions.csv", "x,y,z\n1,0,0\n0,1,0\n0,0,1\n-1,0,0\n0,-1,0\n0,0,-1\n"
                                "1,1,0\n1,0,1\n0,1,1\n-1,1,0\n-1,0,1\n0,-1,1\n");
    make_file("stand.csv", "x,y,z,alpha,beta\n20,993,3,0,0\n20,-1007,3,180,0\n"
                           "20,-7,1003,90,0\n20,-7,-997,90,180\n1020,-7,3,90,90\n"
                           "-980,-7,3,-90,90\n20,700,710,45,0\n727,700,3,45,90\n"
                           "727,-7,710,90,45\n20,-714,710,135,0\n727,-714,3,135,90\n"
                           "727,-7,-704,90,135\n");
    make_file("positions.csv", "x,y,z,std,n\n1020,-7,3,2,50\n-980,-7,3,2,50\n20,993,3,2,50\n"
                               "20,-1007,3,2,50\n20,-7,1003,2,50\n20,-7,-997,2,50\n"
                               "727,700,3,2,50\n727,-714,3,2,50\n-687,700,3,2,50\n"
                               "727,-7,710,2,50\n-687,-7,710,2,50\n20,700,710,2,50\n");
    run("invcal calibrate positions.csv --positions --out cal.json", NULL);
}

/* The folder is FUZZ_FOLDER, or else this one. */
void tool_begin(void)
{
    const char *parent = getenv("FUZZ_FOLDER");
    char folder[512];

    own_stderr = stderr;
    own_stdin = stdin;
    own_stdout = stdout;
    snprintf(folder, sizeof folder, "%s/tool-XXXXXX", parent ? parent : ".");
    if (!mkdtemp(folder) || chdir(folder) != 0) {
        perror(folder);
        exit(1);
    }
    first_file = dup(0);
    close(first_file);
    make_files();
}

/* ---- one run ---------------------------------------------------------------------------------- */

static int is_warning(const char *line)
{
    return strncmp(line, "invcal: warning: ", 17) == 0;
}

/* Every error is one line; warnings may precede it. */
static void look_at_errors(int code, int is_live)
{
    const char *line = said.text;
    const char *end = strchr(line, '\n');

    REQUIRE(code >= 0 && code <= 3);
    REQUIRE(strlen(said.text) == said.size);
    if (code == 0) {
        return;
    }
    REQUIRE(end != NULL);
    while ((is_live || is_warning(line)) && end[1] != '\0') { /* guidance and bad lines before it */
        line = end + 1;
        end = strchr(line, '\n');
        REQUIRE(end != NULL);
    }
    REQUIRE(end[1] == '\0');
    REQUIRE(strncmp(line, "invcal: ", 8) == 0 && end - line > 8);
    for (const char *c = line; c < end; c++) {
        REQUIRE((unsigned char)*c >= ' ' && *c != 0x7f);
    }
}

/* ---- JSON: one value of RFC 8259, and no other number than finite ones ------------------------ */

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\r\n");
}

static const char *skip_text(const char *c)
{
    REQUIRE(*c == '"');
    for (c++; *c != '"'; c++) {
        REQUIRE((unsigned char)*c >= ' ');
        if (*c == '\\') {
            c++;
            REQUIRE(*c != '\0' && strchr("\"\\/bfnrtu", *c));
        }
    }
    return c + 1;
}

static const char *skip_number(const char *c)
{
    char *end;
    const double x = strtod(c, &end);

    REQUIRE((*c == '-' || (*c >= '0' && *c <= '9')) && end > c && x - x == 0);
    return end;
}

static const char *skip_value(const char *c);

static const char *skip_members(const char *c, char end)
{
    c = skip_blanks(c + 1);
    while (*c != end) {
        if (end == '}') {
            c = skip_blanks(skip_text(c));
            REQUIRE(*c == ':');
            c++;
        }
        c = skip_blanks(skip_value(skip_blanks(c)));
        REQUIRE(*c == ',' || *c == end);
        if (*c == ',') {
            c = skip_blanks(c + 1);
            REQUIRE(*c != end);
        }
    }
    return c + 1;
}

static const char *skip_value(const char *c)
{
    static const char *const words[] = {"true", "false", "null"};

    for (unsigned i = 0; i < 3; i++) {
        if (strncmp(c, words[i], strlen(words[i])) == 0) {
            return c + strlen(words[i]);
        }
    }
    return *c == '{'   ? skip_members(c, '}')
           : *c == '[' ? skip_members(c, ']')
           : *c == '"' ? skip_text(c)
                       : skip_number(c);
}

static void look_at_json(void)
{
    REQUIRE(strlen(printed.text) == printed.size);
    REQUIRE(*skip_blanks(skip_value(skip_blanks(printed.text))) == '\0');
}

static int has(int argc, char **argv, const char *word)
{
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], word) == 0) {
            return 1;
        }
    }
    return 0;
}

/* --help, and --sensor list: text, whatever else is asked for. */
static void look_at_results(int argc, char **argv, int code)
{
    const int is_help = has(argc, argv, "--help") || has(argc, argv, "--help=all") ||
                        has(argc, argv, "--sensor=list") || has(argc, argv, "list");
    if (code <= 1 && printed.size > 0 && has(argc, argv, "--json") && !is_help) {
        look_at_json();
    }
}

/* What a process leaves for the system to free. */
static void tidy(const struct sigaction *old)
{
    sigaction(SIGINT, &old[0], NULL);
    sigaction(SIGTERM, &old[1], NULL);
    for (int file = first_file; file < first_file + 8; file++) {
        close(file);
    }
}

void tool_run(int argc, char **argv, const uint8_t *input, size_t size)
{
    struct sigaction old[2];

    sigaction(SIGINT, NULL, &old[0]);
    sigaction(SIGTERM, NULL, &old[1]);
    stdin = fmemopen((void *)(uintptr_t)(size > 0 ? input : (const uint8_t *)"\n"),
                     size > 0 ? size : 1, "rb");
    stdout = open_sink(&printed);
    stderr = open_sink(&said);
    if (!stdin) {
        abort();
    }
    const int code = tool_main(argc, argv);
    fclose(stdin);
    close_sink(stdout, &printed);
    close_sink(stderr, &said);
    stdin = own_stdin;
    stdout = own_stdout;
    stderr = own_stderr;
    tidy(old);
    look_at_errors(code, argc > 1 && strcmp(argv[1], "watch") == 0);
    look_at_results(argc, argv, code);
}
