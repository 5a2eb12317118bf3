#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What README.md, the manual and the headers say of costs, from what `make bench` and `make size` have measured in
# folder $1: the pages to 1 %, as the linker's order moves single instructions, the headers as promises.awk says.
# Says which line differs; ends with `N passed, N failed`. UPDATE=1: writes the pages again.
build=$1
cd "$(dirname "$0")/.." || exit 1
page=port/manual/targets.md
passed=0
failed=0

figure() { # TARGET NAME: a figure of the budgets, or the stack of a function
    awk -v what="$2" '$1 == what || ($1 == "stack" && $3 ~ "^" what "(_double_0.*)?$") {
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

# Functions of the headers, and what `make bench` calls their instructions.
cat > "$build/promised" << 'END'
invcal_apply apply
invcal_calibrate 18_positions_and_everything
invcal_calibrate_judged judged_18_positions
invcal_calibrate_six_faces six_faces
invcal_session_feed feed_1000_Hz
invcal_session_next next_orientation
invcal_session_solve session_solve
invcal_full_vector_add full_vector_add
invcal_full_vector_solve full_vector_solve
invcal_frame_add frame_add
invcal_frame_solve frame_solve
invcal_moves_feed gyro_feed
invcal_imu_solve imu_pass
invcal_turns_add turns_add
invcal_turns_next turns_next
invcal_turns_sigma turns_sigma
invcal_magnetometer_feed magnetometer_sample
invcal_magnetometer_solve magnetometer_solve
invcal_dip_add dip_add
invcal_dip_solve dip_solve
invcal_thermal_at thermal_at
invcal_thermal_calibrate 36_positions_thermal
END
awk -f tests/size/promises.awk "$build/promised" "$build/bench/m4f.figures" "$build/size/cortex-m-m4f/measured" \
    include/invcal/*.h > "$build/promises"
read -r kept _ broken _ << END
$(tail -n 1 "$build/promises")
END
sed '$d' "$build/promises"
passed=$((passed + kept))
failed=$((failed + broken))

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
