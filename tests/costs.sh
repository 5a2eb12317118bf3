#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Checks the costs that README.md and the manual state against what `make bench` and `make size` measured in folder $1:
# within 1 %, as the link order shifts single instructions. Names the lines that differ; ends with
# `N passed, N failed`. UPDATE=1: rewrites them.
build=$1
cd "$(dirname "$0")/.." || exit 1
page=port/manual/targets.md
passed=0
failed=0

figure() { # TARGET NAME: a figure of the budgets, or the stack of a function
    awk -v what="$2" '$1 == what || ($1 == "stack" && $3 ~ "^" what "(_float_[0-9]+)?$") {
            print $1 == what ? $2 : $4
            exit
        }' "$build/bench/$1.figures" "$build/size/$1.figures" "$build"/size/*"$1"/measured |
        sed -e ':a' -e 's/^\([0-9]\{1,\}\)\([0-9]\{3\}\)/\1,\2/' -e 'ta'
}

row() { # TITLE NAME
    line="| $1 |"
    for target in m0plus m4f rv32imac rv32imafc atmega1284p; do
        line="$line $(figure $target "$2") |"
    done
    expect "| $1 |" "$line"
}

# The line of the page that begins with $1 must begin with $2.
expect() {
    case $2 in *'|  |'* | *'takes ')
        echo "not measured: $2"
        failed=$((failed + 1))
        return
        ;;
    esac
    if [ -n "$UPDATE" ]; then
        awk -v head="$1" -v line="$2" 'index($0, head) == 1 {
                $0 = head ~ /[|]$/ ? line : line substr($0, length(head) + match( \
                    substr($0, length(head) + 1), / /))
            }
            { print }' "$page" > "$build/page.new" && cat "$build/page.new" > "$page"
    fi
    if awk -v head="$1" -v line="$2" '
            function number(word) { gsub(/,/, "", word); return word ~ /^[0-9]+$/ ? word : "" }
            index($0, head) == 1 {
                n = split(line, wanted, " ")
                split($0, is, " ")
                for (i = 1; i <= n; i++) {
                    a = number(wanted[i]); b = number(is[i])
                    if (a == "" ? wanted[i] != is[i] : b == "" || 100 * (a - b) > a || 100 * (b - a) > a) exit
                }
                found = 1
            } END { exit !found }' "$page"; then
        passed=$((passed + 1))
    else
        echo "$page should say: $2"
        failed=$((failed + 1))
    fi
}

row "add a position" add_position
row "18 positions and the solve" 18_positions_and_solve
row "the same with every σ and the verdict" 18_positions_and_everything
row "apply a calibration to a sample" apply
row "feed a sample at rest, 1 kHz" feed_1000_Hz
row "where to turn next" next_orientation
row "solve a session of 18 positions" session_solve
row "the same, one of them wrong" session_solve_1_wrong
row "a sample of one axis into \`allan.h\`" allan_push
row "a sample of the gyroscope" gyro_feed
row "both sensors, 24 rests and 23 moves" imu_solve
row "a sample of the magnetometer, on average" magnetometer_with_looks
row "36 positions at two temperatures, everything" 36_positions_thermal
row "the calibration at a temperature" thermal_at
row "flash, the core" flash.core
row "flash, everything" flash
row "stack, \`invcal_solve\`" invcal_solve
row "stack, \`invcal_session_feed\`" invcal_session_feed
row "stack, \`invcal_session_solve\`" invcal_session_solve
page=README.md
head='Cortex-M4F, '
expect "$head" "$head$(figure m4f flash.product)"
expect '| invcal, the core |' \
    "| invcal, the core | 9 | $(figure m4f 18_positions_and_solve) | $(figure m4f flash.core) | $(figure m4f memory.core) | 0 |"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
