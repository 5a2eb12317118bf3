#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/derived.sh BUILD
# Whatever is derived is up to date: the layout of the sources, expected.h, turns_design.h, releases/values.h, the man
# page, the pictures of the manual. Checks the shell scripts and the English, too, and that the suites of floors.txt
# are there.
# Ends with `N passed, N failed`.
build=$1
cd "$(dirname "$0")/.." || exit 1
passed=0
failed=0
export PYTHONDONTWRITEBYTECODE=1 # leave no files beside the scripts

gate() { # SENTENCE COMMAND...
    sentence=$1
    shift
    if "$@" > "$build/derived.log" 2>&1; then
        echo "$sentence: PASS"
        passed=$((passed + 1))
    else
        cat "$build/derived.log"
        echo "$sentence: FAIL"
        failed=$((failed + 1))
    fi
}

layout() {
    sh tests/sources.sh c | xargs clang-format-19 --dry-run --Werror
}
expected() {
    python3 tests/reference/reference.py tests/data > "$build/expected.h" &&
        diff tests/reference/expected.h "$build/expected.h"
}
turns() {
    python3 tests/reference/turns_design.py > "$build/turns_design.h" &&
        diff tests/reference/turns_design.h "$build/turns_design.h"
}
releases() {
    python3 tests/reference/releases/pack.py | diff tests/reference/releases/0.2.0.txt - &&
        python3 tests/reference/releases/values.py > "$build/values.h" &&
        diff tests/reference/releases/values.h "$build/values.h"
}
magnetometer() { # from a recording that is not part of the project
    python3 tests/reference/magnetometer.py "$recordings/ck_acc_mag.csv" > "$build/magnetometer.h" &&
        diff tests/reference/magnetometer.h "$build/magnetometer.h"
}
logs() { # from such recordings: what the library keeps of them today
    ${CC:-cc} -std=c99 -DINVCAL_DOUBLE=1 -Iinclude -Isrc tests/reference/gyro_logs.c src/*/*.c -lm -o "$build/gyro_logs" &&
        "$build/gyro_logs" "$recordings/xsens_mti_acc.txt" "$recordings/xsens_mti_gyro.txt" \
            "$recordings/mpu9150_0.txt" "$recordings/mpu9150_1.txt" > "$build/gyro_logs.h" &&
        diff tests/unit/gyro_logs.h "$build/gyro_logs.h"
}
samples() { # from all samples of such recordings
    python3 tests/reference/gyro_samples.py "$recordings" > "$build/gyro_samples.h" &&
        diff tests/reference/gyro_samples.h "$build/gyro_samples.h"
}
scripts() {
    sh tests/sources.sh sh | xargs shellcheck -S warning
}
suites() {
    ! sed -n 's|^unit-\([^ ]*\) .*|tests/unit/test_\1.c|p; s|^tool-\([^ ]*\) .*|tests/tool/test_\1.c|p
        s|^package-\([^ ]*\) .*|tests/packages/\1.sh|p; s|^edges-\([^ ]*\) .*|tests/fuzz/\1.c|p' tests/floors.txt |
        while read -r file; do [ -e "$file" ] || echo "there is no $file"; done | grep .
}
plants() {
    DRY=1 sh tests/gates.sh "$build"
}
double() {
    sh port/double.sh | diff include/invcal/double.h - && sh port/double.sh src | diff src/core/names.h -
}
manual() {
    mandoc -Tlint -W warning "$build/invcal.1" &&
        test -z "$(LC_ALL=C.UTF-8 man --warnings -l -Tutf8 "$build/invcal.1" 2>&1 > /dev/null)"
}

# A stray file, made by a mistyped command, would be committed and shipped.
top_level() {
    ! find . -maxdepth 1 ! -name . | sed 's|^./||' | grep -vxE 'Makefile|src|include|tests|port|README.md|LICENSE|CHANGELOG.md|build|\.(git|gitignore|github|ci|clang-format|clang-tidy)'
}

mkdir -p "$build"
gate "the sources are formatted by .clang-format" layout
gate "expected.h is what the reference script prints" expected
gate "turns_design.h is what its script prints" turns
recordings=${RECORDINGS:-../shared/data}
if [ -d "$recordings" ]; then
    gate "magnetometer.h is what its script prints" magnetometer
    gate "gyro_logs.h is what its program prints" logs
    gate "gyro_samples.h is what its script prints" samples
fi
gate "releases' files and values are what their scripts print" releases
gate "the tool writes every key that its last release wrote" python3 tests/reference/releases/tool.py "$build/invcal" --check
gate "nothing else is at the top level" top_level
gate "no suite of tests/floors.txt is gone" suites
gate "the headers are small, and each of their functions has a use" sh tests/headers.sh
gate "double.h has the names that the headers declare" double
gate "migration.md has a row for every function that has changed since 0.2.0" sh tests/migration.sh "$build"
gate "every bug of check-gates can still be planted" plants
gate "shellcheck accepts the shell scripts" scripts
gate "text and comments have no misspelt word, and none of tests/words.txt" sh tests/words.sh
gate "man and mandoc accept the man page" manual
gate "the manual shows the picture that the tool draws" sh tests/picture.sh "$build/invcal" --check
gate "the manual shows the figures that its commands draw" sh tests/figures.sh "$build/invcal" --check

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
