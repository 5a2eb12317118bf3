#!/bin/sh
# SPDX-License-Identifier: MIT
#
# PASS or FAIL, --strict, and figures that agree: table, page and JSON of one run have the same.
# pass_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

page=$work/out/page.html
xsens="$data/xsens_mti_positions.csv --positions --gravity 9.81744 --zero 33123,33276,32360
    --lsb 0.002409639,0.002421308,0.002409639"
"$tool" simulate --plan edges > "$work/log.csv"
sheet='--zero 0,0,0 --lsb 0.000598550415 --gravity 9.80665+-0'
# The text of the table on one line.
flat() { tr -s '\n ' ' ' < "$work/stdout"; }
prints() { flat | grep -Eq -- "$1" || { flat | tail -c 400 >&2; return 1; }; }
shows() { sed 's/<[^>]*>/ /g' "$page" | tr -s '\n ' ' ' | grep -Eq -- "$1"; }
# A member of an inner object, such as `pass`, by its name.
inner() { sed -n "s/^ *\"$2\": \(.*[^,]\),*\$/\1/p" "$1" | tr -d '"'; }

# ---- PASS and FAIL -------------------------------------------------------------------------------

# shellcheck disable=SC2086 # $sheet and $xsens are several words
{
accepts "pass: limits and a need that are kept" calibrate "$work/log.csv" $sheet --need 1mg \
    --tolerance 0.06,0.04,0.02 --report "$page"
check "pass: the table says so, with both margins" prints \
    'Good: .* PASS: \|a\| within 0\.0[0-9]+ of 1\.0 mg; angle xy up to 0\.57[0-9] of 1\.15° \(95 %\)\. '
check "pass: the page does in its box" shows 'Good ✓ PASS: \|a\| within 0\.0[0-9]+ of 1\.0 mg; angle xy up to'
check "pass: and has no red row" lacks "$page" '<tr class="bad">'
run calibrate "$work/log.csv" $sheet --need 1mg --tolerance 0.06,0.04,0.02 --json
check "pass: nor has the JSON" test "$(inner "$work/stdout" answer) $(inner "$work/stdout" failed)" = 'PASS []'
check "pass: a need in mg is in the units of the field, too" near 1e-12 "$(inner "$work/stdout" wanted)" 0.00980665
for need in '0.1 %' 1000ug 0.001g 0.00980665m/s2 0.00980665; do
    run calibrate "$work/log.csv" $sheet --need "$need" --json
    check "pass: $need is as much" near 1e-12 "$(inner "$work/stdout" wanted)" 0.00980665
done
run calibrate "$work/log.csv" $sheet --need 100ug
check "pass: reported as it was stated" prints 'within [0-9.]+ of 100 µg'
for need in 1mT 5mgg 2um/s2 0.5uT xmg; do
    refuses "pass: an unknown unit, $need" 2 \
        "--need $need: must be a number followed by mg, g, ug, m/s2 or %, or a number in the unit of --gravity;" \
        calibrate "$work/log.csv" --need "$need"
done
refuses "pass: an unknown unit of a magnetometer's" 2 \
    '--need 0\.5mT: must be a number followed by %, or a number in the unit of the readings;' \
    calibrate "$work/log.csv" --magnetometer --need 0.5mT
refuses "pass: a need without its unit" 2 '--need 2: is more than a tenth of the field: state the unit, as 2mg;' \
    calibrate "$work/log.csv" --need 2
refuses "pass: a need that everything meets" 2 '--need 200mg: is more than a tenth of the field;' \
    calibrate "$work/log.csv" --need 200mg
# The same limits in units: 60 mg and 4 % and 0.02 rad, which are 1.145915590 degrees.
for limits in 60mg,4%,1.145915590261646deg '60 mg,4 %,1.145915590261646 °' 0.06g,0.04,0.02rad 6%,4%,2%; do
    run calibrate "$work/log.csv" $sheet --tolerance "$limits" --json
    check "pass: limits of $limits are the same" near 1e-12 \
        "$(sed -n '/"limit": {/,/}/s/.*\[\(.*\)\].*/\1/p' "$work/stdout" | tr '\n' ' ')" \
        '0.06 0.06 0.06 0.04 0.04 0.04 0.02 0.02 0.02'
done
for limits in 50,3,2 0.05,3,0.02 0.05,0.03,2 0.5,0.03,0.02 50mg,3mg,0.02 50uT,0.03,0.02 0.05,0.03,nan; do
    refuses "pass: limits of $limits" 2 \
        "--tolerance $limits: offsets are over the field \(0\.05 is 50 mg\), scale errors as ratios \(0\.03 is 3 %\), angles in rad" \
        calibrate "$work/log.csv" $sheet --tolerance "$limits"
done
refuses "pass: mg for a field that is not gravity" 2 'is not gravity: state % of it' \
    calibrate "$work/log.csv" --gravity 48.5 --need 1mg
refuses "pass: no number" 2 "--need 1x2: '1x2' is not a decimal" calibrate "$work/log.csv" --need 1x2mg
refuses "pass: 0 mg" 2 '--need: must be above 0' calibrate "$work/log.csv" --need 0mg

accepts "pass: limits that are not kept" calibrate "$work/log.csv" $sheet --tolerance 0.02,0.04,0.02 --report "$page"
check "pass: then it fails, with the margin" prints 'FAIL: offset z up to 30\.0 of 20\.0 mg and 1 more \(95 %\)\. Beyond'
check "pass: in the page the two rows are red" test "$(grep -c '<tr class="bad">' "$page")" -eq 2
check "pass: under a verdict that is good" shows 'Good ✗ FAIL: offset z'
# A limit that the value keeps, but not with its ±: the value of z, and half a sigma.
run calibrate "$work/log.csv" $sheet --json
limit=$(awk -F'[][,:]' '/^  "delta"/ { x = $5 } /^    "delta"/ { s = $5 } END { printf "%.9f", x + s / 2 }' "$work/stdout")
run calibrate "$work/log.csv" $sheet --tolerance "$limit,0.4,0.4" --report "$page"
check "pass: a value that may be beyond fails" prints 'FAIL: offset z up to 30\.0[0-9]+ of 30\.0[0-9]+ mg \(95 %\)\. '
check "pass: and is reported as unsure" shows 'Possibly beyond the limits .*: offset z\.'
}
printf '%s\n' 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0,-1 .7,.7,0 .7,0,.7 0,.7,.7 |
    awk -F, -v OFS=, '{ print 9.8 * $1, 9.8 * $2, 9.8 * $3 }' > "$work/nine.csv"
run calibrate "$work/nine.csv" --positions --zero 0,0,0 --lsb 1 --tolerance 0.4,0.4,0.4 --need 0.5 --report "$page"
check "pass: if the noise is unknown, nothing passes" prints \
    'FAIL: the verdict is no redundancy; the noise is unknown'
check "pass: and the page is well-formed" is_page "$page"

# ---- --strict ------------------------------------------------------------------------------------

strictly() { # CODE PATTERN ARGUMENTS: files are there in any case
    expected=$1
    pattern=$2
    shift 2
    rm -f "$work"/out/*
    run calibrate "$@" --strict --quiet --out "$work/out/cal.json" --report "$page"
    [ "$code" -eq "$expected" ] && is_json "$work/out/cal.json" && is_page "$page" && is_empty "$work/stdout" &&
        if [ "$expected" -eq 0 ]; then is_empty "$work/stderr"; else says "$pattern"; fi || complain
}
# shellcheck disable=SC2086
{
check "strict: a good one" strictly 0 . "$work/log.csv" $sheet
check "strict: that passes" strictly 0 . "$work/log.csv" $sheet --need 1mg --tolerance 0.06,0.04,0.02
check "strict: fails its need" strictly 1 '--strict: FAIL: \|a\| within .* of 0\.0010 mg .* Missing: ' \
    "$work/log.csv" $sheet --need 0.001mg
check "strict: or a limit" strictly 1 '--strict: FAIL: offset z' "$work/log.csv" $sheet --tolerance 0.02,0.04,0.02
check "strict: is rough" strictly 1 '--strict: the verdict is rough: the positions disagree by 3\.6 times' $xsens
check "strict: is weak" strictly 1 '--strict: the verdict is weak: angle xy, angle xz, angle zy poorly' \
    "$data/t265_positions.csv" --positions
check "strict: has no redundancy" strictly 1 'no redundancy: nothing checks' "$work/nine.csv" --positions
for trouble in drift cubic; do
    awk -v trouble=$trouble -v seed=1 -f "$here/random.awk" -f "$here/trouble.awk" > "$work/$trouble.csv"
    check "strict: $trouble" strictly 1 '--strict: the verdict is (drifting: the offsets drift|bent: the [xyz] axis has)' \
        "$work/$trouble.csv" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665
done
run calibrate $xsens --strict --json
check "strict: the JSON is printed anyway" is_json "$work/stdout"
run calibrate $xsens --quiet
check "without it the exit code of a rough one is 0" test "$code" -eq 0
in=$work/log.csv
run watch - --strict --quiet --need 0.001mg
in=/dev/null
check "strict: watch as well" was_refused 1 'standard input: --strict: FAIL'
}

# ---- the same figures everywhere -----------------------------------------------------------------

agree() { # LEAST [-v ins=1] -- ARGUMENTS: so many figures of the page are the JSON's
    least=$1
    ins=$2
    shift 2
    run calibrate "$@" --json --report "$page"
    [ "$code" -eq 0 ] || complain || return
    compared=$(awk -v ins="$ins" -f "$here/figures.awk" -f "$here/page_json.awk" "$work/stdout" "$page")
    [ "$compared" -ge "$least" ] 2> /dev/null || { echo "    $compared" >&2; return 1; }
}
# shellcheck disable=SC2086
{
check "figures: a real sensor, with limits and a need" agree 50 0 $xsens --tolerance 0.02,0.005,0.02 --need 1mg
check "figures: in the units of navigation" agree 50 1 $xsens --tolerance 0.02,0.005,0.02 --need 100ug --units ins
check "figures: a drift that was fitted" agree 30 0 "$work/drift.csv" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665
check "figures: a nonlinearity that was fitted" agree 30 0 "$work/cubic.csv" --positions --zero 0,0,0 --lsb 1 \
    --noise 0.000980665 --cubic
"$tool" simulate --plan edges --outliers 2 > "$work/outliers.csv"
check "figures: outliers" agree 39 0 "$work/outliers.csv" --zero 0,0,0 --lsb 0.000598550415
check "figures: outliers beside a prior" agree 39 0 "$work/outliers.csv" --zero 0,0,0 --lsb 0.000598550415 \
    --noise 0.01 --prior 0.05,0.02,0.02 --tolerance 0.05,0.03,0.02
}
sensor() { awk -v what=positions -v stations="$1" -v wrong="$2" -v seed=1 -v sigma=1e-4 -f "$here/random.awk" -f "$here/thermal.awk" \
    "$here/../reference/expected.h"; }
sensor -20,25,70 23 > "$work/chamber.csv"
check "figures: of slopes over temperature, with an outlier" agree 50 0 "$work/chamber.csv" --positions --thermal 1 --unit g \
    --gravity 9.80665
# Their size: the three digits in the table agree with the JSON.
run calibrate "$work/outliers.csv" --json
sed -n '/"rejected_excess"/,/\]/p' "$work/stdout" | grep -E '^ *[-0-9]' | tr -d ' ,' > "$work/excess"
run calibrate "$work/outliers.csv"
sed -n 's/^Left out: .*wrong by \([-0-9.]*\) mg$/\1/p' "$work/stdout" | paste - "$work/excess" > "$work/pairs"
check "figures: the size of an outlier in table and JSON" awk '{ d = $1 - 1000 * $2; if (d > 0.051 || d < -0.051) exit 1 }
    END { exit NR != 2 }' "$work/pairs"

finish
