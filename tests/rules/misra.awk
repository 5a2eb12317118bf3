# SPDX-License-Identifier: MIT
#
# The messages of cppcheck and its MISRA addon that misra.txt does not excuse; entries of misra.txt that
# excuse nothing; and suppressions in the code that no run needed.
# Usage: awk -v runs=N -f misra.awk misra.txt MESSAGES...
#     MESSAGES  of each run, lines "file:line:column: id message"
FILENAME == ARGV[1] {
    if (/^[^# ]/) {
        rule[++entries] = $1
        at[entries] = FNR
        category = $2
        if (category !~ /^(advisory|required)$/) fault("neither advisory nor required")
        sub(/^[^ ]+ [^ ]+ ?/, "")
        where[entries] = $0
    } else if (/^ +[^ ]/ && entries) reason[entries] = 1
    next
}
$2 == "unmatchedSuppression" { if (++unmatched[$0] == runs) print; next }
seen[$0]++ { next }
{
    id = $2
    if (!sub(/^misra-c2012-/, "", id) || !excused(id, text_of($1))) print
}

function fault(text) { print ARGV[1] ":" at[entries] ": " text }

# "file: text" of a place "file:line:column:".
function text_of(place,    part, n) {
    split(place, part, ":")
    if (!((part[1], 1) in text)) {
        for (n = 1; (getline line < part[1]) > 0; n++) text[part[1], n] = line
        close(part[1])
    }
    return part[1] ": " text[part[1], part[2]]
}

function excused(id, line,    i) {
    for (i = 1; i <= entries; i++) {
        if (rule[i] == id && line ~ where[i]) {
            count[i]++
            return 1
        }
    }
    return 0
}

END {
    for (i = 1; i <= entries; i++) {
        if (!count[i]) print ARGV[1] ":" at[i] ": excuses nothing: " rule[i] " " where[i]
        if (!reason[i]) print ARGV[1] ":" at[i] ": no reason: " rule[i]
    }
}
