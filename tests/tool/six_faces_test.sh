#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Six faces, which determine no angles: six_faces_test.sh path/to/invcal builddir. The simulated sensor has
# offsets 0.02 -0.015 0.03 g, scale errors 0.01 -0.008 0.012, angles 0.01 -0.006 0.008 rad.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

lsb=0.000598550415 # 9.80665 / 16384
sheet="--zero 0,0,0 --lsb $lsb"
log=$work/faces.csv
"$tool" simulate --plan faces > "$log"

set_of() { # rows of directions: the log of a sensor that is held so
    printf '%s\n' "$@" > "$work/set.csv"
    "$tool" simulate --plan "directions:$work/set.csv" --seed 2
}
faces='1,0,0 0,1,0 0,0,1 -1,0,0 0,-1,0 0,0,-1'
member() { sed -n "s/^ *\"$1\": \(.*[^,]\),*\$/\1/p" "$work/stdout"; }
sigma_of() { # KIND
    sed -n "/^  \"sigma\"/,/^  }/s/^ *\"$1\": \(.*\]\),*\$/\1/p" "$work/stdout"
}

# ---- without the option --------------------------------------------------------------------------

refuses "six faces: without the option too few, with advice" 1 \
    '6 positions are too few: 9 .*--six-faces takes the angles.*Six more determine everything: \+x up' \
    calibrate "$log"
# shellcheck disable=SC2086 # words
set_of $faces $faces > "$work/twice.csv"
refuses "six faces: visited twice they determine no more, and the advice is the same" 1 \
    'undetermined: angle xy, angle xz, angle zy; .*--six-faces takes the angles' calibrate "$work/twice.csv"
# shellcheck disable=SC2086
set_of 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0.6,0.8 > "$work/no_faces.csv"
run calibrate "$work/no_faces.csv"
check "six faces: six others are refused" test "$code" -eq 1
check "six faces: and the option is not suggested" lacks "$work/stderr" 'six-faces'

# ---- with it -------------------------------------------------------------------------------------

# shellcheck disable=SC2086
accepts "six faces: with the option" calibrate "$log" --six-faces $sheet --json --out "$work/cal.json"
check "six faces: offsets are the sensor's" near 3e-4 '0.02 -0.015 0.03' "$(json "$work/stdout" delta)"
check "six faces: scales are, too" near 3e-4 '0.01 -0.008 0.012' "$(json "$work/stdout" dk)"
check "six faces: angles are 0" near 1e-9 '0 0 0' "$(json "$work/stdout" gamma)"
check "six faces: with the sigma of the data sheet" near 2e-5 '0.01 0.01 0.01' "$(sigma_of gamma)"
noise=$(member noise | awk '{ print $1 / 9.80665 / sqrt(2) }')
check "six faces: sigma of an offset is the noise over the root of 2" \
    near 2e-6 "$noise $noise $noise" "$(sigma_of delta)"
check "six faces: the verdict is about offsets and scales, which nothing checks" \
    test "$(member verdict)" = '"no redundancy"'
check "six faces: none of them is undetermined" test "$(member undetermined)" = '[]'
check "six faces: the angles come from the prior" test "$(grep -c '"gamma_..": "prior"' "$work/stdout")" -eq 3
check "six faces: the others from the data" test "$(grep -c '": "data"' "$work/stdout")" -eq 6
check "six faces: what is not measured is named" \
    test "$(member not_measured)" = '["gamma_xy", "gamma_xz", "gamma_zy"]'
check "six faces: the stated sigma" near 1e-12 0.01 "$(member angle_sigma)"
# 1.96 sigma over the roots of 5 and of 3, of gravity
check "six faces: that costs 8.8 mg over all directions" near 1e-4 0.085957 "$(member length95)"
check "six faces: 11.3 mg on a corner" near 2e-4 0.110970 "$(member length95_most)"
# the field anywhere on Earth and the angles; the rest is nearly zero
check "six faces: no Student's t widens it" near 2e-3 \
    "$(awk 'BEGIN { print sqrt(0.085957 ^ 2 + (1.96 * 0.0265) ^ 2) }')" "$(member accuracy95)"
"$tool" apply "$work/cal.json" "$log" > "$work/applied" 2> /dev/null
check "six faces: the calibration can be applied" test "$(wc -l < "$work/applied")" -gt 3000

accepts "six faces: in words" calibrate "$log" --six-faces
tr '\n' ' ' < "$work/stdout" > "$work/words"
check "six faces: the verdict says what is not measured, and what that costs" matches "$work/words" \
    'Good for offsets and scales; angles not measured: taken as 0 ±0\.57 degrees .*±8\.8 mg in lengths .*±11 mg at worst'
check "six faces: and that nothing checks the rest" matches "$work/words" 'No redundant position checks'
check "six faces: what to do next" matches "$work/words" 'Next: to measure the angles, add six positions'
check "six faces: each angle is marked in the table" \
    test "$(grep -c '^angle .* ± 0\.57 .*not measured$' "$work/stdout")" -eq 3
accepts "six faces: in navigation units" calibrate "$log" --six-faces --units ins
check "six faces: the angle in arcsec, too" matches "$work/stdout" '^angle xy .* 2063 .*arcsec, not measured'

run calibrate "$log" --six-faces --report "$work/page.html"
check "six faces: a page" is_page "$work/page.html"
check "six faces: with the verdict" matches "$work/page.html" 'Good for offsets and scales'
check "six faces: and three rows that say so" test "$(grep -c '>not measured<' "$work/page.html")" -eq 3
accepts "six faces: invcal watch has it, too" watch "$log" --six-faces --quiet

# ---- more than six -------------------------------------------------------------------------------

run calibrate "$work/twice.csv" --six-faces
check "six faces: visited twice they check each other" matches "$work/stdout" '^Good for offsets and scales'
check "six faces: and the verdict does not say otherwise" lacks "$work/stdout" 'No redundant position'
run calibrate "$work/twice.csv" --six-faces --json
check "six faces: in JSON that is good" test "$(member verdict)" = '"good"'
run calibrate "$work/twice.csv" --six-faces --need 0.2
check "six faces: good for 20 mg" matches "$work/stdout" '^PASS: \|a\| within 0\.[0-9]+ of 0\.20 m/s²'
run calibrate "$work/twice.csv" --six-faces --latitude 50 --need 0.05
tr '\n' ' ' < "$work/stdout" > "$work/words"
check "six faces: for 5 mg directions are missing, not longer rests" matches "$work/words" \
    'FAIL: .a. within 0\.[0-9]+ of 0\.050 .* Missing: positions in directions'
# The six that are named: +x up and tilted to +y, -y, +z, -z; +z up and tilted to +y, -y.
# shellcheck disable=SC2086
set_of $faces 1,1,0 1,-1,0 1,0,1 1,0,-1 0,1,1 0,-1,1 > "$work/twelve.csv"
# shellcheck disable=SC2086
run calibrate "$work/twelve.csv" $sheet --json
check "six faces: with the six that are named everything is determined" test "$(member verdict)" = '"good"'
check "six faces: the angles, too" near 6e-4 '0.01 -0.006 0.008' "$(json "$work/stdout" gamma)"
run calibrate "$work/twelve.csv" --six-faces --json
check "six faces: then the option holds nothing" test "$(member not_measured)" = '[]'
run calibrate "$work/twelve.csv" --six-faces
check "six faces: and the verdict is the usual one" matches "$work/stdout" '^Good: every parameter'

# ---- tables of six means -------------------------------------------------------------------------

printf '%s\n' 10.1,0.1,0 -9.7,0.1,0.1 0.2,9.9,0 0.2,-9.6,0 0.2,0.1,9.8 0.2,0.1,-9.9 > "$work/means.csv"
refuses "six faces: a table without noise" 2 '--six-faces: needs the noise.*--noise' \
    calibrate "$work/means.csv" --positions --six-faces
accepts "six faces: a table, the noise stated" calibrate "$work/means.csv" --positions --six-faces \
    --noise 0.01
check "six faces: offsets are the midpoint of each pair" matches "$work/stdout" '^offset x +0\.(199|200)'
sed 's/$/,0.02,100/' "$work/means.csv" > "$work/std.csv"
accepts "six faces: a table with std and n" calibrate "$work/std.csv" --positions --six-faces

# ---- what else is known of the angles ------------------------------------------------------------

run calibrate "$log" --six-faces --prior 0,0,0.02 --json
check "six faces: another data sheet" near 2e-4 0.171914 "$(member length95)"
"$tool" simulate --plan edges --seed 3 > "$work/edges.csv"
"$tool" calibrate "$work/edges.csv" --out "$work/before.json" --quiet
# The first row off the diagonal, about 3e-6 and 2e-6.
beside_diagonal() { sed -n '/^  "matrix"/{n;s/^ *\[[^,]*, \(.*\)\],$/\1/p;q;}' "$1" | tr ',' ' '; }
run calibrate "$log" --six-faces --nominal "$work/before.json" --json
check "six faces: the angles of an earlier calibration stay as they were" near 1e-9 \
    "$(beside_diagonal "$work/before.json")" "$(beside_diagonal "$work/stdout")"
run calibrate "$log" --six-faces --nominal "$work/before.json"
check "six faces: and it says so" matches "$work/stdout" 'in the earlier calibration, ±0\.57'

# ---- refusals --------------------------------------------------------------------------------------

set_of 0,0,1 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 > "$work/z_up.csv"
# shellcheck disable=SC2086
refuses "six faces: what is none leaves offsets and scales open, no angles" 1 \
    'undetermined: (offset z, scale z|offset z|scale z); add positions with the field along \+z and -z$' \
    calibrate "$work/z_up.csv" --six-faces $sheet
accepts "six faces: what hardly is one is used" calibrate "$work/no_faces.csv" --six-faces
check "six faces: and reported as weak" matches "$work/stdout" '^Weak: offset z, scale z are poorly'
head -n 5 "$work/means.csv" > "$work/five.csv"
refuses "six faces: five are too few" 1 '5 positions are too few: 6 are needed' \
    calibrate "$work/five.csv" --positions --six-faces --noise 0.01
refuses "six faces: a prior on offsets has no place" 2 '--prior: with --six-faces' \
    calibrate "$log" --six-faces --prior 0.1,0,0.01
refuses "six faces: nor an angle of anything" 2 '--prior: with --six-faces' \
    calibrate "$log" --six-faces --prior 0,0,0
for o in --robust --quadratic --cubic '--thermal=1'; do
    refuses "six faces: not together with ${o%=*}" 2 "--six-faces: cannot be combined with ${o%=*}" \
        calibrate "$log" --six-faces "$o"
done

finish
