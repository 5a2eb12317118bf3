#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs every test that stands in the build folder $1, and the scripts beside this file.
# Prints what failed, a line for each suite, and at the end `N passed, N failed`.
# CC, CFLAGS and UNITY are handed on to scripts that compile something.
build=$1
tests=$(dirname "$0")
log=$build/run.log
passed=0
failed=0

# A suite tells its result as "N Tests F Failures I Ignored" (Unity) or "N passed, N failed".
# One that says neither has crashed, and counts as one failure.
count() {
    result=$(awk '
        / Tests .* Failures .* Ignored/ { p = $1 - $3 - $5; f = $3; said = 1 }
        /^[0-9]+ passed, [0-9]+ failed$/ { p = $1; f = $3; said = 1 }
        END { if (!said || (status && !f)) f++; print p + 0, f + 0 }' status="$2" "$log")
    passed=$((passed + ${result% *}))
    failed=$((failed + ${result#* }))
    [ "$2" -eq 0 ] || cat "$log"
    echo "$1: ${result% *} passed, ${result#* } failed"
}

suite() {
    name=$1
    shift
    "$@" > "$log" 2>&1
    count "$name" $?
}

for real in float double; do
    for program in "$build/$real"/test_*; do
        [ -x "$program" ] && suite "$real ${program##*/}" "$program"
    done
done
suite unity sh "$tests/unity/selftest.sh" "$build/unity"
suite library sh "$tests/library.sh" "$build"
suite readme sh "$tests/readme.sh" "$build"
suite tool sh "$tests/tool/tool_test.sh" "$build/invcal" "$build/tool"
suite log sh "$tests/tool/log_test.sh" "$build/invcal" "$build/tool"
suite input sh "$tests/tool/input_test.sh" "$build/invcal" "$build/tool"
suite citizen sh "$tests/tool/citizen_test.sh" "$build/invcal" "$build/tool"
suite thermal sh "$tests/tool/thermal_test.sh" "$build/invcal" "$build/tool"
suite allan sh "$tests/tool/allan_test.sh" "$build/invcal" "$build/tool"
suite plan sh "$tests/tool/plan_test.sh" "$build/invcal" "$build/tool"
suite plan-report sh "$tests/tool/plan_report_test.sh" "$build/invcal" "$build/tool"
suite export sh "$tests/tool/export_test.sh" "$build/invcal" "$build/tool"
suite report sh "$tests/tool/report_test.sh" "$build/invcal" "$build/tool"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
