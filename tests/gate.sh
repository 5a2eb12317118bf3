#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/gate.sh 'NAME [WORD...]' COMMAND...
# Runs a gate, which ends with `N passed, N failed`. It fails, too, if it makes fewer checks than tests/floors.txt
# states for this name in this mode: see floor.sh.
key="$1 ${BRIEF:+brief}"
shift
{ "$@"; echo "gate.sh: status $?"; } | awk -v floor="sh $(dirname "$0")/floor.sh" -v key="$key" '
    /^gate\.sh: status [0-9]+$/ { status = $3; next }
    { print }
    /^[0-9]+ passed, [0-9]+ failed$/ { passed = $1; failed = $3; counted = 1 }
    END {
        if (counted && !failed && system(floor " " passed " " key)) {
            failed = 1
            print passed " passed, 1 failed"
        }
        exit !counted || failed > 0 || status > 0
    }'
