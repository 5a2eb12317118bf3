#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of `--units ins`: figures in micro-g, ppm and arcsec agree with the JSON, with the default units by
# exact factors, and with closed forms: units_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

xsens="$data/xsens_mti_positions.csv --positions --gravity 9.81744 --zero 33123,33276,32360
    --lsb 0.002409639,0.002421308,0.002409639"

# The figure in a line that begins so: "VALUE SIGMA", without its unit.
figure() { # figure LABEL FILE
    awk -v label="$1" 'index($0, label) == 1 { print $(split(label, w, " ") + 1), $(split(label, w, " ") + 3); exit }' "$2"
}
# One number of an array in JSON, from 1, times a factor; of `sigma` with a 1.
number() { # number FIELD INDEX FACTOR SIGMA
    awk -v field="\"$1\":" -v n="$2" -v factor="$3" -v sigma="$4" '
        /"sigma": *\{/ { inside = 1 } /^ *\},?$/ { inside = 0 }
        index($0, field) && inside == sigma { sub(/.*\[/, ""); sub(/\].*/, ""); split($0, v, /, */)
            printf "%.9f\n", factor * v[n]; exit }' "$work/result.json"
}
# All digits that are printed are right: to half a unit of the last place.
agrees() { # agrees TOLD TRUE
    awk -v printed="$1" -v true="$2" 'BEGIN {
        places = match(printed, /\./) ? length(printed) - RSTART : 0
        d = printed - true
        exit !(printed != "" && true != "" && (d < 0 ? -d : d) <= 0.5000001 * 10 ^ -places)
    }'
}
both_agree() { # both_agree LABEL FIELD INDEX FACTOR
    agrees "$(figure "$1" "$work/ins" | cut -d ' ' -f 1)" "$(number "$2" "$3" "$4" 0)" &&
        agrees "$(figure "$1" "$work/ins" | cut -d ' ' -f 2)" "$(number "$2" "$3" "$4" 1)"
}
# A figure in the default units times a factor, to the digits of both.
factor() { # factor LABEL FACTOR
    awk -v a="$(figure "$1" "$work/everyday" | cut -d ' ' -f 1)" -v f="$2" \
        -v b="$(figure "$1" "$work/ins" | cut -d ' ' -f 1)" 'BEGIN {
            places = match(a, /\./) ? length(a) - RSTART : 0
            d = b - f * a
            exit !(a != "" && b != "" && (d < 0 ? -d : d) <= 0.5000001 * f * 10 ^ -places + 0.5)
        }'
}

# shellcheck disable=SC2086 # $xsens is several words
{
    run calibrate $xsens --json
    cp "$work/stdout" "$work/result.json"
    run calibrate $xsens
    cp "$work/stdout" "$work/everyday"
    run calibrate $xsens --units everyday
    check "everyday units are the default" same "$work/everyday" "$work/stdout"
    run calibrate $xsens --units ins
    cp "$work/stdout" "$work/ins"
    run calibrate $xsens --units ins --json
    check "JSON stays in its units" same "$work/result.json" "$work/stdout"
    accepts "a page in the units of navigation" calibrate $xsens --units ins --report "$work/ins.html" --quiet
    accepts "and one in the default units" calibrate $xsens --report "$work/everyday.html" --quiet
}
n=0
for axis in x y z; do
    n=$((n + 1))
    check "offset $axis in micro-g" both_agree "offset error $axis" delta $n 1000000
    check "scale error $axis in ppm" both_agree "scale error $axis" dk $n 1000000
    check "scale error $axis: 10,000 times that in percent" factor "scale error $axis" 10000
done
n=0
for pair in xy xz zy; do
    n=$((n + 1))
    check "angle $pair in arcsec" both_agree "angle $pair" gamma $n 206264.80624709636
    check "angle $pair: 3600 times that in degrees" factor "angle $pair" 3600
done
labelled() { awk -v label="$1" 'index($0, label) { sub(label, ""); print $1, $2; exit }' "$2"; }
rms=$(awk -F '[:,]' '/"residual_rms"/ { printf "%.6f", 1e6 * $2 }' "$work/result.json")
check "residual in micro-g" agrees "$(labelled 'residual rms' "$work/ins" | cut -d ' ' -f 1)" "$rms"
check "and its unit" test "$(labelled 'residual rms' "$work/ins" | cut -d ' ' -f 2)" = µg
check "residual: 1000 times that in mg" agrees "$(labelled 'residual rms' "$work/everyday" | cut -d ' ' -f 1)" \
    "$(awk -v r="$rms" 'BEGIN { printf "%.9f", r / 1000 }')"
check "the other lines are the same" test "$(grep -c . "$work/ins")" -eq $(($(grep -c . "$work/everyday") + 3))
check "no milli-g, percent or degree is left in the table" lacks "$work/ins" ' (mg|degrees off square|% in the)'

# ---- the page ----------------------------------------------------------------------------------

text() { sed 's/<[^>]*>/ /g; s/  */ /g; s/−/-/g' "$1"; }
text "$work/ins.html" > "$work/ins.text"
text "$work/everyday.html" > "$work/everyday.text"
check "page: offset in micro-g" matches "$work/ins.text" \
    "offset x \\+$(number delta 1 1000000 0 | awk '{ printf "%.0f", $1 }') ± [0-9]+ µg"
# On the page ± is 95 %.
ninety_five() { awk -v s="$(number "$1" "$2" "$3" 1)" -v k="$(json "$work/result.json" interval95)" \
    'BEGIN { printf "%.0f", s * k }'; }
check "page: scale in ppm" matches "$work/ins.text" "scale y -2176 ± $(ninety_five dk 2 1000000) ppm"
check "page: angle in arcsec" matches "$work/ins.text" "angle zy \\+4397 ± $(ninety_five gamma 3 206264.80624709636) arcsec"
check "page: no milli-g" lacks "$work/ins.text" '[0-9] mg|, mg'
check "page: no degrees except for directions" lacks "$work/ins.text" '[0-9] °'
# The residuals of all positions: the last cells of their rows.
residuals() { awk '$NF ~ /^[-+][0-9.]+$/ && $(NF - 1) ~ /^[-+][0-9.]+$/ { print $(NF - 1), $NF }' "$1"; }
residuals "$work/ins.text" > "$work/a"
residuals "$work/everyday.text" > "$work/b"
check "page: 38 residuals" test "$(wc -l < "$work/a")" -ge 38
check "page: each 1000 times that in milli-g" sh -c 'paste -d " " "$1" "$2" | awk "
    function off(p, q) { p -= 1000 * q; return p < 0 ? -p : p }
    off(\$1, \$3) > 0.5501 || off(\$2, \$4) > 0.0551 { bad = 1 } END { exit bad }"' - "$work/a" "$work/b"

# ---- plan --------------------------------------------------------------------------------------

# The paper's sigma at a noise of 1e-4 over one second and 4 s in each position: 5e-5 times the roots of 1/6,
# 7/30 and 8/6, in 1e-6, 1e-6 and arcsec.
plan="--noise 0.0001 --dwell 4 --bound 0.0002"
paper=$(awk 'BEGIN { printf "%.9f %.9f %.9f", 50 * sqrt(1 / 6), 50 * sqrt(7 / 30), 50 * sqrt(8 / 6) * 0.20626480624709636 }')
of() { echo "$paper" | cut -d ' ' -f "$1"; }
third() { awk -v name="$1" 'index($0, "  " name) == 1 { sub("  " name, ""); print $2, $3; exit }' "$work/stdout"; }
# shellcheck disable=SC2086 # $plan is several words
{
    run plan $plan --json
    cp "$work/stdout" "$work/result.json"
    run plan $plan --units ins --json
    check "plan: JSON stays in its units" same "$work/result.json" "$work/stdout"
    run plan $plan
    cp "$work/stdout" "$work/everyday"
    run plan $plan --units everyday
    check "plan: everyday units are the default" same "$work/everyday" "$work/stdout"
    accepts "plan: a page" plan $plan --units ins --report "$work/plan.html"
}
check "plan: the noise" matches "$work/stdout" ', which is 50 µg$'
n=0
for kind in offsets:µg 'scale errors:ppm' angles:arcsec; do
    n=$((n + 1))
    check "plan: ${kind%:*}" agrees "$(third "${kind%:*}" | cut -d ' ' -f 1)" "$(of $n)"
    check "plan: ${kind%:*} in ${kind#*:}" test "$(third "${kind%:*}" | cut -d ' ' -f 2)" = "${kind#*:}"
done
check "plan: quadratic, 50 times the root of 8/3" matches "$work/stdout" '^  quadratic .* 81\.65 µg per g² '
check "plan: bounds, 200 times 1.244, 1.5333 and 0.4763" test "$(
    sed -n 's/.*at most \([0-9.]* [^ ]*\)$/\1/p' "$work/stdout" | tr '\n' ' ')" = '248.8 µg 306.7 ppm 95.27 arcsec '
check "plan: no milli-g, percent or degree except for the stand" lacks "$work/stdout" ' mg| %|(angles|at most) .*degrees'
text "$work/plan.html" > "$work/plan.text"
check "plan: page: no milli-g" lacks "$work/plan.text" '[0-9] mg|, mg|in mg'
check "plan: page: nor percent" lacks "$work/plan.text" '[0-9.] %'
check "plan: page: the angles of the stand in degrees" matches "$work/plan.text" 'α, °'
check "plan: page: sigma of offsets, scales and angles" matches "$work/plan.text" \
    'offsets to 20\.4[^0-9]*µg, scale errors to 24\.2[^0-9]*ppm, angles to 11\.9[^0-9]*arcsec'
run plan --compare per-group:6 per-group:8 --noise 0.0001 --dwell 4 --units ins
check "plan: two sets" test "$(sed -n 's/^\(offsets\|scales\|angles\), *//p' "$work/stdout" | awk '{ print $1, $2 }' | tr '\n' ' ')" = \
    'µg 20.4124 ppm 24.1523 arcsec 11.9087 '
run plan --programs --noise 0.0001 --dwell 4 --units ins
check "plan: all programs" matches "$work/stdout" '^3 x 6 .* 20\.4[^0-9]*µg .* 24\.2[^0-9]*ppm .* 11\.9[^0-9]*arcsec$'
echo 0 0 1 > "$work/up"
"$tool" simulate --plan directions:"$work/up" --dwell 60 > "$work/rest.csv"
"$tool" allan "$work/rest.csv" --lsb 0.0006 --out "$work/noise.json" --quiet
run plan --limits 0.0001,0.0001,0.0002 --allan "$work/noise.json" --units ins --report "$work/plan.html"
check "plan --allan: limits" matches "$work/stdout" 'limits 100 µg, 100 ppm, 41\.25 arcsec$'
check "plan --allan: no milli-g" lacks "$work/stdout" 'mg'
text "$work/plan.html" > "$work/plan.text"
check "plan --allan: page: no milli-g" lacks "$work/plan.text" '[0-9] mg|, mg|in mg'
run plan --limits 1e-9,1e-9,1e-9 --allan "$work/noise.json" --units ins
check "plan --allan: a refusal" matches "$work/stderr" ' µg is needed'
refuses "plan: units that are none" 2 'units SI: must be everyday or ins' plan --units SI

# ---- other fields, temperature, live -----------------------------------------------------------

run calibrate "$data/xsens_mti_positions.csv" --positions --gravity 48.5 --units ins
check "another field: ppm of it" matches "$work/stdout" '^residual rms .* ppm of the field$'
"$tool" simulate --dwell 3 --move 1 --temperature 20,50 --drift 0.0003 > "$work/log.csv"
in=$work/log.csv
run watch - --units ins
in=/dev/null
check "watch: micro-g, ppm and arcsec" matches "$work/stdout" \
    '; 95 %: offsets ± [0-9.e+]+ µg, scales ± [0-9.e+]+ ppm, angles ± [0-9.e+]+ arcsec'
run calibrate "$work/log.csv" --units ins
check "temperature, drift: no milli-g" lacks "$work/stdout" '[0-9] mg'
refuses "units that are none" 2 'units SI: must be everyday or ins' calibrate "$work/log.csv" --units SI

finish
