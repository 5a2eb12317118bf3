#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Compiles the program of README.md and runs it on the board of tests/readme, with the float library of
# the build folder $1: it must calibrate, and after a reset find what it has stored. CC and CFLAGS as for
# the library.
build=$1
here=$(dirname "$0")
root=$here/..
out=$build/readme
mkdir -p "$out"
passed=0
failed=0

result() { # name, status
    if [ "$2" -eq 0 ]; then
        echo "readme: $1: PASS"
        passed=$((passed + 1))
    else
        echo "readme: $1: FAIL"
        cat "$out/log"
        failed=$((failed + 1))
    fi
}

awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' "$root/README.md" > "$out/program.c"
lines=$(grep -c . "$out/program.c")
echo "$lines lines" > "$out/log"
[ "$lines" -gt 10 ] && [ "$lines" -le 25 ]
result 'the program has at most 25 lines' $?

# shellcheck disable=SC2086 # flags
${CC:-cc} $CFLAGS -std=c99 -Wall -Wextra -pedantic -Werror -I"$root/include" -I"$here/readme" \
    "$out/program.c" "$here/readme/board.c" "$build/float/libinvcal.a" -lm -o "$out/program" \
    > "$out/log" 2>&1
result 'it compiles' $?

head -c 4096 /dev/zero > "$out/memory"
BOARD_MEMORY=$out/memory "$out/program" > "$out/log" 2>&1
result 'a hand that follows its words gets calibrated readings' $?

BOARD_MEMORY=$out/memory "$out/program" > "$out/log" 2>&1 && [ "$(grep -c . "$out/log")" -eq 1 ]
result 'after a reset it finds the calibration' $?

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
