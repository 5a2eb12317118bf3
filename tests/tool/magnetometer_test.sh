#!/bin/sh
# SPDX-License-Identifier: MIT
#
# calibrate --magnetometer: logs of one that is waved, with a truth: magnetometer_test.sh path/to/invcal builddir
# With the recordings (RECORDINGS, or ../shared/data) also a real one, against fits of all of its samples.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Gauss, in 100 samples a second: the field 0.48 turned about two axes, hard iron 0.1 -0.3 0.05, y scaled by 1.1;
# noise of 0.5 % of the field. A magnet makes the field 1 + MAGNET times as long for 2 s; from STEP s on another 0.1
# of offset x; HALF: z > 0 only.
waved() { # MAGNET STEP HALF
    awk -v magnet="$1" -v step="$2" -v half="$3" 'BEGIN {
        srand(1); print "ax (g),ay (g),az (g),mx (G),my (G),mz (G)"
        for (i = 0; i < 6000; i++) {
            t = i / 100; a = 2 * t + sin(t); b = 0.73 * t
            x = sin(a) * cos(b); y = sin(a) * sin(b); z = cos(a)
            if (half && z < 0) z = -z
            f = 0.48 * (1 + (t > 40 && t < 42 ? magnet : 0))
            printf "0,0,1,%.5f,%.5f,%.5f\n", f * x + 0.1 + (t > step ? 0.1 : 0) + n(),
                f * 1.1 * y - 0.3 + n(), f * z + 0.05 + n()
        } }
        function n() { return 0.48 * 0.005 * (rand() + rand() + rand() + rand() - 2) * 1.732 }'
}
number() { sed -n "s/^ *\"$1\": \([^[].*[^,]\),*$/\1/p" "$work/stdout" | head -n 1; }
vector() { sed -n "s/^ *\"$1\": \[\(.*\)\],*$/\1/p" "$work/stdout" | head -n 1 | tr -d ' '; }

waved 0 99 0 > "$work/log.csv"
accepts "magnetometer: beside an accelerometer" calibrate --magnetometer "$work/log.csv" --json --out "$work/out/cal.json"
check "magnetometer: hard iron" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
check "magnetometer: the field, in the unit of the readings" near 0.01 "$(number gravity)" 0.495
check "magnetometer: and its shape" near 0.01 "$(vector dk)" -0.031,0.065,-0.031
check "magnetometer: good" matches "$work/stdout" '"verdict": "good"'
check "magnetometer: nothing disturbed it" matches "$work/stdout" '"disturbance": "none"'
accepts "magnetometer: the table" calibrate --magnetometer "$work/log.csv" --report "$work/out/page.html"
check "magnetometer: says what it found" matches "$work/stdout" '18 of 18 directions covered'
check "magnetometer: and what limits" matches "$work/stdout" 'limited by +what neighbouring samples err alike by'
run apply "$work/out/cal.json" "$work/log.csv"
check "magnetometer: apply takes its columns" succeeded
check "magnetometer: and makes all lengths alike" test "$(awk -F, 'NR > 1 { l = sqrt($1^2 + $2^2 + $3^2)
    bad += l < 0.47 || l > 0.52 } END { print NR, bad + 0 }' "$work/stdout")" = "6001 0"

accepts "magnetometer: a field that is known" calibrate --magnetometer "$work/log.csv" --gravity 48 --json
check "magnetometer: gives its unit" near 0.01 "$(number gravity)" 48
in=$work/log.csv
accepts "magnetometer: from the standard input" calibrate --magnetometer - --json
in=/dev/null

waved 1 99 0 > "$work/magnet.csv"
accepts "magnetometer: a magnet passes" calibrate --magnetometer "$work/magnet.csv" --json
check "magnetometer: that is named" matches "$work/stdout" '"disturbance": "passing"'
check "magnetometer: and does no harm" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
run calibrate --magnetometer "$work/magnet.csv"
check "magnetometer: also in words" matches "$work/stdout" 'Disturbed: samples contradict the others'
waved 0 35 0 > "$work/step.csv"
accepts "magnetometer: a step" calibrate --magnetometer "$work/step.csv"
check "magnetometer: that is named, too" matches "$work/stdout" 'Rough: readings changed at some time'
check "magnetometer: with what to do" matches "$work/stdout" 'Next: wave it again'
waved 0 99 1 > "$work/half.csv"
accepts "magnetometer: half a sphere" calibrate --magnetometer "$work/half.csv"
check "magnetometer: is weak" matches "$work/stdout" '^Weak: '

head -n 300 "$work/log.csv" > "$work/short.csv"
refuses "magnetometer: three seconds" 1 'short.csv: 299 samples, all in a few directions; wave it' \
    calibrate --magnetometer "$work/short.csv"
run calibrate --magnetometer "$work/short.csv" --json
check "magnetometer: as JSON, too" matches "$work/stdout" '"error": "too few"'
printf 'ax,ay,az\n0,0,1\n' > "$work/none.csv"
refuses "magnetometer: none there" 3 'none.csv:1: the header names no columns of a magnetometer' \
    calibrate --magnetometer "$work/none.csv"
printf 'x,y,z,mx,my,mz\n0,0,1,1,2,3\n' > "$work/twice.csv"
refuses "magnetometer: two sets that may be meant" 3 "x, y and z are there twice .'mx' and 'x'." \
    calibrate --magnetometer "$work/twice.csv"
for option in --positions --robust --six-faces --cubic '--thermal=1' '--noise=1' '--case=+z' '--prior=1,1,1'; do
    refuses "magnetometer: and $option" 2 "--magnetometer: does not go together with ${option%=*}" \
        calibrate --magnetometer "$work/log.csv" "$option"
done
refuses "magnetometer: watch" 2 '--magnetometer: is for invcal calibrate' watch --magnetometer "$work/log.csv"

recording=${RECORDINGS:-$here/../../../shared/data}/ck_acc_mag.csv
if [ -f "$recording" ]; then
    accepts "magnetometer: a real one" calibrate --magnetometer "$recording" --json
    sigma=$(sed -n '/"sigma"/,/}/s/.*"offset": \[\(.*\)\].*/\1/p' "$work/stdout")
    fits=$(sed -n '/reference_offsets/,/;/s/^ *{\([-0-9., ]*\)}.*/\1/p' "$here/../reference/magnetometer.h")
    check "magnetometer: is within sigma of three fits of all its samples" test "$(
        { echo "$(vector offset)"; echo "$sigma"; echo "$fits"; } | tr -d ' ' | awk -F, '
            NR == 1 { split($0, o) } NR == 2 { split($0, s) }
            NR > 2 { for (i = 1; i <= 3; i++) { e = ($i - o[i]) / s[i]; bad += e > 1 || e < -1; n++ } }
            END { print n, bad + 0 }')" = "9 0"
    check "magnetometer: and good" matches "$work/stdout" '"verdict": "good"'
fi
finish
