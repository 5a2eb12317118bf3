#!/bin/sh
# SPDX-License-Identifier: MIT
#
# All tests with gcc and clang, C99 and C11, with warnings as errors. $1: folder to build in.
#
#     gcc-sanitizers     what `make test` runs, under AddressSanitizer, UndefinedBehaviorSanitizer and INVCAL_ASSERT;
#                        the tool's scripts skip cases that differ only in their numbers (BRIEF); the library is the
#                        fast one, INVCAL_FAST=1
#     clang-sanitizers   the unit tests, under the same; the tool runs under clang's sanitizers in its fuzzers
#     gcc                everything at full length; 1,500 draws of the tables of test_judged.c
#     clang              the unit tests at full length, with -O3 and degree 0 of thermal.h
#
# Compilers that are not installed are named and counted as a failure; `make deps` gets them.
# CONFIGURATION=gcc: only those whose names match. ONLY: see run.sh. BRIEF=1: sanitizers for float only; gcc only the long
# scripts, with the tool that `make test` has built; no search for leaks, which costs more than all else in a run of the
# tool; the fuzzers search.
# More arguments run one configuration: NAME COMPILER STANDARD LONG ASSERT DEGREE FLAG..., with - for what is not set;
# DEGREE is that of thermal.h.
out=$1
clang=${CLANG:-clang-19}

# Leaves `N passed, N failed`, or what is missing, in NAME.result.
run() {
    name=$1 compiler=$2 std=$3 long=$4 assert=$5 degree=$6 part='' folder=$out/$1
    shift 6
    log=$out/$name.log
    types='float double'
    status=0
    if ! command -v "$compiler" > /dev/null; then
        echo "$compiler is not installed: make deps" > "$out/$name.result"
        return
    fi
    case $name in clang*) part=src ;; esac
    [ -z "$BRIEF" ] || types=float
    set -- CC="$compiler" STD="$std" CFLAGS="$* -Werror" ASSERT="${assert#-}" DEGREE="${degree#-}"
    [ "$long" != only ] || { part=host folder=${out%/*}; set --; } # what is there, whatever it was compiled with
    make -s -j2 test BUILD="$folder" PART="$part" ONLY="$ONLY" TYPES="$types" LONG="${long#-}" \
        BRIEF="$([ "$long" = 1 ] || echo 1)" "$@" > "$log" 2>&1 || status=1
    [ $status -eq 0 ] || cat "$log"
    # A failed build is a failure, too.
    awk -v status=$status '/^[0-9]+ passed, [0-9]+ failed$/ { passed = $1; failed = $3 }
        END { print passed + 0 " passed, " (status && !failed ? 1 : failed + 0) " failed" }' \
        "$log" > "$out/$name.result"
}

configurations() {
    all | awk -v only="$CONFIGURATION" '$1 ~ only'
}

all() {
    full=1
    [ "$BRIEF" ] && full=only
    san='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer'
    echo "gcc-sanitizers gcc c11 - 1 - $san -DINVCAL_FAST=1
clang-sanitizers $clang c99 - 1 2 $san
gcc gcc c99 $full - - -O2 -DJUDGED_DRAWS=1500
clang $clang c11 1 - 0 -O3"
}

cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
[ -z "$BRIEF" ] || export ASAN_OPTIONS=detect_leaks=0
if [ $# -gt 1 ]; then
    shift
    run "$@"
    exit
fi

rm -f "$out"/*.result
# Two at a time, as a build alone does not keep two cores busy. (Not with `&`, whose jobs ignore SIGINT.)
configurations | xargs -P 2 -L 1 sh tests/check.sh "$out"
# Anything but `N passed, N failed` is a failure.
configurations | while read -r name rest; do
    echo "check $name: $(cat "$out/$name.result")"
done | awk '{ print }
    / [0-9]+ passed, [0-9]+ failed$/ { passed += $3; failed += $5; next }
    { failed++ }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
