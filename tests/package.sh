# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034
#
# For the scripts of tests/packages, which are called as `sh tests/packages/NAME.sh BUILD`:
#
#     . "$(dirname "$0")/../package.sh"
#     need cmake
#     check "a sentence" a_function_or_command with arguments
#     finish
#
# Sets root, build (with build/float, build/double) and out, an empty folder of the script's own; all
# three are absolute. The script runs in root, and make takes $below for BUILD: its rules cannot have blanks.

unset MAKEFLAGS # a CC=... meant for the host would be taken for every target
name=$(basename "$0" .sh)
mkdir -p "$1/consumed" || exit 1
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
out=$build/consumed/$name
below=${build#"$root"/}
rm -rf "$out"
mkdir -p "$out"
passed=0
failed=0

check() { # SENTENCE COMMAND...: passes if the command succeeds
    sentence=$1
    shift
    if "$@" > "$out/log" 2>&1 < /dev/null; then
        echo "$name: $sentence: PASS"
        passed=$((passed + 1))
    else
        cat "$out/log"
        echo "$name: $sentence: FAIL"
        failed=$((failed + 1))
    fi
}

long() { # the same, but with BRIEF=1 left out
    [ "$BRIEF" ] || check "$@"
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}

need() { # COMMAND...: ends with one line if one is not installed
    for command; do
        if ! command -v "$command" > /dev/null; then
            echo "$name: $command is not installed: make deps: FAIL"
            failed=$((failed + 1))
            finish
        fi
    done
}

# stage PACKAGE: lays it out in $out/PACKAGE.
stage() {
    sh port/stage.sh "$1" "$out/$1"
}

# drops_uncalled PROGRAM [NM]: of a module that the example needs, only what it calls is in it.
drops_uncalled() {
    ${2:-nm} "$1" > "$out/linked" && grep -q ' invcal_apply$' "$out/linked" &&
        ! grep ' invcal_scale$' "$out/linked"
}

# prints_as_expected COMMAND...: it prints what the example, tests/packages/example.c, must print.
example=$root/tests/packages/example.c
prints_as_expected() {
    "$@" > "$out/printed" && diff "$root/tests/packages/expected.txt" "$out/printed"
}
