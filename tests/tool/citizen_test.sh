#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tests of how the tool fits into its environment: help, man page, completion, installation, silence,
# colours, progress. citizen_test.sh path/to/invcal builddir
# Skips what needs `script` (a terminal) or bash if they are missing, with a line that says so.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
root=$(cd "$here/../.." && pwd)
commands='calibrate apply export allan plan compare simulate watch'
xsens=$data/xsens_mti_positions.csv
unset NO_COLOR COLUMNS

# ---- help --------------------------------------------------------------------------------------

in_order() { # usage first; exit codes; an example last
    awk 'NR == 1 && !/^usage: invcal / { exit 1 }
        /^exit codes: 0 (good|calibrated, whatever the verdict); / { codes = NR }
        /^examples?:$/ { example = NR }
        END { exit !(codes > 1 && example > codes && NR > example) }' "$1"
}
# Blanks, the option and its value; then, from column 23 on or on the next line, what it means.
has_layout() {
    awk 'alone && (substr($0, 1, 22) ~ /[^ ]/ || substr($0, 23, 1) == " ") { print "no text: " $0; bad = 1 }
        { alone = 0 }
        /^  --/ {
            alone = length <= 22 || substr($0, 22, 1) != " "
            if (!/^  --[a-z][a-z0-9-]+( [^ ]+)*( +.*)?$/) { print "no option: " $0; bad = 1 }
            if (!alone && substr($0, 23, 1) == " ") { print "out of line: " $0; bad = 1 }
        }
        END { exit bad }' "$1" >&2
}
options_of() { "$tool" "$1" --help all | awk '/^  --/ { print $1 }'; }
knows_options() { # every option of its help is one
    for o in $(options_of "$1"); do
        ! "$tool" "$1" "$o=" 2>&1 | grep -q 'unknown option' || return 1
    done
}
mkdir "$work/bin" "$work/example"
ln -s "$tool" "$work/bin/invcal"
ln -s "$root/tests" "$work/example/tests"
runs() { (cd "$work/example" && PATH=$work/bin:$PATH && export PATH && [ -s "$1" ] && sh -e "$1"); }
for c in $commands; do
    accepts "$c --help all succeeds" "$c" --help all
    cp "$work/stdout" "$work/help"
    check "$c --help all has usage, exit codes and an example, in this order" in_order "$work/help"
    check "$c --help all has the common layout" has_layout "$work/help"
    check "$c --help all: every option is known" knows_options "$c"
    sed '1,/^examples*:$/d; s/^  //' "$work/help" > "$work/example/run"
    check "the example of $c --help all works" runs run > /dev/null
done
check "the example of calibrate writes its calibration" is_json "$work/example/cal.json"
check "the example of plan draws a picture" matches "$work/example/directions.svg" '^</svg>$'
check "the example of simulate makes a log" matches "$work/example/log.csv" '^t,x,y,z$'
accepts "--help succeeds" --help
sed -n 's/^  \([a-z]*\) .*/\1/p' "$work/stdout" | grep -v invcal > "$work/commands"
check "--help names the commands" [ "$(tr '\n' ' ' < "$work/commands")" = "$commands " ]
for n in 0 1 2 3; do
    check "--help and README.md document exit code $n" sh -c '
        tr "\n" " " < "$1" | grep -iq "exit codes: .*$3 [a-z]" &&
        tr "\n" " " < "$2" | grep -q "Exit codes: .*$3 [a-z]"' sh "$work/stdout" "$root/README.md" "$n"
done
mkdir "$work/example/build"
ln -s "$tool" "$work/example/build/invcal"
for page in README.md port/manual/tool.md; do
    sed -n 's|^    build/invcal|build/invcal|p' "$root/$page" > "$work/example/readme"
    check "the commands of $page work" runs readme > /dev/null
done

# ---- slips -------------------------------------------------------------------------------------

refuses "a slip in a command" 2 '^invcal: calibate: unknown command \(did you mean calibrate\?\); see' \
    calibate
refuses "a slip in an option" 2 '\(did you mean --gravity\?\); see invcal calibrate --help$' \
    calibrate log --garvity 9.8
refuses "half an option" 2 '\(did you mean --nominal\?\); see' calibrate log --nomi x
refuses "one dash for two" 2 '\(did you mean --json\?\); see' calibrate log -json
refuses "a slip in an option with a value" 2 '^invcal: --optimul: .*\(did you mean --optimal\?\)' \
    plan --optimul=9
refuses "what is near to nothing is not guessed" 2 '^invcal: --wobble: unknown option; see' \
    plan --wobble

# ---- silence -----------------------------------------------------------------------------------

"$tool" simulate --plan edges > "$work/log.csv"
is_silent() { { [ "$code" -eq 0 ] && is_empty "$work/stdout" && is_empty "$work/stderr"; } || complain; }
silent() { # silent ARGUMENTS ...
    run "$@" --quiet
    check "--quiet: $1 ${2##*/} says nothing" is_silent
}
silent calibrate "$work/log.csv"
silent calibrate "$xsens" --positions --gravity 9.81744 --out "$work/quiet.json"
check "--quiet: the file is written anyway" is_json "$work/quiet.json"
silent watch "$work/log.csv"
silent allan "$work/log.csv" --to 5
silent plan
silent plan --sweep 5:9
silent plan --compare edges optimal:18
silent plan --limits 0.4,0.6,1 --svg "$work/quiet.svg"
check "--quiet: the picture is drawn anyway" matches "$work/quiet.svg" '^</svg>$'
only_json() { # only_json ARGUMENTS ...
    run "$@" --json
    cp "$work/stdout" "$work/loud"
    run "$@" --json --quiet
    check "--quiet: JSON is printed anyway, and nothing else: $1" sh -c '
        cmp "$1" "$2" && [ ! -s "$3" ]' sh "$work/loud" "$work/stdout" "$work/stderr"
}
only_json calibrate "$work/log.csv"
only_json watch "$work/log.csv"
only_json plan --edges
run apply "$work/quiet.json" "$work/log.csv" --quiet
check "--quiet: apply prints its result" matches "$work/stdout" '^t,x,y,z$'
refuses "--quiet: a refusal is reported" 1 'no rest' calibrate "$xsens" --quiet
refuses "--quiet: a set that is refused is reported" 1 'undetermined' plan --faces --quiet
refuses "--quiet: an error is reported" 3 'nowhere' watch "$work/nowhere" --quiet

# ---- what the first help promises ------------------------------------------------------------------

run --help
mv "$work/stdout" "$work/first"
run calibrate "$root/tests/data/t265_positions.csv" --positions --gravity 9.8016
check "--help: 0 whatever the verdict, such as weak" test \
    "$code $(grep -c '^Weak: ' "$work/stdout") $(grep -c 'exit codes: 0 done, whatever the verdict; 1' "$work/first")" = "0 1 1"
check "--help: the kinds of sensors" matches "$work/first" '^Calibrates accelerometers, gyroscopes and magnetometers from logs\.$'

# ---- the manual --------------------------------------------------------------------------------

sh "$root/port/host/man.sh" "$tool" > "$work/invcal.1"
for s in NAME SYNOPSIS DESCRIPTION '"EXIT STATUS"' EXAMPLES FILES ENVIRONMENT '"SEE ALSO"'; do
    check "the manual has a section $s" matches "$work/invcal.1" "^\.SH $s\$"
done
check "the man page names these sensors, too" matches "$work/invcal.1" '^invcal .- calibrate accelerometers, gyroscopes and magnetometers from logs$'
check "the manual has a subsection for each command" [ "$(sed -n 's/^\.SS "\([a-z]*\) .*/\1/p' \
    "$work/invcal.1" | tr '\n' ' ')" = "$commands " ]
in_manual() { # every option of each command stands in its own subsection
    for c in $commands; do
        awk -v c="$c" '/^\.S[SH]/ { on = $2 == "\"" c } on && sub(/^\.B /, "") {
            gsub(/\\/, ""); print $1 }' "$work/invcal.1" > "$work/found"
        options_of "$c" | diff - "$work/found" >&2 || return 1
    done
}
check "the manual has every option of every command" in_manual
check "the manual has every exit code" [ "$(sed -n '/^\.SH "EXIT/,/^\.SH EXAM/s/^\.B //p' \
    "$work/invcal.1" | tr -d '\n')" = 0123 ]
check "the man page has no text that troff would take for a request" awk '
    /^\./ && !/^\.(\\"|TH|SH|SS|TP|PP|B|I|nf|fi|nh|ad)( |$)/ { exit 1 }
    /^\047/ { exit 1 }' "$work/invcal.1"

# ---- completion --------------------------------------------------------------------------------

offers() { # offers "WORDS ..." WORD ...: what bash offers for the last word, sorted
    wanted=$1
    shift
    offered=$(cd "$work/example" && bash -c '
        . "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _invcal; printf "%s\n" "${COMPREPLY[@]}"' \
        "$root/port/host/invcal.bash" "$tool" "$@" | LC_ALL=C sort | tr '\n' ' ')
    [ "$offered" = "$wanted " ] || { echo "    offered: $offered" >&2; return 1; }
}
completes() { check "completion: $1" offers "$2" "$3" "$4" "$5" "$6"; }
if command -v bash > /dev/null; then
    : > "$work/example/la la.csv"
    check "completion: commands" offers "--help --version allan apply calibrate compare export help plan simulate watch" ''
    check "completion: the rest of a command" offers calibrate ca
    check "completion: help" offers 'allan apply' help a
    check "completion: the rest of an option" offers --gravity calibrate --gr
    for c in $commands; do
        check "completion: all options of $c" offers \
            "$({ options_of "$c"; echo --help; } | LC_ALL=C sort | tr '\n' ' ' | sed 's/ $//')" \
            "$c" --
    done
    check "completion: words of --frame" offers 'accelerometer stand symmetric triangular' calibrate --frame ''
    check "completion: words of --frame after =" offers triangular watch --frame = t
    check "completion: words of --plan" offers \
        'angles: directions: edges faces grid: icosahedron optimal: per-group: stand-12 stand-24' simulate --plan ''
    check "completion: sets of watch --plan" offers \
        'angles: directions: edges faces grid: icosahedron optimal: per-group: stand-12 stand-24' watch --plan ''
    check "completion: a file within a word" offers 'log.csv' simulate --plan directions : log
    check "completion: and one of angles" offers 'log.csv' simulate --plan angles : log
    check "completion: words of --compare, the second too" offers edges plan --compare faces ed
    check "completion: words of --moves" offers 'faces greedy12 tour12 tour16 tour24' plan --moves ''
    check "completion: files, with blanks" offers 'la la.csv' calibrate la
    check "completion: files of an option" offers truth.json simulate --truth tr
    check "completion: nothing for a number" offers '' calibrate --gravity ''
    check "completion: sensors with a sheet" offers 'bmi160 bmi270 bno055' calibrate --sensor b
    check "completion: it is bash's for invcal" bash -c '. "$0" && complete -p invcal' \
        "$root/port/host/invcal.bash" > /dev/null
else
    echo "tool: completion is not tried: bash is not installed"
fi

# ---- installation ------------------------------------------------------------------------------

unset MAKEFLAGS MFLAGS MAKELEVEL
# Folders by their paths from the root, as make accepts no blank in BUILD, and expands a $.
below() { printf %s "${1#"$root"/}"; }
installs() { # TARGET PREFIX
    (cd "$root" && make -s "$1" BUILD="$(below "$(dirname "$tool")")" \
        DESTDIR="$(below "$work")/a root" PREFIX="$2")
}
files() { (cd "$work/a root" && find . -type f | LC_ALL=C sort | tr '\n' ' '); }
for prefix in /usr/local /opt/invcal; do
    check "make install PREFIX=$prefix succeeds" installs install $prefix
    expected=$({
        printf '%s\n' bin/invcal lib/libinvcal.a lib/libinvcal_double.a lib/pkgconfig/invcal.pc \
            lib/pkgconfig/invcal-double.pc share/bash-completion/completions/invcal \
            share/invcal/schema.json share/man/man1/invcal.1
        cd "$root" && printf '%s\n' include/invcal/*.h
    } | sed "s|^|.$prefix/|" | LC_ALL=C sort | tr '\n' ' ')
    check "PREFIX=$prefix: all files are there" [ "$(files)" = "$expected" ]
    check "PREFIX=$prefix: the tool runs" sh -c '"$1" --version | grep -q "^invcal "' sh \
        "$work/a root$prefix/bin/invcal"
    check "PREFIX=$prefix: the manual is of this tool" matches \
        "$work/a root$prefix/share/man/man1/invcal.1" "\"$("$tool" --version)\"\$"
    check "PREFIX=$prefix: everybody can read the files" [ -z "$(find "$work/a root" -type f ! -perm -444)" ]
    check "make uninstall PREFIX=$prefix succeeds" installs uninstall $prefix
    check "PREFIX=$prefix: nothing is left" [ -z "$(files)" ]
done

# ---- colours, progress -------------------------------------------------------------------------

escape=$(printf '\033')
run calibrate "$work/log.csv"
check "no colour into a file" lacks "$work/stdout" "$escape"
run calibrate "$xsens" --positions --zero 33000,33000,32000 --lsb 0.0024 --nominal-name 'ab±²µ'
LC_ALL=C sed 's/±/+/g; s/²/2/g; s/µ/u/g' "$work/stdout" > "$work/ascii"
check "columns count characters, not bytes" awk '
    / \+ sigma/ { heading = index($0, "ab+2u") + length("ab+2u"); sign = index($0, " + ") }
    /^offset x/ { figure = index($0, " " $6 " ") + length($6) + 1; same = sign == index($0, " + ") }
    END { exit !(same && figure && figure == heading) }' "$work/ascii"

# On a terminal: what it shows, line by line, is in $work/shown; all bytes are in $work/typed.
terminal() { # terminal COMMAND: for a shell, in which $tool is invcal
    PATH=$work/bin:$PATH script -qec "$1" /dev/null < /dev/null > "$work/typed"
    code=$?
    # After a carriage return, text overwrites the old from the first column on.
    tr -d '\000' < "$work/typed" | LC_ALL=C awk '{
        n = split($0, piece, "\r")
        line = ""
        for (i = 1; i <= n; i++) line = piece[i] substr(line, length(piece[i]) + 1)
        sub(/ +$/, "", line)
        print line
    }' > "$work/shown"
}
shows() { # shows FILE: the terminal, but for colours, what the file holds
    sed "s/$escape\[[0-9;]*m//g" "$work/shown" | diff "$1" - >&2
}
coloured() { matches "$work/typed" "$escape\[1;${1}m$2$escape\[0m"; }

# shellcheck disable=SC2016 # for the shell inside: a path may hold whatever quotes there are
if command -v script > /dev/null && script -qec true /dev/null > /dev/null 2>&1 < /dev/null; then
    TERM=xterm
    long=$work/long.csv
    export TERM work data long
    plain="$work/plain"
    "$tool" calibrate "$work/log.csv" > "$plain"
    terminal 'invcal calibrate "$work/log.csv"'
    check "colour: good is green" coloured 32 Good:
    check "colour: nothing else differs" shows "$plain"
    check "colour: a heading is bold" matches "$work/typed" "$escape\[1m +calibrated"
    terminal 'invcal calibrate "$data/t265_positions.csv" --positions'
    check "colour: weak is red" coloured 31 Weak:
    printf '%s\n' 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0,-1 .7,.7,0 .7,0,.7 0,.7,.7 > "$work/nine.csv"
    terminal 'invcal calibrate "$work/nine.csv" --positions --gravity 1'
    check "colour: no redundancy is yellow" coloured 33 'No redundancy:'
    "$tool" simulate --plan edges --outliers 1 > "$work/wrong.csv"
    terminal 'invcal calibrate "$work/wrong.csv"'
    check "colour: left-out positions are red" coloured 31 'Left out:'
    terminal "invcal plan --sweep 5:9"
    check "colour: the heading of a sweep is bold" matches "$work/typed" "$escape\[1m *N  positions"
    terminal "invcal plm"
    check "colour: an error is red" coloured 31 invcal:
    terminal 'invcal plm 2> "$work/error"'
    check "colour: but not in a file" lacks "$work/error" "$escape"
    for setting in NO_COLOR=1 TERM=dumb TERM=; do
        terminal "$setting invcal calibrate \"\$work/log.csv\"; $setting invcal plm"
        check "colour: none with $setting" lacks "$work/typed" "$escape"
    done
    terminal 'unset TERM; invcal calibrate "$work/log.csv"'
    check "colour: none on a terminal without a name" lacks "$work/typed" "$escape"
    terminal 'NO_COLOR= invcal calibrate "$work/log.csv"'
    check "colour: an empty NO_COLOR is ignored" coloured 32 Good:
    terminal 'invcal watch "$work/log.csv" --target 1,1,1'
    check "colour: watch: enough is green" coloured 32 enough:

    # 50,000 rows: the bar comes and goes.
    "$tool" simulate --plan edges --rate 400 > "$long"
    "$tool" calibrate "$long" --out "$work/long.json" --quiet
    "$tool" calibrate "$long" > "$plain"
    terminal 'invcal calibrate "$long"'
    check "progress: calibrate shows a bar" matches "$work/typed" '\[#+ +\] +[0-9]+ %, [0-9]+ position'
    check "progress: nothing of it is left" shows "$plain"
    terminal 'invcal calibrate "$long" --quiet'
    check "progress: not with --quiet" is_empty "$work/typed"
    terminal 'invcal calibrate "$long" 2> "$work/error" > /dev/null'
    check "progress: not into a file" is_empty "$work/error"
    terminal 'cat "$long" | invcal calibrate -'
    check "progress: for a pipe, lines" matches "$work/typed" '[0-9]+ lines, [0-9]+ position'
    "$tool" calibrate - < "$long" > "$plain"
    check "progress: nothing of them is left" shows "$plain"
    terminal 'invcal apply "$work/long.json" "$long" > "$work/applied"'
    check "progress: apply shows a bar" matches "$work/typed" '\[#+ +\] +[0-9]+ %'
    check "progress: nothing of apply's is left" [ -z "$(tr -d ' \n' < "$work/shown")" ]
    "$tool" apply "$work/long.json" "$long" > "$work/expected"
    check "progress: apply's result is the same" same "$work/applied" "$work/expected"
    echo 'a,b' >> "$long"
    "$tool" apply "$work/long.json" "$long" 2> "$plain"
    terminal 'invcal apply "$work/long.json" "$long"'
    check "progress: an error has its own line" shows "$plain"
else
    echo "tool: colours and progress are not tried: script is not installed"
fi

finish
