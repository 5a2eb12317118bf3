#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/packages.sh BUILD [NAME...]
# Consumes the packages as their users do: each script of tests/packages, or those named. Each prints
# a line for each check; what was missing is one line and a failure. At the end `N passed, N failed`.
build=$1
shift
cd "$(dirname "$0")/.." || exit 1
if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046 # names without blanks
    set -- $(cd tests/packages && printf '%s\n' *.sh | sed 's/\.sh$//')
fi

for name; do
    if [ ! -f "tests/packages/$name.sh" ]; then
        echo "$name: there is no tests/packages/$name.sh: FAIL"
        echo "0 passed, 1 failed"
        continue
    fi
    log=$(sh "tests/packages/$name.sh" "$build" 2>&1)
    printf '%s\n' "$log"
    # One that does not tell its result has crashed.
    printf '%s\n' "$log" | tail -n 1 | grep -Eqx '[0-9]+ passed, [0-9]+ failed' ||
        echo "0 passed, 1 failed"
done | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next } { print }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
