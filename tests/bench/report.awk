# SPDX-License-Identifier: MIT
#
# One table, a row for each operation, a column for each target; then what is over its budget or goal,
# and "N passed, N failed".
# Usage: awk -f report.awk BUDGETS GOALS UNITS TARGET.figures...
#     UNITS  "target unit", or "target-level fault" if its program did not finish
FNR == 1 {
    file++
    target = FILENAME
    sub(/.*\//, "", target)
    sub(/\.figures$/, "", target)
}
/^#/ || NF == 0 { next }
file == 1 && $1 == "figure" { for (i = 2; i <= NF; i++) column[$i] = i; next }
file == 1 { operations[$1]; for (name in column) budget[$1, name] = $(column[name]); next }
file == 2 { goals[++n_goals] = $0; next }
file == 3 && $2 == "fault" { failure[++failed] = $1 " does not finish"; next }
file == 3 { names[++targets] = $1; unit[$1] = $2; next }
{
    if (!seen[$1]++) rows[++n] = $1
    value[$1, target] = $2
    most = budget[$1, target]
    if (most == "" || most == "-") failure[++failed] = target ": " $1 " has no budget: make bench UPDATE=1"
    else if ($2 > most + 0) failure[++failed] = target ": " $1 " takes " $2 ", at most " most
    else passed++
}
function width(t) { return length(t) < 12 ? 14 : length(t) + 2 }
function meet(line,    part, fields, what, is, most) {
    fields = split(line, part, " ")
    what = part[1] ": " part[2]
    if (!unit[part[1]]) return
    is = value[part[2], part[1]]
    most = part[3] * (fields < 4 ? 1 : value[part[4], part[1]])
    if (is == "") failure[++failed] = what " has a goal, but was not measured"
    else if (is > most) failure[++failed] = what " takes " is ", its goal is at most " int(most)
    else passed++
}
END {
    printf "%-33s", ""
    for (i = 1; i <= targets; i++) printf "%*s", width(names[i]), names[i]
    printf "\n%-33s", ""
    for (i = 1; i <= targets; i++) printf "%*s", width(names[i]), unit[names[i]]
    print ""
    for (r = 1; r <= n; r++) {
        printf "%-33s", rows[r]
        for (i = 1; i <= targets; i++) printf "%*s", width(names[i]), value[rows[r], names[i]]
        print ""
    }
    for (i = 1; i <= targets; i++) for (r in operations) {
        if (budget[r, names[i]] != "-" && !((r, names[i]) in value)) {
            failure[++failed] = names[i] ": " r " was not measured"
        }
    }
    for (i = 1; i <= n_goals; i++) meet(goals[i])
    for (i = 1; i <= failed; i++) print "FAIL " failure[i]
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0
}
