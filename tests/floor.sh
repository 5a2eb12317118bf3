#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/floor.sh COUNT NAME [WORD...]
# A suite or gate has made COUNT checks, in the mode that the words name: does floors.txt state as many? Prints a line
# if not. With fewer it has failed, with FLOORS=exact also with more. FLOORS=update: states COUNT. WHAT=edges: what is
# counted, if not checks. A number with a + behind it is the least: more are as stated.
#
# A line of floors.txt is `NAME [WORD...] COUNT`. It holds if all its words are among those given; of several the one
# with the most words does. So a mode has a line of its own only where its count differs.
floors=$(dirname "$0")/floors.txt
count=$1
shift
key=$*

stated() { # FILE
    awk -v name="${key%% *}" -v key=" $key " '
        $1 == name {
            for (i = 2; i < NF; i++) if (!index(key, " " $i " ")) next
            if (NF > most) { most = NF; number = $NF }
        }
        END { print number }' "$1"
}

# Without a line of its own for what the other lines state, too. The first line of a name holds for all its modes.
update() {
    # One at a time; but if another was interrupted, its lock stays.
    for _ in 1 2 3 4 5 6 7 8 9; do
        mkdir "$floors.lock" 2> /dev/null && break
        sleep 1
    done
    own=$(grep -xE "$key [0-9]+[+]?" "$floors")
    case $own in *+) count=${count%+}+ ;; esac
    new=$floors.$$
    grep -vxE "$key [0-9]+[+]?" "$floors" > "$new"
    number=$(stated "$new")
    if [ -z "$own$number" ]; then
        echo "${key%% *} $count" >> "$new"
    elif [ "$number" != "$count" ]; then
        echo "$key $count" >> "$new"
    fi
    { grep '^#' "$new"; grep -v '^#' "$new" | LC_ALL=C sort; } > "$new.sorted"
    rm "$new"
    if cmp -s "$new.sorted" "$floors"; then
        rm "$new.sorted"
    else
        mv "$new.sorted" "$floors"
    fi
    rmdir "$floors.lock"
}

fails=
number=$(stated "$floors")
made=${count%+}
but="$key: $made ${WHAT:-checks}, but tests/floors.txt says"
if [ "$FLOORS" = update ]; then
    update
elif [ -z "$number" ]; then
    echo "$but nothing of it; FLOORS=update states them: FAIL"
    exit 1
elif [ "$made" -lt "${number%+}" ]; then
    echo "$but $number; if none is missing, FLOORS=update states them: FAIL"
    exit 1
elif [ "$made" -gt "${number%+}" ] && [ "${number%+}" = "$number" ]; then
    [ "$FLOORS" = exact ] && fails=': FAIL'
    echo "$but $number; FLOORS=update states them$fails"
    [ -z "$fails" ]
fi
