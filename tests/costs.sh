#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What README.md, the manual and the headers say of costs, from what `make bench` and `make size` have measured in
# folder $1: costs.awk says how closely for the pages, promises.awk for the headers. Says which line differs; ends with
# `N passed, N failed`. UPDATE=1: writes the numbers again.
build=$1
cd "$(dirname "$0")/.." || exit 1
targets=port/manual/targets.md
passed=0
failed=0

says() { # PAGE TEXT: with {numbers} that were measured
    if [ -n "$UPDATE" ]; then
        awk -v update=1 -v text="$2" -f tests/costs.awk "$1" > "$build/page.new" && cat "$build/page.new" > "$1"
    fi
    answer=$(awk -v text="$2" -f tests/costs.awk "$1")
    if [ -z "$answer" ]; then
        passed=$((passed + 1))
    else
        echo "$answer"
        failed=$((failed + 1))
    fi
}

# ---- figures ----------------------------------------------------------------------------------------------

for name in m4f m0plus rv32imac rv32imafc atmega1284p; do
    cat "$build/bench/$name.figures" "$build/size/$name.figures" "$build"/size/*"-$name-Os/measured" > "$build/all.$name"
done

raw() { # TARGET NAME: a figure of the budgets, or the stack of a function
    awk -v what="$2" '$1 == what || ($1 == "stack" && $3 == what) {
            print ($1 == what ? $2 : $4)
            exit
        }' "$build/all.$1"
}

commas() { sed -e ':a' -e 's/^\([0-9]\{1,\}\)\([0-9]\{3\}\)/\1,\2/' -e 'ta'; }

figure() { raw "$@" | commas; } # 1,234

rounded() { # NUMBER: ~ and its first two digits
    [ -z "$1" ] || echo "~$(awk -v n="$1" 'BEGIN {
        for (unit = 1; n >= 100 * unit; ) unit *= 10
        for (digits = 0; n < 10 * unit && digits < 4; digits++) unit /= 10
        printf "%.*f\n", digits, int(n / unit + 0.5) * unit
    }' | commas)"
}

about() { rounded "$(raw "$@")"; } # ~1,200

over() { # TARGET NAME DIVISOR: ~0.12
    dividend=$(raw "$1" "$2")
    [ -z "$dividend" ] || rounded "$(awk -v a="$dividend" -v b="$3" 'BEGIN { print a / b }')"
}

ms() { # TARGET NAME: ~4.2, at 64 MHz (M4F), 48 (M0+) or 16 (AVR, whose figures are cycles)
    awk -v what="$2" 'BEGIN { mhz["m4f.cycles"] = 64; mhz["m0plus.cycles"] = 48; mhz["atmega1284p.figures"] = 16 }
        { file = FILENAME; sub(/.*\//, "", file) }
        $1 == what && file in mhz { print $2 / mhz[file] / 1000; exit }' "$build/bench/$1".[cf]* > "$build/ms"
    rounded "$(cat "$build/ms")"
}

# ---- README.md, targets.md ----------------------------------------------------------------------------------

row() { # TITLE NAME: on each target
    line="| $1 |"
    for target in m4f m0plus rv32imac rv32imafc atmega1284p; do
        line="$line {$(figure $target "$2")} |"
    done
    says $targets "$line"
}
row "add a position" add_position
row "18 positions and the solve" 18_positions_and_solve
row "the same with every σ and the verdict" 18_positions_and_everything
row "apply a calibration to a sample" apply
row "feed a sample at rest, 100 Hz" feed_100_Hz
row "the same, 1 kHz" feed_1000_Hz
row "where to turn next" next_orientation
row "judge a session of 18 positions" session_solve
row "the same, one of them wrong" session_solve_1_wrong
row "judge a session of 16 positions" session_solve_16
row "save a session of 18 positions" save_session
row "load it" load_session
row "save a calibration" save
row "load that" load
row "a sample of one axis into \`allan.h\`" allan_push
row "a sample of the gyroscope" gyro_feed
row "both sensors, 24 rests and 23 moves" imu_solve
row "a sample of the magnetometer, on average" magnetometer_with_looks
row "36 positions at two temperatures, everything" 36_positions_thermal
row "the calibration at a temperature" thermal_at
row "flash, the core" flash.core
row "flash, the program of [README.md](../../README.md#in-your-firmware)" flash.program
row "flash, the whole library alone" flash
row "RAM with stack, that program" memory.program
row "stack, \`invcal_sums_solve\`" invcal_sums_solve
row "stack, \`invcal_session_feed\`" invcal_session_feed
row "stack, \`invcal_session_solve\`" invcal_session_solve

build_row() { # TITLE TARGET SUFFIX
    line="| $1 |"
    for what in 18_positions_and_solve flash.core session_solve flash.product flash.program memory.program; do
        line="$line {$(figure "$2" "$what$3")} |"
    done
    says $targets "$line"
    line="| $1 |"
    for what in flash.program memory.program session_solve; do line="$line {$(figure "$2" "$what$3")} |"; done
    case $3 in '' | -O2) says README.md "$line" ;; esac
}
build_row "Cortex-M4F, -Os" m4f
build_row "Cortex-M4F, -O2" m4f -O2
build_row "Cortex-M4F, -Og" m4f -Og
build_row "Cortex-M4F, -O3" m4f -O3
build_row "Cortex-M4F, -O2, \`INVCAL_FAST=1\`" m4f -fast
build_row "Cortex-M0+, -Os" m0plus
build_row "Cortex-M0+, -O2" m0plus -O2

time_row() { # TITLE NAME
    says $targets "| $1 | {$(ms m4f "$2")} | {$(ms m0plus "$2")} | {$(ms atmega1284p "$2")} |"
}
time_row "takes a sample, 100 Hz, on average" feed_100_Hz
time_row "finds where to turn next" next_orientation
time_row "adds 18 positions and solves, without a verdict" 18_positions_and_solve
time_row "judges 18 positions" session_solve
time_row "saves a session of 18 positions" save_session
time_row "loads it" load_session
time_row "saves a calibration" save
time_row "loads that" load
says $targets "16 positions, as many as an ATmega328P keeps, take {$(ms atmega1284p session_solve_16)} ms there"
says $targets "judging takes {$(over m4f session_solve_3_wrong "$(raw m4f session_solve)")} times"

moved() { # TITLE SUFFIX
    says $targets "| $1 | {$(figure m4f "save$2_read_bytes")} | {$(figure m4f "save$2_programmed_bytes")} | \
{$(figure m4f "load$2_read_bytes")} |"
}
moved "a session of 18 positions" _session
moved "a calibration" ''

says README.md "At -Os it takes {$(figure m4f flash.program)} bytes of flash on a Cortex-M4F"
says README.md "{$(ms m4f session_solve)} ms on a Cortex-M4F at 64 MHz"
says README.md "{$(ms m0plus session_solve)} ms on a Cortex-M0+ at"
for page in README.md port/manual/evidence.md; do
    for suffix in '' -O2; do
        says $page "| invcal, the core | 9 | ${suffix:--Os} | {$(figure m4f "18_positions_and_solve$suffix")} | \
{$(figure m4f "own.core$suffix")} / {$(figure m4f "flash.core$suffix")} | {$(figure m4f "memory.core$suffix")} | 0 |"
    done
done

# ---- other pages --------------------------------------------------------------------------------------------

page=port/manual/gyroscope_firmware.md
says $page "| session and moves in RAM | {$(figure m4f sizeof.invcal_imu)} |"
says $page "| the result in RAM, in a slot | {$(figure m4f sizeof.invcal_imu_result)}, "
says $page "of \`invcal_imu_save_result\` (Cortex-M4F, \`-Os\`) | {$(figure m4f invcal_imu_solve)}, {$(figure m4f invcal_imu_save_result)} |"
says $page "gyroscope costs {$(about m4f gyro_feed)} instructions on a Cortex-M4F"
says $page "a solution of 23 moves {$(over m4f imu_solve 1000000)} million"
says $page "it takes {$(over atmega1284p imu_solve 16000000)} s"
says port/manual/magnetometer.md "| cost | {$(about m4f magnetometer_with_looks)} instructions per sample on a Cortex-M4F, \
{$(figure m4f sizeof.invcal_magnetometer)} bytes |"
says port/manual/wearable.md "takes {$(figure m4f sizeof.invcal_background)} bytes of RAM"
page=port/manual/porting.md
says $page "| stack | about {$(about m4f invcal_session_solve)} bytes for a session's worst call, \
{$(about m4f invcal_magnetometer_feed)} for a magnetometer, {$(about m4f invcal_imu_solve)} for both sensors"
says $page "without one the library takes {$(over m0plus session_solve "$(raw m4f session_solve)")} times as many instructions"

page=port/cortex-m/firmware/README.md
says $page "| the library | {$(figure m4f firmware.invcal)} | 0 |"
says $page "| this folder without \`sim/\` | {$(figure m4f firmware.own)} |"
says $page "| libc: memory functions, and string functions for \`sim/\` | {$(figure m4f firmware.libc)} | 0 |"
says $page "a call of the library takes {$(figure m4f stack.session)} bytes of stack at most"
page=port/cortex-m/firmware_imu/README.md
says $page "| the library | {$(figure m4f firmware_imu.invcal)} | 0 |"
says $page "| \`main.c\` and its part of \`../firmware\`, without \`sim/\` | {$(figure m4f firmware_imu.own)} |"
says $page "| libc: memory functions, and string functions for \`sim/\` | {$(figure m4f firmware_imu.libc)} | 0 |"
says $page "a call of the library takes {$(figure m4f stack.imu_next)} bytes of stack at most"
says $page "solution alone {$(figure m4f invcal_imu_solve)}"

# ---- the headers --------------------------------------------------------------------------------------------

# Functions, and what `make bench` calls the instructions of each sentence in their descriptions.
cat > "$build/promised" << 'END'
invcal_apply apply
invcal_calibrate_plain 18_positions_and_everything
invcal_calibrate judged_18_positions
invcal_calibrate_robust robust_18_positions
invcal_calibrate_prior 18_positions_with_prior
invcal_calibrate_faces six_faces
invcal_undetermined undetermined
invcal_sums_add add_position
invcal_sums_solve solve
invcal_session_feed feed_1000_Hz feed_100_Hz
invcal_session_next next_orientation
invcal_session_solve session_solve session_solve_3_wrong
invcal_background_feed background_rest
invcal_session_save save_session
invcal_session_load load_session
invcal_save save
invcal_load load
invcal_frame_add frame_add
invcal_frame_solve frame_solve
invcal_imu_feed gyro_follow
invcal_imu_feed_gyro gyro_feed
invcal_imu_solve imu_pass
invcal_imu_next imu_next
invcal_imu_apply imu_apply
invcal_magnetometer_feed magnetometer_sample magnetometer_look magnetometer_with_looks
invcal_magnetometer_next magnetometer_next
invcal_magnetometer_solve magnetometer_solve
invcal_dip_add dip_add
invcal_dip_solve dip_solve
invcal_thermal_at thermal_at
invcal_thermal_calibrate 36_positions_thermal
invcal_allan_feed allan_push
invcal_allan_solve allan_noise
END
promises() {
    awk "$@" -f tests/size/promises.awk "$build/promised" "$build/bench/m4f.figures" \
        "$build"/size/*-m4f-Os/measured include/invcal/*.h
}
[ -z "$UPDATE" ] || promises -v update=1
promises > "$build/promises"
read -r kept _ broken _ << END
$(tail -n 1 "$build/promises")
END
sed '$d' "$build/promises"
passed=$((passed + kept))
failed=$((failed + broken))

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
