#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What the tool says of a sensor or a clock that fails, log by log: fault_test.sh path/to/invcal
# builddir. A good log is damaged by a line of awk; the message, the exit code and what comes of the
# offset are compared with a table.
# shellcheck disable=SC2016 # $2 and the like belong to awk
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

"$tool" simulate --plan edges --truth "$work/truth.json" > "$work/good.csv"

# Columns are t x y z; half is 1 from the middle of the log on; old[1] ... is the line before.
damage() { # NAME AWK: $work/NAME.csv
    awk -F, -v OFS=, 'NR == 1 { print; next } { half = NR > 6200 }
        '"$2"' { print; for (i = 1; i <= 4; i++) old[i] = $i }' "$work/good.csv" > "$work/$1.csv"
}

# The offset of the truth, the axes in this order, agrees with the result to so many counts.
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
# A rail touched on the way is one too.
fault "clips at a rail that is stated" 0 "^ +6 rests refused: at the end of the sensor's range" \
    "$clip" --clip -15500,15500
fault "two axes exchanged" 0 '^Good: ' '{ x = $2; $2 = $3; $3 = x }'
right "two axes exchanged, and calibrated as they read" 1.5 213
fault "two axes exchanged half-way" 0 'residuals are [0-9]+ times as large as that noise' \
    'half { x = $2; $2 = $3; $3 = x }'
check "fault: two axes exchanged half-way: not called good" matches "$work/said" '^Rough: '
fault "an offset that steps half-way" 0 '^Rough: .*but 4 of 18 positions are left out' \
    'half { $2 += 200 }'
fault "one sample of 1,000 at a rail" 0 '^Good: ' 'NR % 1000 == 500 { $2 = -32768 }'
right "one sample of 1,000 at a rail" 1.5
fault "a quarter of the samples half-way" 0 '^ +[0-9]+ rests? refused: too short: hold it still' \
    'half && NR % 4 { next }'
check "fault: a quarter of the samples half-way: not called good" matches "$work/said" \
    '^No redundancy: '
fault "a clock that is 30 % slow" 0 '76\.9 samples a second$' '{ $1 *= 1.3 }'
right "a clock that is 30 % slow" 1.5
fault "a clock that jumps by an hour" 0 '^ +1 gap in the stream' 'half { $1 += 3600 }'
right "a clock that jumps by an hour" 1.5
fault "a clock that is set back" 0 '^ +1 gap in the stream' 'half { $1 -= 30 }'
right "a clock that is set back" 1.5
fault "a clock that stands still" 3 'fault\.csv:2: the times go on by 0,.*state --rate' '{ $1 = 5 }'
fault "a reading that is none" 3 "fault\\.csv:6201: column 2 \\(x\\): 'nan' is not a finite number" \
    'NR == 6201 { $2 = "nan" }'
finish
