# SPDX-License-Identifier: MIT
#
# awk -v part=src|host -v unmeasured=N -v failing=N -f coverage.awk FILE...
# FILE: what `llvm-cov show -show-branches=count -show-mcdc` prints of some sources, one FILE for each
# build. Something is covered if any of them covers it. Prints what is not, `FILE:LINE: what`, then a
# table, and at the end the results of the gates; the last line is `N passed, N failed`.
# unmeasured: how many expressions have MC/DC that the compiler could not measure. failing: how many suites failed.
#
# A gap in src/ that cannot be closed is explained at the end of its line:
#     /* uncovered: why */
# Such a comment where nothing is missing is a failure, too.

function base(path) {
    sub(/.*\//, "", path)
    return path
}

# There is a thing `at` (a line, one side of a branch, a condition) of this kind; hit: this build covers it.
function see(kind, at, line, hit) {
    at = kind " " file " " at
    if (!(at in covered)) {
        order[++things] = at
        covered[at] = 0
        where[at] = file SUBSEP line
    }
    if (hit) {
        covered[at] = 1
    }
}

/^\/.*\.[ch]:$/ {
    file = base(substr($0, 1, length($0) - 1))
    if (!(file in known)) {
        known[file] = 1
        files[++modules] = file
    }
    next
}

# "  |  Branch (34:26): [True: 256k, False: 51.3k]", once for each instance of a header's code.
/^  \|  Branch \(/ {
    if ($0 ~ /Folded/) {
        next # a constant
    }
    split($3, place, /[(:)]/)
    side = $0
    sub(/.*True: /, "", side)
    see("branch", place[2] ":" place[3] " true", place[2], side + 0 > 0)
    sub(/.*False: /, "", side)
    see("branch", place[2] ":" place[3] " false", place[2], side + 0 > 0)
    next
}
/^  \|     Condition C[0-9]+ --> \(/ {
    split($5, place, /[(:)]/)
    condition[substr($3, 2)] = place[2] SUBSEP place[3]
    next
}
/^  \|  C[0-9]+-Pair: / {
    if ($0 !~ /constant folded/) {
        number = substr($2, 2)
        sub(/-.*/, "", number)
        split(condition[number], place, SUBSEP)
        see("MC/DC", place[1] ":" place[2], place[1], $0 !~ /not covered/)
    }
    next
}

# "   34|   308k|    source"
/^ *[0-9]+\|/ {
    split($0, field, "|")
    line = field[1] + 0
    text[file SUBSEP line] = $0
    if (field[2] ~ /[0-9]/) {
        see("line", line, line, field[2] + 0 > 0)
    }
    if ($0 ~ /\/\* uncovered: .* \*\/$/) {
        explained[file SUBSEP line] = 1
    }
}

function percent(kind, of) {
    return total[kind, of] ? 100 * (total[kind, of] - missed[kind, of]) / total[kind, of] : 100
}

function cells(of) {
    line = sprintf("%-28s", of)
    for (k = 1; k <= kinds; k++) {
        of_kind = sprintf("%d/%d", total[kind[k], of] - missed[kind[k], of], total[kind[k], of])
        line = line sprintf(" %11s %6.2f", of_kind, percent(kind[k], of))
    }
    return line
}

function gate(text, good) {
    print "coverage: " text ": " (good ? "PASS" : "FAIL")
    if (good) {
        passed++
    } else {
        failed++
    }
}

END {
    kinds = split(part == "src" ? "line branch MC/DC" : "line", kind, " ")
    for (i = 1; i <= things; i++) {
        split(order[i], word, " ")
        split(where[order[i]], place, SUBSEP)
        total[word[1], word[2]]++
        total[word[1], part]++
        if (!covered[order[i]]) {
            missed[word[1], word[2]]++
            missed[word[1], part]++
            if (where[order[i]] in explained) {
                explained[where[order[i]]]++
            } else {
                open[word[1]]++
                if (part == "src") {
                    print place[1] ":" word[3] ": " word[1] (word[4] ? " never " word[4] : "")
                }
            }
        }
    }
    for (at in explained) {
        split(at, place, SUBSEP)
        explanations++
        if (explained[at] == 1) {
            print place[1] ":" place[2] ": explains a gap that is not there"
            stale++
        }
    }
    printf "%-28s", (part == "src" ? "module" : "file")
    for (k = 1; k <= kinds; k++) {
        printf " %18s", (kind[k] == "MC/DC" ? kind[k] : kind[k] (kind[k] == "branch" ? "es" : "s"))
    }
    print ""
    for (i = 1; i <= modules; i++) {
        if (total["line", files[i]] && (part == "src" || percent("line", files[i]) < 95)) {
            print cells(files[i])
        }
    }
    print cells(part)
    if (part == "src") {
        gate("the suites pass", failing == 0)
        gate("all lines of src/, but for what is explained", total["line", part] && !open["line"])
        gate("all branches of src/, but for what is explained", total["branch", part] && !open["branch"])
        gate(sprintf("MC/DC of src/, %.2f %%, at least 98 %%", percent("MC/DC", part)),
             total["MC/DC", part] && percent("MC/DC", part) >= 98 && unmeasured == 0)
        gate(sprintf("gaps: %d lines explain theirs, none is left unexplained", explanations + 0),
             !stale && !open["line"] && !open["branch"] && !open["MC/DC"])
    } else {
        gate(sprintf("lines of port/host, %.2f %%, at least 95 %%", percent("line", part)),
             total["line", part] && percent("line", part) >= 95)
    }
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0
}
