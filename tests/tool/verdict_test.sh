#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The tool's verdicts, file by file: verdict_test.sh path/to/invcal builddir. Ten files of each trouble;
# the verdict, its cause, and the parameters.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# files TROUBLE: $work/TROUBLE.1 ... and the output for each, .said and .json
files() {
    for seed in 1 2 3 4 5 6 7 8 9 10; do
        file=$work/$1.$seed
        awk -v trouble="$1" -v seed="$seed" -f "$here/random.awk" -f "$here/trouble.awk" > "$file"
        "$tool" calibrate "$file" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 \
            > "$file.said" 2>&1
        "$tool" calibrate "$file" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --json \
            > "$file.json" 2>&1
    done
}

# How many of the ten say that, in text and in JSON.
count() { grep -El -- "$2" "$work/$1".*."$3" | wc -l; }
called() { # TROUBLE TEXT JSON [LEAST]
    [ "$(count "$1" "$2" said)" -ge "${4:-10}" ] && [ "$(count "$1" "$3" json)" -ge "${4:-10}" ]
}

# The parameters of every file are within 5 of their sigma.
are_right() { # TROUBLE [FIRST PARAMETER: delta, dk or gamma]
    for json in "$work/$1".*.json; do
        for kind in delta dk gamma; do
            json "$json" "$kind" | tr -d '[],'
            awk -v kind="$kind" '/"sigma"/ { on = 1 } on && $1 == "\"" kind "\":" { print; exit }' "$json" |
                sed 's/.*\[//; s/[],]/ /g'
        done
    done | awk 'BEGIN { split("0.03 -0.02 0.01 0.02 -0.03 0.01 0.008 0 -0.02", truth) }
        NR % 2 { split($0, x); next }
        { split($0, sigma)
          for (i = 1; i <= 3; i++) {
              d = x[i] - truth[(NR / 2 - 1) % 3 * 3 + i]
              if (!(d * d <= 25 * sigma[i] * sigma[i])) { print x[i], truth[(NR / 2 - 1) % 3 * 3 + i], sigma[i]; bad = 1 }
          } }
        END { exit bad || NR != 60 }'
}

files none
check "verdict: without trouble it is good, nine times of ten" called none '^Good: ' '"good"' 9
check "verdict: and right" are_right none

files drift
check "verdict: a drift is named" called drift '^Drifting: the offsets drift, by ' '"drifting"'
check "verdict: it is fitted: the calibration holds for the middle" are_right drift
has_drift() {
    for json in "$work"/drift.*.json; do
        near 0.0005 "$(sed -n 's/^ *"drift": \[\(.*\)\],$/\1/p' "$json" | tr -d ,)" '0.003 -0.004 0' || return 1
    done
}
check "verdict: and the drift is reported" has_drift

files step
check "verdict: a step is not called good" called step '^(Rough|Drifting|Bent): ' '"(rough|drifting|bent)"'

files quadratic
check "verdict: a quadratic error is named with its axis and size" called quadratic \
    '^Bent: the y axis has a quadratic error: .* (4\.[4-9]|5\.[0-8]?) mg more' '"kind": "quadratic"'
files cubic
check "verdict: a cubic error, too" called cubic \
    '^Bent: the x axis has a cubic error: .* (1[7-9]|2[0-3]) mg more' '"kind": "cubic"'
files hysteresis
check "verdict: and hysteresis" called hysteresis \
    '^Bent: the z axis has hysteresis: it reads (3\.[5-9]|4\.[0-4]?) mg' \
    '"kind": "hysteresis"'

files repeated
check "verdict: nine directions again and again have no redundancy" called repeated \
    '^(No redundancy|Weak): ' '"degrees_of_freedom": 0'
files noisy
check "verdict: noise above the stated one is reported" called noisy \
    '^Rough: the positions disagree by [3-7](\.[0-9])? times the noise stated' '"rough"'
files wrong
check "verdict: two wrong positions are left out" called wrong '^Left out: position 20 ' \
    '"rejected": \[4, 20\]'
check "verdict: and cause no error" are_right wrong
files spoilt
check "verdict: seven of 24 are too many" called spoilt '^(Rough|Bent|Drifting|Contradictory): ' \
    '"(rough|bent|drifting)"'

# ---- nonlinearity, and the l1 estimate ------------------------------------------------------------------

fits() { # TROUBLE OPTION PATTERN [OPTIONS]: what is said of all ten, which are good but for at most one
    trouble=$1
    option=$2
    pattern=$3
    shift 3
    good=0
    for file in "$work/$trouble".[0-9] "$work/$trouble".10; do
        run calibrate "$file" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 "$option" "$@"
        tr '\n' ' ' < "$work/stdout" > "$work/words"
        [ "$code" -eq 0 ] && matches "$work/words" "$pattern" || return 1
        matches "$work/stdout" '^Good: ' && good=$((good + 1))
    done
    [ "$good" -ge 9 ]
}
check "nonlinearity: a quadratic is fitted and reported, and the rest is good" fits quadratic --quadratic \
    'quadratic y  +(4\.[0-9]+|5\.[0-9]+) ± 0\.[1-4][0-9]* +mg per g²'
check "nonlinearity: a cubic, too" fits cubic --cubic 'cubic x  +(1[89]|2[01])\.?[0-9]* ± [0-9.]+ +mg per g³'
check "l1: it agrees where nothing is wrong" fits none --robust 'l1 .* it +agrees\.'
check "l1: and where two wrong positions were left out" fits wrong --robust 'l1 .* it +agrees\.'
run calibrate "$work/wrong.1" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --robust --keep-all
check "l1: not where they were kept" matches "$work/stdout" 'it contradicts'
run calibrate "$work/wrong.1" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --robust --keep-all --json
check "l1: nor in JSON" matches "$work/stdout" '"answer": "contradicts"'
# The two wrong ones pull offsets by 10 mg, but the l1 estimate stays near the truth.
l1_of() { sed -n '/^  "robust"/,/^  }/s/.*"delta": \[\(.*\)\].*/\1/p' "$work/stdout" | tr -d ,; }
check "l1: and is right itself" near 0.001 '0.03 -0.02 0.01' "$(l1_of)"
run calibrate "$work/none.1" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --robust --json
check "l1: JSON where it agrees" matches "$work/stdout" '"answer": "agrees"'
run calibrate "$work/quadratic.1" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --quadratic --json
member() { sed -n "s/^ *\"$1\": \[\(.*\)\],*\$/\1/p" "$work/stdout" | tr -d ,; }
check "nonlinearity: JSON" near 0.001 '0 0.005 0' "$(member quadratic)"
check "nonlinearity: its sigma" near 0.0003 '0.0002 0.0002 0.0002' "$(member quadratic_sigma)"
head -n 13 "$work/none.1" > "$work/thirteen"
run calibrate "$work/thirteen" --positions --zero 0,0,0 --lsb 1 --quadratic --json
check "nonlinearity: JSON of a refusal" matches "$work/stdout" '"error": "too few"'
check "nonlinearity: and its exit code" test "$code" -eq 1
refuses "nonlinearity: 13 positions are too few" 1 '--quadratic: 13 positions are too few: 14' \
    calibrate "$work/thirteen" --positions --zero 0,0,0 --lsb 1 --quadratic
"$tool" plan --icosahedron --json | sed -n 's/^ *"vertical": \[\(.*\)\],*$/\1/p' > "$work/twelve"
cat "$work/twelve" "$work/twelve" > "$work/corners"
refuses "nonlinearity: what the positions leave open is named" 1 '--cubic: the positions do not determine cubic x' \
    calibrate "$work/corners" --positions --zero 0,0,0 --lsb 1 --gravity 1 --cubic
refuses "nonlinearity: --cubic includes --quadratic" 2 'includes --quadratic' \
    calibrate "$work/none.1" --positions --quadratic --cubic
refuses "nonlinearity: not over temperature" 2 '--quadratic: cannot be combined with --thermal' \
    calibrate "$work/none.1" --positions --quadratic --thermal 1
refuses "l1: nine parameters only" 2 '--robust: needs nine free parameters: leave out --cubic;' \
    calibrate "$work/none.1" --positions --robust --cubic

# ---- nonlinearity, corrected -----------------------------------------------------------------------------

# The readings of a sensor with known errors in a field x y z, in counts: zero + 16384 ((I + S) eta + delta +
# q eta^2 + c eta^3); and the field, m/s^2.
bent() { # bent FILE TIMES
    awk -v times="$2" 'BEGIN { split("0.03 -0.02 0.01 0.02 -0.03 0.01 0.008 0.004 -0.02", X)
            split("0.01 -0.02 0.015", q); split("-0.012 0.02 0.01", c) }
        { for (i = 1; i <= 3; i++) e[i] = times * $i
          u[1] = (1 + X[4]) * e[1] + X[7] / 2 * e[2] + X[8] / 2 * e[3]
          u[2] = X[7] / 2 * e[1] + (1 + X[5]) * e[2] + X[9] / 2 * e[3]
          u[3] = X[8] / 2 * e[1] + X[9] / 2 * e[2] + (1 + X[6]) * e[3]
          for (i = 1; i <= 3; i++)
              printf "%.9f%s", 32768 + 16384 * (u[i] + X[i] + q[i] * e[i] ^ 2 + c[i] * e[i] ^ 3), (i < 3 ? "," : "\n")
        }' "$work/$1"
}
verticals() { "$tool" plan "$@" --json | sed -n 's/^ *"vertical": \[\(.*\)\],*$/\1/p' | tr -d ,; }
verticals --per-group 8 > "$work/program"
verticals --optimal 40 > "$work/unseen"
bent program 1 > "$work/bent.csv"
# The largest error after apply, over the field, of readings at TIMES the field: of vectors or, with a 1, only of
# lengths.
worst() { # worst CAL TIMES [LENGTHS]
    bent unseen "$2" > "$work/readings.csv"
    run apply "$1" "$work/readings.csv"
    sed 1d "$work/stdout" | tr , ' ' | paste -d ' ' - "$work/unseen" | awk -v times="$2" -v lengths="$3" '
        { square = felt = 0
          for (i = 1; i <= 3; i++) { felt += $i ^ 2; square += ($i / 9.80665 - times * $(i + 3)) ^ 2 }
          d = lengths ? sqrt(felt) / 9.80665 - times : sqrt(square)
          d = d < 0 ? -d : d; if (d > most) most = d }
        END { print (NR == 40 ? most : "none") }'
}
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "none" && a < b) }'; }
known="--zero 32768,32768,32768 --lsb 0.000598550415"
# shellcheck disable=SC2086 # $known is several words
{
    run calibrate "$work/bent.csv" --positions $known --cubic --out "$work/symmetric.json" --quiet
    run calibrate "$work/bent.csv" --positions $known --cubic --frame triangular --out "$work/triangular.json" --quiet
    run calibrate "$work/bent.csv" --positions $known --cubic --plan per-group:8 --frame stand --out "$work/stand.json" --quiet
    run calibrate "$work/bent.csv" --positions $known --out "$work/linear.json" --quiet
    run calibrate "$work/bent.csv" --positions --cubic --out "$work/free.json" --quiet
}
check "nonlinearity: without it readings are 1 % wrong" below 0.01 "$(worst "$work/linear.json" 1)"
# The fit is right to 1e-6; test_nonlinear_correction shows that apply adds nothing to that.
for at in 1 0.5; do
    check "nonlinearity: apply corrects it, at $at of the field" below "$(worst "$work/symmetric.json" $at)" 2e-6
    check "nonlinearity: in the frame of the stand, too, at $at" below "$(worst "$work/stand.json" $at)" 2e-6
    check "nonlinearity: triangular: lengths, at $at" below "$(worst "$work/triangular.json" $at 1)" 2e-6
done
check "nonlinearity: triangular: rotated" below 0.001 "$(worst "$work/triangular.json" 1)"
check "nonlinearity: nothing is beyond the edge" test ! -s "$work/stderr"
check "nonlinearity: an estimated nominal: lengths" below "$(worst "$work/free.json" 1 1)" 1e-3
worst "$work/symmetric.json" 3 > "$work/far"
check "nonlinearity: beyond the edge it is held, which is reported" matches "$work/stderr" \
    'warning: .*readings\.csv: 40 of 40 readings are beyond 1\.1 times the field on an axis, up to 3\.'
# At 3 eta the model is off by what q 9 eta^2 + c 27 eta^3 is more than at the edge: 0.6 of the field at most.
check "nonlinearity: and bounded" below "$(cat "$work/far")" 0.8
sed 's/"field": .*/"field": 0,/' "$work/symmetric.json" > "$work/broken.json"
refuses "nonlinearity: incomplete" 3 '"nonlinearity" is incomplete' apply "$work/broken.json" "$work/bent.csv"
sed 's/"quadratic": .*/"quadratic": [0.3, 0, 0],/' "$work/symmetric.json" > "$work/broken.json"
refuses "nonlinearity: too large" 3 '"nonlinearity" is too large' apply "$work/broken.json" "$work/bent.csv"
for format in c c-arrays px4 ardupilot ros imu_tk fusion; do
    refuses "nonlinearity: --format $format has no place for it" 2 "quadratic or cubic errors, which --format $format cannot" \
        export "$work/symmetric.json" --format $format
done

# ---- good enough? ------------------------------------------------------------------------------------

# The accuracy of lengths, from the sigma in the file; that of dk includes the field's already.
accuracy() {
    awk -F'[][,:]' '/"sigma"/ { on = 1 } /"interval95"/ { wide = $2 } /"gravity":/ { g = $2 } /"gravity_sigma"/ { f = $2 }
        on && /"(delta|dk|gamma)"/ { for (i = 3; i <= 5; i++) square[$1] += $i * $i }
        /"interval95"/ { on = 0 }
        END { for (k in square) {
                  if (k ~ /delta/) sum += square[k] / 3
                  if (k ~ /dk/) sum += (square[k] - 3 * f * f / g / g) / 5
                  if (k ~ /gamma/) sum += square[k] / 15
              }
              printf "%.9g", g * sqrt(wide * wide * sum + (1.959964 * f / g) ^ 2) }' "$1"
}

needs() { # MISSING SENTENCE FILE NEED GRAVITY; none.1 leaves a large part of the sphere empty
    run calibrate "$work/$3" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --gravity "$5" --need "$4"
    matches "$work/stdout" "$2" &&
        run calibrate "$work/$3" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --gravity "$5" --need "$4" \
            --json && grep -q "\"missing\": \"$1\"" "$work/stdout" && is_json "$work/stdout"
}
exact='9.80665+-0'
needs nothing . none.2 0.5 $exact
check "need: lengths are right to within sigma" near 1e-6 "$(json "$work/stdout" accuracy95)" \
    "$(accuracy "$work/stdout")"
needs nothing . none.2 0.5 '9.80665+-0.01'
check "need: and the sigma of the field" near 1e-6 "$(json "$work/stdout" accuracy95)" "$(accuracy "$work/stdout")"
check "need: it is met" needs nothing '^PASS: \|a\| within 0\.001[0-9]+ of 0\.0020 m/s² \(95 %\)\.$' \
    none.2 0.002 $exact
check "need: a known g is missing" needs gravity '^FAIL: \|a\| within 0\.05[0-9]* of 0\.010 m/s² \(95 %\)\. Missing: the length' none.2 0.01 \
    '9.80665+-0.027'
check "need: more positions are missing" needs positions \
    '^FAIL: \|a\| within 0\.001[0-9]* of 0\.0010 m/s² \(95 %\)\. Missing: about [45][0-9]' none.2 0.001 $exact
check "need: longer rests are missing" needs 'longer rests' '2[0-9] times as long' none.2 0.0003 $exact
check "need: a warm sensor is missing" needs warm-up '^FAIL: the verdict is drifting; .* of 0\.50 m/s² \(95 %\)\. Missing: a warm sensor' drift.1 0.5 $exact
check "need: a linear sensor is missing" needs linearity 'Missing: a linear sensor' cubic.1 0.5 $exact
check "need: steadier positions are missing" needs steadiness 'Missing: steadier positions' noisy.1 0.5 $exact
check "need: other directions are missing" needs directions '^FAIL: the verdict is no redundancy; .* Missing: positions' repeated.1 0.5 $exact
run calibrate "$work/none.1" --positions --need 0
check "need: must be above 0" [ "$code" -eq 2 ]
run calibrate "$work/none.1" --positions --need 0.06 --report "$work/need.html"
check "need: the report has it" grep -q 'PASS: |a| within 0.05[0-9] of 0.060 m/s²' "$work/need.html"

# ---- the noise of a rest ---------------------------------------------------------------------------

# The offsets of a simulated log are within 4 sigma of the truth, and sigma is no larger than LARGEST counts.
log() { # LARGEST ARGUMENTS...
    largest=$1
    shift
    for seed in 1 2 3 4; do
        "$tool" simulate --plan edges --seed $seed --truth "$work/truth.json" "$@" > "$work/log.csv"
        lsb=$(awk -v lsb="${LSB:-0.000598550415}" 'BEGIN { print lsb }')
        run calibrate "$work/log.csv" --zero 0,0,0 --lsb "$lsb" --json
        cp "$work/stdout" "$work/log.json"
        {
            json "$work/log.json" offset
            json "$work/truth.json" offset
            awk '/"sigma"/ { on = 1 } on && /"offset"/ { print; exit }' "$work/log.json" | sed 's/.*: //'
        } | tr -d '[],' | awk -v most="$largest" '{ split($0, row); for (i = 1; i <= 3; i++) x[NR, i] = row[i] }
            END { for (i = 1; i <= 3; i++) {
                d = (x[1, i] - x[2, i]) / x[3, i]
                if (!(d * d <= 16 && x[3, i] <= most)) exit 1 } }' || return 1
        grep -q '"verdict": "good"' "$work/log.json" || return 1
    done
}
check "verdict: a hand's tremor is in the noise of its rests" log 4 --tremor 0.003
# One step is 4 mg, the noise 0.3 mg: the mean of a rest is no better than about a quarter of a step.
LSB=0.04
check "verdict: and so are the steps of a coarse sensor" log 0.2 --lsb 0.04 --noise 0.0003
finish
