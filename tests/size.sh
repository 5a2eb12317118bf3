#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # target_facts sets what is not set here
#
# `make size`: flash, stack and structures on every target, against tests/size/budgets.txt and the
# goals in goals.txt. $1: folder to build in. TARGETS: folders, by default all under port/. V=1: every
# function, too. UPDATE=1: rewrites the budgets. A target has the name of its last folder. Everything
# is recompiled, as objects of deleted modules would count. How the stack is computed: size/stack.awk.
# All is at -Os; programs also at the target's other LEVELS: "flash.product-O2".
build=$1
budgets=tests/size/budgets.txt
goals=tests/size/goals.txt
passed=0
failed=0

cd "$(dirname "$0")/.." || exit 1
. tests/target.sh
mkdir -p "$build"
rm -f "$build"/*.figures

make_target() {
    make -s -j2 --no-print-directory -f tests/size/size.mk TARGET="$target" BUILD="$build" LEVEL="$level" "$1"
}

fail() {
    echo "FAIL $name: $1"
    failed=$((failed + 1))
}

linked() { # program: the library's part of it
    awk -f tests/size/hex.awk -f tests/size/sections.awk "$out/$1.map" > "$out/$1.sections"
    awk -v program="$1" -v library="$out/src/" 'index($4, library) == 1 {
            kind = $1 ~ /^\.text/ ? "text" : "rodata"
            bytes[kind] += $3
            if (kind == "text") print "part", program, $3, substr($1, 7) | "sort -k 3,3nr"
        }
        END { for (kind in bytes) print "own", program, kind, bytes[kind] }' "$out/$1.sections"
}

stacks() {
    "${prefix}objdump" -d "$out/whole.elf" |
        awk -f tests/size/hex.awk -f tests/size/code.awk > "$out/code"
    grep '^frame\.' $budgets > "$out/frames"
    case $prefix in avr-*) pushed=2 ;; *) pushed=0 ;; esac
    awk -v return_size=$pushed -v library="$out/src/" -f tests/size/stack.awk "$out/frames" \
        "$out/public" "$out/whole.sections" "$out/code" "$out"/src/*/*.su
}

undeclared() { # a global function that no header declares would escape the measurement
    "${prefix}nm" -g --defined-only "$out"/src/*/*.o | awk 'FILENAME != "-" { known[$2]; next }
        $2 == "T" && !($3 in known) { print "fault", $3 " is global, and declared in no header" }' \
        "$out/public" "$out/declared" -
}

# All of it, libc and the compiler's library too. Uninitialised data is not flash.
flash() { # program
    "${prefix}size" -A "$out/$1.elf" | awk -v program="$1" '
        $1 ~ /^\.(text|rodata|data|ARM\.exidx|s?rodata|sdata|vectors|init|fini)/ { n += $2 }
        END { print "linked." program, n + 0 }'
}

# The parts of an example firmware, but for start-up and the simulated world.
parts() { # firmware
    awk -f tests/size/hex.awk -f tests/size/sections.awk "$out/$1.map" |
        awk -v program="$1" -v out="$out/" '
            index($4, out "src/") == 1 { n["invcal"] += $3 }
            $4 ~ /\/firmware(_imu)?\/[a-z_]+\.o$/ { n["own"] += $3 }
            $4 ~ /\.a\(/ { n["libc"] += $3 }
            END { for (part in n) print program "." part, n[part] }'
}

# RAM of the program of README.md without its stack, the frame of its main, and what it calls.
program_memory() {
    "${prefix}size" -A "$out/program.elf" |
        awk '$1 ~ /^\.s?(data|bss)$/ { n += $2 } END { print "static.program", n + 0 }'
    awk '$1 ~ /:main$/ { print "frame.main", $2 }' "$out/program.su"
    "${prefix}nm" -u "$out/program.o" | awk '$2 ~ /^invcal_/ { print "called", $2 }'
}

measure() {
    "${prefix}size" -A "$out"/src/*/*.o | awk -f tests/size/modules.awk
    flash core
    flash judged
    flash product
    flash program
    flash imu
    linked product
    linked core | grep '^own'
    linked whole | grep '^own'
    program_memory
    "${prefix}nm" -S -t d "$out/tests/size/structures.o" |
        awk 'sub(/^size_of_/, "", $4) { print "sizeof." $4, $2 + 0 }'
    stacks
    undeclared
}

build_at() { # LEVEL: builds, measures, adds the figures
    level=$1
    target_facts "$build" "$target" "$level" || exit 1
    prefix=${compiler%gcc}
    rm -rf "$out"
    if ! make_target programs > "$out.log" 2>&1; then
        cat "$out.log"
        fail "does not build at $level"
        return 1
    fi
    measure > "$out/measured"
    awk -v level="$level" -f tests/size/figures.awk "$out/measured" >> "$build/$name.figures"
}

size_of() {
    target=${1%/}
    name=${target##*/}
    target_facts "$build" "$target" || exit 1
    if ! need "$compiler" "$emulator"; then
        failed=$((failed + 1))
        return
    fi
    printf '\n== %s: %s %s, %s, float\n   %s\n' "${target#port/}" "$compiler" \
        "$("$compiler" -dumpversion)" "$levels" "$cpu"
    : > "$build/$name.figures"
    build_at Os || return
    os=$out
    if [ "$name" = m4f ]; then
        make_target firmwares >> "$out.log" 2>&1 || { fail "the example firmware does not build"; return; }
        { parts firmware; parts firmware_imu; } | sort >> "$build/$name.figures"
    fi
    # Not every emulator passes on the program's exit status: what it prints last decides.
    make_target depth > "$os/depth.log" 2>&1
    if ! grep -q 'OK' "$os/depth.log"; then
        cat "$os/depth.log"
        fail "tests/size/depth.c does not run"
        return
    fi
    grep -oE 'invcal_[a-z_0-9]+ [0-9]+' "$os/depth.log" > "$os/depths"
    for other in ${levels#Os}; do
        build_at "$other" || return
        sed -n "s/^fault /&at $other: /p" "$out/measured" >> "$os/measured"
    done
    awk -v target="$name" -v V="$V" -f tests/size/report.awk $budgets $goals "$os/measured" \
        "$build/$name.figures" "$os/depths" > "$os/report"
    sed '$d' "$os/report"
    passed=$((passed + $(tail -n 1 "$os/report" | cut -d ' ' -f 1)))
    failed=$((failed + $(tail -n 1 "$os/report" | cut -d ' ' -f 3)))
}

for target in ${TARGETS:-$(all_targets)}; do
    size_of "$target"
done
if [ -n "$UPDATE" ]; then
    awk -f tests/size/update.awk $budgets "$build"/*.figures > "$build/budgets.txt" &&
        mv "$build/budgets.txt" $budgets && echo "$budgets: rewritten"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
