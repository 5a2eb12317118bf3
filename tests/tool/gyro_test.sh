#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the gyroscope, from a log to both calibrations: gyro_test.sh path/to/invcal builddir
# With the recordings (RECORDINGS, or ../shared/data) also for raw logs of real sensors, against solutions from all
# samples.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Members of "gyroscope", one level deeper than those that json finds: the member's name, all its numbers.
inner() { # FILE NAME
    awk -v name="$2" '
        /^  "gyroscope": / { inside = 1 }
        inside && /^  }/ { exit }
        inside && $0 ~ "^    \"" name "\": " { found = 1; sub(/^[^:]*: /, "    ") }
        found { print }
        found && (/^    [^ ].*[^[{]$/ || /^    []}],?$/ || /^    -?[0-9]/) { exit }' "$1" |
        tr -d '\n' | sed 's/,$//; s/  */ /g; s/^ //'
}
numbers() { tr -c '0-9.eE+-' ' '; }
solve() { # ARGUMENTS...: $work/stdout is the JSON
    run calibrate --json "$@"
}

# Each of nine elements is within 3 sigma of the truth, and seven or more of them within 95 %.
is_true() { # RESULT TRUTH
    { inner "$1" matrix | numbers; echo; inner "$1" lsb | numbers; echo; inner "$1" sigma | numbers; echo
      inner "$1" interval95 | numbers; echo; inner "$2" matrix | numbers; } | awk '
        { n = split($0, row); for (i = 1; i <= n; i++) x[NR, i] = row[i]; count[NR] = n }
        END {
            if (count[1] != 9 || count[3] != 9 || count[5] != 9) { print "    not nine numbers"; exit 1 }
            for (i = 1; i <= 9; i++) {
                off = (x[1, i] - x[5, i]) / x[2, 1] / x[3, i]
                off = off < 0 ? -off : off
                if (!(off < 3)) { print "    element " i ": " off " sigma"; bad = 1 }
                near += off < x[4, 1]
            }
            exit bad || near < 7
        }' >&2
}
is_small() { # VALUE BOUND
    echo "$1 $2" | awk '{ exit !($1 > 0 && $1 < $2) }'
}
refused_as() { # WORD PATTERN: of the gyroscope alone
    [ "$code" -eq 0 ] && is_empty "$work/stderr" && [ "$(inner "$work/stdout" error)" = "\"$1\"" ] &&
        matches "$work/stdout" "$2" && matches "$work/stdout" '^  "verdict": "good"'
}
change() { # AWK: what is done to the fields of a row, from edges.csv to changed.csv
    awk -F, -v OFS=, "$random_awk NR == 1 { begin_random(1); print; next } $1 { print }" "$work/edges.csv" > "$work/changed.csv"
}

# ---- against the truth -------------------------------------------------------------------------------

printf '%s\n' x,y,z 0,0,1 1,0,0 0,1,0 0,0,1 -1,0,0 0,1,0 0,0,-1 1,0,0 0,-1,0 0,0,-1 -1,0,0 0,-1,0 0,0,1 > "$work/tour.csv"
for seed in 1 2 3; do
    "$tool" simulate --gyro --dwell 3 --plan edges --seed $seed --truth "$work/truth.json" > "$work/edges.csv"
    solve "$work/edges.csv"
    check "18 positions, seed $seed: within the intervals" is_true "$work/stdout" "$work/truth.json"
    "$tool" simulate --gyro --dwell 3 --plan directions:"$work/tour.csv" --seed $seed --truth "$work/truth.json" > "$work/tour.log"
    solve "$work/tour.log" --gravity 9.80665
    check "twelve quarter turns, seed $seed: within the intervals" is_true "$work/stdout" "$work/truth.json"
    near 0.0016 "$(json "$work/stdout" gamma)" '0.01 -0.006 0.008' # three sigma of a tour
    check "twelve quarter turns, seed $seed: the moves determine the angles of the accelerometer" test $? -eq 0
done
# The noise comes from 13 lengths among 37 equations with 19 to spare; 2.365 is Student's t of 7 degrees of freedom.
check "twelve quarter turns: the degrees of freedom are those of the lengths" near 1e-9 "$(json "$work/stdout" degrees_of_freedom)" 6.675675675675675
check "twelve quarter turns: so is the interval" near 0.001 "$(json "$work/stdout" interval95)" 2.3646
good_tours() { # SEEDS...: how many of them end good
    for seed in "$@"; do
        "$tool" simulate --gyro --dwell 3 --plan directions:"$work/tour.csv" --seed "$seed" > "$work/clean.log"
        "$tool" calibrate "$work/clean.log" | grep '^Good: '
    done | wc -l
}
check "twelve quarter turns, clean, seeds with the largest scatter: good" test "$(good_tours 8 15 42 67 80)" -eq 5
if [ "${LONG-}" ]; then # 0.3 % by chance
    # shellcheck disable=SC2046 # numbers
    check "twelve quarter turns, clean: good but for chance" test "$(good_tours $(seq 1 80))" -ge 79
fi
"$tool" simulate --gyro --dwell 3 --plan directions:"$work/tour.csv" --outliers 1 > "$work/outlier.log"
run calibrate "$work/outlier.log"
check "twelve quarter turns with a wrong rest: rough" matches "$work/stdout" '^Rough: '
check "twelve quarter turns with a wrong rest: so is the gyroscope" test "$(tail -n 1 "$work/stdout")" = 'The gyroscope is rough, as the accelerometer is.'
run calibrate "$work/outlier.log" --strict --quiet
check "twelve quarter turns with a wrong rest: --strict" was_refused 1 '--strict: the verdict is rough'
solve "$work/tour.log" --gravity 9.80665
check "the JSON says that the moves helped the accelerometer" matches "$work/stdout" '"accelerometer": "rests and moves"'
refuses "six faces without the gyroscope work as before" 1 'undetermined: angle xy, angle xz, angle zy' \
    calibrate "$work/tour.log" --accelerometer-only
"$tool" simulate --dwell 3 --plan edges > "$work/plain.csv"
"$tool" simulate --gyro --dwell 3 --plan edges --truth "$work/truth.json" > "$work/edges.csv"
cut -d, -f1-4 "$work/edges.csv" > "$work/cut.csv"
check "simulate: a gyroscope leaves the accelerometer's readings as they are" same "$work/plain.csv" "$work/cut.csv"
run calibrate "$work/plain.csv" --json
grep -v '"source_' "$work/stdout" | sed 's/,$//' > "$work/alone"
run calibrate "$work/edges.csv" --json --accelerometer-only
grep -v '"source_' "$work/stdout" | sed 's/,$//' > "$work/only"
check "--accelerometer-only: the result of the accelerometer's columns" same "$work/alone" "$work/only"
solve "$work/edges.csv"
sed '/^  "gyroscope"/,/^  }/d' "$work/stdout" | grep -v '"source_' | sed 's/,$//' > "$work/both"
check "positions that determine the accelerometer: its result is the same with a gyroscope" same "$work/alone" "$work/both"
# g-sensitivity, degrees/s per g
"$tool" simulate --gyro --dwell 3 --plan per-group:8 --gyro-g 0,0,0,-0.15,0,0,0,0,0 --truth "$work/truth.json" > "$work/g.csv"
solve "$work/g.csv"
check "g-sensitivity: it is used" matches "$work/stdout" '"used": "yes"'
check "g-sensitivity: the matrix is true anyway" is_true "$work/stdout" "$work/truth.json"
run calibrate "$work/g.csv"
check "g-sensitivity: it is reported" matches "$work/stdout" '^g-sensitivity *about y, at most -0\.1[45][0-9]* ± 0\.0'

# temperature: 2 counts a degree about y, which is 0.01527 degrees/s
"$tool" simulate --gyro --dwell 3 --plan edges --temperature 20,40 |
    awk -F, -v OFS=, 'NR > 1 { $6 = sprintf("%.0f", $6 + 2 * ($8 - 30)) } { print }' > "$work/warm.csv"
solve "$work/warm.csv"
check "bias as a function of temperature" near 0.00001 "$(inner "$work/stdout" temperature_slope | numbers)" '0 0.00026646 0'
run calibrate "$work/warm.csv"
check "bias as a function of temperature: it is reported" matches "$work/stdout" '^temperature *bias x .* y \+0\.01[56]'
# drift: 30 counts of 1/131 degrees/s in 85 s, which is 5 s less than 18 rests every 5 s take
awk -F, -v OFS=, 'NR > 1 { $6 = sprintf("%.0f", $6 + 30 * $1 / 85) } { print }' "$work/edges.csv" > "$work/drift.csv"
solve "$work/drift.csv"
check "drift of the bias" near 0.00015 "$(inner "$work/stdout" drift | numbers)" '0 0.0039969 0'
check "drift of the bias: its sigma" is_small "$(inner "$work/stdout" drift_sigma | numbers | awk '{ print $2 }')" 0.0001
check "drift of the bias: JSON says what limits" matches "$work/stdout" '"limited_by": "its bias, which changes from rest to rest'
run calibrate "$work/drift.csv"
check "drift of the bias: it is reported" matches "$work/stdout" '^drift *of the bias, x .*, y \+0\.2[23][0-9]* .* °/s from the first rest to the last'
solve "$work/tour.log"
check "12 rests or more determine the drift" lacks "$work/stdout" '^    "drift": \[null'
head -n 5000 "$work/edges.csv" > "$work/short.csv"
solve "$work/short.csv"
check "10 rests do not" test "$(inner "$work/stdout" drift)" = '[null, null, null]'
# frames: A'G is the same whatever the frame, if both are turned alike
both() {
    { sed -n '/^  "matrix"/,/^  \]/p' "$work/stdout" | numbers; echo; inner "$work/stdout" matrix | numbers; } | tr '\n' ' ' |
        awk '{ for (i = 0; i < 3; i++) for (j = 0; j < 3; j++) printf "%.9g ", 1e9 * ($(1 + i) * $(10 + j) + $(4 + i) * $(13 + j) + $(7 + i) * $(16 + j)) }'
}
solve "$work/edges.csv"
both > "$work/nine"
for frame in '--frame triangular' '--case -z' '--case .,-x'; do
    # shellcheck disable=SC2086 # two words
    solve "$work/edges.csv" $frame
    check "$frame: the gyroscope is turned with the accelerometer" near 1e-5 "$(both)" "$(cat "$work/nine")"
done

# ---- units and columns -------------------------------------------------------------------------------

unit_is() { [ "$(inner "$work/stdout" unit)" = "\"$1\"" ] && [ "$(inner "$work/stdout" unit_from)" = "\"$2\"" ] && is_small "$(inner "$work/stdout" residual_rms)" 3e-4; }
in_unit() { # SENTENCE HEADINGS PER UNIT FROM ARGUMENTS...
    sentence=$1; per=$3; unit=$4; from=$5
    { echo "t,ax,ay,az,$2"
      awk -F, -v OFS=, -v per="$per" 'NR > 1 { print $1, $2, $3, $4, $5 * per, $6 * per, $7 * per }' "$work/edges.csv"; } > "$work/changed.csv"
    shift 5
    solve "$work/changed.csv" "$@"
    check "$sentence" unit_is "$unit" "$from"
}
rad=0.000133231240610254
dps=0.00763358778625954
in_unit "rad/s by the header" 'gx (rad/s),gy (rad/s),gz (rad/s)' $rad rad/s header
in_unit "rad/s of PX4" 'gyro_rad[0],gyro_rad[1],gyro_rad[2]' $rad rad/s header
in_unit "dps behind the names" 'gyro_x_dps,gyro_y_dps,gyro_z_dps' $dps °/s header
in_unit "°/s in brackets" 'GYROSCOPE X [°/s],GYROSCOPE Y [°/s],GYROSCOPE Z [°/s]' $dps °/s header
in_unit "rad/s by the moves" 'wx,wy,wz' $rad rad/s size
in_unit "°/s by the moves" 'gx,gy,gz' $dps °/s size
in_unit "counts by the moves" 'GyrX_,GyrY_,GyrZ_' 1 counts size
in_unit "counts that are stated" 'gx,gy,gz' 1 counts option --gyro-lsb 1/131
in_unit "°/s that are stated" 'gx,gy,gz' $dps °/s option --gyro-lsb deg/s
sed 1d "$work/edges.csv" > "$work/bare.csv"
solve "$work/bare.csv"
check "seven columns without a header" unit_is counts size
sed 1d "$work/edges.csv" | cut -d, -f2- > "$work/bare.csv"
solve "$work/bare.csv" --rate 100
check "six columns without a header" unit_is counts size
cut -d, -f1-4 "$work/edges.csv" > "$work/acc.csv"
cut -d, -f1,5-7 "$work/edges.csv" > "$work/gyro.csv"
solve "$work/acc.csv" --gyro "$work/gyro.csv"
check "two files with headers" unit_is counts size
sed 1d "$work/gyro.csv" | cut -d, -f2- | tr , ' ' > "$work/bare.csv"
refuses "two files, one without times" 3 'does not match .*acc\.csv: both need a column t' calibrate "$work/acc.csv" --gyro "$work/bare.csv"
sed 1d "$work/acc.csv" | cut -d, -f2- > "$work/acc_bare.csv"
solve "$work/acc_bare.csv" --gyro "$work/bare.csv" --rate 100
check "two files without headers and times" unit_is counts size
sed 1d "$work/gyro.csv" | awk 'NR % 2 == 0' > "$work/half.csv"
solve "$work/acc.csv" --gyro "$work/half.csv"
check "two files, the gyroscope's at half the rate" unit_is counts size
awk -F, -v OFS=, '{ $1 += 1000; print }' "$work/half.csv" > "$work/other.csv"
refuses "two files, another clock" 3 'its times are not those of' calibrate "$work/acc.csv" --gyro "$work/other.csv"

# ---- bad data ----------------------------------------------------------------------------------------

change '{ y = $6; $6 = -$5; $5 = y }' # about x of the accelerometer turns -y of this
solve "$work/changed.csv"
check "axes exchanged: it says which fit" refused_as axes '"remedy": "state --gyro-axes -y,x,z,'
solve "$work/changed.csv" --gyro-axes -y,x,z
check "axes exchanged: --gyro-axes corrects it" unit_is counts size
change '{ $7 = -$7 }'
solve "$work/changed.csv"
check "a wrong sign: it says which" refused_as axes '"remedy": "state --gyro-axes x,y,-z,'
in_unit "°/s with the heading of rad/s, mended" 'gx (rad/s),gy (rad/s),gz (rad/s)' $dps °/s option --gyro-lsb deg/s
solve "$work/changed.csv"
check "°/s with the heading of rad/s: it says so" refused_as unit '"remedy": "its unit is °/s: state --gyro-lsb deg/s"'
change '{ $6 = 17 }'
solve "$work/changed.csv"
check "an axis that never changes" refused_as stuck "gyroscope's y never changes"
change '{ $6 = NR % 7 }'
solve "$work/changed.csv"
check "an axis that reads only noise" refused_as stuck "gyroscope's y reads nothing"
change 'NR > 4001 { $5 = x; $6 = y; $7 = z } { x = $5; y = $6; z = $7 }'
solve "$work/changed.csv"
check "stuck from the middle on: it says from where" refused_as stuck 'the gyroscope reads the same from line 4001 on'
change 'NR > 4001 { $5 = x } { x = $5 }'
solve "$work/changed.csv"
check "one axis that stops: the reason is different" lacks "$work/stdout" 'reads the same'
cut -d, -f1,5-7 "$work/changed.csv" > "$work/moving.csv"
awk -F, -v OFS=, 'NR > 4001 { $2 = x; $3 = y; $4 = z } { x = $2; y = $3; z = $4; print }' "$work/moving.csv" > "$work/stuck.csv"
solve "$work/acc.csv" --gyro "$work/stuck.csv"
check "stuck, in its own file: the position is named" refused_as stuck 'reads the same from position 8 \(line 3[0-9]+\) on'
change 'NR > 8795 { $5 = x; $6 = y; $7 = z } { x = $5; y = $6; z = $7 }'
solve "$work/changed.csv"
check "quiet at the end of the last rest: no fault" unit_is counts size
for what in '$5 = 1e12' '$6 = -32768000' '$7 = 1e-300'; do
    change "NR == 900 { $what }"
    solve "$work/changed.csv"
    check "a single wrong reading, $what: the others suffice" is_true "$work/stdout" "$work/truth.json"
done
change '{ $5 = NR % 7; $6 = NR % 5; $7 = NR % 3 }'
solve "$work/changed.csv"
check "rests without moves" refused_as 'too few' 'reads no turns between the rests'
awk -F, -v OFS=, 'NR > 1 && $1 % 5 > 3 { next } { print }' "$work/edges.csv" > "$work/changed.csv"
solve "$work/changed.csv"
check "moves that were not recorded" refused_as 'too few' 'too few complete moves between rests .*; unusable 17: samples were lost in the move'
check "moves that were not recorded: JSON, too" test "$(grep -c '"left_out": "samples were lost in the move"' "$work/stdout")" -eq 17
change 'function clip(x) { return x > 9000 ? 9000 : x < -9000 ? -9000 : x } { $5 = clip($5); $6 = clip($6); $7 = clip($7) }'
run calibrate "$work/changed.csv"
check "clipped: that move is left out and named" matches "$work/stdout" "^Left out: the move from position 1 to 2 \(line [0-9]+\): at the end of the range"
printf '%s\n' x,y,z 0,0,1 1,0,0 0,0,-1 -1,0,0 0,0,1 1,0,0 0,0,-1 -1,0,0 0,0,1 1,0,0 > "$work/one.csv"
"$tool" simulate --gyro --dwell 3 --plan directions:"$work/one.csv" > "$work/one.log"
refuses "all moves about one axis: it names what is open" 1 'The moves between them do not determine them either: .*gyro scale x.*gyro scale z' \
    calibrate "$work/one.log" --zero 0,0,0 --lsb 9.80665/16384
awk -F, -v OFS=, 'NR > 1 { y = $6; $6 = -$5; $5 = y } { print }' "$work/one.log" > "$work/changed.csv"
refuses "all moves about one axis, axes exchanged: not clear which" 1 "axes are not the accelerometer's, and these moves do not show which they are: make more moves" \
    calibrate "$work/changed.csv" --zero 0,0,0 --lsb 9.80665/16384
refuses "the same without zero and scale: the rests are in a plane" 1 'the rests are nearly in a plane: turn about all three axes' calibrate "$work/one.log"
awk -F, -v OFS=, 'NR == 1 { print; next } { a[NR] = $1 OFS $2 OFS $3 OFS $4; g[NR] = $5 OFS $6 OFS $7 }
    END { for (i = 2; i <= NR - 60; i++) print a[i], g[i + 60] }' "$work/edges.csv" > "$work/changed.csv"
solve "$work/changed.csv"
check "readings 0.6 s early: they are corrected" unit_is counts size
check "readings 0.6 s early: it is reported" near 0.02 "$(inner "$work/stdout" late)" -0.6
for word in nan inf '' 1e999 junk; do
    awk -F, -v OFS=, -v word="$word" 'NR == 700 { $6 = word } { print }' "$work/edges.csv" > "$work/changed.csv"
    refuses "'$word' in a column of the gyroscope" 3 "csv:700: column 6 \(gyroscope's y\): .*--accelerometer-only ignores" calibrate "$work/changed.csv"
done
accepts "but not with --accelerometer-only" calibrate "$work/changed.csv" --accelerometer-only --quiet

# ---- logs that end too soon -------------------------------------------------------------------------

# The data are good, so there must be no message about wrong axes, units or clocks.
is_not_accused() { # LOG ROWS ARGUMENTS...
    head -n "$2" "$1" > "$work/short.csv"
    shift 2
    run calibrate "$work/short.csv" "$@"
    ! grep -Eq "one device|axes are not|axes, signs or unit|unit of the gyroscope is" "$work/stdout" "$work/stderr" || complain
}
for seed in 1 2; do
    "$tool" simulate --gyro --dwell 3 --plan edges --seed $seed > "$work/long.csv"
    for rows in 1300 1900 2300 2900 3300 4000 4500; do
        check "edges, seed $seed, $rows rows: not accused" is_not_accused "$work/long.csv" $rows
    done
    "$tool" simulate --gyro --dwell 3 --plan directions:"$work/tour.csv" --seed $seed > "$work/long.csv"
    for rows in 1500 2000 3000 3500; do
        check "tour, seed $seed, $rows rows: not accused" is_not_accused "$work/long.csv" $rows
    done
done
check "7 rests: undetermined, and what to do" says \
    '6 usable moves do not determine both sensors: make more moves, about each of the three axes'
head -n 1500 "$work/long.csv" > "$work/short.csv"
refuses "3 rests: they do not show which way was up" 1 \
    'the 3 rests between the moves do not show the accelerometer.s zero.*hold it still in four directions' calibrate "$work/short.csv"
head -n 2000 "$work/long.csv" > "$work/short.csv"
refuses "nor do 4 rests in a plane" 1 'the 4 rests .*: the rests are nearly in a plane: turn about all three axes' \
    calibrate "$work/short.csv"
for sensor in mpu0 mpu1; do
    awk -v name=$sensor -v zero=0 -v rate=7505.747 -v noise=10 -v shake=2000 -f "$here/random.awk" -f "$here/gyro_log.awk" "$here/../unit/gyro_logs.h" > "$work/long.csv"
    for rows in 3000 4000 5000; do
        check "MPU-9150, $sensor, $rows rows: not accused" is_not_accused "$work/long.csv" $rows --gravity 9.81
    done
done
change '{ y = $6; $6 = -$5; $5 = y }'
head -n 3500 "$work/changed.csv" > "$work/short.csv"
refuses "axes that are exchanged are found in seven rests" 1 'state --gyro-axes -y,x,z' calibrate "$work/short.csv"
"$tool" simulate --gyro --dwell 3 --plan directions:"$work/tour.csv" --seed 7 | cut -d, -f5-7 > "$work/gyro7.csv"
paste -d, "$work/acc.csv" "$work/gyro7.csv" | awk -F, 'NF == 7 && $1 != "" && $5 != ""' > "$work/changed.csv"
solve "$work/changed.csv"
check "the gyroscope of another device: apart" refused_as apart 'one device and one clock'

# ---- reports on a gyroscope that is not good -----------------------------------------------------------

# A range of 30 degrees/s clips all but one of the moves.
"$tool" simulate --gyro --dwell 3 --plan edges --gyro-range 30 > "$work/clipped.csv"
solve "$work/clipped.csv"
clipped='unusable 16: at the end of the range'
check "clipped but for one move: undetermined, and why" refused_as undetermined "\"reason\": .*gyro scale x, .*; $clipped"
check "clipped but for one move: turn more slowly, or a larger range" matches "$work/stdout" '"remedy": "turn more slowly, or choose a larger range of the gyroscope; '
check "clipped but for one move: JSON names all moves" test "$(grep -c '"left_out": "at the end of the range"' "$work/stdout")" -eq 16
run calibrate "$work/clipped.csv"
check "the last line names the gyroscope" test "$(tail -n 1 "$work/stdout" | grep -c '^The gyroscope is not calibrated. Next, for it: turn more slowly')" -eq 1
# It reads -1 to 1, mostly 1, whatever the turn.
change '{ for (k = 5; k <= 7; k++) { r = uniform(); $k = r < 0.6 ? 1 : r < 0.7 ? -1 : 0 } }'
solve "$work/changed.csv"
check "noise of a count is not the end of the range" \
    refused_as 'too few' '"reason": "the gyroscope reads no turns between the rests",$'
run calibrate "$work/edges.csv"
check "a good one is not in the last line" lacks "$work/stdout" '^The gyroscope is'
# Nine rests that leave nothing of the accelerometer open, and one angle of the gyroscope.
head -n 4500 "$work/edges.csv" > "$work/short.csv"
run calibrate "$work/short.csv"
check "weak in the gyroscope alone: the accelerometer is good" matches "$work/stdout" '^Good: every parameter is determined'
check "weak in the gyroscope alone: the last line says where" test "$(tail -n 1 "$work/stdout")" = \
    'The gyroscope is weak: gyro angle yz; make more moves, about all three axes.'
solve "$work/short.csv"
check "weak in the gyroscope alone: the verdict of the accelerometer is good" matches "$work/stdout" '^  "verdict": "good"'
check "weak in the gyroscope alone: JSON names it" test "$(inner "$work/stdout" undetermined)" = '["gyro_yz"]'
run calibrate "$work/short.csv" --strict --quiet
check "weak in the gyroscope alone: --strict" was_refused 1 '--strict: the gyroscope is weak: gyro angle yz'
head -n 3500 "$work/edges.csv" > "$work/short.csv"
run calibrate "$work/short.csv" --json
check "a refusal names the moves" test "$(grep -c '^ *"seconds": ' "$work/stdout")" -eq 6

# ---- the page ----------------------------------------------------------------------------------------

run calibrate "$work/edges.csv" --report "$work/page.html" --quiet
check "the page is well-formed" is_page "$work/page.html"
check "the page: a bar for each move, twice (wide and narrow)" test "$(grep -o 'class="c1 bar"' "$work/page.html" | wc -l)" -ge 36
check "the page: its rate in the words of the table" matches "$work/page.html" 'in [^<]*, [0-9.]+ per second'
check "the page: the constant" matches "$work/page.html" 'static const invcal_calibration calibration_gyro = '
change '{ $6 = 17 }'
run calibrate "$work/changed.csv" --report "$work/page.html" --quiet
check "the page: why there is none" matches "$work/page.html" 'never changes'
check "the page without one is well-formed" is_page "$work/page.html"

# ---- apply and export --------------------------------------------------------------------------------

run calibrate "$work/edges.csv" --out "$work/cal.json" --quiet
inner "$work/cal.json" offset | numbers > "$work/offset"
inner "$work/cal.json" matrix | numbers > "$work/matrix"
# rates FACTOR: of each row of the log, as the file's own numbers make them; three rows in motion
rates() {
    awk -F, 'NR == 320 || NR == 380 || NR == 1050 { print $5, $6, $7 }' "$work/edges.csv" |
        { cat "$work/offset"; echo; cat; } | awk -v m="$(cat "$work/matrix")" -v factor="$1" '
            BEGIN { split(m, M, " ") }
            NR == 1 { for (i = 1; i <= 3; i++) o[i] = $i; next }
            { for (i = 0; i < 3; i++) printf "%.9g ", factor * (M[3 * i + 1] * ($1 - o[1]) + M[3 * i + 2] * ($2 - o[2]) + M[3 * i + 3] * ($3 - o[3])) }'
}
accepts "apply" apply "$work/cal.json" "$work/edges.csv"
check "apply: the gyroscope has columns" matches "$work/stdout" '^t,x,y,z,gx,gy,gz$'
check "apply: rad/s" near 1e-8 "$(awk -F, 'NR == 320 || NR == 380 || NR == 1050 { print $5, $6, $7 }' "$work/stdout" | tr '\n' ' ')" "$(rates 1)"
cut -d, -f5-7 "$work/stdout" > "$work/rates.csv"
run apply "$work/cal.json" "$work/gyro.csv" --gyro
cut -d, -f2-4 "$work/stdout" > "$work/alone.csv"
check "apply --gyro: the same from a separate file" same "$work/rates.csv" "$work/alone.csv"
run apply "$work/cal.json" "$work/acc.csv"
check "apply: a log without a gyroscope" matches "$work/stdout" '^t,x,y,z$'
run calibrate "$work/acc.csv" --out "$work/none.json" --quiet
refuses "apply --gyro of a calibration without one" 2 'none\.json contains no gyroscope' apply "$work/none.json" "$work/gyro.csv" --gyro
sed 's/^    "matrix"/    "matrices"/' "$work/cal.json" > "$work/broken.json"
refuses "apply: a gyroscope that is incomplete" 3 '"gyroscope" is incomplete' apply "$work/broken.json" "$work/edges.csv"

# system OFFSET MATRIX: the same rows by matrix (raw - offset), numbers of an export
system() {
    awk -F, 'NR == 320 || NR == 380 || NR == 1050 { print $5, $6, $7 }' "$work/edges.csv" | awk -v o="$1" -v m="$2" '
        BEGIN { split(o, O, " "); split(m, M, " ") }
        { for (i = 0; i < 3; i++) printf "%.9g ", M[3 * i + 1] * ($1 - O[1]) + M[3 * i + 2] * ($2 - O[2]) + M[3 * i + 3] * ($3 - O[3]) }'
}
run export "$work/cal.json" --format c-arrays
o=$(sed -n 's/.*gyro_offset\[3\] = //p' "$work/stdout" | sed 's/f//g' | numbers)
m=$(sed -n '/gyro_matrix\[3\]/,/;/p' "$work/stdout" | sed 1d | sed 's/f//g' | numbers | tr '\n' ' ')
check "export --format c-arrays: the gyroscope" near 1e-5 "$(system "$o" "$m")" "$(rates 1)"
run export "$work/cal.json" --format c --name imu
check "export --format c: a second constant" matches "$work/stdout" '^static const invcal_calibration imu_gyro = \{$'
run export "$work/cal.json" --format imu_tk-gyro
m=$(awk 'NR <= 3 { for (i = 1; i <= 3; i++) t[NR, i] = $i } NR >= 5 && NR <= 7 { k[NR - 4] = $(NR - 4) }
    END { for (r = 1; r <= 3; r++) for (i = 1; i <= 3; i++) printf "%.17g ", t[r, i] * k[i] }' "$work/stdout")
check "export --format imu_tk-gyro: T K (X - B)" near 1e-8 "$(system "$(sed -n 9,11p "$work/stdout" | tr '\n' ' ')" "$m")" "$(rates 1)"
refuses "export --format imu_tk-gyro without one" 2 'none\.json contains none' export "$work/none.json" --format imu_tk-gyro
run export "$work/cal.json" --format fusion
o=$(sed -n 's/.*gyroscopeOffset = //p' "$work/stdout" | sed 's/f//g' | numbers)
m=$(sed -n '/gyroscopeMisalignment = /,/gyroscopeSensitivity/p' "$work/stdout" | sed 's/^static[^=]*=//; s/f//g' | numbers |
    tr '\n' ' ' | awk '{ for (i = 0; i < 9; i++) printf "%.17g ", $(i + 1) * $(10 + i % 3) }')
check "export --format fusion: degrees/s" near 1e-3 "$(system "$o" "$m")" "$(rates 57.29577951308232)"
in_unit "a log in °/s" 'gx (dps),gy (dps),gz (dps)' $dps °/s header
run calibrate "$work/changed.csv" --out "$work/dps.json" --quiet
run export "$work/dps.json" --format ardupilot --zero 0,0,0 --lsb 0.000598550415
check "export --format ardupilot: the bias, rad/s" near 2e-4 "$(sed -n 's/^INS_GYROFFS_[XYZ],//p' "$work/stdout" | tr '\n' ' ')" '0.0087266 -0.0139626 0.0052360'
run export "$work/dps.json" --format px4 --zero 0,0,0 --lsb 0.000598550415
check "export --format px4: the bias, rad/s" near 2e-4 "$(sed -n 's/.*CAL_GYRO0_[XYZ]OFF\t\(.*\)\t9$/\1/p' "$work/stdout" | tr '\n' ' ')" '0.0087266 -0.0139626 0.0052360'


# A driver delivers rad/s: the bias in counts is of no use for it, which must be reported.
left_out() { # WHY: in a comment and a warning
    matches "$work/stdout" "^# The gyroscope is left out: $1\.$" && lacks "$work/stdout" 'GYR.*OFF' &&
        matches "$work/stderr" "warning: .*json: the gyroscope is left out: $1$"
}
for format in px4 ardupilot ros; do
    why='its readings are counts; log them in rad/s or degrees/s'
    [ $format = ros ] && why='imu_calib measures its bias at each start'
    run export "$work/cal.json" --format $format --zero 0,0,0 --lsb 0.000598550415
    check "export --format $format: the gyroscope in counts is left out, and it says so" left_out "$why"
    run export "$work/none.json" --format $format --zero 0,0,0 --lsb 0.000598550415
    check "export --format $format: no mention without one" lacks "$work/stdout" gyroscope
    check "export --format $format: and no warning" lacks "$work/stderr" gyroscope
done
run export "$work/dps.json" --format ros --zero 0,0,0 --lsb 0.000598550415
check "export --format ros: of any unit" left_out 'imu_calib measures its bias at each start'
two_digits() { inner "$work/cal.json" sigma | numbers | awk '{ for (i = 1; i <= 9; i++) printf "%.2g ", $i }'; }
for format in c c-arrays fusion imu_tk-gyro; do
    run export "$work/cal.json" --format $format
    check "export --format $format: the gyroscope's verdict" matches "$work/stdout" '^( \*|#) gyroscope: good$'
    check "export --format $format: its standard deviations" test \
        "$(sed -n '/of its matrix over its scale/{n;p;n;p;n;p;}' "$work/stdout" | tr -d '*#\n' | tr -s ' ' | sed 's/^ //; s/$/ /')" \
        = "$(two_digits)"
    sed '/^    "sigma"/,/^    \]/d; /^    "verdict"/d' "$work/cal.json" > "$work/less.json"
    run export "$work/less.json" --format $format
    check "export --format $format: a file without them" matches "$work/stdout" '^( \*|#) gyroscope: unknown$'
done

change '{ $6 = 17 }'
run calibrate "$work/changed.csv" --strict --quiet
check "--strict: a gyroscope that is not calibrated" was_refused 1 "--strict: the gyroscope is not calibrated: .*y never changes"
accepts "--strict: a good one" calibrate "$work/edges.csv" --strict

# ---- g-sensitivity corrected ----------------------------------------------------------------------------

# In each rest of the truth nothing turns. Large scale errors, so that the order of the corrections matters.
"$tool" simulate --gyro --dwell 3 --plan per-group:8 --gyro-g 0,0.1,0,-0.2,0,0,0,0,0.15 --gyro-scale 0.1,-0.08,0.06 \
    --gyro-noise 0.005 --gyro-lsb 0.001 --truth "$work/truth.json" > "$work/g.csv"
at_rest() { # BOUND ARGUMENTS...: mean rates, degrees/s
    bound=$1
    shift
    run apply "$@"
    succeeded && is_small "$(awk -f "$here/gyro_rests.awk" "$work/truth.json" "$work/stdout")" "$bound"
}
for frame in '--frame symmetric' '--frame triangular' '--case -z' '--case .,-x'; do
    # shellcheck disable=SC2086 # two words
    run calibrate "$work/g.csv" --quiet --out "$work/g.json" $frame
    check "apply, $frame: no rate in any rest" at_rest 0.003 "$work/g.json" "$work/g.csv"
done
run calibrate "$work/g.csv" --quiet --out "$work/g.json" --report "$work/page.html"
check "g-sensitivity: as it was simulated, by the rate" near 1.5e-6 "$(inner "$work/g.json" g_correction | numbers)" \
    "$(inner "$work/truth.json" g_correction | numbers)" # rad/s per m/s^2: 5 sigma; the largest is 3.9e-4
check "apply of the truth: no rate either" at_rest 0.002 "$work/truth.json" "$work/g.csv"
sed '/"g_correction"/,/^    \]/d' "$work/g.json" > "$work/without.json"
run apply "$work/without.json" "$work/g.csv"
check "without it there is one" near 0.05 "$(awk -f "$here/gyro_rests.awk" "$work/truth.json" "$work/stdout")" 0.2
cut -d, -f1,5-7 "$work/g.csv" > "$work/gyro.csv"
run apply "$work/g.json" "$work/gyro.csv" --gyro
check "apply --gyro: without an accelerometer it is not corrected, which is reported" says "gyro\.csv: the gyroscope's g-sensitivity is not corrected"
accepts "apply --gyro --quiet: no warning about it" apply "$work/g.json" "$work/gyro.csv" --gyro --quiet
run export "$work/g.json" --format c --name imu
sed -n '/^static const invcal_real imu_gyro_g/,$p' "$work/stdout" | sed '1d; /^#/d' | tr -d 'INVCALRE_()f' | numbers > "$work/nine"
check "export --format c: the nine numbers" near 1e-15 "$(cat "$work/nine")" "$(inner "$work/g.json" g_correction | numbers)"
check "the page has them" matches "$work/page.html" '^static const invcal_real calibration_gyro_g\[3\]\[3\] =|>static const invcal_real calibration_gyro_g'
run export "$work/g.json" --format c-arrays
sed -n '/^static const float calibration_gyro_g/,$p' "$work/stdout" | sed '1d; s/f//g' | numbers > "$work/nine"
check "export --format c-arrays: the same" near 1e-10 "$(cat "$work/nine")" "$(inner "$work/g.json" g_correction | numbers)"
for format in fusion imu_tk-gyro; do
    run export "$work/g.json" --format $format
    check "export --format $format: it says that the format cannot store it" matches "$work/stdout" 'cannot store the gyroscope.s g-sensitivity'
    run export "$work/cal.json" --format $format
    check "export --format $format: not without one" lacks "$work/stdout" 'g-sensitivity'
done

# ---- watch -------------------------------------------------------------------------------------------

for log in edges.csv tour.log; do
    run calibrate "$work/$log" --json
    mv "$work/stdout" "$work/as"
    run watch "$work/$log" --json
    check "watch: $log ends with the result of calibrate" same "$work/stdout" "$work/as"
done
check "watch: it shows the accuracy of the gyroscope" matches "$work/stderr" 'gyroscope: 12 of 12 moves; scale ± 0\.0[0-9]* %, cross ± 0\.0[0-9]* degrees$'
change '{ y = $6; $6 = -$5; $5 = y }'
run watch "$work/changed.csv"
check "watch: exchanged axes are reported before the tenth position" test \
    "$(awk '/position 10 taken/ { exit } /gyroscope.s axes are not the accelerometer/ { n++ } END { print (n > 0) }' "$work/stdout")" = 1
run watch "$work/edges.csv" --accelerometer-only
check "watch --accelerometer-only: it is not mentioned" lacks "$work/stdout" 'gyroscope'

# ---- options -----------------------------------------------------------------------------------------

for pair in '--gyro-axes x,y' '--gyro-axes x,x,z' '--gyro-axes x,y,zz' '--gyro-lsb 0' '--gyro-lsb nonsense' '--gyro-lsb -1'; do
    # shellcheck disable=SC2086 # two words
    refuses "$pair" 2 'gyro-' calibrate "$work/edges.csv" $pair
done
refuses "--gyro of positions" 2 'leave out --positions' calibrate "$work/edges.csv" --positions --gyro "$work/gyro.csv"
refuses "--gyro with --accelerometer-only" 2 'leave out --accelerometer-only' calibrate "$work/acc.csv" --gyro "$work/gyro.csv" --accelerometer-only
refuses "a gyroscope's file that is not there" 3 'none\.csv' calibrate "$work/acc.csv" --gyro "$work/none.csv"

# ---- real sensors, from their rests and moves ----------------------------------------------------------

real() { awk -v name="$1" -v zero="$2" -v rate="$3" -v noise="$4" -v shake="$5" -f "$here/random.awk" -f "$here/gyro_log.awk" "$here/../unit/gyro_logs.h" > "$work/real.csv"; }
reference() { sed -n "/$1/,/;/p" "$here/../reference/gyro_samples.h" | sed 's/.*=//' | tr -d '{};\n'; }
multiplied() { awk -v k="$1" '{ for (i = 1; i <= NF; i++) printf "%.6f ", $i * k }'; } # numbers, times K
real xsens 32768 4772 3 20000
solve "$work/real.csv" --gravity 9.81744
# of counts of 1/4772 rad/s
inner "$work/stdout" matrix | numbers | multiplied 4772 > "$work/nine"
check "Xsens MTi: as from all samples" near 0.001 "$(cat "$work/nine")" \
    "$(reference xsens_gyro)"
check "Xsens MTi: residual" is_small "$(inner "$work/stdout" residual_rms)" 2.1e-3
run calibrate "$work/real.csv" --gravity 9.81744
check "Xsens MTi: g-sensitivity about y along x, xsens_slope there" matches "$work/stdout" '^g-sensitivity *about y, at most -0\.1[45][0-9]* ± 0\.0[01][0-9]* °/s per g along x'
real mpu0 0 7505.747 10 2000
solve "$work/real.csv" --gravity 9.81
check "MPU-9150: residual" is_small "$(inner "$work/stdout" residual_rms)" 2.1e-3
real mpu1 0 7505.747 10 2000
run calibrate "$work/real.csv" --gravity 9.81
# How far the bias of a rest is from the median of all, degrees/s, from the table itself.
turned() { # REST
    awk '/mpu1_rest/ { on = 1; next } on && /^};/ { exit } on { gsub(/[{},]/, " "); print $1, $2, $3 }' "$here/../unit/gyro_logs.h" > "$work/biases"
    for axis in 1 2 3; do
        sort -n -k $axis,$axis "$work/biases" | awk -v axis=$axis '{ x[NR] = $axis } END { print x[int(NR / 2) + 1] }'
    done | tr '\n' ' ' | { cat; sed -n "$1p" "$work/biases"; } | awk '
        { printf "%.2g", sqrt(($1 - $4)^2 + ($2 - $5)^2 + ($3 - $6)^2) / 2^18 * 57.29578 }'
}
check "another: the two rests that turned are named" test "$(grep -c '^Left out: position' "$work/stdout")" -eq 2
for rest in 4 12; do
    check "another: rest $rest, and how fast it turned" matches "$work/stdout" \
        "^Left out: position $rest \(line [0-9]+\), for the gyroscope, with the moves to and from it: the device turned at $(turned $rest) °/s"
done
check "another: the move that contradicts is named" matches "$work/stdout" '^Left out: the move from position 6 to 7 .*contradicts the others'

# ---- the same from all samples, where the recordings are (RECORDINGS, or ../shared/data) ------------------

recordings=${RECORDINGS:-$here/../../../shared/data}
if [ -f "$recordings/xsens_mti_gyro.txt" ]; then
    accepts "Xsens MTi, the raw log" calibrate "$recordings/xsens_mti_acc.txt" --gyro "$recordings/xsens_mti_gyro.txt" \
        --gravity 9.81744 --json
    check "Xsens MTi, the raw log: matrix, by the reference's 16 rests" near 0.0006 \
        "$(inner "$work/stdout" matrix | numbers | multiplied 4772)" "$(reference xsens_gyro)"
    check "Xsens MTi, the raw log: residual" is_small "$(inner "$work/stdout" residual_rms)" 1.7e-3
    # numpy over all 38 rests: -0.154 +- 0.006 degrees/s per g
    check "Xsens MTi, the raw log: g-sensitivity about y along x" near 0.006 \
        "$(sed -n '/"g_sensitivity"/,$p' "$work/stdout" | sed -n '/"value"/{n;n;p;q;}' | numbers | awk '{ print $1 * 57.29578 }')" -0.154
    for log in 0 1; do
        accepts "MPU-9150 $log, the raw log" calibrate "$recordings/mpu9150_$log.txt" --gravity 9.81 --json
        mv "$work/stdout" "$work/mpu$log.json"
    done
    check "MPU-9150 0, the raw log: matrix" near 0.0045 "$(inner "$work/mpu0.json" matrix | numbers)" "$(reference mpu_gyro)"
    check "MPU-9150 0, the raw log: residual" is_small "$(inner "$work/mpu0.json" residual_rms)" 2.1e-3
    check "MPU-9150 1, the raw log: residual" near 0.05e-3 "$(inner "$work/mpu1.json" residual_rms)" 1.60e-3
    run calibrate "$recordings/mpu9150_1.txt" --gravity 9.81
    check "MPU-9150 1, the raw log: rests 4 and 12, in which it turned, and the move that contradicts are named" test \
        "$(sed -n -e 's/^Left out: \(position [0-9]*\) .*/\1/p' -e 's/^Left out: \(the move from position [0-9]* to [0-9]*\) .*/\1/p' "$work/stdout" | tr '\n' ',')" = \
        "position 4,the move from position 6 to 7,position 12,"
fi

# ---- apply --gyro: by header, --columns or number ------------------------------------------------------

"$tool" simulate --gyro --dwell 3 --plan edges > "$work/both.csv"
"$tool" calibrate "$work/both.csv" --quiet --out "$work/both.json"
"$tool" apply "$work/both.json" "$work/both.csv" --gyro | awk -F, 'NR > 1 { print $2, $3, $4 }' > "$work/rates"
sed 1d "$work/both.csv" > "$work/seven.csv"
cut -d, -f 1,5-7 "$work/seven.csv" > "$work/four.csv"
same_rates() { # LOG OPTION...
    log=$1
    shift
    run apply "$work/both.json" "$log" --gyro "$@"
    succeeded && awk -F, '$NF + 0 == $NF { print $(NF - 2), $(NF - 1), $NF }' "$work/stdout" | cmp -s - "$work/rates"
}
check "apply --gyro: the same rates with --columns by name" same_rates "$work/both.csv" --columns gx,gy,gz
check "apply --gyro: with --columns by number" same_rates "$work/four.csv" --columns 2,3,4
check "apply --gyro: of four columns without a header" same_rates "$work/four.csv"
check "apply --gyro: of seven, the last three" same_rates "$work/seven.csv"
refuses "a magnetometer has no gyroscope" 2 '--magnetometer: cannot be combined with --gyro-lsb' \
    calibrate "$work/both.csv" --magnetometer --gyro-lsb 1

finish
