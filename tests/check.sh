#!/bin/sh
# SPDX-License-Identifier: MIT
#
# `make test` by gcc and clang, C99 and C11, with warnings as errors: under AddressSanitizer,
# UndefinedBehaviorSanitizer and INVCAL_ASSERT, and optimised otherwise than `make test` itself
# (gcc, C99, -O2). $1: folder to build in.
# Compilers that are not installed are named and counted as a failure; `make deps` gets them.
# The scripts that try the tool run once, under gcc's sanitizers: they are slow, and the fuzzers of the
# tool are clang's. With BRIEF=1 they leave out what differs in numbers only, and the tutorial, which
# `make test` tries.
# clang builds the tool without sanitizers, and tries degree 0 of thermal.h; gcc-tables draws the tables of
# test_judged.c 1,500 times. CONFIGURATION=gcc: those with such names only. ONLY: see run.sh.
# With more arguments, it is one configuration: NAME COMPILER STANDARD ASSERT DEGREE ONLY FLAG..., -
# for what is not to be set; DEGREE is that of thermal.h.
out=$1
clang=${CLANG:-clang-19}
thermal='^float-thermal|^double-thermal'
tables='^float-judged|^double-judged'

# Leaves `N passed, N failed`, or what is missing, in NAME.result.
run() {
    name=$1 compiler=$2 std=$3 assert=$4 degree=$5 only=${ONLY:-${6#-}}
    shift 6
    log=$out/$name.log
    status=0
    if ! command -v "$compiler" > /dev/null; then
        echo "$compiler is not installed: make deps" > "$out/$name.result"
        return
    fi
    case $name in clang-sanitizers) units=1 ;; *) units= ;; esac
    case $only in # of the suites only these
    "$thermal") goals=all suites='thermal thermal_record' ;;
    "$tables") goals='' suites=judged ;;
    *) goals='test' suites= ;;
    esac
    if [ -n "$suites" ]; then
        for suite in $suites; do
            goals="$goals $out/$name/float/test_$suite $out/$name/double/test_$suite"
        done
    fi
    # shellcheck disable=SC2086 # several goals
    make -s -j2 $goals BUILD="$out/$name" CC="$compiler" STD="$std" CFLAGS="$* -Werror" \
        UNITS="$units" ASSERT="${assert#-}" DEGREE="${degree#-}" ONLY="$only" BRIEF=1 \
        > "$log" 2>&1 || status=1
    [ "$goals" = test ] || ONLY=$only sh tests/run.sh "$out/$name" >> "$log" 2>&1 || status=1
    [ $status -eq 0 ] || cat "$log"
    # What does not build has failed, too.
    awk -v status=$status '/^[0-9]+ passed, [0-9]+ failed$/ { passed = $1; failed = $3 }
        END { print passed + 0 " passed, " (status && !failed ? 1 : failed + 0) " failed" }' \
        "$log" > "$out/$name.result"
}

configurations() {
    all | awk -v only="$CONFIGURATION" '$1 ~ only'
}

all() {
    san='-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer'
    units='^float-|^double-'
    echo "gcc-sanitizers gcc c11 1 - - $san
clang-sanitizers $clang c99 1 2 $units $san
clang-c11 $clang c11 - 0 $thermal -O3
gcc-tables gcc c99 - - $tables -O2 -DDRAWS=1500"
}

cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
if [ $# -gt 1 ]; then
    shift
    run "$@"
    exit
fi

rm -f "$out"/*.result
# Two at a time, as the building of one leaves a core to the other. (Not by `&`, which takes SIGINT away.)
configurations | xargs -P 2 -L 1 sh tests/check.sh "$out"
# What is no `N passed, N failed` is a failure.
configurations | while read -r name rest; do
    echo "check $name: $(cat "$out/$name.result")"
done | awk '{ print }
    / [0-9]+ passed, [0-9]+ failed$/ { passed += $3; failed += $5; next }
    { failed++ }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
