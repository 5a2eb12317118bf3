#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/coverage.sh BUILD [src|host]
# What the tests reach, by clang's source-based coverage: lines, branches and MC/DC of src/ by the
# unit tests, in float and double and for each degree of thermal.h, and lines of port/host by the
# scripts of tests/tool; or one of the two. Gaps in src/ are listed by file and line unless they are
# explained there (see coverage.awk). Unit tests that fail are listed, too; scripts of the tool may
# fail, as they notice the files of its counts. Ends with `N passed, N failed`.
# INVCAL_ASSERT compiles to nothing, as it does by default.
cd "$(dirname "$0")/.." || exit 1
case $2 in '' | src | host) ;; *)
    echo "PART is src or host, not '$2'" >&2
    exit 1
    ;;
esac
rm -rf "$1/coverage"
mkdir -p "$1/coverage" || exit 1
out=$(cd "$1/coverage" && pwd)

# For the scripts of the tool as well, so that what they make is not built again.
export CC="${CLANG:-clang-19}" CFLAGS='-O1 -fprofile-instr-generate -fcoverage-mapping' DEGREE=1

# build FLAGS DEGREE TARGET ...: in a folder of that degree of thermal.h
build() {
    flags="$CFLAGS $1"
    folder=$out/$2
    degree=$2
    shift 2
    # shellcheck disable=SC2046 # names without blanks
    make -s -j2 LONG=1 BUILD="$folder" DEGREE="$degree" CC="$CC" CFLAGS="$flags" $(printf "$folder/%s " "$@") \
        >> "$out/build.log" 2>&1 || { cat "$out/build.log"; return 1; }
}

# Runs lines `NAME COMMAND ...`, two at a time. Their counts go to NAME.*.profraw, failures to the file failed.
run() {
    # shellcheck disable=SC2016 # for the shell inside
    OUT=$out xargs -P 2 -L 1 sh -c 'LLVM_PROFILE_FILE=$OUT/$0.%m.profraw "$@" > "$OUT/$0.log" 2>&1 ||
        echo "$0 fails, see $OUT/$0.log" >> "$OUT/failed"'
}

# show NAME SOURCES PROGRAM ...: makes NAME.show of NAME-*.profraw
show() {
    name=$1
    sources=$2
    shift 2
    # shellcheck disable=SC2046 # names without blanks
    llvm-profdata-19 merge -o "$out/$name.profdata" "$out/$name"-*.profraw &&
        llvm-cov-19 show -show-branches=count -show-mcdc -show-instantiations=false \
            -instr-profile="$out/$name.profdata" $(printf -- '-object %s ' "$@") \
            -sources "$sources" > "$out/$name.show"
}

# in_float_and_double DEGREE SUITE ...
in_float_and_double() {
    degree=$1
    shift
    # shellcheck disable=SC2046 # names without blanks
    build "-fcoverage-mcdc '-DINVCAL_ASSERT(condition)=((void)0)'" "$degree" $(printf 'float/%s ' "$@") $(printf 'double/%s ' "$@") || return
    for suite; do
        for real in float double; do
            echo "src-$degree$real-$suite $out/$degree/$real/$suite"
        done
    done | run
    for real in float double; do
        # shellcheck disable=SC2046 # names without blanks
        show "src-$degree$real" src $(printf "$out/$degree/$real/%s " "$@") || return
    done
}

measure_src() {
    # shellcheck disable=SC2046 # names without blanks
    in_float_and_double 1 $(basename -s .c tests/unit/test_*.c) &&
        in_float_and_double 0 test_thermal && in_float_and_double 2 test_thermal
}

measure_host() {
    build '' 1 invcal || return
    for script in tests/tool/*_test.sh; do
        echo "host-$(basename "$script" .sh) sh $script $out/1/invcal $out/1/tool"
    done | run
    show host port/host "$out/1/invcal"
}

for part in ${2:-src host}; do
    if ! "measure_$part"; then
        echo "coverage: $part cannot be measured: FAIL"
        echo "0 passed, 1 failed"
        continue
    fi
    unmeasured=$(grep -c "^$part/.*unsupported MC/DC" "$out/build.log")
    touch "$out/failed"
    grep '^src-' "$out/failed"
    awk -v part="$part" -v unmeasured="$unmeasured" -v failing="$(grep -c '^src-' "$out/failed")" -f tests/coverage.awk "$out/$part"*.show
done | awk '/^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; next }
    { print }
    END { print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 || passed == 0 }'
