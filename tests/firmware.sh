#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The example firmware (port/cortex-m/firmware), from power-on to the stored calibration, on an
# emulated Cortex-M4F and again on a Cortex-M0+; then that for both sensors
# (port/cortex-m/firmware_imu). $1: folder to build in.
# Lines that begin with "world:" come from the simulated world, which knows the truth. The firmware
# does not; what it printed is compared with the truth here.
. "$(dirname "$0")/target.sh"
targets=${1:-build/targets}
out=$targets/firmware
passed=0
failed=0

check() { # NAME COMMAND...: if it fails, its last line says what is wrong
    name=$1
    shift
    if "$@" > "$out/why" 2>&1; then
        echo "firmware: $name: PASS"
        passed=$((passed + 1))
    else
        echo "firmware: $name: FAIL: $(tail -n 1 "$out/why")"
        failed=$((failed + 1))
    fi
}

build() { # TARGET FIRMWARE
    target_make "$targets" "port/cortex-m/$1" "$2"
}

run() { # TARGET MACHINE LOG FIRMWARE
    timeout 60 qemu-system-arm -M "$2" -nographic -monitor none -serial stdio \
        -semihosting-config enable=on,target=native \
        -kernel "$targets/cortex-m-$1/$4.elf" < /dev/null > "$3"
    status=$?
    echo "exit status $status"
    return $status
}

# Runs an awk program on the log; whatever it prints is what is wrong.
log() {
    why=$(awk "$1" "$out/$shown.log")
    echo "$why"
    [ -z "$why" ]
}

# After each reset but the last: as many positions as were stored last. And as many resets as there should be.
resumed() {
    log '
        /^power on/ { starts++ }
        /^world: reset/ { resets++ }
        /^world: power fails/ { cuts++ }
        /^session stored, positions: / { stored = $NF }
        /^stored session found, positions: / {
            found++
            if ($NF != stored) print "found " $NF " positions of " stored
        }
        /^new session/ { begun++ }
        END {
            if (starts != 4) print starts + 0 " starts, not one at power-on and three after resets"
            if (resets != 1 || cuts != 1) print resets + 0 " resets and " cuts + 0 " cuts of power"
            if (found != 2) print "a session was found " found + 0 " times"
            if (begun != 1) print begun + 0 " sessions were started"
        }'
}

# Positions are numbered in order, none skipped, none repeated but the one that could not be stored.
counted() {
    log '
        /^session stored, positions: / { stored = $NF }
        /^position taken: / {
            if ($NF != stored + 1) print "position " $NF " after " stored + 0
            most = $NF
        }
        END { if (most < 12) print most + 0 " positions" }'
}

asked() {
    log '
        /^next: [+-][xyz] up/ { if (!seen[$0]++) different++ }
        END { if (different < 9) print different + 0 " orientations were asked for" }'
}

# Only the one that was taken while somebody pulled. It does not keep the session from ending.
outlier() {
    log '
        /^world: somebody pulls/ { pulled++; next_is = 1 }
        /^position taken: / { if (next_is) wrong = $NF; next_is = 0; most = $NF }
        /^left out, / { left++; if ($NF != wrong) print "left out " $NF ", but wrong is " wrong }
        END {
            if (pulled != 1 || left != 1) print pulled + 0 " planted, " left + 0 " left out"
            if (most >= 24) print "ended only when the table was full"
        }'
}

# Before any reset: after one, the first rest may have begun earlier, and look like another that is too short.
too_short() {
    log '
        /^world: reset/ { exit }
        /^refused: too short/ { refused++ }
        END { if (refused != 1) print "refused " refused + 0 " times" }'
}

said() { # PATTERN TIMES
    found=$(grep -c "$1" "$out/$shown.log")
    echo "said $found times: $1"
    [ "$found" -eq "$2" ]
}

# Values and sigmas that the firmware printed, against the world's truth of these names.
true_to() { # LABEL NAME_X NAME_Y NAME_Z
    log '
        /^'"$1"'/ { for (i = 1; i <= 3; i++) value[i] = $(NF - 3 + i); next_is = 1; next }
        next_is && /^sigma:/ { for (i = 1; i <= 3; i++) sigma[i] = $(1 + i) }
        { next_is = 0 }
        /^world: truth / { name = $3; sub(",", "", $4); truth[name] = $4 }
        END {
            split("'"$2 $3 $4"'", names)
            for (i = 1; i <= 3; i++) {
                off = value[i] - truth[names[i]]
                if (off < 0) off = -off
                if (!(names[i] in truth) || !(sigma[i] > 0) || !(off <= 4 * sigma[i]))
                    print names[i] ": " value[i] " +- " sigma[i] ", truth " truth[names[i]]
            }
        }'
}

# Readings after the last power-on: 1 g, whatever the offsets and scale errors.
applied() {
    log '
        /^world: off and on/ { again = 1; n = 0 }
        again && /^stored calibration: found/ { found = 1 }
        found && /^a, g: / {
            n++
            if (!($NF > 0.99 && $NF < 1.01)) print "a length of " $NF
        }
        END { if (n < 5) print n + 0 " readings" }'
}

# What the firmware links: no heap, no printf, no arithmetic in double.
is_lean() {
    names=$(arm-none-eabi-nm "$targets/cortex-m-m4f/$1.elf" |
        awk '$3 ~ /^(_sbrk|_*malloc.*|.*printf.*|__aeabi_(d|f2d|i2d|ui2d|l2d|ul2d).*)$/ { print $3 }')
    echo "has" $names
    [ -z "$names" ]
}

# The folder's README.md quotes this run: its lines are in the log, in that order.
quoted() { # FIRMWARE
    awk '/^```text$/ { on = 1; next } /^```$/ { on = 0 } on' "port/cortex-m/$1/README.md" |
        awk '
            NR == FNR { if ($0 != "...") quote[++n] = $0; next }
            $0 == quote[i + 1] { i++ }
            END {
                if (n < 30) print "README.md quotes " n + 0 " lines"
                else if (i < n) print "not printed there: " quote[i + 1]
                exit i < n || n < 30
            }' - "$out/$shown.log"
}

# With both sensors: as many positions after each reset as were stored last.
both_resumed() {
    log '
        /^world: reset in a move/ { resets++ }
        /^world: power fails/ { cuts++ }
        /^session stored, positions: / { stored = $NF }
        /^stored session found, positions: / {
            found++
            if ($NF != stored) print "found " $NF " positions of " stored
        }
        /^new session/ { begun++ }
        END {
            if (resets != 2 || cuts != 1) print resets + 0 " resets and " cuts + 0 " cuts of power"
            if (found != 3) print "a session was found " found + 0 " times"
            if (begun != 1) print begun + 0 " sessions were started"
        }'
}

# The first move after a reset, and the one while the flash was slow, are refused as gaps, the hurried one as clipped;
# no other is. The result uses the others. The move of the slow flash is repeated, as power failed before its rest was
# stored.
refused_moves() {
    log '
        /^power on/ { gap = starts++ > 0; taken = stored }
        /^world: the flash takes/ { gap = 1 }
        /^world: somebody hurries/ { hurry = 3 } # after the rest that is left
        /^position taken/ {
            taken = $NF
            hurry -= hurry > 0
            expected = gap ? "lost" : hurry == 1 ? "range" : ""
            gap = 0
        }
        /^move refused: / {
            if (!expected || !index($0, expected)) print taken ": " $0
            is_refused[taken] = 1
            said++
            expected = ""
        }
        /^session stored|^world: power fails/ {
            if (expected) print taken ": not refused: " expected
            expected = ""
        }
        /^session stored/ { stored = taken }
        /^moves: / {
            for (i in is_refused) refused++
            if ($NF != taken - 1 - refused) print $NF " moves of " taken " rests, " refused + 0 " refused"
        }
        END { if (refused != 4 || said != 5) print refused + 0 " moves were refused, said " said + 0 " times" }'
}

# The tour of the faces; after it, in place of the missing moves, the turns that add most.
toured() {
    log '
        /^next: / { is_face = /^next: [+-][xyz] up$/; if (!is_face && taken < 11) print taken ": " $0 }
        /^next: / && taken >= 11 { late++ }
        /^position taken/ { taken = $NF }
        END { if (!late) print "asked for no turn after the tour" }'
}

mkdir -p "$out" || exit 1
: > "$out/m4f.log"
: > "$out/m0plus.log"
: > "$out/imu.log"
: > "$out/imu-m0plus.log"
shown=m4f
check "builds for the Cortex-M4F" build m4f firmware
check "needs no heap, no printf, no double" is_lean firmware
check "ends by itself, once a good calibration is stored" run m4f mps2-an386 "$out/m4f.log" firmware
check "asks for orientations" asked
check "after a reset and a power cut it goes on with as many positions" resumed
check "counts its positions" counted
check "a rest that is too short is reported" too_short
check "the same place again is reported" said '^refused: nothing new: same place' 1
check "flash that fails is reported" said '^session not stored: the memory' 1
check "each store finds only its own" said '^stored calibration: nothing is stored$' 3
check "a position that is wrong by 50 mg is left out" outlier
check "flash that is slower than the queue does no harm" said '^world: the flash takes 3 s$' 1
check "its verdict is good" said '^verdict: good$' 1
check "offsets are true within 4 sigma" true_to 'offset' offset_x offset_y offset_z
check "scale errors are true within 4 sigma" true_to 'scale errors' dk_x dk_y dk_z
check "cross terms are true within 4 sigma" true_to 'cross terms' gamma_xy gamma_xz gamma_zy
check "the world agrees" said '^world: the stored calibration is good$' 1
check "after power-on the record is found and applied" applied
check "README.md quotes it" quoted firmware
check "builds for the Cortex-M0+" build m0plus firmware
check "ends by itself there" run m0plus mps2-an385 "$out/m0plus.log" firmware
check "prints the same there" diff "$out/m4f.log" "$out/m0plus.log"

shown=imu
check "both sensors: builds for the Cortex-M4F" build m4f firmware_imu
check "both sensors: needs no heap, no printf, no double" is_lean firmware_imu
check "both sensors: ends by itself, once a good calibration is stored" run m4f mps2-an386 "$out/imu.log" firmware_imu
check "both sensors: after resets in two moves and a power cut while it stores it goes on" both_resumed
check "both sensors: those moves are refused, and one while the flash was slow, and one that was too quick" refused_moves
check "both sensors: it makes the tour, then the turn that adds most" toured
check "both sensors: its verdict is good" said '^verdict: good$' 1
check "both sensors: the world agrees" said '^world: the stored calibration is good$' 1
check "both sensors: after power-on the record is found and applied" applied
check "both sensors: README.md quotes it" quoted firmware_imu
check "both sensors: builds for the Cortex-M0+" build m0plus firmware_imu
check "both sensors: ends by itself there" run m0plus mps2-an385 "$out/imu-m0plus.log" firmware_imu
check "both sensors: prints the same there" diff "$out/imu.log" "$out/imu-m0plus.log"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
