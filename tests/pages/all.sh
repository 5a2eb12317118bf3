#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/pages/all.sh BUILD: checks the pages of BUILD/pages.list, with two browsers at a time.
here=$(dirname "$0")

{
    tr '\n' '\0' < "$1/pages.list" | xargs -0 -P 2 -n 8 sh "$here/../pages.sh" "$1" ||
        echo 'pages: not all of them: FAIL'
} | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next }
    { print } /: not all of them: FAIL$/ && !failed { failed++ }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
