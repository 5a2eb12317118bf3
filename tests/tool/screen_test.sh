#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of the screen of `watch`, on a terminal of 80 columns and 24 lines that `script` makes:
# screen_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"

escape=$(printf '\033')
bell=$(printf '\a')
home="$escape\[\?25l$escape\[H"

mkdir "$work/bin"
ln -s "$tool" "$work/bin/invcal"
"$tool" simulate --plan edges > "$work/edges.csv"
run watch "$work/edges.csv"
cp "$work/stdout" "$work/plain"
check "no escapes, no bells where there is no terminal" lacks "$work/plain" "$escape|$bell"
check "but the lines" matches "$work/plain" '^next: '

# Everything that a terminal of this size receives is in $work/typed.
size='rows 24 cols 80'
terminal() { # terminal COMMAND: for a shell, in which $tool is invcal
    PATH=$work/bin:$PATH script -qec "stty $size; $1" /dev/null < /dev/null > "$work/typed"
    code=$?
}
# Each frame in a file of its own, lines as they are shown, without escapes.
frames() {
    rm -rf "$work/frames"
    mkdir "$work/frames"
    tr -d '\r' < "$work/typed" | LC_ALL=C awk -v out="$work/frames/" -v escape="$escape" '
        {
            if (split($0, part, escape "\\[\\?25l" escape "\\[H") > 1) {
                if (n) close(file)
                file = sprintf("%s%05d", out, ++n)
                $0 = part[2]
            }
            if (index($0, escape "[?25h")) {
                text = substr($0, index($0, escape "[?25h") + 6)
                sub(/^\a/, "", text)
                file = ""
            }
            gsub(escape "\\[[0-9;?]*[A-Za-z]", "")
            if (file) print > file
        }'
}
count() { grep -ao "$1" "$work/typed" | wc -l; }
# Lines of frames that are wider than that many columns; a byte that continues a character has none.
wider_than() {
    cat "$work/frames"/* | LC_ALL=C awk -v most="$1" '{ gsub(/[\200-\277]/, "") } length($0) > most' | wc -l
}
# After the last frame the cursor is visible and colours are off.
is_restored() {
    [ "$(count "$escape\[?25l")" -gt 0 ] && [ "$(count "$escape\[?25l")" -eq "$(count "$escape\[?25h")" ] &&
        tr -d '\r' < "$work/typed" | LC_ALL=C awk -v escape="$escape" '
            { n = split($0, part, escape "\\[")
              for (i = 2; i <= n; i++) {
                  if (part[i] ~ /^\?25/) cursor = part[i] ~ /^\?25h/
                  if (part[i] ~ /^[0-9;]*m/) plain = part[i] ~ /^0m/
              } }
            END { exit !(cursor && plain) }'
}

# shellcheck disable=SC2016 # for the shell inside
if command -v script > /dev/null && script -qec true /dev/null > /dev/null 2>&1 < /dev/null; then
    TERM=xterm
    export TERM work

    terminal 'invcal simulate --plan edges | invcal watch -'
    frames
    check "it ends well" test "$code" -eq 0
    number=$(find "$work/frames" -type f | wc -l)
    check "it is redrawn nearly ten times per second of the log, of 126 s" test "$number" -gt 1100
    check "and no more than ten times" test "$number" -le 1261
    check "a frame is 22 lines" test "$(wc -l < "$work/frames/00020")" -eq 22
    check "and narrower than the terminal" test "$(wider_than 79)" -eq 0
    check "and as wide as that allows" test "$(wider_than 78)" -gt 0
    check "when it is good, it says that you may stop" grep -q 'Good: you may stop (Ctrl-C)' "$work/frames"/*
    check "but not before the tenth position" test \
        "$(grep -l 'you may stop' "$work/frames"/* | while read -r frame; do
            grep -oE '[0-9]+ positions?$' "$frame"
        done | sort -n | head -n 1 | cut -d ' ' -f 1)" -ge 10
    check "a bell for each position, and one when it is good" test "$(count "$bell")" -eq 19
    check "the terminal is as it was" is_restored
    sed 's/^standard input: //; s/^[^:]*edges.csv: //' "$work/plain" | sed -n '/ 18 positions, field/,$p' > "$work/figures"
    tr -d '\r' < "$work/typed" | sed "s/$escape\[[0-9;]*m//g; s/^standard input: //" | sed -n '/ 18 positions, field/,$p' > "$work/below"
    check "below it is what is printed without it" same "$work/figures" "$work/below"
    check "what was there is scrolled up, not overwritten" test \
        "$(awk '/waiting for samples/ { on = 1; next } index($0, "25l") { exit } on' "$work/typed" | wc -l)" -eq 24

    # The tutorial's picture; with DRAW=1 it is drawn again.
    "$tool" simulate --plan edges --seed 7 > "$work/board.csv"
    terminal 'cd "$work" && invcal watch board.csv'
    if command -v python3 > /dev/null; then
        python3 "$here/screen_svg.py" 'or go on: 57 degrees to go' < "$work/typed" > "$work/watch.svg"
        [ -z "$DRAW" ] || cp "$work/watch.svg" "$here/../../port/host/watch.svg"
        check "the tutorial shows a frame of it" cmp "$work/watch.svg" "$here/../../port/host/watch.svg"
    else
        echo "tool: the tutorial's frame is not tried: python3 is not installed"
    fi

    terminal 'NO_COLOR=1 invcal watch "$work/edges.csv"'
    check "NO_COLOR: no colours" lacks "$work/typed" "$escape\[[0-9;]*m"
    check "NO_COLOR: but there are frames" matches "$work/typed" "$home"
    terminal 'invcal watch "$work/edges.csv" --target 0.00000001,0,0'
    frames
    check "a target that is too far: it does not say that you may stop" lacks "$work/typed" 'you may stop'
    check "a target that is too far: it says so" matches "$work/typed" 'the target is not reached'
    check "a target that is too far: a bell for each position" test "$(count "$bell")" -eq 18
    terminal 'invcal watch "$work/edges.csv" --plan edges --need 0.1 --gravity 9.8'
    check "a need and a program" matches "$work/typed" 'lengths ± '
    check "the program's position is next" matches "$work/typed" 'X next.*position 2 of 18: alpha'
    check "and complete in the end" matches "$work/typed" 'nowhere: the program is complete'

    frames
    # It is carried from each position straight to the next, 17 times, 45 to 90 degrees.
    check "the degrees to go decrease" awk '
        /^TURN IT|^YOU MAY STOP/ { to = $0; sub(/ degrees to go.*/, "", to); sub(/.* /, "", to)
            if (!going) first = to + 0
            last = to + 0; going = 1 }
        /^(HOLD STILL|MOVE ON)/ { if (going) moves++; if (going && first > 40 && first < 95 && last < 24) right++; going = 0 }
        END { exit !(moves == 17 && right == 17) }' "$work/frames"/*

    # The orientations that the device was carried through, in words, from frames that say MOVE ON.
    printf '%s\n' x,y,z 1,0,0 0,-1,0 0,0,1 -1,0,0 0,1,0 0,0,-1 > "$work/faces.csv"
    "$tool" simulate --plan directions:"$work/faces.csv" --zero 33000,32800,32500 > "$work/turned.csv"
    terminal 'invcal watch "$work/turned.csv" --zero 33000,32800,32500'
    frames
    check "the present orientation is the true one" test "+x -y +z -x +y -z " = \
        "$(cat "$work/frames"/* | awk '/^MOVE ON/ { on = 1 } /^@ now/ && on { on = 0; if ($3 != was && $4 == "up" && NF == 4) printf "%s ", was = $3 }')"
    # A rest that drifts cannot be used.
    awk -F, -v OFS=, 'NR > 60 && NR < 500 { $2 += (NR - 60) * 5 } { print }' "$work/edges.csv" > "$work/creep.csv"
    head -n 600 "$work/creep.csv" > "$work/creeps.csv"
    run watch "$work/creeps.csv"
    terminal 'invcal watch "$work/creeps.csv"'
    check "what is refused is reported" matches "$work/typed" 'NOT GOOD.*drifts'
    check "and rings the bell" test "$(count "$bell")" -eq "$(grep -c '^refused:' "$work/stdout")"

    # With a gyroscope it asks for turns, and shows which move does not count.
    "$tool" simulate --gyro --plan edges --dwell 3 | awk -F, -v OFS=, '
        NR > 1 { for (i = 5; i <= 7; i++) $i = $i > 9000 ? 9000 : $i < -9000 ? -9000 : $i } { print }' > "$work/turned.csv"
    terminal 'invcal watch "$work/turned.csv"'
    frames
    check "turns: the next is shown" grep -qE '^X next    edge \+y \+z up: 135 degrees about x$' "$work/frames"/*
    check "turns: the move that does not count is named" grep -qE \
        'Position 5 taken: the move from position 1 to 2 is refused: at the end' "$work/frames"/*
    check "turns: frames are as wide as before" test "$(wider_than 79)" -eq 0

    # Where there is no screen.
    terminal 'invcal watch "$work/edges.csv" --quiet'
    check "--quiet: nothing" is_empty "$work/typed"
    terminal 'invcal watch "$work/edges.csv" --json > "$work/json"'
    check "--json: lines" matches "$work/typed" 'position 18 taken'
    check "--json: no frames" lacks "$work/typed" "$escape\[H|$bell"
    terminal 'TERM=dumb invcal watch "$work/edges.csv"'
    check "a dumb terminal: lines" matches "$work/typed" 'position 18 taken'
    check "a dumb terminal: no frames" lacks "$work/typed" "$escape|$bell"
    for size in 'rows 22 cols 80' 'rows 24 cols 79' 'rows 0 cols 0'; do
        terminal 'invcal watch "$work/edges.csv"'
        check "a terminal of $size: lines" matches "$work/typed" 'position 18 taken'
        check "a terminal of $size: no frames" lacks "$work/typed" "$escape\[H"
    done
    size='rows 24 cols 80'

    # Ctrl-C and SIGTERM end it with the result; a second signal ends it at once.
    mkfifo "$work/port"
    interrupt() { # SIGNAL
        rm -f "$work/pid"
        terminal 'echo $$ > "$work/pid"; exec invcal watch - < "$work/port"' &
        exec 3> "$work/port"
        head -n 11000 "$work/edges.csv" >&3
        eventually grep -aq '15 positions' "$work/typed"
        drawn=0 # until nothing more is drawn: KILL in the middle of a frame would leave half of it
        until [ "$drawn" -eq "$(wc -c < "$work/typed")" ]; do
            drawn=$(wc -c < "$work/typed")
            sleep 0.3
        done
        kill "-$1" "$(cat "$work/pid")"
        wait $!
        exec 3>&-
    }
    for signal in INT TERM; do
        interrupt $signal
        check "$signal: the terminal is as it was" is_restored
        check "$signal: the result is printed" matches "$work/typed" 'Good:'
    done
    interrupt KILL
    check "KILL: even then the terminal is as it was" is_restored

    # A window that is too small says so, and is redrawn when it is large enough.
    rm -f "$work/pid"
    terminal 'echo $$ > "$work/pid"; tty > "$work/tty"; exec invcal watch - < "$work/port"' &
    exec 3> "$work/port"
    head -n 3000 "$work/edges.csv" >&3
    eventually grep -aq '0:2[0-9]' "$work/typed"
    stty -F "$(cat "$work/tty")" rows 10
    sed -n '3001,4000p' "$work/edges.csv" >&3
    eventually grep -aq 'the window is too small' "$work/typed"
    stty -F "$(cat "$work/tty")" rows 30
    sed -n '4001,5000p' "$work/edges.csv" >&3
    eventually grep -aq '0:4[0-9]' "$work/typed"
    exec 3>&-
    wait $!
    check "a window may become too small, and large again" matches "$work/typed" 'ENDED'

    "$tool" simulate --plan edges --rate 1000 > "$work/fast.csv"
    terminal 'timeout 30 invcal watch "$work/fast.csv"'
    check "two minutes at 1 kHz take less than thirty seconds" test "$code" -eq 0
else
    echo "tool: the screen is not tried: script is not installed"
fi

finish
