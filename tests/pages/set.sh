#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Makes the pages and pictures to check: set.sh path/to/invcal folder. Prints their names.
tool=$1
out=$2
here=$(dirname "$0")
data=$here/../data
mkdir -p "$out" || exit 2
set -e

calibrate() { # calibrate PAGE ARGUMENTS ...
    page=$out/$1.html
    shift
    "$tool" calibrate --quiet --report "$page" "$@"
    echo "$page"
}

# Real sensors: one with its maker's figures, one with positions as recorded, one that is weak.
calibrate xsens "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 \
    --zero 33123,33276,32360 --lsb 0.002409639,0.002421308,0.002409639 --nominal-name factory \
    --tolerance 0.02,0.005,0.02 --need 1mg
calibrate xsens-ins "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 --units ins \
    --zero 33123,33276,32360 --lsb 0.002409639,0.002421308,0.002409639 --tolerance 0.02,0.005,0.02
calibrate mpu9150 "$data/mpu9150_0_positions.csv" --positions --gravity 9.81 --unit m/s2
calibrate t265 "$data/t265_positions.csv" --positions --gravity 9.8016 --unit m/s2

# A log with two wrong positions and temperatures, and a prior for the sensor's errors.
"$tool" simulate --plan edges --outliers 2 --temperature 20,30 --tremor 0.003 > "$out/outliers.csv"
calibrate outliers "$out/outliers.csv" --sensor mpu6050 --noise 0.01 --prior 0.05,0.02,0.02
calibrate counts "$out/outliers.csv" # the same, in unknown units

# Angles of a stand: correct, one misset, exchanged columns, an open group.
for trouble in none misset columns open; do
    awk -v trouble=$trouble -v seed=1 -f "$here/../tool/random.awk" -f "$here/../tool/stand.awk" > "$out/stand-$trouble.csv"
done
sed -i 16q "$out/stand-open.csv"
at_stand() { calibrate "$@" --positions --stand --zero 0,0,0 --lsb 1 --noise 0.001; }
at_stand stand "$out/stand-none.csv"
at_stand stand-ins "$out/stand-none.csv" --units ins
at_stand stand-misset "$out/stand-misset.csv"
at_stand stand-columns "$out/stand-columns.csv" --stand-zero 12.5,-3
at_stand stand-open "$out/stand-open.csv"

# Temperature: lines with a wrong position, parabolas, no model at all, a log whose rests drift.
sensor() { # sensor STATIONS WRONG
    awk -v what=positions -v stations="$1" -v wrong="$2" -v seed=1 -v sigma=1e-4 \
        -f "$here/../tool/random.awk" -f "$here/../tool/thermal.awk" "$here/../reference/expected.h"
}
sensor -20,25,70 23 > "$out/chamber.csv"
calibrate thermal "$out/chamber.csv" --positions --thermal 1 --unit g --latitude 48.1 --height 520
calibrate parabolas "$out/chamber.csv" --positions --thermal 2 --unit g --units ins
calibrate unasked "$out/chamber.csv" --positions --unit g
sensor 25,25.5 0 > "$out/room.csv"
calibrate no-slopes "$out/room.csv" --positions --thermal 1 --unit g
"$tool" simulate --plan optimal:48 --temperature 10,20 --drift 0.001 --dwell 8 --noise 0.0028 \
    > "$out/drift.csv"
calibrate warming "$out/drift.csv" --thermal 1
calibrate warming-prior "$out/drift.csv" --thermal 1 --noise 0.02 --slope 0.01,0.001,0.001

# As many positions as parameters; 2000; another field; a name with special characters.
"$tool" simulate --plan optimal:9 > "$out/nine.csv"
calibrate nine "$out/nine.csv"
"$tool" simulate --plan faces > "$out/faces.csv"
calibrate six-faces "$out/faces.csv" --six-faces --zero 0,0,0 --lsb 0.000598550415
awk -v family=sphere -v count=2000 -v seed=7 -f "$here/../tool/random.awk" -f "$here/../tool/positions.awk" > "$out/many.csv"
calibrate many "$out/many.csv" --positions
awk -F, 'NR > 1 { print $1 / 300, $2 / 300, $3 / 300 }' "$data/xsens_mti_positions.csv" > "$out/mag.txt"
calibrate magnetometer "$out/mag.txt" --positions --gravity 48.5
calibrate record "$out/nine.csv" --device 'MTi "<10>"' --serial 47 --operator Jürgen --date 2026-11-23 --note 'on the bench'
odd="$out/<b onclick=x>&\"' a-very-long-name-without-any-place-to-break-it-in-two-lines-of-a-phone.csv"
cp "$out/nine.csv" "$odd"
calibrate hostile "$odd" --nominal-name '<i>&"'

# Refusals: six faces, a plane, no rest, drifting temperatures, a wrong unit.
refused() { # refused PAGE ARGUMENTS ...
    page=$out/refused-$1.html
    shift
    if "$tool" calibrate --quiet --report "$page" "$@" 2> /dev/null; then false; fi
    echo "$page"
}
"$tool" simulate --plan faces > "$out/faces.csv"
refused faces "$out/faces.csv" --need 1mg --out "$out/none.json"
awk -v family=plane -v count=18 -v seed=4 -f "$here/../tool/random.awk" -f "$here/../tool/positions.awk" > "$out/plane.csv"
refused plane "$out/plane.csv" --positions
"$tool" simulate --plan edges --dwell 0.5 --move 0.5 > "$out/restless.csv"
refused restless "$out/restless.csv"
"$tool" simulate --plan edges --temperature 10,40 --drift 0.001 > "$out/drifting.csv"
refused drift "$out/drifting.csv" --thermal 1
refused unit "$data/xsens_mti_positions.csv" --positions --unit g

for set in per-group:6 optimal:48; do
    picture=$out/directions-$(echo "$set" | tr : -).svg
    "$tool" plan "--${set%:*}" "${set#*:}" --svg "$picture" > /dev/null
    echo "$picture"
done
"$tool" plan --sweep 5:16 --svg "$out/sweep.svg" > /dev/null
echo "$out/sweep.svg"

allan() { # allan PAGE ARGUMENTS ...
    page=$out/allan-$1.html
    shift
    "$tool" allan --quiet --report "$page" "$@"
    echo "$page"
}

# Noise: only white, with a floor, a sigma that is out of reach; in unknown units.
echo 0 0 1 > "$out/up.txt"
rest="simulate --plan directions:$out/up.txt --dwell 1000"
# shellcheck disable=SC2086
"$tool" $rest > "$out/white.csv"
# shellcheck disable=SC2086
"$tool" $rest --instability 0.001 > "$out/walk.csv"
allan white "$out/white.csv" --lsb 0.000598550415 --sigma 0.0005 --out "$out/noise.json"
allan walk "$out/walk.csv" --lsb 0.000598550415
allan beyond "$out/walk.csv" --lsb 0.000598550415 --sigma 0.000001
allan counts "$out/white.csv" --tau 0.01,0.1,1,10

plan() { # plan PAGE ARGUMENTS ...
    page=$out/plan-$1.html
    shift
    "$tool" plan --quiet --report "$page" "$@"
    echo "$page"
}

# Programs: the paper's, one with noise and odd angles, a choice, one that is too large, a bad one.
plan paper
plan noise --per-group 7 --noise 0.0001
plan choice --limits 0.4,0.6,1 --noise 0.0001 --budget 600
plan many --per-group 1000
printf '%s\n' '1 0 10' '9 3 3' '8 6 0' '7 0 7' '6 8 1' '5 5 7' '3 3 9' '9 4 0' '2 8 5' '-1 0 9' \
    '0 9 -1' > "$out/cap.txt"
plan weak --directions "$out/cap.txt"
plan sweep --sweep 5:16
plan labour --limits 0.00002,0.00002,0.00005 --settle 1 --allan "$out/noise.json" --svg "$out/labour.svg"
echo "$out/labour.svg"
plan comparison --compare per-group:8 per-group:6 --svg "$out/comparison.svg"
echo "$out/comparison.svg"
plan far-apart --compare per-group:1000 optimal:9
plan turns --moves tour16
plan turns-guided --moves greedy31 --units ins
if "$tool" plan --quiet --report "$out/plan-turns-open.html" --moves x:90,x:90,+x+y+z 2> /dev/null; then false; fi
echo "$out/plan-turns-open.html"

# Comparisons: a history of three, a fleet with an outlier, two that are alike.
for k in 1 2 3 4 5 6 7 8 9; do
    "$tool" simulate --plan edges --seed $k --offset "0.0$((k * k % 7 + 1)),0,0.$((k / 9 * 2))3" --zero 20000,20000,20000 \
        --lsb 0.0012 > "$out/fleet.csv"
    "$tool" calibrate "$out/fleet.csv" --quiet --serial "47-$k" --device 'ADXL355 "<A>"' --date "2026-0$k-01" \
        --out "$out/fleet-$k.json"
done
compare() { # compare PAGE ARGUMENTS ...
    page=$out/compare-$1.html
    shift
    "$tool" compare --quiet --report "$page" "$@"
    echo "$page"
}
compare history "$out/fleet-1.json" "$out/fleet-2.json" "$out/fleet-3.json" --as history --same-field
compare fleet "$out"/fleet-?.json
compare fleet-ins "$out"/fleet-?.json --units ins
compare same "$out/fleet-1.json" "$out/fleet-1.json"
