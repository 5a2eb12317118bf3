#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of plan --moves by the command line: plan_moves_test.sh path/to/invcal builddir
# Expected figures are those of tests/reference/turns_design.h, and closed forms.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

perfect='--rate-noise 0 --instability 0' # the gyroscope: turns are as good as the rests

plan() { # plan ARGUMENTS ...: as JSON
    # shellcheck disable=SC2086 # options are words
    run plan --json $perfect --moves "$@"
}

numbers() { # numbers OBJECT: of a member with a line for each parameter
    awk -v name="\"$1\": {" 'index($0, name) { on = 1; next } on && /}/ { exit }
        on { sub(/.*: /, ""); printf "%s ", $0 }' "$work/stdout"
}

values() { # values NAME: of all members of this name, in order
    sed -n "s/^ *\"$1\": \(.*[^,]\),*\$/\1/p" "$work/stdout"
}

expected() { # expected NAME: a figure or a table of turns_design.h
    awk -v name="$1" '$4 == name || index($4, name "[") == 1 { on = 1 }
        on { last = /;/; sub(/.*=/, ""); gsub(/[{};]/, ""); printf "%s", $0 }
        last { exit }' "$here/../reference/turns_design.h"
}

member_is() { # member_is NAME VALUE
    [ "$(json "$work/stdout" "$1")" = "$2" ] || { json "$work/stdout" "$1" >&2; return 1; }
}
# The gyroscope's nine come first there, and last here.
sigma_is() { # sigma_is NAME: of the plan, all 18
    near 0.00002 "$(numbers sigma)" "$(expected "$1_sigma" | tr -d ' \n' |
        awk -F , '{ for (i = 0; i < 18; i++) printf "%s, ", $((i + 9) % 18 + 1) }' | sed 's/, $//')" ||
        { numbers sigma >&2; return 1; }
}
condition_is() { member_is_near 0.0001 condition "$(expected "$1_condition")"; } # condition_is NAME
member_is_near() { near "$1" "$(json "$work/stdout" "$2")" "$3" || { json "$work/stdout" "$2" >&2; return 1; }; }

# ---- figures -----------------------------------------------------------------------------------

plan tour12
check "tour12: sigma of all 18" sigma_is tour12
check "tour12: its condition" condition_is tour12
check "tour12: rank 18" member_is rank 18
check "tour12: 13 rests of 2 s, 12 turns of 1.5" member_is seconds 44
check "tour12: nothing is open" member_is undetermined '[]'
plan tour16
check "tour16: full turns halve the sigma of the scale" sigma_is tour16
check "tour16: its condition" condition_is tour16
plan tour24
check "tour24: sigma over the square root of 2" sigma_is tour24
check "tour24: its condition" condition_is tour24
plan greedy12
check "greedy12: its figures" sigma_is greedy12
check "greedy12: its condition" condition_is greedy12
check "greedy12: it ends with an edge up" [ "$(values words | sed -n 12p)" = '"edge +x -z up: 135 degrees about y"' ]
plan greedy24
check "greedy24: its figures" sigma_is greedy24
check "greedy24: its condition" condition_is greedy24
plan +z,+x,+y,+z,-x,+y,-z,+x,-y,-z
check "nine turns of the tour, given one by one" condition_is tour9
plan faces
check "faces: rank 18" member_is rank 18
check "faces: 12 turns" [ "$(values words | wc -l)" -eq 13 ] # and the next

# The angle of a turn has the variance 2 a^2 + N^2 T + (N^2 / 2 + (1.5 B)^2) T^2: with a turn that takes twice
# the time, and only noise of the rate, the sigma of the scale is known in advance: sqrt(variance) / pi, if the
# accelerometer is nearly perfect.
run plan --json --moves tour12 --noise 0.000001 --dwell 1 --rate-noise 0.01 --instability 0 --move 2
check "sigma of the scale with a noise of the rate" near 0.0001 \
    "$(numbers expected | awk '{ print 1000 * $10 }')" \
    "$(awk 'BEGIN { n = 0.01 * 3.14159265358979 / 180; t = 2; print 1000 * sqrt(2e-12 + n * n * t + n * n / 2 * t * t) / 3.14159265358979 }')"
run plan --json --moves tour12 --noise 0.0004 --dwell 4
check "--noise is that of one second, --dwell shares it" member_is noise 0.0002
check "--dwell counts in the time" member_is seconds 70

# ---- words -------------------------------------------------------------------------------------

accepts "plan --moves: it prints" plan --moves tour12
check "it names its start" matches "$work/stdout" '^Start with \+z up\.'
check "a quarter turn in words" matches "$work/stdout" '^ +1 \+x up: a quarter turn about y +18 '
check "sigma in units" matches "$work/stdout" '^  gyro scale x  +0\.5[0-9]+ +0\.015[0-9] %$'
accepts "plan --moves with --units ins" plan --moves tour12 --units ins
check "sigma in units of navigation" matches "$work/stdout" '^  gyro scale x .* ppm$'
run plan --moves z:90,-z:180,x:360,+x+y,+x-y-z,y:30
check "about the vertical: left" matches "$work/stdout" '\+z up: a quarter turn as it stands, left'
check "about the vertical: right" matches "$work/stdout" '\+z up: half a turn as it stands, right'
check "a full turn" matches "$work/stdout" ' a full turn about \+x: \+z up'
check "an edge" matches "$work/stdout" 'edge \+x \+y up: a quarter turn '
check "a corner" matches "$work/stdout" 'corner \+x -y -z up: '
check "any direction" matches "$work/stdout" '30 degrees about \+y: \+x up, tilt 40 deg, '
plan -z,+x
check "it may begin anywhere" member_is start '[0, 0, -1]'
plan x:90
check "x:90 turns right-handed: +y comes up" near 1e-12 "$(values up | head -n 1)" '0 1 0'
plan -x:90
check "-x:90 the other way round" near 1e-12 "$(values up | head -n 1)" '0 -1 0'

# ---- what leaves something open ----------------------------------------------------------------

one_axis='"delta_x", "dk_x", "gamma_xy", "gamma_xz", "gyro_xy", "gyro_xz", "gyro_yx", "gyro_yy", "gyro_yz", "gyro_zx", "gyro_zy", "gyro_zz"'
plan x:90,x:90,x:90,x:90,x:90,x:90,x:90,x:90
check "one axis: exit code 1" [ "$code" -eq 1 ]
check "one axis: rank 8" member_is rank 8
check "one axis: what is open is named" member_is undetermined "[$one_axis]"
check "one axis: no sigma" [ "$(numbers sigma | tr -d ' ')" = null,null,null,null,null,null,null,null,null,null,null,null,null,null,null,null,null,null ]
check "one axis: said in one line" says '8 turns determine 8 of 18 parameters; undetermined: offset x, .*, gyro scale z\. Turn next: .* up: '
run plan --moves x:90,x:90,x:90,x:90
check "the table is printed anyway" matches "$work/stdout" '^ +4 \+z up: a quarter turn about x +12 '
check "and no sigma" lacks "$work/stdout" 'sigma'
plan x:90,x:90,x:90,x:90,y:90,y:90,y:90,y:90
check "two axes: rank 14" member_is rank 14
check "two axes: what is open is named" member_is undetermined \
    '["gamma_xy", "gyro_xy", "gyro_xz", "gyro_yx", "gyro_yz", "gyro_zz"]'

# ---- page --------------------------------------------------------------------------------------

accepts "plan --moves --report" plan --quiet --moves tour16 --report "$work/turns.html"
check "it is a page" is_page "$work/turns.html"
check "which shows its command" shows_command "$work/turns.html" invcal plan --quiet --moves tour16 --report "$work/turns.html"
check "and the verdict" matches "$work/turns.html" '16 turns determine all 18 parameters'
check "and each turn" [ "$(grep -c '☐' "$work/turns.html")" -eq 16 ]
run plan --quiet --moves x:90,x:90 --report "$work/open.html"
check "a refusal has a page, too" is_page "$work/open.html"
check "with the open parameters" matches "$work/open.html" 'Undetermined'

# ---- refusals ----------------------------------------------------------------------------------

refuses "no such program" 2 "'tour13' is not a program .*tour12.*a direction .*or a turn" plan --moves tour13
refuses "greedy without a number" 2 'greedy12 and the like, of 1 to 31' plan --moves greedy
refuses "greedy with too many" 2 'greedy12 and the like, of 1 to 31' plan --moves greedy32
refuses "the opposite has no shortest way" 2 "'-z' points up or down already, .*x:180" plan --moves +z,-z
refuses "an axis twice" 2 "'\+x\+x' is not a program" plan --moves +x+x
refuses "too many degrees" 2 "'x:721' is not a program" plan --moves x:721
refuses "no degrees" 2 "'x:' is not a program" plan --moves x:
refuses "a turn with something behind" 2 "'x:90y' is not a program" plan --moves x:90y
refuses "an empty word" 2 "'' is not a program" plan --moves +z,,+x
refuses "no turn at all" 2 'one rest without a turn' plan --moves +x
refuses "more turns than a device keeps" 2 'more than 31 turns' plan --moves "$(awk 'BEGIN { for (i = 0; i < 31; i++) printf "x:90,"; print "x:90" }')"
refuses "a turn that is too slow" 2 'turn 13 of tour16 would take 12 s; the bias is known for 10 s only' plan --moves tour16 --move 3
refuses "--rate-noise without --moves" 2 '--rate-noise: needs --moves' plan --rate-noise 0.01
refuses "--instability without --moves" 2 '--instability: needs --moves' plan --instability 10
refuses "a negative rate noise" 2 '--rate-noise -1: must be within' plan --moves tour12 --rate-noise -1
refuses "--moves beside a set" 2 '--moves: names its own sets' plan --moves tour12 --edges
refuses "--moves beside --programs" 2 '--programs: cannot be combined with --moves' plan --moves tour12 --programs
refuses "--moves with --limits" 2 '--limits: .*leave out .*--moves' plan --moves tour12 --limits 1,1,1
for option in '--svg x.svg' '--settle 1' '--warm-up 1'; do
    # shellcheck disable=SC2086 # an option and its value
    refuses "--moves with ${option% *}" 2 "${option% *}: cannot be combined with --moves" plan --moves tour12 $option
done
refuses "--moves with --csv" 2 '--csv: needs a single set' plan --moves tour12 --csv
refuses "a report that cannot be written" 3 'none/r.html' plan --moves tour12 --report "$work/none/r.html"

finish
