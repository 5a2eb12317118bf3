#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What the angles of a stand show, file by file: stand_test.sh path/to/invcal builddir. Simulated stands
# with each of the troubles of port/manual/errors.md, "The stand"; five files of each.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

make_file() { # TROUBLE SEED [plain=1 ...]
    trouble=$1
    seed=$2
    shift 2
    # shellcheck disable=SC2046 # assignments without blanks
    set -- $(printf -- '-v %s ' "$@" | sed 's/-v  *$//')
    awk -v trouble="$trouble" -v seed="$seed" "$@" -f "$here/random.awk" -f "$here/stand.awk"
}
calibrate() { run calibrate "$@" --positions --zero 0,0,0 --lsb 1 --noise 0.000980665 --gravity 9.80665; }

# each TROUBLE PATTERN [OPTIONS]: five files get that message, and are still good
each() {
    trouble=$1
    pattern=$2
    shift 2
    for seed in 1 2 3 4 5; do
        make_file "$trouble" $seed > "$work/$trouble.$seed"
        calibrate "$work/$trouble.$seed" "$@"
        tr '\n' ' ' < "$work/stdout" > "$work/words"
        { [ "$code" -eq 0 ] && matches "$work/words" "$pattern" && matches "$work/stdout" '^Good: '; } ||
            { cat "$work/stdout" "$work/stderr" >&2; return 1; }
    done
}
quiet() { each "$@" && lacks "$work/stdout" '^(Misset|Stand): '; }

# The mounting is TRUTH (degrees) within 5 sigma; the three sigma are 1/sqrt(12) of the scatter.
is_mounted() { # TROUBLE TRUTH
    for seed in 1 2 3 4 5; do
        calibrate "$work/$1.$seed" --stand --json
        awk -v truth="$2" -F'[][,:]' '/"mounting"/ { for (i = 1; i <= 3; i++) m[i] = $(i + 2) }
            /"vertical"/ { exit } /"stand"/ { on = 1 } on && /"sigma"/ { for (i = 1; i <= 3; i++) s[i] = $(i + 2) }
            /"scatter"/ { scatter = $2 }
            END { split(truth, t, " ")
                for (i = 1; i <= 3; i++) {
                    d = (m[i] - t[i]) / s[i]
                    r = s[i] * sqrt(12) / scatter
                    if (!(d * d < 25 && r > 0.99 && r < 1.01)) exit 1 } }' "$work/stdout" || return 1
    done
}

check "stand: without trouble there is no message" quiet none ' closure .*sigma' --stand
check "stand: it sits straight" is_mounted none '0 0 0'
check "stand: a tilt of 14 mrad is the mounting, and causes no error" quiet tilt 'mounting x' --stand
check "stand: it is known with its sigma" is_mounted tilt '0.26738 0.53476 -0.53476'
check "stand: 10 mrad are named" each misset 'Misset: position 8 .* is off by (9\.[6-9]|10)[.0-9]* mrad: alpha by \+0\.5[0-9]*' --stand
check "stand: 1 mrad, too" each fine 'Misset: position 8 .* is off by (0\.[789]|1\.)[0-9]* mrad' --stand
check "stand: three of 5 degrees, which hide each other" each several \
    'Misset: position 3 .* is off by 87\.[0-9]* mrad: .*Misset: position 7 .* 87\..*Misset: position 11 .* 8[67]\.' --stand
check "stand: no others are named" sh -c '[ "$(grep -c "^Misset" "$1")" -eq 3 ]' sh "$work/stdout"
check "stand: of more than a quarter, none, and there is no answer" each many \
    'Stand: the angles are off by more than 10 mrad .*too many positions are misset to tell which' --stand
check "stand: the scatter is" matches "$work/stdout" '^directions +[2-9][0-9]\.[0-9]* mrad'
check "stand: no mounting is printed, nor J1" lacks "$work/stdout" '^mounting|by J1'
check "stand: two swapped positions are named" each swapped \
    'Misset: position (5 .* swapped with position 12|12 .* swapped with position 5)\..*Misset: position (5|12) ' --stand
check "stand: a repeated one is" each repeated 'Misset: position 8 .* reads like position 7: repeated' --stand
check "stand: one more position causes no error" quiet twice 'group 2 ' --stand
check "stand: nor does one less" quiet lost 'group 2 ' --stand
check "stand: exchanged columns are named" each columns 'Stand: .*only with alpha and beta swapped: ' --stand
check "stand: a reversed beta is" each reversed 'Stand: .*only with the sense of beta reversed' --stand
check "stand: and corrected when stated" quiet reversed ' closure ' --stand --stand-sense 1,-1
check "stand: a wrong sense that was stated is reversed" each none \
    'only with the sense of beta reversed: state --stand-sense 1,1 ' --stand --stand-sense 1,-1
"$tool" simulate --plan edges > "$work/edges.csv"
run calibrate "$work/edges.csv" --plan per-group:6
tr '\n' ' ' < "$work/stdout" > "$work/words"
check "stand: with --plan, options that it excludes are not advised" matches "$work/words" \
    'do not fit the angles of the plan: check the order of the positions, and the senses and zeros of the stand; or add columns'
check "stand: another zero of alpha is reported" each zero 'Stand: the angles do not fit the readings' --stand
check "stand: and subtracted when stated" quiet zero ' closure ' --stand --stand-zero 20,0
check "stand: a reversed alpha is half a turn about y" each alpha \
    'mounting y +-?1(79\.9|80\.0).*The unit appears to be mounted at a large angle' --stand

# ---- as JSON ------------------------------------------------------------------------------------------

calibrate "$work/misset.1" --stand --json
tr -d '\n ' < "$work/stdout" > "$work/words"
check "stand: a misset position in JSON" matches "$work/words" \
    '"misset":\[\{"position":8,"kind":"misset","angle":0\.5[5-9]'
calibrate "$work/many.1" --stand --json
check "stand: too many of them" matches "$work/stdout" '"angles": "scattered"'
calibrate "$work/many.1" --stand --frame stand
check "stand: which give no frame" was_refused 1 'no frame of the stand: the angles are off by more than 10 mrad'
awk -F, -v OFS=, 'NR > 1 { $4 *= atan2(0, -1) / 180; $5 *= atan2(0, -1) / 180 } { print }' "$work/tilt.1" > "$work/radians"
calibrate "$work/radians" --stand
check "stand: angles in radians are suspected" matches "$work/stdout" \
    '^Stand: the angles do not fit the readings: are they in radians\? Head them alpha \(rad\) and beta \(rad\)\.$'
sed '1s/alpha,beta/alpha (rad),beta (rad)/' "$work/radians" > "$work/headed"
calibrate "$work/headed" --stand --json
radians=$(sed -n 's/"mounting"://p' "$work/stdout" | head -n 1)
calibrate "$work/tilt.1" --stand --json
check "stand: and read, if their heading says so" \
    near 1e-4 "$radians" "$(sed -n 's/"mounting"://p' "$work/stdout" | head -n 1)"
calibrate "$work/swapped.1" --stand --json
tr -d '\n ' < "$work/stdout" > "$work/words"
check "stand: swapped ones in JSON" matches "$work/words" '"position":12,"kind":"swapped","other":5,"angle":(29\.9|30\.0)'
check "stand: each with the other" matches "$work/words" '"position":5,"kind":"swapped","other":12,"angle":(29\.9|30\.0)'

# ---- some positions without angles --------------------------------------------------------------------

without() { # FIRST: from that position on there are none
    awk -F, -v first="$1" 'NR > first { $4 = $5 = "" } 1' OFS=, "$work/none.1" > "$work/without"
    calibrate "$work/without" --stand
}
without 9
check "stand: positions without angles are counted" matches "$work/stdout" '^stand +8 positions with angles .*, 10 without'
check "stand: eight determine the mounting" matches "$work/stdout" '^mounting z '
check "stand: but not J1" matches "$work/stdout" '^J1 +these directions leave parameters undetermined$'
without 4
check "stand: three determine nothing" matches "$work/stdout" '^Stand: too few positions have angles'
calibrate "$work/without" --stand --json
check "stand: nor as JSON" matches "$work/stdout" '"angles": "few"'

calibrate "$work/none.1" --stand --units ins
# 0.1 mrad over sqrt(12) is 6 arcsec; 36 numbers tell it within a quarter. The offset is 3000 micro-g.
check "stand: in the requested units" matches "$work/stdout" '^mounting x +-?[0-9.]+ ± ([4-7]\.[0-9]*|8) +arcsec, '
check "stand: J1 as well" matches "$work/stdout" '^offset x +(29|30)[0-9][0-9] ± [0-9]+ .* µg$'

# ---- a group that is missing -------------------------------------------------------------------------

make_file group 1 > "$work/group"
refuses "stand: without group 3 the angle xy stays open, and it is named" 1 \
    'undetermined: angle xy; group 3 .beta 90, alpha all round. was not visited, .*: visit it' \
    calibrate "$work/group" --positions --stand --gravity 9.80665
refuses "stand: columns alone tell that, too" 1 'undetermined: angle xy; group 3 ' \
    calibrate "$work/group" --positions --gravity 9.80665
sed 2,7d "$work/none.1" > "$work/first"
refuses "stand: without group 1" 1 'undetermined: angle zy; group 1 .beta 0, alpha all round. was not' \
    calibrate "$work/first" --positions --stand
sed 8,13d "$work/none.1" > "$work/second"
refuses "stand: without group 2" 1 'undetermined: angle xz; group 2 .alpha -90, beta all round. was not' \
    calibrate "$work/second" --positions --stand
awk -F, 'NR > 1 { $4 = 5 - $4; $5 += 7 } { OFS = ","; $1 = $1; print }' "$work/second" > "$work/other"
refuses "stand: as the stand reads it" 1 'group 2 .alpha 95, beta all round. was not' \
    calibrate "$work/other" --positions --stand --stand-sense -1,1 --stand-zero 5,7
make_file group 1 log_wanted=1 > "$work/log"
refuses "stand: in a log as well" 1 'undetermined: angle xy; group 3 .beta 90' calibrate "$work/log" --stand --quiet
cut -d, -f1-3 "$work/group" > "$work/bare"
refuses "stand: where no angles tell it, the field is" 1 'angle xy; add positions with the field midway' \
    calibrate "$work/bare" --positions
refuses "stand: as many as a group are missing of a program" 3 'has 18: .*; was a whole group not visited' \
    calibrate "$work/bare" --positions --plan per-group:6
sed 6,13d "$work/none.1" > "$work/half"
refuses "stand: with half a group missing too it is more than that" 1 'angle xz; add positions with the field' \
    calibrate "$work/half" --positions --stand

# ---- the program instead of columns --------------------------------------------------------------------

make_file misset 1 plain=1 > "$work/plain.csv"
calibrate "$work/plain.csv" --plan per-group:6
check "stand: the program gives the angles as well" matches "$work/stdout" '^Misset: position 8 .* is off by (9\.[6-9]|10)'
make_file lost 1 plain=1 > "$work/lost.csv"
refuses "stand: of another number of positions it does not" 3 'holds 17 positions, but --plan 3 x 6 has 18' \
    calibrate "$work/lost.csv" --positions --plan per-group:6
refuses "stand: without columns there are no angles" 3 'needs columns alpha and beta' \
    calibrate "$work/lost.csv" --positions --stand

# ---- the frame of the stand --------------------------------------------------------------------------

# Calibrated readings of a tilted unit are the directions of the stand.
is_turned() {
    calibrate "$work/tilt.1" --stand --frame stand --json
    json "$work/stdout" matrix > /dev/null
    cp "$work/stdout" "$work/turned.json"
    "$tool" apply "$work/turned.json" "$work/tilt.1" 2> /dev/null | awk -F, 'NR > 1 { n++
        x = $1 / 9.80665; y = $2 / 9.80665
        if (n == 1 && !(x * x < 25e-8 && (y - sqrt(3) / 2) ^ 2 < 25e-8)) exit 1
        if (n == 18 && !((x - sqrt(3) / 2) ^ 2 < 25e-8 && (y - 0.5) ^ 2 < 25e-8)) exit 1 }
        END { exit n != 18 }' && grep -q '"frame": "stand"' "$work/turned.json"
}
check "stand: the calibrated frame is turned to it" is_turned
refuses "stand: angles that do not fit turn no frame" 1 'no frame of the stand: the angles fit' \
    calibrate "$work/reversed.1" --positions --stand --frame stand
refuses "stand: no frame without angles" 2 '--frame: needs the angles of a stand' \
    calibrate "$work/none.1" --positions --frame stand
refuses "stand: a sense is 1 or -1" 2 '--stand-sense: must be 1 or -1' \
    calibrate "$work/none.1" --positions --stand --stand-sense 2,1
refuses "stand: no sense without angles" 2 '--stand-sense: needs the angles' \
    calibrate "$work/none.1" --positions --stand-sense 1,-1
refuses "stand: nor beside temperature" 2 '--thermal: cannot be combined with the angles' \
    calibrate "$work/none.1" --positions --stand --thermal 1

# ---- a log -------------------------------------------------------------------------------------------

log() { # TROUBLE PATTERN
    make_file "$1" 1 log_wanted=1 > "$work/log.csv"
    run calibrate "$work/log.csv" --stand --gravity 9.80665 --zero 0,0,0 --lsb 1
    { [ "$code" -eq 0 ] && matches "$work/stdout" '18 positions with angles .columns.$' &&
        matches "$work/stdout" "$2"; } || { cat "$work/stdout" "$work/stderr" >&2; return 1; }
}
check "stand: a log with angles, too" log none '^closure '
check "stand: a misset rest of it is named" log misset '^Misset: position 8 .* is off by '
check "stand: at rest a centre of rotation that is 0.3 m off does nothing" log offset '^Good: '

# ---- the table of the manual ---------------------------------------------------------------------------

# What a row of errors.md, "The stand", quotes is printed, in this order; "nothing" means no message about the stand.
sed -n '/^### The stand/,/^### The clock/p' "$here/../../port/manual/errors.md" | grep '^| ' | sed 1d > "$work/rows"
row() { # TROUBLE CODE ARGUMENTS ...: the first cell, and what calibrate is called with
    row=$(grep -F "| $1 |" "$work/rows")
    trouble=$1
    expected=$2
    shift 2
    run calibrate "$@" --zero 0,0,0 --lsb 1 --noise 0.000980665 --gravity 9.80665
    tries=$((tries + 1))
    check "stand: errors.md is right about: $trouble" row_is_true
}
row_is_true() {
    message=$(echo "$row" | awk -F ' [|] ' '{ print $3 }')
    { [ -n "$message" ] && [ "$code" -eq "$expected" ]; } || { complain; return 1; }
    if [ "$message" = nothing ]; then
        matches "$work/stdout" '^Good: ' && lacks "$work/stdout" '^(Misset|Stand|The unit appears)'
        return
    fi
    cat "$work/stdout" "$work/stderr" | tr -s ' \n' ' ' > "$work/words"
    echo "$message" | grep -o '"[^"]*"' | tr -d '"' > "$work/quoted"
    awk 'NR == FNR { text = $0; next } !(at = index(text, $0)) { print "    not said: " $0; exit 1 }
        { text = substr(text, at + length($0)) }' "$work/words" "$work/quoted" >&2 && [ -s "$work/quoted" ]
}
tries=0
for one in "an angle misset by 1 mrad=fine" "an angle misset by 10 mrad=misset" "the unit mounted 14 mrad off=tilt" \
    "three angles misset by 5°=several" "nine angles misset by 5°=many" \
    "columns alpha and beta exchanged=columns" "the sense of beta reversed=reversed" \
    "the sense of alpha reversed=alpha" "another zero of alpha, by 20°=zero" "two positions swapped=swapped" \
    "a position repeated in place of the next=repeated" "an extra position=twice" "a position missing=lost"; do
    row "${one%=*}" 0 "$work/${one##*=}.1" --positions --stand
done
row "angles in radians, without a unit in the heading" 0 "$work/radians" --positions --stand
make_file offset 1 log_wanted=1 > "$work/offset.csv"
row "axes of the stand that do not meet in the unit, by 0.3 m" 0 "$work/offset.csv" --stand
row "another zero of beta, by 20°" 0 "$work/none.1" --positions --stand --stand-zero 0,-20
# shellcheck disable=SC2016 # backticks of the page
row 'a position missing, without columns (`--plan`)' 3 "$work/lost.csv" --positions --plan per-group:6
row "group 3 missing" 1 "$work/group" --positions --stand
# shellcheck disable=SC2016
row 'group 3 missing, without columns (`--plan`)' 3 "$work/bare" --positions --plan per-group:6
check "stand: errors.md has no other rows" test "$tries" -eq "$(wc -l < "$work/rows")"

# ---- the page ----------------------------------------------------------------------------------------

page=$work/out/page.html
words() {
    sed -n '/<h2>At the stand/,/<\/section>/p' "$page" | sed '/<svg /,/<\/svg>/d; s/<[^>]*>/ /g; s/−/-/g' |
        tr -s ' \n' ' ' | plainly
}
says_page() { words | grep -Eq -- "$1" || { { words | head -c 600; echo; } >&2; return 1; }; }
says_not() { ! words | grep -Eq -- "$1"; }
makes_page() { # SENTENCE FILE OPTIONS ...
    sentence=$1
    shift
    rm -f "$page"
    calibrate "$@" --json --report "$page"
    check "stand: page of $sentence" succeeded
    check "stand: page of $sentence: well-formed and self-contained" is_page "$page"
    check "stand: page of $sentence: every number is finite" lacks "$page" '[^a-zA-Z](nan|inf)[^a-zA-Z]'
}
figures_are_those_of_json() { # AT LEAST
    compared=$(awk -f "$here/figures.awk" -f "$here/stand_page.awk" "$work/stdout" "$page")
    [ "$compared" -ge "$1" ] || { echo "    $compared" >&2; return 1; }
}

makes_page "a straight unit" "$work/none.1" --stand
check "stand: the page has the figures of the JSON" figures_are_those_of_json 136
check "stand: it says how the angles are read" says_page \
    '18 positions with angles, in degrees: α = alpha, β = beta, .* derived from the paper.s Table 2'
check "stand: nothing is misset" says_page 'No position is misset'
check "stand: the paper's table is filled in" says_page \
    'group a0 a1 b1 a2 b2 1, 6 positions .* stands for [(]δk_y [+] δk_z[)]/2 Δ_y Δ_z [(]δk_y - δk_z[)]/2 γ_zy/2 2, 6 .* 3, 6 .* γ_xy/2'
check "stand: closures have their test" says_page 'F = [0-9.]* with 6 and 3 degrees of freedom'
# Both ends of an arrow: at its beginning the front moves up, with growing beta the right side to the front.
arrows_turn_as_derived() {
    sed -n '/<title>The unit on the two axes/,/<\/svg>/p' "$page" | grep '<polyline class="c2 curve"' |
        sed 's/.*points="//; s/[",]/ /g' | awk 'NR == 1 && !($4 < $2) { exit 1 } NR == 2 && !($3 < $1 && $4 > $2) { exit 1 }
            END { exit NR != 4 }'
}
check "stand: the arrows turn as derived" arrows_turn_as_derived
makes_page "a misset one" "$work/misset.1" --stand
check "stand: figures of a misset one are those of the JSON" figures_are_those_of_json 138
check "stand: it is named on the page" says_page \
    'Misset: position 8 .alpha -90, beta 90. is off by (9\.[6-9]|10)[.0-9]* mrad: .* Lengths do not depend on angles'
makes_page "a tilted unit" "$work/tilt.1" --stand
check "stand: figures of a tilted one are those of the JSON" figures_are_those_of_json 136
makes_page "exchanged columns" "$work/columns.1" --stand
check "stand: exchanged columns are reported on the page" says_page \
    '^ *At the stand ! The angles fit the readings only with alpha and beta swapped: exchange'
check "stand: and the angles are not used" says_not 'mounting|closure|J1'
makes_page "another convention" "$work/reversed.1" --stand --stand-sense 1,-1
check "stand: the page shows the sense" says_page 'α = alpha, β = -beta, where'
makes_page "another zero" "$work/zero.1" --stand --stand-zero 20,0 --units ins
check "stand: the page shows the zero" says_page 'α = [(]alpha - 20°[)], β = beta, where'
check "stand: and the requested units" says_page 'about x [-+0-9.]* ± [0-9.]* arcsec .* offset x [-+0-9.]* ± [0-9.]* µg'
makes_page "a program" "$work/plain.csv" --plan per-group:6
check "stand: the page says that the order was kept" says_page 'those of the program 3 x 6, in its order'
head -n 15 "$work/none.1" > "$work/short"
makes_page "an incomplete group" "$work/short" --stand
check "stand: the page says which group is open" says_page \
    '3, 2 positions open open open .* Group 3 is incomplete: 2 positions do not determine its five coefficients'
check "stand: without closures" says_not 'closure'
run calibrate "$work/none.1" --positions --report "$page"
check "stand: without --stand the page does not mention it" lacks "$page" 'At the stand'
finish
