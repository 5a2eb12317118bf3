#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of calibrate and apply by the command line: tool_test.sh path/to/invcal builddir
# Needs a POSIX shell, coreutils, awk and sed. Prints a line for each check.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

positions sphere 18 5 > "$work/good.csv"
cut -d, -f1-3 "$data/xsens_mti_positions.csv" | tail -n +2 > "$work/xsens.csv"

# ---- the command line --------------------------------------------------------------------------

good=$work/good.csv
accepts "--version succeeds" --version
check "--version prints the version of config.h" [ "$(cat "$work/stdout")" = "invcal $(awk '
    /^#define INVCAL_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $3; dot = "." } END { print v }' \
    "$here/../../include/invcal/config.h")" ]
"$tool" calibrate --help all > "$work/help"
for o in positions gravity frame zero lsb nominal nominal-name noise prior out json quiet; do
    check "calibrate --help all explains --$o" matches "$work/help" "^  --$o "
done
check "calibrate --help all has the unit of a magnetometer" matches "$work/help" '48\.5 or 48\.5uT'

see='see invcal calibrate --help'
refuses "no command is refused" 2 'COMMAND is missing; see invcal --help'
refuses "an unknown command is refused" 2 'polish: unknown command; see invcal --help' polish
refuses "a message is one line, whatever it quotes" 2 'a\?b\?\[2J: unknown command' \
    "$(printf 'a\nb\033[2J')"
refuses "an unknown option in place of a command is refused" 2 '--polish: unknown option' --polish
refuses "an operand after --version is refused" 2 "'more'" --version more
refuses "an unknown option is refused" 2 "--polish: unknown option; $see" calibrate --polish
refuses "a single dash before an option is refused" 2 "-json: unknown option" calibrate -json
refuses "an abbreviated option is refused" 2 '--grav: unknown' calibrate "$good" --grav 9.8
refuses "an option without its value is refused" 2 "--gravity: its value is missing; $see" \
    calibrate "$good" --positions --gravity
refuses "an option in place of a value is refused" 2 '--out: its value is missing' \
    calibrate "$good" --positions --out --json
refuses "an empty value is refused" 2 '--out: its value is empty' \
    calibrate "$good" --positions --out ''
refuses "a value for an option that has none is refused" 2 '--json: takes no value' \
    calibrate "$good" --positions --json=yes
refuses "an option given twice is refused" 2 "--gravity: given twice; $see" \
    calibrate "$good" --positions --gravity 9.8 --gravity=9.8
refuses "a missing operand is refused" 2 "LOG is missing; $see" calibrate --positions
refuses "an operand too many is refused" 2 "'more': one operand too many: it takes only LOG; options begin with --" \
    calibrate "$good" more --positions
refuses "apply without a log is refused" 2 'LOG is missing; see invcal apply --help' apply cal.json
refuses "apply with an option is refused" 2 '--json: unknown option' apply --json a b
refuses "apply of two standard inputs is refused" 2 'only one input' apply - -
refuses "calibrate with two standard inputs is refused" 2 'only one input' \
    calibrate - --positions --nominal -
refuses "position means without --positions are refused, and what to do" 1 \
    'no rest of two seconds.*; if each row is the mean of a position, add --positions; if each is a sample, state --rate, record' \
    calibrate "$good"

refuses_value() { # refuses_value OPTION VALUE PATTERN
    refuses_file "$1 '$2' is refused" 2 "^invcal: $1.*$3.*$see\$" "$good" "$1" "$2"
}
for v in 0 -0 -9.8; do
    refuses_value --gravity "$v" 'above 0'
    refuses_value --noise "$v" 'above 0'
done
refuses_value --gravity nan "'nan' is not a finite number"
refuses_value --gravity -inf "'-inf' is not a finite number"
for v in nine 9.8x 0x9 9,8 '9.8,' ' 9.8' 1e 1e+ . + 1.2.3; do
    refuses_value --gravity "$v" '(is not a decimal number|is empty|has a decimal comma|1 number expected)'
done
refuses_value --gravity 9,81 'decimals are written with a point, such as 9.81'
refuses_value --gravity 1e999 "'1e999' is too large"
refuses_value --zero 1,2 '3 numbers separated by commas expected'
refuses_value --zero 1,2,3,4 '3 numbers separated by commas expected'
refuses_value --zero 1,,3 "'' is empty"
refuses_value --zero 1,nan,3 "'nan' is not a finite number"
refuses_value --lsb 1,2 '3 numbers separated by commas expected, or one'
refuses_value --lsb 0 'not be 0'
refuses_value --lsb 1,0,1 'not be 0'
refuses_value --frame round 'symmetric, triangular or stand'
refuses_value --nominal-name a-very-long-heading 'at most 14'
refuses_value --prior 0.1,0.1,0.1 '--zero and --lsb, or --nominal'
refuses_file "a prior with --zero alone is refused" 2 '--prior: .*--lsb' \
    "$good" --zero 0,0,0 --noise 0.01 --prior 0.1,0.1,0.1
refuses_file "a prior without noise is refused with the reason" 2 '--prior: .*--noise, or columns' \
    "$good" --zero 0,0,0 --lsb 1 --prior 0.1,0.1,0.1
refuses_file "a negative prior is refused" 2 '--prior: a standard deviation must not be negative' \
    "$good" --zero 0,0,0 --lsb 1 --noise 0.01 --prior 0.1,-0.1,0.1
refuses_file "--nominal with --zero is refused" 2 '--nominal: .*leave out --zero' \
    "$good" --nominal x --zero 0,0,0
refuses_file "--nominal with --lsb is refused" 2 '--nominal: .*leave out --zero and --lsb' \
    "$good" --nominal x --lsb 1
accepts "an option takes its value after = as well" calibrate --gravity=9.8 --positions "$good"
accepts "a negative number is a value" calibrate "$good" --positions --zero -0.1,-0.2,0 --lsb 1
cp "$good" "$work/--odd"
check "-- ends the options" sh -c 'cd "$2" && "$1" calibrate --positions -- --odd > /dev/null' sh \
    "$tool" "$work"

# ---- real sensors ------------------------------------------------------------------------------

# reference FILE GRAVITY OFFSET TOLERANCE RMS TOLERANCE MAX TOLERANCE VERDICT
reference() {
    file=$data/${1}_positions.csv
    accepts "$1: is calibrated" calibrate "$file" --positions --gravity "$2" --json
    cp "$work/stdout" "$work/cal.json"
    check "$1: the offset is that of the reference" near "$4" "$(json "$work/cal.json" offset)" "$3"
    check "$1: the rms residual is that of the reference" \
        near "$6" "$(json "$work/cal.json" residual_rms)" "$5"
    check "$1: the largest residual is that of the reference" \
        near "$8" "$(json "$work/cal.json" residual_max)" "$7"
    check "$1: the verdict is $9" [ "$(json "$work/cal.json" verdict)" = "\"$9\"" ]
    check "$1: as many positions as rows" \
        [ "$(json "$work/cal.json" positions)" -eq $(($(wc -l < "$file") - 1)) ]
    accepts "$1: the calibration can be applied" apply "$work/cal.json" "$file"
    check "$1: applied, every position has the length of the field within the residuals" \
        awk -F, -v g="$2" -v max="$(json "$work/cal.json" residual_max)" 'NR > 1 {
            r = sqrt($1 * $1 + $2 * $2 + $3 * $3) / g - 1
            if (r < 0) r = -r
            if (r > most) most = r
        } END { exit !(most > max - 1e-8 && most < max + 1e-8) }' "$work/stdout"
    accepts "$1: a triangular frame" calibrate "$file" --positions --gravity "$2" --json \
        --frame triangular
    check "$1: the frame changes neither offset nor residuals" \
        near 1e-9 "$(json "$work/stdout" offset) $(json "$work/stdout" residual_rms)" \
        "$(json "$work/cal.json" offset) $(json "$work/cal.json" residual_rms)"
    check "$1: a triangular matrix has zeros below its diagonal" sh -c \
        'grep -A3 "\"matrix\"" "$1" | awk "NR == 3 && \$1 != \"[0,\" || NR == 4 &&
            (\$1 != \"[0,\" || \$2 != \"0,\") { exit 1 }"' sh "$work/stdout"
}
# From tests/reference/reference.py; those in m/s^2 with zero 0 and scale 1 in place of its nominal().
reference xsens_mti 9.81744 '33123.83073 33275.15503 32364.49374' 0.000006 \
    99.857e-6 0.0006e-6 214.43e-6 0.006e-6 rough
reference mpu9150_0 9.81 '0.1024225 0.0969186 0.3443504' 0.00000006 \
    170.121e-6 0.0006e-6 333.4e-6 0.06e-6 good
reference mpu9150_1 9.81 '0.0885715 0.0702243 0.3391512' 0.00000006 \
    191.123e-6 0.0006e-6 487.0e-6 0.06e-6 good
reference t265 9.8016 '-0.19196 0.57358 -0.23265' 0.000006 \
    497.27e-6 0.006e-6 1474.7e-6 0.06e-6 weak
check "t265: the three angles are named as undetermined" \
    [ "$(json "$work/cal.json" undetermined)" = '["gamma_xy", "gamma_xz", "gamma_zy"]' ]
run calibrate "$data/t265_positions.csv" --positions --gravity 9.8016
check "t265: the table says that it is weak, and in what" \
    matches "$work/stdout" '^Weak: angle xy, angle xz, angle zy are poorly determined'
check "t265: the table says which positions to add" \
    matches "$work/stdout" '^Next: add positions with the field midway between x and y, x and z'
check "nothing on standard output but the table" lacks "$work/stdout" '^invcal:'

# ---- the table ---------------------------------------------------------------------------------

ascii() { LC_ALL=C sed 's/±/+/g; s/²/2/g' "$1" > "$work/ascii"; }
# The command of `make demo`.
accepts "the demo runs" calibrate "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 \
    --zero 33123,33276,32360 --lsb 0.002409639,0.002421308,0.002409639 --nominal-name factory
ascii "$work/stdout"
cp "$work/ascii" "$work/demo"
check "the table names the file, the positions and the field" matches "$work/demo" \
    'xsens_mti_positions.csv: 38 positions, field 9.81744 m/s2$'
check "the table has the nominal column's name" matches "$work/demo" 'calibrated .* factory '
check "the table says where the nominal comes from" matches "$work/demo" \
    '^factory: zero and scale given'
check "the table has offsets, nominal and difference" matches "$work/demo" \
    '^offset x +33123\.83 \+ 0\.25 +33123\.00 +\+0\.83  counts$'
check "the table has scales as data sheets state them" matches "$work/demo" \
    '^scale x +414\.437 \+ 0\.026 +415\.000 +-0\.563  counts per m/s2$'
check "the table has scale errors" matches "$work/demo" '^scale error y +-0\.2176 \+ 0\.0034 +%$'
check "the table has angles" matches "$work/demo" '^angle zy +1\.2215 \+ 0\.0068 .*degrees'
check "the table has the residuals" matches "$work/demo" \
    '^residual rms +0\.0999 mg$'
check "the table has the residuals before" matches "$work/demo" 'rms before .*\(factory alone\)$'
check "the table has noise and degrees of freedom" matches "$work/demo" \
    '^noise .*7 degrees of freedom \(of samples: '
check "the table has a verdict" matches "$work/demo" '^Rough: the positions disagree by 3\.6 times the noise of the samples'
check "the table has a next step" matches "$work/demo" '^Next: look for a disturbance'
check "the columns of the table are aligned" awk '
    /^(offset|scale|angle)/ { at = index($0, " + "); if (first && at != first) exit 1; first = at }
    END { if (!first) exit 1 }' "$work/demo"
run calibrate "$work/xsens.csv" --positions --gravity 48.5
check "a field that is not gravity is not in m/s^2" lacks "$work/stdout" 'm/s|mg'
run calibrate "$data/xsens_mti_positions.csv" --positions --lsb 0.0024
check "--lsb alone leaves the zero open" matches "$work/stdout" \
    '^nominal: zero not stated, scale given'
run calibrate "$data/xsens_mti_positions.csv" --positions --zero 33123,33276,32360
check "--zero alone leaves the scale open" matches "$work/stdout" \
    '^nominal: zero given, scale not stated'
printf '%s\n' 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0,-1 .7,.7,0 .7,0,.7 0,.7,.7 > "$work/nine.csv"
run calibrate "$work/nine.csv" --positions --gravity 1
check "nine positions: the table says that nothing checks them" matches "$work/stdout" \
    '^No redundancy: '
check "nine positions: the table says what to do" matches "$work/stdout" \
    '^Next: add 3 or more positions'
check "nine positions: the noise is unknown" matches "$work/stdout" '^noise +unknown'

# ---- JSON --------------------------------------------------------------------------------------

run calibrate "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 --json
cp "$work/stdout" "$work/cal.json"
check "the JSON is JSON" is_json "$work/cal.json"
for m in invcal positions rejected gravity offset matrix frame nominal delta dk gamma sigma \
    interval95 noise degrees_of_freedom residual_rms residual_max residual_worst residual_before \
    condition verdict unchecked undetermined; do
    check "the JSON has \"$m\"" [ "$(grep -c "^  \"$m\": " "$work/cal.json")" -eq 1 ]
done
check "the JSON has no source without a prior" lacks "$work/cal.json" '"source"'
check "the JSON has no NaN or infinity" sh -c '! grep -Eiq "nan|inf[^o]" "$1"' sh \
    "$(sed '/"invcal"/d' "$work/cal.json" > "$work/numbers"; echo "$work/numbers")"
# of 38 hand-held positions 16 are more than 5 degrees from all previous ones
check "degrees of freedom are directions less nine" \
    [ "$(json "$work/cal.json" degrees_of_freedom)" = 7 ]
check "residual_worst counts from one" sh -c '
    "$1" apply "$2" "$3" | awk -F, -v worst="$4" "NR > 1 {
        r = sqrt(\$1 * \$1 + \$2 * \$2 + \$3 * \$3) / 9.81744 - 1
        if (r < 0) r = -r
        if (r > most) { most = r; at = NR - 1 }
    } END { exit at != worst }"' sh "$tool" "$work/cal.json" "$work/xsens.csv" \
    "$(json "$work/cal.json" residual_worst)"
accepts "--out writes a file" calibrate "$data/xsens_mti_positions.csv" --positions \
    --gravity 9.81744 --out "$work/saved.json"
check "--out writes the same as --json" same "$work/saved.json" "$work/cal.json"
check "the table says where it was saved" grep -Fq "Saved in $work/saved.json" \
    "$work/stdout"
# In its folder, as the path to it may contain a blank or a quote.
saves() { # NAME: prints the command behind `Next:`
    (cd "$work" && "$tool" calibrate xsens.csv --positions --out "$1" --report odd.html) |
        sed -n 's/^Next: correct readings with: invcal //p'
}
check "and the next command" [ "$(saves saved.json)" = 'apply saved.json LOG' ]
check "a path with a blank and a quote in it is quoted" \
    [ "$(saves "it's saved.json")" = "apply 'it'\\''s saved.json' LOG" ]
check "a shell takes it as one" sh -c 'cd "$1" && eval "\"\$2\" $3" > odd && test -s odd' sh \
    "$work" "$tool" "apply 'it'\\''s saved.json' xsens.csv"
check "the report quotes it, too" grep -q "apply [^ ]*it[^ ]*\\\\[^ ]*s saved.json[^ ]* LOG" "$work/odd.html"
accepts "--out and --json go together" calibrate "$data/xsens_mti_positions.csv" --positions \
    --gravity 9.81744 --out "$work/saved.json" --json
check "both hold the same" same "$work/saved.json" "$work/stdout"
run calibrate "$work/xsens.csv" --positions --gravity 9.81744 --json
check "without std and n the same parameters come out" near 0 "$(json "$work/stdout" offset)" \
    "$(json "$work/cal.json" offset)"
# rms over positions and axes of std lsb / sqrt(n), computed here
by_hand=$(awk -F, 'NR > 1 { for (i = 4; i <= 6; i++) { s += ($i * 0.0024) ^ 2 / $7 / 3 } }
    END { printf "%.3g", sqrt(s / (NR - 1)) }' "$data/xsens_mti_positions.csv")
run calibrate "$data/xsens_mti_positions.csv" --positions --gravity 9.81744 --lsb 0.0024
check "the noise from std and n is as computed by hand" matches "$work/stdout" "\(of samples: $by_hand\)"
run calibrate "$work/xsens.csv" --positions --gravity 9.81744 --json
observed=$(json "$work/stdout" noise)
# It counts as four residuals with 29 others; but one that is ten times what they show is not believed.
noise_of() { # TIMES EXPECTED: times what is observed
    run calibrate "$work/xsens.csv" --positions --gravity 9.81744 --json \
        --noise "$(awk -v n="$observed" "BEGIN { print $1 * n }")"
    awk -v n="$(json "$work/stdout" noise)" -v o="$observed" \
        "BEGIN { d = n / o - $2; exit !(d * d < 1e-5) }"
}
check "a noise stated above the residuals counts" noise_of 1.3 'sqrt((4 * 1.69 + 29) / 33)'
check "a noise stated ten times too large does not" noise_of 10 1
run calibrate "$work/nine.csv" --positions --gravity 1 --json
check "nine positions have no redundancy" [ "$(json "$work/stdout" verdict)" = '"no redundancy"' ]
check "without noise and redundancy sigma is null" [ "$(grep -c 'null, null, null' \
    "$work/stdout")" -eq 4 ]
check "without noise and redundancy the noise is null" [ "$(json "$work/stdout" noise)" = null ]
run calibrate "$work/nine.csv" --positions --gravity 1 --json --noise 0.01
check "with stated noise nine positions have a sigma" lacks "$work/stdout" null

run calibrate "$good" --positions --zero 0.30000000000000004,0.1,-1e-7 --lsb 1 --json
check "numbers are as short as possible, and read back exactly" matches "$work/stdout" \
    '^    "zero": \[0\.30000000000000004, 0\.1, -1e-07\],$'

# ---- an earlier calibration, priors ------------------------------------------------------------

accepts "an earlier calibration is a nominal" calibrate "$work/xsens.csv" --positions \
    --gravity 9.81744 --nominal "$work/cal.json" --json
check "it leads to the same calibration" near 1e-3 "$(json "$work/stdout" offset)" \
    "$(json "$work/cal.json" offset)"
check "and to no deviation from it" near 1e-6 "$(json "$work/stdout" delta) $(json \
    "$work/stdout" dk) $(json "$work/stdout" gamma)" '0 0 0 0 0 0 0 0 0'
check "its matrix is in the nominal" [ "$(grep -c '^    "matrix": ' "$work/stdout")" -eq 1 ]
check "residual_before is then the residual" near 1e-9 \
    "$(json "$work/stdout" residual_before)" "$(json "$work/stdout" residual_rms)"
in=$work/cal.json
accepts "it may come from the standard input" calibrate "$work/xsens.csv" --positions \
    --gravity 9.81744 --nominal -
in=/dev/null
ascii "$work/stdout"
check "the table says that it is an earlier calibration" matches "$work/ascii" \
    '^nominal: zero and scale from an earlier calibration'
check "scales are those of the earlier calibration" matches "$work/ascii" \
    '^scale x +414\.437 \+ 0\.026 +414\.437 +\+0\.000  '
printf '{"offset": [1, 2, 3]}' > "$work/half.json"
refuses_file "an earlier calibration without a matrix is refused" 3 \
    'half\.json:1: no member "matrix"' "$work/xsens.csv" --nominal "$work/half.json"

head -n 3 "$good" > "$work/three.csv"
prior="--zero 0,0,0 --lsb 1 --noise 0.002 --prior 0.05,0.05,0.02"
accepts "with a prior three positions will do" calibrate "$work/three.csv" --positions $prior --json
check "source names what the data determined" [ "$(grep -Ec '^    "(delta|dk|gamma)_.*": "(data|prior)"' \
    "$work/stdout")" -eq 9 ]
check "source says prior for some" matches "$work/stdout" '"gamma_..": "prior"'
accepts "with a prior the table shows what it determined" calibrate "$work/three.csv" --positions $prior
check "the table names what the prior determined" matches "$work/stdout" '^Determined by the prior rather than'
head -n 7 "$good" > "$work/seven.csv"
run calibrate "$work/seven.csv" --positions --zero 0,0,0 --lsb 1 --noise 0.002 --prior 1e-6,0,0 --json
check "a narrow prior on offsets: they come from it, scales and angles from the data" \
    [ "$(grep -Ec '"delta_.": "prior"|"(dk|gamma)_.*": "data"' "$work/stdout")" -eq 9 ]
run calibrate "$work/seven.csv" --positions --zero 0,0,0 --lsb 1 --noise 0.002 --prior 0,0,1e-6 --json
check "a narrow prior on angles: they come from it" \
    [ "$(grep -Ec '"gamma_..": "prior"|"(dk|delta)_.*": "data"' "$work/stdout")" -eq 9 ]
refuses_file "a prior on offsets alone needs six positions" 1 \
    '3 positions are too few: 6 are needed' "$work/three.csv" --zero 0,0,0 --lsb 1 --noise 0.002 \
    --prior 0.05,0,0

# ---- formats of the table ----------------------------------------------------------------------

# All but the name of the file and its CRC.
result() { grep -v '^  "source_' "$work/stdout"; }
run calibrate "$work/xsens.csv" --positions --json
result > "$work/expected.json"
is_expected() { [ "$code" -eq 0 ] && result | cmp -s - "$work/expected.json"; }
same_result() { # same_result SENTENCE FILE
    run calibrate "$2" --positions --json
    check "$1" is_expected
}
f=$work/format.csv
tr , ';' < "$work/xsens.csv" > "$f"; same_result "semicolons separate" "$f"
tr , '\t' < "$work/xsens.csv" > "$f"; same_result "tabs separate" "$f"
tr , ' ' < "$work/xsens.csv" > "$f"; same_result "blanks separate" "$f"
sed 's/,/   /g; s/^/  /; s/$/  /' "$work/xsens.csv" > "$f"; same_result "many blanks separate" "$f"
sed 's/,/ , /g; s/^/ /; s/$/ /' "$work/xsens.csv" > "$f"
same_result "blanks around fields do not matter" "$f"
sed 's/,/","/g; s/^/"/; s/$/"/' "$work/xsens.csv" > "$f"; same_result "quotes do not matter" "$f"
sed 's/$/\r/' "$work/xsens.csv" > "$f"; same_result "lines may end with CR LF" "$f"
{ printf '\357\273\277'; cat "$work/xsens.csv"; } > "$f"; same_result "a byte order mark is fine" "$f"
{ printf '\357\273\277x,y,z\r\n'; sed 's/$/\r/' "$work/xsens.csv"; } > "$f"
same_result "byte order mark, header and CR LF together" "$f"
{ printf '# a comment; with, separators\n\n  # another\n'; sed 's/$/\n\n#/' "$work/xsens.csv"; } > "$f"
same_result "comments and empty lines are skipped" "$f"
printf %s "$(cat "$work/xsens.csv")" > "$f"; same_result "the last line may lack its end" "$f"
awk -F, '{ printf "%.4fe1,+%.5fE+0,%d.\n", $1 / 10, $2, $3 }' "$work/xsens.csv" > "$f"
accepts "numbers may have signs and exponents" calibrate "$f" --positions
in=$work/xsens.csv
same_result "- reads standard input" -
in=/dev/null
for h in x,y,z X,Y,Z ax,ay,az acc_x,acc_y,acc_z Accel_X,Accel_Y,Accel_Z mx,my,mz \
    mag_x,mag_y,mag_z mean_x,mean_y,mean_z '"x", " y" ,z '; do
    { echo "$h"; cat "$work/xsens.csv"; } > "$f"
    same_result "a header may be $h" "$f"
done
awk -F, 'BEGIN { print "face;z;note;x;y;t" } { print "p" NR ";" $3 ";;" $1 ";" $2 ";nan" }' \
    "$work/xsens.csv" > "$f"
same_result "a header sorts columns; others may hold anything" "$f"
awk -F, 'BEGIN { print ",x,y,z" } { print NR "," $0 }' "$work/xsens.csv" > "$f"
same_result "a column without a name is ignored" "$f"

# The table shows the noise that a file states.
stated() { # stated SENTENCE FILE: the noise as in $work/expected
    run calibrate "$2" --positions --lsb 0.0048,0.0012,0.0024
    sed -n 's/^noise.*of samples: \(.*\))$/\1/p' "$work/stdout" > "$work/noise"
    check "$1" sh -c '[ -s "$1" ] && cmp -s "$1" "$2"' sh "$work/noise" "$work/expected"
}
n7=$data/xsens_mti_positions.csv
run calibrate "$n7" --positions --lsb 0.0048,0.0012,0.0024
sed -n 's/^noise.*of samples: \(.*\))$/\1/p' "$work/stdout" > "$work/expected"
sed 1d "$n7" > "$f"
stated "seven columns are x y z std_x std_y std_z n" "$f"
awk -F, 'BEGIN { print "mean_x,std_y,mean_y,count,std_x,mean_z,std_z" }
    NR > 1 { print $1 "," $5 "," $2 "," $7 "," $4 "," $3 "," $6 }' "$n7" > "$f"
stated "std_x, std_y, std_z and count may stand anywhere" "$f"
sed 's/n_samples/N/' "$n7" > "$f"
stated "the number of samples may be called N" "$f"
sed 1d "$n7" | cut -d, -f1-4,7 > "$f"
run calibrate "$f" --positions --lsb 0.0048,0.0012,0.0024
sed -n 's/^noise.*of samples: \(.*\))$/\1/p' "$work/stdout" > "$work/expected"
check "five columns are x y z std n" [ "$(cat "$work/expected")" = "$(awk -F, '
    { s += $4 ^ 2 / $5 * (0.0048 ^ 2 + 0.0012 ^ 2 + 0.0024 ^ 2) / 3 }
    END { printf "%.3g", sqrt(s / NR) }' "$f")" ]
{ echo 'x,y,z,std,count'; cat "$f"; } > "$work/f2"
stated "one std may stand for all axes" "$work/f2"
{ echo 'x,y,z,std_x,n'; cat "$f"; } > "$work/f2"
run calibrate "$work/f2" --positions
check "std_x alone gives no noise" lacks "$work/stdout" stated:
# x, y and z have noise in proportion to their own scales
run calibrate "$n7" --positions --lsb 0.0048,0.0012,0.0024
check "the noise of each axis counts with its scale" matches "$work/stdout" "of samples: $(awk -F, '
    NR > 1 { s += (($4 * 0.0048) ^ 2 + ($5 * 0.0012) ^ 2 + ($6 * 0.0024) ^ 2) / $7 / 3 }
    END { printf "%.3g", sqrt(s / (NR - 1)) }' "$n7")"

# ---- malformed tables --------------------------------------------------------------------------

# A bad fifth line in a good table, by columns x,y,z; also as a log for apply.
cp "$work/cal.json" "$work/apply.json"
bad_row() { # bad_row SENTENCE ROW PATTERN
    awk -v row="$2" 'NR == 5 { print row; next } { print }' "$good" > "$work/bad.csv"
    refuses_file "calibrate: $1" 3 "bad\.csv:5: $3" "$work/bad.csv"
    refuses "apply: $1" 3 "bad\.csv:5: $3" apply "$work/apply.json" "$work/bad.csv"
}
bad_row "too few columns" '1,2' '2 columns, but line 1 has 3, separated by commas'
bad_row "too many columns" '1,2,3,4' '4 columns, but line 1 has 3'
bad_row "a comma at the end" '1,2,3,' '4 columns, but line 1 has 3'
bad_row "another separator" '1;2;3' '1 column, but line 1 has 3, separated by commas'
bad_row "a first column that is empty" ',2,3' 'column 1 \(x\) is empty'
bad_row "a column that is empty" '1,,3' 'column 2 \(y\) is empty'
bad_row "a column of blanks" '1,  ,3' 'column 2 \(y\) is empty'
bad_row "a last column that is empty" '1,2,' 'column 3 \(z\) is empty'
bad_row "a word" '1,two,3' "column 2 \(y\): 'two' is not a decimal number"
bad_row "a number with a unit" '1,2,3m' "column 3 \(z\): '3m' is not a decimal number"
bad_row "two numbers in a column" '1 1,2,3' "column 1 \(x\): '1 1' is not a decimal number"
bad_row "nan" '1,2,nan' "column 3 \(z\): 'nan' is not a finite number"
bad_row "-NaN" '-NaN,2,3' "column 1 \(x\): '-NaN' is not a finite number"
bad_row "inf" '1,+inf,3' "column 2 \(y\): '\+inf' is not a finite number"
bad_row "Infinity" '1,Infinity,3' "column 2 \(y\): 'Infinity' is not a finite number"
bad_row "a hexadecimal number" '0x1p3,2,3' "column 1 \(x\): '0x1p3' is not a decimal number"
bad_row "a number that overflows" '1,1e400,3' "column 2 \(y\): '1e400' is too large a number"
bad_row "a sign alone" '-,2,3' "column 1 \(x\): '-' is not a decimal number"
bad_row "a quote left open" '1,"2,3' 'column 2: the quotes do not match'
bad_row "something after a quote" '1,"2"2,3' 'column 2: the quotes do not match'
bad_row "a long word, which is cut" "1,$(printf '%01000d' 0 | tr 0 w),3" "column 2 \(y\): 'w+\.\.\.' is not"
bad_row "a terminal's control sequence" "$(printf '1,\033[2J,3')" 'byte 3 of the line has the value 27'

with_bytes() { # with_bytes SENTENCE PATTERN, the bytes by printf in $bytes
    { head -n 4 "$good"; printf "$bytes"; tail -n +6 "$good"; } > "$work/bad.csv"
    refuses_file "calibrate: $1" 3 "$2" "$work/bad.csv"
    refuses "apply: $1" 3 "$2" apply "$work/apply.json" "$work/bad.csv"
}
bytes='1,2,\0003\n'; with_bytes "a NUL byte" 'bad\.csv:5: byte 5 .* 0: not a text file'
bytes='1,2,3\r4,5,6\n'; with_bytes "a carriage return inside a line" \
    "bad\.csv:5: byte 6 .* carriage return \(CR\), .*: tr '.r' '.n' < log\.csv > lines\.csv$"
bytes='1,2,\377\n'; with_bytes "a byte that is no UTF-8" "bad\.csv:5: column 3 \(z\)"

bad_file() { # bad_file SENTENCE PATTERN: the file $work/bad.csv
    refuses_file "calibrate: $1" 3 "$2" "$work/bad.csv"
    refuses "apply: $1" 3 "$2" apply "$work/apply.json" "$work/bad.csv"
}
: > "$work/bad.csv"; bad_file "an empty file" 'bad\.csv: is empty'
printf '\n\n# only\n \t \n' > "$work/bad.csv"; bad_file "nothing but comments" 'bad\.csv: is empty'
printf '\357\273\277' > "$work/bad.csv"; bad_file "nothing but a byte order mark" 'is empty'
echo x,y,z > "$work/bad.csv"; bad_file "nothing but a header" 'bad\.csv: has a header, but no'
printf 'x,y,z' > "$work/bad.csv"; bad_file "nothing but a header without end" 'has a header'
{ echo a,b,c; cat "$good"; } > "$work/bad.csv"
bad_file "a header of unknown names" 'bad\.csv:1: the header names no columns x, y, z'
{ echo x,y,z,y; sed 's/$/,1/' "$good"; } > "$work/bad.csv"
bad_file "a header with a name twice" "bad\.csv:1: x, y and z are there twice \('y' and 'y'\)"
{ echo x,y,z,n,N; sed 's/$/,1,1/' "$good"; } > "$work/bad.csv"
bad_file "a header with n twice" "bad\.csv:1: more than one column could be 'n'"
{ echo x,y,3; cat "$good"; } > "$work/bad.csv"
bad_file "a header with a number" "bad\.csv:1: column 1 \(x\): 'x' is not a decimal number"
awk -F, 'BEGIN { print "x,y,z,mx,my,mz" } { print $0 "," $0 }' "$good" > "$work/bad.csv"
bad_file "an unnamed sensor and a magnetometer in one file" \
    "x, y and z are there twice \('x' and 'mx'\): choose one set with --columns, or delete"
{ echo 'x,y,z,t,time,n,count'; sed 's/$/,1,1,1,1/' "$good"; } > "$work/bad.csv"
bad_file "two columns of one meaning" 'more than one column could be'
awk '{ print 1 }' "$good" > "$work/bad.csv"
bad_file "one column" 'bad\.csv:1: 1 column, separated by blanks, without a header: expected are 3 \('
sed 's/$/,1,1,1,1,1/' "$good" > "$work/bad.csv"
bad_file "eight columns" '8 columns, separated by commas, without a header: expected are 3 .*header that names'
printf '1,5;2,5;3,5\n' > "$work/bad.csv"
bad_file "decimal commas" "bad\.csv:1: column 1 \(x\): '1,5' has a decimal comma"
awk 'BEGIN { for (i = 0; i < 300; i++) printf "%d,", i; print 0 }' > "$work/bad.csv"
bad_file "300 columns" 'more than 256 columns'
head -c 4096 /dev/urandom > "$work/bad.csv"; bad_file "random bytes" 'bad\.csv'
{ printf '\0\0\0'; head -c 4096 /dev/urandom; } > "$work/bad.csv"
bad_file "binary data" 'bad\.csv:1: byte 1 of the line has the value 0: not a text file'
printf '\377\376x\0,\0y\0,\0z\0\n\0' > "$work/bad.csv"
bad_file "a text in UTF-16" 'bad\.csv: this is UTF-16 text: save it as UTF-8'
sed 's/$/,1/' "$good" > "$work/bad.csv"
refuses_file "calibrate: four columns without names" 3 \
    'bad\.csv:1: 4 columns, .* or a header that names them' "$work/bad.csv"
rm "$work/bad.csv"
bad_file "a missing file" 'bad\.csv: cannot be read: No such file'
mkdir "$work/bad.csv"; bad_file "a directory" 'bad\.csv: is a directory'
rmdir "$work/bad.csv"
ln -s bad.csv "$work/bad.csv"; bad_file "a link to itself" 'bad\.csv: cannot be read'
rm "$work/bad.csv"
cp "$good" "$work/bad.csv"
chmod 000 "$work/bad.csv"
if [ ! -r "$work/bad.csv" ]; then # root may read everything
    bad_file "a file without permission" 'cannot be read: Permission denied'
fi
rm -f "$work/bad.csv"
refuses_file "an empty standard input" 3 'standard input: is empty' -
in=$work
refuses_file "a directory as standard input" 3 'standard input: is a directory' -
in=/dev/null

# std and n
five_columns() { # five_columns STD N
    awk -v tail="$1,$2" 'NR == 5 { print $0 "," tail; next } { print $0 ",0.01,100" }' "$good" \
        > "$work/bad.csv"
}
five_columns -0.01 100
refuses_file "a negative std" 3 'bad\.csv:5: column 4 \(std_x\): the standard deviation is negative' "$work/bad.csv"
five_columns 1e200 100
refuses_file "an absurd std" 3 'bad\.csv:5: column 4 \(std_x\)' "$work/bad.csv"
five_columns 0.01 0
refuses_file "a mean of no sample" 3 'bad\.csv:5: column 5 \(n\)' "$work/bad.csv"
five_columns 0.01 nan
refuses_file "n is nan" 3 "bad\.csv:5: column 5 \(n\): 'nan'" "$work/bad.csv"

# ---- lines and files without end: memory is limited where the system can ------------------------

limit=20480 # KiB of address space: 13000 are static, and 10 MB more do not fit
# shellcheck disable=SC3045 # tried first: where there is no ulimit -v, there is no limit
if ! (ulimit -v $limit && "$tool" --version) > /dev/null 2>&1; then
    limit= # the tool itself needs more, as under a sanitizer
fi
run_limited() {
    # shellcheck disable=SC3045
    ([ -z "$limit" ] || ulimit -v $limit
        exec "$tool" "$@") > "$work/stdout" 2> "$work/stderr" < "$in"
    code=$?
}
long='the line is longer than 65536 bytes'
{ head -n 4 "$good"; head -c 10000000 /dev/zero | tr '\0' 1; echo; } > "$work/bad.csv"
run_limited calibrate "$work/bad.csv" --positions
check "calibrate: a line of 10 MB" was_refused 3 "bad\.csv:5: $long"
run_limited apply "$work/apply.json" "$work/bad.csv"
check "apply: a line of 10 MB" was_refused 3 "bad\.csv:5: $long"
head -c 30000000 /dev/zero | tr '\0' ' ' > "$work/bad.csv"
run_limited calibrate "$work/bad.csv" --positions
check "calibrate: a first line of 30 MB of blanks" was_refused 3 "bad\.csv:1: $long"
yes 1,2,3 | head -n 20000 | tr '\n' '\r' > "$work/bad.csv"
run_limited calibrate "$work/bad.csv" --positions
check "calibrate: lines that end with CR alone" was_refused 3 "bad\.csv:1: byte 6 .* \(CR\), which alone does not"
head -c 30000000 /dev/zero > "$work/bad.csv"
run_limited calibrate "$work/bad.csv" --positions
check "calibrate: 30 MB of zeros" was_refused 3 "bad\.csv:1: "
{ printf '{"offset": ['; head -c 30000000 /dev/zero | tr '\0' 1; echo; } > "$work/bad.json"
run_limited apply "$work/bad.json" "$work/log.csv"
check "apply: a calibration with a number of 30 MB" was_refused 3 'bad\.json:1: .* too long'
{ printf '{"'; head -c 10000000 /dev/zero | tr '\0' 1; echo '": 1}'; } > "$work/bad.json"
run_limited apply "$work/bad.json" "$work/log.csv"
check "apply: a calibration with a name of 10 MB" was_refused 3 'bad\.json:1: no member'
head -c 10000000 /dev/zero | tr '\0' '[' > "$work/bad.json"
run_limited apply "$work/bad.json" "$work/log.csv"
check "apply: a calibration of 10 MB of brackets" was_refused 3 'bad\.json:1: '
awk 'BEGIN { printf "{\"deep\": "; for (i = 0; i < 99999; i++) printf "[" }' > "$work/bad.json"
run_limited apply "$work/bad.json" "$work/log.csv"
check "apply: a calibration nested too deep" was_refused 3 'bad\.json:1: .* nested too deep'
rm -f "$work/bad.csv" "$work/bad.json"
awk 'BEGIN { print "t,x,y,z"; for (i = 0; i < 300000; i++) print i / 100 "," i ",1,2" }' \
    > "$work/long.csv"
run_limited apply "$work/apply.json" "$work/long.csv" --quiet
check "apply: a log of 300,000 readings" succeeded
check "apply: as many readings out as in" [ "$(wc -l < "$work/stdout")" -eq 300001 ]
{ head -n 50001 "$work/long.csv"; echo 1,2,3,four; } > "$work/bad.csv"
run_limited apply "$work/apply.json" "$work/bad.csv"
check "apply: nothing is printed if the last of many is bad" was_refused 3 'bad\.csv:50002: col'
rm -f "$work/long.csv"
awk 'BEGIN { for (i = 0; i < 65535; i++) print "1 2 3" }' > "$work/bad.csv"
refuses_file "more positions than the library takes" 3 'bad\.csv:65535: more than 65534' "$work/bad.csv"
rm -f "$work/bad.csv"

# ---- data that cannot be calibrated -------------------------------------------------------------

# Each refusal with --json: an object on stdout, a line on stderr.
refused_in_json() { # refused_in_json ERROR
    { [ "$code" -eq 1 ] && says . && grep -Eq "^  \"error\": \"$1\",\$" "$work/stdout" &&
        grep -q '^  "reason": ".*",$' "$work/stdout" &&
        grep -Eq '^  "undetermined": \[.*\],$' "$work/stdout" && is_json "$work/stdout"; } || complain
}
hopeless() { # hopeless SENTENCE FILE ERROR PATTERN ARGUMENTS ...
    name=$1
    file=$2
    error=$3
    pattern=$4
    shift 4
    refuses_file "$name" 1 "$pattern" "$file" "$@"
    run calibrate "$file" --positions --json "$@"
    check "$name, in JSON" refused_in_json "$error"
}
f=$work/hopeless.csv
for n in 1 2 5 8; do
    head -n $n "$good" > "$f"
    hopeless "$n positions" "$f" 'too few' \
        "hopeless\.csv: $n positions? (is|are) too few: 9 are needed, 12 or more"
done
for family in plane cone circles repeated; do
    for s in 1 2 3 4 5; do
        positions $family 18 $s > "$f"
        hopeless "$family $s" "$f" '(undetermined|not an ellipsoid)' 'hopeless\.csv: the '
    done
done
for family in cap hyperboloid cylinder noise; do
    for s in 1 2 3 4 5; do
        positions $family 18 $s > "$f"
        hopeless "$family $s" "$f" '(undetermined|not an ellipsoid|out of range)' 'hopeless\.csv'
    done
done
awk 'BEGIN { for (i = 0; i < 20; i++) print cos(i) * 9.8 "," sin(i) * 9.8 ",0" }' > "$f"
hopeless "turned about z only" "$f" undetermined \
    'undetermined: offset z, scale z, angle xz, angle zy; add positions with the field along \+z and -z, and midway between x and z, z and y$'
check "the names are those of the library" matches "$work/stdout" \
    '"undetermined": \["delta_z", "dk_z", "gamma_xz", "gamma_zy"\]'
awk 'BEGIN { for (i = 0; i < 20; i++) print "1,2,3" }' > "$f"
hopeless "one position again and again" "$f" undetermined 'undetermined: offset x, '
awk 'BEGIN { for (i = 0; i < 20; i++) print "0,0,0" }' > "$f"
hopeless "zero vectors" "$f" undetermined 'undetermined'
hopeless "zero vectors with a given nominal" "$f" 'out of range' \
    'hopeless\.csv:1: position 1 reads 0 of the field with the nominal' --zero 0,0,0 --lsb 1
awk '{ print (NR == 7 ? "1e30,1e30,1e30" : $0) }' "$good" > "$f"
hopeless "a position of 1e30" "$f" '(undetermined|out of range)' 'hopeless' --unit counts
run calibrate "$f" --positions --json
check "a position of 1e30 among those in m/s^2 is left out and named" test "$(json "$work/stdout" rejected)" = '[7]'
hopeless "a position of 1e30 with a given nominal" "$f" 'out of range' \
    'hopeless\.csv:7: position 7 reads .* check --gravity' --zero 0,0,0 --lsb 1 --keep-all
run calibrate "$f" --positions --zero 0,0,0 --lsb 1 --json
check "a position of 1e30 is left out and named" test "$(json "$work/stdout" rejected)" = '[7]'
awk -F, 'NR == 1 { print "x,y,z\n# comment" }
    { print (NR == 7 ? "1e300,-1e300,3" : $1 "e-10," $2 "e-10," $3 "e-10") }' "$good" > "$f"
hopeless "a position that overflows in the calculation" "$f" 'not finite' \
    'hopeless\.csv:9: the reading of position 7 is too large' --zero 0,0,0 --lsb 1e10
awk 'NR % 2 { print "1.7e308,-1.7e308,1.7e308"; next } { print "-1.7e308,1.7e308,-1.7e308" }' \
    "$good" > "$f"
hopeless "the largest numbers" "$f" '.*' 'hopeless'
awk -F, '{ print $1 "e-320," $2 "e-320," $3 "e-320" }' "$good" > "$f"
hopeless "subnormal numbers" "$f" '(undetermined|not an ellipsoid|out of range)' 'hopeless'
awk '{ print (NR == 3 ? "4e-324,0,-4e-324" : $0) }' "$good" > "$f"
hopeless "one subnormal position" "$f" '.*' 'hopeless' --zero 0,0,0 --lsb 1 --keep-all
run calibrate "$f" --positions --zero 0,0,0 --lsb 1
check "a position without any reading is left out and named" matches "$work/stdout" \
    '^Left out: position 3 \(line 3\)'
refuses_file "a wrong scale" 2 '^invcal: with --lsb 9\.8 the readings are 40[0-9][0-9] times the field: by the data sheet' \
    "$work/xsens.csv" --zero 33123,33276,32360 --lsb 9.8
refuses_file "a wrong field" 2 'with --lsb 1 the readings are 19[0-9] times the field: .*, if --gravity is right;' "$good" \
    --zero 0,0,0 --lsb 1 --gravity 0.05
run calibrate "$good" --positions --out "$work/nominal.json" --quiet
refuses_file "a field other than that of --nominal" 2 '--nominal .*: was made with --gravity 9.80665, but here it is 0.05' \
    "$good" --nominal "$work/nominal.json" --gravity 0.05
sed '/"gravity"/d' "$work/nominal.json" > "$work/bare.json"
hopeless "the same, if the file states none" "$good" 'out of range' 'position 1 reads .*check --gravity' \
    --nominal "$work/bare.json" --gravity 0.05
refuses_file "a scale too small to calculate with" 2 '^invcal: --lsb: the scale is too small' "$good" --lsb 1e-320
refuses_file "a noise larger than the field" 2 '^invcal: --noise: is larger than the field' "$good" \
    --noise 10
sed 's/$/,10,1/' "$good" > "$f"
refuses_file "std columns larger than the field" 3 'hopeless\.csv: the noise from its std columns' "$f" \
    --lsb 1

# ---- writing ------------------------------------------------------------------------------------

awk 'BEGIN { for (i = 0; i < 50000; i++) print "1 2 3" }' > "$work/long.csv"
refuses "--out in a missing directory" 3 'nowhere/cal\.json: cannot be written: No such file .*: make its folder first$' \
    calibrate "$good" --positions --out "$work/nowhere/cal.json"
refuses "--out of a directory" 3 'out: cannot be written: Is a directory: name a file in it$' \
    calibrate "$good" --positions --out "$work/out"
check "nothing was left behind" [ -z "$(ls -A "$work/out")" ]
cp "$good" "$work/both.csv"
refuses "--out over the positions themselves" 2 '--out: would overwrite LOG' \
    calibrate "$work/both.csv" --positions --out "$work/../tool_test.$$/both.csv"
check "the positions are still there" same "$good" "$work/both.csv"
# A disk that is full, by a limit of 512 or 1024 bytes for each file. (Not by --out /dev/full: for
# root a fault in the tool might replace the device.)
echo old > "$work/out/cal.json"
(trap '' XFSZ
    ulimit -f 1
    exec "$tool" calibrate "$good" --positions --out "$work/out/cal.json") \
    > "$work/stdout" 2> "$work/stderr"
code=$?
check "--out on a full disk is noticed, the file untouched" \
    kept_old 3 'out/cal\.json: cannot be written: '
(trap '' XFSZ
    ulimit -f 8
    exec "$tool" apply "$work/apply.json" "$work/long.csv") > "$work/stdout" 2> "$work/stderr"
code=$?
check "apply: a full disk for temporary files is noticed" was_refused 3 'temporary file.* written: '
mkfifo "$work/pipe"
cat "$work/pipe" > "$work/piped" &
reader=$!
run calibrate "$good" --positions --out "$work/pipe"
check "--out into a pipe leaves a pipe" [ -p "$work/pipe" ]
{ [ -p "$work/pipe" ] && [ "$code" -eq 0 ]; } || kill $reader # or it would wait for ever
wait $reader
check "--out into a pipe arrives" is_json "$work/piped"
if [ -c /dev/full ]; then
    for arguments in '' --json; do
        "$tool" calibrate "$good" --positions $arguments --out "$work/out/cal.json" \
            > /dev/full 2> "$work/stderr"
        code=$?
        : > "$work/stdout"
        check "calibrate $arguments: a full standard output is noticed, the file untouched" \
            kept_old 3 'standard output: cannot be written: No space left'
    done
    noticed() { # noticed SENTENCE ARGUMENTS ...
        sentence=$1
        shift
        "$tool" "$@" > /dev/full 2> "$work/stderr"
        check "a full standard output is noticed: $sentence" [ $? -eq 3 ]
    }
    noticed "help" --help
    noticed "version" --version
    noticed "help of a command" calibrate --help
    noticed "apply" apply "$work/apply.json" "$work/log.csv"
    noticed "a refusal in JSON" calibrate "$work/three.csv" --positions --json
else
    echo "tool: a full standard output is not tried: there is no /dev/full"
fi
echo old > "$work/out/cal.json"
"$tool" calibrate "$good" --positions --out "$work/out/cal.json" >&- 2> "$work/stderr"
code=$?
check "calibrate: a closed standard output is noticed, the file untouched" \
    kept_old 3 'standard output: cannot be written'
"$tool" apply "$work/apply.json" "$work/log.csv" >&- 2> "$work/stderr"
code=$?
check "apply: a closed standard output is noticed" was_refused 3 'standard output: cannot be written'
"$tool" apply "$work/apply.json" "$work/log.csv" <&- >&- 2> "$work/stderr"
code=$?
check "apply: closed standard input and output are noticed" \
    was_refused 3 'standard output: cannot be written'
"$tool" calibrate - --positions <&- > "$work/stdout" 2> "$work/stderr"
code=$?
check "a closed standard input is noticed" was_refused 3 'standard input:.* cannot be read'
"$tool" calibrate "$good" --positions --out "$work/out/cal.json" > /dev/null 2>&-
check "a closed standard error does no harm" is_json "$work/out/cal.json"
check "the old file was replaced" lacks "$work/out/cal.json" '^old$'
check "no other file was left" [ "$(ls -A "$work/out")" = cal.json ]
{
    "$tool" apply "$work/apply.json" "$work/long.csv" 2> "$work/stderr"
    echo $? > "$work/code"
} | head -n 1 > "$work/stdout"
code=$(cat "$work/code")
: > "$work/stdout"
check "a reader that goes away is noticed" was_refused 3 'standard output: cannot be written: Broken'
chmod 640 "$work/out/cal.json"
run calibrate "$good" --positions --out "$work/out/cal.json"
check "a file that is replaced keeps its mode" [ "$(ls -l "$work/out/cal.json" | cut -c1-10)" = \
    -rw-r----- ]
ln -s out/cal.json "$work/link.json"
echo old > "$work/out/cal.json"
run calibrate "$good" --positions --out "$work/link.json"
check "a link is followed" sh -c '[ -L "$1" ] && ! grep -q "^old" "$2"' sh "$work/link.json" \
    "$work/out/cal.json"
check "standard error is empty after a success" is_empty "$work/stderr"
rm -f "$work"/out/*

# ---- apply --------------------------------------------------------------------------------------

echo '{"offset": [1, 2, 3], "matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 1e0]]}' > "$work/simple.json"
applied() { # applied SENTENCE INPUT OUTPUT, both by printf
    printf "$2" > "$work/in"
    printf "$3" > "$work/expected"
    run apply "$work/simple.json" "$work/in"
    check "apply: $1" sh -c '[ "$1" -eq 0 ] && cmp -s "$2" "$3"' sh "$code" "$work/stdout" \
        "$work/expected"
}
applied "three columns" '2,4,6\n1,2,3\n' 'x,y,z\n2,4,3\n0,0,0\n'
applied "four columns begin with the time, copied as it was" '0.10,2,4,6\n00.2000,1,2,3\n' \
    't,x,y,z\n0.10,2,4,3\n00.2000,0,0,0\n'
applied "five columns end with the temperature, copied as it was" '1e3 2 4 6 25.00\n' \
    't,x,y,z,temperature\n1e3,2,4,3,25.00\n'
applied "named columns in any order" 'temp;az;ay;gx;ax;timestamp\n21.50;6;4;99;2;7\n' \
    't,x,y,z,temperature\n7,2,4,3,21.50\n'
applied "temperature without time" 'x,y,z,Temperature\n2,4,6,20\n' 'x,y,z,temperature\n2,4,3,20\n'
applied "CR LF, byte order mark, comments" '\357\273\277x,y,z\r\n# no\r\n\r\n2,4,6\r\n' \
    'x,y,z\n2,4,3\n'
applied "nine digits" '1.333333333333,2,3\n' 'x,y,z\n0.666666667,0,0\n'
in=$work/in
printf '2 4 6\n' > "$in"
run apply "$work/simple.json" -
check "apply: the log from the standard input" sh -c '[ "$1" -eq 0 ] && grep -q "^2,4,3$" "$2"' sh \
    "$code" "$work/stdout"
in=$work/simple.json
printf '2 4 6\n' > "$work/in"
run apply - "$work/in"
check "apply: the calibration from the standard input" sh -c \
    '[ "$1" -eq 0 ] && grep -q "^2,4,3$" "$2"' sh "$code" "$work/stdout"
in=/dev/null
printf '0,1,2,nan\n' > "$work/in"
refuses "apply: nan in the fourth column" 3 "in:1: column 4 \(z\): 'nan'" apply "$work/simple.json" \
    "$work/in"
printf '0,1,2,3\nsoon,1,2,3\n' > "$work/in"
refuses "apply: a word for the time" 3 "in:2: column 1 \(t\): 'soon'" apply "$work/simple.json" \
    "$work/in"
printf '0,1,2,3,20\n0,1,2,3,\n' > "$work/in"
run apply "$work/simple.json" "$work/in"
check "apply: an empty temperature stays empty" says 'in:2: temperature left empty: column 5 is empty'
printf '1,2,3\n1e308,2,3\n' > "$work/in"
refuses "apply: a reading that overflows" 3 'in:2: the reading is too large' apply "$work/simple.json" "$work/in"

# ---- malformed calibrations ---------------------------------------------------------------------

bad_json() { # bad_json SENTENCE TEXT PATTERN
    printf '%s\n' "$2" > "$work/bad.json"
    refuses "apply: a calibration, $1" 3 "bad\.json:$3" apply "$work/bad.json" "$work/log.csv"
}
m='"matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 2]]'
o='"offset": [1, 2, 3]'
bad_json "empty" '' '2: is empty: name a file that invcal wrote with --out'
bad_json "not an object" '[1, 2]' '1: is not a JSON object: name a file that invcal wrote'
bad_json "not JSON" 'offset: 1' '1: is not a JSON object'
bad_json "without offset" "{$m}" '.: no member "offset"'
bad_json "without matrix" "{$o}" '.: no member "matrix"'
bad_json "without members" '{}' '.: no member "offset"'
bad_json "offset twice" "{$o, $o, $m}" '1: "offset" or "matrix" is there twice'
bad_json "an offset of two" "{\"offset\": [1, 2], $m}" '1: a list of 3 expected'
bad_json "an offset of four" "{\"offset\": [1, 2, 3, 4], $m}" '1: a list of 3 expected'
bad_json "an offset that is not a list" "{\"offset\": 1, $m}" '1: a JSON list'
bad_json "a word in the offset" "{\"offset\": [1, two, 3], $m}" "1: 'two' is not a decimal number"
bad_json "a text in the offset" "{\"offset\": [1, \"2\", 3], $m}" '1: a number expected'
bad_json "null in the offset" "{\"offset\": [1, null, 3], $m}" "1: 'null' is not a decimal"
bad_json "NaN in the offset" "{\"offset\": [1, NaN, 3], $m}" "1: 'NaN' is not a finite number"
bad_json "an infinite offset" "{\"offset\": [1, 1e999, 3], $m}" "1: '1e999' is too large"
bad_json "a matrix of two rows" "{$o, \"matrix\": [[1, 0, 0], [0, 1, 0]]}" '1: a list of 3'
bad_json "a matrix with a short row" "{$o, \"matrix\": [[1, 0, 0], [0, 1], [0, 0, 1]]}" '1: a list'
bad_json "a flat matrix" "{$o, \"matrix\": [1, 0, 0, 0, 1, 0, 0, 0, 1]}" '1: a JSON list'
bad_json "a singular matrix" "{$o, \"matrix\": [[1, 0, 0], [1, 0, 0], [0, 0, 1]]}" ' "matrix" is sing'
bad_json "a matrix of zeros" "{$o, \"matrix\": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}" ' "matrix" is sing'
bad_json "cut off" "{$o, \"matrix\": [[1, 0" "2: ',' or ']' is expected, but the file ends here"
bad_json "a comma missing" "{$o $m}" "1: ',' or '}' is expected"
bad_json "a comma too many" "{$o, $m,}" '1: a name or text in double quotes expected'
bad_json "a comma too many in a list" "{\"a\": [1,], $o, $m}" '1: a value expected'
bad_json "a colon missing" "{\"offset\" [1, 2, 3], $m}" "1: ':' expected"
bad_json "something after it" "{$o, $m} x" '1: nothing may follow'
bad_json "a second object" "{$o, $m}{}" '1: nothing may follow'
bad_json "a name without quotes" "{offset: [1, 2, 3], $m}" '1: a name or text in double quotes'
bad_json "single quotes" "{'offset': [1, 2, 3], $m}" '1: a name or text in double quotes'
bad_json "an unknown word" "{\"a\": nothing, $o, $m}" "1: 'nothing' is not a decimal number"
bad_json "a plus sign" "{\"a\": +1, $o, $m}" "1: '\+1' is not a number in JSON"
bad_json "a leading zero" "{\"a\": 01, $o, $m}" "1: '01' is not a number in JSON"
bad_json "a point without digits" "{\"a\": 1., $o, $m}" "1: '1\.' is not a number in JSON"
bad_json "a text left open" "{\"a\": \"b" '1: a text is not closed by a quote'
bad_json "a line break in a text" "{\"a
\": 1, $o, $m}" '1: a text is not closed by a quote on its line'
bad_json "an unknown escape sequence" "{\"a\": \"\\x\", $o, $m}" '1: unknown escape'
bad_json "half an escape sequence" "{\"a\": \"\\u12\", $o, $m}" '1: unknown escape'
bad_json "an error in the third line" "{$o,
 \"other\": [true, false, null],
 \"matrix\": [[1, 0, 0], [0, 1, 0], [0, 0, x]]}" "3: 'x' is not a decimal number"
bad_json "a refusal in place of a calibration" '{"error": "too few", "reason": "", "undetermined": []}' \
    '1: no member "offset": not a calibration: make one with invcal calibrate --out$'
head -c 4096 /dev/urandom > "$work/bad.json"
refuses "apply: a calibration of random bytes" 3 'bad\.json:' apply "$work/bad.json" "$work/log.csv"
refuses "apply: a missing calibration" 3 'nowhere\.json: cannot be read' apply \
    "$work/nowhere.json" "$work/log.csv"
refuses "apply: a directory as calibration" 3 'out: is a directory' apply "$work/out" "$work/log.csv"
printf '{"x\\u0041\\n\\"": {"offset": [1e5, {"matrix": []}]}, "b": "\\u00b5T", "c": -0.5e-3,\n%s, %s}' \
    "$o" "$m" > "$work/odd.json"
accepts "apply: other members of any kind are ignored" apply "$work/odd.json" "$work/log.csv"

finish
