/* SPDX-License-Identifier: MIT */
#include "text/constant.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *constant_float(double x, char text[NUMBER_TEXT_MAX])
{
    const float value = (float)x;
    float back;
    int digits = 5;

    do {
        snprintf(text, NUMBER_TEXT_MAX, "%.*g", ++digits, (double)value);
        back = strtof(text, NULL);
    } while (digits < 9 && (back < value || back > value));
    return text;
}

const char *constant_literal(double x, int is_double, char text[NUMBER_TEXT_MAX])
{
    if (is_double) {
        number_text(x, text);
    } else {
        constant_float(x, text);
    }
    if (!strpbrk(text, ".e")) {
        /* number_text needs 24 bytes at most, then with a point */
        strcat(text, ".0"); /* NOLINT(clang-analyzer-security.insecureAPI.strcpy): there is room */
    }
    return text;
}

int constant_fits_float(double x)
{
    const double size = fabs(x);

    return size <= (double)FLT_MAX && (!(size > 0) || size >= (double)FLT_MIN);
}

int constant_fits(const double offset[3], const double (*matrix)[3])
{
    int fits = 1;

    for (unsigned i = 0; i < 3; i++) {
        fits = fits && constant_fits_float(offset[i]);
        for (unsigned j = 0; j < 3; j++) {
            fits = fits && constant_fits_float(matrix[i][j]);
        }
    }
    return fits;
}

void constant_row(FILE *file, const double x[3], int is_double, const char *before,
                  const char *after)
{
    char text[NUMBER_TEXT_MAX];

    for (unsigned i = 0; i < 3; i++) {
        fprintf(file, "%s%s%s%s", i == 0 ? "{" : ", ", before,
                constant_literal(x[i], is_double, text), after);
    }
    putc('}', file);
}

/* INVCAL_REAL adds the suffix of the build's type, so that a double build has all digits, and a
 * float build no double constants. The suffix needs a point or an exponent before it. The
 * initialiser is positional because C++ has no designated ones before 2020. */
static void write_rows(FILE *file, const double (*matrix)[3])
{
    putc('{', file);
    for (unsigned i = 0; i < 3; i++) {
        fputs(i == 0 ? "" : ",\n     ", file);
        constant_row(file, matrix[i], 1, "INVCAL_REAL(", ")");
    }
    putc('}', file);
}

void constant_write_matrix(FILE *file, const char *name, const double (*matrix)[3])
{
    fprintf(file, "static const invcal_real %s[3][3] =\n    ", name);
    write_rows(file, matrix);
    fputs(";\n", file);
}

void constant_write(FILE *file, const char *name, const double offset[3], const double (*matrix)[3])
{
    fprintf(file, "static const invcal_calibration %s = {\n    ", name);
    constant_row(file, offset, 1, "INVCAL_REAL(", ")");
    fputs(",\n    ", file);
    write_rows(file, matrix);
    fputs("};\n", file);
}
