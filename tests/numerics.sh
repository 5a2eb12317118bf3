#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/numerics.sh BUILD [COUNT]
# Rounding errors: COUNT random sets of positions, solved in float and in double and compared with
# an exact solution (tests/reference/numerics.py), against the bounds that src/core/solve.h states. The bounds
# were set with 30000, which take about ten minutes. Prints a line for each assertion and at the end
# `N passed, N failed`.
out=$1/numerics
count=${2:-2000}
cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
/usr/bin/python3 -c 'import mpmath, gmpy2' 2> /dev/null ||
    { echo 'python3-mpmath or python3-gmpy2 is not installed: make deps' >&2; exit 1; }

build() { # NAME DOUBLE SOURCE
    # shellcheck disable=SC2086 # options are words
    ${CC:-cc} -std=c99 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Wdouble-promotion \
        -Wshadow -pedantic -DINVCAL_DOUBLE="$2" -DUNITY_INCLUDE_DOUBLE -Iinclude -Isrc -Itests/unit \
        -Itests/unity "tests/numerics/$3.c" tests/unit/support.c tests/unity/unity.c src/*/*.c \
        -lm -o "$out/$1"
}
build problems 1 problems && build solve-float 0 solve && build solve-double 1 solve || exit 1
/usr/bin/python3 tests/reference/numerics.py "$out" "$count"
