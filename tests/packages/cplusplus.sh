#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# Each header by itself, from C and from C++; from C++ a program that links the library, and the two files.
. "$(dirname "$0")/../package.sh"
need g++ clang++-19 gcc clang-19
strict='-Wall -Wextra -pedantic -Wconversion -Werror'

headers() { # COMPILER STANDARD [LANGUAGE]
    for header in include/invcal/*.h "$out/amalgamation/invcal/invcal.h"; do
        for real in 0 1; do
            # shellcheck disable=SC2086 # flags are words
            "$1" -std="$2" $strict -DINVCAL_DOUBLE=$real -Iinclude -fsyntax-only -x "${3:-c++}" "$header" ||
                return
        done
    done
}

links() { # COMPILER STANDARD REAL LIBRARY
    # shellcheck disable=SC2086 # flags are words
    "$1" -std="$2" $strict -DINVCAL_DOUBLE="$3" -Iinclude -x c++ "$example" -x none "$4" -lm \
        -o "$out/program" && prints_as_expected "$out/program"
}

links_two_files() { # C-COMPILER COMPILER
    # shellcheck disable=SC2086 # flags are words
    sed '/^#include "invcal\/[^i]/d' "$example" > "$out/program.cpp"
    "$1" -std=c99 -c "$out/amalgamation/invcal/invcal.c" -o "$out/invcal.o" &&
        "$2" -std=c++11 $strict -I"$out/amalgamation" "$out/program.cpp" "$out/invcal.o" -lm \
            -o "$out/program" && prints_as_expected "$out/program"
}

check "the two files can be staged" stage amalgamation
for compiler in gcc clang-19; do
    for standard in c99 c11; do
        check "$compiler, $standard: each header compiles alone" headers $compiler $standard c
    done
done
for compiler in g++ clang++-19; do
    for standard in c++11 c++14 c++17 c++20; do
        check "$compiler, $standard: each header compiles alone" headers $compiler $standard
    done
    check "$compiler, float: the example prints what it must" \
        links $compiler c++11 0 "$build/float/libinvcal.a"
    check "$compiler, double: the example prints what it must" \
        links $compiler c++20 1 "$build/double/libinvcal.a"
done
check "g++ links the two files" links_two_files gcc g++
check "clang++-19 links the two files" links_two_files clang-19 clang++-19
finish
