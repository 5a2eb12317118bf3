# SPDX-License-Identifier: MIT
#
# Every loop ends after a number of steps that is known in advance. If it counts up to a bound, or down
# from it, the bound is a constant, the counter of an enclosing loop, or something whose maximum is in
# bounds.txt. Any other loop has a comment `at most ...` on its first line or on the line above. There
# is no goto. Prints what is wrong.
# Usage: awk -f loops.awk BOUNDS SOURCE...
#     BOUNDS  lines "module | bound | at most"
FNR == 1 { file++ }
file == 1 && (/^#/ || NF == 0) { next }
file == 1 {
    if (split($0, part, / *\| */) != 3 || part[3] == "") {
        print FILENAME ":" FNR ": not `module | bound | at most`"
    }
    stated[part[1], part[2]] = FILENAME ":" FNR
    next
}
FNR == 1 {
    module = FILENAME
    sub(/.*\//, "", module)
    sub(/\..*/, "", module)
}
{
    code = $0
    gsub(/"[^"]*"|\/\*.*/, "", code)
    if (code ~ /^ *\*/) code = ""
    if (code ~ /(^|[^a-z_])goto[^a-z_]/) say("goto")
    if (match(code, /^ *}/)) closed(RLENGTH)
    if (code ~ /^ *(while \(|do \{)/) commented()
    else if (code ~ /^ *for \(/) counted()
    else if (code ~ /(^|[^a-z_])(for|while) *\(/ && code !~ /^ *} while/) say("a loop that does not begin its line")
    above = $0
}

function say(text) { print FILENAME ":" FNR ": " text ": " $0 }

function commented() {
    if ($0 !~ /\/\* at most / && above !~ /at most [^*]*\*\/$/) say("a loop without /* at most ... */")
}

# A loop that begins in this column, and any in it, is over.
function closed(column,    d) {
    for (d in counter_at) if (d + 0 >= column) delete counter_at[d]
}

function is_around(name, column,    d) {
    for (d in counter_at) if (d + 0 < column && counter_at[d] == name) return 1
    return 0
}

# If the loop counts, sets counter and returns the bound: up, while "i < BOUND", or down, from
# "unsigned i = BOUND".
function bound_of(first, while_true, step,    n, i, part, up) {
    counter = step
    sub(/, .*/, "", counter)
    up = sub(/\+\+$|^\+\+| \+= [0-9]+$/, "", counter)
    n = split(while_true, part, / && /)
    for (i = 1; up && i <= n; i++) {
        if (index(part[i], counter " <") == 1) {
            sub(/.* <=? /, "", part[i])
            return part[i]
        }
    }
    counter = while_true
    if (sub(/-- > 0$/, "", counter) && step == "" || sub(/ > 0$/, "", counter) && step == counter "--") {
        if (sub("^unsigned " counter " = ", "", first)) return first
    }
    return ""
}

function counted(    part, bound, column) {
    column = match(code, /for/)
    sub(/.*for \(/, "", code)
    sub(/\) *\{? *$/, "", code)
    if (split(code, part, /; ?/) != 3) {
        say("the head of a loop spans several lines")
        return
    }
    bound = bound_of(part[1], part[2], part[3])
    if (bound == "") commented()
    else if (bound !~ /^([0-9A-Z_ +*\/()?:u]|sizeof [a-z_]+)+$/ && !is_around(bound, column)) {
        if ((module, bound) in stated) used[module, bound] = 1
        else say("no maximum of `" bound "` in bounds.txt")
    }
    counter_at[column] = counter
}

END { for (key in stated) if (!(key in used)) print stated[key] ": no loop has this bound" }
