#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/misuse.sh BUILD
# Calls every function of the headers with bad arguments (misuse/misuse.c), in float and in double, under sanitizers if
# the compiler has them. Ends with `N passed, N failed`, a function and number type each.
cd "$(dirname "$0")/.." || exit 1
out=$1/misuse
mkdir -p "$out"
compiler=${CC:-cc}
sanitizers='-fsanitize=address,undefined -fno-sanitize-recover=undefined'
echo 'int main(void) { return 0; }' > "$out/empty.c"
# shellcheck disable=SC2086 # flags are words
"$compiler" $sanitizers "$out/empty.c" -o "$out/empty" 2> /dev/null || sanitizers=

for header in include/invcal/*.h; do
    echo "#include \"${header#include/}\""
done > "$out/headers.h"
awk -f tests/misuse/generate.awk include/invcal/*.h > "$out/functions.h" || exit 1
passed=0
failed=0
for real in 0 1; do
    # shellcheck disable=SC2046,SC2086 # flags and names are words
    "$compiler" -std=c99 -D_POSIX_C_SOURCE=200809L -g -O1 -ffp-contract=off $sanitizers -DINVCAL_DOUBLE=$real \
        -DINVCAL_CONFIG_HEADER='"../tests/misuse/assert.h"' -Iinclude -Isrc -I"$out" tests/misuse/misuse.c \
        $(find src -name '*.c' | sort) -lm -o "$out/misuse$real" || exit 1
    "$out/misuse$real" > "$out/misuse$real.log" 2>&1
    cat "$out/misuse$real.log"
    counts=$(awk '/^[0-9]+ of [0-9]+ functions go wrong$/ { w = $1; n = $3 } END { print n - w, (n > 0 ? w + 0 : 1) }' \
        "$out/misuse$real.log")
    passed=$((passed + ${counts% *}))
    failed=$((failed + ${counts#* }))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
