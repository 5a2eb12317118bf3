#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/run_test.sh FOLDER
# tests/run.sh prints what failed, not all output; and it notices checks that are missing. Makes suites in FOLDER that
# fail in one way each, and runs them.
here=$(dirname "$0")
out=$1
passed=0
failed=0
rm -rf "$out"
mkdir -p "$out/double" "$out/tests" && cp "$here/run.sh" "$here/floor.sh" "$here/gate.sh" "$out/tests" || exit 2
unset FLOORS LONG BRIEF DEGREE

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
    PART='' TYPES=double ONLY="^double-$1\$" sh "$out/tests/run.sh" "$out" > "$out/said" 2>&1
}
says() { grep -Fqx -- "$1" "$out/said"; }
states() { printf '%s\n' "$@" > "$out/tests/floors.txt"; } # LINE...
lines() { [ "$(wc -l < "$out/said")" -eq "$1" ]; }

suite good << 'END'
echo 'good: one: PASS'
echo '1 passed, 0 failed'
END
states 'unit-good 1'
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

# ---- checks that are missing -------------------------------------------------------------------

floor() { FLOORS=$1 sh "$out/tests/floor.sh" "$2" $3 > "$out/said"; } # FLOORS COUNT 'NAME WORD...'
states 'unit-good 2'
! runs good
check "a suite with fewer checks than stated fails" [ $? -eq 0 ]
check "fewer: its result is printed" says 'double-good: 1 passed, 1 failed'
check "fewer: and why" grep -q '^unit-good double: 1 checks, but tests/floors.txt says 2; .*: FAIL$' "$out/said"
check "fewer: and no more" lines 4
states 'unit-goods 1'
! runs good
check "a suite of which nothing is stated fails" [ $? -eq 0 ]
check "nothing stated: it says so" grep -q '^unit-good double: 1 checks, .* says nothing' "$out/said"
states 'unit-good 0'
check "a suite with more checks than stated passes" runs good
check "more: it says so" grep -q '^unit-good double: 1 checks, but tests/floors.txt says 0' "$out/said"
! floor exact 1 unit-good
check "more: with FLOORS=exact it fails" [ $? -eq 0 ]
states 'unit-good 0+'
check "more than a least number is as stated" floor exact 1 unit-good
check "least: it says nothing" lines 0
states 'unit-good 2' 'unit-good double 1' 'unit-good double long 3' 'unit-good long 4'
check "a mode has its own line" runs good
check "another mode has another" floor exact 4 'unit-good long'
check "of two lines the one with more words counts" floor exact 3 'unit-good double long'
check "words that no line has do not matter" floor exact 4 'unit-good long brief degree2'

suite ignored << 'END'
echo '2 Tests 0 Failures 1 Ignored'
END
states 'unit-ignored 2'
! runs ignored
check "a test that is ignored is no check" [ $? -eq 0 ]

suite untried << 'END'
echo 'the rest is not tried: there is no tool for it'
echo '1 passed, 0 failed'
END
states 'unit-untried 2'
check "a suite that says what it cannot try here may have fewer" runs untried
export FLOORS=exact
! runs untried
check "but not with FLOORS=exact" [ $? -eq 0 ]
unset FLOORS

updates() { # SENTENCE COUNT 'NAME WORD...' LINE...
    sentence_of=$1
    floor update "$2" "$3"
    shift 3
    printf '%s\n' "$@" > "$out/wanted"
    check "FLOORS=update: $sentence_of" cmp "$out/wanted" "$out/tests/floors.txt"
}
states '# COMMENT' 'b 7' 'a 1' 'c 4+'
updates "a number is replaced" 8 b '# COMMENT' 'a 1' 'b 8' 'c 4+'
updates "a least number remains one" 5 c '# COMMENT' 'a 1' 'b 8' 'c 5+'
updates "a mode without a difference has no line" 1 'a long' '# COMMENT' 'a 1' 'b 8' 'c 5+'
updates "a mode that differs gets one" 2 'a long' '# COMMENT' 'a 1' 'a long 2' 'b 8' 'c 5+'
updates "and loses it" 1 'a long' '# COMMENT' 'a 1' 'b 8' 'c 5+'
updates "the first line is for all modes" 9+ 'd long' '# COMMENT' 'a 1' 'b 8' 'c 5+' 'd 9+'

gate() { sh "$out/tests/gate.sh" 'a long' sh -c "$1" > "$out/said" 2>&1; }
states 'a 1' 'a long 2'
check "a gate with as many checks as stated passes" gate 'echo one: PASS; echo 2 passed, 0 failed'
check "gate: what it says is printed" says 'one: PASS'
check "gate: and its result" says '2 passed, 0 failed'
! gate 'echo 1 passed, 0 failed'
check "a gate with fewer checks fails" [ $? -eq 0 ]
check "gate: that is counted" says '1 passed, 1 failed'
! gate 'echo 2 passed, 0 failed; exit 3'
check "a gate that ends badly has failed" [ $? -eq 0 ]
! gate 'echo python3 is not installed'
check "a gate that does not count has failed" [ $? -eq 0 ]
check "gate: and only says why" lines 1

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
