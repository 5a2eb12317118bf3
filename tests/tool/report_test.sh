#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the page that calibrate --report writes: report_test.sh path/to/invcal builddir
#
# Its looks are checked by tests/pages.sh, in a browser.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

page=$work/out/page.html

# The text of the page, without tags, styles and pictures, on one line.
words() {
    sed '/<style>/,/<\/style>/d; /<svg /,/<\/svg>/d; s/<[^>]*>/ /g' "$page" |
        sed "s/$(printf '\302\240')/ /g; s/−/-/g" | tr -s ' \n' ' ' | plainly
}
says_page() { words | grep -Eq -- "$1" || { { words | head -c 600; echo; } >&2; return 1; }; }
says_not() { ! words | grep -Eq -- "$1"; }

is_finite() { ! grep -Eiqw -- '-?(nan|inf)' "$page"; }

makes_page() { # makes_page SENTENCE ARGUMENTS ...
    sentence=$1
    shift
    rm -f "$page"
    accepts "report: $sentence" calibrate --report "$page" "$@"
    check "report: $sentence: well-formed and self-contained" is_page "$page"
    check "report: $sentence: every number is finite" is_finite
}

# ---- the verdicts of real sensors ----------------------------------------------------------------

xsens=$data/xsens_mti_positions.csv
makes_page "Xsens" "$xsens" --positions --gravity 9.81744 --zero 33123,33276,32360 \
    --lsb 0.002409639,0.002421308,0.002409639 --nominal-name factory --tolerance 0.02,0.005,0.02
check "report: Xsens is rough" says_page '! Rough ✗ FAIL: the verdict is rough; angle zy up to 1\.24 of 1\.15° \(95 %\)\. The positions disagree by 3\.6 times the noise of the samples'
check "report: and what to do next" says_page 'Next: look for a disturbance'
# shared/data: offset 33123.83073, rms 99.857e-6; the angles are those of the reference script.
check "report: the offset is that of the reference" says_page 'offset x [+]0\.2[0-9]+ ± 0\.1[0-9]+ mg 20\.0 mg 2 % 33123\.83 ± 0\.5[0-9] 33123\.00'
check "report: the residual is that of the reference" says_page 'rms error of \|a\| in these positions, before and after 4\.18 → 0\.0999 mg'
check "report: what exceeds the data sheet is named" says_page \
    'Beyond the limits of the data sheet: angle zy\.'
check "report: the table says so, too" matches "$work/stdout" \
    '^Beyond the limits of the data sheet: angle zy\.$'
check "report: and only that" test "$(grep -c '<tr class="bad">' "$page")" -eq 1 -a \
    "$(grep -c 'beyond the limit<' "$page")" -eq 1
run calibrate "$data/t265_positions.csv" --positions --gravity 9.8016 --zero 0,0,0 --lsb 1 \
    --tolerance 0.05,0.01,0.01
check "report: what may be beyond is not" matches "$work/stdout" \
    '^Beyond the limits of the data sheet: offset y, scale y, scale z\.$'
check "report: its title is the name of the file" says_page '^ *Calibration of xsens_mti_positions\.csv'

makes_page "T265" "$data/t265_positions.csv" --positions --gravity 9.8016
check "report: T265 is weak, and in what" says_page \
    '✗ Weak The positions hardly determine angle xy, angle xz, angle zy'
check "report: and where to start" says_page \
    'Next: add positions with the field midway between x and y, x and z, z and y\. Begin with: [+-][xyz] up'
check "report: an error that no direction checks is not reported" says_not 'rms error of'
check "report: what the samples' noise does not explain is reported: 0.00553 / 0.000872" says_page \
    'They are 6\.3 times as large as the noise of the samples explains'
check "report: a noise that was not stated is not called stated" says_page \
    'noise 0\.000872 m/s² of a position mean, from the scatter'
makes_page "MPU-9150" "$data/mpu9150_0_positions.csv" --positions --gravity 9.81

# ---- the identity of the file --------------------------------------------------------------------

# gzip stores the CRC-32 and the size of what it packs.
gzip -c "$data/mpu9150_0_positions.csv" | tail -c 8 | od -An -tu1 > "$work/trailer"
crc=$(awk '{ printf "%02x%02x%02x%02x", $4, $3, $2, $1 }' "$work/trailer")
size=$(awk '{ print $5 + 256 * ($6 + 256 * ($7 + 256 * $8)) }' "$work/trailer")
check "report: CRC and size are those of the file" says_page "$size bytes, CRC-32 $crc"
run calibrate "$data/mpu9150_0_positions.csv" --positions --gravity 9.81 --json
check "report: the JSON has the same CRC" test "$(json "$work/stdout" source_crc)" = "\"$crc\""
check "report: the command line is shown" shows_command "$page" invcal calibrate --report "$page" \
    "$data/mpu9150_0_positions.csv" --positions --gravity 9.81
in=$data/mpu9150_0_positions.csv
makes_page "standard input" - --positions --gravity 9.81
in=/dev/null
check "report: standard input has the same CRC" says_page "standard input, $size bytes, CRC-32 $crc"

# ---- outliers, no redundancy, many ---------------------------------------------------------------

"$tool" simulate --plan edges --outliers 2 --temperature 20,30 --truth "$work/truth.json" \
    > "$work/outliers.csv"
makes_page "two outliers" "$work/outliers.csv"
wrong=$(grep '"wrong"' "$work/truth.json" | grep -n 'wrong": -*0\.05' | cut -d: -f1 | tr '\n' ' ')
named=$(words | grep -o 'Left out: position [0-9]*' | awk '{ printf "%s ", $4 }')
check "report: the outliers are named, and they are the wrong ones" test "$named" = "$wrong"
check "report: by how much" says_page 'contradicts the others; it reads (4[89]|5[012])\.[0-9]* mg too'
check "report: the verdict mentions them" says_page '2 positions contradict the others and are left out'
crosses() { # of one picture, by its title
    sed -n "/<title>$1</,/<\/svg>/p" "$page" | grep -c '<polygon class="c2 full"'
}
check "report: residuals have a cross for each, and one in the legend, in both sizes" \
    test "$(crosses 'Residuals of the calibration')" -eq 6
bands() {
    sed -n "/<title>The log and the rests in it</,/<\/svg>/p" "$page" | grep -c "<rect class=\"$1 area\""
}
check "report: the timeline has a band for each rest, and one in the legend, in both sizes" \
    test "$(bands c3)" -eq 34 -a "$(bands c2)" -eq 4

# Rows of the table: number, begin, length, temperature. The truth: begin, end; 20 ... 30 degrees.
rests_are_true() {
    sed -n '/<h2>The positions in numbers/,/<\/table>/p' "$page" | grep '^<tr><th scope="row"' |
        sed 's/<[^>]*>/ /g' > "$work/rows"
    sed -n 's/^ *"\(begin\|end\)": \([^,]*\),/\2/p' "$work/truth.json" | paste - - > "$work/rests"
    paste "$work/rows" "$work/rests" | awk '{
        begin = $(NF - 1); end = $NF; middle = $2 + $3 / 2; last = 124
        if ($2 < begin || $2 + $3 > end + 0.01 || $3 < 3.5) exit 1
        t = $4 - (20 + 10 * middle / last)
        if (t > 0.05 || t < -0.05) exit 1
    } END { exit NR != 18 }'
}
check "report: each rest lies within the true one, with its temperature" rests_are_true
# At rest the calibrated length is that of the field, to 15 pixels of 150; uncalibrated it is not. Bands are rests.
lengths_are_true() {
    sed -n '/<title>The log and the rests in it</,/<\/svg>/p; /<title>Length of the readings/,/<\/svg>/p' "$page" |
        tr '"' ' ' | awk '/<title>The log/ { log_pictures++ }
        /c3 area/ && $8 > 22 && log_pictures == 1 { left[++n] = $6; right[n] = $6 + $10 }
        /<title>Length/ && pictures++ == 0 { on = 1 } /<\/svg>/ { on = 0 }
        on && /c[01] column/ {
            for (k = 1; k <= n; k++) if ($6 > left[k] + 2 && $6 < right[k] - 2) {
                all[$3]++; far[$3] += $8 < 108 || $12 > 138
            }
        } END { exit !(all["c1"] > 200 && far["c1"] == 0 && far["c0"] > all["c0"] / 4) }'
}
check "report: the temperatures are reported" says_page 'temperature 2[01]\.[0-9] \.\.\. (29|30)\.[0-9] °C'

"$tool" simulate --plan edges > "$work/log.csv"
makes_page "a log, its nominal stated" "$work/log.csv" --zero 0,0,0 --lsb 0.000598
check "report: the length along the log is that of the field at rest, and before it is not" lengths_are_true
# Eleven bars; heights add up to the 18 positions: 120 pixels are 6 of them.
histogram_is_full() {
    sed -n '/<title>Histogram of the residuals</,/<\/svg>/p' "$page" | tr '"' ' ' | awk '
        /<\/svg>/ { exit } /text-anchor= end/ && $NF { split($0, part, /[<>]/); top = part[3] }
        /c1 area/ { bars++; sum += $12 } END { n = sum * top / 120
        exit !(bars == 11 && n > 17.99 && n < 18.01) }'
}
check "report: the histogram has all positions" histogram_is_full

# An hour's pause is not drawn.
awk -F, -v OFS=, 'NR > 5000 { $1 += 3600 } { print }' "$work/outliers.csv" > "$work/pause.csv"
makes_page "a log with a pause" "$work/pause.csv"
check "report: it says how the pause is drawn" says_page \
    '1 gap in the times; those of more than a minute are left out here\.'

# A sensor that clips at 0.95 g, which is not stated. Its counts are too coarse to notice that an axis
# that clips has no noise.
"$tool" simulate --plan per-group:6 --range 0.95 --lsb 0.006 > "$work/clipped.csv"
makes_page "clipped readings" "$work/clipped.csv"
check "report: positions that disagree confirm nothing" says_page \
    '! Rough The positions disagree by [0-9]{3} times the noise of the samples'
check "report: and the table gives a possible reason" matches "$work/stdout" \
    '^The residuals are [0-9]* times as large'

# Four residuals of the same size do not show which positions are wrong.
"$tool" simulate --plan per-group:5 --outliers 3 --seed 33 --noise 0.002 > "$work/doubt.csv"
makes_page "outliers that cannot be identified" "$work/doubt.csv"
check "report: then the verdict is not good" says_page \
    '! Contradictory .* 4 positions contradict one another, and nothing shows which'
check "report: nor is it in the table" matches "$work/stdout" '^Contradictory: .* 4 positions'
check "report: and the next step is another measurement" matches "$work/stdout" \
    '^Next: measure again with more positions'

"$tool" simulate --plan optimal:9 > "$work/nine.csv"
makes_page "nine positions" "$work/nine.csv"
check "report: nine positions have no redundancy" says_page '! No redundancy .* nothing checks the result'
check "report: and what to do" says_page 'Next: add three or more positions in other directions'
positions sphere 9 1 > "$work/nine-means.csv"
makes_page "nine means, no noise known" "$work/nine-means.csv" --positions
check "report: without a noise there is no ±" says_page 'There is no ±'

# A prior far narrower than what the positions can determine with their noise.
positions sphere 18 1 > "$work/prior.csv"
makes_page "angles from a prior" "$work/prior.csv" --positions --zero 0,0,0 --lsb 1 --noise 0.1 \
    --prior 0.1,0.1,0.0001
check "report: positions do not confirm what the prior says" says_page \
    'determined, but angle xy, angle xz, angle zy by the prior rather than by the positions'

positions sphere 2000 2 > "$work/many.csv"
makes_page "2000 positions" "$work/many.csv" --positions
check "report: 2000 positions take less than a megabyte" test "$(wc -c < "$page")" -lt 1000000
positions sphere 20000 3 > "$work/very-many.csv"
accepts "report: 20000 positions" calibrate --report "$page" "$work/very-many.csv" --positions
check "report: nor do 20000" test "$(wc -c < "$page")" -lt 1000000

# A sensor that clips: positions disagree by far more than the samples scatter.
"$tool" simulate --plan edges --range 0.9 --lsb 0.006 > "$work/clipped.csv"
makes_page "a sensor that clips" "$work/clipped.csv" --keep-all
check "report: a sensor that clips is not called good" says_page '! Rough .*disagree by [0-9]+ times'
check "report: nor in the table" matches "$work/stdout" '^Rough: '
check "report: what to look for" says_page 'Next: look for a disturbance'

# ---- how well every direction is known -----------------------------------------------------------

# The twelve corners of an icosahedron are a D-optimal design, and the same for every direction:
# h K h' is 9 / 12 everywhere (Kiefer and Wolfowitz). A noise of 1 mg is stated, and there: lengths are
# wrong by r, of which H' r = 0 and r r' = 3 mg^2. So sigma is 0.866 mg, and ± by Student's t for the 3 degrees of freedom and the 4
# that a noise stated stands for 2.3646 times that.
awk 'function g(r) { return 9.80665 * sqrt(1 + 2 * r) / n }
    BEGIN { s = sqrt(5); c = (1 + s) / 2; n = sqrt(1 + c * c); t = 1e-3 * sqrt(3 / 4 / (c * c + 1))
    for (i = -1; i <= 1; i += 2) for (j = -1; j <= 1; j += 2) {
        printf "0,%.12f,%.12f\n%.12f,%.12f,0\n%.12f,0,%.12f\n", g(i * c * t) * i, g(i * c * t) * j * c,
            g(-j * t) * i, g(-j * t) * j * c, g(0) * j * c, g(0) * i } }' \
    > "$work/icosahedron.csv"
makes_page "an icosahedron" "$work/icosahedron.csv" --positions --noise 0.00980665 --zero 0,0,0 --lsb 1
check "report: every direction is known as closed form says" says_page \
    'is ±2\.0 mg in the best direction, and ±2\.0 mg in the worst'

# A magnetometer: no mg, no m/s^2.
awk -F, '{ printf "%.6f,%.6f,%.6f\n", $1 * 4.9, $2 * 4.9, $3 * 4.9 }' "$work/icosahedron.csv" |
    cat - "$work/icosahedron.csv" | head -n 12 > "$work/mag.csv"
makes_page "a magnetometer" "$work/mag.csv" --positions --gravity 48.0526 --noise 0.05
check "report: a field that is not gravity is not called so" says_not ' mg|m/s|gravity to|\|a\|'

# ---- hostile names -------------------------------------------------------------------------------

odd="$work/<img src=x onerror=alert(1)>&\"' \$(id).csv"
{ echo '# <script>alert(2)</script>'; echo 'x,y,z,"</title><script>alert(3)</script>"'
    sed 's/$/,1/' "$work/icosahedron.csv"; } > "$odd"
makes_page "a hostile name and header" "$odd" --positions --noise 0.01 --nominal-name '<b>"&'
check "report: the name is reported anyway" says_page \
    "Calibration of <img src=x onerror=alert\(1\)>&\"' \\\$\(id\)\.csv"
check "report: in the command it is quoted" shows_command "$page" invcal calibrate \
    --report "$page" "$odd" --positions --noise 0.01 --nominal-name '<b>"&'
printf 'x\377y' > "$work/bytes"
makes_page "a name that is no UTF-8" "$work/icosahedron.csv" --positions --noise 0.01 \
    --nominal-name "$(cat "$work/bytes")"
is_utf8() { iconv -f UTF-8 -t UTF-8 "$page" > "$work/converted" && same "$page" "$work/converted"; }
check "report: the page is UTF-8 anyway" is_utf8

# ---- to copy --------------------------------------------------------------------------------------

# The contents of the boxes to copy, one after the other.
boxes() {
    awk '/<pre class="code"/ { on = 1 } on { print } /<\/pre>/ { on = 0 }' "$page" | sed 's/<[^>]*>//g' | plainly
}
mkdir "$work/my place"
cp "$xsens" "$work/my place/-it's.csv"
uses() { # runs what the page says, in a folder with such names: ARGUMENTS of calibrate
    (cd "$work/my place" && "$tool" calibrate --quiet --report "$page" "$@" && boxes > commands &&
        PATH=$work/bin:$PATH && export PATH && grep '^invcal' commands > run && sh -e run)
}
mkdir "$work/bin"
ln -s "$tool" "$work/bin/invcal"
check "report: its commands do what they say" uses ./-it\'s.csv --positions --gravity 9.81744 --out "a 'b'.json"
check "report: apply corrects the log" matches "$work/my place/calibrated.csv" '^x,y,z$'
boxes | sed -n '/^static const/,/;$/p' > "$work/constant"
sed -n '/^static const/,/;$/p' "$work/my place/calibration.h" > "$work/exported"
check "report: the constant is the one that export writes" same "$work/constant" "$work/exported"
check "report: of four lines of numbers" test "$(grep -c INVCAL_REAL "$work/constant")" -eq 4
rm -f "$work/my place"/*.json "$work/my place"/*.h
check "report: without --out the first command saves it" uses ./-it\'s.csv --positions --gravity 9.81744
check "report: and so it is there" is_json "$work/my place/CAL.json"
rm -f "$work/my place"/*.json "$work/my place"/*.h
check "report: a file whose name looks like an option" uses --positions --gravity 9.81744 --out=-cal.json -- -it\'s.csv
"$tool" calibrate "$xsens" --positions --gravity 9.81744 --json > "$work/result.json"
awk -F'[][,]' '/^  "offset"/ { for (i = 2; i <= 4; i++) o[i - 2] = $i }
    /^  "matrix"/ { on = 3; next } on { n = 3 - on; on--; print "-", o[n], $2, $3, $4 }' "$work/result.json" |
    sed 's/^-/0/' > "$work/numbers"
check "report: the matrix is the JSON's" sh -c 'sed -n "/<h2>Use it/,/<.table>/p" "$1" | grep "^<tr><th scope=\"row\"" |
    sed "s/<[^>]*>/ /g; s/−/-/g" | tr -s " \n" " "  > "$3"
    awk -v file="$2" "{ for (i = 0; i < 3; i++) {
            getline line < file; if (split(line, m, /[^-+0-9.e]+/) < 5) exit 1
            for (k = 2; k <= 5; k++) { d = \$(5 * i + k) / m[k] - 1; if (!(d * d < 1e-16)) exit 1 } } }" "$3"' sh \
    "$page" "$work/numbers" "$work/printed"
makes_page "a nonlinearity" "$xsens" --positions --gravity 9.81744 --quadratic
check "report: which has no constant" says_page 'It cannot be exported as a constant: no format corrects quadratic'
check "report: and no box for one" lacks "$page" 'static const'
in=$xsens
makes_page "standard input, to take away" - --positions --gravity 9.81744 --out "$work/out/cal.json"
in=/dev/null
check "report: then LOG stands for it" matches "$page" '>invcal apply .*out/cal\.json[^ ]* LOG &gt; calibrated\.csv</pre>'
rm -f "$work/out/cal.json"

# ---- nothing can be written (for pages of refusals see refusal_test.sh) ----------------------------

echo old > "$work/out/cal.json"
rm -f "$page"
positions plane 18 4 > "$work/plane.csv"
refuses "report: where none can be" 3 'nowhere/x\.html' \
    calibrate "$xsens" --positions --report "$work/nowhere/x.html" --out "$work/out/cal.json"
check "report: then the calibration is not written, either" is_untouched
refuses "report: not over LOG" 2 'report: would overwrite LOG' \
    calibrate "$work/plane.csv" --positions --report "$work/plane.csv"
refuses "report: not over the calibration" 2 'report: is the file of --out' \
    calibrate "$xsens" --positions --report "$work/out/cal.json" --out "$work/out/cal.json"
for v in 0,1,1 -1,1,1 1,2 nan,1,1; do
    refuses "report: --tolerance $v" 2 '--tolerance' calibrate "$xsens" --positions \
        --zero 0,0,0 --lsb 1 --tolerance "$v"
done
refuses "report: --tolerance wants a nominal" 2 'tolerance: needs the nominal calibration' \
    calibrate "$xsens" --positions --tolerance 1,1,1

# ---- length does not matter ----------------------------------------------------------------------

# A tenth of an hour at 1 kHz needs no more memory than two minutes (the sanitizer's own is another
# matter).
# shellcheck disable=SC3045 # dash and bash know -v
fits() { (ulimit -v 18000 && exec "$tool" calibrate "$1" --report "$page" > /dev/null); }
if ! grep -q __asan_init "$tool"; then
    "$tool" simulate --rate 1000 --dwell 18 --plan edges > "$work/long.csv"
    check "report: a short log in 18 MB" fits "$work/outliers.csv"
    check "report: 342,000 samples too" fits "$work/long.csv"
fi

finish
