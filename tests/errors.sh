#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/errors.sh BUILD: port/manual/errors.md has every answer of the library, no others, and the
# library's own words for them. CC and CFLAGS as for the library.
build=$1
cd "$(dirname "$0")/.." || exit 1
page=port/manual/errors.md
out=$build/errors
passed=0
failed=0
mkdir -p "$out"

result() { # 0 or 1, SENTENCE
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
        echo "errors: $2: PASS"
    else
        failed=$((failed + 1))
        echo "errors: $2: FAIL"
    fi
}

# The enumerators of a type, in order; of one with a byte they follow its name.
enumerators() { # HEADER TYPE
    sed 's,/\*.*,,' "include/invcal/$1" | awk -v type="$2" '
        $0 == "typedef uint8_t " type ";" { follow = 1; next }
        /^(typedef )?enum \{/ { names = ""; on = 1; next }
        on && /^\}/ { if (follow || $2 == type ";") printf "%s", names; on = follow = 0 }
        on && match($0, /INVCAL_[A-Z_]+/) {
            name = substr($0, RSTART, RLENGTH)
            if (name !~ /_(COUNT|END)$/) names = names name "\n"
        }'
}

# The page's rows that begin with a name of the list: the name and the next cell.
rows() { # LIST
    awk -F ' *[|] *' 'NR == FNR { known[$1]; next }
        { gsub(/`/, "", $2) }
        $2 in known { print $2 "|" $3 }' "$1" "$page"
}

# A program that prints the names of a list, each with the function's text for it.
program() { # LIST FUNCTION
    printf '#include <stdio.h>\n#include "invcal/thermal.h"\nint main(void)\n{\n'
    sed "s/.*/    printf(\"&|%s\\\\n\", $2(&));/" "$1"
    printf '    return 0;\n}\n'
}

# Each enumerator has one row, in the order of the header; with FUNCTION, its text in the next cell.
type() { # HEADER TYPE [FUNCTION]
    enumerators "$1" "$2" > "$out/$2.names"
    rows "$out/$2.names" > "$out/$2.rows"
    sed 's/|.*//' "$out/$2.rows" > "$out/$2.first"
    [ -s "$out/$2.names" ] && diff "$out/$2.names" "$out/$2.first"
    result $? "every $2 has exactly one row"
    [ -n "$3" ] || return
    program "$out/$2.names" "$3" > "$out/$2.c"
    # shellcheck disable=SC2086 # words
    ${CC:-cc} $CFLAGS -std=c99 -Iinclude "$out/$2.c" "$build/float/libinvcal.a" -lm -o "$out/$2" &&
        "$out/$2" > "$out/$2.said" && diff "$out/$2.said" "$out/$2.rows"
    result $? "$2: the words are those of $3"
}

type status.h invcal_status invcal_status_text
type invcal.h invcal_verdict invcal_verdict_text
type invcal.h invcal_event
type thermal.h invcal_thermal_fallback invcal_thermal_fallback_text
type thermal.h invcal_thermal_place
type allan.h invcal_dwell_end

# A status that nothing gives would only mislead.
while read -r name; do
    grep -rqw "$name" src port/host || echo "$name"
done < "$out/invcal_status.names" > "$out/unused"
! grep . "$out/unused"
result $? "the library or the tool gives every invcal_status"

# Any other name on the page is in a header, and every exit code is on the page.
grep -oE '\b(INVCAL|invcal)_[A-Za-z_]+' "$page" | sort -u > "$out/named"
cat include/invcal/*.h | grep -oE '\b(INVCAL|invcal)_[A-Za-z_]+' | sort -u > "$out/known"
[ -s "$out/named" ] && ! comm -23 "$out/named" "$out/known" | grep .
result $? "every name is in a header"
sed -n 's/^ *EXIT_[A-Z]* = \([0-9]\).*/\1/p' port/host/cli/command.h > "$out/codes"
awk '/^\| exit code/ { on = 1; next } !/^\|/ { on = 0 } on && /^\| [0-9]/ { print $2 }' "$page" |
    diff "$out/codes" -
result $? "every exit code of the tool has its row"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
