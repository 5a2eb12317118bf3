#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Compiles the programs of README.md and of three pages of the manual, and runs them on the board of tests/readme, with
# the float library of the build folder $1: each must calibrate, go on after a reset, and after another one find what
# it stored. CC and CFLAGS as for the library.
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

# Keeps the memory; what is shown goes to $out/log.
runs() {
    BOARD_MEMORY=$out/memory "$out/program" > "$out/log" 2>&1
}

# builds PAGE LINES: the first C block of a page, of at most LINES lines; empties the memory.
builds() {
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
}

# Puts the session of a double build into the memory, as firmware with other build options leaves it.
saves_foreign_session() {
    cat > "$out/other.c" << 'END'
#include "board.h"

int main(void)
{
    static invcal_session session;

    return invcal_session_init(&session, sizeof session, 16384, 100) != INVCAL_OK ||
           invcal_session_save(&session, &board_progress) != INVCAL_OK;
}
END
    # shellcheck disable=SC2086 # flags
    ${CC:-cc} $CFLAGS -std=c99 -DINVCAL_DOUBLE=1 -I"$root/include" -I"$here/readme" -I"$here/hand" "$out/other.c" \
        "$here/readme/board.c" "$here/hand/hand.c" "$build/double/libinvcal.a" -lm -o "$out/other" > "$out/log" 2>&1 &&
        BOARD_MEMORY=$out/memory "$out/other" >> "$out/log" 2>&1
}

# is_guided PAGE: a program that shows where to turn.
is_guided() {
    BOARD_RESET=6 runs
    [ $? -eq 3 ] && runs
    result "$1: a hand that follows its words gets calibrated readings, despite a reset" $?

    places=$(grep -c ' up' "$out/log")
    echo "after a reset in move 6 it shows $places places" > "$out/log"
    [ "$places" -ge 1 ] && [ "$places" -le 11 ]
    result "$1: after the reset it goes on" $?

    runs && [ "$(grep -c . "$out/log")" -eq 1 ]
    result "$1: switched on again, it finds the calibration" $?
}

# says NAME TEXT CHANGE [FLAG...]: the program with a mistake, made by sed, or by another flag, says what is wrong.
says() {
    name=$1
    text=$2
    sed "$3" "$out/program.c" > "$out/wrong.c"
    shift 3
    # shellcheck disable=SC2086 # flags
    ${CC:-cc} $CFLAGS -std=c99 -w "$@" -I"$root/include" -I"$here/readme" -I"$here/hand" "$out/wrong.c" \
        "$here/readme/board.c" "$here/hand/hand.c" "$build/float/libinvcal.a" -lm -o "$out/wrong" > "$out/log" 2>&1 &&
        BOARD_MEMORY=$memory timeout 3 "$out/wrong" 2>&1 | head -n 100 > "$out/log"
    grep -qx "$text" "$out/log"
    result "README.md: $name, and it says \"$text\"" $?
}

builds README.md 25
memory=$out/memory
says "a rate of 5" "invalid rate" 's/16384, 100)/16384, 5)/'
says "a scale of 0" "invalid scale" 's/16384, 100)/0, 100)/'
says "counts of another range" "far from the field: wrong scale or offset" 's/16384, 100)/163840000, 100)/'
says "no session was begun" "not begun" 's/if (invcal_session_init.*/if (0)/'
says "a library with other options" "other build" '' -DINVCAL_MAX_POSITIONS=64
memory=$out/no/such/file
says "a memory that fails" "not saved" ''
is_guided README.md
builds port/manual/gyroscope_firmware.md 75
is_guided port/manual/gyroscope_firmware.md

builds port/manual/wearable.md 45
BOARD_RESET=12 runs
[ $? -eq 3 ] && runs
result 'port/manual/wearable.md: after lying around for a month, despite a reset, its readings are calibrated' $?
BOARD_RESET=9 runs
[ $? -eq 3 ] && grep -q '^day 1: |a| is 1 g within [0-2]\.' "$out/log"
result 'port/manual/wearable.md: switched on again, it finds the calibration' $?

head -c 16384 /dev/zero > "$out/memory"
saves_foreign_session && runs
result 'port/manual/wearable.md: the stored session of another build does no harm' $?

builds port/manual/thermal.md 60
runs && [ "$(grep -c '^[cw]' "$out/log")" -eq 3 ]
result 'port/manual/thermal.md: a hand that follows its words gets calibrated readings at every temperature' $?
runs && [ "$(grep -c . "$out/log")" -eq 1 ]
result 'port/manual/thermal.md: switched on again, it finds the calibration' $?

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
