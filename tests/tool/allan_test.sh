#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of allan by its command line: allan_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

# ---- NIST SP 1065 ------------------------------------------------------------------------------

# Its set of 1000 points, and the deviations that it publishes.
nist() { # nist M: each point times 2147483647 / M, with both signs
    awk -v m="$1" 'BEGIN {
        for (n = 1234567890; i++ < 1000; n = 16807 * n % 2147483647) # below 2^53: exact
            printf "%.17g %.17g %.17g\n", n / m, -n / m, n / m
    }'
}
nist 2147483647 > "$work/fractions.txt"
nist 1 > "$work/integers.txt"

deviates() { # deviates AXIS "A B C": the deviations at the three times, to 1e-6 of each
    sed -n "s/^    \"$1\": \[\([0-9].*\)\],*\$/\1/p" "$work/stdout" | sed 's/,//g' |
        awk -v expected="$2" '{
            n = split(expected, e, " ")
            if (NF != n) exit 1
            for (i = 1; i <= n; i++) if (!($i / e[i] - 1 <= 1e-6 && $i / e[i] - 1 >= -1e-6)) exit 1
            found = 1
        } END { exit !found }' || { grep -A 4 adev "$work/stdout" >&2; return 1; }
}

agrees() { # agrees ESTIMATOR "A B C" ARGUMENTS ...: of fractions, and of integers with --lsb
    estimator=$1
    expected=$2
    shift 2
    for file in fractions integers; do
        unit=4.656612875245797e-10
        [ $file = integers ] || unit=1
        run allan "$work/$file.txt" --lsb $unit --rate 1 --tau 1,10,100 --json "$@"
        for axis in x y z; do
            check "NIST SP 1065, $estimator, $file, $axis" deviates $axis "$expected"
        done
    done
}
agrees overlapping '2.922319e-01 9.159953e-02 3.241343e-02'
agrees 'non-overlapping' '2.922319e-01 9.965736e-02 3.897804e-02' --apart
check "NIST SP 1065: the number of differences" [ "$(json "$work/stdout" count)" = '[999, 99, 9]' ]

# ---- what it finds -----------------------------------------------------------------------------

# 1 mg a sample at 100 Hz: white noise of 100 micro-g/sqrt(Hz).
echo 0.3 -0.4 0.9 > "$work/up.txt"
"$tool" simulate --plan "directions:$work/up.txt" --dwell 900 > "$work/rest.csv"
lsb=0.000598550415

inside() { # inside NAME LEAST MOST: each member of this name
    sed -n "s/^ *\"$1\": \([0-9.e-]*\),*\$/\1/p" "$work/stdout" | awk -v a="$2" -v b="$3" '
        !($1 >= a && $1 <= b) { bad = 1; print "    found: " $1 > "/dev/stderr" }
        END { exit bad || NR == 0 }'
}
accepts "white noise" allan "$work/rest.csv" --lsb $lsb --sigma 0.0001 --json
check "white noise is found to 3 %" inside white 0.000951 0.00101
check "and nothing but white noise" inside walk 0 0
check "and no bias instability" inside instability 0 0
# (N / sigma)^2 of the worst axis
check "the dwell is (N / sigma)^2" inside dwell 90 102
check "and gives the wanted sigma" inside dwell_sigma 0.0000999999 0.0001000001
check "it is limited by white noise" matches "$work/stdout" '"dwell_limit": "white noise"'
check "it has been reached" matches "$work/stdout" '"dwell_end": "reached"'
run allan "$work/rest.csv" --lsb $lsb --sigma 0.00001 --json
check "a time beyond the log" matches "$work/stdout" '"dwell_end": "beyond"'
run allan "$work/rest.csv" --json
check "no unit: it is in counts" inside white 1.59 1.69
check "no unit: it says so" matches "$work/stdout" '"unit": "input"'
check "no sigma, no floor: the longest time" matches "$work/stdout" '"dwell_end": "longest"'

# Only white noise: terms that are not visible are 0.
awk "$random_awk"'
    BEGIN {
        begin_random(1)
        print "t,x,y,z"
        for (i = 0; i < 6000; i++) printf "%.2f,%.5f,%.5f,%.5f\n", i / 100, normal(), normal(), normal() + 100
    }' > "$work/white.csv"
run allan "$work/white.csv" --json
check "white noise: a random walk of 0" matches "$work/stdout" '^ *"walk": 0,$'
check "white noise: no minus zero" lacks "$work/stdout" ' -0[],]'

# Bias that wanders: a random walk, K of 1e-5 m/s^2 in a step of 0.1 s, is 3.16e-5 m/s^2 sqrt(Hz).
awk "$random_awk"'
    BEGIN {
        begin_random(7)
        print "t,ax (m/s^2),ay (m/s^2),az (m/s^2)"
        for (i = 0; i < 100000; i++) {
            for (k = 0; k < 3; k++) b[k] += 1e-5 * normal()
            printf "%.1f,%.7f,%.7f,%.7f\n", i / 10, b[0] + 1e-3 * normal(), b[1] + 1e-3 * normal(),
                9.8 + b[2] + 1e-3 * normal()
        }
    }' > "$work/walk.csv"
accepts "a random walk" allan "$work/walk.csv" --json
check "a random walk: its unit comes from the header" matches "$work/stdout" '"unit": "m/s\^2"'
check "a random walk: K to 25 %" inside walk 2.37e-5 3.95e-5
check "a random walk: N to 5 %" inside white 3.0e-4 3.33e-4
check "a random walk: the dwell is about sqrt(3) N / K" inside dwell 13 22
check "a random walk: that is the floor" matches "$work/stdout" '"dwell_end": "floor"'
check "a random walk: it makes the floor" matches "$work/stdout" '"dwell_limit": "rate random walk"'
accepts "it prints" allan "$work/walk.csv"
check "the table names its units" matches "$work/stdout" 'white noise N, µg/√Hz'
check "the table has the velocity random walk" matches "$work/stdout" 'm/s/√h'
# (In the POSIX locale a non-breaking space is two characters for grep.)
check "it says how long to hold" matches "$work/stdout" \
    "^Hold each position 1[0-9](\\.[0-9])?$(printf '\302\240')s: "
run allan "$work/walk.csv" --sigma 1e-6
check "it says that no time is enough" matches "$work/stdout" '^No dwell brings the sigma'

# A filter of first order: short averaging times look better than they are.
awk "$random_awk"'BEGIN { begin_random(3); for (i = 0; i < 20000; i++) { y += 0.02 * (uniform() - 0.5 - y); print y, y, y } }' \
    > "$work/filtered.txt"
run allan "$work/filtered.txt" --rate 100
check "a filter is noticed" matches "$work/stdout" '^Not only this noise: on x y z the model does not fit'
run allan "$work/rest.csv"
check "without one, there is no such message" lacks "$work/stdout" 'Not only this noise'

# ---- gaps, parts, files ------------------------------------------------------------------------

# A hundred seconds are cut out: no window reaches across.
awk -F, 'NR == 1 || NR < 40000 || NR > 50000' "$work/rest.csv" > "$work/gap.csv"
accepts "a gap" allan "$work/gap.csv" --json
check "a gap is counted" [ "$(json "$work/stdout" gaps)" = 1 ]
awk -F, 'NR > 1 { print $2, $3, $4 }' "$work/gap.csv" > "$work/glued.txt"
count=$(json "$work/stdout" count)
run allan "$work/glued.txt" --rate 100 --json
check "a gap costs differences" [ "$count" != "$(json "$work/stdout" count)" ]
accepts "a part" allan "$work/rest.csv" --from 100 --to 199.995 --json
check "a part is 10000 samples" [ "$(json "$work/stdout" samples)" = 10000 ]
in=$work/rest.csv
run allan "$work/rest.csv" --json
sed '/source_file/d' "$work/stdout" > "$work/named"
run allan - --json
check "standard input gives the same" sh -c 'sed /source_file/d "$1" | cmp -s - "$2"' sh \
    "$work/stdout" "$work/named"
in=/dev/null
accepts "files" allan "$work/rest.csv" --out "$work/out/noise.json" --report "$work/out/noise.html" --json
check "--out is what --json prints" same "$work/stdout" "$work/out/noise.json"
check "--out is JSON" is_json "$work/out/noise.json"
check "the report is a page" is_page "$work/out/noise.html"
check "the report has its verdict" matches "$work/out/noise.html" 'Hold each position'
cp "$work/rest.csv" "$work/out/<b>&.csv"
accepts "a hostile name" allan "$work/out/<b>&.csv" --report "$work/out/hostile.html"
check "a hostile name is escaped" is_page "$work/out/hostile.html"
rm -f "$work"/out/*

# ---- refusals ----------------------------------------------------------------------------------

"$tool" simulate --plan edges > "$work/moves.csv"
# The first position ends after 5 s, in line 502.
run allan "$work/moves.csv" --out "$work/out/noise.json"
check "a log that moves is refused, with the place" was_refused 1 \
    'moves.csv:(49|5[0-4])[0-9]: not at rest: at (4\.[89]|5\.[0-4])[0-9]* s .*--from and --to'
check "and nothing is written" [ -z "$(ls "$work/out")" ]
accepts "but for its first position" allan "$work/moves.csv" --to 4.9
awk -F, 'NR == 1 || NR < 30000 || NR > 60000 { print; next }
    { OFS = ","; $3 += 200 * sin(NR / 3); print }' "$work/rest.csv" > "$work/shaken.csv"
refuses "a log that is shaken for a while" 1 'shaken.csv:[23][0-9]*: not at rest: .* of y scatter' \
    allan "$work/shaken.csv"
awk -F, 'NR > 1 { OFS = ","; $2 += 30 * (1 - exp(-NR / 6000)) } { print }' "$work/rest.csv" \
    > "$work/warm.csv"
accepts "a sensor that warms up is at rest" allan "$work/warm.csv"
awk 'BEGIN { for (i = 0; i < 1000; i++) print i % 7, i % 5, 3 }' > "$work/frozen.txt"
refuses "an axis that never changes" 1 'z never changes' allan "$work/frozen.txt" --rate 50
head -n 8 "$work/rest.csv" > "$work/short.csv"
refuses "a short log" 1 'show no noise of x .*log longer' allan "$work/short.csv"
head -n 2 "$work/rest.csv" > "$work/one.csv"
refuses "one sample" 1 '1 sample shows no noise of x .*log longer' allan "$work/one.csv" --rate 100
refuses "too high a rate" 2 'must be above 0, at most 1e\+12' allan "$work/rest.csv" --rate 1e13
refuses "no rate" 2 '--rate: is needed' allan "$work/glued.txt"
refuses "a time that is no multiple" 2 '--tau: 0.015 s .* not a multiple of the interval, 0.01 s' allan \
    "$work/rest.csv" --tau 0.015
refuses "a long time off the grid" 2 'must be a multiple of 0.02 s' allan "$work/rest.csv" --tau 50.01
refuses "times that descend" 2 '--tau: must ascend' allan "$work/rest.csv" --tau 1,0.1
refuses "a time that is no number" 2 'is not a decimal number' allan "$work/rest.csv" --tau 1,b
refuses "sigma 0" 2 '--sigma 0: must be above 0' allan "$work/rest.csv" --sigma 0
refuses "an unknown unit" 2 '--unit ft: must be g' allan "$work/rest.csv" --unit ft
refuses "two units" 2 '--lsb: states the unit' allan "$work/rest.csv" --unit g --lsb 1
# A gyroscope: only its header has the unit. The figures are those of the table without a header.
sed 's/^t,x,y,z/t,gx,gy,gz/' "$work/rest.csv" > "$work/turn.csv"
for unit in rad/s deg/s mdeg/s; do
    sed "1s|gx,gy,gz|gx ($unit),gy ($unit),gz ($unit)|" "$work/turn.csv" > "$work/turn_unit.csv"
    run allan "$work/turn_unit.csv" --columns gx,gy,gz --out "$work/out/turn.json"
    printed=$(echo "$unit" | sed 's/deg/°/')
    check "gyroscope: $unit" matches "$work/stdout" "^white noise N, $printed/√Hz "
    check "gyroscope: no acceleration" lacks "$work/stdout" 'm/s²|µg|velocity'
    check "gyroscope: $unit in JSON" matches "$work/out/turn.json" "^  \"unit\": \"$unit\","
    refuses "gyroscope: $unit is no noise of an accelerometer" 3 "turn.json: is the noise of a gyroscope \\($unit\\): run" \
        plan --limits 1,1,1 --allan "$work/out/turn.json"
done
run allan "$work/turn.csv" --columns gx,gy,gz
check "gyroscope: without a unit" matches "$work/stdout" '^white noise N, input units/√Hz '
for option in '--unit g' '--gravity 9.8'; do
    # shellcheck disable=SC2086 # words
    refuses "gyroscope: $option" 2 "${option% *}: gx gy gz are columns of a gyroscope; --lsb states rad/s per input unit: leave" \
        allan "$work/turn.csv" --columns gx,gy,gz $option
done
refuses "gyroscope: two units" 2 '--lsb: gx gy gz .* whose unit the header states: leave it out' \
    allan "$work/turn_unit.csv" --columns gx,gy,gz --lsb 2
run allan "$work/turn.csv" --columns gx,gy,gz
counts=$(awk '/^white noise N, input units/ { print $6 }' "$work/stdout")
run allan "$work/turn.csv" --columns gx,gy,gz --lsb 0.5
check "gyroscope: --lsb" near 0.001 "$(awk '/^white noise N, rad.s/ { print $5 }' "$work/stdout")" \
    "$(awk -v n="$counts" 'BEGIN { print n / 2 }')"
refuses "an end before the beginning" 2 '--to: is before --from' allan "$work/rest.csv" --from 3 --to 2
refuses "a part with nothing in it" 1 'no sample within' allan "$work/rest.csv" --from 5000
refuses "a result over the log" 2 'would overwrite LOG' allan "$work/rest.csv" --out "$work/rest.csv"
refuses "a report over the result" 2 '--report: is the file of --out' allan "$work/rest.csv" \
    --out "$work/out/a" --report "$work/out/a"
row=$(tail -n 1 "$work/short.csv")
printf '1,2\n%s\n' "$row" >> "$work/short.csv"
refuses "a malformed line" 3 'short.csv:9: ' allan "$work/short.csv"
refuses "no log" 3 'nowhere' allan "$work/nowhere"

# ---- plan --allan ------------------------------------------------------------------------------

noise() { # noise WHITE INSTABILITY WALK: of all axes, over a field of 10
    for axis in x y z; do
        printf '"%s": {"white": %s, "instability": %s, "walk": %s, "shortest": 0.01, "longest": 90},' \
            $axis "$1" "$2" "$3"
    done | sed 's/,$//; s/.*/{"gravity": 10, "noise": {&}}/' > "$work/noise.json"
}
rows() { # rows FAMILY: positions, dwell, sigma, seconds of its rows
    awk -v family="\"$1\"," '{ sub(/,$/, "", $2) }
        $1 == "\"family\":" { on = $2 "," == family }
        $1 == "\"positions\":" { n = $2 }
        $1 == "\"dwell\":" { dwell = $2 }
        $1 == "\"dwell_sigma\":" { sigma = $2 }
        $1 == "\"seconds\":" && on { print n, dwell, sigma, $2 }' "$work/stdout"
}
# The closed form of white noise: a program of n = 3 N positions has sigmas of sqrt(1 / N),
# sqrt(7 / (5 N)), sqrt(8 / N) times the noise of a position mean, N / sqrt(dwell), and 2 s are
# the minimum. Prints the number and time at the minimum of the total time.
least() { # least WHITE SETTLE MOVE DELTA DK GAMMA
    echo "$@" | awk '{
        for (n = 15; n <= 144; n += 3) {
            c = sqrt(3 / n) / $4
            if (sqrt(21 / 5 / n) / $5 > c) c = sqrt(21 / 5 / n) / $5
            if (sqrt(24 / n) / $6 > c) c = sqrt(24 / n) / $6
            dwell = ($1 * c) ^ 2 > 2 ? ($1 * c) ^ 2 : 2
            seconds = n * (dwell + $2) + (n - 1) * $3
            if (!best || seconds < best) { best = seconds; number = n }
        }
        printf "%d %.9f\n", number, best
    }'
}
for wanted in '0 5 1e-4 1e-4 3e-4' '2 0 2e-5 4e-5 1e-4' '0 0.5 1e-5 1e-5 1e-5' '1 20 3e-4 5e-5 1e-2'; do
    [ -z "$BRIEF" ] || [ "$wanted" = '0 5 1e-4 1e-4 3e-4' ] || continue
    # shellcheck disable=SC2086
    set -- $wanted
    noise 0.003 0 0 # over the field 3e-4
    run plan --limits "$3,$4,$5" --settle "$1" --move "$2" --allan "$work/noise.json" --json
    found=$(rows stand | awk '!n || $4 < best { best = $4; n = $1 } END { printf "%d %.9f", n, best }')
    # shellcheck disable=SC2086
    check "labour of white noise, $wanted: the minimum over the programs" near 1e-6 "$found" \
        "$(least 3e-4 $wanted)"
    check "labour of white noise, $wanted: the plan takes the overall minimum" near 1e-6 \
        "$(json "$work/stdout" seconds)" \
        "$({ rows stand; rows free; } | awk '!n++ || $4 < best { best = $4 } END { printf "%.9f", best }')"
done
set -- "$tool" "$work"

# Slow noise, without time lost: the factors of Barnes for n means.
barnes() { # each row's sigma is what they make of it
    rows "$1" | awk -v white="$2" -v b="$3" -v k="$4" '{
        square = white ^ 2 / $2
        square += 2 * log(2) / 3.14159265358979 * b ^ 2 * $1 * log($1) / (2 * ($1 - 1) * log(2))
        square += k ^ 2 * $2 / 3 * $1 / 2
        r = $3 / sqrt(square) - 1
        if (!(r < 1e-6 && r > -1e-6)) { bad = 1; print "    " $0, sqrt(square) > "/dev/stderr" }
    } END { exit bad || NR < 5 }'
}
limits='--limits 3e-5,3e-5,1e-4 --move 0'
noise 0.001 0.0002 0
# shellcheck disable=SC2086
run plan $limits --allan "$work/noise.json" --json
check "labour: flicker noise over n positions" barnes stand 1e-4 2e-5 0
noise 0.001 0 0.000004
# shellcheck disable=SC2086
run plan $limits --allan "$work/noise.json" --json
check "labour: a random walk over n positions" barnes free 1e-4 0 4e-7
noise 0.001 0.0002 0.000004
# shellcheck disable=SC2086
run plan $limits --allan "$work/noise.json" --json
check "labour: all three" barnes stand 1e-4 2e-5 4e-7
# A random walk continues during lost time: n means of T, P apart, scatter by K^2 (P (n + 1) - T) / 6.
noise 0.000001 0 0.000004
run plan --limits 3e-5,3e-5,1e-4 --move 30 --settle 3 --allan "$work/noise.json" --json
walked() {
    rows stand | awk '{
        r = $3 / sqrt(1e-14 / $2 + 16e-14 * (($2 + 33) * ($1 + 1) - $2) / 6) - 1
        if (!(r < 1e-6 && r > -1e-6)) exit bad = 1
    } END { exit bad || NR < 5 }'
}
check "labour: a random walk goes on between positions" walked

noise 0.001 0.0002 0.000004
accepts "labour prints" plan --limits 3e-5,3e-5,1e-4 --allan "$work/noise.json" --settle 1
check "labour: one row is chosen" [ "$(grep -c ' chosen$' "$work/stdout")" = 1 ]
check "labour: what binds is named" matches "$work/stdout" '(offsets|scale errors|angles) +chosen$'
accepts "labour draws" plan --limits 3e-5,3e-5,1e-4 --allan "$work/noise.json" --quiet \
    --svg "$work/out/labour.svg" --report "$work/out/labour.html"
check "labour: the picture is drawn" matches "$work/out/labour.svg" 'Total time against number'
check "labour: the report is a page" is_page "$work/out/labour.html"
check "labour: the report says why" matches "$work/out/labour.html" 'Number and dwell'
rm -f "$work"/out/*
"$tool" allan "$work/rest.csv" --lsb $lsb --out "$work/real.json" --quiet
accepts "labour takes what allan --out wrote" plan --limits 1e-4,1e-4,2e-4 --allan "$work/real.json"
refuses "labour: no dwell is long enough" 1 'no dwell meet the limits: the noise has a floor; ' \
    plan --limits 1e-6,1e-6,1e-6 --allan "$work/noise.json"
noise 0.001 0 0
refuses "labour: white noise has no floor" 1 'no dwell up to 1e6 s meet the limits; 144 positions' \
    plan --limits 1e-9,1e-9,1e-9 --allan "$work/noise.json"
noise 0.001 0.0002 0.000004
"$tool" allan "$work/rest.csv" --out "$work/counts.json" --quiet
refuses "labour: noise in counts alone" 3 'the length of the field is not known' \
    plan --limits 1e-4,1e-4,2e-4 --allan "$work/counts.json"
echo '{"gravity": 9.8, "noise": {"x": {"white": 1}}}' > "$work/half.json"
refuses "labour: an axis is missing" 3 'half.json: does not hold the noise of three axes' \
    plan --limits 1e-4,1e-4,2e-4 --allan "$work/half.json"
sed 's/"white": 0.001/"white": -1/' "$work/noise.json" > "$work/negative.json"
refuses "labour: negative noise" 3 'negative.json:1: negative noise' \
    plan --limits 1e-4,1e-4,2e-4 --allan "$work/negative.json"
refuses "labour without limits" 2 '--allan: chooses the set for --limits' \
    plan --allan "$work/noise.json"
noise 0.003 0 0
run plan --limits 1e-4,1e-4,3e-4 --allan "$work/noise.json" --json
before=$(json "$work/stdout" seconds)
run plan --limits 1e-4,1e-4,3e-4 --allan "$work/noise.json" --warm-up 900 --json
check "labour: the warm-up counts once" near 1e-6 "$(json "$work/stdout" seconds)" \
    "$(echo "$before" | awk '{ printf "%.9f", $1 + 900 }')"
check "labour: nine to eleven positions are not considered" test \
    "$(rows free | awk '!n || $1 < n { n = $1 } END { print n }')" = 12
run plan --limits 1e-4,1e-4,3e-4 --allan "$work/noise.json" --spare 30 --need-axes --json
check "labour: a redundancy of thirty" test "$({ rows free; rows stand; } | awk '$1 < 39' | wc -l)" -eq 0
check "labour: each axis up and down" test "$(json "$work/stdout" missing)" = '[]'
check "labour: and therefore no odd group" test "$(rows stand | awk '$1 / 3 % 2 == 1' | wc -l)" -eq 0
noise 0.001 0.0002 0.000004
for other in '--noise 1e-4' '--dwell 4' '--budget 100' '--sweep 5:9' --programs; do
    # shellcheck disable=SC2086
    refuses "labour with ${other% *}" 2 'cannot be combined with --allan' plan --limits 1e-4,1e-4,1e-4 \
        --allan "$work/noise.json" $other
done
refuses "labour over its noise" 2 '--svg: would overwrite the file of --allan' plan \
    --limits 1e-4,1e-4,1e-4 --allan "$work/noise.json" --svg "$work/noise.json"
run plan --dwell 5 --move 2 --settle 3 --json
check "--settle counts for every position" near 1e-9 "$(json "$work/stdout" seconds)" 178

finish
