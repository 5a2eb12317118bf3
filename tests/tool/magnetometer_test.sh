#!/bin/sh
# SPDX-License-Identifier: MIT
#
# calibrate --magnetometer: logs of a waved magnetometer with a known truth: magnetometer_test.sh path/to/invcal builddir
# With the recordings (RECORDINGS, or ../shared/data) also a real one, against fits to all of its samples.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Gauss, 100 samples a second: a field of 0.48 turned about two axes, hard iron 0.1 -0.3 0.05, y scaled by 1.1;
# noise of 0.5 % of the field. A magnet makes the field 1 + MAGNET times as large for 2 s; from STEP s on, offset x is
# 0.1 more; HALF: z > 0 only.
waved() { # MAGNET STEP HALF
    awk -v magnet="$1" -v step="$2" -v half="$3" "$random_awk"'BEGIN {
        begin_random(1); print "ax (g),ay (g),az (g),mx (G),my (G),mz (G)"
        for (i = 0; i < 6000; i++) {
            t = i / 100; a = 2 * t + sin(t); b = 0.73 * t
            x = sin(a) * cos(b); y = sin(a) * sin(b); z = cos(a)
            if (half && z < 0) z = -z
            f = 0.48 * (1 + (t > 40 && t < 42 ? magnet : 0))
            printf "0,0,1,%.5f,%.5f,%.5f\n", f * x + 0.1 + (t > step ? 0.1 : 0) + n(),
                f * 1.1 * y - 0.3 + n(), f * z + 0.05 + n()
        } }
        function n() { return 0.48 * 0.005 * (uniform() + uniform() + uniform() + uniform() - 2) * 1.732 }'
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
check "magnetometer: reports the directions" matches "$work/stdout" '18 of 18 directions covered'
check "magnetometer: the page states how much samples differ" matches "$work/out/page.html" 'differ by 0\.4[0-9]+ % rms after calibration'
check "magnetometer: by how much samples differ" matches "$work/stdout" '^ +of samples +0\.4[0-9]+ % of the field rms$'
check "magnetometer: and what limits the accuracy" matches "$work/stdout" 'limited by +errors that neighbouring samples share'
run apply "$work/out/cal.json" "$work/log.csv"
check "magnetometer: apply takes its columns" succeeded
check "magnetometer: and makes all lengths alike" test "$(awk -F, 'NR > 1 { l = sqrt($1^2 + $2^2 + $3^2)
    bad += l < 0.47 || l > 0.52 } END { print NR, bad + 0 }' "$work/stdout")" = "6001 0"

accepts "magnetometer: a field that is known" calibrate --magnetometer "$work/log.csv" --gravity 48 --json
check "magnetometer: determines its unit" near 0.01 "$(number gravity)" 48
run calibrate --magnetometer "$work/log.csv"
check "magnetometer: in gauss, not in g" matches "$work/stdout" 'my mz in gauss;.*'
check "magnetometer: the field, too" matches "$work/stdout" 'field 0\.49[0-9]* gauss'
for heading in 'mag_x_uT,mag_y_uT,mag_z_uT' 'mx (µT),my (µT),mz (µT)'; do
    { echo "$heading"; sed 1d "$work/log.csv" | awk -F, '{ print 100 * $4 "," 100 * $5 "," 100 * $6 }'; } > "$work/ut.csv"
    run calibrate --magnetometer "$work/ut.csv"
    check "magnetometer: $heading" matches "$work/stdout" 'field 49\.[0-9]* µT'
done
run calibrate --magnetometer "$work/ut.csv" --gravity 48 --need 4
check "magnetometer: a stated field has the unit of the column" matches "$work/stdout" 'field 48 µT$'
check "magnetometer: the scale, too" matches "$work/stdout" '^scale x .* µT per µT$'
check "magnetometer: and the need" matches "$work/stdout" 'PASS: length within [0-9.]+ of 4\.0 µT'
run calibrate --magnetometer "$work/ut.csv" --gravity 0.48
check "magnetometer: unless it is far from the readings" matches "$work/stdout" 'field 0\.48 field units$'
for stated in '48.0 uT' 48.0µT '48.0+-0.5uT' '48.0±0.5µT'; do
    run calibrate --magnetometer "$work/log.csv" --gravity "$stated" # of columns in gauss
    check "magnetometer: a field of $stated" matches "$work/stdout" 'field 48 µT$'
    check "magnetometer: $stated: scales" matches "$work/stdout" '^scale x .* gauss per µT$'
    check "magnetometer: $stated: noise" matches "$work/stdout" '^noise  .* µT of one position mean'
done
check "magnetometer: its uncertainty" matches "$work/stdout" '^of the field +1 %, included in the ± of all three scales'
run calibrate --magnetometer "$work/log.csv" --gravity 0.48G
check "magnetometer: G is gauss, not g" matches "$work/stdout" 'field 0\.48 gauss$'
for stated in 48.5parsec uT 48.5counts; do
    refuses "magnetometer: a field of $stated" 2 'is not a decimal number' calibrate --magnetometer "$work/log.csv" --gravity "$stated"
done
refuses "a field in a magnetometer's unit, of something else" 2 'is not a decimal number' calibrate "$work/log.csv" --gravity 48.5uT
{ echo 'mx,my,mz'; echo 'uT,uT,uT'; sed 1,2d "$work/ut.csv"; } > "$work/row.csv"
run calibrate --magnetometer "$work/row.csv" --json
check "magnetometer: units in a row of their own" matches "$work/stdout" '"unit": "uT"'
run calibrate --magnetometer "$work/log.csv" --gravity 1 --out "$work/out/one.json"
refuses "magnetometer: a field of 1 does not mean g" 2 'px4 is for accelerometers' export "$work/out/one.json" --format px4
accepts "magnetometer: as a constant" export "$work/out/one.json" --format c
in=$work/log.csv
accepts "magnetometer: from the standard input" calibrate --magnetometer - --json
in=/dev/null

waved 1 99 0 > "$work/magnet.csv"
accepts "magnetometer: a magnet passes" calibrate --magnetometer "$work/magnet.csv" --json
check "magnetometer: that is named" matches "$work/stdout" '"disturbance": "passing"'
check "magnetometer: and causes no error" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
run calibrate --magnetometer "$work/magnet.csv"
check "magnetometer: also in words" matches "$work/stdout" 'Disturbed: samples contradict the others'
# One sample that is not from the sensor, in the first seconds: the overflow of an HMC5883L in uT, and a bus without answer.
for wild in 2:4:3276.7 20:5:-4096 40:6:-4096 300:5:150 300:4:-300; do
    awk -F, -v OFS=, -v wild="$wild" 'BEGIN { split(wild, w, ":") } NR == w[1] { $w[2] = w[3] } { print }' \
        "$work/log.csv" > "$work/wild.csv"
    accepts "magnetometer: a wild sample in line $wild" calibrate --magnetometer "$work/wild.csv" --json
    check "magnetometer: $wild: good all the same" matches "$work/stdout" '"verdict": "good"'
    check "magnetometer: $wild: hard iron" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
done
awk -F, -v OFS=, 'NR > 1 && NR < 1500 { $5 += 1.5 * exp(-((NR - 502) / 100) ^ 2) } { print }' "$work/log.csv" > "$work/early.csv"
accepts "magnetometer: a strong magnet in the first seconds" calibrate --magnetometer "$work/early.csv" --json
check "magnetometer: causes no error either" near 0.004 "$(vector offset)" 0.1,-0.3,0.05
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
awk -F, -v OFS=, 'NR > 1 { $5 = 0.125 } { print }' "$work/log.csv" > "$work/dead.csv"
refuses "magnetometer: an axis that is dead" 1 'in a few directions: y never changes; check its column and the sensor; wave it' \
    calibrate --magnetometer "$work/dead.csv"
sed 1d "$work/log.csv" > "$work/nohead.csv"
refuses "magnetometer: six columns without a header" 3 "which are the magnetometer's. state them by number, such as --columns 4,5,6, or" \
    calibrate --magnetometer "$work/nohead.csv"
awk '{ print NR / 100 "," $0 }' "$work/nohead.csv" > "$work/timed.csv"
refuses "magnetometer: seven columns without a header" 3 'such as --columns 5,6,7,t=1, or' \
    calibrate --magnetometer "$work/timed.csv"
run calibrate --magnetometer "$work/timed.csv" --columns 5,6,7,t=1 --json
check "magnetometer: which are stated then" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
cut -d, -f4-6 "$work/nohead.csv" > "$work/three.csv"
run calibrate --magnetometer "$work/three.csv" --json
check "magnetometer: three can be no others" near 0.002 "$(vector offset)" 0.1,-0.3,0.05
run calibrate --magnetometer "$work/log.csv" --out "$work/out/gauss.json"
run calibrate --magnetometer "$work/ut.csv" --out "$work/out/ut.json"
refuses "magnetometer: compared in two units" 1 'readings are in uT and gauss; .* or state it in the heading, as mx .uT.$' \
    compare "$work/out/gauss.json" "$work/out/ut.json"
printf 'x,y,z,mx,my,mz\n0,0,1,1,2,3\n' > "$work/twice.csv"
refuses "magnetometer: two possible sets of columns" 3 "x, y and z are there twice .'mx' and 'x'." \
    calibrate --magnetometer "$work/twice.csv"
for option in --positions --robust --six-faces --cubic '--thermal=1' '--noise=1' '--case=+z' '--prior=1,1,1' '--sensor=mpu6050'; do
    refuses "magnetometer: and $option" 2 "--magnetometer: cannot be combined with ${option%=*}" \
        calibrate --magnetometer "$work/log.csv" "$option"
done
refuses "magnetometer: watch needs no noise" 2 '--magnetometer: cannot be combined with --mean-sigma' \
    watch --magnetometer "$work/log.csv" --mean-sigma 1

# Without the option the tool looks for rests, and a waved magnetometer has none.
"$tool" simulate --magnetometer > "$work/named.csv"
cut -d, -f5-7 "$work/named.csv" | sed 1d > "$work/unnamed.csv"
advice='; for a magnetometer in motion: --magnetometer$'
refuses "magnetometer: without --magnetometer it is named" 1 "no rest of two seconds.*$advice" \
    calibrate "$work/named.csv" --columns mx,my,mz
refuses "magnetometer: also without a header" 1 "no rest of two seconds.*$advice" calibrate "$work/unnamed.csv"
run calibrate "$work/named.csv" --columns mx,my,mz --positions
check "magnetometer: and if samples are said to be positions" matches "$work/stderr" "looks like a raw log.*$advice"
run calibrate "$work/named.csv"
check "magnetometer: no such advice for an accelerometer in motion" lacks "$work/stderr" '--magnetometer'
run calibrate "$work/named.csv" --columns ax,ay,az --positions
check "magnetometer: nor if its samples are said to be positions" lacks "$work/stderr" '--magnetometer'
"$tool" simulate --plan faces | sed 1s/.*/t,u,v,w/ > "$work/rests.csv"
run calibrate "$work/rests.csv" --columns u,v,w
check "magnetometer: nor for a sensor that was held still six times" lacks "$work/stderr" '--magnetometer'

run calibrate --magnetometer "$work/named.csv"
check "magnetometer: the field points down" matches "$work/stdout" 'points down by'
awk -F, -v OFS=, 'NR > 1 { x = $5; $5 = $6; $6 = x } { print }' "$work/named.csv" > "$work/swapped.csv"
run calibrate --magnetometer "$work/swapped.csv"
tr -s '\n ' '  ' < "$work/stdout" > "$work/flat"
check "magnetometer: two axes exchanged: it points up" matches "$work/flat" 'points up by .* wrong sign, or two are exchanged'

# ---- live ---------------------------------------------------------------------------------------

run calibrate --magnetometer "$work/log.csv" --json
found=$(vector offset)
accepts "magnetometer: live" watch --magnetometer "$work/log.csv"
check "magnetometer: what to do" matches "$work/stdout" '^turn it slowly until every side'
check "magnetometer: where to turn" matches "$work/stdout" '^next: hold it [-+][xyz] up.*, and swing it around$'
check "magnetometer: its progress" matches "$work/stdout" '^18 of 18 directions; 95 %: offsets ± 0'
check "magnetometer: when it is enough, once" test "$(grep -c '^enough: it is good' "$work/stdout")" -eq 1
check "magnetometer: and the result" matches "$work/stdout" '^Good: '
in=$work/log.csv
run watch --magnetometer - --json
in=/dev/null
check "magnetometer: which is that of calibrate" test "$(vector offset)" = "$found"
check "magnetometer: with JSON the guidance is on stderr" matches "$work/stderr" '^next: hold it'
waved 1 99 0 > "$work/magnet.csv"
run watch --magnetometer "$work/magnet.csv"
check "magnetometer: a magnet is named at once" matches "$work/stdout" '^disturbed: samples contradict the others'
run watch --magnetometer "$work/log.csv" --need 0.0001%
check "magnetometer: no end before the need is met" lacks "$work/stdout" '^enough'
run watch --magnetometer "$work/log.csv" --need 0.01
check "magnetometer: in the unit of the readings" matches "$work/stdout" '^enough: the target is reached'
run watch --magnetometer "$work/log.csv" --target 0.00001,0,0
check "magnetometer: nor before the target is" lacks "$work/stdout" '^enough'
head -n 500 "$work/log.csv" | sed '200s/,/;;/' > "$work/torn.csv"
run watch --magnetometer "$work/torn.csv" --frame accelerometer
check "magnetometer: a torn line is skipped" matches "$work/stderr" 'torn.csv:200'

# An accelerometer and a magnetometer, whose axes are those of the accelerometer turned by 90 degrees about z and then by 3
# about x; the field points down by 60 degrees; the accelerometer has an offset of OFFSET g. The hand accelerates by 0.03 g for
# half a second each.
both() { # OFFSET SEED
    awk -v offset="$1" -v seed="$2" "$random_awk"'BEGIN {
        begin_random(seed); print "t,ax,ay,az,mx,my,mz"; r = 3.14159265358979 / 180
        for (i = 0; i < 6000; i++) {
            t = i / 100; a = 2 * t + sin(t); b = 0.73 * t; c = 0.31 * t + cos(0.4 * t)
            # rows of the rotation from the world to the case: about z by c, y by b, x by a
            cx = cos(c); sx = sin(c); cy = cos(b); sy = sin(b); cz = cos(a); sz = sin(a)
            x[1] = cx * cy; x[2] = sx * cy; x[3] = -sy
            y[1] = cx * sy * sz - sx * cz; y[2] = sx * sy * sz + cx * cz; y[3] = cy * sz
            z[1] = cx * sy * cz + sx * sz; z[2] = sx * sy * cz - cx * sz; z[3] = cy * cz
            for (k = 1; k <= 3; k++) h[k] = 0.98 * h[k] + 0.2 * 0.03 * n()
            n1 = cos(60 * r); n3 = -sin(60 * r)
            f1 = x[1] * n1 + x[3] * n3; f2 = y[1] * n1 + y[3] * n3; f3 = z[1] * n1 + z[3] * n3
            # axes x\047 = y, y\047 = -x; then about x by 3 degrees
            g1 = f2; g2 = -f1; g3 = f3
            m2 = cos(3 * r) * g2 + sin(3 * r) * g3; m3 = -sin(3 * r) * g2 + cos(3 * r) * g3
            printf "%.2f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f\n", t, x[3] + h[1] + offset, y[3] + h[2], z[3] + h[3],
                0.5 * g1 + 0.1 + 0.002 * n(), 0.5 * m2 - 0.2 + 0.002 * n(), 0.5 * m3 + 0.002 * n()
        } }
        function n() { return (uniform() + uniform() + uniform() + uniform() - 2) * 1.732 }'
}
both 0 1 > "$work/both.csv"
# The rotation is Rz(90) Rx(3): its columns are the axes of the magnetometer in those of the accelerometer.
accepts "magnetometer: with an accelerometer" calibrate --magnetometer "$work/both.csv" --json
rows() { sed -n '/"rotation"/,/\]$/p' "$work/stdout" | sed 1d | tr -d '[] \n' | sed 's/,$//'; }
check "magnetometer: the rotation between the two" near 0.02 "$(rows)" \
    0,-0.99863,0.05234,1,0,0,0,0.05234,0.99863
check "magnetometer: the dip" near 0.01 "$(number dip)" 1.0472
check "magnetometer: turned only on request" matches "$work/stdout" '"frame": "symmetric"'
run calibrate --magnetometer "$work/both.csv"
check "magnetometer: also in words" matches "$work/stdout" \
    'axes +to those of the accelerometer from [0-9]+ of 6000 samples, degrees: about x [+]2\.[0-9]+ ± .*The field points down by (59|60)\.[0-9]* degrees\..*use --with CAL.json'
accepts "magnetometer: turned" calibrate --magnetometer "$work/both.csv" --frame accelerometer --out "$work/out/both.json" \
    --report "$work/out/both.html"
check "magnetometer: the page says so" matches "$work/out/both.html" 'rotated to those of the accelerometer'
check "magnetometer: the table, too" matches "$work/stdout" 'rotated to those of the accelerometer'
run apply "$work/out/both.json" "$work/both.csv"
check "magnetometer: then the angle between up and the field is constant" test "$(paste -d, "$work/both.csv" "$work/stdout" | awk -F, '
    NR > 1 { l = sqrt($9^2 + $10^2 + $11^2) * sqrt($2^2 + $3^2 + $4^2)
    d = ($2 * $9 + $3 * $10 + $4 * $11) / l + 0.866; s += d; q += d * d; n++ }
    END { print n, (s / n < 0.01 && s / n > -0.01 && sqrt(q / n) < 0.05) }')" = "6000 1"

# Sigma is the scatter of the logs: three angles each, all but one within 3 sigma.
logs=${LONG:+20}
logs=${logs:-6}
for seed in $(seq "$logs"); do
    both 0 "$seed" > "$work/one.csv"
    run calibrate --magnetometer "$work/one.csv" --json
    echo "$(sed -n '/"accelerometer"/,$s/.*"angle": \[\(.*\)\].*/\1/p' "$work/stdout")," \
        "$(sed -n '/"accelerometer"/,$s/.*"sigma": \[\(.*\)\].*/\1/p' "$work/stdout")"
done | tr -d ' ' > "$work/angles.csv"
# The rotation vector of Rz(90) Rx(3): half angles 45 and 1.5 degrees as quaternions.
check "magnetometer: sigma covers the scatter of the angles" test "$(awk -F, 'BEGIN {
        r = 3.14159265358979 / 180; c = cos(45 * r); d = cos(1.5 * r); e = sin(1.5 * r)
        w = c * d; q[1] = c * e; q[2] = c * e; q[3] = c * d; s = sqrt(1 - w * w); t = 2 * atan2(s, w) }
    { for (i = 1; i <= 3; i++) { e = ($i - q[i] / s * t) / $(i + 3); n++; far += e * e > 9; squares += e * e } }
    END { print n, (far <= 1), (squares / n > 0.4 && squares / n < 2) }' "$work/angles.csv")" = "$((3 * logs)) 1 1"

both 0.2 1 > "$work/offset.csv"
echo '{"offset": [0.2, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}' > "$work/accel.json"
accepts "magnetometer: an accelerometer that is not calibrated" \
    calibrate --magnetometer "$work/offset.csv" --with "$work/accel.json" --json
check "magnetometer: the accelerometer is corrected by its calibration" near 0.02 "$(rows)" \
    0,-0.99863,0.05234,1,0,0,0,0.05234,0.99863
check "magnetometer: which is reported" matches "$work/stdout" '"taken": "calibrated"'
both 0.5 1 > "$work/offset.csv"
accepts "magnetometer: one that is far off" calibrate --magnetometer "$work/offset.csv"
check "magnetometer: then the axes are unknown" matches "$work/stdout" 'axes +against the accelerometer.s unknown: the length of gravity varies'
refuses "magnetometer: nor can anything be turned to it" 1 'usual length, within 10 %, in only [0-9]+ of 6000 samples; correct it' \
    calibrate --magnetometer "$work/offset.csv" --frame accelerometer
cut -d, -f5-7 "$work/both.csv" > "$work/alone.csv"
refuses "magnetometer: none there" 1 'the log has no columns of an accelerometer' \
    calibrate --magnetometer "$work/alone.csv" --frame accelerometer
refuses "magnetometer: --with a magnetometer" 2 'is a calibration of a magnetometer' \
    calibrate --magnetometer "$work/both.csv" --with "$work/out/both.json"
refuses "magnetometer: --with alone" 2 '--with: needs --magnetometer' calibrate "$work/both.csv" --with "$work/accel.json"
refuses "magnetometer: its frame alone" 2 '--frame: accelerometer needs --magnetometer' \
    calibrate "$work/both.csv" --frame accelerometer
accepts "magnetometer: a need in parts" calibrate --magnetometer "$work/both.csv" --need 1%
check "magnetometer: the need is judged" matches "$work/stdout" 'PASS: length within 0\.[0-9]+ of 1\.0 % of the field'
accepts "magnetometer: and in the unit of the readings" calibrate --magnetometer "$work/both.csv" --need 0.005
check "magnetometer: a need in field units is the same" matches "$work/stdout" 'PASS: length within 0\.00[0-9]+ of 0\.0050 input units'
refuses "magnetometer: a need of gravity" 2 'the field .--gravity. is not gravity' \
    calibrate --magnetometer "$work/both.csv" --need 1mg

recording=${RECORDINGS:-$here/../../../shared/data}/ck_acc_mag.csv
if [ -f "$recording" ]; then
    run calibrate "$recording" --columns mx,my,mz
    check "magnetometer: a real one without --magnetometer" matches "$work/stderr" "2 positions are too few.*$advice"
    accepts "magnetometer: a real one" calibrate --magnetometer "$recording" --json
    sigma=$(sed -n '/"sigma"/,/}/s/.*"offset": \[\(.*\)\].*/\1/p' "$work/stdout")
    fits=$(sed -n '/reference_offsets/,/;/s/^ *{\([-0-9., ]*\)}.*/\1/p' "$here/../reference/magnetometer.h")
    check "magnetometer: is within sigma of three fits of all its samples" test "$(
        { echo "$(vector offset)"; echo "$sigma"; echo "$fits"; } | tr -d ' ' | awk -F, '
            NR == 1 { split($0, o) } NR == 2 { split($0, s) }
            NR > 2 { for (i = 1; i <= 3; i++) { e = ($i - o[i]) / s[i]; bad += e > 1 || e < -1; n++ } }
            END { print n, bad + 0 }')" = "9 0"
    check "magnetometer: and agrees with them to their last digit" test "$(
        { echo "$(vector offset)"; echo "$fits"; } | tr -d ' ' | awk -F, '
            NR == 1 { split($0, o) } NR == 2 { split($0, least); split($0, most) }
            NR > 2 { for (i = 1; i <= 3; i++) { if ($i < least[i]) least[i] = $i; if ($i > most[i]) most[i] = $i } }
            END { for (i = 1; i <= 3; i++) { n++; bad += o[i] < least[i] - 1e-4 || o[i] > most[i] + 1e-4 } print n, bad + 0 }')" = "3 0"
    check "magnetometer: its samples differ from a sphere by as much as with a fit of all" near 0.0002 \
        "$(number sample_rms)" "$(sed -n 's/.*reference_rms = \([0-9.]*\);/\1/p' "$here/../reference/magnetometer.h")"
    check "magnetometer: and good" matches "$work/stdout" '"verdict": "good"'
    # shellcheck disable=SC2016 # fields of awk
    check "magnetometer: its axes are turned as in a fit of all samples" test "$(
        { echo "$(vector angle)"; sed -n '/"accelerometer"/,$s/.*"sigma": \[\(.*\)\].*/\1/p' "$work/stdout"
          sed -n 's/.*reference_axes.*{\(.*\)};/\1/p' "$here/../reference/magnetometer.h"; } | tr -d ' ' | awk -F, '
            NR == 1 { split($0, a) } NR == 2 { split($0, s) }
            NR == 3 { for (i = 1; i <= 3; i++) { e = ($i - a[i]) / s[i]; bad += e > 1 || e < -1; n++ } }
            END { print n, bad + 0 }')" = "3 0"
    check "magnetometer: and so is the dip" near 0.01 "$(number dip)" "-$(
        sed -n 's/.*reference_axes.*, \([0-9.]*\)};/\1/p' "$here/../reference/magnetometer.h" |
            awk '{ print atan2($1, sqrt(1 - $1 * $1)) }')"
fi
# ---- simulated ------------------------------------------------------------------------------------

# Nine parameters and three angles of these logs: errors over sigma, against the options that made them.
"$tool" simulate > "$work/still.csv"
run calibrate "$work/still.csv" --quiet --out "$work/accel.json"
seed=0
while [ $((seed += 1)) -le "$logs" ]; do
    "$tool" simulate --magnetometer --seed $seed > "$work/waved.csv"
    run calibrate --magnetometer "$work/waved.csv" --gravity 48 --zero 0,0,0 --lsb 1 --json --with "$work/accel.json"
    sed -n '/^  "sigma"/,/^  }/d; s/^  "\(offset\|dk\|gamma\)": \[\(.*\)\],*$/\2/p; s/^ *"angle": \[\(.*\)\],*$/\1/p' "$work/stdout" | tr '\n' ','
    sed -n 's/^    "\(offset\|dk\|gamma\)": \[\(.*\)\],*$/\2/p; /"angle"/,$s/^ *"sigma": \[\(.*\)\],*$/\1/p' "$work/stdout" | tr '\n' ','
    echo
done | tr -d ' ' > "$work/simulated.csv"
honest() { # FIRST LAST LEAST: columns; 95 % of the errors within 2.03 sigma or so, and their mean square LEAST ... 1.5
    awk -F, -v logs="$logs" -v first="$1" -v last="$2" -v least="$3" '
        BEGIN { split("12 -30 5 0.03 -0.02 0.015 0.02 -0.01 0.015 0.034907 -0.017453 0.026180", truth, " ") }
        { for (i = first; i <= last; i++) { e = ($i - truth[i]) / $(12 + i); n++; in95 += e * e < 2.03 * 2.03; squares += e * e } }
        END { exit !(n == logs * (last - first + 1) && in95 / n > 0.9 && squares / n > least && squares / n < 1.5) }' "$work/simulated.csv"
}
check "simulate --magnetometer: offsets, scales and angles are within sigma" honest 1 9 0.4
check "simulate --magnetometer: and its axes against the accelerometer's" honest 10 12 0.1 # these are too cautious
"$tool" simulate --magnetometer --truth "$work/truth.json" > "$work/waved.csv"
run apply "$work/truth.json" "$work/waved.csv"
check "simulate --magnetometer: its truth makes all lengths 48 uT" test "$(awk -F, 'NR > 1 { l = sqrt($2^2 + $3^2 + $4^2); s += l; q += (l - 48)^2; n++ }
    END { print n, (s / n > 47.7 && s / n < 48.3), (sqrt(q / n) > 0.4 && sqrt(q / n) < 0.6) }' "$work/stdout")" = "6000 1 1"
check "simulate --magnetometer: the dip, rad" near 1e-6 "$(sed -n 's/.*"dip": \(.*\),/\1/p' "$work/truth.json")" 1.0471976
"$tool" simulate --magnetometer --magnet 40 > "$work/waved.csv"
run calibrate --magnetometer "$work/waved.csv" --gravity 48 --json
check "simulate --magnet: it is named" matches "$work/stdout" '"disturbance": "passing"'
check "simulate --magnet: and causes no error" near 0.6 "$(vector offset)" 12,-30,5
"$tool" simulate --magnetometer --mag-field 30,-20 --mag-offset 1,2,3 --mag-soft 0.1,0,0,0,0,0.1 --mag-turn 0,0,0 --mag-noise 0 \
    --noise 0 --tremor 0 --offset 0,0,0 --dk 0,0,0 --gamma 0,0,0 --seconds 90 --rate 50 > "$work/waved.csv"
run calibrate --magnetometer "$work/waved.csv" --gravity 30 --zero 0,0,0 --lsb 1 --json
check "simulate --magnetometer: without noise, offset" near 0.002 "$(vector offset)" 1,2,3
check "simulate --magnetometer: without noise, scales" near 1e-4 "$(vector dk)" 0.1,0,0
check "simulate --magnetometer: without noise, angles" near 1e-4 "$(vector gamma)" 0,0,0.1
check "simulate --magnetometer: without noise, up and the field" near 1e-3 "$(number dip)" -0.349066
check "simulate --seconds: the number of samples" test "$(wc -l < "$work/waved.csv")" -eq 4501
for option in '--plan=edges' '--gyro' '--dwell=3' '--stand' '--outliers=1' '--temperature=1,2'; do
    refuses "simulate --magnetometer and $option" 2 "--magnetometer: cannot be combined with ${option%=*}" simulate --magnetometer "$option"
done
refuses "simulate: a field without a magnetometer" 2 '--mag-field: needs --magnetometer' simulate --mag-field 48,60
refuses "simulate: no length" 2 '--mag-field: must be a length above 0' simulate --magnetometer --mag-field 0,60
refuses "simulate: a dip beyond the vertical" 2 '--mag-field: must be a length above 0' simulate --magnetometer --mag-field 48,91

# ---- an earlier calibration of another sensor ----------------------------------------------------------

run calibrate "$work/still.csv" --quiet --out "$work/accel.json"
"$tool" simulate --magnetometer > "$work/waved.csv"
run calibrate --magnetometer "$work/waved.csv" --quiet --out "$work/magnet.json"
refuses "magnetometer: the calibration of an accelerometer is not its nominal" 2 \
    '--nominal .*accel.json: is a calibration of an accelerometer' \
    calibrate --magnetometer "$work/waved.csv" --nominal "$work/accel.json"
refuses "magnetometer: nor its own that of an accelerometer" 2 \
    '--nominal .*magnet.json: is a calibration of a magnetometer' \
    calibrate "$work/still.csv" --nominal "$work/magnet.json"
accepts "magnetometer: its own is" calibrate --magnetometer "$work/waved.csv" --nominal "$work/magnet.json"
refuses "an earlier calibration over another field" 2 \
    '--nominal .*accel.json: was made with --gravity 9.80665, but here it is 1' \
    calibrate "$work/still.csv" --nominal "$work/accel.json" --gravity 1

finish
