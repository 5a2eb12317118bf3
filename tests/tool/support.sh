#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Shared by the tests of the tool; sourced with the arguments path/to/invcal builddir.
# Sets $tool, $data and $work, the test's own folder; at the end the test calls `finish`.
# shellcheck disable=SC2034,SC2154
tool=$1
data=$here/../data
[ -x "$tool" ] && [ -n "$2" ] || { echo "usage: $0 path/to/invcal builddir" >&2; exit 2; }
tool=$(cd "$(dirname "$tool")" && pwd)/$(basename "$tool")
mkdir -p "$2" || exit 2
work=$(cd "$2" && pwd)/$(basename "$0" .sh).$$
mkdir "$work" "$work/out" || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' HUP INT TERM
passed=0
failed=0

# Sentences stay on one line. width_test.sh tests what is printed if COLUMNS is not set.
COLUMNS=1000
export COLUMNS

# ---- checking ----------------------------------------------------------------------------------

report() { # report CODE SENTENCE: 0 is a pass
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
        echo "tool: $2: PASS"
    else
        failed=$((failed + 1))
        echo "tool: $2: FAIL"
    fi
}

check() { # check SENTENCE COMMAND ...: the command succeeds
    sentence=$1
    shift
    "$@"
    report $? "$sentence"
}

# Runs the tool: $code, $work/stdout, $work/stderr. Its standard input is the file $in.
in=/dev/null
run() {
    "$tool" "$@" > "$work/stdout" 2> "$work/stderr" < "$in"
    code=$?
}

complain() {
    echo "    exit code $code, stderr: $(head -c 300 "$work/stderr")" >&2
    return 1
}

is_empty() { [ ! -s "$1" ]; }

only_line() { # FILE: into $line
    { IFS= read -r line && ! IFS= read -r rest && [ -z "$rest" ]; } < "$1"
}

# One line that begins with "invcal: " and matches a pattern.
says() {
    only_line "$work/stderr" && [ "${line#invcal: }" != "$line" ] && grep -Eq -- "$1" "$work/stderr"
}

succeeded() { { [ "$code" -eq 0 ] && is_empty "$work/stderr"; } || complain; }

accepts() { # accepts SENTENCE ARGUMENTS ...
    sentence=$1
    shift
    run "$@"
    check "$sentence" succeeded
}

was_refused() { # CODE PATTERN
    { [ "$code" -eq "$1" ] && says "$2" && is_empty "$work/stdout"; } || complain
}

refuses() { # refuses SENTENCE CODE PATTERN ARGUMENTS ...
    sentence=$1
    expected=$2
    pattern=$3
    shift 3
    run "$@"
    check "$sentence" was_refused "$expected" "$pattern"
}

# The folder of the result contains what it contained before, and nothing else.
is_untouched() {
    [ "$(ls -A "$work/out")" = cal.json ] && only_line "$work/out/cal.json" && [ "$line" = old ]
}

kept_old() { was_refused "$1" "$2" && is_untouched; }

# refuses_file SENTENCE CODE PATTERN ARGUMENTS ...: the same for calibrate --positions, with a
# result file that must stay as it was.
refuses_file() {
    sentence=$1
    expected=$2
    pattern=$3
    shift 3
    echo old > "$work/out/cal.json"
    run calibrate --positions --out "$work/out/cal.json" "$@"
    check "$sentence" kept_old "$expected" "$pattern"
    rm -f "$work"/out/*
}

# ---- numbers and JSON --------------------------------------------------------------------------

json() { # json FILE NAME: the outermost member of this name, on one line; it has lines of its own
    sed -n "s/^  \"$2\": \(.*[^,]\),*\$/\1/p" "$1"
}

near() { # near TOLERANCE "A B C" "a b c": each pair agrees; brackets and commas do not matter
    echo "$2 | $3" | awk -v tolerance="$1" '{
        gsub(/[][,]/, " ")
        n = split($0, side, "|")
        n = split(side[1], a, " ")
        if (n == 0 || n != split(side[2], b, " ")) exit 1
        for (i = 1; i <= n; i++) {
            d = a[i] - b[i]
            if (!(d <= tolerance && d >= -tolerance)) exit 1
        }
    }'
}

# It is JSON according to the strict parser of apply: only its content may be wrong.
is_json() {
    "$tool" apply "$1" "$work/log.csv" 2> "$work/json.err" > /dev/null ||
        grep -q 'not a calibration' "$work/json.err"
}

is_page() { # FILE: HTML that is well-formed, and needs nothing else
    result=$(awk -f "$here/page.awk" "$1" 2>&1)
    [ -z "$result" ] || { echo "    $result" >&2; return 1; }
}

# Undoes a page's escapes for HTML.
plainly() { sed 's/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&#39;/'"'"'/g; s/&amp;/\&/g'; }

# The page shows the command that made it, and a shell splits that into exactly these words.
shows_command() { # FILE WORD ...
    shown_command=$(sed -n 's/^<dd class="literal">\(invcal .*\)<\/dd>$/\1/p' "$1" | plainly)
    shift
    [ "$(eval "printf '%s\n' $shown_command")" = "$(printf '%s\n' "$@")" ] || { echo "    $shown_command" >&2; return 1; }
}

eventually() { # COMMAND ...: waits until it succeeds, for a minute at most
    tries=0
    until "$@"; do
        [ $((tries += 1)) -le 600 ] || return 1
        sleep 0.1
    done
}

same() { cmp -s "$1" "$2"; }
matches() { grep -Eq -- "$2" "$1"; }
lacks() { ! grep -Eq -- "$2" "$1"; }

random_awk=$(cat "$here/random.awk")
random_awk="$random_awk
" # to be followed by a program
positions() { # positions FAMILY COUNT SEED
    awk -v family="$1" -v count="$2" -v seed="$3" -f "$here/random.awk" -f "$here/positions.awk"
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}

printf 'x,y,z\n1,2,3\n4,5,6\n' > "$work/log.csv"
