# SPDX-License-Identifier: MIT
#
# The tables of one target, each figure next to its budget and goal; then "FAIL ..." for each that
# exceeds one, and "N passed, N failed".
# Usage: awk -v target=m4f -v V=1 -f report.awk BUDGETS GOALS MEASURED FIGURES DEPTHS
#     V       1: also every function
#     DEPTHS  "function bytes", what depth.c measured
FNR == 1 { file++ }
/^#/ || NF == 0 { next }

file == 1 && $1 == "figure" { for (i = 2; i <= NF; i++) if ($i == target) column = i; next }
file == 1 && $1 !~ /^frame\./ && column { budget[$1] = $column }
file == 1 { next }
file == 2 && $1 == target { goal[$2] = $3; goal_of[$2] = $4 }
file == 2 { next }

file == 3 && $1 == "fault" { sub(/^fault /, ""); fail($0); next }
file == 3 && $1 == "stack" {
    stack[$3] = $4
    path[$3] = $6
    names[++functions] = $3
    if ($4 > deepest[$2]) {
        deepest[$2] = $4
        who[$2] = substr($3, 8)
    }
    if ($5) plus[$2] = plus[$3] = "+"
    next
}
file == 3 && $1 == "part" { part[++parts] = sprintf("%-12s%7s  %s", $2, $3, $4); next }
file == 3 { measured[$1] = $2; next }
file == 4 { check($1, $2); order[++figures] = $1; next }
file == 5 { depth($1, $2) }

function fail(text) { failure[++failed] = text }

function check(what, value) {
    figure[what] = value
    if (!column) return
    if (!(what in budget) || budget[what] == "-") fail(what " is " value " and has no budget: make size UPDATE=1")
    else if (value > budget[what] + 0) fail(what " is " value ", at most " budget[what])
    else passed++
}

# The worst case is right if no measurement is deeper, and useful if it is not far above them.
function depth(name, bytes) {
    depths[++measures] = sprintf("%-28s%8d%12d", name, bytes, stack[name])
    if (bytes > stack[name]) fail(name " took " bytes " of stack, computed " stack[name] + 0)
    else if (bytes < 2 / 3 * stack[name]) fail(name " took only " bytes " of stack, computed " stack[name])
    else passed++
}

function module_table(    i, k, kind, module, total) {
    split("text rodata data bss", kind, " ")
    printf "\n%-12s%7s%8s%6s%6s%8s%8s%8s %8s  %s\n", "module", "text", "rodata", "data", "bss", "flash",
        "at most", "stack", "at most", "deepest"
    for (i = 1; i <= figures; i++) {
        if (order[i] !~ /^module\./) continue
        module = substr(order[i], 8)
        printf "%-12s%7d%8d%6d%6d%8d%8s%8d%-1s%8s  %s\n", module, measured["text." module],
            measured["rodata." module], measured["data." module], measured["bss." module],
            figure["module." module], budget["module." module], deepest[module], plus[module],
            budget["stack." module], who[module]
        for (k = 1; k <= 4; k++) total[k] += measured[kind[k] "." module]
    }
    printf "%-12s%7d%8d%6d%6d%8d%8s\n", "all", total[1], total[2], total[3], total[4],
        figure["flash"], budget["flash"]
}

function figure_table(    i) {
    printf "\n%-28s%8s%12s%12s\n", "figure", "is", "at most", "goal"
    for (i = 1; i <= figures; i++) {
        if (order[i] ~ /^(flash$|module|stack)/) continue
        printf "%-28s%8d%12s%12s\n", order[i], figure[order[i]], budget[order[i]], goal[order[i]]
    }
}

# A number, followed by frames, in lines of 100 characters.
function wrap(line, list,    frame, i, n) {
    n = split(list, frame, ",")
    for (i = 1; i <= n; i++) {
        if (length(line) + 1 + length(frame[i]) > 100) {
            print line
            line = "      "
        }
        line = line " " frame[i]
    }
    print line
}

END {
    if (!column) fail("has no budgets: make size UPDATE=1")
    for (what in budget) {
        if (budget[what] != "-" && figure[what] == "") fail(what " has a budget, but was not measured")
    }
    for (what in goal) {
        if (goal_of[what] != "") goal[what] = int(goal[what] * figure[goal_of[what]])
        if (figure[what] == "") fail(what " has a goal, but was not measured")
        else if (figure[what] > goal[what]) fail(what " is " figure[what] ", its goal at most " goal[what])
        else passed++
    }
    module_table()
    figure_table()
    printf "\n%-28s%8s%12s\n", "stack", "measured", "computed"
    for (i = 1; i <= measures; i++) print depths[i]
    if (V) {
        printf "\n%-12s%7s  %s\n", "program", "text", "function"
        for (i = 1; i <= parts; i++) print part[i]
        print "\nstack of every public function, and the frames it is made of"
        for (i = 1; i <= functions; i++) {
            wrap(sprintf("%5d%-1s", stack[names[i]], plus[names[i]]), path[names[i]])
        }
    }
    print ""
    for (i = 1; i <= failed; i++) print "FAIL " target ": " failure[i]
    print passed + 0 " passed, " failed + 0 " failed"
}
