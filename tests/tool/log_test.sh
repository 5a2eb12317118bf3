#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of raw logs by the command line: simulate, calibrate LOG, watch: log_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

field() { json "$work/stdout" "$1"; }

# Simulates a log: log NAME ARGUMENTS ...; its truth is $work/NAME.json.
log() {
    name=$1
    shift
    "$tool" simulate --truth "$work/$name.json" "$@" > "$work/$name.csv"
}

# The offset agrees with the truth to that many counts.
right_offset() { # NAME COUNTS
    near "$2" "$(field offset)" "$(json "$work/$1.json" offset)"
}

# ---- simulate ----------------------------------------------------------------------------------

accepts "simulate: --help succeeds" simulate --help
log plain
check "simulate: 18 rests of 5 s and 17 moves of 2 s at 100 Hz" \
    [ "$(wc -l < "$work/plain.csv")" -eq 12401 ]
log again
check "simulate: the same seed gives the same log" same "$work/plain.csv" "$work/again.csv"
log other --seed 2
differs() { ! cmp -s "$1" "$2"; }
check "simulate: another seed gives another log" differs "$work/plain.csv" "$work/other.csv"
check "simulate: the truth is JSON" is_json "$work/plain.json"
# The truth corrects the errors: in the rests all lengths are 1 g.
accepts "simulate: apply reads the truth" apply "$work/plain.json" "$work/plain.csv"
rests_are_1g() {
    awk -F, 'NR > 1 { i = NR - 2; if (i % 700 < 500) { n++
            length_ = sqrt($2 ^ 2 + $3 ^ 2 + $4 ^ 2) / 9.80665 - 1; sum += length_; square += length_ ^ 2 } }
        END { mean = sum / n; exit !(n == 9000 && mean ^ 2 < 1e-9 && square / n < 1.3e-6 && square / n > 0.8e-6) }' \
        "$work/stdout"
}
check "simulate: with it every rest reads 1 g, with the noise stated" rests_are_1g
log warm --temperature 10,40 --drift 0.0001 --rate 50 --plan faces
check "simulate: the temperature has a column" test "$(head -n 1 "$work/warm.csv")" = t,x,y,z,temperature
check "simulate: and goes from first to last" test \
    "$(sed -n 2p "$work/warm.csv" | cut -d, -f5)" = 10.000 -a "$(tail -n 1 "$work/warm.csv" | cut -d, -f5)" = 40.000
log angles --stand --plan per-group:6 --temperature 20,21
check "simulate: angles have columns" test "$(head -n 1 "$work/angles.csv")" = t,x,y,z,temperature,alpha,beta
# Table 2: the angles of each rest, 700 samples after the previous one; moves take the shorter way.
angles_are_those_of_table_2() {
    awk -F, 'function off(a, b) { a = (a - b) % 360; return a > 0.0001 && a < 359.9999 || a < -0.0001 && a > -359.9999 }
        NR == 1 { next }
        { k = int((NR - 2) / 700); rest = (NR - 2) % 700 < 500 }
        rest && (off($6, k < 6 ? 30 + 60 * k : k < 12 ? -90 : 120 + 60 * k) ||
                 off($7, k < 6 ? 0 : k < 12 ? 30 + 60 * k : 90)) { exit 1 }
        NR > 2 { for (i = 6; i <= 7; i++) { d = $i - was[i]; if (rest ? (d > 360.1 || d < -360.1) : (d > 0.91 || d < -0.91)) jumps++ } }
        { was[6] = $6; was[7] = $7 }
        END { if (jumps) exit 1; exit NR != 1 + 12400 }' "$work/angles.csv"
}
check "simulate: they are those of the program" angles_are_those_of_table_2
run calibrate "$work/angles.csv" --stand --zero 0,0,0 --lsb 0.000598550415
check "simulate: and calibrate reads them so" matches "$work/stdout" '^stand         18 positions with angles .columns.$'
check "simulate: none of them is misset" lacks "$work/stdout" '^(Misset|Stand): '
log clipped --range 0.9 --plan faces --noise 0
check "simulate: readings are clipped" test "$(cut -d, -f4 "$work/clipped.csv" | sort -n | tail -n 1)" -le 14746
log wrong --outliers 2
check "simulate: outliers are listed" test "$(grep -c '"wrong": -*0\.05' "$work/wrong.json")" -eq 2
for bad in '--rate 0' '--rate nan' '--noise -1' '--dwell 0' '--offset 1,2' '--offset 9,0,0' \
    '--seed 1.5' '--seed -1' '--outliers 0.5' '--lsb 0' '--range 0' '--temperature 1' '--drift 1'; do
    # shellcheck disable=SC2086
    refuses "simulate: $bad" 2 'simulate --help|whole numbers' simulate $bad
done
refuses "simulate: an unknown set" 2 'is not a set' simulate --plan dodecahedron
refuses "simulate: too small a program" 1 'too few' simulate --plan per-group:4
refuses "simulate: a truth that cannot be written" 3 'nowhere' simulate --truth "$work/nowhere/t.json"

# ---- calibrate LOG -----------------------------------------------------------------------------

run calibrate "$work/plain.csv" --json
check "calibrate LOG: 18 positions" test "$(field positions)" = 18
check "calibrate LOG: none left out" test "$(field rejected)" = '[]'
check "calibrate LOG: good" test "$(field verdict)" = '"good"'
check "calibrate LOG: the offset is right" right_offset plain 2
accepts "calibrate LOG: it prints" calibrate "$work/plain.csv"
check "calibrate LOG: samples and rate are reported" matches "$work/stdout" \
    '12400 samples, 124 s at 100 samples per second$'

cut -d, -f2-4 "$work/plain.csv" | tail -n +2 | tr ',' ' ' > "$work/blank.txt"
run calibrate "$work/blank.txt" --json
check "calibrate LOG: with blanks, without header and times" right_offset plain 2
run calibrate "$work/blank.txt"
check "calibrate LOG: a guessed rate is reported" matches "$work/stdout" 'guess: state --rate'
in=$work/blank.txt
run calibrate - --rate 100 --json
in=/dev/null
check "calibrate LOG: from standard input" right_offset plain 2
awk '{ printf "%.4f %.4f %.4f 0.1 0.2 0.3\n", $1 * 0.0006, $2 * 0.0006, $3 * 0.0006 }' "$work/blank.txt" > "$work/decimal.txt"
run calibrate "$work/decimal.txt" --json
check "calibrate LOG: decimals, with a gyro behind" near 0.0012 "$(field offset)" \
    "$(json "$work/plain.json" offset | tr -d '[]' | awk -F, '{ print $1 * 0.0006, $2 * 0.0006, $3 * 0.0006 }')"

# The same log scaled, shifted and with its axes exchanged gives the same positions and result.
run calibrate "$work/plain.csv" --json
plain_offset=$(field offset)
plain_rms=$(field residual_rms)
awk -F, 'NR == 1 { print; next } { printf "%s,%d,%d,%d\n", $1, 1000 * $2, 1000 * $3, 1000 * $4 }' "$work/plain.csv" > "$work/scaled.csv"
run calibrate "$work/scaled.csv" --json
check "calibrate LOG: scaled by 1000" near 1e-3 "$(field offset)" \
    "$(echo "$plain_offset" | tr -d '[]' | awk -F, '{ printf "%.6f %.6f %.6f", 1000 * $1, 1000 * $2, 1000 * $3 }')"
check "calibrate LOG: scaled by 1000, the same residuals" near 1e-12 "$(field residual_rms)" "$plain_rms"
awk -F, 'NR == 1 { print; next } { printf "%s,%d,%d,%d\n", $1, $2 + 100000, $3 - 5000, $4 + 7 }' "$work/plain.csv" > "$work/shifted.csv"
run calibrate "$work/shifted.csv" --json
check "calibrate LOG: shifted" near 1e-6 "$(field offset)" \
    "$(echo "$plain_offset" | tr -d '[]' | awk -F, '{ printf "%.9f %.9f %.9f", $1 + 100000, $2 - 5000, $3 + 7 }')"
awk -F, 'NR == 1 { print; next } { printf "%s,%s,%s,%s\n", $1, $4, $2, $3 }' "$work/plain.csv" > "$work/turned.csv"
run calibrate "$work/turned.csv" --json
check "calibrate LOG: axes exchanged" near 1e-6 "$(field offset)" \
    "$(echo "$plain_offset" | tr -d '[]' | awk -F, '{ printf "%.9f %.9f %.9f", $3, $1, $2 }')"
awk 'NR == 1 || NR % 4 == 2' "$work/plain.csv" > "$work/quarter.csv"
run calibrate "$work/quarter.csv" --json
check "calibrate LOG: every fourth sample" near 2 "$(field positions)" 18

for noise in 0.0002 0.005; do
    for rate in 50 400; do
        log n --noise $noise --rate $rate --dwell 3 --move 1 --tremor 0.0003 --seed 7
        run calibrate "$work/n.csv" --json
        check "calibrate LOG: noise $noise at $rate Hz, with tremor: 18 positions" \
            test "$(field positions)" = 18
    done
done
run calibrate "$work/wrong.csv" --json
check "calibrate LOG: two wrong positions are left out" near 0 "$(field rejected)" \
    "$(awk '/"begin"/ { n++ } /"wrong": -*0\.05/ { printf "%d ", n }' "$work/wrong.json")"
check "calibrate LOG: and cause no error" right_offset wrong 2
run calibrate "$work/wrong.csv"
check "calibrate LOG: they are named" test "$(grep -c '^Left out: position' "$work/stdout")" -eq 2
# The line that is named is in the wrong rest, whatever was lost before it.
names_rest() { # LINE BEGIN END: the time in that line is within the rest, or a second
    awk -F, -v line="$1" -v begin="$2" -v end="$3" 'NR == line { ok = $1 > begin - 0.2 && $1 < end } END { exit !ok }' "$work/lost.csv"
}
begin=$(awk '/"begin"/ { t = $2 + 0 } /"wrong": -*0\.05/ { last = t } END { print last }' "$work/wrong.json")
awk 'NR > 1 && NR % 300 == 50 { print "# a comment" } NR < 2 || NR % 500 > 20' "$work/wrong.csv" > "$work/lost.csv"
run calibrate "$work/lost.csv"
check "calibrate LOG: the line is right despite gaps and comments" names_rest \
    "$(sed -n 's/^Left out: .*(line \([0-9]*\)).*/\1/p' "$work/stdout" | tail -n 1)" "$begin" $((begin + 5))
run calibrate "$work/wrong.csv" --keep-all --json
check "calibrate LOG: --keep-all keeps them" test "$(field rejected)" = '[]'

"$tool" simulate --plan edges --move 4 --dwell 0.2 > "$work/turning.csv"
refuses "calibrate LOG: a device that never rests" 1 'no rest of two seconds' calibrate \
    "$work/turning.csv"
run calibrate "$work/clipped.csv" --clip -14745,14745 --json
check "calibrate LOG: clipped rests are refused" matches "$work/stderr" 'no rest'
printf 't,x,y,z\n0,1,2,3\n1000,1,2,3\n2000,1,2,3\n3000,1,2,3\n' > "$work/ms.csv"
refuses "calibrate LOG: times in milliseconds" 3 'times advance by 1000, which cannot be seconds' \
    calibrate "$work/ms.csv"
printf 't_us,x,y,z\n0,1,2,3\n1000000,1,2,3\n2000000,1,2,3\n3000000,1,2,3\n' > "$work/ms.csv"
refuses "calibrate LOG: one sample per second, the unit stated" 3 \
    'ms\.csv:2: 1 sample per second is too slow: 8 are the minimum, 50 are good$' calibrate "$work/ms.csv"
printf 't,x,y,z\n0,1,2,3\n5,1,2,3\n10,1,2,3\n15,1,2,3\n' > "$work/ms.csv"
refuses "calibrate LOG: one sample in 5 s, or in 5 ms" 3 \
    '0\.2 samples per second are too slow: .*; if the times are not in seconds, .*\(t_ms, t_us\), or state --rate$' \
    calibrate "$work/ms.csv"
awk -F, 'NR == 1 { print; next } NR < 3000 || NR > 3200' "$work/plain.csv" > "$work/gap.csv"
run calibrate "$work/gap.csv" --json
check "calibrate LOG: samples lost" right_offset plain 2
sed '5000s/.*/49.98,1,2/' "$work/plain.csv" > "$work/bad.csv"
refuses "calibrate LOG: a malformed line" 3 'bad\.csv:5000: 3 columns' calibrate "$work/bad.csv"
for bad in '--rate 0' '--rate 7' '--rate 9000' '--clip 1' '--clip 2,1'; do
    # shellcheck disable=SC2086
    refuses "calibrate LOG: $bad" 2 'calibrate --help' calibrate "$work/plain.csv" $bad
done
refuses "calibrate: the rate of position means" 2 'needs samples' calibrate "$work/log.csv" \
    --positions --rate 100
refuses "calibrate: a target" 2 'is an option of invcal watch only' calibrate "$work/plain.csv" --target 1,1,1

# A sensor that boots: whole numbers first, decimals later.
{ awk 'BEGIN { for (i = 0; i < 300; i++) print "0 0 0" }'; cat "$work/decimal.txt"; } > "$work/boot.txt"
cut -d ' ' -f 1-3 "$work/boot.txt" > "$work/zeros.txt"
run calibrate "$work/zeros.txt" --json
check "calibrate LOG: 300 zeros before decimals" near 0.0012 "$(field offset)" \
    "$(json "$work/plain.json" offset | tr -d '[]' | awk -F, '{ print $1 * 0.0006, $2 * 0.0006, $3 * 0.0006 }')"
# Samples in groups of ten with the same time.
awk -F, 'NR == 1 { print; next } { printf "%.2f,%s,%s,%s\n", int((NR - 2) / 10) / 10, $2, $3, $4 }' \
    "$work/plain.csv" > "$work/batches.csv"
run calibrate "$work/batches.csv" --json
check "calibrate LOG: ten samples for each time" near 0 "$(field offset)" "$plain_offset"
run calibrate "$work/batches.csv" --rate 100 --json
check "calibrate LOG: the same with the rate stated" near 0 "$(field offset)" "$plain_offset"
awk -F, 'NR == 1 { print; next } { printf "%.2f,%s,%s,%s\n", (NR == 6000 ? 1 : $1), $2, $3, $4 }' \
    "$work/plain.csv" > "$work/backwards.csv"
run calibrate "$work/backwards.csv"
check "calibrate LOG: times that go back are reported" matches "$work/stdout" '^ +2 gaps in the stream'
# One rest that reads almost nothing, with 18 good ones.
{ cat "$work/blank.txt"; awk 'BEGIN { for (i = 0; i < 500; i++) print i % 3, 2 - i % 5, i % 2 }'; } > "$work/drop.txt"
run calibrate "$work/drop.txt" --json
check "calibrate LOG: a rest without any reading is left out" near 0 "$(field rejected)" 19

# ---- watch -------------------------------------------------------------------------------------

accepts "watch: --help succeeds" watch --help
in=$work/plain.csv
run watch - --plan per-group:6
in=/dev/null
cp "$work/stdout" "$work/watched"
check "watch: says what it recognised" test "$(head -n 1 "$work/watched")" = \
    'standard input: CSV with commas, header in line 1; t (s), x y z'
check "watch: asks for the first position" test "$(sed -n 2p "$work/watched")" = \
    'next: position 1 of 18: alpha 30, beta 0°; +y up, tilt 30 deg, +z rises'
check "watch: takes 18" test "$(grep -c '^position .* taken' "$work/watched")" -eq 18
check "watch: knows that the program is complete" matches "$work/watched" '^finished'
check "watch: no control characters where there is no terminal" lacks "$work/watched" "$(printf '\r')"
check "watch: the uncertainty shrinks" awk '/taken; 95 %: offsets/ { most = $8; if (!first) first = most }
    END { exit !(most < first) }' "$work/watched"
run calibrate "$work/plain.csv" --json
# Two digits of the widest interval of calibrate: both know the noise of the samples.
interval=$(awk -F'[][,: ]+' '/"sigma"/ { on = 1 } /"delta"/ && on && !sigma { for (i = 3; i < 6; i++) if ($i > sigma) sigma = $i }
    /"interval95"/ { times = $3 } END { print times * sigma }' "$work/stdout")
check "watch: and is the 95 % interval" awk -v interval="$interval" '
    /taken; 95 %: offsets/ { most = $8 }
    END { exit !(most > 0.94e3 * interval && most < 1.06e3 * interval) }' "$work/watched"
run calibrate "$work/plain.csv"
sed -n '/ 18 positions, field/,$p' "$work/stdout" | sed 's/^[^:]*: //' > "$work/figures"
sed -n '/ 18 positions, field/,$p' "$work/watched" | sed 's/^[^:]*: //' > "$work/live"
check "watch: at the end the same figures as calibrate" same "$work/figures" "$work/live"
# A sample scatters by 1 mg at 100 Hz: 0.7 mm/s^2 take 2 s; 0.1 mm/s^2 take 96 s, more than 5.
in=$work/plain.csv
run watch - --mean-sigma 0.0007
check "watch: a mean that is good enough soon is taken" \
    test "$(grep -c '^position .* taken' "$work/stdout")" -eq 18
run watch - --mean-sigma 0.0001
check "watch: one that needs longer is refused" matches "$work/stdout" \
    '^refused: too short: hold still longer'
check "watch: and none is taken" lacks "$work/stdout" '^position .* taken'
# With measured noise: white noise N needs (N / sigma)^2, the worst axis decides.
noise() { # noise WHITE_OF_Z INSTABILITY_OF_X: m/s^2/sqrt(Hz), m/s^2
    printf '{"gravity": 9.80665, "noise": {"x": {"white": 0.001, "instability": %s, "walk": 0},
        "y": {"white": 0.001, "instability": 0, "walk": 0},
        "z": {"white": %s, "instability": 0, "walk": 0}}}\n' "$2" "$1" > "$work/noise.json"
}
noise 0.001 0
run watch - --mean-sigma 0.0007 --allan "$work/noise.json"
check "watch --allan: the time that it takes is reported" matches "$work/stdout" '^hold each position for 2.04 s'
check "watch --allan: and is enough" test "$(grep -c '^position .* taken' "$work/stdout")" -eq 18
noise 0.002 0
run watch - --mean-sigma 0.0007 --allan "$work/noise.json"
check "watch --allan: the noisiest axis decides" matches "$work/stdout" '^hold each position for 8.16 s'
check "watch --allan: five seconds are too short then" lacks "$work/stdout" '^position .* taken'
noise 0.001 0.003
run watch - --mean-sigma 0.0007 --allan "$work/noise.json"
check "watch --allan: what does not average out is reported" matches "$work/stdout" \
    '; longer does not help: the sigma of a mean is 0.0021$'
in=/dev/null
refuses "watch: --allan without --mean-sigma" 2 'allan: needs --mean-sigma' \
    watch - --allan "$work/noise.json"
refuses "calibrate: --allan" 2 'allan: is an option of invcal watch only' \
    calibrate "$work/plain.csv" --allan "$work/noise.json"
in=$work/plain.csv
refuses "watch --allan: hours are not held" 2 'takes more than 3600 s' \
    watch - --mean-sigma 0.00001 --allan "$work/noise.json"
in=/dev/null
refuses "watch: --mean-sigma 0" 2 'mean-sigma: the standard deviation' watch - --mean-sigma 0
refuses "calibrate: --mean-sigma" 2 'mean-sigma: is an option of invcal watch only' \
    calibrate "$work/plain.csv" --mean-sigma 1
in=$work/plain.csv
run watch - --target 0.0001,0.0002,0.0003
check "watch: says when the target is reached" matches "$work/stdout" '^enough'
run watch - --json
in=/dev/null
# With 3 to 8 degrees of freedom the residuals of a clean log are small by chance in every fifth: the noise of the samples
# is known, and when watch has enough, so has calibrate of the log up to there. A position takes 3.5 s.
follow=
logs=${LONG:+25}
logs=${logs:-5}
enough() { # enough OPTIONS, $follow those of watch alone: how many logs have enough, and how many of these calibrate refuses
    reached=0
    failed_there=0
    seed=0
    while [ $((seed += 1)) -le "$logs" ]; do
        "$tool" simulate --plan optimal:18 --dwell 2.5 --move 1 --seed $seed > "$work/lucky.csv"
        # shellcheck disable=SC2086 # words
        taken=$("$tool" watch "$work/lucky.csv" $follow --gravity 9.80665 --need 0.15mg "$@" |
            awk '/^position .* taken/ { n = $2 } /^enough/ { print n; exit }')
        [ "$taken" ] || continue
        awk -F, -v n="$taken" 'NR == 1 || $1 <= 3.5 * n + 0.2' "$work/lucky.csv" > "$work/lucky_part.csv"
        run calibrate "$work/lucky_part.csv" --gravity 9.80665 --need 0.15mg "$@"
        reached=$((reached + 1))
        grep -q '^PASS' "$work/stdout" || failed_there=$((failed_there + 1))
    done
    echo "    enough in $reached of $logs, of which $failed_there fail" >&2
    [ "$reached" -ge $((logs * 3 / 5)) ] && [ "$failed_there" -eq 0 ]
}
check "watch: enough does not depend on lucky residuals" enough --zero 0,0,0 --lsb 9.80665/16384
check "watch: the same with a nominal from the range" enough
follow='--plan optimal:18'
check "watch: the same with one from the program" enough
in=$work/plain.csv
run watch - --json
check "watch: --json prints only JSON" is_json "$work/stdout"
check "watch: the guidance goes to stderr" matches "$work/stderr" '^next: '
in=/dev/null
awk 'NR == 1 { print "34,-512"; next } NR == 900 { print "garb,age" } { print } END { printf "124.5,12" }' \
    "$work/plain.csv" > "$work/noisy.csv"
in=$work/noisy.csv
run watch - --json
in=/dev/null
check "watch: lines that are cut or garbled are skipped" test "$code" -eq 0
check "watch: they are reported" test "$(grep -c 'columns' "$work/stderr")" -eq 4
check "watch: and cause no error" right_offset plain 2
awk '{ print (NR < 300 ? $0 : "garbage") }' "$work/plain.csv" > "$work/garbage.csv"
in=$work/garbage.csv
run watch - --json
in=/dev/null
check "watch: a hundred such lines end it" test "$code" -eq 3
check "watch: and the last line is the error" matches "$work/stderr" '^invcal: '
check "watch: without an empty line after it" test -n "$(tail -n 1 "$work/stderr")"
# Ctrl-C gives the result so far.
mkfifo "$work/port"
"$tool" watch - --json < "$work/port" > "$work/stdout" 2> "$work/stderr" &
watcher=$!
exec 3> "$work/port"
head -n 11000 "$work/plain.csv" >&3
has_taken() { [ "$(grep -c 'taken' "$work/stderr")" -ge "$1" ]; }
eventually has_taken 14
# The interrupt is what ends it: its result is there before the stream's other end is closed. (Without `timeout`, which a
# signal kills as long as it does not know its child.)
interrupted() {
    kill -TERM $watcher
    eventually test -s "$work/stdout"
    has_ended=$?
    exec 3>&-
    wait $watcher
    code=$?
    return $has_ended
}
interrupted
check "watch: an interrupt ends the stream" test $? -eq 0
check "watch: with the result" test "$code" -eq 0
check "watch: it is that of the samples so far" test "$(field positions)" -ge 14
# At any time: while the tool waits, or while it computes.
ends_on_interrupt() {
    for pause in 0 0 0 0 0.01 0.02 0.03 0.05; do
        "$tool" watch - --json < "$work/port" > "$work/stdout" 2> "$work/stderr" &
        watcher=$!
        exec 3> "$work/port"
        head -n 9000 "$work/plain.csv" >&3
        eventually grep -q '^next: ' "$work/stderr" # it reads the stream
        sleep "$pause"
        interrupted && [ "$code" -le 1 ] || return 1
    done
}
check "watch: an interrupt ends the stream at any moment" ends_on_interrupt
refuses "watch: no set" 2 "'cubes' is not a set of positions: give edges, faces, .*directions:FILE" watch - --plan cubes
refuses "watch: a set that leaves parameters open" 2 'plan: the positions leave' watch - --plan faces
refuses "watch: one standard input for two" 2 'plan: only one input' watch - --plan directions:-
refuses "watch: a set that is not there" 3 'nowhere' watch - --plan directions:nowhere
refuses "watch: groups that are too small" 2 'plan: 4 positions in a group' watch - --plan per-group:4
refuses "watch: position means" 2 'positions: is an option of' watch - --positions
refuses "watch: a negative target" 2 'target: must not be negative' watch - --target=-1,0,0
refuses "watch: nothing" 3 'standard input: is empty' watch -

finish
