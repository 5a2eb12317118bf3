#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The library as two files: every compiler compiles it, with the example. (That it computes the same bits
# as the library of many files, tests/builds.sh checks.)
. "$(dirname "$0")/../package.sh"
need gcc g++ clang-19 clang++-19
strict='-std=c99 -O1 -ffp-contract=off -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow
    -pedantic -Werror'
files=$out/amalgamation/invcal

same_bytes() {
    LC_ALL=C.UTF-8 TZ=Asia/Tokyo sh port/stage.sh amalgamation "$out/again" &&
        diff -r "$out/amalgamation" "$out/again"
}

compiles() { # COMPILER FLAG...
    # shellcheck disable=SC2086 # flags are words
    "$@" $strict -c "$files/invcal.c" -o "$out/invcal.o"
}

runs_example() { # COMPILER FLAG...
    compiles "$@" || return
    "$@" -std=c99 -Wall -Wextra -Werror -I"$out/amalgamation" "$example" "$out/invcal.o" -lm \
        -o "$out/example" && prints_as_expected "$out/example"
}

# invcal.c as C++, in a project that has no C.
runs_as_cpp() { # COMPILER FLAG...
    "$@" -x c++ -std=c++11 -O1 -ffp-contract=off -pedantic-errors -Wall -Wconversion -Wshadow -Werror -c "$files/invcal.c" \
        -o "$out/invcal.o" && cp "$example" "$out/example.cpp" &&
        "$@" -std=c++11 -I"$out/amalgamation" "$out/example.cpp" "$out/invcal.o" -lm -o "$out/example" &&
        prints_as_expected "$out/example"
}

# The command of port/README.md: the linker drops what is not called.
links_what_is_called() {
    mkdir -p "$out/project" && cp -R "$out/amalgamation" "$out/project/third_party" &&
        cp "$example" "$out/project/main.c" || return
    command=$(sed -n '/cd PROJECT && cc/{N;s/.*&& //;p;}' port/README.md)
    (cd "$out/project" && eval "$command") && prints_as_expected "$out/project/a.out" &&
        drops_uncalled "$out/project/a.out" && ! nm "$out/project/a.out" | grep 'invcal_allan'
}

# Programs include the headers by their names, whatever package they are built with.
has_every_header() {
    for header in include/invcal/*.h; do
        printf '#include "%s"\n' "${header#include/}"
    done > "$out/headers.c"
    echo 'int main(void) { return INVCAL_IMU_RECORD_SIZE > 0 && INVCAL_OK == 0 ? 0 : 1; }' >> "$out/headers.c"
    gcc -std=c99 -I"$out/amalgamation" "$out/headers.c" -o "$out/headers" && "$out/headers"
}

takes_config() { # a header of choices reaches the library and its user
    echo '#define INVCAL_MAX_POSITIONS 17' > "$out/choices.h"
    printf '%s\n' '#include "invcal/invcal.h"' \
        'typedef char as_chosen[INVCAL_MAX_POSITIONS == 17 ? 1 : -1];' \
        'int main(void) { return sizeof(as_chosen) != 1; }' > "$out/chosen.c"
    set -- gcc -I"$out" '-DINVCAL_CONFIG_HEADER="choices.h"'
    compiles "$@" && "$@" -I"$out/amalgamation" "$out/chosen.c" "$out/invcal.o" -lm -o "$out/chosen" &&
        "$out/chosen"
}

check "it can be staged" stage amalgamation
check "staged again in another locale, it has the same bytes" same_bytes
for compiler in gcc clang-19; do
    check "$compiler, float: the example prints what it must" \
        runs_example $compiler
    check "$compiler, double: the example prints what it must" \
        runs_example $compiler -DINVCAL_DOUBLE=1
    long "$compiler, parabolas and 64 positions" compiles $compiler -DINVCAL_THERMAL_DEGREE=2 \
        -DINVCAL_MAX_POSITIONS=64
    long "$compiler, no thermal polynomial" compiles $compiler -DINVCAL_THERMAL_DEGREE=0
done
check "it has a header of every name" has_every_header
check "only what is called is linked" links_what_is_called
check "gcc as C++: the example prints what it must" runs_as_cpp g++
check "clang as C++: the example prints what it must" runs_as_cpp clang++-19
check "INVCAL_CONFIG_HEADER is included" takes_config
finish
