#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Prints the manual page of the tool $1, made from its own help, so that the two cannot differ.
# The help has text in the first column, options after two blanks and their meaning from column 23 on;
# other indented lines are kept as they are.
tool=$1
export COLUMNS=64 # of 78, without what man indents words by
version=$("$tool" --version) || exit 1
list=$("$tool" --help) || exit 1
commands=$(echo "$list" | awk '/^  [a-z]/ && $1 != "invcal" { print $1 }')

# The help of a command, through an awk program.
help_of() {
    "$tool" "$1" --help all | awk -v command="$1" "$escape $2"
}

# Text for troff: escapes its requests, and characters that it would replace by typographic ones. (Not by
# gsub, where each awk has its own rule for a backslash.)
escape='
BEGIN {
    troff["\\"] = "\\e"; troff["-"] = "\\-"; troff["\047"] = "\\(aq"
    troff["^"] = "\\(ha"; troff["`"] = "\\(ga"; troff["~"] = "\\(ti"
}
function raw(s,    c, i, out) {
    out = s ~ /^\./ ? "\\" "&" : ""
    for (i = 1; i <= length(s); i++) {
        c = substr(s, i, 1)
        out = out (c in troff ? troff[c] : c)
    }
    return out
}
# Hyphens within words need no escape.
function text(s) {
    s = raw(s)
    while (match(s, /[A-Za-z]\\-[A-Za-z]/)) {
        s = substr(s, 1, RSTART) "-" substr(s, RSTART + 3)
    }
    return s
}'

synopsis='
/^usage:/ { on = 1 }
!NF { is_past = 1 } # an exit would leave the tool writing into a closed pipe
on && !is_past { sub(/^usage: /, "       "); print raw(substr($0, 8)) }'

description='
function fill() { if (verbatim) print ".fi"; verbatim = 0 }
function keep() { if (!verbatim) print ".nf"; verbatim = 1 }
/^usage:/ { usage = 1 }
/^examples?:/ { is_past = 1 }
is_past { next }
usage { usage = NF > 0; next }
!NF { fill(); paragraph = 1; next }
/^  --/ {
    fill()
    alone = length($0) <= 22 || substr($0, 22, 1) != " "
    tag = alone ? $0 : substr($0, 1, 22)
    gsub(/^ +| +$/, "", tag)
    print ".TP\n.B " raw(tag)
    if (!alone) print text(substr($0, 23))
    paragraph = 0
    next
}
/^                      / { print text(substr($0, 23)); next }
/^ / { if (paragraph) print ".PP"; paragraph = 0; keep(); print raw($0); next }
{ fill(); if (paragraph) print ".PP"; paragraph = 0; print text($0) }
END { fill() }'

examples='
on && NF { print raw(substr($0, 3)) }
/^examples?:/ { on = 1 }'

echo ".\\\" SPDX-License-Identifier: MIT
.\\\" Made by port/host/man.sh of what invcal --help prints.
.TH INVCAL 1 $(date -u +%Y-%m-%d) \"$version\"
.nh
.ad l
.SH NAME
invcal \\- calibrate accelerometers, gyroscopes and magnetometers from logs
.SH SYNOPSIS
.nf"
for c in $commands; do
    help_of "$c" "$synopsis"
done
echo 'invcal help [COMMAND [all]]
invcal \-\-help
invcal COMMAND \-\-help [all]
invcal \-\-version
.fi
.SH DESCRIPTION'
echo "$list" | awk "$escape"'
    /^usage:|^exit codes:/ { skip = 1 }
    !NF { skip = 0; next }
    !skip && !/^ / { print text($0) }'
for c in $commands; do
    echo "$list" | awk -v c="$c" "$escape"'
        /^  / && $1 == c { $1 = ""; print ".SS \"" c " \\- " text(substr($0, 2)) "\"" }'
    help_of "$c" "$description"
done
echo '.SH "EXIT STATUS"'
echo "$list" | awk "$escape"'
    /^exit codes:/ { on = 1; sub(/^exit codes: */, "") }
    on { all = all (all == "" ? "" : " ") $0 }
    END {
        n = split(all, code, "; *")
        for (i = 1; i <= n; i++) {
            print ".TP\n.B " substr(code[i], 1, 1) "\n" text(substr(code[i], 3))
        }
    }'
echo '.SH EXAMPLES
.nf'
for c in $commands; do
    help_of "$c" "$examples"
done
echo '.fi
.SH FILES
.TP
.I CAL.json
A calibration, written by calibrate \-\-out, read by apply, compare and \-\-nominal.
.TP
.I PREFIX/share/invcal/schema.json
JSON Schema (2020\-12) of the JSON that the tool prints and writes, with units.
.TP
.I PREFIX/share/bash\-completion/completions/invcal
Completion for bash; zsh reads it after bashcompinit.
.SH ENVIRONMENT
.TP
.B COLUMNS
Width of tables and texts, at least 60. Default: the width of the terminal, or 80.
.TP
.B NO_COLOR
If set and not empty, disables colours.
.TP
.B TERM
A terminal named dumb, or without a name, gets no colours.
.SH "SEE ALSO"
Egorov, Dzuev, Popov: Synthesis of calibration programs for an accelerometer unit of strapdown INS:
an invariant approach. Giroskopiya i Navigatsiya 2019, 27(1), 61\-71.'
