#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Compares a Unity implementation with the outputs in golden/. Needs a C compiler, diff and grep.
#
#     [CC=cc] [CFLAGS=-std=c99] [UNITY=dir] [LDLIBS=-lm] [EXEC=emulator] ./selftest.sh builddir
#
# UNITY holds unity.h and unity.c; the default is this script's own folder. For another
# implementation, only the recorded outputs of the original are compared. Prints one line per check
# and a count; exits with 1 if any check failed, with 2 if it was called wrongly.
# CFLAGS must not configure Unity: the checks do that.
set -u
unset CDPATH

CC=${CC:-cc}
CFLAGS=${CFLAGS:--std=c99}
LDLIBS=${LDLIBS:--lm}
EXEC=${EXEC:-}
WARNINGS='-Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -pedantic -Werror'

if [ $# -ne 1 ]; then
    echo "usage: [CC=...] [CFLAGS=...] [UNITY=dir] $0 builddir" >&2
    exit 2
fi
here=$(cd -- "$(dirname -- "$0")" && pwd) || exit 2
unity=$(cd -- "${UNITY:-$here}" && pwd) || exit 2
mkdir -p -- "$1" && build=$(cd -- "$1" && pwd) || exit 2
cd -- "$here/golden" || exit 2 # the outputs contain file names as passed to the compiler

own=no
grep -q UNITY_STRICT "$unity/unity.c" && own=yes
[ "$own" = yes ] || CFLAGS="$CFLAGS -w" # warnings in another implementation do not matter here

passed=0
failed=0

# check LABEL COMMAND...
check() {
    label=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "unity: $label: PASS"
    else
        failed=$((failed + 1))
        echo "unity: $label: FAIL"
    fi
}

# run SOURCE [FLAG...]: builds and runs a program; its output goes to $build/out.txt. Ignores the
# program's exit status, its number of failures; a crash shows in the output.
run() {
    source=$1
    shift
    rm -f -- "$build/program" "$build/out.txt"
    # CC, CFLAGS, LDLIBS and EXEC are lists of words
    # shellcheck disable=SC2086
    $CC $CFLAGS "$@" -I"$unity" "$source" "$unity/unity.c" $LDLIBS -o "$build/program" || return 1
    # shellcheck disable=SC2086
    $EXEC "$build/program" >"$build/out.txt"
    return 0
}

# same GOLDEN SOURCE [FLAG...]: the output must be the golden one.
same() {
    golden=$1
    shift
    run "$@" && diff "$golden" "$build/out.txt"
}

# Everything compiles with many warnings on, including the macros in the tests. (Nothing is linked.)
no_warnings() {
    for flags in '' -DUNITY_STRICT -DUNITY_INCLUDE_DOUBLE -DUNITY_EXCLUDE_FLOAT \
        -DUNITY_EXCLUDE_SETJMP_H; do
        for source in "$unity/unity.c" probe.c extra.c strict.c; do
            # shellcheck disable=SC2086
            $CC $CFLAGS $WARNINGS $flags -I"$unity" -c "$source" -o "$build/out.o" || return 1
        done
    done
}

# Each float assertion of the probe must fail at run time, and say why.
no_float() {
    run probe.c -DUNITY_EXCLUDE_FLOAT || return 1
    for type in FLOAT:Floating DOUBLE:Double; do
        asserts=$(grep -c "(void) {.*${type%:*}.*(" probe.c)
        refusals=$(grep -c "FAIL:Unity ${type#*:} .* Disabled\$" "$build/out.txt")
        [ "$asserts" -gt 0 ] && [ "$asserts" -eq "$refusals" ] || return 1
    done
}

# The configured sink gets all characters, START and COMPLETE once per suite.
own_output() {
    mkdir -p -- "$build/config" || return 1
    cat >"$build/config/unity_config.h" <<'END'
int sink(int c);
#define UNITY_OUTPUT_CHAR(c)    (void)sink(c)
#define UNITY_OUTPUT_START()    (void)sink('<')
#define UNITY_OUTPUT_COMPLETE() (void)sink('>')
END
    printf '#include <stdio.h>\nint sink(int c);\nint sink(int c) { return putchar(c); }\n' \
        >"$build/config/sink.c"
    run flow.c -DUNITY_INCLUDE_CONFIG_H -I"$build/config" "$build/config/sink.c" || return 1
    [ "$(tr -cd '<>' <"$build/out.txt")" = '<><>' ] || return 1
    tr -d '<>' <"$build/out.txt" | diff golden-flow.txt -
}

check 'probe float' same golden-float.txt probe.c
check 'probe double' same golden-double.txt probe.c -DUNITY_INCLUDE_DOUBLE
check 'flow' same golden-flow.txt flow.c
if [ "$own" = yes ]; then
    check 'flow without setjmp' same golden-flow-nosetjmp.txt flow.c -DUNITY_EXCLUDE_SETJMP_H
    check 'flow into own output' own_output
    check 'extra float' same golden-extra-float.txt extra.c
    check 'extra double' same golden-extra-double.txt extra.c -DUNITY_INCLUDE_DOUBLE
    check 'strict' same golden-strict.txt strict.c -DUNITY_STRICT
    check 'strict without setjmp' same golden-strict.txt strict.c -DUNITY_STRICT \
        -DUNITY_EXCLUDE_SETJMP_H
    check 'probe without float' no_float
    printf 'int main(void) { return 0; }\n' >"$build/empty.c"
    # Only with a compiler that knows these options.
    # shellcheck disable=SC2086
    if $CC $CFLAGS $WARNINGS -c "$build/empty.c" -o "$build/out.o" 2>/dev/null; then
        check 'no warnings' no_warnings
    fi
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
