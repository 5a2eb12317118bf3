#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # target_facts sets what is not set here
#
# `make bench`: what each operation costs on every target that can count, against
# tests/bench/budgets.txt. $1: folder to build in. TARGETS: folders, by default all under port/.
# UPDATE=1: rewrites the budgets.
build=$1/targets
logs=$1/bench
budgets=tests/bench/budgets.txt

cd "$(dirname "$0")/.." || exit 1
. tests/target.sh
rm -rf "$logs"
mkdir -p "$logs"

for target in ${TARGETS:-$(all_targets)}; do
    target=${target%/}
    name=${target##*/}
    target_facts "$build" "$target" || exit 1
    [ -n "$unit" ] || continue
    need "$compiler" "$emulator" || exit 1
    # shellcheck disable=SC2086 # a command with its arguments
    if {
        target_make "$build" "$target" -j2 bench && timeout 300 $run_counting "$out/bench.elf"
    } > "$logs/$name.log" 2>&1 < /dev/null && grep -q '^OK' "$logs/$name.log"; then
        awk 'NF == 2 { print $1, $2 }' "$logs/$name.log" > "$logs/$name.figures"
        echo "$name $unit" >> "$logs/units"
    else
        cat "$logs/$name.log"
        echo "$name fault" >> "$logs/units"
    fi
done

if [ -n "$UPDATE" ]; then
    awk -f tests/size/update.awk $budgets "$logs"/*.figures > "$logs/budgets.txt" &&
        mv "$logs/budgets.txt" $budgets && echo "$budgets: rewritten"
fi
awk -f tests/bench/report.awk $budgets "$logs/units" "$logs"/*.figures
