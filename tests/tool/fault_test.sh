#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What the tool says about a sensor or a clock that fails, log by log: fault_test.sh path/to/invcal
# builddir. A line of awk damages a good log; the message, the exit code and the offset must be as
# stated.
# shellcheck disable=SC2016 # $2 and the like belong to awk
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Six faces, three edges, which make nine, and the other edges.
{
    echo x,y,z
    for sign in 1 -1; do echo $sign,0,0; echo 0,$sign,0; echo 0,0,$sign; done
    for p in 1 -1; do for q in 1 -1; do echo 0,$q,$p; echo $p,0,$q; echo $q,$p,0; done; done
} > "$work/directions.csv"
"$tool" simulate --plan "directions:$work/directions.csv" --truth "$work/truth.json" > "$work/good.csv"

# Columns are t x y z; half is 1 from the middle of the log on; old[1] ... is the previous line.
damage() { # NAME AWK: $work/NAME.csv
    awk -F, -v OFS=, 'NR == 1 { print; next } { half = NR > 6200 }
        '"$2"' { print; for (i = 1; i <= 4; i++) old[i] = $i }' "$work/good.csv" > "$work/$1.csv"
}

# The true offset, with its axes in this order, agrees with the result to that many counts.
is_offset() { # COUNTS ORDER
    near "$1" "$(json "$work/stdout" offset)" "$(json "$work/truth.json" offset | tr -d '[]' |
        awk -F, -v order="$2" '{ split(order, i, ""); print $i[1], $i[2], $i[3] }')"
}

# fault NAME CODE PATTERN AWK [OPTION ...]: exit code and a line that is printed
fault() {
    name=$1
    expected=$2
    pattern=$3
    damage fault "$4"
    shift 4
    run calibrate "$work/fault.csv" "$@"
    cat "$work/stdout" "$work/stderr" > "$work/said"
    check "fault: $name: exit code $expected" test "$code" -eq "$expected"
    check "fault: $name: told" matches "$work/said" "$pattern"
    [ "$code" -eq 0 ] || check "fault: $name: in one line" test "$(wc -l < "$work/said")" -eq 1
}

right() { # NAME COUNTS [ORDER]: of the fault before
    run calibrate "$work/fault.csv" --json
    check "fault: $1: does no harm" is_offset "$2" "${3:-123}"
}

stuck='readings, or those of an axis, never change: is the sensor read\?'

fault none 0 '^Good: ' ''
right none 1.5
fault "nothing but zeros" 1 "no rest .* 1: $stuck" '{ $2 = $3 = $4 = 0 }'
fault "frozen" 1 "no rest .* 1: $stuck" '{ $2 = 100; $3 = 200; $4 = 16000 }'
fault "freezes half-way" 0 "^ +1 rest refused: $stuck" 'half { $2 = old[2]; $3 = old[3]; $4 = old[4] }'
check "fault: freezes half-way: not called good" matches "$work/said" '^No redundancy: '
fault "one axis frozen" 1 "no rest .* 18: $stuck" '{ $4 = 250 }'
fault "one axis freezes half-way" 0 "^ +9 rests refused: $stuck" 'half { $4 = old[4] }'
check "fault: one axis freezes half-way: not called good" matches "$work/said" '^No redundancy: '
clip='{ $2 = $2 > 15500 ? 15500 : $2 < -15500 ? -15500 : $2 }'
fault "clips at a rail that is not stated" 0 "^ +2 rests refused: $stuck" "$clip"
right "clips at a rail that is not stated" 1.5
# A rail that is touched in a move counts, too.
fault "clips at a rail that is stated" 0 "^ +6 rests refused: at the end of the range" \
    "$clip" --clip -15500,15500
fault "two axes exchanged" 0 '^Good: ' '{ x = $2; $2 = $3; $3 = x }'
right "two axes exchanged, and calibrated as they read" 1.5 213
fault "two axes exchanged half-way" 0 'residuals are [0-9]+ times as large as this noise' \
    'half { x = $2; $2 = $3; $3 = x }'
check "fault: two axes exchanged half-way: not called good" matches "$work/said" '^(Rough|Drifting|Bent|Weak): '
fault "an offset that steps half-way" 0 '^Rough: the positions disagree by [0-9]+ times' \
    'half { $2 += 200 }'
fault "one sample of 1,000 at a rail" 0 '^Good: ' 'NR % 1000 == 500 { $2 = -32768 }'
right "one sample of 1,000 at a rail" 1.5
fault "a quarter of the samples half-way" 0 '^ +[0-9]+ rests? refused: too short: hold still' \
    'half && NR % 4 { next }'
check "fault: a quarter of the samples half-way: not called good" matches "$work/said" \
    '^No redundancy: '

# ---- the fixture, and the hand -----------------------------------------------------------------------

# 0.5 degrees a second in two rests.
fault "rests in a slow turn" 0 '^ +[234] rests refused: drifts: turning or settling' \
    '$1 > 14 && $1 < 20 { $2 += 140 * ($1 - 14) } $1 > 35 && $1 < 41 { $3 += 140 * ($1 - 35) }'
right "rests in a slow turn" 1.5
# The case rocks by 0.06 rad at 17 Hz about z: cos has the mean 1 - 0.06^2 / 4, by which x and y read less.
fault "a case that rocks" 0 '^Good: ' '{ a = 0.06 * sin(106.8141502 * $1); x = $2 - 327.68; y = $3 + 245.76
    $2 = sprintf("%.0f", x * cos(a) - y * sin(a) + 327.68); $3 = sprintf("%.0f", y * cos(a) + x * sin(a) - 245.76) }'
rectified() {
    run calibrate "$work/fault.csv" --zero 0,0,0 --lsb 0.000598550415 --json
    near 0.0002 "$(json "$work/stdout" dk)" "$(json "$work/truth.json" dk | tr -d '[]' |
        awk -F, '{ print $1 - 0.0009, $2 - 0.0009, $3 }')"
}
check "fault: a case that rocks: scales are wrong by half the square of its angle, no more" rectified
# One leg of the table gives way: the nine positions after that lean by 2 degrees.
awk -F, 'NR <= 10 { print; next } { c = cos(0.035); s = sin(0.035); printf "%.9f,%.9f,%s\n", $1 * c - $2 * s, $2 * c + $1 * s, $3 }' \
    "$work/directions.csv" > "$work/leaning.csv"
"$tool" simulate --plan "directions:$work/leaning.csv" > "$work/fault.csv"
run calibrate "$work/fault.csv"
check "fault: a table that tilts between visits: good" matches "$work/stdout" '^Good: '
right "a table that tilts between visits" 1.5
"$tool" simulate --plan "directions:$work/directions.csv" --tremor 0.003 > "$work/fault.csv"
run calibrate "$work/fault.csv"
check "fault: a hand: good, if it is as noisy in rests as between them" matches "$work/stdout" '^Good: '
run calibrate "$work/fault.csv" --json
check "fault: a hand: errors stay within sigma" is_offset 20 123

# ---- the clock ---------------------------------------------------------------------------------------

fault "a clock that is 30 % slow" 0 '76\.9 samples per second$' '{ $1 *= 1.3 }'
right "a clock that is 30 % slow" 1.5
fault "a clock that jumps by an hour" 0 '^ +1 gap in the stream' 'half { $1 += 3600 }'
right "a clock that jumps by an hour" 1.5
fault "a clock that is set back" 0 '^ +1 gap in the stream' 'half { $1 -= 30 }'
right "a clock that is set back" 1.5
fault "a clock that stands still" 3 'fault\.csv:2: the times advance by 0, which cannot be seconds .*: state --rate$' '{ $1 = 5 }'
fault "a reading that is not a number" 3 "fault\\.csv:6201: column 2 \\(x\\): 'nan' is not a finite number" \
    'NR == 6201 { $2 = "nan" }'
finish
