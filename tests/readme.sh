#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Compiles and runs the C example of README.md against the float library of the build folder $1.
# CC and CFLAGS as for the library.
build=$1
here=$(dirname "$0")
root=$here/..
out=$build/readme
mkdir -p "$out"

fail() {
    echo "readme: $1: FAIL"
    [ -s "$out/log" ] && cat "$out/log"
    echo "0 passed, 1 failed"
    exit 1
}

: > "$out/log"
awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' "$root/README.md" > "$out/example.c"
[ -s "$out/example.c" ] || fail "README.md has no C example"
lines=$(grep -c . "$out/example.c")
[ "$lines" -le 30 ] || fail "the example has $lines lines: more than 30"
# shellcheck disable=SC2086
${CC:-cc} $CFLAGS -std=c99 -Wall -Wextra -pedantic -Werror -I"$root/include" "$out/example.c" \
    "$build/float/libinvcal.a" -lm -o "$out/example" > "$out/log" 2>&1 || fail "the example compiles"
"$out/example" > "$out/log" 2>&1 || fail "the example runs"
# What it prints is quoted below it.
awk '/^```text$/ { on = 1; next } /^```$/ { on = 0 } on' "$root/README.md" |
    diff - "$out/log" > "$out/diff" || { cat "$out/diff" >> "$out/log"; fail "prints what README says"; }
echo "readme: the example compiles, runs and prints what README says: PASS"
echo "1 passed, 0 failed"
