# SPDX-License-Identifier: MIT
#
# Rewrites the budgets: what was measured, plus 3 %. Keeps comments, frames, and the columns of targets
# that were not measured.
# Usage: awk -f update.awk BUDGETS TARGET.figures...
FNR == 1 && FILENAME != ARGV[1] {
    target = FILENAME
    sub(/.*\//, "", target)
    sub(/\.figures$/, "", target)
    fresh[target] = 1
    if (!known[target]++) targets[++columns] = target
}
FILENAME == ARGV[1] && (/^#/ || /^frame\./ || NF == 0) { print; next }
FILENAME == ARGV[1] && $1 == "figure" {
    for (i = 2; i <= NF; i++) if (!known[$i]++) targets[++columns] = $i
    next
}
FILENAME == ARGV[1] {
    old[++olds] = $1
    for (i = 2; i <= NF; i++) former[$1, targets[i - 1]] = $i
    next
}
{
    add($1)
    budget($1, target, int($2 * 1.03))
}
function add(figure) {
    if (row[figure]++) return
    rows[++n] = figure
    longest = length(figure) > longest ? length(figure) : longest
}
function budget(figure, target, bytes) {
    most[figure, target] = bytes
    if (length(bytes) > wide[target]) wide[target] = length(bytes)
}
END {
    for (i = 1; i <= olds; i++) for (c = 1; c <= columns; c++) {
        if (fresh[targets[c]] || !((old[i], targets[c]) in former)) continue
        if (former[old[i], targets[c]] != "-") add(old[i])
        budget(old[i], targets[c], former[old[i], targets[c]])
    }
    printf "%-*s", longest, "figure"
    for (c = 1; c <= columns; c++) printf "%*s", width(c), targets[c]
    print ""
    for (i = 1; i <= n; i++) {
        printf "%-*s", longest, rows[i]
        for (c = 1; c <= columns; c++) {
            printf "%*s", width(c), (rows[i], targets[c]) in most ? most[rows[i], targets[c]] : "-"
        }
        print ""
    }
}
function width(c) { return (wide[targets[c]] > length(targets[c]) ? wide[targets[c]] : length(targets[c])) + 2 }
