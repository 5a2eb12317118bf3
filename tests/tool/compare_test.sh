#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of invcal compare: compare_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

make_cal() { # NAME SIMULATE'S OPTIONS -- CALIBRATE'S OPTIONS
    name=$1
    shift
    simulate=
    while [ "$1" != -- ]; do
        simulate="$simulate $1"
        shift
    done
    shift
    # shellcheck disable=SC2086
    "$tool" simulate --plan edges $simulate > "$work/raw.csv"
    "$tool" calibrate "$work/raw.csv" --quiet --out "$work/$name.json" "$@"
}
here=$(cd "$here" && pwd)
data=$here/../data
cd "$work" || exit 2
words() { sed 's/<[^>]*>/ /g' page.html | plainly | tr '\n' ' ' | tr -s ' '; }
says_page() { words | grep -Eq -- "$1"; }
make_cal old --seed 1 -- --serial 47 --date 2026-01-05
make_cal middle --seed 2 -- --serial 47 --date 2026-03-01
make_cal new --seed 3 --offset 0.025,-0.015,0.03 --dk 0.01,-0.008,0.0125 -- --serial 47 --date 2026-06-01

# ---- a history ---------------------------------------------------------------------------------

member() { # NAME: numbers of a member inside, one after the other
    sed -n "s/^ *\"$1\": \[\(.*\)\],*\$/\1/p" "$work/stdout"
}
files_in_order() { sed -n 's/^ *"file": "\(.*\)",*$/\1/p' "$work/stdout" | tr '\n' ' '; }
accepts "history: compare takes them" compare new.json old.json middle.json
cp "$work/stdout" "$work/table"
check "history: by date" [ "$(awk '/^[1-3]  2026/ { printf "%s ", $3 }' "$work/table")" = "old.json middle.json new.json " ]
rows() { # FROM TO: the rows of this step
    awk -v from="$1" -v to="$2" '/ to .* before / { on = $1 == from && $3 == to; next } !NF { on = 0 } on' "$work/table"
}
check "history: nine rows for each step, and from the first to the newest" \
    [ "$(rows 1 2 | wc -l) $(rows 2 3 | wc -l) $(rows 1 3 | wc -l)" = "9 9 9" ]
rows 1 2 > "$work/first"
rows 2 3 > "$work/second"
check "history: from the first to the second nothing has changed" lacks "$work/first" changed
check "history: then offset x has, and only that" [ "$(awk '/changed/ { print $1, $2 }' "$work/second")" = "offset x" ]
check "history: its change is 5 mg" awk '/^offset x/ { d = $5 - 5; exit !(d < 0.1 && d > -0.1) }' "$work/second"
tr '\n' ' ' < "$work/table" > "$work/line"
check "history: it says so" matches "$work/line" \
    ' Changed: Offset x has changed significantly since 2026-03-01 \(middle\.json\)\. Next: '
check "history: a cause may be another unit" matches "$work/line" 'or another unit under this serial number\), and'
check "history: the error of the field is mentioned" grep -q -- --same-field "$work/table"
run compare new.json old.json middle.json --same-field
check "same field: the scale has changed, too" matches "$work/stdout" '^Changed: Offset x, scale z have changed'
check "same field: and that error is not mentioned" lacks "$work/stdout" '--same-field'

run compare middle.json new.json --same-field --json
check "JSON: offset x drifts by 0.005" near 0.0001 "$(member delta | sed -n 1p)" "0.005, 0, 0"
check "JSON: scale z by 0.0005 / 1.012" near 0.0001 "$(member dk | sed -n 1p)" "0, 0, 0.000494"
check "JSON: angles do not" near 0.0003 "$(member gamma | sed -n 1p)" "0, 0, 0"
# Without the field's uncertainty, sigma is what calibrate gives for an exact field.
sigma_of() { "$tool" simulate --plan edges "$@" | "$tool" calibrate - --gravity 9.80665 --json |
    sed -n '/"sigma"/,/}/s/^ *"dk": \[\(.*\)\],*$/\1/p'; }
sigma_of --seed 2 > "$work/sigmas"
sigma_of --seed 3 --offset 0.025,-0.015,0.03 --dk 0.01,-0.008,0.0125 >> "$work/sigmas"
expected=$(awk -F ', ' '{ for (i = 1; i <= 3; i++) s[i] += $i * $i }
    END { print sqrt(s[1]), sqrt(s[2]), sqrt(s[3]) }' "$work/sigmas")
check "JSON: sigma of the scales: both, squared" near 1e-6 "$(member dk | sed -n 2p)" "$expected"
check "JSON: what has changed" matches "$work/stdout" '^ *"changed": \["delta_x", "dk_z"\]'
run compare old.json old.json --json
check "a file and itself: no drift, and chance 1" near 0 "$(member delta | sed -n '1p;4p' | tr '\n' ' ')" \
    "0 0 0 1 1 1"
check "a file and itself: steady" matches "$work/stdout" '"changed": \[\]'
run compare old.json middle.json
check "what has not changed is steady" matches "$work/stdout" '^Steady: Nothing has changed significantly since'
check "two have no table from the first to the newest" [ "$(grep -c ' before ' "$work/stdout")" -eq 1 ]

# Offset x creeps by 0.04 mg each month, 0.16 mg in all; sigma of a step is 0.04 mg.
for k in 1 2 3 4 5; do
    make_cal "month$k" --seed 40$k --dwell 3 --offset "0.0$((2000 + 4 * k)),-0.015,0.03" -- --serial 48 --date "2026-0$k-01"
done
accepts "a slow drift: compare takes it" compare month?.json --same-field
tr '\n' ' ' < "$work/stdout" > "$work/line"
check "a slow drift: no step is unusual, their sum is" [ "$(grep -c ' changed$' "$work/stdout")" -eq 1 ]
check "a slow drift: the verdict is about the sum" matches "$work/line" \
    ' Drifting: Nothing has changed significantly since 2026-04-01 \(month4\.json\), but offset x has moved by \+0\.[0-9]+ mg \(\+[0-9.]+ sigma\) since 2026-01-01 \(month1\.json\)\. Next: use the newest calibration, look for a cause'
run compare month?.json --same-field --json
sed -n '/"since_first"/,$p' "$work/stdout" > "$work/whole"
check "a slow drift: JSON has it, too" matches "$work/whole" '"changed": \["delta_x"\]'
check "a slow drift: from the first to the newest" matches "$work/whole" '"from": "month1\.json"'
check "a slow drift: by 0.16 mg" near 0.00012 "$(sed -n 's/^ *"delta": \[\(.*\)\],*$/\1/p' "$work/whole" | head -n 1)" "0.00016, 0, 0"
run compare month1.json month5.json --same-field --json
check "a slow drift: as if only these two were compared" \
    [ "$(member delta | tr -d '\n')" = "$(sed -n 's/^ *"delta": \[\(.*\)\],*$/\1/p' "$work/whole" | tr -d '\n')" ]
accepts "a slow drift: page" compare month?.json --same-field --report page.html --quiet
check "a slow drift: page: well-formed" is_page page.html
check "a slow drift: page: the verdict" says_page '! Drifting Nothing has changed significantly since 2026-04-01 \(month4\.json\), but offset x has moved by'
check "a slow drift: page: a table from the first to the newest" says_page 'From 1 to 5\.'

# The same log against other nominals, which rotate the frame slightly, gives the same calibration.
"$tool" simulate --plan edges --gamma 0.05,-0.04,0.03 > "$work/raw.csv"
"$tool" calibrate raw.csv --quiet --out one.json
"$tool" calibrate raw.csv --quiet --zero 300,-200,500 --lsb 0.00055,0.00065,0.0006 --out other.json
"$tool" calibrate raw.csv --quiet --nominal old.json --out third.json
for other in other third; do
    run compare one.json $other.json --json
    check "another nominal is no drift ($other)" near 2e-5 \
        "$(member delta | sed -n 1p) $(member dk | sed -n 1p) $(member gamma | sed -n 1p)" "0 0 0 0 0 0 0 0 0"
done
accepts "two without a serial are a history" compare one.json other.json
check "in the order of the arguments" matches "$work/stdout" '^one\.json: 2 calibrations, by the order of the files|^other\.json: 2 calibrations, by the order of the files'
make_cal undated --seed 4 -- --serial 47
run compare new.json undated.json old.json --json
check "one without a date: the order of the arguments" [ "$(files_in_order)" = "new.json undated.json old.json " ]
"$tool" simulate --plan optimal:9 > "$work/raw.csv"
sed 's/"sigma": {/"sigma": {"offset": [null, null, null], "dk": [null, null, null], "gamma": [null, null, null]}, "was": {/' \
    old.json > blind.json
run compare blind.json middle.json
check "without a ± nothing is reported as changed" matches "$work/stdout" '^Unknown: Nothing has changed as far as is known'
check "and a drift has none" matches "$work/stdout" '^offset x .* [+-][0-9.]+ ± \? +\?$'

# A file of the first release, which had neither record nor gravity_sigma, from the same positions.
release=$here/../reference/releases/0.1.0-calibration.json
"$tool" calibrate "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 --zero 33123,33276,32360 \
    --lsb 0.002409639,0.002421308,0.002409639 --quiet --out today.json
accepts "a file of 0.1.0 is compared" compare "$release" today.json --json
check "and is the same calibration today" near 1e-9 \
    "$(member delta | sed -n 1p) $(member dk | sed -n 1p) $(member gamma | sed -n 1p)" "0 0 0 0 0 0 0 0 0"

# ---- a fleet -----------------------------------------------------------------------------------

# Twenty devices whose offsets are normal with a deviation of 10 mg, and scales of 0.5 %.
awk "$random_awk"'BEGIN { begin_random(5)
    for (k = 1; k <= 20; k++) { for (i = 1; i <= 6; i++) {
        printf "%s%.6f", (i == 1 ? "" : i == 4 ? " " : ","), normal() * (i <= 3 ? 0.01 : 0.005) + (k == 13 && i == 2 ? 0.1 : 0) }
        print "" } }' > "$work/devices"
k=0
while read -r offset dk; do
    k=$((k + 1))
    make_cal "d$k" --seed $k "--offset=$offset" "--dk=$dk" -- --serial "D$k" --gravity 9.80665
    printf '%s,%s\n' "$offset" "$dk" >> "$work/truth"
done < "$work/devices"
accepts "fleet: compare takes them" compare d*.json
cp "$work/stdout" "$work/table"
check "fleet: nine rows" [ "$(grep -cE '^(offset|scale|angle) ' "$work/table")" -eq 9 ]
check "fleet: one is an outlier" matches "$work/table" '^Not alike: Outliers, of 20 devices: serial D13 \(offset y\)\.$'
check "fleet: its row says so" matches "$work/table" '^offset y .* serial D13 +\+[0-9.]+ +outside$'
check "fleet: by how much" matches "$work/table" '^Outlier: serial D13, offset y: \+[0-9]+(\.[0-9])? mg from the median$'
run compare d*.json --json
cp "$work/stdout" "$work/fleet.json"
statistics=$(awk -F, '
    function sort(v, n,    i, j, t) { for (i = 2; i <= n; i++) { t = v[i]
        for (j = i - 1; j > 0 && v[j] > t; j--) v[j + 1] = v[j]; v[j + 1] = t } }
    { x[NR] = $2; sum += $2 }
    END { for (i = 1; i <= NR; i++) squares += (x[i] - sum / NR) ^ 2
        sort(x, NR); median = (x[10] + x[11]) / 2
        for (i = 1; i <= NR; i++) away[i] = x[i] < median ? median - x[i] : x[i] - median
        sort(away, NR)
        print 1.4826 * (away[10] + away[11]) / 2, sqrt(squares / 19) }' "$work/truth")
printed=$(member delta | tail -2 | awk -F ', ' '{ printf "%s ", $2 }')
check "fleet: spread and deviation are those of the truth" near 0.0003 "$printed" "$statistics"
outside=$(awk '/^      "serial"/ { serial = $2 } /"outside": \["/ { print serial, $2 }' "$work/fleet.json")
check "fleet: the outlier, and no other" [ "$outside" = '"D13", ["delta_y"]' ]
make_cal later --seed 99 "--offset=$(sed -n 7s/' .*'//p "$work/devices")" "--dk=0.02,0,0" -- --serial D7 --gravity 9.80665
run compare d*.json later.json
check "mixed: the device with a history is reported, too" matches "$work/stdout" '^serial D7: 2 calibrations, by the order of the files$'
tr '\n' ' ' < "$work/stdout" > "$work/line"
check "mixed: and both verdicts" matches "$work/line" \
    'Outliers, of [0-9]+ devices: serial .* Of 1 device with an earlier calibration 1 changed significantly: serial D7 \('
run compare d1.json d2.json
check "two devices are too few" matches "$work/stdout" '^Too few: Two devices are too few to identify an outlier\.$'
check "two devices are too few: what to do" matches "$work/stdout" '^Next: compare three devices or more; or, if both'
run compare d1.json d2.json d3.json
check "three are enough" matches "$work/stdout" '^Alike: None of 3 devices is an outlier\.$'
run compare month?.json d1.json d2.json
check "mixed: a slow drift is reported, too" matches "$work/stdout" '^Drifting: None of 3 devices is an outlier\. Of 1 device with an earlier calibration none has changed since that one, but since the first, 1 changed: serial 48 \(offset x\)\.$'
run compare month1.json month2.json d1.json
check "of two devices, one with a history" matches "$work/stdout" '^Steady: Two devices are too few .*none has changed'
accepts "--as fleet: of one serial number each its own" compare old.json middle.json new.json --as fleet --json
check "--as fleet: three devices" [ "$(grep -c '"calibrations"' "$work/stdout")" -eq 3 ]
run compare d1.json d2.json d3.json d2.json --as history --json
check "--as history: one device" [ "$(grep -c '"calibrations"' "$work/stdout")" -eq 1 ]
check "--as history: of several serial numbers: a warning" says 'warning: .*the files name 3 serial numbers: D1, D2, D3$'
check "--as history: no serial number is that of all" lacks "$work/stdout" '^      "serial"'
run compare d1.json d2.json d3.json --as history
check "--as history: the heading names all" matches "$work/stdout" '^serials D1, D2, D3: 3 calibrations,'
accepts "--as history: of one serial number: no warning" compare old.json middle.json --as history
accepts "--as history: with --quiet: no warning" compare d1.json d2.json --as history --quiet

# ---- pages -------------------------------------------------------------------------------------

accepts "page: of a history" compare old.json middle.json new.json --report page.html --quiet
check "page: nothing is printed" is_empty "$work/stdout"
check "page: it is well-formed" is_page page.html
check "page: what has changed" says_page '! Changed Offset x has changed significantly since 2026-03-01'
check "page: the drift and its 95 % interval" says_page 'offset x 327\.[0-9]+ [0-9.]+ \+(4\.9|5\.0)[0-9]* ± 0\.0[56][0-9]* mg \+[0-9.]+ changed'
run compare old.json middle.json new.json --json
printed=$(words | grep -o 'offset x 327\.[0-9]* [0-9.]* +[0-9.]* ± [0-9.]* mg' | sed -n 2p | awk '{ print $5 / 1000, $7 / 1000 }')
in_json=$(member delta | sed -n '5p;7p' | awk -F ', ' '{ printf "%s ", $1 }') # drift and interval of the second step
check "page: the drift and its 95 % interval are those of the JSON" near 6e-7 "$printed" "$in_json"
check "page: three pictures in both sizes" [ "$(grep -c "<title>[A-Z][a-z]* by calibration<" page.html)" -eq 6 ]
check "page: the command is shown" shows_command page.html invcal compare old.json middle.json new.json --report page.html --quiet
accepts "page: of a fleet" compare d*.json --report page.html --quiet
check "page: of a fleet: it is well-formed" is_page page.html
check "page: of a fleet: the outlier" says_page 'serial D13 offset y \+[0-9.]+ mg \+[0-9.]+'
marks() { sed -n '/<title>Distance of the devices from the median/,/<\/svg>/p' page.html | grep -c "$1"; }
check "page: of a fleet: a marker for each device and parameter" [ "$(marks 'c1 hollow') $(marks 'c2 full')" = "358 2" ]
printf old > "$work/out/cal.json"
refuses "page: not over an input" 2 '--report: would overwrite new.json' compare old.json new.json --report new.json
odd=$(printf '\033[31m<b>.json')
cp one.json "$odd"
run compare "$odd" other.json --report page.html
check "a name with an escape sequence does not reach the terminal" lacks "$work/stdout" "$(printf '\033')"
check "nor the page as markup" is_page page.html
run compare "$odd" other.json --json
check "in JSON it is escaped" matches "$work/stdout" '"file": "\\u001b\[31m<b>\.json"'

# ---- what cannot be compared ---------------------------------------------------------------------

"$tool" calibrate raw.csv --quiet --gravity 9.80665 --out fit.json
"$tool" calibrate raw.csv --quiet --gravity 9.80665 --frame triangular --out triangular.json
"$tool" calibrate raw.csv --quiet --gravity 9.80665 --unit mg --zero 0,0,0 --lsb 0.0006 --out milli.json
"$tool" calibrate raw.csv --quiet --gravity 1 --unit counts --out field.json
"$tool" calibrate raw.csv --quiet --gravity 9.81 --out elsewhere.json
together() { # SENTENCE PATTERN FILE
    refuses "refused: $1" 1 "$3: cannot be compared with fit\\.json: .*$2" compare fit.json "$3"
}
together "frames" 'frames are triangular and symmetric' triangular.json
together "units" 'readings are in mg and counts' milli.json
together "fields" 'fields are 1 and 9\.80665' field.json
accepts "another place on Earth is the same field" compare fit.json elsewhere.json
refuses "refused: but not with --same-field" 1 'the fields are 9\.81 and 9\.80665' compare fit.json elsewhere.json --same-field
run compare fit.json field.json --json
check "refused: as JSON, too" matches "$work/stdout" '"error": "not comparable"'
"$tool" simulate --plan edges --temperature 10,40 > "$work/warm.csv"
"$tool" calibrate warm.csv --quiet --gravity 9.80665 --thermal 1 --keep-all --out thermal.json
together "temperature" 'only one of them includes temperature' thermal.json
sed 's/"greatest": [0-9.]*/"greatest": 20/' thermal.json > cold.json
refuses "refused: temperatures that do not overlap" 1 'it holds from .* to 20 °C, and the other at' compare thermal.json cold.json
accepts "two with temperature are compared at one of them" compare thermal.json thermal.json
"$tool" simulate --plan grid:30:18 > "$work/raw.csv"
"$tool" calibrate raw.csv --quiet --gravity 9.80665 --quadratic --out bent.json
together "nonlinearity" 'includes nonlinearity' bent.json
for range in 2g:16384 4g:8192; do
    "$tool" simulate --plan edges --zero 0,0,0 --lsb "$(awk -v per=${range#*:} 'BEGIN { print 9.80665 / per }')" > raw.csv
    "$tool" calibrate raw.csv --quiet --sensor "mpu6050:${range%:*}" --serial 9 --out "mpu${range%:*}.json"
    "$tool" calibrate raw.csv --quiet --zero 0,0,0 --lsb "$(awk -v per=${range#*:} 'BEGIN { print 9.80665 / per }')" \
        --serial 9 --out "stated${range%:*}.json"
    "$tool" calibrate raw.csv --quiet --serial 9 --out "unstated${range%:*}.json"
done
"$tool" calibrate raw.csv --quiet --sensor mpu9250:4g --serial 9 --out other4g.json
refuses "refused: ranges" 1 'mpu4g\.json: cannot be compared with mpu2g\.json: they were made with --sensor mpu6050:4g and mpu6050:2g' \
    compare mpu2g.json mpu4g.json
refuses "refused: ranges, though not of the first file" 1 'mpu4g\.json: cannot be compared with mpu2g\.json: ' \
    compare unstated2g.json mpu2g.json mpu4g.json
refuses "refused: sensors" 1 'made with --sensor mpu9250:4g and mpu6050:4g' compare mpu4g.json other4g.json --as fleet
refuses "refused: stated scales" 1 'their nominal scales are 0\.00119[0-9]*,.* and 0\.000598' compare stated2g.json stated4g.json
refuses "refused: a stated scale and a sensor" 1 'stated4g\.json: cannot be compared with mpu2g\.json: their nominal' \
    compare unstated2g.json mpu2g.json stated4g.json
accepts "one range, stated in two ways" compare mpu4g.json stated4g.json
accepts "a nominal that is not stated is not refused" compare mpu4g.json unstated4g.json
"$tool" calibrate raw.csv --quiet --nominal mpu4g.json --serial 9 --out earlier4g.json
accepts "nor one that is an earlier calibration" compare stated4g.json earlier4g.json
sed '/"nominal"/,/}/s/"lsb": \[[^]]*\]/"lsb": [1e-9, 1e-9, 1e-9]/' earlier4g.json > turned4g.json
accepts "nor one whose axes may be others" compare stated4g.json turned4g.json
"$tool" calibrate raw.csv --quiet --zero 10,20,-30 --lsb 0.0011,0.0012,0.0013 --serial 9 --out factory4g.json
accepts "nor factory figures of each device" compare stated4g.json factory4g.json
refuses "refused: three without a serial" 2 'one\.json: has no serial number' compare one.json other.json third.json
refuses "refused: one without among others" 2 'one\.json: has no serial number' compare old.json one.json
refuses "refused: one file" 2 'a second CAL\.json is missing' compare old.json
refuses "refused: the standard input twice" 2 'only one input' compare - -
in=old.json
accepts "the standard input once" compare - middle.json
in=/dev/null
refuses "refused: an unknown --as" 2 '--as cousins: must be serial, history or fleet' compare old.json new.json --as cousins
"$tool" simulate --truth truth.json > /dev/null
refuses "refused: not a file of calibrate" 3 'truth\.json: the field or the frame is missing' compare truth.json old.json
refuses "refused: no such file" 3 'none\.json: cannot be read' compare old.json none.json
echo '{"offset": [1, 2, 3], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}' > bare.json
refuses "refused: a file without a field" 3 'the field or the frame is missing' compare bare.json bare.json

# ---- magnetometers -------------------------------------------------------------------------------

# waved NAME SEED OFFSET_X ARGUMENTS...: hard iron about x, uT
waved() {
    name=$1
    "$tool" simulate --magnetometer --seed "$2" --mag-offset "$3,-30,5" > waved.csv
    shift 3
    "$tool" calibrate --magnetometer waved.csv --quiet --out "$name.json" "$@"
}
waved first 1 12
waved again 2 12
waved moved 3 15
waved known 4 12 --gravity 48
waved there 5 12 --gravity 48.7
waved gauss 6 12 --gravity 0.48
accepts "magnetometers without --gravity" compare first.json again.json --report page.html
check "magnetometers without --gravity: nothing has changed" matches "$work/stdout" '^Steady: '
check "magnetometers: the page is well-formed" is_page page.html
run compare first.json moved.json
check "magnetometers: hard iron has changed by 3 of 48 uT" test "$(awk '/^offset x/ { d = $5 / 6.25; print (d > 0.8 && d < 1.2), $NF; exit }' "$work/stdout")" = "1 changed"
accepts "magnetometers: --gravity of another place" compare known.json there.json
refuses "magnetometers: one with, one without" 1 'only one of them was made with --gravity' compare first.json known.json
refuses "magnetometers: fields of other units" 1 'their fields are 0\.48 and 48' compare known.json gauss.json
together "a magnetometer and an accelerometer" "the readings are in" known.json

finish
