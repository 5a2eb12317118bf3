#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/fuzz.sh BUILD SECONDS [NAME...]
# Runs the fuzzers tests/fuzz/NAME.c, or all of them, for SECONDS each, two at a time, from the
# seeds in tests/fuzz/seeds/NAME. Prints a line for each, and at the end `N passed, N failed`.
# A fuzzer passes if it finds nothing and tries as many inputs per second of CPU time as its file demands. What it
# finds goes to BUILD/fuzz/NAME/found-*; its corpus, BUILD/fuzz/NAME/corpus, is where the next run
# begins only with KEEP=1. DOUBLE=1: the library's fuzzers in double.
out=$1/fuzz${DOUBLE:+-double}
seconds=$2
shift 2
case $seconds in '' | *[!0-9]*)
    echo "SECONDS is a number of seconds, not '$seconds'" >&2
    exit 1
    ;;
esac
cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
# shellcheck disable=SC2046 # names without blanks
[ $# -gt 0 ] || set -- $(grep -l 'fuzz: more than' tests/fuzz/*.c | sed 's|.*/||; s|\.c$||')

if ! make -s -j2 -f tests/fuzz/fuzz.mk OUT="$out" NAMES="$*" DOUBLE="${DOUBLE:-0}" > "$out/make.log" 2>&1; then
    cat "$out/make.log"
    echo "0 passed, $# failed"
    exit 1
fi
printf '%s\n' "$@" | xargs -P 2 -n 1 sh tests/fuzz/run.sh "$out" "$seconds" |
    awk '{ print } / PASS$/ { p++ } / FAIL$/ { f++ }
        END { print p + 0 " passed, " f + 0 " failed"; exit f > 0 || p + f < wanted }' wanted=$#
