#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/mutation.sh BUILD SAMPLE SEED [FILE...]
# Do the unit tests notice small changes to the library? Builds them and runs tests/mutation/run.py,
# whose head says the rest. Prints unknown survivors, a table, and at the end `N passed, N failed`.
out=$1/mutation
export CC="${CC:-cc}"
export PYTHONDONTWRITEBYTECODE=1 # leave no files beside the scripts
cd "$(dirname "$0")/.." || exit 1

sample=$2 seed=$3
shift 3
case $sample:$seed in *[!0-9:]* | :* | *:)
    echo "SAMPLE and SEED are numbers, not '$sample' and '$seed'" >&2
    exit 1
    ;;
esac
for file; do
    if [ ! -f "$file" ]; then
        echo "ONLY='$file': there is no such file" >&2
        exit 1
    fi
done

suites() { # BUILD: the suites in it
    for suite in tests/unit/test_*.c; do
        name=$(basename "$suite" .c)
        echo "$1/float/$name $1/double/$name"
    done
}
# For mutants a suite stops at its first failure and tries one case of ten where it tries many, and
# thermal.h has all its degrees.
stop='-O2 -DTEST_SHORT=10 -include stdlib.h
    "-DUNITY_OUTPUT_FLUSH()=if (Unity.CurrentTestFailed) exit(1)"'
# shellcheck disable=SC2046 # names without blanks
make -s -j2 BUILD="$out/whole" LONG=1 $(suites "$out/whole") > /dev/null &&
    make -s -j2 BUILD="$out" DEGREE=2 CFLAGS="$(echo "$stop" | tr '\n' ' ')" $(suites "$out") \
        > /dev/null &&
    exec python3 tests/mutation/run.py "$out" "$sample" "$seed" "$@"
echo '0 passed, 1 failed'
exit 1
