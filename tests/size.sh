#!/bin/sh
# SPDX-License-Identifier: MIT
#
# `make size`: flash, stack and structures on every target, against tests/size/budgets.txt.
# $1: folder to build in. TARGETS: folders, all under port/ unless given. V=1: every function too.
# UPDATE=1: writes the budgets anew. A target is called by its last folder. Everything is compiled
# anew: what is left of a room that is gone would count. How the stack is computed: size/stack.awk.
out=$1
budgets=tests/size/budgets.txt
passed=0
failed=0

cd "$(dirname "$0")/.." || exit 1
mkdir -p "$out"
rm -f "$out"/*.figures

# The value of a variable of a target's target.mk.
value() {
    printf 'TARGET := %s\ninclude %s/target.mk\nvalue:\n\t@echo "$(%s)"\n' "$1" "$1" "$2" |
        make -s --no-print-directory -f - value
}

make_target() {
    make -s -j2 --no-print-directory -f tests/size/size.mk TARGET="$target" BUILD="$out" "$1"
}

fail() {
    echo "FAIL $name: $1"
    failed=$((failed + 1))
}

linked() { # program: the library's part of it
    awk -f tests/size/hex.awk -f tests/size/sections.awk "$folder/$1.map" > "$folder/$1.sections"
    awk -v program="$1" -v library="$folder/src/" 'index($4, library) == 1 {
            kind = $1 ~ /^\.text/ ? "text" : "rodata"
            bytes[kind] += $3
            if (kind == "text") print "part", program, $3, substr($1, 7) | "sort -k 3,3nr"
        }
        END { for (kind in bytes) print "own", program, kind, bytes[kind] }' "$folder/$1.sections"
}

stacks() {
    "${prefix}objdump" -d "$folder/whole.elf" |
        awk -f tests/size/hex.awk -f tests/size/code.awk > "$folder/code"
    grep '^frame\.' $budgets > "$folder/frames"
    awk -f tests/size/public.awk include/invcal/*.h > "$folder/public"
    case $prefix in avr-*) pushed=2 ;; *) pushed=0 ;; esac
    awk -v return_size=$pushed -v library="$folder/src/" -f tests/size/stack.awk "$folder/frames" \
        "$folder/public" "$folder/whole.sections" "$folder/code" "$folder"/src/*.su
}

undeclared() { # a public function that is not seen would not be measured
    awk -f tests/size/public.awk include/invcal/*.h src/*.h > "$folder/declared"
    "${prefix}nm" -g --defined-only "$folder"/src/*.o | awk 'FILENAME != "-" { known[$2]; next }
        $2 == "T" && !($3 in known) { print "fault", $3 " is global, and declared in no header" }' \
        "$folder/declared" -
}

measure() {
    "${prefix}size" -A "$folder"/src/*.o | awk -f tests/size/rooms.awk
    linked core
    linked everything
    linked whole | grep '^own'
    "${prefix}nm" -S -t d "$folder/tests/size/structures.o" |
        awk 'sub(/^size_of_/, "", $4) { print "sizeof." $4, $2 + 0 }'
    stacks
    undeclared
}

size_of() {
    target=${1%/}
    name=${target##*/}
    folder=$out/$(echo "${target#port/}" | tr / -)
    prefix=$(value "$target" PREFIX)
    run=$(value "$target" RUN)
    for command in "${prefix}gcc" "${run%% *}"; do
        if ! command -v "$command" > /dev/null; then
            fail "$command is not installed: make deps"
            return
        fi
    done
    printf '\n== %s: %sgcc %s, -Os, float\n   %s\n' "${target#port/}" "$prefix" \
        "$("${prefix}gcc" -dumpversion)" "$(value "$target" CPU)"
    rm -rf "$folder"
    if ! make_target programs > "$folder.log" 2>&1; then
        cat "$folder.log"
        fail "does not build"
        return
    fi
    measure > "$folder/measured"
    awk -f tests/size/figures.awk "$folder/measured" > "$out/$name.figures"
    # Not every emulator has an exit status of the program: its last word tells.
    make_target depth > "$folder/depth.log" 2>&1
    if ! grep -q 'OK' "$folder/depth.log"; then
        cat "$folder/depth.log"
        fail "tests/size/depth.c does not run"
        return
    fi
    grep -oE 'invcal_[a-z_]+ [0-9]+' "$folder/depth.log" > "$folder/depths"
    awk -v target="$name" -v V="$V" -f tests/size/report.awk $budgets "$folder/measured" \
        "$out/$name.figures" "$folder/depths" > "$folder/report"
    sed '$d' "$folder/report"
    passed=$((passed + $(tail -n 1 "$folder/report" | cut -d ' ' -f 1)))
    failed=$((failed + $(tail -n 1 "$folder/report" | cut -d ' ' -f 3)))
}

for target in ${TARGETS:-$(find port -name target.mk | sed 's|/target.mk||' | sort)}; do
    size_of "$target"
done
if [ -n "$UPDATE" ]; then
    awk -f tests/size/update.awk $budgets "$out"/*.figures > "$out/budgets.txt" &&
        mv "$out/budgets.txt" $budgets && echo "$budgets: written anew"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
