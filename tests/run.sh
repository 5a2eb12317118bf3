#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs every test in the build folder $1, and the scripts next to this file, two at a time. Prints a
# line for each suite, below it what failed and where its log is, and at the end `N passed, N failed`.
# CC, CFLAGS and UNITY are passed on to scripts that compile something. ONLY='rests|tool': only suites whose names match.
# PART=src: the unit tests of the library, of the TYPES 'float double' or one of them; PART=host: everything else.
# LONG=1: with the tests that take long. LONG=only: the same, without what LONG does not change.
# A suite with fewer checks than floors.txt states has failed, see floor.sh; unless it says what is not tried here.
build=$1
tests=$(dirname "$0")
logs=$build/run
rm -rf "$logs"
mkdir -p "$logs" || exit 2

# The scripts compute in awk; that of Debian's busybox cannot.
[ "$PART" = src ] || awk 'BEGIN { exit sqrt(4) != 2 }' 2> /dev/null || {
    echo "awk has no mathematics, which POSIX requires: install mawk or gawk, or run make test PART=src" >&2
    exit 2
}

# NAME COMMAND...; the longest first.
suites() {
    case $PART in
    src) programs $TYPES ;;
    host) scripts; [ "$LONG" = only ] || programs tool; other_scripts ;;
    *) scripts; programs $TYPES tool; other_scripts ;;
    esac
}

programs() { # FOLDER...
    for folder; do
        for program in "$build/$folder"/test_*; do
            [ -x "$program" ] && echo "$folder-${program##*/test_} $program"
        done
    done
}

scripts() {
    short='tool thermal stand case magnetometer log watch units sensor input reading citizen record compare export gyro
        fault pass refusal six_faces release'
    [ "$LONG" = only ] && short='gyro log magnetometer' # they take longer then
    for name in ${LONG:+faults allan plan plan_moves width plan_report report screen verdict} $short; do
        echo "$name sh $tests/tool/${name}_test.sh $build/invcal $build/tool"
    done
}

other_scripts() {
    if [ "$LONG" ]; then
        echo "unity sh $tests/unity/selftest.sh $build/unity"
        for page in tutorial magnetometer porting drone inclinometer production mathematics_judgement mathematics_imu; do
            echo "page-$page sh $tests/tutorial.sh $build $page"
        done
    fi
    [ "$LONG" = only ] && return
    echo "run sh $tests/run_test.sh $build/run_test"
    echo "library sh $tests/library.sh $build"
    echo "readme sh $tests/readme.sh $build"
    echo "make sh $tests/make.sh $build/make"
    echo "errors sh $tests/errors.sh $build"
}

# (Not with `&`, whose jobs ignore SIGINT.)
suites | awk -v only="$ONLY" '$1 ~ only' > "$logs/list"
if [ ! -s "$logs/list" ]; then
    echo "ONLY='$ONLY': no suite has such a name" >&2
    exit 2
fi
# shellcheck disable=SC2016 # $log and the like belong to the inner shell
xargs -L 1 -P 2 sh -c 'log=$1/$2.log; shift 2
    "$@" > "$log" 2>&1 < /dev/null
    echo "exit status $?" >> "$log"' suite "$logs" < "$logs/list"

# From a log: each line that says FAIL, preceded by the first lines since the previous check, and what
# follows the last check; no more than a screen or two.
failures() { # LOG
    awk '
        function say(line) {
            if (length(line) > 400) line = substr(line, 1, 400) " ..."
            if (++lines <= 40) print line
        }
        function why(    i) {
            for (i = 1; i <= said && i <= 10; i++) say(since[i])
            if (said > 10) say("    ... " said - 10 " lines more")
            said = 0
        }
        /: ?PASS$/ { said = 0; next }
        /: ?FAIL(:|$)/ { why(); say($0); next }
        / Tests .* Failures .* Ignored/ || /^[0-9]+ passed, [0-9]+ failed$/ {
            if (!/ 0 (Failures|failed)/) summed = 1
            next
        }
        /^(-*|OK|FAIL)$/ { next }
        /^exit status/ { status = $0; next }
        { since[++said] = $0 }
        END {
            why()
            if (!summed) say(status)
            if (lines > 40) print "    ... " lines - 40 " lines more"
        }' "$1"
}

floor() { # SUITE COUNT
    case $1 in
    float-*) set -- "$2" "unit-${1#*-}" ;;
    double-*) set -- "$2" "unit-${1#*-}" double ;;
    *) set -- "$2" "$1" ;;
    esac
    sh "$tests/floor.sh" "$@" ${LONG:+long} ${BRIEF:+brief} ${DEGREE:+"degree$DEGREE"}
}

# A suite gives its result as "N Tests F Failures I Ignored" (Unity) or "N passed, N failed".
# One that gives neither has crashed, and one that ran no test shows nothing: one failure each.
while read -r name _; do
    log=$logs/$name.log
    : >> "$log" # in case it was not run
    result=$(awk '
        / Tests .* Failures .* Ignored/ { p = $1 - $3 - $5; f = $3 }
        /^[0-9]+ passed, [0-9]+ failed$/ { p = $1; f = $3 }
        /^exit status / { status = $3 }
        END { if (p + f == 0 || (status && !f)) f++; print p + 0, f + 0 }' "$log")
    passed=${result% *} failed=${result#* } said=
    if [ "$failed" -gt 0 ]; then
        said=$(failures "$log")
    elif [ "$FLOORS" = exact ] || ! grep -q ' not tried: ' "$log"; then
        said=$(floor "$name" "$passed") || failed=1
    fi
    echo "$name: $passed passed, $failed failed"
    [ -z "$said" ] || printf '%s\n' "$said"
    [ "$failed" -eq 0 ] || echo "    all of it: $log"
done < "$logs/list" | awk '{ print }
    /^[a-z0-9_-]+: [0-9]+ passed, [0-9]+ failed$/ { passed += $2; failed += $4 }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
