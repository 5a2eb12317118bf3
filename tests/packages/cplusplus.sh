#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# From C++: each header by itself, and a program that links the library, and the two files.
. "$(dirname "$0")/../package.sh"
need g++ clang++-19 gcc clang-19
strict='-Wall -Wextra -pedantic -Werror'

headers() { # COMPILER STANDARD
    for header in include/invcal/*.h "$out/amalgamation/invcal/invcal.h"; do
        for real in 0 1; do
            # shellcheck disable=SC2086 # flags are words
            "$1" -std="$2" $strict -DINVCAL_DOUBLE=$real -Iinclude -fsyntax-only -x c++ "$header" ||
                return
        done
    done
}

cat > "$out/program.cpp" << 'END'
#include <math.h>

#include <cstdio>

#include "invcal/invcal.h"

// Six faces and twelve edges of a cube, by a sensor whose x axis reads 1 % too much.
int main()
{
    invcal_settings settings = {};
    invcal_solution solution;
    invcal_quality quality;
    invcal_real mean[18][3] = {};
    unsigned n = 0;

    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            for (int z = -1; z <= 1; z++) {
                const int square = x * x + y * y + z * z;
                if (square == 1 || square == 2) {
                    const invcal_real length = INVCAL_SQRT(invcal_real(square));
                    mean[n][0] = INVCAL_REAL(1.01) * invcal_real(x) / length;
                    mean[n][1] = invcal_real(y) / length;
                    mean[n++][2] = invcal_real(z) / length;
                }
            }
    for (unsigned i = 0; i < 3; i++)
        settings.nominal.matrix[i][i] = 1;
    settings.field = 1;
    const invcal_status status =
        invcal_calibrate(&mean[0][0], n, &settings, &solution, &quality, nullptr);
    if (status != INVCAL_OK)
        return std::printf("%s\n", invcal_status_text(status));
    std::printf("%u positions, %s, dk x %.3f\n", n, invcal_verdict_text(quality.verdict),
                double(solution.dk[0]));
}
END
expected='18 positions, good, dk x 0.010'

prints_verdict() {
    "$out/program" > "$out/printed" && echo "$expected" | diff - "$out/printed"
}

links() { # COMPILER STANDARD REAL LIBRARY
    # shellcheck disable=SC2086 # flags are words
    "$1" -std="$2" $strict -DINVCAL_DOUBLE="$3" -Iinclude "$out/program.cpp" "$4" -lm \
        -o "$out/program" && prints_verdict
}

links_two_files() { # C-COMPILER COMPILER
    "$1" -std=c99 -c "$out/amalgamation/invcal/invcal.c" -o "$out/invcal.o" &&
        "$2" -std=c++11 -I"$out/amalgamation" "$out/program.cpp" "$out/invcal.o" -lm \
            -o "$out/program" && prints_verdict
}

check "the two files can be staged" stage amalgamation
for compiler in g++ clang++-19; do
    for standard in c++11 c++14 c++17 c++20; do
        check "$compiler, $standard: each header compiles alone" headers $compiler $standard
    done
    check "$compiler, float: a program calibrates" \
        links $compiler c++11 0 "$build/float/libinvcal.a"
    check "$compiler, double: a program calibrates" \
        links $compiler c++20 1 "$build/double/libinvcal.a"
done
check "g++ links the two files" links_two_files gcc g++
check "clang++-19 links the two files" links_two_files clang-19 clang++-19
finish
