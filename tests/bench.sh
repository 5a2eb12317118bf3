#!/bin/sh
# SPDX-License-Identifier: MIT
#
# `make bench`: what each operation takes on every target that can count, against
# tests/bench/budgets.txt. $1: folder to build in. TARGETS: folders, all under port/ unless given.
# UPDATE=1: writes the budgets anew.
out=$1/bench
budgets=tests/bench/budgets.txt

cd "$(dirname "$0")/.." || exit 1
rm -rf "$out"
mkdir -p "$out"

target_make() {
    make -s -f port/build.mk BUILD="$build" TARGET="$target" "$@"
}

build=$1/targets
for target in ${TARGETS:-$(find port -name target.mk | sed 's|/target.mk||' | sort)}; do
    counter=$(target_make counter) || exit 1
    unit=$(echo "$counter" | head -n 1)
    run=$(echo "$counter" | sed -n 2p)
    name=${target##*/}
    [ -n "$unit" ] || continue
    { read -r compiler && read -r emulator && read -r folder; } << EOF
$(target_make facts)
EOF
    for command in "$compiler" "$emulator"; do
        if ! command -v "$command" > /dev/null; then
            echo "$command is not installed: make deps" >&2
            exit 1
        fi
    done
    # shellcheck disable=SC2086 # a command with its arguments
    if target_make -j2 bench && $run "$folder/bench.elf" > "$out/$name.log" 2>&1 < /dev/null &&
        grep -q '^OK' "$out/$name.log"; then
        awk 'NF == 2 { print $1, $2 }' "$out/$name.log" > "$out/$name.figures"
        echo "$name $unit" >> "$out/units"
    else
        cat "$out/$name.log"
        echo "$name fault" >> "$out/units"
    fi
done

if [ -n "$UPDATE" ]; then
    awk -f tests/size/update.awk $budgets "$out"/*.figures > "$out/budgets.txt" &&
        mv "$out/budgets.txt" $budgets && echo "$budgets: written anew"
fi
awk -f tests/bench/report.awk $budgets "$out/units" "$out"/*.figures
