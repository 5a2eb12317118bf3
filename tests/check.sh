#!/bin/sh
# SPDX-License-Identifier: MIT
#
# `make test` for each compiler and language standard with warnings as errors, and with
# AddressSanitizer, UndefinedBehaviorSanitizer and INVCAL_ASSERT. $1: folder to build in.
# Compilers that are not installed are named and counted as a failure; `make deps` gets them.
out=$1
root=$(dirname "$0")/..
clang=${CLANG:-clang-19}
san='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer'
passed=0
failed=0

run() {
    name=$1 compiler=$2 std=$3 flags=$4 assert=$5
    if ! command -v "$compiler" > /dev/null; then
        echo "check $name: $compiler is not installed: make deps"
        failed=$((failed + 1))
        return
    fi
    if make -s -j2 test BUILD="$out/$name" CC="$compiler" STD="$std" CFLAGS="$flags" ASSERT="$assert" \
        > "$out/$name.log" 2>&1; then
        status=0
    else
        status=1
        cat "$out/$name.log"
    fi
    line=$(tail -n 1 "$out/$name.log")
    echo "check $name: $line"
    counts=$(echo "$line" | awk '/^[0-9]+ passed, [0-9]+ failed$/ { print $1, $3; ok = 1 } END { if (!ok) print 0, 1 }')
    passed=$((passed + ${counts% *}))
    failed=$((failed + ${counts#* }))
    [ $status -eq 0 ] || [ "${counts#* }" -gt 0 ] || failed=$((failed + 1))
}

cd "$root" || exit 1
mkdir -p "$out"
run gcc-c99 gcc c99 "-O2 -Werror"
run gcc-c11 gcc c11 "-O3 -Werror"
run clang-c99 "$clang" c99 "-O2 -Werror"
run clang-c11 "$clang" c11 "-Os -Werror"
run gcc-sanitizers gcc c99 "$san -Werror" 1
run clang-sanitizers "$clang" c11 "$san -Werror" 1

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
