/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "text/unit.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#define LENGTH_TOLERANCE 0.15 /* relative: offsets and scale errors of a bad sensor */
#define SHARE_MIN 0.9         /* of the readings: some may be wrong */
#define RESULTANT_MAX 0.7 /* length of the mean unit vector: a larger one means a large offset */
#define TEXT_MAX 16
#define LATIN1_SQUARE '\xb2' /* ISO 8859-1, as spreadsheets save it on Windows */
#define LATIN1_MICRO "\xb5"
#define LATIN1_RATE "\xb0/s" /* °/s */

/* Removes the differences between spellings of a unit: "m / s^2", "m_s2", "(m/(s^2))" become the
 * same. Returns 0 if the text is longer than any unit. */
static int normalise(const char *text, char out[TEXT_MAX])
{
    unsigned length = 0;

    for (const char *c = text; *c != '\0'; c++) {
        if (strchr(" _^*.()[]", *c)) {
            continue;
        }
        if (length + 1 == TEXT_MAX) {
            return 0;
        }
        if (strncmp(c, "²", strlen("²")) == 0) {
            c += strlen("²") - 1;
            out[length++] = '2';
        } else {
            out[length++] = *c == LATIN1_SQUARE ? '2' : *c;
        }
    }
    out[length] = '\0';
    return 1;
}

typedef struct {
    const char *text;
    reading_unit unit;
} spelling;

/* Finds a text among spellings, ignoring case. */
static int is_spelled(const char *text, const spelling *spellings, unsigned count,
                      reading_unit *out)
{
    char normalised[TEXT_MAX];

    if (!normalise(text, normalised)) {
        return 0;
    }
    for (unsigned i = 0; i < count; i++) {
        if (strcasecmp(normalised, spellings[i].text) == 0) {
            *out = spellings[i].unit;
            return 1;
        }
    }
    return 0;
}

int unit_parse(const char *text, reading_unit *out)
{
    static const spelling spellings[] = {
        {"g", UNIT_G},           {"gs", UNIT_G},         {"mg", UNIT_MG},      {"m/s2", UNIT_MS2},
        {"m/s/s", UNIT_MS2},     {"ms2", UNIT_MS2},      {"ms-2", UNIT_MS2},   {"mps2", UNIT_MS2},
        {"counts", UNIT_COUNTS}, {"count", UNIT_COUNTS}, {"raw", UNIT_COUNTS}, {"lsb", UNIT_COUNTS},
    };

    return is_spelled(text, spellings, sizeof spellings / sizeof spellings[0], out);
}

int unit_parse_magnetic(const char *text, reading_unit *out)
{
    static const spelling spellings[] = {
        {"ut", UNIT_MICROTESLA},     {"µt", UNIT_MICROTESLA}, /* U+00B5, then U+03BC */
        {"μt", UNIT_MICROTESLA},     {LATIN1_MICRO "t", UNIT_MICROTESLA},
        {"nt", UNIT_NANOTESLA},      {"g", UNIT_GAUSS},
        {"gauss", UNIT_GAUSS},       {"mg", UNIT_MILLIGAUSS},
        {"mgauss", UNIT_MILLIGAUSS}, {"counts", UNIT_COUNTS},
        {"raw", UNIT_COUNTS},        {"lsb", UNIT_COUNTS},
    };

    return is_spelled(text, spellings, sizeof spellings / sizeof spellings[0], out);
}

double unit_parse_angular_rate(const char *text)
{
    static const char *const radians[] = {"rad/s",   "rads",     "radps",     "rads-1",
                                          "rad/sec", "radian/s", "radians/s", NULL};
    static const char *const degrees[] = {"deg/s",   "dps",  "degps",     "degs-1",
                                          "deg/sec", "degs", "degrees/s", "degree/s",
                                          "°/s",     "°s-1", LATIN1_RATE, NULL};
    char normalised[TEXT_MAX];

    if (!normalise(text, normalised)) {
        return 0;
    }
    for (unsigned part = 0; part < 2; part++) { /* without a prefix, with milli */
        const char *name = normalised + part;
        const double of = part ? 1e-3 : 1;
        for (unsigned i = 0; radians[i] && (!part || normalised[0] == 'm'); i++) {
            if (strcasecmp(name, radians[i]) == 0) {
                return of;
            }
        }
        for (unsigned i = 0; degrees[i] && (!part || normalised[0] == 'm'); i++) {
            if (strcasecmp(name, degrees[i]) == 0) {
                return of * UNIT_DEGREE;
            }
        }
    }
    return 0;
}

/* Names are those of rad/s, mrad/s, degrees/s, millidegrees/s, and counts for any other unit. */
static const char *choose_rate_name(double rad_per_s, const char *const names[5])
{
    const double degrees = rad_per_s / UNIT_DEGREE;

    return fabs(rad_per_s - 1) < 1e-6      ? names[0]
           : fabs(rad_per_s - 1e-3) < 1e-9 ? names[1]
           : fabs(degrees - 1) < 1e-6      ? names[2]
           : fabs(degrees - 1e-3) < 1e-9   ? names[3]
                                           : names[4];
}

const char *unit_angular_rate_words(double rad_per_s)
{
    static const char *const words[] = {"rad/s", "mrad/s", "°/s", "m°/s", "counts"};

    return choose_rate_name(rad_per_s, words);
}

const char *unit_angular_rate_name(double rad_per_s)
{
    static const char *const names[] = {"rad/s", "mrad/s", "deg/s", "mdeg/s", "counts"};

    return choose_rate_name(rad_per_s, names);
}

double unit_parse_time(const char *text)
{
    static const struct {
        double per_second;
        const char *texts[7];
    } units[] = {
        {1, {"s", "sec", "secs", "second", "seconds"}},
        {1e3, {"ms", "msec", "millis", "milliseconds"}},
        {1e6,
         /* NOLINTNEXTLINE(bugprone-suspicious-missing-comma): a macro and a text are one */
         {"us", "µs", "μs", LATIN1_MICRO "s", "usec", "micros",
          "microseconds"}}, /* U+00B5, U+03BC */
        {1e9, {"ns", "nsec", "nanos", "nanoseconds"}},
    };

    for (unsigned i = 0; i < sizeof units / sizeof units[0]; i++) {
        for (unsigned k = 0; k < 7 && units[i].texts[k]; k++) {
            if (strcasecmp(text, units[i].texts[k]) == 0) {
                return units[i].per_second;
            }
        }
    }
    return 0;
}

static int ends_with(const char *text, const char *end)
{
    const size_t length = strlen(text);
    const size_t end_length = strlen(end);

    return length >= end_length && strcasecmp(text + length - end_length, end) == 0;
}

temperature_unit unit_parse_temperature(const char *text)
{
    static const struct {
        const char *letter;
        const char *name;
        temperature_unit unit;
    } units[] = {{"c", "celsius", {1, 0}},
                 {"k", "kelvin", {1, -273.15}},
                 {"f", "fahrenheit", {5.0 / 9, -160.0 / 9}}};
    const double part = text[0] == 'm' ? 1e-3 : 1;

    for (unsigned i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (ends_with(text, units[i].letter) || ends_with(text, units[i].name)) {
            return (temperature_unit){part * units[i].unit.scale, units[i].unit.zero};
        }
    }
    return (temperature_unit){0, 0};
}

int unit_is_gravity(double field)
{
    return field > 9.7 && field < 9.9;
}

double unit_field_si(double field)
{
    return unit_is_gravity(field)         ? 1
           : field > 0.99 && field < 1.01 ? UNIT_STANDARD_GRAVITY
           : field > 990 && field < 1010  ? UNIT_STANDARD_GRAVITY / 1000
                                          : 0;
}

/* The length of gravity in each unit. */
static const double gravity_reads[] = {
    [UNIT_G] = 1, [UNIT_MG] = 1000, [UNIT_MS2] = UNIT_STANDARD_GRAVITY};

reading_unit unit_by_size(const double *reading, unsigned count, double field)
{
    unsigned like[UNIT_COUNTS] = {0};

    if (!(unit_field_si(field) > 0)) {
        return UNIT_UNKNOWN;
    }
    for (unsigned n = 0; n < count; n++) {
        const double *v = &reading[3 * (unsigned long)n];
        const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        for (unsigned u = UNIT_G; u <= UNIT_MS2; u++) {
            like[u] += fabs(length / gravity_reads[u] - 1) < LENGTH_TOLERANCE;
        }
    }
    for (unsigned u = UNIT_G; u <= UNIT_MS2; u++) {
        if (like[u] > count / 2) {
            return (reading_unit)u;
        }
    }
    return UNIT_COUNTS;
}

int unit_is_sure(reading_unit u, const double *reading, unsigned count)
{
    double sum[3] = {0, 0, 0};
    unsigned like = 0;

    if (u != UNIT_G && u != UNIT_MS2) {
        return 0;
    }
    for (unsigned n = 0; n < count; n++) {
        const double *v = &reading[3 * (unsigned long)n];
        const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        if (fabs(length / gravity_reads[u] - 1) < LENGTH_TOLERANCE) {
            like++;
            for (unsigned i = 0; i < 3; i++) {
                sum[i] += v[i] / length;
            }
        }
    }
    return like >= SHARE_MIN * count &&
           sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) < RESULTANT_MAX * like;
}

double unit_scale(reading_unit u, double field)
{
    const double si = unit_field_si(field);
    const double unit = u == UNIT_G     ? UNIT_STANDARD_GRAVITY
                        : u == UNIT_MG  ? UNIT_STANDARD_GRAVITY / 1000
                        : u == UNIT_MS2 ? 1
                                        : 0;

    return si > 0 ? unit / si : 0;
}

static const char *const unit_names[] = {"unknown", "g",  "mg",    "m/s^2", "counts",
                                         "uT",      "nT", "gauss", "mgauss"};

const char *unit_name(reading_unit u)
{
    return unit_names[u];
}

reading_unit unit_of_name(const char *name)
{
    for (unsigned u = UNIT_G; u <= UNIT_MILLIGAUSS; u++) {
        if (strcmp(name, unit_names[u]) == 0) {
            return (reading_unit)u;
        }
    }
    return UNIT_UNKNOWN;
}

const char *unit_words(reading_unit u)
{
    return u == UNIT_UNKNOWN      ? "input units"
           : u == UNIT_MS2        ? "m/s²"
           : u == UNIT_MICROTESLA ? "µT"
                                  : unit_name(u);
}

const char *unit_origin_name(unit_origin origin)
{
    static const char *const names[] = {"none", "header", "option", "size", "sensor"};

    return names[origin];
}
