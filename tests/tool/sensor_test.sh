#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the nominal sensor: from --sensor, from the unit, or unknown; then no meaningless number is
# printed. sensor_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

page=$work/out/page.html
words() {
    sed '/<style>/,/<\/style>/d; s/<[^>]*>/ /g' "$page" | sed "s/$(printf '\302\240')/ /g" | tr -s ' \n' ' '
}
says_page() { words | grep -Eq -- "$1" || { { words | head -c 600; echo; } >&2; return 1; }; }
says_not() { ! words | grep -Eq -- "$1"; }
made() { "$tool" simulate --plan edges "$@" > "$work/log.csv"; } # made OPTIONS ...: a log

# Members of the run's JSON, a line each: offset, matrix, sigma ...
member() { json "$work/stdout" "$1"; }
nominal() { # nominal MEMBER: one of nominal
    sed -n '/^  "nominal": {/,/^  }/p' "$work/stdout" | sed -n "s/^    \"$1\": \(.*[^,]\),*\$/\1/p"
}
sigma() { sed -n '/^  "sigma": {/,/^  }/p' "$work/stdout" | sed -n "s/^    \"$1\": \(.*[^,]\),*\$/\1/p"; }
is() { [ "$1" = "$2" ] || { echo "    $1" >&2; return 1; }; }

unknown='[null, null, null]'
truth='0.02 -0.015 0.03'   # of simulate: offsets, g,
scales='0.01 -0.008 0.012' # scale errors

# ---- counts, and nothing stated ------------------------------------------------------------------

made
accepts "nothing stated: is calibrated" calibrate "$work/log.csv" --out "$work/cal.json" --report "$page"
cp "$work/stdout" "$work/table"
check "nothing stated: the table says so, and which options would" matches "$work/table" \
    '^nominal: unknown; state --sensor, --unit, or --zero and --lsb$'
check "nothing stated: no columns for nominal" matches "$work/table" '^ +calibrated ± sigma$'
check "nothing stated: offsets as they are read" matches "$work/table" '^offset x +327\.[0-9]+ ± 0\.[0-9]+ +counts$'
check "nothing stated: scales too" matches "$work/table" '^scale z +169[0-9]\.[0-9] ± [0-9.]+ +counts per m/s²$'
check "nothing stated: angles, from square" matches "$work/table" '^angle xy +0\.57[0-9]+ ± 0\.0[0-9]+ +degrees off square$'
check "nothing stated: no deviation, no before, no guess" lacks "$work/table" 'scale error|difference|rms before|guess|range'
check "nothing stated: the page has no deviations" says_not 'deviation from nominal|Deviation from nominal'
check "nothing stated: nor before" says_not '[Bb]efore'
check "nothing stated: nor a guess" says_not 'guess|say nothing'
check "nothing stated: and no bars" lacks "$page" 'bar"|The nine parameters with their uncertainty'
check "nothing stated: it has offsets, scales and angles" says_page \
    'parameter value remark offset x 327\.[0-9]+ ± 0\.[0-9]+ .*angle xy \+0\.57[0-9]* ± 0\.0[0-9]* °'
check "nothing stated: it says which options would" says_page 'nominal unknown; state --sensor, --unit, or --zero and --lsb'
check "nothing stated: it has residuals" says_page ' Residuals '
check "nothing stated: it is well-formed" is_page "$page"
run calibrate "$work/log.csv" --json
for m in delta dk; do
    check "nothing stated: JSON: $m is unknown" is "$(member $m)" "$unknown"
done
check "nothing stated: JSON: no zero" is "$(nominal zero) $(nominal zero_from)" "$unknown \"range\""
check "nothing stated: JSON: no scale" is "$(nominal lsb) $(nominal lsb_from)" "$unknown \"range\""
check "nothing stated: JSON: no residual before" is "$(member residual_before)" null
check "nothing stated: JSON: offset of the truth" near 2 "$(member offset)" '327.68 -245.76 491.52'
check "nothing stated: JSON: gamma of the truth" near 2e-4 "$(member gamma)" '0.01 -0.006 0.008'
for m in offset delta dk gamma; do
    check "nothing stated: JSON: sigma of $m" sh -c 'echo "$1" | grep -Eq "^\[[0-9]"' sh "$(sigma $m)"
done
accepts "nothing stated: apply takes the file" apply "$work/cal.json" "$work/log.csv"
accepts "nothing stated: export takes it" export "$work/cal.json" --format c
refuses "nothing stated: a driver's scale is unknown" 2 'the scale of the driver is unknown' export "$work/cal.json" \
    --format px4
accepts "nothing stated: the file is a nominal" calibrate "$work/log.csv" --nominal "$work/cal.json"
check "nothing stated: its log does not differ from that nominal" matches "$work/stdout" '^scale error x +-?0\.00 ± '
run calibrate "$work/log.csv" --zero 0,0,0 --json
check "a zero alone: offsets from it, to 1 %" near 5e-4 "$(member delta)" "$truth"
check "a zero alone: no scale errors" is "$(member dk) $(member residual_before)" "$unknown null"
run calibrate "$work/log.csv" --lsb 0.00059855 --json
check "a scale alone: its errors" near 3e-3 "$(member dk)" "$scales"
check "a scale alone: no offsets from nominal" is "$(member delta) $(member residual_before)" "$unknown null"
run watch "$work/log.csv" --json
check "nothing stated: watch has no deviations, either" is "$(member delta) $(member dk)" "$unknown $unknown"
run calibrate "$work/log.csv" --robust --json
check "nothing stated: nor does the cross-check" [ "$(grep -c '"d[ek][a-z]*": \[null' "$work/stdout")" -eq 4 ]

# ---- the unit -----------------------------------------------------------------------------------

in_unit() { # in_unit FACTOR [HEADER]: the log in another unit than counts
    awk -F, -v OFS=, -v f="$1" -v header="${2:-t,x,y,z}" \
        'NR == 1 { print header; next } { print $1, f * $2, f * $3, f * $4 }' OFMT=%.9g \
        CONVFMT=%.9g "$work/log.csv" > "$work/unit.csv"
}
compares() { # compares SENTENCE ZERO_FROM ARGUMENTS ...: with the truth
    sentence=$1
    from=$2
    shift 2
    run calibrate "$@" --json
    check "$sentence: zero and scale" is "$(nominal zero_from) $(nominal lsb_from)" "\"$from\" \"$from\""
    check "$sentence: offsets are the sensor's" near 3e-4 "$(member delta)" "$truth"
    check "$sentence: scale errors are the sensor's" near 4e-4 "$(member dk)" "$scales"
}
in_unit 0.000598550415
compares "m/s^2 by size" unit "$work/unit.csv"
check "m/s^2 by size: zero 0, scale 1" is "$(nominal zero) $(nominal lsb)" '[0, 0, 0] [1, 1, 1]'
run calibrate "$work/unit.csv"
check "m/s^2 by size: the first lines say so" sh -c 'head -n 5 "$1" | tr "\n" " " | grep -q "in m/s² (by their size).*nominal: zero and scale from the unit"' sh \
    "$work/stdout"
run watch "$work/unit.csv" --json
check "m/s^2 by size: watch compares alike" near 3e-4 "$(member delta)" "$truth"
in_unit 6.103515625e-5
compares "g by size" unit "$work/unit.csv"
compares "g by size, result in g" unit "$work/unit.csv" --gravity 1
check "g by size, result in g: scale 1" is "$(nominal lsb)" '[1, 1, 1]'
in_unit 0.06103515625
run calibrate "$work/unit.csv" --json
check "mg by size may be counts" is "$(member unit) $(nominal lsb_from) $(member dk)" "\"mg\" \"range\" $unknown"
compares "mg by --unit" unit "$work/unit.csv" --unit mg
in_unit 0.06103515625 't,x (mg),y (mg),z (mg)'
compares "mg by header" unit "$work/unit.csv"

# ---- data sheets --------------------------------------------------------------------------------

# Counts per g as in the data sheets: NAME COUNTS, and which true values are beyond its limits
while read -r name counts beyond; do
    made --lsb "$(awk -v c="$counts" 'BEGIN { printf "%.17g", 9.80665 / c }')"
    compares "$name" sensor "$work/log.csv" --sensor "$name"
    check "$name: counts, by it" is "$(member unit) $(member unit_from)" '"counts" "sensor"'
    check "$name: zero 0, and the scale of the sheet" near 1e-11 "$(nominal zero) $(nominal lsb)" \
        "0 0 0 $(awk -v OFMT=%.12g -v c="$counts" 'BEGIN { s = 9.80665 / c; print s, s, s }')"
    check "$name: beyond its limits: ${beyond:-none}" is "$(member beyond)" "[$beyond]"
done << 'EOF'
mpu6050 16384
mpu6050:4g 8192
MPU-9250:8g 4096
icm20948:16g 2048 "dk_z"
lsm6ds3:2g 16393.44262295
lis3dh:4g 8000
bno055 980.665
bno055:mg 1000
adxl355:4g 128000
EOF
made
compares "bmi160" sensor "$work/log.csv" --sensor bmi160
check "the name is saved" is "$(nominal sensor)" '"bmi160:2g"'
run calibrate "$work/log.csv" --sensor mpu6050
check "the first line says whose counts" matches "$work/stdout" 'counts \(--sensor\)$'
check "the table says which sheet" matches "$work/stdout" '^MPU-6050 at 2g: InvenSense PS-MPU-6000A-00 Rev\. 3\.4'
check "the table says its limits" matches "$work/stdout" '^limits        typical: offsets ±50, ±50, ±80 mg; scale ±3 %; cross-axis ±2 %$'
accepts "the page of a sensor" calibrate "$work/log.csv" --sensor mpu6050 --report "$page" --out "$work/cal.json"
check "it has the limits" says_page 'sensor MPU-6050 at 2g its limits typical: offsets ±50, ±50, ±80 mg; scale ±3 %; cross-axis ±2 %'
check "it names the document" says_page 'InvenSense PS-MPU-6000A-00 Rev\. 3\.4, 2013-08-19'
check "it has before and after" says_page 'Deviation: from nominal.* Before and after'
check "bars are drawn, with limits of each axis" [ "$(grep -c 'c0 dashed' "$page")" -eq 36 ]
run export "$work/cal.json" --format px4
check "a driver's scale is that of the sheet" matches "$work/stdout" 'CAL_ACC0_XOFF'
run calibrate "$work/log.csv" --sensor mpu6050 --gravity 1 --json
check "a result in g: counts of the sheet" near 1e-12 "$(nominal lsb)" \
    "$(awk -v OFMT=%.12g 'BEGIN { s = 1 / 16384; print s, s, s }')"
accepts "a prior has its nominal from the sheet" calibrate "$work/log.csv" --sensor mpu6050 --prior 0.05,0.03,0.02

# Limits are by axis: 60 mg is too much for x of the MPU-6050, not for z.
made --offset 0.06,0.02,0.06 --dk 0.04,0,0 --gamma 0,0.05,0
run calibrate "$work/log.csv" --sensor mpu6050 --json
check "beyond: each by its own limit" is "$(member beyond)" '["delta_x", "dk_x", "gamma_xz"]'
run calibrate "$work/log.csv" --sensor mpu6050 --tolerance 0.07,0.05,0.06 --json
check "--tolerance overrides the sheet by looser limits" is "$(member beyond)" '[]'
run calibrate "$work/log.csv" --sensor mpu6050 --tolerance 0.01,0.05,0.06 --json
check "--tolerance overrides the sheet by tighter limits" is "$(member beyond)" '["delta_x", "delta_y", "delta_z"]'
run calibrate "$work/log.csv" --sensor lsm6ds3 --json
check "beyond: what the sheet does not state is no limit" is "$(member beyond)" '["delta_x", "delta_z"]'
run calibrate "$work/log.csv" --sensor mpu6050 --zero 983,0,983 --json
check "--zero overrides the zero, the scale is the sheet's" is \
    "$(nominal zero_from) $(nominal lsb_from) $(member beyond)" '"given" "sensor" ["dk_x", "gamma_xz"]'

# In m/s^2 the sheet has the limits, and the unit the rest.
in_unit 0.000598550415 't,x (m/s^2),y (m/s^2),z (m/s^2)'
run calibrate "$work/unit.csv" --sensor mpu6050 --json
check "readings in m/s^2: limits of the sheet" is "$(nominal lsb_from) $(member beyond)" \
    '"unit" ["delta_x", "dk_x", "gamma_xz"]'
run calibrate "$work/unit.csv" --sensor xsens-mti --json
check "a sheet without limits: nothing is judged" is "$(member beyond)" ''
run watch "$work/unit.csv" --sensor mpu6050:16g --json
check "watch: readings in m/s^2 may have any range" is "$(nominal lsb_from) $(member beyond)" \
    '"unit" ["delta_x", "dk_x", "gamma_xz"]'

# ---- temperature ----------------------------------------------------------------------------------

# 1 mg a degree against nominal, which is 1 / 1.2 of that in the scale of a sensor that reads 1.2 times too much.
"$tool" simulate --plan optimal:48 --temperature 10,20 --drift 0.001 --dwell 8 --noise 0.0028 --dk 0.2,0.2,0.2 \
    > "$work/drift.csv"
slopes() { awk '/ mg\/K/ { print $3 }' "$work/stdout" | tr '\n' ' '; }
run calibrate "$work/drift.csv" --thermal 1 --sensor mpu6050
check "slopes relative to a data sheet" near 0.08 "$(slopes)" '1 1 1'
accepts "slopes of counts" calibrate "$work/drift.csv" --thermal 1 --report "$page"
check "slopes of counts: in their own scale" near 0.08 "$(slopes)" '0.833 0.833 0.833'
slope=$(awk '/ mg\/K/ { printf "%s ", $3 / 1000 }' "$work/stdout")
run calibrate "$work/drift.csv" --thermal 1 --json
check "slopes of counts: JSON has the same" near 5e-7 "$slope" \
    "$(sed -n '/"slope": {/,/}/s/^ *"delta": //p' "$work/stdout")"
run calibrate "$work/drift.csv" --thermal 1
check "slopes of counts: no guess" lacks "$work/stdout" 'guess'
check "slopes of counts: the page has none" says_not 'guess'
check "slopes of counts: curves begin where the parameters are" says_page 'offset over the field relative to 15\.[0-9]+ °C, mg'

# ---- a stand --------------------------------------------------------------------------------------

"$tool" simulate --plan per-group:6 --stand --lsb 0.0005 > "$work/stand.csv"
accepts "at a stand" calibrate "$work/stand.csv" --stand --report "$page"
check "at a stand: differences of two methods, not what they differ from" matches "$work/stdout" \
    '^offset x + ± [0-9.]+ +[+-][0-9.]+  mg$'
check "at a stand: angles" matches "$work/stdout" '^angle xy +0\.[0-9]+ ± [0-9.]+ +0\.[0-9]+ +[+-][0-9.]+  degrees'
check "at a stand: no series" lacks "$work/stdout" '^group'
check "at a stand: closures" matches "$work/stdout" '^closure '
check "at a stand: the page has no series" says_not "paper's series of J1"
check "at a stand: it is well-formed" is_page "$page"
run calibrate "$work/stand.csv" --stand --json
check "at a stand: JSON has none" [ "$(grep -c 'coefficients": \[null, null, null, null, null\]' "$work/stdout")" -eq 3 ]
check "at a stand: JSON has no deviations" [ "$(grep -c '"d[ek][a-z]*": \[null' "$work/stdout")" -eq 6 ]
run calibrate "$work/stand.csv" --stand --zero 0,0,0 --lsb 0.0005
check "at a stand, and a nominal: all of it" matches "$work/stdout" '^group 1 +[-+][0-9.]+e'

# ---- refusals --------------------------------------------------------------------------------------

made
echo old > "$work/out/cal.json"
rm -f "$page"
# It is the data that are wrong; at the beginning of a live stream, the command line can still be corrected.
for command in calibrate watch; do
    code_of=$([ $command = calibrate ] && echo 1 || echo 2)
    refuses "$command: another range is named" "$code_of" \
        'log\.csv: the readings are 2\.[01] times too large for mpu6050:4g: they match mpu6050:2g; state that range' \
        $command "$work/log.csv" --sensor mpu6050:4g --out "$work/out/cal.json"
    check "$command: nothing is written" is_untouched
    refuses "$command: another sensor" "$code_of" \
        'the readings are 5[0-9]+ times too large for adxl345:16g, at any of its ranges: a broken unit, or another' \
        $command "$work/log.csv" --sensor adxl345:16g
    refuses "$command: an unknown name" 2 "--sensor: unknown sensor 'mpu605' \(did you mean mpu6050\?\); --sensor list" \
        $command "$work/log.csv" --sensor mpu605
    refuses "$command: an unknown range" 2 "MPU-6050 has no '3g', but 2g, 4g, 8g, 16g" \
        $command "$work/log.csv" --sensor mpu6050:3g
    refuses "$command: --nominal states it, too" 2 '--sensor: and --nominal both' \
        $command "$work/log.csv" --sensor mpu6050 --nominal "$work/cal.json"
    refuses "$command: a magnetometer has no such sheet" 2 '--sensor: is an accelerometer' \
        $command "$work/log.csv" --sensor mpu6050 --gravity 48.5
    accepts "$command: --sensor list" $command --sensor list
    check "$command: --sensor list fits into 80 columns" sh -c 'sed "s/±/+/g" "$1" | LC_ALL=C awk "length > 80 { exit 1 }"' sh \
        "$work/stdout"
    check "$command: --sensor list has all" is "$(sed -n 's/^\([a-z][a-z0-9-]*\)  .*/\1/p' "$work/stdout" | tr '\n' ' ')" \
        'mpu6050 mpu6000 mpu9250 icm20948 lsm6ds3 lsm6dso lis3dh adxl345 adxl355 bmi160 bmi270 bno055 xsens-mti '
done
check "--sensor list names the range at power-on" [ "$(grep -c '[a-z0-9]\* ' "$work/stdout")" -eq 13 ]
check "--sensor list says what is typical" matches "$work/stdout" 'typical: offsets ±50, ±50, ±80 mg; scale ±3 %'
made --lsb 0.000299275207
refuses "too small" 1 'the readings are 2\.0 times too large for mpu6050:2g, at any of its ranges' calibrate "$work/log.csv" --sensor mpu6050
made --lsb 0.00119710083
refuses "as if it were another" 1 'the readings are 2\.0 times too small for mpu6050:2g: they match mpu6050:4g' \
    calibrate "$work/log.csv" --sensor mpu6050
# A unit that is off by 1.5 g: 24576 counts of an MPU-6050.
made
awk -F, -v OFS=, 'NR > 1 { $2 += 24576 } 1' "$work/log.csv" > "$work/broken.csv"
run calibrate "$work/broken.csv" --sensor mpu6050:2g --need 2mg --json-lines --report "$page"
check "a broken unit: exit code 1, and the reason" sh -c '[ "$1" -eq 1 ] && grep -Eq "$2" "$3"' sh "$code" \
    'for mpu6050:2g, at any of its ranges: a broken unit, or another sensor; state --zero and --lsb if it is right$' \
    "$work/stderr"
check "a broken unit: it has its line" matches "$work/stdout" \
    '^\{"file": ".*broken\.csv", .*"error": "out of range", "reason": "the readings are 1\.[0-9] times too large'
check "a broken unit: and its page" says_page 'No calibration: out of range .*a broken unit, or another sensor'
check "a broken unit: the page is well-formed" is_page "$page"
run calibrate "$work/broken.csv" --sensor mpu6050:2g --zero 0,0,0 --lsb 9.80665/16384 --json
check "a broken unit: stated as right, it is calibrated" near 3e-4 "$(member delta)" '1.52 -0.015 0.03'
made --lsb 0.00119710083
accepts "it is" calibrate "$work/log.csv" --sensor mpu6050:4g
refuses "--tolerance needs something to compare with" 2 '--tolerance: .*--sensor' calibrate "$work/log.csv" \
    --tolerance 0.1,0.1,0.1

finish
