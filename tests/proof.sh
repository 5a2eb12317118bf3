#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/proof.sh BUILD [ROOM...]
# Proves that the rooms of src/, or those named, have no undefined behaviour, by Frama-C/Eva from the
# entry points tests/proof/ROOM.c, whose inputs are arbitrary: no alarm, and every function of the
# room reached. Prints a line for each proof and at the end `N passed, N failed`.
out=$1/proof
shift
cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
[ $# -gt 0 ] || set -- $(basename -s .c tests/proof/*.c)

# Options of one proof stand in its file, in a line `// eva: ...`.
prove() {
    room=$1
    # shellcheck disable=SC2046 # options are words
    frama-c -machdep gcc_x86_32 -cpp-extra-args="-Iinclude -Isrc -Itests/proof -ffp-contract=off" \
        -warn-special-float none -eva -eva-precision 3 -eva-no-show-progress \
        $(sed -n 's|^// eva: ||p' "tests/proof/$room.c") \
        "tests/proof/$room.c" src/*.c > "$out/$room.log" 2>&1
}
for room; do
    if prove "$room" && grep -q ' 0 alarms generated' "$out/$room.log"; then
        echo "$room: PASS"
    else
        grep -E 'alarm|rror' "$out/$room.log"
        echo "$room: FAIL"
    fi
done | awk '{ print } /: PASS$/ { p++ } /: FAIL$/ { f++ }
    END { print p + 0 " passed, " f + 0 " failed"; exit f > 0 || NR == 0 }'
