#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/packages.sh BUILD [NAME...]
# Uses the packages as their users would: each script of tests/packages, or those named, two at a
# time. Each prints a line for each check; a missing tool is one line and a failure. At the end
# `N passed, N failed`.
build=$1
shift
cd "$(dirname "$0")/.." || exit 1
if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046 # names without blanks
    set -- $(cd tests/packages && printf '%s\n' *.sh | sed 's/\.sh$//')
fi

logs=$build/check-packages
rm -rf "$logs"
mkdir -p "$logs" || exit 1
# shellcheck disable=SC2016 # $1 and the like belong to the inner shell
printf '%s\n' "$@" | xargs -P 2 -n 1 sh -c '
    if [ -f "tests/packages/$3.sh" ]; then
        sh "tests/packages/$3.sh" "$1" > "$2/$3.log" 2>&1 < /dev/null
    else
        echo "$3: there is no tests/packages/$3.sh: FAIL" > "$2/$3.log"
    fi' package "$build" "$logs"

for name; do
    cat "$logs/$name.log"
    # One that gives no result has crashed.
    if counts=$(tail -n 1 "$logs/$name.log" | grep -Ex '[0-9]+ passed, [0-9]+ failed'); then
        case $counts in *' 0 failed')
            sh tests/floor.sh "${counts%% *}" "package-$name" ${BRIEF:+brief} ${FULL:+full} || echo "0 passed, 1 failed"
            ;;
        esac
    else
        echo "0 passed, 1 failed"
    fi
done | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next } { print }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
