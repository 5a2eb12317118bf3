#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Refusals: one line, the JSON and a page say the same, and --out is left alone; with the positions that it asks for,
# there is a calibration: refusal_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

page=$work/out/page.html
words() { sed '/<style>/,/<\/style>/d; /<svg /,/<\/svg>/d; s/<[^>]*>/ /g; s/−/-/g' "$page" | tr -s ' \n' ' ' | plainly; }
shows() { words | grep -Eq -- "$1" || { words | head -c 900 >&2; return 1; }; }
text() { json "$work/stdout" "$1" | sed 's/^"//; s/"$//'; }
marks() { # of the map, without the legend
    grep '<title>Positions with z' "$page" > /dev/null &&
        sed -n '/<title>Positions with z/,/<\/svg>/p' "$page" | grep -c "class=\"$1"
}

# One run: line, JSON and page; cal.json as it was.
refused_as() { # WORD ARGUMENTS
    word=$1
    shift
    rm -f "$page"
    echo old > "$work/out/cal.json"
    run calibrate "$@" --out "$work/out/cal.json" --report "$page" --json
    [ "$code" -eq 1 ] && [ "$(wc -l < "$work/stderr")" -eq 1 ] && [ "$(cat "$work/out/cal.json")" = old ] &&
        [ "$(text error)" = "$word" ] && is_page "$page" || { complain; return 1; }
    reason=$(text reason)
    next=$(text next)
    grep -Fq -- "$reason${next:+; $next}" "$work/stderr" || { echo "    $reason; $next" >&2; return 1; }
    words > "$work/words"
    # on the page the sentence begins with a capital letter
    grep -Fq -- "${reason#?}. Next: $next" "$work/words" && grep -q "✗ No calibration: $word " "$work/words" &&
        grep -q 'class="verdict bad"' "$page" || { head -c 600 "$work/words" >&2; return 1; }
    # the rows of positions to add are the JSON's, and the map has that many targets
    sed -n 's/^ *"words": "\(.*\)"$/\1/p' "$work/stdout" > "$work/add"
    sed -n '/<h2>Positions to add/,/<\/table>/p' "$page" | grep '^<tr><th scope="row"' |
        sed 's/^[^>]*>[^>]*>[a-z]<\/th><td class="text">\([^<]*\)<.*/\1/' | sed 's/−/-/g' > "$work/rows"
    same "$work/add" "$work/rows" || { diff "$work/add" "$work/rows" >&2; return 1; }
}

positions sphere 5 1 > "$work/few.csv"
positions sphere 13 1 > "$work/thirteen.csv"
positions sphere 16 1 > "$work/sixteen.csv"
positions plane 18 4 > "$work/plane.csv"
printf '%s\n' 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 1,2,3 > "$work/one.csv"
"$tool" simulate --plan faces > "$work/faces.csv"
"$tool" simulate --plan edges --dwell 0.5 --move 0.5 > "$work/restless.csv"
"$tool" simulate --plan edges --temperature 10,40 --drift 0.001 > "$work/drift.csv"

check "refusal: too few" refused_as 'too few' "$work/few.csv" --positions
check "refusal: seven to add" test "$(wc -l < "$work/add")" -eq 7
check "refusal: they are in the map, and those taken" test "$(marks 'c3 full')" -eq 7 -a "$(marks 'c1 full')" -eq 5
check "refusal: what is not determined is reported" shows 'Undetermined: '
words > "$work/words"
check "refusal: the file that was not written is named" grep -Fq "$work/out/cal.json was not written." "$work/words"
check "refusal: undetermined" refused_as undetermined "$work/plane.csv" --positions
check "refusal: the map gives the same advice as the text" test "$(wc -l < "$work/add")" -gt 0 -a \
    "$(marks 'c3 full')" -eq "$(wc -l < "$work/add")"
positions hyperboloid 18 1 > "$work/saddle.csv"
check "refusal: not an ellipsoid" refused_as 'not an ellipsoid' "$work/saddle.csv" --positions
check "refusal: one position again and again" refused_as undetermined "$work/one.csv" --positions
check "refusal: six faces in a log" refused_as 'too few' "$work/faces.csv"
check "refusal: with the log on the page" shows 'The log 4[0-9]* samples'
check "refusal: a log without a rest" refused_as 'no rest' "$work/restless.csv"
check "refusal: with twelve to add" test "$(wc -l < "$work/add")" -eq 12
check "refusal: a wrong unit" refused_as 'out of range' "$data/xsens_mti_positions.csv" --positions --unit g
awk -F, -v OFS=, 'NR == 3 { $1 *= 20; $2 *= 20; $3 *= 20 } 1' "$work/sixteen.csv" > "$work/shock.csv"
check "refusal: a shock" refused_as 'out of range' "$work/shock.csv" --positions --zero 0,0,0 --lsb 1 --keep-all
check "refusal: the position is crossed, and named" shows 'Position 3 reads (19|20)[.0-9]* of the field .* refused'
check "refusal: in the map" test "$(marks 'c2 full')" -eq 1
sed 's/^/1e300,/; s/,[^,]*$//' "$work/few.csv" | head -n 1 > "$work/huge.csv"
cat "$work/thirteen.csv" >> "$work/huge.csv"
check "refusal: a reading that is too large" refused_as 'out of range' "$work/huge.csv" --positions --zero 0,0,0 \
    --lsb 1 --keep-all
check "refusal: every number of its page is finite" lacks "$work/words" '[^a-z](nan|inf)[^a-z]'
check "refusal: its length is reported in words" shows 'far off refused'
check "refusal: all rests drift" refused_as 'too few' "$work/drift.csv" --thermal 1
check "refusal: positions that drifted are crossed, none are to be added" test "$(wc -l < "$work/add")" -eq 0 -a \
    "$(marks 'c2 full')" -ge 12
check "refusal: --quadratic of thirteen" refused_as 'too few' "$work/thirteen.csv" --positions --quadratic
check "refusal: one to add" test "$(wc -l < "$work/add")" -ge 1
check "refusal: --cubic in a plane and a circle" refused_as 'too few' "$work/sixteen.csv" --positions --cubic
awk -v trouble=columns -v seed=1 -f "$here/random.awk" -f "$here/stand.awk" > "$work/stand.csv"
check "refusal: angles of another stand" refused_as angles "$work/stand.csv" --positions --stand --frame stand
check "refusal: FAIL, too, if there is a need" refused_as 'too few' "$work/few.csv" --positions --need 1mg
check "refusal: in its box" shows 'No calibration: too few ✗ FAIL: there is no calibration\. 5 positions'
run calibrate "$work/few.csv" --positions --report "$page"
check "refusal: without --json the page is named" grep -Fxq "Report in $page." "$work/stdout"
run calibrate "$work/few.csv" --positions --report "$page" --quiet
check "refusal: --quiet says nothing but the reason" was_refused 1 'too few'
run calibrate "$work/few.csv" --positions --report "$work/nowhere/page.html" --json
check "refusal: a page that cannot be written is reported before any work" sh -c \
    'test "$1" -eq 3 && grep -q "nowhere" "$2"' sh "$code" "$work/stderr"
in=$work/faces.csv
run watch - --report "$page" --quiet
in=/dev/null
check "refusal: watch makes one, too" shows 'No calibration: too few'
check "refusal: its title" shows '^ Calibration of standard input'

# ---- the positions to add are enough -------------------------------------------------------------

# With the directions taken and those of "add", a simulated sensor gets a calibration.
is_enough() { # VERDICT FILE-OF-DIRECTIONS [ARGUMENTS]
    verdict=$1
    taken=$2
    shift 2
    "$tool" simulate --plan "directions:$taken" > "$work/taken.csv"
    run calibrate "$work/taken.csv" "$@" --json
    [ "$code" -eq 1 ] || { complain; return 1; }
    { cat "$taken"; sed -n 's/^ *"up": \[\(.*\)\],$/\1/p' "$work/stdout" | tr -d ,; } > "$work/all.txt"
    "$tool" simulate --plan "directions:$work/all.txt" > "$work/all.csv"
    run calibrate "$work/all.csv" "$@" --json
    grep -q "\"verdict\": \"$verdict\"" "$work/stdout" || { complain; json "$work/stdout" verdict >&2; return 1; }
}
printf '%s\n' '1 0 0' '-1 0 0' '0 1 0' '0 -1 0' '0 0 1' '0 0 -1' > "$work/six.txt"
check "refusal: six faces and what is to be added" is_enough good "$work/six.txt"
awk 'BEGIN { for (i = 0; i < 15; i++) { a = 0.41888 * i; print cos(a), sin(a), 0 } }' > "$work/circle.txt"
check "refusal: a circle" is_enough good "$work/circle.txt"
printf '%s\n' '0 0 1' '0.2 0 1' '0 0.2 1' '-0.2 0.1 1' > "$work/cap.txt"
check "refusal: a cap" is_enough good "$work/cap.txt"
head -n 5 "$work/six.txt" > "$work/five.txt"
check "refusal: five positions, for a quadratic" is_enough good "$work/five.txt"
{ cat "$work/six.txt"; printf '%s\n' '1 1 0' '-1 1 0' '1 0 1' '0 1 1' '1 1 1' '-1 -1 1'; } > "$work/dozen.txt"
check "refusal: a quadratic of twelve" is_enough good "$work/dozen.txt" --quadratic
check "refusal: a cubic of twelve" is_enough good "$work/dozen.txt" --cubic

finish
