#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/first.sh BUILD [GOAL...], as root
# The first impression: on a new Debian with a C compiler and make, and nothing else, `make demo` and
# `make test` work; every other target of `make help` either works, too, or says in one line for each
# thing that is missing what to install. The locale is POSIX, as on such a machine, and the path of the
# sources contains a blank and characters that are special to a shell. The machine is a folder,
# BUILD/first/root, which debootstrap makes in two minutes, and which is kept. The rest takes three
# minutes. Prints a line for each target, and at the end `N passed, N failed`. With GOALs, only those.
mkdir -p "$1/first" || exit 2
out=$(cd "$1/first" && pwd)
shift
cd "$(dirname "$0")/.." || exit 1
machine=$out/root
place="my own/it's \$HOME & (new)/invcal"
passed=0
failed=0

fail() {
    echo "first.sh: $1" >&2
    exit 1
}

result() { # 0 or 1, SENTENCE
    if [ "$1" -eq 0 ]; then
        echo "first: $2: PASS"
        passed=$((passed + 1))
    else
        cat "$out/log"
        echo "first: $2: FAIL"
        failed=$((failed + 1))
    fi
}

on_machine() { # GOAL...: make, there
    chroot "$machine" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
        make -C "/$place" "$@" > "$out/log" 2>&1 < /dev/null
}

# Besides make's own lines, what passes and the sum, it says only what is missing.
names_missing() {
    grep -vE '^make(\[[0-9]+\])?: |: PASS$|^[0-9]+ passed, [0-9]+ failed$' "$out/log" > "$out/said"
    grep -q . "$out/said" && ! grep -vE ' is not installed: make deps\b' "$out/said"
}

[ "$(id -u)" -eq 0 ] || fail "only root can make a machine: run it as root"
command -v debootstrap > /dev/null || fail "debootstrap is not installed: make deps"
if [ ! -e "$out/made" ]; then
    rm -rf "$machine"
    debootstrap --variant=minbase --include=gcc,make,libc6-dev bookworm "$machine" > "$out/log" 2>&1 ||
        fail "debootstrap failed: $(tail -n 1 "$out/log")"
    touch "$out/made"
fi
rm -rf "${machine:?}/${place%%/*}"
mkdir -p "$machine/$place"
# The build folder stays here, with the machine in it.
tar -cf - --exclude="./$(basename "${out%/first}")" . | tar -xf - -C "$machine/$place" ||
    fail "the sources cannot be copied"

# The demonstration first, before anything is built.
# shellcheck disable=SC2046 # names without blanks
[ $# -gt 0 ] || set -- demo $(awk -F ':.*## ' '/^[a-z-]+:.*## / && $1 != "demo" { print $1 }' Makefile)
for goal; do
    case $goal in
    demo)
        start=$(date +%s)
        on_machine demo && grep -q '^Good: ' "$out/log"
        result $? "make demo calls the demonstration good"
        seconds=$(($(date +%s) - start))
        [ "$seconds" -lt 60 ]
        result $? "make demo takes less than a minute: $seconds s"
        ;;
    test)
        on_machine test && tail -n 2 "$out/log" | grep -q ' passed, 0 failed$'
        result $? "make test: $(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$out/log" | tail -n 1)"
        ;;
    deps) ;; # would need a network
    package)
        on_machine package PACKAGE=amalgamation
        result $? "make package works"
        ;;
    *)
        if on_machine "$goal"; then
            result 0 "make $goal works"
        else
            names_missing
            result $? "make $goal: $(sort -u "$out/said" | head -n 1)"
        fi
        ;;
    esac
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
