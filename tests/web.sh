#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/web.sh BUILD [PATTERN]: the page in Chromium and Firefox at the same time, and the bits of its numbers.
# At the end `N passed, N failed`. PATTERN: only tests whose names match, or digest. One part: sh tests/web.sh --part NAME
# BUILD PATTERN.

# What the library computes as WebAssembly has the native build's bits (tests/digest).
digest() {
    clang-19 --target=wasm32-wasi -O2 -std=c99 -ffp-contract=off -fno-math-errno -DINVCAL_DOUBLE=0 -Iinclude \
        -Iport -Isrc -Itests/reference -I"$build" src/*/*.c tests/digest/*.c port/hosted/board.c -o "$build/web/digest.wasm" &&
        node --no-warnings tests/web/wasi.mjs "$build/web/digest.wasm" > "$build/web/digest.txt" &&
        "$build/float/digest" | cmp - "$build/web/digest.txt" && tail -n 1 "$build/web/digest.txt"
}

part() {
    case $1 in
    digest)
        if found=$(digest 2>&1); then
            echo "WebAssembly: $found, as natively: ok"
            echo "1 passed, 0 failed"
        else
            echo "WebAssembly: not the native bits: FAIL: $found"
            echo "0 passed, 1 failed"
        fi
        ;;
    *)
        timeout 600 node tests/web/main.mjs "$build" "$1" "$pattern" < /dev/null ||
            echo "$1: not all of them: FAIL"
        ;;
    esac
}

cd "$(dirname "$0")/.." || exit 1
if [ "$1" = --part ]; then
    build=$3 pattern=$4
    part "$2" > "$build/web/$2.log" 2>&1
    exit
fi
build=$1 pattern=$2
parts() {
    printf '%s\n' firefox chromium
    case $pattern in '' | digest) echo digest ;; esac
}
rm -f "$build"/web/*.log
# (Not with `&`, whose jobs ignore SIGINT.)
parts | xargs -P 3 -I '{}' sh tests/web.sh --part '{}' "$build" "$pattern"
parts | while read -r name; do
    cat "$build/web/$name.log" || echo "$name: not all of them: FAIL"
done | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next }
    { print } /: not all of them: FAIL$/ && !failed { failed++ }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
