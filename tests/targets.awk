# SPDX-License-Identifier: MIT
#
# Summarizes what the images of the targets printed. Arguments: the logs, BUILD/TARGET/IMAGE.log,
# those of a target in a row, each with a last line `exit status N`; of the digest compared.log, what
# digest/compare.awk says. Exits with 1 if anything failed.

function judge_digest() {
    tests[target]++
    passed[target] += same
    failed[target] += !same
    digest[target] = same ? "same" : "differs"
    return !same
}

# A suite gives its result as "N Tests F Failures I Ignored" (Unity). One that does not has crashed;
# one that ends badly after that has failed, too: either counts as one failure.
function judge_suite() {
    if (!said || (status && !failures)) failures++
    tests[target] += count
    passed[target] += said ? count - failures - ignored : 0
    failed[target] += failures
    skipped[target] += ignored
    return failures
}

function judge() {
    if (log_name == "") return
    if (image == "compared" ? judge_digest() : judge_suite()) printf "== %s %s\n%s", target, image, shown
}

function begin(    part, n) {
    judge()
    log_name = FILENAME
    n = split(FILENAME, part, "/")
    target = part[n - 1]
    image = part[n]
    sub(/\.log$/, "", image)
    if (!(target in failed)) { order[++targets] = target; failed[target] = 0 }
    shown = ""
    said = count = failures = ignored = status = same = 0
}

FNR == 1 { begin() }
/^exit status [0-9]+$/ {
    status = $3
    shown = shown $0 "\n"
    next
}
image == "compared" {
    same = $0 == "same"
    shown = $0 "\n"
    next
}
/:IGNORE/ {
    reason = $0
    if (!sub(/.*:IGNORE: /, "", reason)) reason = "no reason given"
    if (!why[target, reason]++) reasons[target] = reasons[target] reason "\n"
    next
}
/^[0-9]+ Tests [0-9]+ Failures [0-9]+ Ignored/ { said = 1; count = $1; failures = $3; ignored = $5 }
!/:PASS$/ { shown = shown $0 "\n" }

END {
    judge()
    printf "%-20s %6s %6s %6s %7s  %s\n", "target", "tests", "passed", "failed", "skipped", "digest"
    for (i = 1; i <= targets; i++) {
        t = order[i]
        printf "%-20s %6d %6d %6d %7d  %s\n", t, tests[t], passed[t], failed[t], skipped[t], digest[t]
        all_passed += passed[t]
        all_failed += failed[t]
    }
    for (i = 1; i <= targets; i++) {
        t = order[i]
        n = split(reasons[t], reason_list, "\n")
        for (k = 1; k < n; k++)
            printf "skipped on %s: %d, %s\n", t, why[t, reason_list[k]], reason_list[k]
    }
    print all_passed + 0 " passed, " all_failed + 0 " failed"
    exit all_failed > 0 || targets == 0
}
