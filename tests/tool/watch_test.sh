#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of following a program with `watch --plan`, with logs in which positions are exchanged, left out,
# repeated or elsewhere: watch_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# The positions of a set, a line x y z each.
"$tool" plan > "$work/table"
awk '$2 ~ /^[123]$/ && NF == 7 { print $5, $6, $7 }' "$work/table" > "$work/all"
check "the program has 18" test "$(wc -l < "$work/all")" -eq 18

# Follows SET with a log of the positions of a file, and of simulate's OPTIONS.
follow() { # follow SET FILE OPTIONS
    set=$1
    { echo x y z; cat "$2"; } > "$work/visited"
    shift 2
    "$tool" simulate --plan directions:"$work/visited" --dwell 3 --move 1 "$@" > "$work/log.csv"
    in=$work/log.csv
    run watch - --plan "$set"
    in=/dev/null
}
line() { sed -n "$1" "$work/stdout"; }
asked() { sed -n 's/^next: position \([0-9]*\) of .*/\1/p' "$work/stdout" | tr '\n' ' '; }

# ---- as instructed -----------------------------------------------------------------------------

follow per-group:6 "$work/all"
check "each position is asked for in turn" test "$(asked)" = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 "
check "the first with its angles and no turn" test "$(line 2p)" = \
    'next: position 1 of 18: alpha 30, beta 0°; +y up, tilt 30 deg, +z rises'
check "the next with the turn to it" matches "$work/stdout" \
    '^next: position 2 of 18: alpha 90, beta 0°; turn alpha \+60°; \+z up$'
check "both axes turn, each the shorter way" matches "$work/stdout" \
    '^next: position 13 of 18: alpha 120, beta 90°; turn alpha -150, beta \+120°; '
check "when a position is good, the angles of the next" test "$(line 3p)" = 'good: move on to alpha 90, beta 0°'
check "nothing is wrong" lacks "$work/stdout" 'wrong'
check "it is finished" matches "$work/stdout" '^finished: the program is complete'
check "the angles are those of plan" test "$(sed -n 's/^next: position .*: alpha \([-0-9]*\), beta \([-0-9]*\)°; .*/\1 \2/p' "$work/stdout")" = \
    "$(awk '$2 ~ /^[123]$/ && NF == 7 { print $3, $4 }' "$work/table")"

# ---- start angles and other sets ---------------------------------------------------------------

for set in per-group:5:10,20,30 per-group:8 edges icosahedron optimal:14 per-group:8:-45,0,0; do
    "$tool" simulate --plan "$set" --dwell 3 --move 1 > "$work/log.csv"
    in=$work/log.csv
    run watch - --plan "$set"
    in=/dev/null
    check "$set: it is followed to its end" matches "$work/stdout" '^finished: the program is complete'
    check "$set: nothing is wrong" lacks "$work/stdout" 'wrong'
done
check "start angles: simulate accepts them" "$tool" simulate --plan per-group:5:10,20,30 --dwell 3 \
    --move 1 --seed 2 > /dev/null
"$tool" simulate --plan per-group:5:10,20,30 --dwell 3 --move 1 > "$work/log.csv"
in=$work/log.csv
run watch - --plan per-group:5:10,20,30
check "start angles: group 1" matches "$work/stdout" '^next: position 2 of 15: alpha 82, beta 0°; turn alpha \+72°; '
check "start angles: group 2" matches "$work/stdout" '^next: position 6 of 15: alpha -90, beta 20°; '
check "start angles: group 3" matches "$work/stdout" '^next: position 11 of 15: alpha 30, beta 90°; '
in=/dev/null

# ---- wrong positions ---------------------------------------------------------------------------

awk 'NR == 4 { held = $0; next } { print } NR == 5 { print held }' "$work/all" > "$work/exchanged"
follow per-group:6 "$work/exchanged"
check "exchanged: the position that was taken is named" matches "$work/stdout" \
    '^wrong position: that is position 5 \(alpha -90, beta 0°\), not 4\. It is used anyway$'
check "exchanged: it is reported while the device is still there" matches "$work/stdout" \
    '^good, but not position 4: move on to alpha -150, beta 0°$'
check "exchanged: the way back" matches "$work/stdout" \
    '^next: position 4 of 18: alpha -150, beta 0°; turn alpha -60°; '
check "exchanged: what has been taken is not asked for again" test "$(asked)" = \
    "1 2 3 4 4 6 7 8 9 10 11 12 13 14 15 16 17 18 "
check "exchanged: one is wrong" test "$(grep -c '^wrong position' "$work/stdout")" -eq 1
check "exchanged: it is finished anyway" matches "$work/stdout" '^finished'
check "exchanged: that does not suggest exchanged axes" lacks "$work/stdout" 'in a row'

sed 7d "$work/all" > "$work/left_out"
follow per-group:6 "$work/left_out"
check "left out: what is missing is reported at the end" matches "$work/stdout" '^positions of the program not visited: 7$'
check "left out: it is not finished" lacks "$work/stdout" '^finished'

head -n 3 "$work/all" > "$work/three"
follow per-group:36 "$work/three"
check "left out: a list that is too long ends with dots" matches "$work/stdout" \
    '^positions of the program not visited: ([0-9]+, )+[0-9]+, \.\.\.$'

awk '{ print } NR == 9 { print before } { before = $0 }' "$work/all" > "$work/repeated"
follow per-group:6 "$work/repeated"
check "repeated: it is named" matches "$work/stdout" \
    '^wrong position: that is position 8 \(alpha -90, beta 90°\), not 10\.'
check "repeated: it is finished" matches "$work/stdout" '^finished'

awk 'NR == 3 { print 0.577, -0.577, 0.577 } { print }' "$work/all" > "$work/elsewhere"
follow per-group:6 "$work/elsewhere"
check "elsewhere: while the zero is unknown, it is taken for the expected one" test \
    "$(grep -c '^wrong position' "$work/stdout")" -le 1
in=$work/log.csv
run watch - --plan per-group:6 --zero 0,0,0
in=/dev/null
check "elsewhere: with a stated zero its angles are reported" matches "$work/stdout" \
    '^wrong position: that is alpha 12[0-9.]+, beta [34][0-9.]+°, not a position of the program; go to 3\.'
check "elsewhere: and the turn from there" matches "$work/stdout" \
    '^next: position 3 of 18: alpha 150, beta 0°; turn alpha \+2[0-9.]+, beta -[34][0-9.]+°; '

# alpha and beta exchanged: eta(beta, alpha); the sense of alpha reversed: the sine changes sign.
angles() { # angles EXPRESSION_OF_X Y Z in a and b, radians
    awk "\$2 ~ /^[123]\$/ && NF == 7 { a = \$3 / 57.295779513; b = \$4 / 57.295779513
        printf \"%.9f %.9f %.9f\\n\", $1, $2, $3 }" "$work/table"
}
angles 'sin(b) * sin(a)' 'cos(b)' 'sin(b) * cos(a)' > "$work/swapped"
follow per-group:6 "$work/swapped"
check "alpha and beta exchanged: it is suggested" matches "$work/stdout" \
    '^2 wrong in a row: check for alpha and beta exchanged'
angles 'sin(-a) * sin(b)' 'cos(a)' 'sin(-a) * cos(b)' > "$work/reversed"
follow per-group:6 "$work/reversed"
check "alpha reversed: the first is position 6" matches "$work/stdout" \
    '^wrong position: that is position 6 \(alpha -30, beta 0°\), not 1\.'
check "alpha reversed: it is suggested" matches "$work/stdout" 'a reversed sense'

# ---- sensors that are far from nominal ---------------------------------------------------------

follow per-group:6 "$work/all" --zero 33000,32800,32500
check "counts without sign: each position is known in the end" matches "$work/stdout" '^finished'
check "counts without sign: nothing is called wrong" lacks "$work/stdout" '^wrong'
follow per-group:6 "$work/all" --offset 0.1,-0.1,0.1 --dk 0.05,-0.05,0.05
check "offsets of 100 mg: nothing is called wrong" lacks "$work/stdout" '^wrong'
"$tool" simulate --plan per-group:36 --dwell 3 --move 1 --offset 0.03,-0.02,0.03 > "$work/log.csv"
in=$work/log.csv
run watch - --plan per-group:36
in=/dev/null
check "steps of 10 degrees: nothing is called wrong" lacks "$work/stdout" '^wrong'
check "steps of 10 degrees: it is finished" matches "$work/stdout" '^finished'

# ---- with a prior ------------------------------------------------------------------------------

"$tool" simulate --plan faces --dwell 3 --move 1 > "$work/log.csv"
in=$work/log.csv
run watch - --plan faces --zero 0,0,0 --lsb 0.000598550415 --noise 0.001 --prior 0.05,0.03,0.02
in=/dev/null
check "faces with a prior for the angles" matches "$work/stdout" '^finished'

# ---- turns for a gyroscope ----------------------------------------------------------------------

# The turns that `plan --moves` finds before anything is measured.
"$tool" plan --moves greedy8 --json > "$work/plan.json"
{ echo x y z; echo 0 0 1; sed -n 's/^      "up": \[\(.*\)\],$/\1/p' "$work/plan.json" | tr -d ,; } > "$work/greedy"
sed -n 's/^      "words": "\(.*\)",$/\1/p' "$work/plan.json" > "$work/turns"
"$tool" simulate --gyro --gyro-range 2000 --plan directions:"$work/greedy" --dwell 3 > "$work/log.csv"
run watch "$work/log.csv" --zero 0,0,0
check "turns: eight are planned" test "$(wc -l < "$work/turns")" -eq 8
check "turns: they are asked for as planned" test "$(sed -n 's/^next: //p' "$work/stdout" | sed '1d;10,$d')" = "$(cat "$work/turns")"
check "turns: also while the device is still there" test \
    "$(sed -n 's/^good: move on to //p' "$work/stdout" | head -n 8)" = "$(cat "$work/turns")"
check "turns: how many count" matches "$work/stdout" '^gyroscope: 8 of 8 moves; scale ± 0\.0'
check "turns: all of them" lacks "$work/stdout" 'move from .* refused'
run watch "$work/log.csv" --accelerometer-only
check "--accelerometer-only: directions, no turns" lacks "$work/stdout" ' about [xyz]$'
in=$work/log.csv
run watch - --plan edges
in=/dev/null
check "--plan: its positions, no turns" lacks "$work/stdout" ' about [xyz]$'

"$tool" simulate --gyro --plan edges --dwell 3 | awk -F, -v OFS=, '
    NR > 1 { for (i = 5; i <= 7; i++) $i = $i > 9000 ? 9000 : $i < -9000 ? -9000 : $i } { print }' > "$work/log.csv"
run watch "$work/log.csv"
check "turns: the move that was clipped is named" matches "$work/stdout" \
    "^gyroscope: the move from position 1 to 2 is refused: at the end of the range$"
check "turns: once" test "$(grep -c 'from position 1 to 2 is refused' "$work/stdout")" -eq 1
check "turns: the others count" matches "$work/stdout" '^gyroscope: 1[0-6] of 17 moves; '

finish
