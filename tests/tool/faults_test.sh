#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of faults that were found and mended: what is written over, numbers out of range, what gets to
# the terminal, logs of great length, and facts of a report that nothing else looks at.
# faults_test.sh path/to/invcal builddir
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
xsens=$data/xsens_mti_positions.csv
"$tool" simulate --plan edges > "$work/log.csv"
"$tool" calibrate "$xsens" --positions --gravity 9.81744 --out "$work/cal.json" > /dev/null
"$tool" simulate --plan faces --dwell 300 --move 1 > "$work/rest.csv"
"$tool" allan "$work/rest.csv" --to 299 --lsb 0.0006 --out "$work/noise.json" > /dev/null
"$tool" plan --csv > "$work/angles.csv"

# ---- what is read is not written over ------------------------------------------------------------

# saves FILE SENTENCE PATTERN ARGUMENTS ...: refused as usage, and the file is as it was.
saves() {
    file=$1 sentence=$2 pattern=$3
    shift 3
    cp "$file" "$work/before"
    refuses "$sentence" 2 "$pattern" "$@"
    check "$sentence: it is as it was" same "$file" "$work/before"
}
l=$work/log.csv c=$work/cal.json n=$work/noise.json a=$work/angles.csv
for o in --out --report; do
    for command in calibrate watch; do
        saves "$l" "$command $o over LOG" "$o: is LOG itself, which would be lost" \
            $command "$l" $o "$l"
        saves "$c" "$command $o over --nominal" "$o: is the file of --nominal, which would be lost" \
            $command "$l" --nominal "$c" $o "$c"
        saves "$a" "$command $o over --plan angles:" "$o: is the file of --plan" \
            $command "$l" --plan "angles:$a" $o "$a"
        saves "$a" "$command $o over --plan directions:" "$o: is the file of --plan" \
            $command "$l" --plan "directions:$a" $o "$a"
        in=$l
        saves "$l" "$command $o over what the standard input comes from" "$o: is LOG itself" \
            $command - $o "$l"
        in=/dev/null
    done
    saves "$n" "watch $o over --allan" "$o: is the file of --allan, which would be lost" \
        watch "$l" --allan "$n" --mean-sigma 0.001 $o "$n"
    saves "$l" "allan $o over LOG" "$o: is LOG itself" allan "$l" $o "$l"
    in=$l
    saves "$l" "allan $o over what the standard input comes from" "$o: is LOG itself" \
        allan - $o "$l"
    in=/dev/null
done
saves "$c" "export --out over CAL.json" '--out: is CAL.json itself' \
    export "$c" --format c --out "$c"
in=$c
saves "$c" "export --out over what the standard input comes from" '--out: is CAL.json itself' \
    export - --format c --out "$c"
in=/dev/null
for o in --svg --report; do
    saves "$a" "plan $o over --angles" "$o: is the file of --angles" plan --angles "$a" $o "$a"
    saves "$a" "plan $o over --directions" "$o: is the file of --directions" \
        plan --directions "$a" $o "$a"
    saves "$n" "plan $o over --allan" "$o: is the file of --allan" \
        plan --allan "$n" --limits 1e-4,1e-4,1e-4 $o "$n"
    for set in "angles:$a faces" "edges directions:$a"; do
        # shellcheck disable=SC2086 # two words
        saves "$a" "plan $o over --compare $set" "$o: is the file of --compare" \
            plan --compare $set $o "$a"
    done
done
saves "$a" "simulate --truth over its directions" '--truth: is the file of --plan' \
    simulate --plan "directions:$a" --truth "$a"
saves "$a" "simulate --truth over its angles" '--truth: is the file of --plan' \
    simulate --plan "angles:$a" --truth "$a"
ln "$l" "$work/hard.csv"
ln -s "$l" "$work/soft.csv"
saves "$l" "a second name of LOG" '--out: is LOG itself' calibrate "$l" --out "$work/hard.csv"
saves "$l" "a link to LOG" '--out: is LOG itself' calibrate "$l" --out "$work/soft.csv"

nothing_new() { [ -z "$(ls -A "$work/out")" ] || { ls -A "$work/out" >&2; return 1; }; }
ln -s out "$work/again"
for command in calibrate watch allan; do
    refuses "$command: one new file for two, by two names" 2 '--report: is the file of --out' \
        $command "$l" --out "$work/out/new" --report "$work/again/../again/new"
done
refuses "plan: one new file for two, by two names" 2 '--report: is the file of --svg' \
    plan --svg "$work/out/new" --report "$work/again/new"
ln -s again/new "$work/leads"
refuses "one new file for two, by a link to it" 2 '--report: is the file of --out' \
    calibrate "$l" --out "$work/out/new" --report "$work/leads"
check "nothing was written" nothing_new
refuses "plan: one standard input for two sets" 2 '--compare: only one input' \
    plan --compare directions:- angles:-
refuses "watch: one standard input for samples and nominal" 2 '--nominal: only one input' \
    watch - --nominal -

# ---- writing ---------------------------------------------------------------------------------------

left() { ls -A "$work/out" | tr '\n' ' '; }
# A run that was killed left a file; the next has the same number, as always in a container.
(cd "$work/out" && sh -c 'echo stale > cal.json.tmp-$$; echo $$ > ../pid
    exec "$0" calibrate "$1" --out cal.json' "$tool" "$l") > "$work/stdout" 2> "$work/stderr"
code=$?
pid=$(cat "$work/pid")
check "what a killed run left does not stand in the way" succeeded
check "it is left alone, and nothing else is left" [ "$(left)" = "cal.json cal.json.tmp-$pid " ]
check "the file is there" is_json "$work/out/cal.json"
check "what is not ours is as it was" [ "$(cat "$work/out/cal.json.tmp-$pid")" = stale ]
rm -f "$work"/out/*
(cd "$work/out" && sh -c 'for n in "" $(seq -f -%g 99); do echo stale > cal.json.tmp-$$$n; done
    exec "$0" calibrate "$1" --out cal.json' "$tool" "$l") > "$work/stdout" 2> "$work/stderr"
code=$?
check "a hundred of them do, and one is named" \
    was_refused 3 'cal\.json: cannot be written: cal\.json\.tmp-[0-9]+-99 stands in the way'
rm -f "$work"/out/*

ln -s out/target.json "$work/link.json"
accepts "a link to a file that is not there yet" calibrate "$l" --out "$work/link.json" --quiet
check "the link is one still" [ -L "$work/link.json" ]
check "its target is made" is_json "$work/out/target.json"
ln -s link.json "$work/link2.json"
rm "$work/out/target.json"
accepts "a link to such a link" calibrate "$l" --out "$work/link2.json" --quiet
check "the target of both is made" is_json "$work/out/target.json"
ln -s loop.json "$work/loop.json"
refuses "a link to itself" 3 'loop\.json: cannot be written: ' calibrate "$l" --out "$work/loop.json"
ln -s nowhere/cal.json "$work/lost.json"
refuses "a link into no folder" 3 'lost\.json: cannot be written: No such file' \
    calibrate "$l" --out "$work/lost.json"
"$tool" calibrate "$l" --quiet --out /dev/stdout > "$work/stdout" 2> "$work/stderr"
check "/dev/stdout, a file" is_json "$work/stdout"
"$tool" calibrate "$l" --quiet --out /dev/stdout 2> "$work/stderr" | cat > "$work/piped"
check "/dev/stdout, a pipe" is_json "$work/piped"
rm -f "$work"/out/*

echo old > "$work/out/cal.json"
chmod 444 "$work/out/cal.json"
# LOG is a pipe that nobody writes into: who reads it first would wait for ever.
mkfifo "$work/never"
for line in "calibrate $work/never --out" "watch $work/never --report" "allan $work/never --out" \
    "export $work/never --format c --out" "plan --svg" "simulate --truth"; do
    # shellcheck disable=SC2086 # words
    run_for() { timeout 10 "$tool" $line "$work/out/cal.json" > "$work/stdout" 2> "$work/stderr"; }
    run_for
    code=$?
    check "what is read-only is refused before any work: ${line%% *}" \
        kept_old 3 'out/cal\.json: is read-only, so nothing is written over it'
done
ln -s out/cal.json "$work/to_old.json"
run calibrate "$l" --out "$work/to_old.json"
check "what is read-only is refused through a link" kept_old 3 'to_old\.json: is read-only'
chmod 644 "$work/out/cal.json"
timeout 10 "$tool" calibrate "$work/never" --out "$work/nowhere/x" > "$work/stdout" 2> "$work/stderr"
code=$?
check "a folder that is not there is told before any work" \
    was_refused 3 'nowhere/x: cannot be written: No such file'
rm -f "$work"/out/*
finish
