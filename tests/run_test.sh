#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/run_test.sh FOLDER
# tests/run.sh prints what failed, not all output. Makes suites in FOLDER that fail in one way each,
# and runs them.
here=$(dirname "$0")
out=$1
passed=0
failed=0
rm -rf "$out"
mkdir -p "$out/double" || exit 2

check() { # SENTENCE COMMAND...
    sentence=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "run: $sentence: PASS"
    else
        failed=$((failed + 1))
        cat "$out/said"
        echo "run: $sentence: FAIL"
    fi
}

suite() { # NAME, its script on stdin
    { echo '#!/bin/sh'; cat; } > "$out/double/test_$1"
    chmod +x "$out/double/test_$1"
}
runs() { # NAME: runs only that suite; what it prints goes to $out/said
    PART='' TYPES=double ONLY="^double-$1\$" sh "$here/run.sh" "$out" > "$out/said" 2>&1
}
says() { grep -Fqx -- "$1" "$out/said"; }
lines() { [ "$(wc -l < "$out/said")" -eq "$1" ]; }

suite good << 'END'
echo 'good: one: PASS'
echo '1 passed, 0 failed'
END
check "a suite that passes" runs good
check "it takes a line, and one for the sum" lines 2

suite one << 'END'
awk 'BEGIN { for (i = 1; i <= 3000; i++) print "one: " i ": PASS" }'
echo 'because'
echo 'one: this: FAIL'
echo 'one: that: PASS'
echo '3001 passed, 1 failed'
exit 1
END
! runs one
check "one check of many fails: so does the suite" [ $? -eq 0 ]
check "its result is printed" says 'double-one: 3001 passed, 1 failed'
check "the check is printed" says 'one: this: FAIL'
check "and why" says because
check "and where the rest is" says "    all of it: $out/run/double-one.log"
check "and no more" lines 5

suite unity << 'END'
echo 'test_unity.c:5:one:PASS'
echo 'test_unity.c:9:two:FAIL: Expected 1 Was 2'
echo
echo '-----------------------'
echo '2 Tests 1 Failures 0 Ignored'
echo FAIL
exit 1
END
! runs unity
check "a suite of Unity fails" [ $? -eq 0 ]
check "Unity: the check is printed" says 'test_unity.c:9:two:FAIL: Expected 1 Was 2'
check "Unity: and no more" lines 4

suite all << 'END'
awk 'BEGIN { for (i = 1; i <= 500; i++) print "all: " i ": FAIL" }'
echo '0 passed, 500 failed'
exit 1
END
! runs all
check "every check fails" [ $? -eq 0 ]
check "the first are printed" says 'all: 40: FAIL'
check "of the others, how many" says '    ... 460 lines more'
check "no more than a screen or two" lines 44

suite crash << 'END'
echo 'crash: one: PASS'
awk 'BEGIN { for (i = 1; i <= 100; i++) print "trace " i }'
kill -s SEGV $$
END
! runs crash
check "a suite that crashes has failed" [ $? -eq 0 ]
check "its first lines are printed" says 'trace 1'
# (The shell adds a line about the crash.)
check "but not all" grep -qx '    \.\.\. 9[01] lines more' "$out/said"
check "and how it ended" grep -q '^exit status 1[0-9][0-9]$' "$out/said"

suite leak << 'END'
printf '%s\n' '1 Tests 0 Failures 0 Ignored' OK 'ERROR: detected memory leaks'
exit 23
END
! runs leak
check "what ends badly after its last check has failed" [ $? -eq 0 ]
check "what it said is printed" says 'ERROR: detected memory leaks'
check "and how it ended" says 'exit status 23'

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
