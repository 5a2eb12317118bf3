# SPDX-License-Identifier: MIT
#
# awk -f promises.awk PAIRS FIGURES MEASURED HEADER...
# What the headers say of each function's stack and instructions ("Stack: about N bytes", "Cost: N instructions,
# N instructions if ..."), against what `make size` and `make bench` have measured on the Cortex-M4F: to 10 % or 10.
# PAIRS: function and its figures of FIGURES, one for each number of instructions. Prints each that differs, or has
# not been measured; ends with `N passed, N failed`. With update=1 writes the headers again instead.

# The first two digits of a number; not below the unit.
function rounded(n, unit,    text) {
    while (n >= 100 * unit) unit *= 10
    n = int(n / unit + 0.5) * unit
    for (text = ""; n >= 1000; n = int(n / 1000)) text = "," substr(n + 1000000, 5) text
    return n text
}

# Puts a word in the place of word `at` of a line.
function put(file, number, at, word,    rest, head, i) {
    rest = line[file, number]
    for (i = 1; i < at; i++) {
        match(rest, /^ *[^ ]+/)
        head = head substr(rest, 1, RLENGTH)
        rest = substr(rest, RLENGTH + 1)
    }
    match(rest, /^ *[^ ]+/)
    head = head substr(rest, 1, match(rest, /[^ ]/) - 1) word
    match(rest, /^ *[^ ]+/)
    line[file, number] = head substr(rest, RLENGTH + 1)
    changed[file] = 1
}

# promise: "LINE WORD NUMBER"
function check(name, what, promise, measured,    part, most) {
    split(promise, part, " ")
    most = measured > 100 ? measured / 10 : 10
    if (measured == "") {
        print name ": " what " promised, but not measured"
        failed++
    } else if (part[3] - measured <= most && measured - part[3] <= most) passed++
    else if (update) put(FILENAME, part[1], part[2], rounded(measured, what == "stack" ? 10 : 1))
    else {
        print name ": " what ": the header says " part[3] ", measured: " measured
        failed++
    }
}

function number(text) {
    gsub(/,/, "", text)
    return text
}

# A comment: where it states numbers.
function read_comment(first, last,    n, words, i, k, w, word, row, at, costs_begin) {
    stated_stack = ""
    costs = 0
    for (k = first; k <= last; k++) {
        n = split(line[FILENAME, k], w, " ")
        for (i = 1; i <= n; i++) {
            word[++words] = w[i]
            row[words] = k
            at[words] = i
        }
    }
    # The asterisks at the left are words, too.
    for (i = 1; i <= words; i++) if (word[i] == "*") word[i] = ""
    for (i = 1; i <= words; i++) {
        if (word[i] == "") continue
        if (word[i] ~ /^instructions/ && before ~ /^[0-9][0-9,]*$/) {
            if (costs_begin) cost[++costs] = place " " number(before)
            else { print FILENAME ":" row[i] ": instructions that nothing measures"; failed++ }
        }
        if (word[i] == "Cost:") costs_begin = 1
        if (word[i] == "Stack:") costs_begin = 0
        if (two_before == "Stack:" && before == "about" && word[i] ~ /^[0-9][0-9,]*$/) {
            stated_stack = row[i] " " at[i] " " number(word[i])
        }
        two_before = before
        before = word[i]
        place = row[i] " " at[i]
    }
}

function check_function(name,    list, i, n) {
    if (stated_stack != "") check(name, "stack", stated_stack, stack[name])
    n = split(figure_of[name], list, " ")
    seen[name] = 1
    if (n != costs) {
        print name ": " costs " numbers of instructions, " n " are measured"
        failed++
        return
    }
    for (i = 1; i <= n; i++) check(name, "instructions", cost[i], figure[list[i]])
}

FNR == 1 { file++; is_open = described = 0 }
file == 1 { name = $1; $1 = ""; figure_of[name] = $0; names[name]; next }
file == 2 { figure[$1] = $2; next }
file == 3 { if ($1 == "stack") stack[$3] = $4; next }

{ line[FILENAME, FNR] = $0; lines[FILENAME] = FNR }
/^ *\/\*/ { begun = FNR; is_open = 1 }
is_open && /\*\// { read_comment(begun, FNR); is_open = 0; described = FNR; next }
is_open { next }
/^(INVCAL_NODISCARD )?[a-z].* \*?invcal_[a-z0-9_]+\(/ && described {
    match($0, /invcal_[a-z0-9_]+\(/)
    check_function(substr($0, RSTART, RLENGTH - 1))
}
{ described = 0 }

END {
    for (name in names) if (!(name in seen)) {
        print name ": not in the headers"
        failed++
    }
    for (file in changed) for (i = 1; i <= lines[file]; i++) print line[file, i] > file
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0 || passed == 0
}
