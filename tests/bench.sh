#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # target_facts sets what is not set here
#
# `make bench`: what each operation costs on every target that can count, against
# tests/bench/budgets.txt and the goals in goals.txt; and cycles of what a user waits for, where cycles.py knows the
# processor. $1: folder to build in. TARGETS: folders, by default all under port/. UPDATE=1: rewrites the budgets.
# All is at -Os; some operations also at the target's other LEVELS: "apply-O2". The objects are those of `make size`.
build=$1/size
logs=$1/bench
budgets=tests/bench/budgets.txt
goals=tests/bench/goals.txt
also='18_positions_and_solve|apply|feed_100_Hz|feed_1000_Hz|next_orientation|session_solve|save_session'

cd "$(dirname "$0")/.." || exit 1
. tests/target.sh
rm -rf "$logs"
mkdir -p "$logs"

bench_at() { # LEVEL: runs, adds the figures
    level=$1
    log=$logs/$name-$level.log
    target_facts "$build" "$target" "$level" || exit 1
    # shellcheck disable=SC2086 # a command with its arguments
    if {
        target_make "$build" "$target" LEVEL="$level" -j2 bench && timeout 300 $run_counting "$out/bench.elf"
    } > "$log" 2>&1 < /dev/null && grep -q '^OK' "$log"; then
        awk -v level="$level" -v also="^($also)\$" 'NF != 2 { next }
            level == "Os" { print $1, $2 }
            level != "Os" && $1 ~ also { print $1 "-" level, $2 }' "$log" >> "$logs/$name.figures"
    else
        cat "$log"
        return 1
    fi
}

trace() { # after bench_at Os: the cycles of what a user waits for
    [ -n "$processor" ] || return 0
    need "${compiler%gcc}objdump" python3 || return
    trace=$logs/trace
    # shellcheck disable=SC2086 # a command with its arguments
    target_make "$build" "$target" LEVEL=Os traced &&
        timeout 300 ${run%% *} -d exec,nochain -D "$trace" ${run#* } "$out/traced.elf" > "$log.traced" 2>&1 < /dev/null &&
        "${compiler%gcc}objdump" -d "$out/traced.elf" > "$out/traced.dis" &&
        python3 tests/bench/cycles.py "$processor" "$out/traced.dis" "$log" < "$trace" > "$logs/$name.cycles"
    status=$?
    rm -f "$trace"
    return $status
}

for target in ${TARGETS:-$(all_targets)}; do
    target=${target%/}
    name=${target##*/}
    target_facts "$build" "$target" || exit 1
    [ -n "$unit" ] || continue
    need "$compiler" "$emulator" || exit 1
    echo "$name $unit" >> "$logs/units"
    for each in $levels; do
        if ! bench_at "$each" || { [ "$each" = Os ] && ! trace; }; then
            echo "$name-$each fault" >> "$logs/units"
        fi
    done
done

if [ -n "$UPDATE" ]; then
    awk -f tests/size/update.awk $budgets "$logs"/*.figures > "$logs/budgets.txt" &&
        mv "$logs/budgets.txt" $budgets && echo "$budgets: rewritten"
fi
awk -f tests/bench/report.awk $budgets $goals "$logs/units" "$logs"/*.figures
