#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What README.md says of costs, from what `make bench` and `make size` have measured in folder $1.
# Says which row differs; ends with `N passed, N failed`.
build=$1
readme=$(dirname "$0")/../README.md
passed=0
failed=0

figure() { # target, what
    awk -v what="$2" '$1 == what || ($1 == "stack" && $3 == what) { print $1 == what ? $2 : $4; exit }' \
        "$build/bench/$1.figures" "$build/size/$1.figures" "$build"/size/*"$1"/measured |
        sed -e ':a' -e 's/^\([0-9]\{1,\}\)\([0-9]\{3\}\)/\1,\2/' -e 'ta'
}

row() { # title, what
    line="| $1 |"
    for target in m0plus m4f rv32imac rv32imafc atmega1284p; do
        line="$line $(figure $target "$2") |"
    done
    expect "$line"
}

expect() {
    if grep -qxF -e "$1" "$readme"; then
        passed=$((passed + 1))
    else
        echo "README.md should say: $1"
        failed=$((failed + 1))
    fi
}

row "add a position" add_position
row "18 positions and the solve" 18_positions_and_solve
row "the same with every σ and the verdict" 18_positions_and_everything
row "apply a calibration to a sample" apply
row "feed a sample at rest, 1 kHz" feed_1000_Hz
row "where to turn next" next_orientation
row "a sample of one axis into \`allan.h\`" allan_push
row "36 positions at two temperatures, everything" 36_positions_thermal
row "the calibration at a temperature" thermal_at
row "flash, the core" text.core
row "flash, everything" text.everything
row "stack, \`invcal_solve\`" invcal_solve
row "stack, \`invcal_session_feed\`" invcal_session_feed
expect "| invcal, the core | 9 | $(figure m4f 18_positions_and_solve) | $(figure m4f text.core) | $(figure m4f memory.core) | 0 |"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
