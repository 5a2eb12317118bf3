#!/bin/sh
# SPDX-License-Identifier: MIT
#
# calibrate --case: the axes of the case, against a known rotation: case_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Readings over g of a perfect sensor in a case: 18 edges, then each of three faces twice on a table that leans
# by LEAN degrees, with half a turn between them. R, case = R sensor: 90 degrees about z, then 3 about x.
positions() { # LEAN
    awk -v lean="$1" '
        function put(x, y, z) { # up in the case: the reading is R^T up
            n = sqrt(x * x + y * y + z * z); x /= n; y /= n; z /= n
            printf "%.15g,%.15g,%.15g\n", c * y + s * z, -x, -s * y + c * z
        }
        BEGIN {
            d = atan2(0, -1) / 180; c = cos(3 * d); s = sin(3 * d); t = lean * d
            print "x (g),y (g),z (g)"
            for (k = 1; k >= -1; k -= 2) {
                put(k * sin(t), 0, cos(t)); put(cos(t), k * sin(t), 0); put(0, cos(t), k * sin(t))
            }
            for (i = -1; i <= 1; i += 2) {
                put(i, 0, 0); put(0, i, 0); put(0, 0, i)
                for (j = -1; j <= 1; j += 2) { put(i, j, 0); put(i, 0, j); put(0, i, j) }
            }
        }'
}
# R above, row by row: Rx(3 degrees) Rz(90 degrees).
is_turned() { # TOLERANCE
    awk -v CONVFMT=%.17g -v tolerance="$1" '/"rotation"/ { on = 3; next } on { gsub(/[][ ]/, ""); split($0, m, ","); row = 4 - on--
        d = atan2(0, -1) / 180; c = cos(3 * d); s = sin(3 * d)
        split(row == 1 ? "0 -1 0" : row == 2 ? c " 0 " (-s) : s " 0 " c, r, " ")
        for (j = 1; j <= 3; j++) { e = m[j] - r[j]; bad += e > tolerance || e < -tolerance }
        rows++ } END { exit !(rows == 3 && !bad) }' "$work/stdout"
}
member() { sed -n "s/^ *\"$1\": \([^,]*\),*$/\1/p" "$work/stdout" | tail -n 1; }

positions 0 > "$work/straight.csv"
positions 0.5 > "$work/leaning.csv"
calibrate() { run calibrate "$@" --positions --gravity 1 --noise 0.0001 --unit g --json; }

calibrate "$work/straight.csv" --case +z,+x,+y
check "case: three faces" succeeded
check "case: the rotation is the true one" is_turned 1e-9
check "case: the frame says so" matches "$work/stdout" '"frame": "case"'
calibrate "$work/straight.csv" --case z,x
check "case: two faces, without signs" is_turned 1e-9
calibrate "$work/straight.csv" --case .,+x,.,.,+x,+y
check "case: a dot is an unknown position" is_turned 1e-9
calibrate "$work/leaning.csv" --case +z,+x,+y
check "case: a leaning table rotates it" test "$(is_turned 1e-3; echo $?)" -eq 1
calibrate "$work/leaning.csv" --case +z,+x,+y,+z,+x,+y
check "case: in pairs it cancels" is_turned 1e-9
check "case: and is reported: 0.5 degrees" near 1e-6 "$(member scatter)" 0.00872664626
calibrate "$work/straight.csv" --case +z
check "case: one face levels" succeeded
check "case: its sigma is unknown" matches "$work/stdout" '"sigma": \[null, null, null\]'
check "case: and so is its scatter" test "$(member scatter)" = null
calibrate "$work/leaning.csv" --case +z,.,.,+z
check "case: one face twice: the scatter is 2 sin 0.25 degrees" near 1e-7 "$(member scatter)" 0.00872661880
run calibrate "$work/straight.csv" --positions --gravity 1 --noise 0.0001 --unit g --case +z
check "case: and the heading is reported as open" matches "$work/stdout" 'the heading is unchanged'
run calibrate "$work/leaning.csv" --positions --gravity 1 --noise 0.0001 --unit g \
    --case +z,+x,+y,+z,+x,+y --report "$work/out/case.html"
check "case: the table shows the angles" matches "$work/stdout" 'about z \+89\.98'
check "case: and the page" matches "$work/out/case.html" 'rotated to the axes of the case by 6 positions'

run calibrate "$work/straight.csv" --positions --unit g --gravity 1 --out "$work/out/cal.json" --case +z,+x,+y
run apply "$work/out/cal.json" "$work/straight.csv"
check "case: corrected readings have its axes" near 1e-6 "$(sed -n 2p "$work/stdout" | cut -d, -f3)" 1

refuses "case: ways that do not fit" 1 'the stated axes do not fit' \
    calibrate "$work/straight.csv" --positions --unit g --gravity 1 --case +x,+x,-z
for list in +z,+z +x,.,.,.,.,+x; do # both 90 degrees apart
    refuses "case: one axis up in two directions, $list" 1 'the stated axis did not point up in all' \
        calibrate "$work/straight.csv" --positions --unit g --gravity 1 --case "$list"
done
refuses "case: the opposite axis" 1 'nearly opposite' \
    calibrate "$work/straight.csv" --positions --unit g --gravity 1 --case -z
refuses "case: a mirrored axis" 1 'in a right-handed frame' \
    calibrate "$work/straight.csv" --positions --unit g --gravity 1 --case +z,+x,-y
refuses "case: an empty list" 2 '--case: its value is empty' \
    calibrate "$work/straight.csv" --positions --case ''
for list in w +. '+z,' ',+z' . '+z,,x' x-y; do
    refuses "case: '$list'" 2 '--case: give the axis' calibrate "$work/straight.csv" --positions --case "$list"
done
refuses "case: over temperature, and what to do" 2 '--case: cannot be combined with --thermal: leave out --case, or' \
    calibrate "$work/straight.csv" --positions --case +z,+x --thermal 1
refuses "case: beside another frame" 2 'leave out --frame' \
    calibrate "$work/straight.csv" --positions --case +z --frame triangular

# The log of such a unit: x inverted, or x and y exchanged, while its axes are stated as they are.
awk -F, -v OFS=, 'NR > 1 { $1 = -$1 } 1' "$work/straight.csv" > "$work/inverted.csv"
awk -F, -v OFS=, 'NR > 1 { t = $1; $1 = $2; $2 = t } 1' "$work/straight.csv" > "$work/exchanged.csv"
for how in inverted exchanged; do
    refuses "case: an axis $how in the log is suspected" 1 'or an axis of the log is inverted or exchanged' \
        calibrate "$work/$how.csv" --positions --unit g --gravity 1 --case +z,+x,+y
done
finish
