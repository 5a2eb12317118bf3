#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Temperature: thermal_test.sh path/to/invcal builddir. Prints a line for each check and a count.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
reference=$here/../reference/expected.h

expected() { # expected NAME: its numbers
    awk -v what="$1" -f "$here/random.awk" -f "$here/thermal.awk" "$reference"
}

sensor() { # sensor STATIONS SEED [WRONG]: position means, noise 1e-4 g
    awk -v what=positions -v stations="$1" -v seed="$2" -v wrong="${3:-0}" -v sigma=1e-4 \
        -f "$here/random.awk" -f "$here/thermal.awk" "$reference"
}

# Zero 0 and scale 1, so that the results are the sensor's errors.
fit() { # fit FILE ARGUMENTS ...
    file=$1
    shift
    run calibrate "$file" --positions --gravity 1 --zero 0,0,0 --lsb 1 "$@"
}

inside() { # inside FILE OBJECT NAME: a member of an object in the outermost one
    sed -n "/^  \"$2\": {/,/^  }/s/^    \"$3\": \(.*[^,]\),*\$/\1/p" "$1"
}

# Mean square of |a| - 1 over a table with a header.
mean_square() {
    awk -F, 'NR > 1 { r = sqrt($1 * $1 + $2 * $2 + $3 * $3) - 1; s += r * r }
        END { printf "%.9g\n", s / (NR - 1) }' "$1"
}

below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }
prints() { matches "$work/stdout" "$1"; }
warns() { [ "$code" -eq 0 ] && says "$1" || complain; }

# ---- 18 positions at each of -20, 25 and 70 degrees ---------------------------------------------

# Errors in all directions at -15 ... 65 degrees, of 25 draws; 2 (25) 18 degrees of freedom: 3 %.
awk -v what=grid -f "$here/random.awk" -f "$here/thermal.awk" "$reference" > "$work/grid.csv"
truth=$(expected thermal_slope | cut -d ' ' -f 1-9)
seed=0
: > "$work/errors"
: > "$work/slopes"
while [ $((seed += 1)) -le 25 ]; do
    sensor -20,25,70 $seed > "$work/positions.csv"
    fit "$work/positions.csv" --thermal 1 --out "$work/thermal.json" --json
    fit "$work/positions.csv" --keep-all --out "$work/nine.json" --quiet
    "$tool" apply "$work/thermal.json" "$work/grid.csv" > "$work/with.csv"
    "$tool" apply "$work/nine.json" "$work/grid.csv" > "$work/without.csv"
    echo "$(mean_square "$work/with.csv") $(mean_square "$work/without.csv") \
        $(json "$work/thermal.json" rejected)" >> "$work/errors"
    for kind in delta dk gamma; do # per K: "slope", and behind it "slope_sigma"
        sed -n "/\"slope\"/,\$s/^      \"$kind\": \[\(.*\)\].*/\1/p" "$work/thermal.json" | tr -d , |
            tr '\n' ' '
    done >> "$work/slopes"
    echo >> "$work/slopes"
done
bound=$(expected thermal_bound | cut -d ' ' -f 1)
over=$(awk -v bound="$bound" '{ s += $1 } END { print sqrt(s / NR) / bound / 1e-4 }' "$work/errors")
nine=$(awk -v bound="$bound" '{ s += $2 } END { print sqrt(s / NR) / bound / 1e-4 }' "$work/errors")
check "the error over the range is the bound of 18 parameters, times $over" near 0.1 "$over" 1
check "nine parameters leave hundreds of it: $nine" below 300 "$nine"
check "no good position is left out" lacks "$work/errors" '[1-9][0-9]*\]'
spread=$(awk -v truth="$truth" 'BEGIN { split(truth, t, " ") } {
        for (k = 0; k < 3; k++) for (i = 1; i <= 3; i++) {
            z = ($(6 * k + i) - t[3 * k + i] / 45) / $(6 * k + 3 + i)
            s += z * z
            n++
        }
    } END { print sqrt(s / n) }' "$work/slopes")
check "slopes differ from the truth by their sigma, times $spread" near 0.12 "$spread" 1
fit "$work/positions.csv" --thermal 1
check "the table has the slopes" prints '^scale x +\+[45][0-9.]+ ± [0-9.]+ +ppm/K'
check "and the nine parameters with them" prints \
    'Nine parameters without temperature leave an rms of [34]\.[0-9]+ % of the field .* [3-5][0-9][0-9] times'
fit "$work/positions.csv" --thermal 2 --json
check "parabolas are fitted on request" near 0 "$(inside "$work/stdout" thermal degree)" 2
check "with three rows of coefficients" near 0 "$(grep -c '^        "gamma"' "$work/stdout")" 3

# ---- what contradicts ---------------------------------------------------------------------------

for wrong in 5 23 54; do
    sensor -20,25,70 $wrong $wrong > "$work/wrong.csv"
    fit "$work/wrong.csv" --thermal 1 --out "$work/thermal.json"
    check "position $wrong of 54 is wrong, and left out" prints "^Left out: position $wrong \\("
    check "and no other" near 0 "$(json "$work/thermal.json" rejected)" "$wrong"
done
sensor -20,25,70 9 4,5,40 > "$work/three.csv"
fit "$work/three.csv" --thermal 1 --json
check "three that are wrong do not hide one another" near 0 "$(json "$work/stdout" rejected)" 4,5,40
# All by the same length: the error of each is relative to the good ones, not to the other two.
fit "$work/three.csv" --thermal 1
check "and the error of each is reported" near 0.05 \
    "$(sed -n 's/^Left out: .*off by \([0-9.-]*\) % of the field$/\1/p' "$work/stdout" | tr '\n' ' ')" \
    5,5,5
fit "$work/wrong.csv" --thermal 1 --keep-all --json
check "--keep-all keeps it" lacks "$work/stdout" '"rejected": \[.+\]'

# ---- without slopes -----------------------------------------------------------------------------

falls_back() { # STATIONS REASON
    sensor "$1" 7 > "$work/few.csv"
    fit "$work/few.csv" --thermal 1 --out "$work/few.json"
    [ "$code" -eq 0 ] && prints "No slopes instead of straight lines: $2" &&
        near 0 "$(inside "$work/few.json" thermal degree)" 0 &&
        matches "$work/few.json" "\"fallback\": \"$2" || complain
}
check "at one temperature there are no slopes, and it says why" falls_back 25,25,25 'too narrow a range'
check "nor at two half a kelvin apart" falls_back 25,25.5 'too narrow a range'
sensor 20,40 7 | awk 'NR <= 9 || (NR > 28 && NR <= 37)' > "$work/seventeen.csv"
fit "$work/seventeen.csv" --thermal 1
check "nor from seventeen positions" prints 'No slopes instead of straight lines: too few positions'
sensor 20,40 7 > "$work/two.csv"
fit "$work/two.csv" --thermal 2
check "two temperatures determine straight lines, but no parabola" prints \
    'Straight lines instead of parabolas: positions and temperatures leave slopes open'
sensor 0,40 7 | awk -F, 'NR <= 19 || NR > 35' > "$work/open.csv"
fit "$work/open.csv" --thermal 1
check "missing slopes limit the accuracy" prints '^limited by    temperature: the slopes are not fitted'
check "without slopes over a range the result is weak, and it says what helps" prints \
    '^Next: measure nine positions or more at each of two temperatures'
sensor 25,25 7 > "$work/one.csv"
fit "$work/one.csv" --thermal 1 --noise 0.0001 --slope 0.001,0.0005,0.0001 --json
check "a prior on slopes gives their sigma" near 5e-5 0.001,0.001,0.001 \
    "$(sed -n '/"slope_sigma"/,$s/^      "delta": \(.*[^,]\),*$/\1/p' "$work/stdout")"

# ---- apply --------------------------------------------------------------------------------------

sensor -20,25,70 3 > "$work/positions.csv"
fit "$work/positions.csv" --thermal 1 --out "$work/thermal.json" --quiet
at() { printf 'x,y,z,temperature\n0.1,-0.2,0.9,%s\n' "$1" > "$work/at.csv"; }
at 70
accepts "the edge of the range is in it" apply "$work/thermal.json" "$work/at.csv"
sed 's/,70$//' "$work/stdout" > "$work/edge.csv"
at 150
run apply "$work/thermal.json" "$work/at.csv"
check "80 K outside is reported in one line" warns '1 of 1 readings are up to 80 K outside -20 ... 70 °C'
sed 's/,150$//' "$work/stdout" > "$work/outside.csv"
check "and corrected as at the edge" same "$work/edge.csv" "$work/outside.csv"
at -21.5
run apply "$work/thermal.json" "$work/at.csv"
check "colder, too" warns 'up to 1.5 K outside'
at 70.8
accepts "within 1 % of the range beyond its edge there is no warning" apply "$work/thermal.json" "$work/at.csv"
sed 's/,70\.8$//' "$work/stdout" > "$work/outside.csv"
check "and corrected as at the edge" same "$work/edge.csv" "$work/outside.csv"
at 71
run apply "$work/thermal.json" "$work/at.csv"
check "beyond that there is a warning" warns '1 of 1 readings are up to 1 K outside'
# Two logs of rests at two temperatures, and a thermometer with a noise of 0.03 K.
for degrees in 20 40; do
    "$tool" simulate --plan optimal:18 --seed $degrees --temperature $degrees,$degrees --drift 0.0005
done | awk -F, -v OFS=, '
    /^t/ { if (NR == 1) print; base = last; next }
    { n = (n * 16807 + 1) % 2147483647; $5 = sprintf("%.3f", $5 + 0.104 * (n / 2147483647 - 0.5))
      last = base + $1 + 0.01; $1 = sprintf("%.2f", base + $1); print }' > "$work/own.csv"
run calibrate "$work/own.csv" --thermal 1 --out "$work/own.json"
check "a log at two temperatures determines slopes" matches "$work/own.json" '"degree": 1'
accepts "applied to itself it gives no warning" apply "$work/own.json" "$work/own.csv"
printf 'x,y,z\n0.1,-0.2,0.9\n' > "$work/bare.csv"
refuses "a log without temperature is refused" 3 'needs a column of temperature.*--temperature' \
    apply "$work/thermal.json" "$work/bare.csv"
# The same temperature in other units: 70 °C.
for unit in '(K) 343.15' '[°F] 158' '(m°C) 70000' '(degC) 70'; do
    printf 'x,y,z,temperature %s\n0.1,-0.2,0.9,%s\n' "${unit% *}" "${unit#* }" > "$work/unit.csv"
    accepts "a temperature in ${unit% *}" apply "$work/thermal.json" "$work/unit.csv"
    check "is converted to °C" near 1e-9 "$(tail -n 1 "$work/edge.csv"),70" "$(tail -n 1 "$work/stdout")"
done
for unit in temperature_raw 'temperature (counts)'; do
    printf 'x,y,z,%s\n0.1,-0.2,0.9,70\n' "$unit" > "$work/unit.csv"
    refuses "counts are no temperature: $unit" 3 'needs a column of temperature in °C' \
        apply "$work/thermal.json" "$work/unit.csv"
done
printf 'x,y,z\n0.1,-0.2\n' > "$work/torn.csv"
refuses "of a row that is wrong, too, one thing is said" 3 'torn.csv:2: 2 columns' \
    apply "$work/thermal.json" "$work/torn.csv"
accepts "unless one is stated" apply "$work/thermal.json" "$work/bare.csv" --temperature 70
sed 's/,temperature$//; s/,70$//' "$work/edge.csv" > "$work/expected.csv"
check "which does the same as the column" same "$work/expected.csv" "$work/stdout"
refuses "a calibration without slopes has no use for one" 2 '--temperature: .*--thermal' \
    apply "$work/nine.json" "$work/bare.csv" --temperature 70
# Between two temperatures: a log in which each line has its own.
sed -n '1p; 2,55{p;}' "$work/positions.csv" | awk -F, 'NR == 1 { print; next }
    { line[++n] = $0 } END { for (i = 0; i < n; i++) print line[1 + 19 * i % n] }' > "$work/mixed.csv"
run apply "$work/thermal.json" "$work/mixed.csv"
mv "$work/stdout" "$work/mixed.out"
check "every reading is corrected at its own temperature" below "$(mean_square "$work/mixed.out")" 4e-8
for damage in 's/"span": [0-9.]*/"span": 0/' '/"least"/d' 's/"degree": 1/"degree": 2/' \
    's/"span"/"spam"/' '/"coefficients"/,/"gamma"/s/"dk"/"kd"/'; do
    sed "$damage" "$work/thermal.json" > "$work/damaged.json"
    refuses "a damaged one is refused: $damage" 3 '"thermal" is incomplete' \
        apply "$work/damaged.json" "$work/at.csv"
done

# ---- other commands read the file, too ----------------------------------------------------------

run export "$work/thermal.json" --format c-arrays
check "export says at which temperature it holds" warns 'terms are not exported; .* 25 °C'
run calibrate "$work/positions.csv" --positions --gravity 1 --nominal "$work/thermal.json"
check "it may be the nominal" succeeded

# ---- logs ---------------------------------------------------------------------------------------

"$tool" simulate --plan per-group:12 --temperature 10,40 --drift 0.001 --dwell 8 --noise 0.002 \
    --truth "$work/truth.json" > "$work/warm.csv"
run calibrate "$work/warm.csv" --thermal 1
check "rests in which the temperature drifts are left out; none is left" was_refused 1 \
    'drifted by more than 0.[0-9]+ K in 36 of 36 rests.*--keep-all'
run calibrate "$work/warm.csv" --thermal 1 --json
check "the same as JSON" matches "$work/stdout" '"error": "too few"'
run calibrate "$work/warm.csv" --thermal 1 --keep-all --zero 0,0,0 --lsb 0.000598550415 --json
check "--keep-all takes them" near 1e-4 0.001,0.001,0.001 \
    "$(sed -n '/"slope"/,/"dk"/s/^      "delta": \(.*[^,]\),*$/\1/p' "$work/stdout")"

# A thermometer that is read to 0.1 K, and noisy, at rest; in rest 5 it moves by 1 K.
"$tool" simulate --plan edges --dwell 5 --truth "$work/truth.json" > "$work/log.csv"
awk -F, -v OFS=, 'NR == 1 { print $0, "temperature"; next } {
        leg = int($1 / 7)
        warm = leg == 4 ? ($1 - 28) / 5 : 0
        printf "%s,%.1f\n", $0, (leg < 9 ? 20 : 35) + 0.3 * (NR % 7 - 3) / 3 + (warm < 1 ? warm : 0)
    }' "$work/log.csv" > "$work/steps.csv"
run calibrate "$work/steps.csv" --thermal 1 --out "$work/steps.json"
check "one rest in which it drifts is left out and named" prints '^ +position 5 \(line [0-9]+\), by 0.[89]'
check "noise of the thermometer is not drift" near 0 "$(json "$work/steps.json" rejected)" 5
run watch "$work/steps.csv" --thermal 1 --json
check "watch finds the same" same "$work/stdout" "$work/steps.json"

# ---- what it says without --thermal -------------------------------------------------------------

fit "$work/positions.csv"
check "residuals that depend on temperature are reported" prints \
    'The residuals depend on temperature .*offset . drifts by'
check "and limit the accuracy" prints '^limited by    temperature, which --thermal'
sensor 25,25,25 3 | awk -F, -v OFS=, 'NR == 1 { print; next } { print $1, $2, $3, 20 + 10 * int((NR - 2) / 18) }' \
    > "$work/calm.csv"
fit "$work/calm.csv"
check "and so are those that do not" prints 'do not depend on temperature.*--thermal'
fit "$work/one.csv"
check "and if it cannot be tested" prints 'cannot be tested: too narrow a range'

# ---- what limits the accuracy -------------------------------------------------------------------

run calibrate "$work/log.csv"
check "noise that explains the residuals" prints '^limited by    the noise of the samples, which expl'
"$tool" simulate --plan edges --dwell 5 --instability 0.003 > "$work/shaky.csv"
run calibrate "$work/shaky.csv"
check "an offset that walks" prints '^limited by    handling, drift or temperature'
# Steps of 0.153 m/s^2 are 16 mg: they average out in a noise of 10 mg, but not in one of 1 mg.
for noise in 0.001 0.01; do
    "$tool" simulate --plan edges --lsb 0.153 --noise $noise > "$work/coarse.csv"
    run calibrate "$work/coarse.csv" --zero 0,0,0 --lsb 0.153 --gravity 9.80665 --need 1mg
    if [ $noise = 0.001 ]; then
        check "steps that are larger than the noise" prints '^limited by    quantisation: the readings have steps of 16 mg'
        check "steps: nothing says that longer rests help" prints 'or a finer resolution; longer rests do not help\.'
        run calibrate "$work/coarse.csv" --zero 0,0,0 --lsb 0.153 --noise 0.001
        check "steps against too small a stated noise" prints '^limited by    quantisation'
        check "steps: what to do then" prints '^Next: leave out --noise'
    else
        check "steps that average out" prints '^limited by    the noise of the samples'
    fi
done
"$tool" simulate --plan edges --lsb 0.153 --instability 0.03 > "$work/coarse.csv"
run calibrate "$work/coarse.csv" --zero 0,0,0 --lsb 0.153
check "steps that explain nothing" prints '^limited by    handling, drift or temperature'
positions sphere 40 3 | awk -F, '$3 > -2' > "$work/cap.csv"
run calibrate "$work/cap.csv" --positions --noise 0.001
check "orientations on one side" prints '^limited by    the orientations'

# ---- the field of a place -----------------------------------------------------------------------

gravity_at() { # LATITUDE HEIGHT EXPECTED TOLERANCE
    run calibrate "$data/mpu9150_0_positions.csv" --positions --latitude "$1" --height "$2" --json
    near "$4" "$(json "$work/stdout" gravity)" "$3" || complain
}
check "gravity at the equator" gravity_at 0 0 9.7803253359 1e-10
check "gravity at 45 degrees" gravity_at 45 0 9.8061977694 1e-10
check "gravity at a pole" gravity_at -90 0 9.8321849379 1e-10
check "gravity 3000 m above it, by the potential" gravity_at 90 3000 9.8229412899722 1e-6
run calibrate "$data/mpu9150_0_positions.csv" --positions --latitude 48 --height 500
check "an error of g affects all scales equally" prints 'normal gravity at 48 degrees, 500 m, ±0.0005; its error'
positions_file=$data/mpu9150_0_positions.csv
refuses "a latitude and a field are too much" 2 '--latitude: .*--gravity' \
    calibrate "$positions_file" --positions --latitude 48 --gravity 9.81
refuses "a height alone is too little" 2 '--height: .*--latitude' \
    calibrate "$positions_file" --positions --height 48
refuses "there is no such latitude" 2 '--latitude: ' calibrate "$positions_file" --latitude 91
refuses "nor such a height" 2 '--height: ' calibrate "$positions_file" --latitude 9 --height 1e5

# ---- options ------------------------------------------------------------------------------------

for degree in 0 3 1.5 -1; do
    refuses "--thermal $degree is refused" 2 '--thermal: must be 1' calibrate "$work/log.csv" \
        --thermal=$degree
done
refuses "--thermal needs temperatures" 3 'needs a column of temperature' calibrate "$work/log.csv" \
    --thermal 1
refuses "--slope belongs to --thermal" 2 '--slope: ' calibrate "$work/log.csv" --slope 1,1,1
refuses "--slope needs the noise" 2 '--slope: .*--noise' calibrate "$work/positions.csv" \
    --positions --thermal 1 --slope 0.001,0.001,0.001
refuses "no slope is negative" 2 '--slope: ' calibrate "$work/steps.csv" --thermal 1 --slope=-1,0,0

# ---- reports ------------------------------------------------------------------------------------

fit "$work/wrong.csv" --thermal 1 --report "$work/thermal.html"
check "the report is a page" is_page "$work/thermal.html"
check "it has the slopes" matches "$work/thermal.html" '[45][0-9.]+ ± [0-9.]+ ppm/K'
check "and what they achieve" matches "$work/thermal.html" \
    'Nine parameters without temperature leave an rms error of [0-9.]+ ‰ of the field'
fit "$work/positions.csv" --report "$work/plain.html"
check "without --thermal the residuals are shown against temperature" matches "$work/plain.html" \
    '<title>Residuals over temperature</title>'
check "and what it would achieve" matches "$work/plain.html" '\-\-thermal 1 reduces their rms from'

finish
