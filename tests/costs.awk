# SPDX-License-Identifier: MIT
#
# Does PAGE contain the text, in which a {number} was measured? The page's number may differ by 1 %, as the linker's
# order moves single instructions; a {~number}, which is rounded, by 10 %. Prints nothing if it does, else
# "PAGE should say: ...". With update=1 prints the page with the measured numbers instead.
# Usage: awk -v text='takes {1,234} bytes' -f costs.awk PAGE
BEGIN {
    NUMBER = "[0-9]([0-9,.]*[0-9])?"
    parts = split(text, part, /[{}]/) # literal, number, literal ...
    for (i = 1; i <= parts; i++) {
        pattern = pattern (i % 2 ? escaped(part[i]) : NUMBER)
        plain = plain (i % 2 ? part[i] : bare(part[i]))
        if (i % 2 == 0 && bare(part[i]) !~ /^[0-9]/) missing = 1
    }
}
function bare(word) {
    sub(/^~/, "", word)
    return word
}
function value(word) {
    gsub(/[~,]/, "", word)
    return word + 0
}
function escaped(words,    out, i, c) {
    for (i = 1; i <= length(words); i++) {
        c = substr(words, i, 1)
        out = out (c == "\\" || c == "^" ? "\\" c : index(".[]()*+?|$/", c) ? "[" c "]" : c)
    }
    return out
}
# Are the numbers of a match near enough?
function near(words,    i, a, b, most) {
    for (i = 1; i <= parts; i++) {
        if (i % 2) {
            words = substr(words, length(part[i]) + 1)
            continue
        }
        match(words, "^" NUMBER)
        a = value(part[i])
        b = value(substr(words, 1, RLENGTH))
        most = a * (part[i] ~ /^~/ ? 0.1 : 0.01)
        if (a - b > most || b - a > most) return 0
        words = substr(words, RLENGTH + 1)
    }
    return 1
}
!missing && match($0, pattern) {
    before = substr($0, 1, RSTART - 1)
    after = substr($0, RSTART + RLENGTH)
    found = found || near(substr($0, RSTART, RLENGTH))
    if (update) $0 = before plain after
}
update { print }
END {
    if (!update && !found) print FILENAME (missing ? ": not measured: " : " should say: ") plain
}
