#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of faults that were found and fixed: overwritten files, numbers out of range, control sequences on
# the terminal, very long logs, and facts in a report that no other test checks.
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

# ---- input files are not overwritten --------------------------------------------------------------

# saves FILE SENTENCE PATTERN ARGUMENTS ...: refused as a usage error, and the file is as it was.
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
        saves "$l" "$command $o over LOG" "$o: would overwrite LOG" \
            $command "$l" $o "$l"
        saves "$c" "$command $o over --nominal" "$o: would overwrite the file of --nominal" \
            $command "$l" --nominal "$c" $o "$c"
        saves "$a" "$command $o over --plan angles:" "$o: would overwrite the file of --plan" \
            $command "$l" --plan "angles:$a" $o "$a"
        saves "$a" "$command $o over --plan directions:" "$o: would overwrite the file of --plan" \
            $command "$l" --plan "directions:$a" $o "$a"
        in=$l
        saves "$l" "$command $o over what the standard input comes from" "$o: would overwrite LOG" \
            $command - $o "$l"
        in=/dev/null
    done
    saves "$n" "watch $o over --allan" "$o: would overwrite the file of --allan" \
        watch "$l" --allan "$n" --mean-sigma 0.001 $o "$n"
    saves "$l" "allan $o over LOG" "$o: would overwrite LOG" allan "$l" $o "$l"
    in=$l
    saves "$l" "allan $o over what the standard input comes from" "$o: would overwrite LOG" \
        allan - $o "$l"
    in=/dev/null
done
saves "$c" "export --out over CAL.json" '--out: would overwrite CAL.json' \
    export "$c" --format c --out "$c"
in=$c
saves "$c" "export --out over what the standard input comes from" '--out: would overwrite CAL.json' \
    export - --format c --out "$c"
in=/dev/null
for o in --svg --report; do
    saves "$a" "plan $o over --angles" "$o: would overwrite the file of --angles" plan --angles "$a" $o "$a"
    saves "$a" "plan $o over --directions" "$o: would overwrite the file of --directions" \
        plan --directions "$a" $o "$a"
    saves "$n" "plan $o over --allan" "$o: would overwrite the file of --allan" \
        plan --allan "$n" --limits 1e-4,1e-4,1e-4 $o "$n"
    saves "$a" "plan $o over --compare, the first" "$o: would overwrite the file of --compare" \
        plan --compare "angles:$a" faces $o "$a"
    saves "$a" "plan $o over --compare, the second" "$o: would overwrite the file of --compare" \
        plan --compare edges "directions:$a" $o "$a"
done
saves "$a" "simulate --truth over its directions" '--truth: would overwrite the file of --plan' \
    simulate --plan "directions:$a" --truth "$a"
saves "$a" "simulate --truth over its angles" '--truth: would overwrite the file of --plan' \
    simulate --plan "angles:$a" --truth "$a"
ln "$l" "$work/hard.csv"
ln -s "$l" "$work/soft.csv"
saves "$l" "a second name of LOG" '--out: would overwrite LOG' calibrate "$l" --out "$work/hard.csv"
saves "$l" "a link to LOG" '--out: would overwrite LOG' calibrate "$l" --out "$work/soft.csv"

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
# A killed run left a file; the next run has the same process ID, as in a container.
(cd "$work/out" && sh -c 'echo stale > cal.json.tmp-$$; echo $$ > ../pid
    exec "$0" calibrate "$1" --out cal.json' "$tool" "$l") > "$work/stdout" 2> "$work/stderr"
code=$?
pid=$(cat "$work/pid")
check "a file of a killed run is not in the way" succeeded
check "it is left alone, and there is no other" [ "$(left)" = "cal.json cal.json.tmp-$pid " ]
check "the file is there" is_json "$work/out/cal.json"
check "a foreign file is unchanged" [ "$(cat "$work/out/cal.json.tmp-$pid")" = stale ]
rm -f "$work"/out/*
(cd "$work/out" && sh -c 'for n in "" $(seq -f -%g 99); do echo stale > cal.json.tmp-$$$n; done
    exec "$0" calibrate "$1" --out cal.json' "$tool" "$l") > "$work/stdout" 2> "$work/stderr"
code=$?
check "a hundred of them are, and one is named" \
    was_refused 3 'cal\.json: cannot be written: cal\.json\.tmp-[0-9]+-99 exists'
rm -f "$work"/out/*

ln -s out/target.json "$work/link.json"
accepts "a link to a file that is not there yet" calibrate "$l" --out "$work/link.json" --quiet
check "the link is still a link" [ -L "$work/link.json" ]
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
# LOG is a pipe without a writer: reading it first would wait forever.
mkfifo "$work/never"
for line in "calibrate never --out" "watch never --report" "allan never --out" \
    "export never --format c --out" "plan --svg" "simulate --truth"; do
    # shellcheck disable=SC2086 # words
    run_for() { cd "$work" && timeout 10 "$tool" $line out/cal.json > stdout 2> stderr; }
    (run_for)
    code=$?
    check "what is read-only is refused before any work: ${line%% *}" \
        kept_old 3 'out/cal\.json: is read-only: name another file'
done
ln -s out/cal.json "$work/to_old.json"
run calibrate "$l" --out "$work/to_old.json"
check "a read-only file is refused through a link" kept_old 3 'to_old\.json: is read-only'
chmod 644 "$work/out/cal.json"
timeout 10 "$tool" calibrate "$work/never" --out "$work/nowhere/x" > "$work/stdout" 2> "$work/stderr"
code=$?
check "a missing folder is reported before any work" \
    was_refused 3 'nowhere/x: cannot be written: No such file'
rm -f "$work"/out/*

# ---- numbers ---------------------------------------------------------------------------------------

for f in px4 ardupilot; do
    for value in -1 99999999999 1e300 0.5; do
        refuses "export: --format $f --instance $value" 2 \
            '^invcal: --instance: must be a whole number from 0 to 3; see' export "$c" --format $f \
            --zero 0,0,0 --lsb 1 --instance $value
    done
done
for value in -1 99999999999 1e300; do
    refuses "plan --spare $value" 2 '^invcal: --spare .*: must be within 0 \.\.\. 135; see' \
        plan --limits 1,1,1 --spare $value
done
is_finite() { ! grep -Ewi -- '-?(inf|infinity|nan)' "$1" >&2; }
prints_finite() { { [ "$code" -eq 0 ] && is_finite "$work/stdout" && is_finite "$work/page.html"; } || complain; }
for rate in 1e-300 1e-12 1e12; do
    head -n 20000 "$work/rest.csv" > "$work/part.csv"
    run allan "$work/part.csv" --rate $rate --report "$work/page.html"
    check "allan --rate $rate prints finite numbers" prints_finite
done
run allan "$work/part.csv" --rate 1e-300
check "a time with more digits than make sense is in seconds" matches "$work/stdout" '[0-9]e\+30[0-9] s'
check "and no number has overflowed" lacks "$work/stdout" '[0-9]{15}'
refuses "a field whose error may exceed it" 2 '--gravity: .*below the length' \
    calibrate "$l" --gravity 9.8+-1e300

calibration() { # OFFSET DIAGONAL GRAVITY
    printf '{"offset": [%s, 0, 0], "matrix": [[%s, 0, 0], [0, %s, 0], [0, 0, %s]], "gravity": %s}\n' \
        "$1" "$2" "$2" "$2" "$3" > "$work/odd.json"
}
formats='c c-arrays fusion imu_tk ros px4 ardupilot'
driver_of() { case $1 in ros | px4 | ardupilot) echo --zero 0,0,0 --lsb "$2" ;; esac; }
for member in NaN Infinity -inf null 1e999; do
    for f in $formats; do
        calibration $member 1 9.8
        # shellcheck disable=SC2046
        refuses "export --format $f of an offset $member" 3 'odd\.json:1: ' \
            export "$work/odd.json" --format $f $(driver_of $f 1)
        calibration 1 $member 9.8
        # shellcheck disable=SC2046
        refuses "export --format $f of a matrix of $member" 3 'odd\.json:1: ' \
            export "$work/odd.json" --format $f $(driver_of $f 1)
    done
done
refuses_nonfinite() { # FORMAT LSB SENTENCE
    # shellcheck disable=SC2046
    refuses "export --format $1: $3" 1 'exceed the range of a|would be' \
        export "$work/odd.json" --format "$1" $(driver_of "$1" "$2")
}
calibration 1e29 1e290 9.8
for f in c c-arrays fusion ros px4 ardupilot; do refuses_nonfinite $f 1 "a product that overflows"; done
calibration 1 1e308 1
for f in fusion imu_tk; do refuses_nonfinite $f 1 "a scale that overflows"; done
calibration 1 1e39 48
refuses_nonfinite fusion 1 "a soft iron that overflows"
printf '{"offset": [1, 0, 0], "matrix": [[1e30, 1e39, 0], [0, 1e30, 0], [0, 0, 1e30]], "gravity": 48}\n' \
    > "$work/odd.json"
refuses_nonfinite fusion 1 "a cross term that overflows"

nominal='--positions --gravity 9.81744 --zero 33123,33276,32360 --lsb 0.0024'
{ cat "$xsens"; echo 1e200,33330,33330,1,1,1,100; } > "$work/huge.csv"
# shellcheck disable=SC2086
refuses "a reading too large to report" 1 'huge\.csv:40: the reading of position 39 is too large' \
    calibrate "$work/huge.csv" $nominal
{ cat "$xsens"; echo 1e20,33330,33330,1,1,1,100; } > "$work/huge.csv"
# shellcheck disable=SC2086
run calibrate "$work/huge.csv" $nominal --report "$work/page.html"
check "a reading that can be left out is, with finite numbers" prints_finite
check "it is named" matches "$work/stdout" '^Left out: position 39 \(line 40\)'

# ---- the terminal ------------------------------------------------------------------------------------

# A name that would clear the screen, in ASCII (ESC [ 2 J), as the one character U+009B, and as its byte.
escape=$(printf 'a\033[2Jb\302\2332Jc\2332Jd\177e')
cp "$l" "$work/$escape.csv"
cp "$xsens" "$work/$escape.positions"
cp "$work/rest.csv" "$work/$escape.rest"
cp "$c" "$work/$escape.json"
cp "$a" "$work/$escape.angles"
has_no_command() { # FILE: nothing that a terminal would obey, and the rest of the name
    LC_ALL=C tr -d '\n\t -~\200-\377' < "$1" | cmp -s - /dev/null &&
        ! LC_ALL=C grep -q "$(printf '\302[\200-\237]')" "$1" &&
        ! LC_ALL=C grep -q "$(printf '[ -~]\233')" "$1"
}
is_clean() { { has_no_command "$work/stdout" && has_no_command "$work/stderr"; } || { LC_ALL=C cat -v "$work/stdout" "$work/stderr" | grep -an '\^\|M-B' | head -n 3 >&2; return 1; }; }
clean() { # clean SENTENCE ARGUMENTS ...
    sentence=$1
    shift
    run "$@"
    check "$sentence: it has something to say" [ -s "$work/stdout" ] || complain
    check "$sentence: no control sequence reaches the terminal" is_clean
}
shown='a\?\[2Jb\?\?2Jc\?2Jd\?e'
clean "calibrate of a log" calibrate "$work/$escape.csv" --out "$work/out/$escape.json" \
    --report "$work/out/$escape.html"
check "the names are still readable" matches "$work/stdout" "^Saved in .*/$shown\.json\.\$"
check "so is the page's" matches "$work/stdout" "^Report in .*/$shown\.html\.\$"
check "and the next command" matches "$work/stdout" "invcal apply '.*/$shown\.json' LOG"
check "the file has the requested name" is_json "$work/out/$escape.json"
check "the page is clean, too" has_no_command "$work/out/$escape.html"
rm -f "$work"/out/*
clean "calibrate of positions" calibrate "$work/$escape.positions" --positions
clean "calibrate --json" calibrate "$work/$escape.csv" --json
clean "watch" watch "$work/$escape.csv"
clean "allan" allan "$work/$escape.rest" --to 299
clean "plan of angles" plan --angles "$work/$escape.angles"
clean "plan of directions" plan --directions "$work/$escape.angles"
clean "plan of two sets" plan --compare "angles:$work/$escape.angles" edges
clean "export" export "$work/$escape.json" --format c
sed "1s/.*/t,ax,ay,az,temp$(printf '\302\2332J\177')/; 2,\$s/\$/,25/" "$l" > "$work/heading.csv"
clean "a column" calibrate "$work/heading.csv"
sed "1s/.*/t,x$(printf '\302\2332J'),y,z/" "$l" > "$work/heading.csv"
run calibrate "$work/heading.csv"
check "a column that is refused" is_clean
for command in calibrate watch allan; do
    run $command "$work/no $escape"
    check "$command: a file that is not there" is_clean
done
clean "the heading of the nominal" calibrate "$l" --nominal-name "$(printf '\033[2J\302\2332J')"

# ---- silence ------------------------------------------------------------------------------------------

cat > "$work/warm.json" << 'END'
{"offset": [0, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity": 9.8,
 "thermal": {"degree": 0, "reference": 25, "span": 10, "least": 20, "greatest": 30, "field": 9.8,
  "nominal_offset": [0, 0, 0], "nominal_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  "coefficients": [{"delta": [0, 0, 0], "dk": [0, 0, 0], "gamma": [0, 0, 0]}], "frame": "symmetric"}}
END
cat > "$work/bent.json" << 'END'
{"offset": [0, 0, 0], "matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gravity": 9.8,
 "nonlinearity": {"quadratic": [0.001, 0, 0], "cubic": [0, 0, 0], "field": 9.8,
  "nominal_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}
END
printf 'x,y,z,temperature\n20,1,1,90\n' > "$work/beyond.csv"
for kind in warm bent; do
    run apply "$work/$kind.json" "$work/beyond.csv"
    check "apply warns of a reading beyond the range: $kind" says '^invcal: warning: '
    cp "$work/stdout" "$work/loud"
    accepts "apply --quiet does not: $kind" apply "$work/$kind.json" "$work/beyond.csv" --quiet
    check "and prints the same: $kind" same "$work/stdout" "$work/loud"
done
refuses "apply --quiet reports an error" 3 'no\.csv: cannot be read' \
    apply "$work/warm.json" "$work/no.csv" --quiet

# ---- very long logs ------------------------------------------------------------------------------------

# The six faces and twelve edges repeatedly, or with random=1 any directions: x y z, normal noise of
# 1 mm/s^2. With share=S a random share S of them reads 20 mm/s^2 too much: their numbers go to the file
# wrong. With angles=1 with angles in steps of 15 degrees, the wrong ones off by 15 degrees.
cat > "$work/long.awk" << 'END'
function put(x, y, z, rest) {
    printf "%.6f,%.6f,%.6f%s\n", 9.8 * x * 1.01 + 0.1 + 0.001 * normal(),
        9.8 * y * 0.99 - 0.2 + 0.001 * normal(), 9.8 * z * 1.02 + 0.05 + 0.001 * normal(), rest
}
BEGIN {
    begin_random(seed)
    d = 0.017453292519943295
    for (i = -1; i <= 1; i++) for (j = -1; j <= 1; j++) for (k = -1; k <= 1; k++) {
        q = i * i + j * j + k * k
        if (q == 1 || q == 2) { m++; X[m] = i / sqrt(q); Y[m] = j / sqrt(q); Z[m] = k / sqrt(q) }
    }
    print "x,y,z" (angles ? ",alpha,beta" : "")
    for (i = 0; i < n; i++) {
        p = i % m + 1
        x = X[p]; y = Y[p]; z = Z[p]
        if (random) {
            z = 2 * uniform() - 1; a = 6.283185307179586 * uniform(); r = sqrt(1 - z * z)
            x = r * cos(a); y = r * sin(a)
        }
        is_wrong = uniform() < share
        if (angles) {
            a = 15 * int(24 * uniform()); b = 15 * int(24 * uniform())
            put(sin(a * d) * sin(b * d), cos(a * d), sin(a * d) * cos(b * d), "," a "," b + 15 * is_wrong)
        } else {
            longer = is_wrong ? 1 + 0.02 / 9.8 : 1
            put(x * longer, y * longer, z * longer, "")
        }
        if (is_wrong) print i + 1 > wrong
    }
}
END
long() { # NAME=VALUE ...
    for v in "$@"; do
        set -- "$@" -v "$v"
        shift
    done
    : > "$work/wrong"
    awk -v wrong="$work/wrong" "$@" -f "$here/random.awk" -f "$work/long.awk" > "$work/long.csv"
}
of_long() { run calibrate "$work/long.csv" --positions --gravity 9.8 "$@"; }
long n=65535 seed=1
refuses "more positions than possible are refused with a reason" 3 'long\.csv:65536: more than 65534 positions' \
    calibrate "$work/long.csv" --positions
all_good() { # a program that is repeated, so often that any stride meets its period
    long n=20000 seed=1
    mv "$work/long.csv" "$work/all.csv"
    for n in 500 1000 2000 2560 3280 5200 6000 7000 9680 12000 13500 17000 20000; do
        head -n $((n + 1)) "$work/all.csv" > "$work/long.csv"
        of_long
        { [ "$code" -eq 0 ] && matches "$work/stdout" '^Good: '; } ||
            { echo "    $n: $(grep -E '^[A-Z][a-z ]*: ' "$work/stdout" | tail -n 2 | head -n 1)" >&2; return 1; }
    done
}
check "a clean program of 18 positions is good, however often it was repeated" all_good
false_alarms() { # of 100 clean sets of 130 positions, which take three turns: 0.7 are to be expected
    alarms=0
    for seed in $(seq 100); do
        long n=130 random=1 seed="$seed"
        of_long --json
        [ "$(json "$work/stdout" rejected)" = "[]" ] && [ "$(json "$work/stdout" suspected)" = 0 ] ||
            alarms=$((alarms + 1))
    done
    [ $alarms -le 3 ] || { echo "    $alarms false alarms" >&2; return 1; }
}
check "a test that is repeated keeps its false alarms for all positions together" false_alarms
finds_wrong() { # SHARE COUNT SEED: those that were made wrong and no others, and none is only suspected
    long n="$2" random=1 share="$1" seed="$3"
    of_long --json
    [ "$(json "$work/stdout" rejected | tr -d '[] ' | tr ',' '\n')" = "$(cat "$work/wrong")" ] &&
        [ "$(json "$work/stdout" suspected)" = 0 ]
}
check "a few wrong ones of thousands are named, and no others" finds_wrong 0.002 5000 1
check "one in ten" finds_wrong 0.1 5000 2
check "one in ten of a hundred and thirty" finds_wrong 0.1 130 3

# takes_its_length SIZE MAKER ARGUMENTS ...: four times as much input from MAKER SIZE takes no more than nine
# times the processor time. (Quadratic time would be sixteen.)
spent() { # BEFORE AFTER: seconds that all children have taken in between, by two lists of `times`
    awk 'FNR == 2 { for (i = 1; i <= 2; i++) { split($i, t, /[ms]/); s += (NR == FNR ? -1 : 1) * (60 * t[1] + t[2]) } }
        END { print s }' "$1" "$2"
}
takes_its_length() {
    size=$1 maker=$2
    shift 2
    for factor in 1 4; do
        $maker $((size * factor))
        times > "$work/before.times" # (not in a shell of its own, which would have no children)
        run "$@"
        times > "$work/after.times"
        [ "$code" -eq 0 ] || { complain; return 1; }
        took=$(spent "$work/before.times" "$work/after.times")
        [ $factor = 4 ] || took1=$took
    done
    echo "$took1 $took" | awk '{ exit !($2 > 0 && $2 <= 9 * $1 + 0.1) }' ||
        { echo "    $took1 s, four times as many $took s" >&2; return 1; }
}
with_angles() { long n="$1" angles=1 share=0.08 seed=1; }
with_wrong() { long n="$1" random=1 share=0.1 seed=1; }
with_rests() { # the same directions, five seconds each at 10 samples a second
    long n="$1" random=1 seed=1
    awk -F , "$random_awk"'BEGIN { begin_random(2) } NR == 1 { print "t,x,y,z"; next } {
        for (k = 1; k <= 55; k++) {
            f = k < 6 ? k / 6 : 1
            s = k < 6 ? 2 : 0.01
            printf "%.1f,%.4f,%.4f,%.4f\n", 0.1 * t++, x + ($1 - x) * f + s * (uniform() - 0.5),
                y + ($2 - y) * f + s * (uniform() - 0.5), z + ($3 - z) * f + s * (uniform() - 0.5)
        }
        x = $1; y = $2; z = $3 }' "$work/long.csv" > "$work/rests.csv"
}
check "time is proportional to the number of positions, some of them wrong" \
    takes_its_length 16000 with_wrong calibrate "$work/long.csv" --positions --gravity 9.8
check "of positions on a stand, some of them misset" \
    takes_its_length 16000 with_angles calibrate "$work/long.csv" --positions --gravity 9.8 --stand
check "of positions in watch" takes_its_length 1000 with_rests watch "$work/rests.csv" --gravity 9.8
check "of positions in watch with a program" \
    takes_its_length 1000 with_rests watch "$work/rests.csv" --gravity 9.8 --plan edges

# ---- facts of a report and of the result ---------------------------------------------------------------

# The sensor of simulate (its --help): offsets 0.02, -0.015, 0.03 g, scale errors 1, -0.8 and 1.2 %, angles
# 0.01, -0.006, 0.008 rad; 16384 counts for g.
"$tool" simulate --plan edges --noise 0.0001 > "$work/known.csv"
run calibrate "$work/known.csv" --gravity 9.80665 --zero 0,0,0 --lsb 0.00059855041503906 \
    --report "$work/page.html"
# The rows of the page's tables, a line each, without tags.
tr -d '\n' < "$work/page.html" | sed 's/<tr>/\n/g' | sed "s/<\/tr>.*//; s/<[^>]*>/ /g; s/$(printf '\302\240')/ /g; s/−/-/g" \
    > "$work/rows"
# The description of the picture of the nine parameters.
sed -n 's/^<desc>Bars for the nine parameters[^:]*: \(.*\)\.<\/desc>$/\1/p' "$work/page.html" | head -n 1 |
    sed "s/; /\n/g; s/$(printf '\302\240')/ /g; s/−/-/g" > "$work/bars"
shows() { # FILE NAME NUMBER WITHIN: the line that begins with this name has such a number
    awk -v name="$2" -v number="$3" -v within="$4" '
        { $1 = $1 }
        index($0, name " ") == 1 {
            seen = 1
            for (i = 3; i <= NF; i++) if ($i - number <= within && number - $i <= within) found = 1
        }
        END { exit !(seen && found) }' "$1" || { grep "$2" "$1" | head -n 2 >&2; return 1; }
}
for row in 'offset x=20=327.68' 'offset y=-15=-245.76' 'offset z=30=491.52' 'scale x=1=1687.410' \
    'scale y=-0.8=1657.337' 'scale z=1.2=1690.751' 'angle xy=0.57296=' 'angle xz=-0.34377=' \
    'angle zy=0.45837='; do
    name=${row%%=*} values=${row#*=}
    check "report: the table has the $name of the sensor" shows "$work/rows" "$name" "${values%=*}" 0.02
    check "report: and so has the picture" shows "$work/bars" "$name" "${values%=*}" 0.02
    [ -z "${values#*=}" ] ||
        check "report: and the readings: $name" shows "$work/rows" "$name" "${values#*=}" 0.3
done
for axis in x y z; do
    check "report: the nominal scale of $axis" shows "$work/rows" "scale $axis" 1670.703 0.06
done

# Forty directions along a spiral; lengths differ by up to 0.1 mg, but position 3 is wrong by 5 mg, so it is
# left out, and of the others 11 is worst, by 0.26 mg.
awk 'BEGIN {
    print "x,y,z"
    for (i = 0; i < 40; i++) {
        z = 1 - (2 * i + 1) / 40
        r = sqrt(1 - z * z)
        length_ = 1 + (i == 2 ? 0.005 : i == 10 ? 2.6e-4 : 1e-4 * sin(12.9898 * i * i))
        printf "%.7f,%.7f,%.7f\n", 9.8 * length_ * r * cos(2.399963 * i),
            9.8 * length_ * r * sin(2.399963 * i), 9.8 * length_ * z
    }
}' > "$work/moved.csv"
run calibrate "$work/moved.csv" --positions --gravity 9.8 --json
check "the wrong one is left out" [ "$(json "$work/stdout" rejected)" = '[3]' ]
run calibrate "$work/moved.csv" --positions --gravity 9.8
check "the worst of those kept has its number in the file" \
    matches "$work/stdout" 'max .*, at position 11 \(line 12\)$'
awk -F , -v OFS=, 'NR == 4 { $1 = 1e20 } NR == 12 { $1 = 1e200 } { print }' "$work/moved.csv" > "$work/huge.csv"
refuses "so has one that is refused behind one that is left out" 1 \
    'huge\.csv:12: the reading of position 11 is too large' calibrate "$work/huge.csv" --positions --gravity 9.8 \
    --zero 0,0,0 --lsb 1
long n=24 angles=1 seed=8
awk -F , -v OFS=, 'NR == 4 { for (i = 1; i <= 3; i++) $i *= 1.005 } NR == 12 { $4 += 2 } { print }' \
    "$work/long.csv" > "$work/moved.csv"
run calibrate "$work/moved.csv" --positions --gravity 9.8 --stand
check "so has the misset one of a stand" matches "$work/stdout" '^Misset: position 11 \(line 12\)|^Misset: position 11 '

# Noise of the samples: 1 mg, over the root of the 350 to 500 samples that a rest of five seconds has.
"$tool" simulate --plan edges --noise 0.001 > "$work/noisy.csv"
run calibrate "$work/noisy.csv" --gravity 9.80665
check "the noise of a mean is that of its samples over the root of their count" awk '
    match($0, /\(of samples: [0-9.e-]*\)/) {
        n = 0.00980665 / substr($0, RSTART + 13, RLENGTH - 14); found = n * n > 350 && n * n < 500
    }
    END { exit !found }' "$work/stdout"

# Slopes of temperature where there are none: the chance of the difference that they make is that of
# Fisher, the integral of the beta distribution (by the midpoint rule) for 9 and n - 18 degrees of freedom.
chance_of() { # RMS WITHOUT POSITIONS
    awk -v z="$(echo "$1 $2" | awk '{ print ($1 / $2) ^ 2 }')" -v n="$3" 'BEGIN {
        a = (n - 18) / 2; b = 4.5; steps = 100000
        for (i = 0; i < steps; i++) {
            t = (i + 0.5) / steps
            f = t ^ (a - 1) * (1 - t) ^ (b - 1)
            all += f
            if (t <= z) part += f
        }
        print part / all
    }'
}
# Half of the positions at 20 and half at 30 degrees, spread over the sphere along a spiral.
warm() { # POSITIONS SEED
    awk -v n="$1" -v seed="$2" "$random_awk"'
        BEGIN {
            begin_random(seed)
            print "x,y,z,temperature"
            for (t = 0; t < 2; t++) {
                m = int((n + 1 - t) / 2)
                begin = 6.28 * uniform()
                for (i = 0; i < m; i++) {
                    z = 1 - (2 * i + 1) / m
                    x = sqrt(1 - z * z) * cos(begin + 2.399963 * i)
                    y = sqrt(1 - z * z) * sin(begin + 2.399963 * i)
                    printf "%.6f,%.6f,%.6f,%g\n", 9.8 * x * 1.01 + 0.1 + 0.001 * normal(),
                        9.8 * y * 0.99 - 0.2 + 0.001 * normal(), 9.8 * z * 1.02 + 0.001 * normal(),
                        20 + 10 * t
                }
            }
        }' > "$work/warm.csv"
}
is_chance() { # POSITIONS SEED
    warm "$1" "$2"
    run calibrate "$work/warm.csv" --positions --gravity 9.8 --keep-all
    printed=$(tr '\n' ' ' < "$work/stdout" | sed -n 's/.*(p = \([0-9.e-]*\)).*/\1/p')
    run calibrate "$work/warm.csv" --positions --gravity 9.8 --keep-all --thermal 1 --json
    without=$(sed -n 's/^ *"residual_rms_without": \([0-9.e-]*\),*$/\1/p' "$work/stdout")
    is=$(chance_of "$(json "$work/stdout" residual_rms)" "$without" "$1")
    echo "$printed $is" | awk '{ exit !($1 > 0 && $1 / $2 < 1.06 && $2 / $1 < 1.06) }' ||
        { echo "    printed $printed, but it is $is" >&2; return 1; }
}
for n in 24 30 50; do
    check "the chance that $n positions depend on temperature is Fisher's" is_chance $n 1
    check "and of others" is_chance $n 2
done
# 0.7 % of sets may lose a good one. Of 22 positions with 18 unknowns the last one that is looked at has two
# degrees of freedom behind it: with any more, or by what the linear rows tell of positions that hardly
# anything checks, it would be one in four.
thermal_alarms() {
    for n in 21 22 24; do
        alarms=0
        for seed in $(seq 100); do
            warm $n "$seed"
            run calibrate "$work/warm.csv" --positions --gravity 9.8 --thermal 1 --json
            [ "$(json "$work/stdout" rejected)" = "[]" ] || alarms=$((alarms + 1))
        done
        [ $alarms -le 3 ] || { echo "    $alarms false alarms of $n positions" >&2; return 1; }
    done
}
check "--thermal leaves out no good position, even of the fewest" thermal_alarms
# Of 21 positions one that is wrong by 3 %, three hundred times the noise, which two degrees of freedom can
# tell, but not one.
thermal_finds() { # AT MOST so many of 40 are missed
    missed=0
    for seed in $(seq 40); do
        warm 21 "$seed"
        awk -F , -v OFS=, 'NR == 6 { for (i = 1; i <= 3; i++) $i *= 1.03 } { print }' \
            "$work/warm.csv" > "$work/moved.csv"
        run calibrate "$work/moved.csv" --positions --gravity 9.8 --thermal 1 --json
        [ "$(json "$work/stdout" rejected)" = "[5]" ] || missed=$((missed + 1))
    done
    [ $missed -le $1 ] || { echo "    $missed missed" >&2; return 1; }
}
check "and finds a wrong one" thermal_finds 10

# ---- on the disk ---------------------------------------------------------------------------------------

cat > "$work/count.c" << 'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
static void tell(const char *what)
{
    FILE *file = fopen(getenv("COUNTED"), "a");
    if (file) {
        fprintf(file, "%s\n", what);
        fclose(file);
    }
}
int fsync(int fd)
{
    tell("fsync");
    return ((int (*)(int))dlsym(RTLD_NEXT, "fsync"))(fd);
}
int rename(const char *from, const char *to)
{
    tell("rename");
    return ((int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename"))(from, to);
}
END
# A name without blanks, as the loader takes a blank for the end of the name.
shim=$(mktemp /tmp/invcal-count.XXXXXX)
if ! ${CC:-cc} -shared -fPIC -w -o "$shim" "$work/count.c" -ldl 2> /dev/null ||
    ! LD_PRELOAD=$shim COUNTED=$work/counted "$tool" --version > /dev/null 2>&1; then
    echo "what is brought to the disk: left out, nothing can be put before the C library here"
else
    COUNTED=$work/counted LD_PRELOAD=$shim "$tool" calibrate "$l" --quiet \
        --out "$work/out/cal.json" --report "$work/out/page.html"
    check "both files are flushed to disk before either gets its name" \
        [ "$(tr '\n' ' ' < "$work/counted")" = 'fsync fsync rename rename ' ]
    rm -f "$work"/out/*
fi
rm -f "$shim"
finish
