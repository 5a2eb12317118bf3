#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests that nothing that the tool prints for people is wider than the terminal, and that help fits on
# one screen. width_test.sh path/to/invcal builddir
# JSON, CSV and generated sources are not for people.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
unset COLUMNS
commands=$("$tool" --help | sed -n 's/^  \([a-z]*\) .*/\1/p' | grep -v invcal)

# Lines of a file that are wider than $2 columns: characters of UTF-8, of which any but the first byte is
# 80 ... BF, without the sequences of a colour.
bytes=$(printf '\200-\277')
escape=$(printf '\033')
wider() { # FILE COLUMNS
    LC_ALL=C sed "s/$escape\[[0-9;]*m//g" "$1" | LC_ALL=C tr -d "$bytes" |
        LC_ALL=C awk -v most="$2" 'length > most'
}
printf '%s\n' '±±±' 'a²c4' "${escape}[1mabcd${escape}[0m" > "$work/ruler"
check "the ruler measures characters" [ -z "$(wider "$work/ruler" 4)" ]
check "and notices one too many" [ "$(wider "$work/ruler" 3 | wc -l)" -eq 2 ]

fits_in() { # COLUMNS FILE
    wide=$(wider "$2" "$1")
    [ -s "$2" ] && [ -z "$wide" ] || { echo "    ${wide:-nothing was printed}" >&2; return 1; }
}
run_in() { # COLUMNS ARGUMENTS ...
    COLUMNS=$1
    export COLUMNS
    [ "$1" ] || unset COLUMNS
    shift
    run "$@"
    unset COLUMNS
}
fits() { # fits ARGUMENTS ...
    for columns in '' 60 80 120; do
        run_in "$columns" "$@"
        check "COLUMNS=$columns: $*" fits_in "${columns:-80}" "$work/stdout"
    done
}

# ---- help --------------------------------------------------------------------------------------

is_screen() { fits_in 80 "$work/stdout" && [ "$(wc -l < "$work/stdout")" -le 24 ]; }
names_rest() { # COMMAND
    "$tool" "$1" --help all | cmp -s - "$work/stdout" || matches "$work/stdout" "invcal $1 --help all\$"
}
has_same() { "$tool" "$@" | cmp -s - "$work/stdout"; }
for c in $commands; do
    accepts "$c --help succeeds" "$c" --help
    check "$c --help is one screen" is_screen
    check "$c --help is complete, or names the rest" names_rest "$c"
    check "help $c is the same" has_same help "$c"
    sed '1,/^examples*:$/d; /^$/,$d; s/^  //' "$work/stdout" > "$work/run"
    check "the example of $c --help works" sh -c '
        mkdir "$2.dir" && ln -s "$3" "$2.dir/tests" && cd "$2.dir" && [ -s "$2" ] || exit 1
        invcal() { "$tool" "$@"; }
        set -e; tool=$1; . "$2"' sh "$tool" "$work/run" "$(cd "$here/../.." && pwd)/tests" > "$work/said"
    rm -rf "$work/run.dir"
    accepts "$c --help all succeeds" "$c" --help all
    check "help $c all is the same" has_same help "$c" all
    check "$c --help=all is the same" has_same "$c" --help=all
    check "$c --help all has exit codes" matches "$work/stdout" '^exit codes: 0 (good|calibrated)'
    "$tool" "$c" --help | awk '/^  --/ { print $1 }' > "$work/brief"
    awk '/^  --/ { print $1 }' "$work/stdout" > "$work/all"
    check "$c --help has options of --help all" sh -c '
        [ -s "$1" ] && ! grep -vxFf "$2" "$1"' sh "$work/brief" "$work/all"
    fits "$c" --help
    fits "$c" --help all
done
"$tool" calibrate --help > "$work/stdout"
for o in positions gravity out report json plan need; do
    check "calibrate --help has --$o" matches "$work/stdout" "^  --$o "
done
fits --help
accepts "help succeeds" help
check "help is --help" has_same --help
refuses "help of no command" 2 '^invcal: calibate: unknown command \(did you mean calibrate\?\)' help calibate
refuses "help of two commands" 2 "'plan': one operand too many: help takes one command" help calibrate plan
refuses "a slip in help" 2 '\(did you mean help\?\)' hepl
refuses "--help of a slip" 2 '\(did you mean calibrate\?\)' calibate --help

# ---- logs and tables ---------------------------------------------------------------------------

cd "$work" || exit 2
data=$(cd "$OLDPWD" && cd "$data" && pwd)
ln -s "$data" data
"$tool" simulate --plan edges > edges.csv
"$tool" simulate --plan per-group:6 --stand > stand.csv
"$tool" simulate --plan optimal:24 --outliers 3 > outliers.csv
"$tool" simulate --plan faces --dwell 60 --instability 0.0002 > rest.csv
"$tool" simulate --plan edges --gravity 1 --lsb 0.00001 --zero 8388608,8388608,8388608 > large.csv
"$tool" simulate --plan edges --truth truth.json > /dev/null
# Eighteen positions at each of two temperatures, an offset of 1 mg/K.
awk 'BEGIN { print "x,y,z,temperature,std,n"; d = sqrt(0.5)
    for (t = 10; t <= 40; t += 30) for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) for (k = -1; k <= 1; k++) {
        r = sqrt(i * i + j * j + k * k)
        if (r == 0 || r > 1.5) continue
        e = ((i * 7 + j * 3 + k * 5 + t) % 4 - 1.5) * 2e-5
        print i / r + t / 1000 + e ",", j / r - e ",", k / r + 2 * e ",", t ",", 0.001 ",", 500
    } }' > thermal.csv

fits calibrate edges.csv
fits calibrate edges.csv --units ins --zero 0,0,0 --lsb 0.0006 --tolerance 0.001,0.001,0.001 --need 0.001
fits calibrate edges.csv --nominal-name fourteen-bytes --nominal truth.json --latitude 55.7 --height 150
awk 'BEGIN { print "ax,ay,az,mx (uT),my (uT),mz (uT)"; for (i = 0; i < 3000; i++) { a = i / 40; b = 0.73 * i / 100
    print "0,0,1," 5 + 40 * sin(a) * cos(b) "," 40 * sin(a) * sin(b) "," 40 * cos(a) } }' > waved.csv
fits calibrate waved.csv --magnetometer
fits watch waved.csv --magnetometer
fits calibrate edges.csv --quadratic
fits calibrate edges.csv --cubic
fits calibrate edges.csv --robust --noise 0.00001
fits calibrate edges.csv --frame triangular --out out.json --report out.html
fits calibrate outliers.csv
fits calibrate outliers.csv --robust
fits calibrate large.csv --gravity 1 --robust
fits calibrate stand.csv --stand
fits calibrate stand.csv --stand --units ins --stand-zero 0,20
fits calibrate stand.csv --stand --stand-sense -1,1 --frame stand
fits calibrate stand.csv --plan per-group:6
fits calibrate thermal.csv --positions --gravity 1
fits calibrate thermal.csv --positions --gravity 1 --thermal 1
fits calibrate thermal.csv --positions --gravity 1 --thermal 1 --units ins
fits calibrate thermal.csv --positions --gravity 1 --thermal 2
for name in xsens_mti mpu9150_0 mpu9150_1 t265; do
    fits calibrate data/${name}_positions.csv --positions
    fits calibrate data/${name}_positions.csv --positions --units ins --keep-all --need 0.001
done
# A refusal prints for people only its line on stderr.
run calibrate data/xsens_mti_positions.csv
check "a refusal prints nothing on stdout" was_refused 1 'no rest'

fits allan rest.csv --to 59
fits allan rest.csv --to 59 --lsb 0.0006
fits allan rest.csv --to 59 --lsb 0.0006 --sigma 0.0001 --apart --out noise.json
fits allan rest.csv --to 59 --unit mg --sigma 100

fits plan
fits plan --faces
fits plan --per-group 7 --noise 0.0001
fits plan --per-group 300
fits plan --stand-24 --noise 0.0001 --units ins --bound 0.0002 --settle 2.5 --warm-up 600
fits plan --optimal 12 --grid 30 --weights --noise 0.0001 --bound 0.0002
fits plan --icosahedron --weights
fits plan --stand-12
fits plan --per-group 6 --start 1.234,2.345,3.456
fits plan --limits 0.4,0.6,1
fits plan --limits 0.4,0.6,1 --budget 300 --need-axes
fits plan --budget 200 --spare 2
fits plan --limits 0.001,0.001,0.001 --allan noise.json --settle 5 --warm-up 60
fits plan --limits 0.0001,0.0001,0.0001 --allan noise.json --units ins
fits plan --sweep 5:20
fits plan --programs
fits plan --programs --noise 0.0001 --units ins
fits plan --compare per-group:8 per-group:6 --noise 0.0001
fits plan --compare optimal:12 grid:30:12 --noise 0.0001 --units ins

for n in 1 2 3; do
    "$tool" calibrate edges.csv --quiet --serial "A$n" --device 'a board with a name' --date "2026-0$n-01" \
        --note 'a note that is long enough to go on in a second line of a terminal' --out "unit$n.json"
done
fits calibrate edges.csv --serial A1 --device 'a board with a name' --note 'a note that is long enough for two lines'
fits compare unit1.json unit2.json --as history
fits compare unit1.json unit2.json unit3.json --units ins
fits watch edges.csv
fits watch edges.csv --target 0.001,0.001,0.001 --units ins
fits watch edges.csv --plan edges --mean-sigma 0.001
fits watch edges.csv --plan optimal:18
fits watch stand.csv --allan noise.json --mean-sigma 0.001

# A command to be copied is not broken, or only with a backslash.
run_in 60 calibrate edges.csv --out calibration_of_the_left_unit.json
check "a command has a line of its own" matches "$work/stdout" \
    '^  invcal apply calibration_of_the_left_unit\.json LOG$'
run_in 60 calibrate edges.csv --out 'a calibration with a name that is as long as a line of it.json'
copied=$(sed -n '/^  invcal apply/,$p' "$work/stdout")
check "one that is too long has a backslash" matches "$work/stdout" '^  invcal apply \\$'
invcal() { printf '%s|' "$@"; }
check "and a shell takes it as one" [ "$(eval "$copied")" = \
    'apply|a calibration with a name that is as long as a line of it.json|LOG|' ]

# ---- COLUMNS -----------------------------------------------------------------------------------

run_in 60 calibrate edges.csv
cp "$work/stdout" sixty
run calibrate edges.csv
cp "$work/stdout" eighty
is_as() { # COLUMNS FILE
    run_in "$1" calibrate edges.csv
    same "$work/stdout" "$2"
}
check "60 columns are not 80" sh -c '! cmp -s sixty eighty'
check "fewer than 60 are 60" is_as 20 sixty
for senseless in 0 -5 wide 80x 99999999999; do
    check "COLUMNS=$senseless is ignored" is_as $senseless eighty
done
# A terminal has its own width.
# shellcheck disable=SC2016 # for the shell inside
if command -v script > /dev/null && script -qec true /dev/null > /dev/null 2>&1 < /dev/null; then
    export tool
    script -qec 'stty cols 60; TERM=dumb "$tool" calibrate edges.csv --report page.html --quiet; "$tool" plan --programs > plain
        NO_COLOR=1 "$tool" plan --programs' /dev/null < /dev/null | tr -d '\r' > typed
    run_in 60 plan --programs
    check "a terminal of 60 columns" same typed "$work/stdout"
    run plan --programs
    check "a file has 80 anyway" same plain "$work/stdout"
else
    echo "tool: the width of a terminal is not tried: script is not installed"
fi

finish
