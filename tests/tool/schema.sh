#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Checks all JSON of the tool against port/host/schema.json: schema.sh path/to/invcal builddir
# Needs Debian's python3-jsonschema, so it is not part of `make test`. Prints a line for each check.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
schema=$here/../../port/host/schema.json
python=/usr/bin/python3
"$python" -c 'import jsonschema' 2> /dev/null ||
    { echo "python3-jsonschema is not installed: make deps" >&2; exit 1; }

fits() { # fits OBJECT FILE [SCHEMA]
    "$python" "$here/../schema.py" "${3:-$schema}" "$1" "$2"
}

misfits() {
    ! fits "$@" 2> "$work/why" && [ -s "$work/why" ]
}

is_object() { # CODE OBJECT: the tool ended with this code, and printed this
    [ "$code" -eq "$1" ] && fits "$2" "$work/stdout"
}

prints() { # prints CODE OBJECT ARGUMENTS ...
    expected=$1
    object=$2
    shift 2
    run "$@" --json
    check "$* is a $object" is_object "$expected" "$object"
}

is_schema() {
    "$python" "$here/../schema.py" "$1"
}

is_no_schema() {
    ! is_schema "$1" 2> "$work/why" && grep -q SchemaError "$work/why"
}

check "the schema is one" is_schema "$schema"
sed 's/"type": "object"/"type": "thing"/' "$schema" > "$work/lax.json"
check "refused: a schema with a type that does not exist" is_no_schema "$work/lax.json"

# ---- calibrations ------------------------------------------------------------------------------

xsens=$data/xsens_mti_positions.csv
prints 0 calibration calibrate "$xsens" --positions --gravity 9.81744 --out "$work/saved.json"
check "the file of --out is a calibration" fits calibration "$work/saved.json"
for file in "$here"/../reference/releases/*-calibration.json "$here"/../reference/releases/*-thermal.json; do
    check "${file##*/} of an earlier release is one" fits calibration "$file"
done
cp "$work/saved.json" "$work/good.json"
prints 0 calibration calibrate "$xsens" --positions --nominal "$work/saved.json" --frame triangular
prints 0 calibration calibrate "$data/t265_positions.csv" --positions --gravity 9.8016
printf '%s\n' 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0,-1 .7,.7,0 .7,0,.7 0,.7,.7 > "$work/nine.csv"
prints 0 calibration calibrate "$work/nine.csv" --positions --gravity 1
prints 0 calibration calibrate "$xsens" --positions --zero 33123,33276,32360 --lsb 0.0024 \
    --noise 0.01 --prior 0.1,0.1,0.1
"$tool" simulate --plan faces > "$work/faces.csv"
prints 0 calibration calibrate "$work/faces.csv" --six-faces
prints 1 calibration_refusal calibrate "$work/faces.csv"
awk 'BEGIN { print "mx,my,mz"; for (i = 0; i < 3000; i++) { a = i / 40; b = 0.73 * i / 100
    print 5 + 40 * sin(a) * cos(b) "," 40 * sin(a) * sin(b) "," 40 * cos(a) } }' > "$work/waved.csv"
prints 0 calibration calibrate "$work/waved.csv" --magnetometer
awk 'BEGIN { print "ax,ay,az,mx (uT),my (uT),mz (uT)"; for (i = 0; i < 3000; i++) { t = i / 50; a = 2 * t; b = 0.73 * t; c = 0.31 * t
    x = sin(a) * cos(b); y = sin(a) * sin(b); z = cos(a)
    u = -sin(b) * cos(c) - cos(a) * cos(b) * sin(c); v = cos(b) * cos(c) - cos(a) * sin(b) * sin(c); w = sin(a) * sin(c)
    print x "," y "," z "," 24 * u - 41 * x "," 24 * v - 41 * y "," 24 * w - 41 * z } }' > "$work/both.csv"
prints 0 calibration calibrate "$work/both.csv" --magnetometer --frame accelerometer
prints 0 calibration watch "$work/both.csv" --magnetometer
sed '1!s/^/5/' "$work/both.csv" > "$work/uneven.csv"
prints 0 calibration calibrate "$work/uneven.csv" --magnetometer
prints 1 calibration_refusal calibrate "$work/uneven.csv" --magnetometer --frame accelerometer
head -n 200 "$work/waved.csv" > "$work/short.csv"
prints 1 calibration_refusal calibrate "$work/short.csv" --magnetometer
"$tool" simulate --plan edges --outliers 2 --truth "$work/truth.json" > "$work/log.csv"
prints 0 calibration calibrate "$work/log.csv"
prints 0 calibration watch "$work/log.csv"
prints 0 calibration calibrate "$work/log.csv" --sensor mpu6050
prints 0 calibration calibrate "$work/log.csv" --robust
"$tool" simulate --plan per-group:6 --stand > "$work/stand.csv"
prints 0 calibration calibrate "$work/stand.csv" --stand
check "the file of --truth is a truth" fits truth "$work/truth.json"
"$tool" simulate --gyro --dwell 3 --plan edges --truth "$work/truth.json" > "$work/gyro.csv"
prints 0 calibration calibrate "$work/gyro.csv"
head -n 3500 "$work/gyro.csv" > "$work/short.csv"
prints 1 calibration_refusal calibrate "$work/short.csv"
check "the file of --truth with a gyroscope is a truth" fits truth "$work/truth.json"
"$tool" simulate --gyro --gyro-g 0,0,0,-0.15,0,0,0,0,0 --dwell 3 --plan per-group:8 --truth "$work/truth.json" > "$work/gyro.csv"
prints 0 calibration calibrate "$work/gyro.csv"
check "its g-sensitivity is there" grep -q '"g_correction"' "$work/stdout"
check "the file of --truth with a g-sensitivity is a truth" fits truth "$work/truth.json"
"$tool" simulate --magnetometer --truth "$work/truth.json" > "$work/waved.csv"
check "the file of --truth with a magnetometer is a truth of one" fits waved_truth "$work/truth.json"
prints 0 calibration calibrate "$work/gyro.csv" --gyro-axes y,x,z

sensor() { # sensor STATIONS
    awk -v what=positions -v stations="$1" -v seed=1 -v sigma=1e-4 -f "$here/random.awk" -f "$here/thermal.awk" \
        "$here/../reference/expected.h"
}
sensor -20,25,70 > "$work/thermal.csv"
for degree in 1 2; do
    prints 0 calibration calibrate "$work/thermal.csv" --positions --thermal $degree
done
sensor 25,25 > "$work/thermal.csv"
prints 0 calibration calibrate "$work/thermal.csv" --positions --thermal 1 --gravity 1
"$tool" simulate --temperature 10,90 > "$work/drift.csv"
prints 1 calibration_refusal calibrate "$work/drift.csv" --thermal 1

for trouble in none misset many swapped reversed zero; do
    awk -v trouble=$trouble -v seed=1 -f "$here/random.awk" -f "$here/stand.awk" > "$work/stand.csv"
    prints 0 calibration calibrate "$work/stand.csv" --positions --stand
done
prints 0 calibration calibrate "$work/stand.csv" --positions --plan per-group:6 --frame stand
prints 0 calibration calibrate "$work/stand.csv" --positions --quadratic
prints 0 calibration calibrate "$work/stand.csv" --positions --cubic --noise 0.001
prints 0 calibration calibrate "$work/stand.csv" --positions --robust
awk 'NR <= 14' "$work/stand.csv" > "$work/fourteen.csv"
prints 1 calibration_refusal calibrate "$work/fourteen.csv" --positions --quadratic

prints 1 calibration_refusal calibrate "$work/nine.csv"
head -n 3 "$work/nine.csv" > "$work/three.csv"
prints 1 calibration_refusal calibrate "$work/three.csv" --positions
awk 'BEGIN { for (i = 0; i < 18; i++) print cos(i / 2.9) "," sin(i / 2.9) "," 0 }' > "$work/flat.csv"
prints 1 calibration_refusal calibrate "$work/flat.csv" --positions --gravity 1 --zero 0,0,0 --lsb 1
awk "$random_awk"'BEGIN { begin_random(1); for (i = 0; i < 18; i++) print uniform() "," uniform() "," i % 3 * uniform() }' \
    > "$work/noise.csv"
prints 1 calibration_refusal calibrate "$work/noise.csv" --positions --gravity 1
prints 1 calibration_refusal calibrate "$xsens" --positions --unit g
sed '2s/.*/1e200,1,1/' "$work/nine.csv" > "$work/huge.csv"
prints 1 calibration_refusal calibrate "$work/huge.csv" --positions --zero 0,0,0 --lsb 1 --gravity 1

# ---- records, lines, comparisons ---------------------------------------------------------------

is_line() { # CODE OBJECT
    [ "$(wc -l < "$work/stdout")" -eq 1 ] && is_object "$@"
}
line() { # line CODE OBJECT ARGUMENTS ...
    expected=$1
    object=$2
    shift 2
    run calibrate "$@" --json-lines
    check "calibrate $* --json-lines is a $object on a line" is_line "$expected" "$object"
}
line 0 calibration "$xsens" --positions --device MTi --serial 47 --operator Jürgen --date 2026-11-23 --note '"new"'
line 1 calibration_refusal "$work/three.csv" --positions
line 3 calibration_refusal "$work/none.csv"
for k in 1 2 3 4; do
    "$tool" calibrate "$xsens" --positions --gravity 9.81744 --serial $((k / 2)) --date 2026-11-2$k --quiet \
        --out "$work/file$k.json"
done
check "the file of --out with a record is a calibration" fits calibration "$work/file1.json"
prints 0 comparison compare "$work/file2.json" "$work/file3.json"
prints 0 comparison compare "$work"/file?.json
prints 0 comparison compare "$work"/file?.json --as history
"$tool" calibrate "$work/nine.csv" --positions --gravity 9.81744 --quiet --unit counts --out "$work/blind.json"
prints 0 comparison compare "$work/file1.json" "$work/blind.json" --as history
"$tool" calibrate "$xsens" --positions --frame triangular --quiet --out "$work/turned.json"
prints 1 comparison_refusal compare "$work/file1.json" "$work/turned.json" --as fleet

# ---- noise -------------------------------------------------------------------------------------

echo 0 0 1 > "$work/up.txt"
"$tool" simulate --plan "directions:$work/up.txt" --dwell 60 > "$work/rest.csv"
prints 0 allan allan "$work/rest.csv" --out "$work/noise.json"
check "the file of --out is a noise" fits allan "$work/noise.json"
prints 0 allan allan "$work/rest.csv" --lsb 0.0006 --sigma 0.001 --apart
prints 0 allan allan "$work/rest.csv" --lsb 0.0006 --sigma 1e-9
prints 0 allan allan "$work/rest.csv" --lsb 0.003 --gravity 48.5

# ---- plans -------------------------------------------------------------------------------------

for set in '' '--per-group 7' '--per-group 8 --start 0,10,20 --noise 0.0001' --edges --icosahedron \
    '--optimal 9' '--optimal 20 --limits 1,1,1' '--limits 0.4,0.6,1' '--budget 120' \
    '--limits 0.001,0.001,0.001 --noise 0.001 --budget 300'; do
    # shellcheck disable=SC2086
    prints 0 plan plan $set
done
for set in --stand-12 --stand-24 '--optimal 12 --grid 30' '--edges --weights' '--weights --bound 0.001' \
    '--optimal 12 --need-axes --warm-up 600 --settle 2' '--limits 0.5,0.8,2 --spare 5 --need-axes'; do
    # shellcheck disable=SC2086
    prints 0 plan plan $set
done
prints 0 plan_programs plan --programs
prints 0 plan_programs plan --programs --noise 0.0001 --warm-up 600
"$tool" plan --edges --weights --csv > "$work/stand.csv"
prints 0 plan plan --angles "$work/stand.csv"
prints 0 plan plan --directions "$work/nine.csv"
prints 1 plan_refused plan --faces
prints 1 plan_refused plan --directions "$work/three.csv"
prints 1 plan_refusal plan --per-group 4
prints 1 plan_refusal plan --limits 1e-5,1e-5,1e-5
prints 1 plan_refusal plan --budget 10
prints 1 plan_refusal plan --compare faces edges
prints 0 allan allan "$work/rest.csv" --lsb 0.0006 --out "$work/noise.json"
prints 0 plan plan --limits 0.0001,0.0001,0.0002 --allan "$work/noise.json" --settle 1
prints 1 plan_refusal plan --limits 1e-9,1e-9,1e-9 --allan "$work/noise.json"
prints 0 plan_sweep plan --sweep 5:9
prints 0 plan_comparison plan --compare edges per-group:6
prints 0 plan_comparison plan --compare edges optimal:18 --noise 0.001
prints 0 plan_moves plan --moves tour12
prints 0 plan_moves plan --moves greedy24 --noise 0.001 --rate-noise 0.01
prints 1 plan_moves plan --moves x:90,x:90

prints 0 calibration calibrate "$xsens" --positions --zero 33123,33276,32360 --lsb 0.0024 --need 1mg \
    --tolerance 0.02,0.005,0.02
prints 0 calibration calibrate "$work/nine.csv" --positions --gravity 1 --zero 0,0,0 --lsb 1 --tolerance 0.4,0.4,0.4 --need 0.1

# ---- what must not pass ------------------------------------------------------------------------

planted() { # planted SENTENCE SED: a calibration that was good, with a mistake
    sed "$2" "$work/good.json" > "$work/bad.json"
    check "refused: $1" misfits calibration "$work/bad.json"
}
planted "a surplus member" 's/"gravity"/"extra": 1, &/'
planted "a missing member" '/"condition"/d'
planted "a misspelt verdict" 's/"verdict": "[a-z ]*"/"verdict": "fine"/'
planted "a number that is NaN" 's/"gravity": [0-9.]*/"gravity": NaN/'
planted "a duplicate member" 's/"frame"/"suspected": 0, &/'
planted "a name in a list that is not a parameter" 's/"undetermined": \[/&"delta_w"/'
check "refused: a refusal in place of a calibration" misfits calibration_refusal "$work/good.json"
sed '0,/"additionalProperties": false/s//"additionalProperties": true/' "$schema" > "$work/lax.json"
check "refused: a schema that lets a misspelt member pass" misfits calibration "$work/good.json" \
    "$work/lax.json"

finish
