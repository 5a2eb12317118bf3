#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of plan by its command line: plan_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# Runs plan --json and evaluates its directions independently: $judged, see directions.awk.
judge() {
    run plan --json "$@"
    judged=$(awk -f "$here/directions.awk" "$work/stdout")
}

holds() { # holds AWK-CONDITION on $judged: n, delta, dk, gamma, ln det, below
    echo "$judged" | awk "/^wrong/ || !NF { exit 1 }
        { n = \$1; delta = \$2; dk = \$3; gamma = \$4; below = \$6; if (!($1)) exit 1 }" ||
        { echo "    $judged" >&2; complain; }
}

field() { # field NAME: numbers of a member of the result
    json "$work/stdout" "$1"
}

cell() { # cell ROW COLUMN of the printed table
    awk -v row="$1" -v column="$2" 'NR == row { print $column }' "$work/stdout"
}

member() { # member NAME INDEX: number INDEX (from 1) of a list of objects
    sed -n "s/^ *\"$1\": \([^,]*\),*\$/\1/p" "$work/stdout" | sed -n "$2p"
}

# ---- the paper ---------------------------------------------------------------------------------

accepts "plan: --help succeeds" plan --help
judge
check "plan: by default the paper's 18 positions" holds \
    'n == 18 && delta == 0.408248290 && dk == 0.483045892 && gamma == 1.154700538'
# Table 2 of the paper: alpha and beta of each of its 18 positions.
cat > "$work/table2" <<'END'
30 0
90 0
150 0
-150 0
-90 0
-30 0
-90 30
-90 90
-90 150
-90 -150
-90 -90
-90 -30
120 90
180 90
-120 90
-60 90
0 90
60 90
END
accepts "plan: it prints" plan
awk 'NF == 7 && $1 ~ /^[0-9]+$/ { print $3, $4 }' "$work/stdout" > "$work/printed"
check "plan: its angles are those of Table 2" same "$work/table2" "$work/printed"
run plan --json
check "plan: --json is JSON" is_json "$work/stdout"
check "plan: its condition is 8" near 1e-12 8 "$(field condition)"
check "plan: each group is D-optimal" near 1e-9 "486 486 486 486" \
    "$(field group_det) $(field group_det_bound)"
check "plan: nothing is missing" near 0 "0$(field missing)" 0
check "plan: H'H of the first offset is N" near 1e-12 6 \
    "$(sed -n '/"hth"/{n;s/^ *\[\([^,]*\),.*/\1/p;}' "$work/stdout")"
check "plan: K of the first offset is 1/N" near 1e-12 0.16666666666666667 \
    "$(sed -n '/"covariance"/{n;s/^ *\[\([^,]*\),.*/\1/p;}' "$work/stdout")"

for n in 5 6 7 8 16 64 333 1000; do
    judge --per-group $n
    check "plan: $n in a group: sigma by the closed form" holds "n == 3 * $n &&
        (delta - sqrt(1 / $n)) ^ 2 < 1e-17 && (dk - sqrt(7 / 5 / $n)) ^ 2 < 1e-17 &&
        (gamma - sqrt(8 / $n)) ^ 2 < 1e-17"
done
judge --per-group 11 --start -360,77.7,359
check "plan: any start angles give the same sigma" holds '(gamma - sqrt(8 / 11)) ^ 2 < 1e-17'
judge --start 30,30,120
check "plan: only start angles: 6 in a group" holds 'n == 18'

accepts "plan: sweep" plan --sweep 5:16
check "plan: the sweep has 12 rows" test "$(grep -c '^ *[0-9]' "$work/stdout")" -eq 12
check "plan: fifteen positions are the minimum" near 0 "5 15" "$(cell 4 1) $(cell 4 2)"
check "plan: they miss axes" matches "$work/stdout" '^ +5 .* -x -y \+z$'
check "plan: every even number points all six axes" test \
    "$(awk '$1 % 2 == 0 && /all six$/' "$work/stdout" | grep -c .)" -eq 6
check "plan: no odd number does" test \
    "$(awk '$1 % 2 == 1 && /all six$/' "$work/stdout" | grep -c .)" -eq 0
run plan --sweep 5:16 --json
check "plan: a sweep is JSON" is_json "$work/stdout"
check "plan: Fig. 2 at 15, 18 and 48 positions" near 1e-12 \
    "0.44721359549995793 0.48304589153964794 0.70710678118654752" \
    "$(member sigma_delta 1) $(member sigma_dk 2) $(member sigma_gamma 12)"
run plan --per-group 5
check "plan: an odd number says why it misses axes" matches "$work/stdout" 'odd number per group'

accepts "plan: compare" plan --compare per-group:8 per-group:6
check "plan: 18 positions against 24: 1.1547" test \
    "$(grep -c '^sigma.* 1\.1547$' "$work/stdout")" -eq 3
run plan --compare per-group:8 per-group:6 --json
check "plan: a comparison is JSON" is_json "$work/stdout"
check "plan: three quarters of the labour" near 1e-12 0.75 "$(member labour 3)"
check "plan: sigma times 1.154701" near 1e-12 1.1547005383792515 "$(member sigma_gamma 3)"

# ---- other directions --------------------------------------------------------------------------

judge --icosahedron
check "plan: the icosahedron is D-optimal" holds \
    'n == 12 && delta == 0.5 && dk == 0.707106781 && gamma == 1.118033989 && below < 1e-9'
judge --edges
check "plan: six faces and twelve edges" holds \
    'n == 18 && delta == 0.408248290 && dk == 0.527046277 && gamma == 1'
run plan --faces --json
check "plan: six faces: refused, but shown" test "$code" -eq 1
check "plan: six faces: the angles are named" test "$(field undetermined)" = \
    '["gamma_xy", "gamma_xz", "gamma_zy"]'
check "plan: six faces: sigma is unknown" test "$(field sigma_gamma)" = null
check "plan: six faces: all axes" test "$(field missing)" = '[]'
check "plan: six faces: one line says why" says 'faces: .*angle xy, angle xz, angle zy'

sed -n 's/^ *"vertical": \[\(.*\)\],*$/\1/p' > "$work/verticals.csv" <<END
$("$tool" plan --json --icosahedron)
END
judge --directions "$work/verticals.csv"
check "plan: directions from a file" holds 'n == 12 && below < 1e-9'
awk -F, '{ print NR * 1e150 * $1, NR * 1e150 * $2, NR * 1e150 * $3 }' "$work/verticals.csv" > "$work/long.txt"
judge --directions "$work/long.txt"
check "plan: they may have any length" holds 'n == 12 && below < 1e-9'
refuses "plan: a direction of no length" 3 'zero\.csv:2: not a direction' plan --directions \
    "$(printf '1,0,0\n0,0,0\n' > "$work/zero.csv"; echo "$work/zero.csv")"
refuses "plan: a malformed direction" 3 'word\.csv:2: ' plan --directions \
    "$(printf '1,0,0\n0,a,0\n' > "$work/word.csv"; echo "$work/word.csv")"
refuses "plan: a missing file" 3 'nowhere: cannot be read' plan --directions "$work/nowhere"
awk 'BEGIN { for (i = 0; i <= 3000; i++) print sin(i) "," cos(i) ",0.5" }' > "$work/many.csv"
refuses "plan: too many directions" 3 '3001 directions; the maximum is 3000' plan --directions "$work/many.csv"

# ---- optimal -----------------------------------------------------------------------------------

# Bound of a spherical 4-design: within 0.05 from 14 positions on. They are better than the paper's
# programs, whose ln det is 0.517 below the bound for every N.
n=9
while [ $n -le 48 ]; do
    judge --optimal $n
    if [ $n -lt 14 ]; then within=0.22; else within=0.005; fi
    check "plan: $n optimal directions: ln det is near the bound" holds \
        "n == $n && below < $within && below > -1e-9"
    n=$((n + 1))
done
"$tool" plan --optimal 14 --json > "$work/once"
"$tool" plan --optimal 14 --json > "$work/twice"
check "plan: the search is deterministic" same "$work/once" "$work/twice"
check "plan: its first direction is up" near 1e-12 "0 0 1" \
    "$(sed -n 's/^ *"vertical": //p' "$work/once" | head -n 1)"

# The paper's program is itself the best against limits in the ratio of its sigma.
judge --optimal 18 --limits 0.408248,0.483046,1.154701
check "plan: weighted by limits, 18 directions are as good as the paper's in all three" holds \
    'delta < 1.001 * 0.408248 && dk < 1.001 * 0.483046 && gamma < 1.001 * 1.154701'
judge --optimal 24 --limits 1,1,1
check "plan: equal limits make the worst sigma smaller than the D-optimum does" holds \
    'gamma < 0.69 && dk < 0.69 && gamma > 0.68'
# No 60 directions have sigmas below sqrt(3 / 60), sqrt(3 (1 - 3 b) / (1 - 9 b) / 60) and
# sqrt(1 / (60 b)), b the mean of x^2 y^2.
least=$(awk 'BEGIN {
    least = 9
    for (b = 0.0001; b < 0.1111; b += 0.0001) {
        dk = sqrt(3 * (1 - 3 * b) / (1 - 9 * b) / 60) / 0.3
        gamma = sqrt(1 / (60 * b))
        worst = dk > gamma ? dk : gamma
        if (worst < least) least = worst
    }
    print least
}')
judge --optimal 60 --limits 0.3,0.3,1
check "plan: weighted by limits, 60 directions are as good as possible" holds \
    "delta < 0.3 * $least && dk < 1.001 * 0.3 * $least && gamma < 1.001 * $least"

# ---- the choice --------------------------------------------------------------------------------

judge --limits 0.4,0.6,1
check "plan: limits: 19 directions are enough" holds \
    'n == 19 && delta <= 0.4 && dk <= 0.6 && gamma <= 1'
check "plan: limits: the stand program takes 24" near 0 24 "$(member labour 2)"
# 18 directions would not be: delta is at least sqrt(3 / 18) for any 18.
judge --limits 0.4083,0.49,1.2
check "plan: limits: at equal labour the set inside them is taken" holds 'n <= 18 && dk <= 0.49'
# Nine are never chosen by default, as nothing would check them.
judge --limits 10,10,10
check "plan: limits: twelve are the minimum, with a redundancy of three" holds 'n == 12'
judge --limits 10,10,10 --spare 0
check "plan: limits: nine are the minimum without redundancy" holds 'n == 9'
# Another optimiser found sets of this size within these limits, to the third digit.
judge --limits .605,.86,1.356 --spare 0
check "plan: limits: nine where nine are enough" holds 'n == 9'
judge --limits 1.32,.66,1.584 --spare 0
check "plan: limits: ten where ten are enough" holds 'n == 10'
judge --limits .53,.7526,1.1872 --spare 0
check "plan: limits: eleven where eleven are enough" holds 'n == 11'
judge --limits 10,0.4,10
check "plan: limits: twenty where twenty are enough, and none is weak" holds 'n == 20 && gamma < 10'
judge --limits 0.224,0.32,0.501
check "plan: limits: sixty as five icosahedra" holds 'n <= 60'
judge --limits 1e6,0.3,1e6
check "plan: limits: a limit of one sigma leaves none above 10" holds 'delta <= 10 && gamma <= 10'
judge --limits 0.15,0.15,0.15
check "plan: limits: many positions on a stand where 144 free ones are not enough" holds \
    'n == 1068 && gamma <= 0.15 + 1e-9'
# 0.1 mg in a second, 0.05 mg in four: the same limits in g, 1 and rad.
judge --limits 0.00002,0.00003,0.00005 --noise 0.0001 --dwell 4
check "plan: limits in units of the field" holds 'n == 19'
check "plan: sigma with the noise" near 1e-7 0.0000198680 "$(member delta 1)"
refuses "plan: limits that nothing meets" 1 'no program of up to 3000' plan --limits 0.01,0.01,0.01
run plan --limits 0.01,0.01,0.01 --json
check "plan: --json has a refusal, too" matches "$work/stdout" '^  "reason": "no program'

judge --budget 200
check "plan: a budget of 200 s holds 20 positions of 5 s and 19 moves of 5 s" holds 'n == 20'
check "plan: 195 s of them" near 1e-9 195 "$(field seconds)"
judge --budget 195 --dwell 5 --move 5
check "plan: it may be used to the last second" holds 'n == 20'
judge --budget 900
check "plan: free directions beyond 48" holds 'n == 90 && below < 1e-6'
judge --budget 3000
check "plan: where 144 are not all, the stand program is larger and better" holds 'n == 300'
judge --budget 90 --dwell 10 --move 0 --spare 0
check "plan: without moves" holds 'n == 9'
refuses "plan: a budget of eight positions" 1 '8 positions fit into 80 s' plan --budget 80 \
    --dwell 10 --move 0
refuses "plan: limits out of a budget's reach" 1 'no program of up to 12 positions' plan \
    --limits 0.4,0.6,1 --budget 115
judge --limits 0.4,0.6,1 --budget 190
check "plan: limits within a budget" holds 'n == 19'

# ---- requirements ------------------------------------------------------------------------------

judge --limits 10,10,10 --spare 7
check "plan: a redundancy of seven" holds 'n == 16'
check "plan: it says so" test "$(field redundancy)" = 7
judge --budget 200 --spare 11
check "plan: a redundancy of eleven in a budget" holds 'n == 20'
refuses "plan: a redundancy of twelve in it" 1 '20 positions fit .* the minimum is 21, nine and a redundancy of 12' plan \
    --budget 200 --spare 12
refuses "plan: more redundancy than --optimal allows" 2 'spare 4: --optimal 12 has a redundancy of only 3' plan \
    --optimal 12 --spare 4
judge --optimal 12 --spare 3
check "plan: as many as it allows" holds 'n == 12'
for set in '--limits 0.4,0.6,1' '--limits 10,10,10' '--budget 300' '--optimal 11' '--optimal 18' \
    '--optimal 24 --limits 1,1,1' '--optimal 18 --grid 15'; do
    # shellcheck disable=SC2086
    judge $set --need-axes
    check "plan: $set: each axis up and down" test "$(field missing)" = '[]'
    check "plan: $set: and the figures are true" holds 'n >= 11'
done
# Even if an odd number of positions in each group were enough, an even one is taken.
judge --limits 0.4,0.46,1.07 --need-axes
run plan --limits 0.375,0.45,1.07 --need-axes
check "plan: programs with all axes have even groups" matches "$work/stdout" '^3 x 8 '
run plan --limits 0.38,0.45,1.07
check "plan: without that an odd one is enough" matches "$work/stdout" '^3 x 7 '
# Six faces fixed, twelve more: the edges of a cube are such a set.
judge --optimal 18 --need-axes
check "plan: with the axes, 18 are as good as faces and edges" holds 'below < 9.464940 - 9.364262 + 1e-6'
judge --optimal 12 --need-axes
check "plan: with the axes, 12 cannot be an icosahedron" holds 'below > 0.3'

# ---- a stand -----------------------------------------------------------------------------------

# ln det has a closed form: from 3 x 6, each axis takes 1 from an offset, ...
judge --stand-12
check "plan: stand-12: ln det 5.801, sigma" holds 'n == 12 && delta == 0.5 && gamma == 1.154700538 &&
    (below - 5.815754 + 5.801363) ^ 2 < 1e-11'
check "plan: stand-12: condition 16/3" near 1e-9 5.333333333333333 "$(field condition)"
check "plan: stand-12: no axis" test "$(field axes_covered)" = '[]'
judge --stand-24
check "plan: stand-24" holds 'n == 24 && gamma == 1'
check "plan: stand-24 is 18 directions" test "$(field directions)" = 18
run plan --stand-24
check "plan: and says so" matches "$work/stdout" '^24 positions in 18 directions$'
for step in 15 30 45; do
    judge --optimal 18 --grid $step
    check "plan: stops of $step degrees: the figures are true" holds 'n == 18 && below < 0.07'
    check "plan: stops of $step degrees: no other angle" test \
        "$(awk -v step=$step '/"(alpha|beta)"/ && $2 % step != 0' "$work/stdout" | wc -l)" -eq 0
done
for bad in 0 10 90 x ''; do
    refuses "plan: stops of '$bad'" 2 'grid' plan --optimal 12 --grid "$bad"
done
refuses "plan: two numbers for stops" 2 "optimal: '12:12'" plan --optimal 12 --grid 30:12
refuses "plan: stops without a number" 2 'grid: needs --optimal' plan --grid 30
refuses "plan: stops and limits" 2 'grid: cannot be combined' plan --optimal 12 --grid 30 --limits 1,1,1
refuses "plan: a colon in --optimal" 2 'optimal: must be a number' plan --optimal 12:axes
for option in --need-axes '--spare 4'; do
    # shellcheck disable=SC2086
    refuses "plan: $option of a given set" 2 'needs --limits' plan --edges $option
done
for bad in -1 136 1.5 x; do
    refuses "plan: --spare $bad" 2 'spare' plan --limits 1,1,1 "--spare=$bad"
done

# ---- shares of the dwell, bounds ---------------------------------------------------------------

shares() { # of positions on an axis, and of the others
    awk '/"vertical"/ { gsub(/[][,]/, " "); axis = 0
            for (i = 2; i <= 4; i++) if ($i > 0.9999 || $i < -0.9999) axis = 1 }
        /"share"/ { printf "%s%.9f\n", axis ? "axis " : "other ", $2 }' "$work/stdout" | sort -u
}
run plan --edges --weights --json
check "plan: faces 1/30, edges 1/15" test "$(shares | tr '\n' ' ')" = 'axis 0.033333333 other 0.066666667 '
bound=$(awk 'BEGIN { print 4 * log(6) + 2 * log(36 / 15) + 3 * log(18 / 15) }')
check "plan: they reach 9.465" near 1e-4 "$bound $bound" "$(field log_det) $(field most_log_det)"
check "plan: equal shares have 9.364" near 1e-3 9.364 "$(field equal_log_det)"
run plan --weights --json
check "plan: Table 2: no share for the axes" test "$(shares | tr '\n' ' ')" = \
    'axis 0.000000000 other 0.083333333 '
accepts "plan: shares are printed" plan --weights
check "plan: six have none" matches "$work/stdout" '^6 positions have no share'
refuses "plan: shares of a choice" 2 'weights: needs a named set' plan --limits 1,1,1 --weights

bounds() { # the largest of each kind
    for kind in delta dk gamma; do
        sed -n "/\"bound\"/,/}/s/^ *\"$kind\": \(.*\)/\1/p" "$work/stdout" | tr -d '[],' |
            awk '{ m = $1; for (i = 2; i <= 3; i++) if ($i > m) m = $i; printf "%.3f ", m }'
    done
}
run plan --bound 1 --json
check "plan: bounds of 3 x 6" test "$(bounds)" = '1.244 1.533 2.309 '
run plan --per-group 8 --bound 1 --json
check "plan: bounds of 3 x 8" test "$(bounds)" = '1.207 1.600 2.000 '
run plan --edges --bound 1 --json
check "plan: bounds of faces and edges" test "$(bounds)" = '1.276 1.889 2.000 '
accepts "plan: bounds are printed" plan --bound 0.0002
check "plan: in units" matches "$work/stdout" '^  offsets .*at most 0\.2488 mg$'
for bad in 0 -1 1.1 nan x; do
    refuses "plan: a bound of $bad" 2 'bound' plan "--bound=$bad"
done

# ---- nonlinear terms ---------------------------------------------------------------------------

# One figure of the quadratic or cubic terms, which are objects within an object.
nonlinear() { # nonlinear quadratic|cubic MEMBER
    sed -n "/^    \"$1\": {/,/}/s/^ *\"$2\": \(.*[^,]\),*\$/\1/p" "$work/stdout"
}
nonlinear_all() {
    for terms in quadratic cubic; do
        echo "$(nonlinear $terms parameters) $(nonlinear $terms sigma) $(nonlinear $terms condition)"
    done | tr '\n' ' '
}
run plan --json
check "plan: Table 2: quadratic to the root of 8/3, cubic of 32/3" near 1e-4 \
    "12 1.632993 40.22514 15 3.265986 231.69168" "$(nonlinear_all)"
check "plan: Table 2: all of them" test "$(nonlinear quadratic undetermined) $(nonlinear cubic undetermined)" = '[] []'
run plan --per-group 8 --json
check "plan: 24 positions: the root of 2, and 2" near 1e-4 "1.414214 2" \
    "$(nonlinear quadratic sigma) $(nonlinear cubic sigma)"
run plan --edges --json
check "plan: faces and edges: the roots of 3 and 5" near 1e-4 "1.732051 38.47401 2.236068 90.40370" \
    "$(nonlinear quadratic sigma) $(nonlinear quadratic condition) $(nonlinear cubic sigma) $(nonlinear cubic condition)"
run plan --weights --json
check "plan: without a share for the axes: the root of 32/9" near 1e-4 "1.885618 42.05956" \
    "$(nonlinear quadratic sigma) $(nonlinear quadratic condition)"
check "plan: and no cubic term" test "$(nonlinear cubic sigma) $(nonlinear cubic undetermined)" = \
    'null ["cubic x", "cubic y", "cubic z"]'
accepts "plan: nonlinear terms are printed" plan
check "plan: quadratic" matches "$work/stdout" '^  quadratic  *1\.6330   of 12 parameters, condition 40\.23$'
check "plan: cubic" matches "$work/stdout" '^  cubic  *3\.2660   of 15 parameters, condition 231\.7$'
accepts "plan: and in units" plan --noise 0.0001 --dwell 1
check "plan: cubic in units" matches "$work/stdout" '^  cubic  *3\.2660  *0\.3266 mg per g³   of 15 '
accepts "plan: of few positions" plan --per-group 5
check "plan: it says what calibrate does not fit" matches "$work/stdout" \
    '^  cubic .*, but --cubic needs 17 positions or more$'
accepts "plan: of corners" plan --icosahedron
check "plan: it names the terms that they do not determine" matches "$work/stdout" \
    '^  cubic  *undetermined: cubic x, cubic y, cubic z$'
accepts "plan: of nine" plan --optimal 9
check "plan: nor do nine the quadratic ones" matches "$work/stdout" \
    '^  quadratic  *undetermined: quadratic x, quadratic y, quadratic z$'
run plan --faces
check "plan: not for positions that determine no calibration" lacks "$work/stdout" 'quadratic'

# ---- labour ------------------------------------------------------------------------------------

run plan --warm-up 600 --settle 2 --dwell 30 --move 10 --json
check "plan: the labour in minutes" near 1e-9 "10 0.6 2.833333333333 9 22.433333333333" "$(
    sed -n '/"minutes"/,/}/s/^ *"[a-z_]*": \([0-9.]*\),*$/\1/p' "$work/stdout" | tr '\n' ' ')"
check "plan: and in seconds" near 1e-9 1346 "$(field seconds)"
accepts "plan: the labour is printed" plan --warm-up 600
check "plan: minutes" matches "$work/stdout" '^12\.92 minutes: 10 to warm up, 0 to settle, 1\.417 to turn, 1\.5 to record$'
accepts "plan: labour compared" plan --compare stand-24 per-group:6 --warm-up 600
check "plan: minutes compared" matches "$work/stdout" '^minutes  *13\.9167  *12\.9167  *0\.9281$'
judge --budget 800 --warm-up 600
check "plan: a budget includes the warm-up" holds 'n == 20'
refuses "plan: a budget that the warm-up uses up" 1 '0 positions fit into 600 s' plan --budget 600 \
    --warm-up 700
refuses "plan: a negative warm-up" 2 'warm-up' plan --warm-up=-1

accepts "plan: the programs" plan --programs
check "plan: six of them" test "$(grep -c 'over 3 x 6' "$work/stdout")" -eq 6
check "plan: faces and edges over 18: 1.091" matches "$work/stdout" \
    '^  over 3 x 6 +1\.0000 +1\.0000 +1\.0000 +1\.0911 +0\.8660 +0\.7500$'
# 0.4082 times the noise, and so on.
run plan --programs --noise 0.001 --dwell 1
noise=$(sed -n 's/^noise of a position mean: \([0-9.]*\) mg$/\1/p' "$work/stdout")
check "plan: the programs at a noise, in mg, % and degrees" near 0.002 "$(awk -v noise="$noise" 'BEGIN {
    print noise, 0.40825 * noise, 0.0483046 * noise, 1.1547 * noise * 0.0572958 }')" \
    "$noise $(sed -n '/^noise of/,$s/^3 x 6//p' "$work/stdout" | tr -c '0-9.\n' ' ')"
check "plan: of all six" test "$(sed '1,/^noise of/d' "$work/stdout" | grep -c 'mg .*% .*°$')" -eq 6
run plan --programs --json
check "plan: the programs are JSON" is_json "$work/stdout"
for option in --edges '--svg x' '--report x' '--limits 1,1,1' '--sweep 5:6' --csv --weights '--bound 1'; do
    # shellcheck disable=SC2086
    refuses "plan: the programs with $option" 2 'rograms' plan --programs $option
done

# ---- to a stand's controller and back ----------------------------------------------------------

for set in --stand-24 --icosahedron '--per-group 7 --start 1,2,3.3' '--edges --weights' \
    '--optimal 12 --grid 30' '--optimal 20' '--dwell 12.5'; do
    # shellcheck disable=SC2086
    "$tool" plan $set --csv > "$work/stand.csv"
    accepts "plan: $set: read back" plan --angles "$work/stand.csv" --csv
    check "plan: $set: the same bytes" same "$work/stand.csv" "$work/stdout"
    # shellcheck disable=SC2086
    run plan $set --json
    sed -n '/"sigma_d/p; /"log_det"/p; /"seconds"/p; /"condition"/p' "$work/stdout" > "$work/before"
    run plan --angles "$work/stand.csv" --json
    sed -n '/"sigma_d/p; /"log_det"/p; /"seconds"/p; /"condition"/p' "$work/stdout" > "$work/after"
    check "plan: $set: the same figures" near 1e-6 "$(tr -dc '0-9.\n' < "$work/before" | tr '\n' ' ')" \
        "$(tr -dc '0-9.\n' < "$work/after" | tr '\n' ' ')"
done
check "plan: its heading" test "$(head -n 1 "$work/stand.csv")" = number,alpha,beta,dwell,x,y,z
awk -F , 'NR > 1 { print $2, $3 }' "$work/stand.csv" > "$work/printed"
check "plan: its angles are those of Table 2" same "$work/table2" "$work/printed"
in=$work/stand.csv
accepts "plan: angles from standard input" plan --angles - --csv
in=/dev/null
check "plan: the same" same "$work/stand.csv" "$work/stdout"
accepts "plan: its directions as directions" plan --directions "$work/stand.csv"
accepts "plan: angles without a header" plan --angles "$work/table2"
printf 'beta,alpha\n90,30\n0,10\n0,60\n0,100\n0,150\n0,-80\n90,60\n90,150\n90,-80\n30,-90\n100,-90\n200,-90\n' \
    > "$work/pairs.csv"
accepts "plan: angles in two columns with names" plan --angles "$work/pairs.csv"
check "plan: the names decide which is which" matches "$work/stdout" '^ +1 +30 +90 +0\.5000 +0\.8660 +0\.0000$'
accepts "plan: angles to compare" plan --compare "angles:$work/table2" per-group:6
check "plan: Table 2 is 3 x 6" matches "$work/stdout" '^ln det .* 8\.9475 +8\.9475$'
bad_angles() { # bad_angles SENTENCE PATTERN LINE ...
    sentence=$1
    pattern=$2
    shift 2
    printf '%s\n' "$@" > "$work/bad.csv"
    refuses "plan: angles: $sentence" 3 "$pattern" plan --angles "$work/bad.csv"
}
bad_angles "no such column" 'bad\.csv:1: columns alpha and beta' alpha,gamma 1,2
bad_angles "four columns without a header" 'bad\.csv:1: columns alpha and beta' 1,2,3,4
bad_angles "a word" "bad\\.csv:3: beta 'x' is not a decimal" alpha,beta 1,2 1,x
bad_angles "a turn and more" "bad\\.csv:2: alpha '*361'* is out of range" alpha,beta 361,2
bad_angles "a negative dwell" 'bad\.csv:2: dwell .* is out of range' alpha,beta,dwell 1,2,-1
bad_angles "no dwell at all" 'no position has a dwell' alpha,beta,dwell 1,2,0
bad_angles "nothing" 'contains no position' alpha,beta
awk 'BEGIN { for (i = 0; i <= 3000; i++) print i % 360, 7 * i % 360 }' > "$work/many.csv"
refuses "plan: angles: too many" 3 'more than 3000 positions' plan --angles "$work/many.csv"
refuses "plan: angles: a missing file" 3 'nowhere: cannot be read' plan --angles "$work/nowhere"
refuses "plan: CSV and JSON" 2 'csv: cannot be combined' plan --csv --json
refuses "plan: CSV of a sweep" 2 'csv: needs a single set' plan --csv --sweep 5:6
refuses "plan: no CSV of a set that is refused" 1 'undetermined' plan --faces --csv
cp "$work/stand.csv" "$work/out/own.csv"
refuses "plan: a picture over its angles" 2 'would overwrite' plan --angles "$work/out/own.csv" \
    --svg "$work/out/own.csv"
rm -f "$work"/out/*

# ---- refused -----------------------------------------------------------------------------------

refuses "plan: four in a group" 1 '4 positions in a group are too few' plan --per-group 4
refuses "plan: one in a group" 1 '1 position in a group is too few' plan --per-group 1
for bad in 0 -6 5.5 1001 1e99 nan x '' ; do
    refuses "plan: '$bad' in a group" 2 'per-group' plan --per-group "$bad"
done
for bad in 1,2 1,2,3,4 1,2,x 1,2,nan 1,2,361 ',,' '1,2,' inf,0,0; do
    refuses "plan: start angles '$bad'" 2 'start' plan --start "$bad"
done
for bad in 8 145 9.5 x; do
    refuses "plan: $bad optimal directions" 2 'optimal' plan --optimal $bad
done
for bad in 4:6 5:1001 9:5 5 5:6:7 5-6 a:b 5: :5 +5:6; do
    refuses "plan: a sweep over $bad" 2 'sweep' plan --sweep $bad
done
for bad in 0,1,1 1,1 -1,1,1 nan,1,1 1,1,inf; do
    refuses "plan: limits $bad" 2 'limits' plan --limits=$bad
done
for option in noise dwell move budget; do
    refuses "plan: a negative $option" 2 "$option" plan "--$option=-1"
    refuses "plan: $option not a number" 2 "$option" plan "--$option" nan
done
refuses "plan: two sets" 2 'only one set' plan --edges --icosahedron
refuses "plan: start angles of an icosahedron" 2 'start: needs' plan --icosahedron --start 1,2,3
refuses "plan: limits of a given set" 2 'limits: chooses' plan --edges --limits 1,1,1
refuses "plan: a budget of a given set" 2 'budget: chooses' plan --edges --budget 100
refuses "plan: a sweep with a set" 2 'sweep: names' plan --edges --sweep 5:6
refuses "plan: an operand" 2 'one operand too many: a set is an option, such as --edges' plan edges faces
refuses "plan: angles in the number" 2 'use --start for the angles' plan --per-group 6:1,2,3
refuses "plan: a sweep with noise" 2 'sweep: does not use' plan --sweep 5:6 --noise 1e-4
refuses "plan: standard input twice" 2 'only one input' plan --compare directions:- directions:-
for bad in '--budget 1e308' '--dwell 1e-300' '--move 1e99' '--noise 1e300' '--noise 1e-300'; do
    # shellcheck disable=SC2086
    refuses "plan: an absurd number, $bad" 2 'must be within' plan $bad
done
for bad in 1e-300,1,1 1,1e300,1; do
    refuses "plan: absurd limits, $bad" 2 'limits: must be within' plan --optimal 12 --limits $bad
done
run plan --optimal 9
check "plan: nine positions are reported as unchecked" matches "$work/stdout" 'no redundancy'
refuses "plan: nothing to compare" 2 'compare: takes two' plan --compare
refuses "plan: one to compare" 2 'a second SET for --compare .one alone is an option: --edges. is missing' plan --compare edges
refuses "plan: three to compare" 2 'one operand too many: it takes only SET and a second SET for --compare' plan --compare edges edges edges
refuses "plan: an unknown word" 2 "'dodecahedron' is not a set" plan --compare edges dodecahedron
refuses "plan: what is not solvable is not compared" 1 'faces: ' plan --compare faces edges

# ---- pictures ----------------------------------------------------------------------------------

is_svg() { # an SVG document that is closed, with nothing from elsewhere
    head -n 1 "$1" | grep -q '^<svg xmlns="http://www.w3.org/2000/svg" ' &&
        tail -n 1 "$1" | grep -q '^</svg>$' &&
        [ "$(grep -c '<title>' "$1")" -eq 1 ] && ! grep -Eq '<script|href=|url\(|@import' "$1"
}
accepts "plan: a picture of a sweep" plan --sweep 5:16 --svg "$work/out/fig2.svg"
check "plan: it is SVG" is_svg "$work/out/fig2.svg"
check "plan: its axis is labelled" matches "$work/out/fig2.svg" 'number of positions'
# Other programs next to the curves: those of 12 positions left of 15, faces and edges at 18.
centre() { # centre CLASS: the middle of the first diamond of this class
    sed -n "s/^<polygon class=\"$1\" points=\"\([^\"]*\)\".*/\1/p" "$work/out/fig2.svg" |
        awk 'NF == 4 { gsub(/,/, " "); printf "%.1f %.1f", ($1 + $5) / 2, ($2 + $6) / 2; exit }'
}
at() { # at CLASS INDEX: a point of a curve
    sed -n "s/^<polyline class=\"$1\" points=\"\([^\"]*\)\".*/\1/p" "$work/out/fig2.svg" | tr ' ' '\n' |
        sed -n "$2p" | awk -F , '{ printf "%.1f %.1f", $1, $2 }'
}
check "plan: angles of faces and edges at 18, as low as those of 24" near 0.11 "$(centre 'c3 over')" \
    "$(at 'c3 curve' 2 | cut -d ' ' -f 1) $(at 'c3 curve' 4 | cut -d ' ' -f 2)"
check "plan: offsets of the icosahedron at 12, one step before 15" near 0.11 \
    "$(centre 'c1 hollow' | cut -d ' ' -f 1)" \
    "$(echo "$(at 'c1 curve' 1) $(at 'c1 curve' 2)" | awk '{ print 2 * $1 - $3 }')"
check "plan: nine rings" test "$(grep -c '^<circle class="c0 curve".* r="8"' "$work/out/fig2.svg")" -eq 10
for words in 'faces and edges, 18 positions: offsets 0.408, scale errors 0.527, angles 1.000' \
    'stand-12, 12 positions: offsets 0.500, scale errors 0.681, angles 1.155' \
    'icosahedron, 12 positions: offsets 0.500, scale errors 0.707, angles 1.118'; do
    check "plan: described: $words" matches "$work/out/fig2.svg" "Next to the curves, $words\."
done
accepts "plan: a picture of a sweep beyond them" plan --sweep 9:12 --svg "$work/out/none.svg"
check "plan: has no markers of other programs" lacks "$work/out/none.svg" 'icosahedron|stand-|c0 over|Beside'
accepts "plan: a picture of directions" plan --optimal 24 --svg "$work/out/directions.svg"
check "plan: it is SVG, too" is_svg "$work/out/directions.svg"
cp "$work/verticals.csv" "$work/out/<b>&\"x.csv"
accepts "plan: a hostile name" plan --directions "$work/out/<b>&\"x.csv" --svg "$work/out/hostile.svg"
check "plan: it is escaped" lacks "$work/out/hostile.svg" '<b>|&"'
cp "$work/verticals.csv" "$work/out/own.csv"
refuses "plan: a picture over its directions" 2 'would overwrite' plan --directions \
    "$work/out/own.csv" --svg "$work/out/own.csv"
check "plan: they are still there" same "$work/verticals.csv" "$work/out/own.csv"
rm -f "$work"/out/*
echo old > "$work/out/cal.json"
run plan --faces --svg "$work/out/cal.json"
check "plan: a refusal leaves the picture as it was" is_untouched
refuses "plan: a picture that cannot be written" 3 'nowhere/x\.svg' plan --svg "$work/nowhere/x.svg"
accepts "plan: a picture of a comparison" plan --compare edges icosahedron --svg "$work/x.svg"
check "plan: it is SVG as well" is_svg "$work/x.svg"

finish
