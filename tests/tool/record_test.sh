#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the record in a calibration, and of JSON with one object per line: record_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
xsens=$data/xsens_mti_positions.csv
calibrate="calibrate $xsens --positions --gravity 9.81744"
log=$work/raw.csv
"$tool" simulate --plan edges > "$log"

# ---- the record --------------------------------------------------------------------------------

# shellcheck disable=SC2086
run $calibrate --device 'MTi "<10>"' --serial 0047 --operator Jürgen --date 2026-11-23 --note 'on the bench' \
    --out "$work/cal.json" --report "$work/page.html"
check "record: calibrate accepts it" succeeded
head -n 5 "$work/stdout" > "$work/head"
printf '%-14s%s\n' device 'MTi "<10>"' serial 0047 operator Jürgen date 2026-11-23 note 'on the bench' \
    > "$work/expected"
check "record: the table begins with it" same "$work/head" "$work/expected"
members() { sed -n '/^  "record": {$/,/^  }/s/^    //p' "$1"; }
cat > "$work/expected" << 'END'
"device": "MTi \"<10>\"",
"serial": "0047",
"operator": "Jürgen",
"date": "2026-11-23",
"note": "on the bench"
END
members "$work/cal.json" > "$work/members"
check "record: CAL.json has it" same "$work/members" "$work/expected"
check "record: and apply reads that" is_json "$work/cal.json"
check "record: the page is well-formed" is_page "$work/page.html"
sed '/class="verdict/,$d; s/<[^>]*>/ /g' "$work/page.html" | plainly | tr '\n' ' ' | tr -s ' ' > "$work/top"
check "record: the page has it above the verdict" grep -qF \
    'device MTi "<10>" serial 0047 operator Jürgen date 2026-11-23 note on the bench' "$work/top"
check "record: the page has a header for paper, whose text nothing can end" matches "$work/page.html" \
    '^@page\{@top-right\{.*content:"MTi \\22 \\3c 10\\3e \\22  · serial 0047 · 2026\\2d 11\\2d 23"\}\}$'
# shellcheck disable=SC2086
run $calibrate --serial 1 --json
check "record: only what is given" [ "$(members "$work/stdout")" = '"serial": "1"' ]
# shellcheck disable=SC2086
run $calibrate --out "$work/plain.json" --report "$work/page.html"
check "record: without one, it is not mentioned" lacks "$work/plain.json" record
check "record: without one, the page has no header" lacks "$work/page.html" top-right
run watch "$log" --serial 7 --json
check "record: watch has it" matches "$work/stdout" '^    "serial": "7"$'

# shellcheck disable=SC2086
{
    refuses "record: no such day" 2 "--date '2026-02-30': is not a date" $calibrate --date 2026-02-30
    refuses "record: a date of another form" 2 "write it like 2026-11-23" $calibrate --date 23.11.2026
    refuses "record: control characters" 2 "--note 'a\?b': is not plain UTF-8 text" $calibrate --note "$(printf 'a\033b')"
    refuses "record: a text too long" 2 "--serial '0+1': is too long" $calibrate --serial "$(printf %0160d 1)"
    refuses "record: an empty one" 2 '--serial: its value is empty' $calibrate --serial=
}
planted() { # SENTENCE PATTERN SED: compare reads all there is
    sed "$3" "$work/cal.json" > "$work/bad.json"
    refuses "record: a file with $1" 3 "bad.json:[0-9]+: $2" compare "$work/bad.json" "$work/cal.json"
}
planted "a day that does not exist" '"date" of "record" is not a date' 's/2026-11-23/2026-11-31/'
planted "an escape sequence" '"serial" of "record" is not plain' 's/0047/\\u001b[31m/'
planted "a text that is too long" '"note" of "record" is too long' "s/on the bench/$(printf %0160d 1)/"

# ---- one line each -----------------------------------------------------------------------------

# shellcheck disable=SC2086
run $calibrate --json-lines
check "lines: a calibration is one line" [ "$code $(wc -l < "$work/stdout")" = "0 1" ]
check "lines: it begins with the file" matches "$work/stdout" "^\\{\"file\": \"$xsens\", \"invcal\": "
unspaced() { tr -d ' \n'; }
unspaced < "$work/stdout" | sed "s|\"file\":\"$xsens\",||" > "$work/line"
# shellcheck disable=SC2086
run $calibrate --json
unspaced < "$work/stdout" > "$work/object"
check "lines: and is the object of --json" same "$work/line" "$work/object"
refusal() { # CODE ERROR
    [ "$code $(wc -l < "$work/stdout") $(wc -l < "$work/stderr")" = "$1 1 1" ] &&
        matches "$work/stdout" "^\\{\"file\": \".*\", \"error\": \"$2\", \"reason\": \"..*\", \"undetermined\": \\[.*\\]\\}\$"
}
head -n 4 "$xsens" > "$work/few.csv"
run calibrate "$work/few.csv" --positions --json-lines
check "lines: a refusal is one line" refusal 1 'too few'
run calibrate "$work/none.csv" --json-lines
check "lines: an unreadable file is one line" refusal 3 unreadable
check "lines: with the message" matches "$work/stdout" '"reason": ".*none\.csv: cannot be read'
refuses "lines: a usage error is not one line of JSON" 2 'its value is missing' calibrate "$log" --json-lines --serial
run calibrate "$log" --json-lines --out "$work/laid.json"
check "lines: the file of --out is laid out for people" matches "$work/laid.json" '^  "invcal": "[0-9.]*",$'

finish
