#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Compiles the program of README.md, and that of port/manual/gyroscope_firmware.md, and runs them on the board of
# tests/readme, with the float library of the build folder $1: each must calibrate, go on after a reset, and after
# another one find what it has stored. CC and CFLAGS as for the library.
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

# With the memory as it is; what is shown stands in $out/log.
runs() {
    BOARD_MEMORY=$out/memory "$out/program" > "$out/log" 2>&1
}

# program PAGE LINES: its first block of C, of at most so many lines.
program() {
    awk '/^```c$/ { on = 1; next } on && /^```$/ { exit } on' "$root/$1" > "$out/program.c"
    lines=$(grep -c . "$out/program.c")
    echo "$lines lines" > "$out/log"
    [ "$lines" -gt 10 ] && [ "$lines" -le "$2" ]
    result "$1: the program has at most $2 lines" $?

    # shellcheck disable=SC2086 # flags
    ${CC:-cc} $CFLAGS -std=c99 -Wall -Wextra -pedantic -Werror -I"$root/include" -I"$here/readme" -I"$here/hand" \
        "$out/program.c" "$here/readme/board.c" "$here/hand/hand.c" "$build/float/libinvcal.a" -lm \
        -o "$out/program" > "$out/log" 2>&1
    result "$1: it compiles" $?

    head -c 16384 /dev/zero > "$out/memory"
    BOARD_RESET=6 runs
    [ $? -eq 3 ] && grep -cx '.* up' "$out/log" > "$out/before" && runs && grep -cx '.* up.*' "$out/log" > "$out/after"
    result "$1: a hand that follows its words, through a reset, gets calibrated readings" $?

    echo "places before and after the reset: $(cat "$out/before") $(cat "$out/after")" > "$out/log"
    [ "$(cat "$out/after")" -le 11 ]
    result "$1: after the reset it goes on" $?

    runs && [ "$(grep -c . "$out/log")" -eq 1 ]
    result "$1: once more switched on it finds the calibration" $?
}

program README.md 25
program port/manual/gyroscope_firmware.md 75

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
