#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # target_facts sets what is not set here
#
# sh tests/targets.sh BUILD [TARGET...]
# Builds the unit tests for every target folder under port/, or those named, runs them in its
# emulator, two images at a time, and compares the digest of what it computes with the host's, which
# BUILD/float/digest prints. Shows what failed, a table, why tests were skipped, and at the
# end `N passed, N failed`.
build=$1
shift
here=$(dirname "$0")
limit=600 # seconds for one image
. "$here/target.sh"

# Those with the long tests come first, as they take longest.
if [ $# -eq 0 ]; then
    all=$(ls port/*/target.mk port/*/*/target.mk)
    # shellcheck disable=SC2046,SC2086 # names without blanks
    set -- $(grep -l '^LONG' $all) $(grep -L '^LONG' $all)
fi

for target; do
    target_facts "$build/targets" "${target%/target.mk}" || exit 1
    need "$compiler" "$emulator" || exit 1
done

# A line for each image: its log, and the command that runs it.
mkdir -p "$build/targets"
list=$build/targets/images
: > "$list"
for target; do
    target=${target%/target.mk}
    target_facts "$build/targets" "$target" || exit 1
    rm -f "$out"/*.elf "$out"/*.log # of suites that no longer exist
    if ! target_make "$build/targets" "$target" -j2 tests digest; then
        echo "$target does not build" >&2
        exit 1
    fi
    for image in "$out"/*.elf; do
        echo "${image%.elf}.log $run $image" >> "$list"
    done
done

# shellcheck disable=SC2016 # $log and the like belong to the inner shell
xargs -L 1 -P 2 sh -c 'limit=$1 log=$2; shift 2
    timeout -k 5 "$limit" "$@" > "$log" 2>&1 < /dev/null
    echo "exit status $?" >> "$log"' image "$limit" < "$list"

"$build/float/digest" > "$build/targets/host.log" || exit 1
for target; do
    target_facts "$build/targets" "${target%/target.mk}" || exit 1
    awk -f "$here/digest/compare.awk" "$build/targets/host.log" "$out"/digest*.log > "$out/compared.log"
    echo "$out/compared.log" >> "$list"
done
# The images of a target in a row; of the digest only how it compares.
# shellcheck disable=SC2046 # names without blanks
awk -f "$here/targets.awk" $(cut -d ' ' -f 1 "$list" | grep -v '/digest[^/]*$' | sort) > "$build/targets/result"
{
    cat "$build/targets/result"
    # The rows of its table: target, tests, passed, failed, ...
    awk 'NF == 6 && $4 == "0" { print $1, $3 }' "$build/targets/result" | while read -r target passed; do
        sh "$here/floor.sh" "$passed+" "target-$target" || echo "0 passed, 1 failed"
    done
} | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next }
    { print }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
