#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/rules.sh BUILD [tool]
# The rules for the sources, a line for each and at the end `N passed, N failed`. For the library:
# cppcheck with its MISRA C:2012 addon, less what tests/rules/misra.txt excuses; clang-tidy by
# .clang-tidy (for the example firmware, too); conversions that change a value, and poisoned names; a
# bound for every loop; cyclomatic complexity. For the tool, with `tool`: clang-tidy (minutes) and
# complexity.
# More arguments run one job; that is how xargs calls this script.
for command in cppcheck clang-tidy-19 clang-19 gcc pmccabe arm-none-eabi-gcc; do
    if ! command -v $command > /dev/null; then
        echo "$command is not installed: make deps" >&2
        exit 1
    fi
done
out=$1/rules
flags='-std=c99 -ffp-contract=off -Iinclude'
firmware=port/cortex-m/firmware
# Newlib's headers need two macros that only gcc predefines.
arm="--target=arm-none-eabi -isystem $(arm-none-eabi-gcc -print-file-name=include)
    -isystem /usr/include/newlib -D__INT32_C(c)=c##L -D__UINT32_C(c)=c##UL -Iport -I$firmware"

# What <float.h> defines, as cppcheck reads no system headers.
float_h='-DFLT_RADIX=2 -DFLT_MANT_DIG=24 -DFLT_MAX_EXP=128 -DFLT_EPSILON=1.2e-7f
    -DDBL_MANT_DIG=53 -DDBL_EPSILON=2.2e-16'

misra() { # NAME FLAG...: one configuration; all sources at once, as some rules are about all of them
    name=$1
    shift
    rm -rf "$out/cppcheck-$name"
    mkdir -p "$out/cppcheck-$name"
    # shellcheck disable=SC2086 # flags are words
    cppcheck --std=c99 --platform=unix64 --addon=misra --inline-suppr -q \
        --enable=warning,style,performance,portability,information \
        --suppress=missingIncludeSystem --cppcheck-build-dir="$out/cppcheck-$name" \
        --template='{file}:{line}:{column}: {id} {message}' -Iinclude $float_h "$@" \
        src > "$out/misra-$name.log" 2>&1 || echo "cppcheck failed" >> "$out/misra-$name.log"
}

# Conversions that may change a value, and poisoned names, for both number types.
strict() { # COMPILER FLAG...
    compiler=$1
    shift
    for real in 0 1; do
        # shellcheck disable=SC2086 # flags are words
        "$compiler" $flags -fsyntax-only -DINVCAL_DOUBLE=$real -include tests/rules/poison.h \
            -Wall -Wextra -Wconversion -Wsign-conversion -Wfloat-conversion -Wdouble-promotion -Wvla \
            -Werror "$@" src/*/*.c || echo "not clean by $compiler"
    done > "$out/strict-$compiler.log" 2>&1
}

tidy() { # GROUP FILE FLAG...
    group=$1 file=$2
    shift 2
    log=$out/tidy-$group-$(echo "$file" | tr / -).log
    # stderr only counts warnings; that a file does not compile is reported on stdout.
    # shellcheck disable=SC2086 # flags are words
    clang-tidy-19 --quiet "$file" -- $flags "$@" > "$log" 2> /dev/null ||
        echo "$file: not clean by clang-tidy" >> "$log"
}

jobs() {
    if [ -n "$1" ]; then
        for file in port/host/*.c port/host/*/*.c; do
            echo "tidy tool $file -DINVCAL_DOUBLE=1 -DINVCAL_MAX_POSITIONS=64" \
                "-DINVCAL_ALLAN_TAUS=31 -DINVCAL_PRIVATE_OVERLAP=4096 -DINVCAL_THERMAL_DEGREE=2 -DINVCAL_MAX_SEGMENTS=1000 -Iport/host -Isrc"
        done
    else
        echo 'misra float -DINVCAL_DOUBLE=0'
        echo 'misra double -DINVCAL_DOUBLE=1 -DINVCAL_THERMAL_DEGREE=2 -DINVCAL_MAX_POSITIONS=64'
        printf 'tidy library %s\n' src/*/*.c
        # shellcheck disable=SC2086 # flags are words
        for file in port/bare.c port/semihosting.c port/cortex-m/*.c $firmware/*.c "$firmware"_imu/*.c; do
            echo "tidy firmware $file" $arm
        done
        echo 'strict gcc -Warith-conversion'
        echo 'strict clang-19 -Wimplicit-int-float-conversion'
    fi
}

complex() { # LIMIT FILE...: functions above it
    limit=$1
    shift
    pmccabe "$@" 2>&1 | awk -v limit="$limit" '
        !/^[0-9]/ { print; next } # its messages
        $1 > limit { print $1 " of at most " limit ": " $6 " " $7 }
        END { if (NR == 0) print "no function" }'
}

report() { # NAME: prints what a gate says on stdin; it passes if that is nothing
    found=$(awk '!seen[$0]++') # headers are checked many times
    if [ -z "$found" ]; then
        echo "$1: PASS"
    else
        printf '%s\n' "$found"
        echo "$1: FAIL"
    fi
}

cd "$(dirname "$0")/.." || exit 1
if [ $# -gt 2 ]; then
    shift
    "$@"
    exit
fi
mkdir -p "$out"
rm -f "$out"/*.log
jobs "$2" | xargs -P 2 -L 1 sh tests/rules.sh "$1" || echo "a job failed" > "$out/tidy-jobs.log"

if [ -n "$2" ]; then
    cat "$out"/tidy-*.log | report 'clang-tidy, port/host'
    complex 27 port/host/*.c port/host/*/*.c | report 'cyclomatic complexity of port/host, at most 27'
else
    awk -v runs=2 -f tests/rules/misra.awk tests/rules/misra.txt "$out"/misra-*.log 2>&1 |
        report 'cppcheck and MISRA C:2012, less tests/rules/misra.txt'
    cat "$out"/tidy-*.log | report 'clang-tidy: src, the example firmware and what it is built on'
    cat "$out"/strict-*.log |
        report 'no conversion that changes a value, no poisoned name, no array of variable length'
    awk -f tests/rules/loops.awk tests/rules/bounds.txt src/*/*.c src/*/*.h 2>&1 |
        report 'every loop has a bound'
    complex 10 src/*/*.c src/*/*.h | report 'cyclomatic complexity of src, at most 10'
    awk -f tests/rules/includes.awk tests/rules/folders.txt src/*/*.[ch] port/host/*/*.[ch] 2>&1 |
        report 'the folders of src and of port/host know only those before them, without cycles'
fi | awk '{ print } /: PASS$/ { p++ } /: FAIL$/ { f++ }
    END { print p + 0 " passed, " f + 0 " failed"; exit f > 0 || p == 0 }'
