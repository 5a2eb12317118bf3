#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of plan --report and of pictures of a comparison, by the command line:
# plan_report_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
# shellcheck disable=SC2154
page=$work/out/page.html

makes_page() { # makes_page SENTENCE ARGUMENTS ...: the tool accepts them and writes a good page
    what=$1
    shift
    rm -f "$page"
    accepts "report: $what" plan "$@" --report "$page"
    check "report: $what: well-formed, self-contained" is_page "$page"
}

# The page's words, a line for each element; the cells of a row are on one line, separated by |.
words() {
    sed -n '/^<body>/,$p' "$page" | sed -e "s/$(printf '\302\240')/ /g" \
        -e 's/<\/t[hd]>/|/g' -e 's/<[^>]*>//g' -e 's/−/-/g' -e '/^ *$/d'
}
page_says() { words | grep -Fq -- "$1"; }
row() { words | sed -n "s/^$1|//p" | head -n 1; } # row NAME: the cells behind the first
formula() { awk "BEGIN { printf \"$1\", $2 }"; }  # formula FORMAT EXPRESSION

# ---- the program of 18 positions ---------------------------------------------------------------

makes_page "the program of 18 positions" --per-group 6
check "report: good" page_says '✓ Good'
check "report: what to do next" page_says 'invcal calibrate LOG'
check "report: sigma by the paper's formulas" page_says "offsets to $(formula %.3f 'sqrt(1/6)'), \
scale errors to $(formula %.3f 'sqrt(7/30)'), angles to $(formula %.2f 'sqrt(8/6)') times"
check "report: offset x" test "$(row 'offset x')" = "$(formula %.4f 'sqrt(1/6)')|"
check "report: scale y" test "$(row 'scale y')" = "$(formula %.4f 'sqrt(7/30)')|"
check "report: angle zy" test "$(row 'angle zy')" = "$(formula %.3f 'sqrt(8/6)')|"
check "report: time" page_says '2 min 55 s'
check "report: its command" shows_command "$page" invcal plan --per-group 6 --report "$page"
check "report: all axes" page_says 'All six of +x, -x, +y, -y, +z, -z point along gravity.'
check "report: groups" page_says 'group 3'
check "report: nonlinear terms" page_says 'quadratic 1.63 × noise, of 12 parameters, condition 40.2; cubic 3.27 × noise, of 15'

# The paper's Table 1 with starts 30, 30, 120, and five seconds to stay and to move.
follows_table() {
    words | awk -F '|' '
        function wrap(a) { while (a > 180) a -= 360; while (a <= -180) a += 360; return a }
        function turned(text, axis) { # by how much, from "α +60°, β -30°"
            if (!match(text, axis " [-+][0-9.]*")) return 0
            text = substr(text, RSTART, RLENGTH)
            sub(/.* /, "", text)
            text += 0
            if (text > 180 || text < -180) exit 1 # the long way round
            return text
        }
        NF == 9 && $1 ~ /^[0-9]+$/ {
            l = n % 6; group = int(n / 6) + 1
            a = group == 1 ? 30 + 60 * l : group == 2 ? -90 : 120 + 60 * l
            b = group == 1 ? 0 : group == 2 ? 30 + 60 * l : 90
            begins = sprintf("%d:%02d", int(n / 6), 10 * n % 60)
            if ($1 != n + 1 || $2 != "☐" || $3 != begins || $8 != group) exit 1
            if ($4 != wrap(a) || $5 != wrap(b)) exit 1
            alpha = wrap(alpha + turned($6, "α")); beta = wrap(beta + turned($6, "β"))
            if (n > 0 && (alpha != $4 || beta != $5)) exit 1
            alpha = $4; beta = $5
            n++
        }
        END { if (n != 18) exit 1 }'
}
check "report: the work sheet is the paper's Table 1, turn by turn" follows_table
check "report: its words" test "$(row 2 | cut -d '|' -f 6)" = '+z up'

marks() { grep -c "^<$1 class=\"$2 over\"" "$page"; }
check "report: six markers of each group" test \
    "$(marks circle c1) $(marks polygon c2) $(marks polygon c3)" = '6 6 6'
run plan --json
down=$(sed -n 's/^ *"vertical": .*, \(.*\)\],*$/\1/p' "$work/stdout" | awk '$1 < -1e-9' | wc -l)
check "report: the lower half is described" page_says \
    "z down, seen from +z. It holds $((down + 0)) of 18 positions."
check "report: and the upper" page_says "z up or level, seen from +z. It holds $((18 - down)) of 18 positions"
check "report: position 2 of group 1 is in the middle" matches "$page" \
    '^<circle class="c1 over" cx="168" cy="164"'

# h K h' over all directions, K from the JSON.
length_sigma() {
    sed -n '/"covariance"/,/^  \]/p' "$work/stdout" | tr -d '[],' | awk '
        NF == 9 { for (i = 1; i <= 9; i++) k[r + 0, i - 1] = $i; r++ }
        END {
            if (r != 9) exit 1
            turn = 8 * atan2(1, 1); least = 1e9
            for (i = 0; i <= 90; i++) for (j = 0; j < 180; j++) {
                s = sin(turn * i / 180); x = s * cos(turn * j / 180); y = s * sin(turn * j / 180)
                z = cos(turn * i / 180)
                split(x " " y " " z " " x*x " " y*y " " z*z " " x*y " " x*z " " y*z, h, " ")
                v = 0
                for (p = 0; p < 9; p++) for (q = 0; q < 9; q++) v += h[p + 1] * k[p, q] * h[q + 1]
                if (v < least) least = v
                if (v > most) most = v
            }
            printf "%.3f %.3f\n", sqrt(least), sqrt(most)
        }'
}
run plan --json
bounds=$(length_sigma)
check "report: |a| is known best along an axis" test "${bounds% *}" = \
    "$(formula %.3f 'sqrt(1/6 + 7/30)')"
check "report: sigma of |a|, the least" page_says "of a corrected reading is ±${bounds% *} × noise"
check "report: sigma of |a|, the most" page_says "±${bounds#* } × noise in the worst"

# The check of pages must detect these faults.
sees() { # sees FAULT SED-COMMAND
    check "report: the test sees $1" test -n "$(sed "$2" "$page" | awk -f "$here/page.awk")"
}
sees "a tag left open" 's/<\/h1>//'
sees "a tag too many" 's/<\/h1>/<\/p><\/h1>/'
sees "a stray <" 's/<h1>/<h1>a < b/'
sees "a stray &" 's/<h1>/<h1>a \& b/'
sees "a script" 's/<main>/<main><script><\/script>/'
sees "a handler" 's/<h1>/<h1 onclick="x">/'
sees "an attribute without quotes" 's/<h1>/<h1 class=x>/'
sees "a picture from elsewhere" 's/<h1>/<img src="x"\/><h1>/'

# ---- units, limits -----------------------------------------------------------------------------

makes_page "with noise" --per-group 8 --noise 0.0001 --dwell 4
check "report: offsets in mg" page_says "offsets to $(formula %.4f '0.05 * sqrt(1/8)') mg"
check "report: scale errors in %" page_says "scale errors to $(formula %.5f '0.005 * sqrt(7/40)') %"
check "report: angles in degrees" page_says "angles to $(formula %.5f '5e-5 * 45 / atan2(1, 1)') °"
check "report: |a| in mg" page_says "of a corrected reading is ±$(formula %.4f '0.05 * sqrt(1/8 + 7/40)') mg in the best"
check "report: time of 24 positions" page_says "$(formula '%d min %d s' 'int(211 / 60), 211 % 60')"
makes_page "rests too short for a log" --dwell 1.5 --move 3
check "report: it says so" page_says 'holding two seconds or more'
check "report: begins with tenths" test "$(row 2 | cut -d '|' -f 2)" = 0:04.5
makes_page "an odd number" --per-group 7
check "report: it names what is missing, and why" \
    page_says 'Never along gravity: +x +y -z; an odd number per group'
# +x, -x, +y, -y, +z, -z by the markers at +1 g (the right end, 672) and -1 g (34).
covered() {
    sed -n '/>The range of each axis</,/^<\/svg>/p' "$page" | awk '
        /class="c3 over"|class="c2 hollow"/ && rows > 0 {
            x = $0
            sub(/.*(cx|points)="/, "", x)
            printf "%s%s ", (x + 0 > 300 ? "+" : "-"), (/c3/ ? "yes" : "no")
        }
        /<rect class="c1 bar"/ { rows++ }
        /^<\/svg>/ { exit }'
}
check "report: markers of axes along gravity" test "$(covered)" = '+no -yes +no -yes +yes -no '
makes_page "start angles" --start 0,10,0
check "report: they miss axes" page_says 'its start angles miss them'

makes_page "a choice" --limits 0.4,0.6,1 --budget 600
check "report: it shows the choice" page_says 'free directions, chosen|19|'
check "report: and the other" page_says '3 x 8|24|'
check "report: the limit in the table" test "$(row 'scale x' | cut -d '|' -f 2)" = 0.600
makes_page "limits not met" --optimal 9 --limits 0.4,0.4,0.4
check "report: it says so" page_says '! Limits not met'
check "report: and where" test "$(row 'angle xy' | cut -d '|' -f 3)" = 'beyond the limit'
check "report: and in colour" matches "$page" '<rect class="c2 bar"'

# ---- a stand, shares, bounds, warm-up ----------------------------------------------------------

makes_page "stand-12" --stand-12
check "report: angles of a stand" page_says 'α: outer axis of the stand'
check "report: turn the stand" page_says 'turn the stand as the work sheet says'
makes_page "angles" --optimal 12 --grid 30 --need-axes
check "report: of a grid" test "$(row 1 | cut -d '|' -f 3,4 | grep -c '^-*[0-9]*0|-*[0-9]*0$')" -eq 1
makes_page "shares" --edges --weights --dwell 9
# A face has 18/30 of 9 s, an edge 18/15.
check "report: the dwell of each position" test "$(words | awk -F '|' '$2 == "☐" { print $9 }' | sort | uniq -c |
    tr -s ' \n' ' ')" = " 12 10.8 s 6 5.4 s "
check "report: on the average" page_says 'for 9 s in each position on average'
check "report: the gain" page_says "with equal ones ln det H&#39;H is 9.36426; for any 18 positions it is at most 9.46494"
makes_page "bounds" --bound 0.001
check "report: bounds of 3 x 6" test "$(words | grep '^offset x|1\.244|')" = 'offset x|1.244|1.24 mg|'
makes_page "a warm-up" --warm-up 600
check "report: the first begins after it" test "$(row 1 | cut -d '|' -f 2)" = 10:00
check "report: it says so" page_says 'let the sensor warm up for 10 min 00 s'

# ---- other sets --------------------------------------------------------------------------------

makes_page "the icosahedron" --icosahedron
check "report: equally well in every direction" \
    page_says "is the same in every direction: ±$(formula %.3f 'sqrt(0.75)') × noise"
makes_page "edges" --edges
makes_page "nine positions" --optimal 9
check "report: no redundancy" page_says '! No redundancy'
cat > "$work/cap.csv" <<END
0.1 0 1
0.9 0.3 0.3
0.8 0.6 0
0.7 0 0.7
0.6 0.8 0.1
0.5 0.5 0.7
0.3 0.3 0.9
0.9 0.4 0
0.2 0.8 0.5
-0.1 0 0.9
0 0.9 -0.1
END
makes_page "a cap of directions" --directions "$work/cap.csv"
check "report: weak" page_says '✗ Weak'
check "report: what to add" page_says 'add positions with'
makes_page "3000 positions" --per-group 1000
check "report: the work sheet is folded" grep -q '^<details>$' "$page"
check "report: but whole" test "$(words | grep -c '^[0-9]*|☐|')" -eq 3000
check "report: no numbers on the sphere" test \
    "$(grep -c '^<text class="ink small halo"' "$page")" -eq 0
check "report: beyond an hour" test "$(row 1000 | cut -d '|' -f 2)" = 2:46:30
check "report: below 1 MB" test "$(wc -c < "$page")" -lt 1000000

# ---- a sweep -----------------------------------------------------------------------------------

makes_page "a sweep" --sweep 5:16
check "report: twice the positions" page_says "multiply every σ by $(formula %.2f 'sqrt(1/2)')"
check "report: from end to end" page_says \
    "falls from $(formula %.2f 'sqrt(8/5)') to $(formula %.3f 'sqrt(8/16)') times"
follows_formulas() {
    words | awk -F '|' '/^3 x [0-9]*\|/ {
        n = substr($1, 5); rows++
        if ($2 != 3 * n || $3 != sprintf("%.4f", sqrt(1 / n))) exit 1
        if ($4 != sprintf("%.4f", sqrt(7 / 5 / n)) || $5 != sprintf("%.4f", sqrt(8 / n))) exit 1
        if (n != 4 + rows || (n % 2 == 0) != ($8 == "all six")) exit 1
    } END { if (rows != 12) exit 1 }'
}
check "report: every row by the paper's formulas" follows_formulas
check "report: the chart, wide and narrow" test \
    "$(grep -c '<polyline class="c3 curve"' "$page")" -eq 2
makes_page "a sweep of one" --sweep 7:7
makes_page "the widest sweep" --sweep 5:1000

# ---- a comparison ------------------------------------------------------------------------------

makes_page "a comparison" --compare per-group:8 per-group:6 --svg "$work/out/ratios.svg"
check "report: time and sigma in a sentence" page_says \
    "B needs $(formula %.4f 175/235) of the time of A, with 18 positions instead of 24; its σ \
are $(formula %.3f 'sqrt(8/6)') times as large."
check "report: the ratios in a table" test "$(row 'σ of angles, × noise')" = \
    "1.00|$(formula %.2f 'sqrt(8/6)')|$(formula %.3f 'sqrt(8/6)')|"
check "report: ln det in the table" test "$(row "ln det H&#39;H" | cut -d '|' -f 1)" = \
    "$(run plan --per-group 8 --json; printf %.3f "$(json "$work/stdout" log_det)")"
check "report: both spheres" test "$(grep -c '<title>3 x [68]: positions with z' "$page")" -eq 4
is_svg() {
    head -n 1 "$1" | grep -q '^<svg xmlns="http://www.w3.org/2000/svg" ' &&
        tail -n 1 "$1" | grep -q '^</svg>$' && ! grep -Eq '<script|href=|url\(|@import' "$1"
}
check "report: the picture alone" is_svg "$work/out/ratios.svg"
# sqrt(24/18) is half as far from 1 as 18/24 on a logarithmic axis; bars extend by a pixel.
has_true_bars() {
    sed -n 's/^<rect class="\(c[12]\) bar".* width="\([0-9.]*\)".*/\1 \2/p' "$work/out/ratios.svg" |
        awk 'NR > 2 { style[++n] = $1; width[n] = $2 - 2 }
        END {
            for (i = 3; i <= 6; i++) {
                d = width[1] / width[i] - 2
                if (style[i] != "c2" || d > 0.001 || d < -0.001) exit 1
            }
            if (n != 7 || style[1] != "c1" || width[7] > 0.01) exit 1
            d = width[2] / width[1] - log(235 / 175) / log(4 / 3)
            if (d > 0.001 || d < -0.001) exit 1
        }'
}
# The bar of 0.75 reaches from the tick of 1 to that of 0.75.
ends_at_tick() {
    awk '/^<rect class="c1 bar"/ && /height="14"/ && !/width="18"/ && !bar { bar = 1; x = $0; w = $0
            sub(/.* x="/, "", x); sub(/.* width="/, "", w); left = x + 1; right = x + w - 1 }
        / text-anchor="middle"/ {
            x = text = $0
            sub(/.* x="/, "", x)
            gsub(/<[^>]*>/, "", text)
            at[text] = x + 0
        }
        function far(a, b) { return !(a - b < 0.02 && b - a < 0.02) }
        END { if (far(left, at["0.75"]) || far(right, at["1.00"])) exit 1 }' "$work/out/ratios.svg"
}
check "report: the bar of 0.75 ends at its tick" ends_at_tick
check "report: the length of a bar is the logarithm of its ratio" has_true_bars
makes_page "equal sets" --compare edges edges
check "report: they are equally good" page_says 'A and B are equally good'
makes_page "better in all" --compare "directions:$work/cap.csv" optimal:11 --noise 0.001
check "report: B is better" page_says 'B is better'
check "report: A is weak" page_says 'A is weak'
makes_page "worse in all" --compare optimal:11 "directions:$work/cap.csv"
check "report: A is better" page_says 'A is better'
makes_page "far apart" --compare per-group:1000 optimal:9
check "report: the one with nine positions is unchecked" page_says 'B has no redundancy'

# ---- names and files ---------------------------------------------------------------------------

awk '{ print NR * $1, NR * $2, NR * $3 }' "$work/cap.csv" > "$work/out/<b>&\"'x.csv"
makes_page "a hostile name" --directions "$work/out/<b>&\"'x.csv"
check "report: it is escaped" lacks "$page" '<b>&|&"'
check "report: and shown" matches "$page" '&lt;b&gt;&amp;&quot;&#39;x\.csv'
check "report: in the command it is quoted" shows_command "$page" invcal plan --directions \
    "$work/out/<b>&\"'x.csv" --report "$page"
makes_page "a hostile name to compare" --compare "directions:$work/out/<b>&\"'x.csv" edges
check "report: it is escaped, too" lacks "$page" '<b>&|&"'

run plan --json
cp "$work/stdout" "$work/plain.json"
makes_page "with JSON" --json
check "report: JSON is the same without it" same "$work/stdout" "$work/plain.json"

rm -f "$work"/out/*
cp "$work/cap.csv" "$work/out/own.csv"
refuses "report: a page over its directions" 2 'report: would overwrite the file of --directions' plan --directions \
    "$work/out/own.csv" --report "$work/out/own.csv"
refuses "report: the same to compare" 2 'report: would overwrite the file of --compare' plan --compare edges \
    "directions:$work/out/own.csv" --report "$work/out/own.csv"
refuses "report: a picture over them" 2 'svg: would overwrite the file of --compare' plan --compare \
    "directions:$work/out/own.csv" edges --svg "$work/out/own.csv"
check "report: they are still there" same "$work/cap.csv" "$work/out/own.csv"
rm -f "$work"/out/*
refuses "report: one file for both" 2 'report: is the file of --svg' plan --svg "$page" \
    --report "$page"
check "report: neither exists" test -z "$(ls -A "$work/out")"
echo old > "$work/out/cal.json"
run plan --faces --report "$work/out/cal.json"
check "report: a refusal leaves the page as it was" is_untouched
run plan --svg "$work/out/cal.json" --report "$work/nowhere/x.html"
check "report: if the page cannot be written, the picture stays as it was" kept_old 3 'nowhere/x\.html'
run plan --report "$work/out/cal.json" --svg "$work/nowhere/x.svg"
check "report: and vice versa" kept_old 3 'nowhere/x\.svg'
"$tool" plan --report "$work/out/cal.json" --svg "$work/out/x.svg" >&- 2> "$work/stderr"
code=$?
check "report: an output that fails leaves everything as it was" \
    kept_old 3 'standard output: cannot'
run plan --limits 0.01,0.01,0.01 --report "$work/out/cal.json"
check "report: no set within the limits, no page" is_untouched

finish
