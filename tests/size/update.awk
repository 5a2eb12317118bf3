# SPDX-License-Identifier: MIT
#
# Rewrites the budgets: what was measured, plus 3 %, but on m4f no more than the goal. Keeps comments,
# frames, goals, and the columns of targets that were not measured.
# Usage: awk -f update.awk BUDGETS TARGET.figures...
FNR == 1 && FILENAME != ARGV[1] {
    target = FILENAME
    sub(/.*\//, "", target)
    sub(/\.figures$/, "", target)
    if (!known[target]++) targets[++columns] = target
}
FILENAME == ARGV[1] && (/^#/ || /^frame\./ || NF == 0) { print; next }
FILENAME == ARGV[1] && $1 == "figure" {
    for (i = 3; i <= NF; i++) if (!known[$i]++) targets[++columns] = $i
    next
}
FILENAME == ARGV[1] {
    goal[$1] = $2
    for (i = 3; i <= NF; i++) budget($1, targets[i - 2], $i)
    next
}
{
    if (!row[$1]++) {
        rows[++n] = $1
        longest = length($1) > longest ? length($1) : longest
    }
    budget($1, target, allowed($1, target, int($2 * 1.03)))
}
function allowed(figure, target, bytes,    most) {
    most = figure in goal ? goal[figure] : "-"
    return target == "m4f" && most != "-" && bytes > most + 0 ? most : bytes
}
function budget(figure, target, bytes) {
    most[figure, target] = bytes
    if (length(bytes) > wide[target]) wide[target] = length(bytes)
}
END {
    printf "%-*s%6s", longest + 1, "figure", "goal"
    for (c = 1; c <= columns; c++) printf "%*s", width(c), targets[c]
    print ""
    for (i = 1; i <= n; i++) {
        printf "%-*s%6s", longest + 1, rows[i], rows[i] in goal ? goal[rows[i]] : "-"
        for (c = 1; c <= columns; c++) {
            printf "%*s", width(c), (rows[i], targets[c]) in most ? most[rows[i], targets[c]] : "-"
        }
        print ""
    }
}
function width(c) { return (wide[targets[c]] > length(targets[c]) ? wide[targets[c]] : length(targets[c])) + 2 }
