# SPDX-License-Identifier: MIT
#
# Compares figures of a page with those of the JSON of the same run, each to its last digit; other scripts say which:
#
#     awk -f figures.awk -f page_json.awk result.json page.html
#
# The first file becomes json[NAME]. count: figures compared. Prints what differs, and sets wrong to 1. ins=1: units of an
# INS.
function strip(text) { gsub(/[][",{} ]/, "", text); return text }
# A figure of the page, with its decimals or digits.
function same(text, value, what,    decimals, d) {
    gsub(/−/, "-", text)
    gsub(/ /, " ", text) # no-break spaces
    sub(/ .*/, "", text)
    if (text !~ /^[-+]?[0-9]/ || value == "" || value == "null") {
        print what ": '" text "' beside '" value "'"
        wrong = 1
        return
    }
    decimals = match(text, /\./) ? length(text) - RSTART : 0
    d = text - value
    if (!(d <= 0.501 * 10 ^ -decimals && d >= -0.501 * 10 ^ -decimals)) {
        print what ": " text " is not " value
        wrong = 1
    }
    count++
}
# "VALUE ± SPREAD UNIT"
function same_spread(cell, value, spread, what,    part) {
    gsub(/ /, " ", cell) # no-break spaces
    if (index(cell, "±") == 0) {
        print what ": no ± in " cell
        wrong = 1
        return
    }
    split(cell, part, / *± */)
    same(part[1], value, what)
    same(part[2], spread, "± of " what)
}
# delta, dk, gamma one after the other: parameter 1 ... 9 of the member at a path.
function nine(path, r) { return json[path member[int((r - 1) / 3)] "," (r - 1) % 3 + 1] }
BEGIN {
    split("x y z", axes, " ")
    split("offset scale angle", kind, " ")
    split("xy xz zy", pairs, " ")
    member[0] = "delta"; member[1] = "dk"; member[2] = "gamma"
    for (r = 1; r <= 9; r++) {
        k = int((r - 1) / 3)
        number[kind[k + 1] " " (k < 2 ? axes[r - 3 * k] : pairs[r - 6])] = r
        unit[r] = ins ? (k < 2 ? 1e6 : 206264.80624709636) : k == 0 ? 1e3 : k == 1 ? 1e2 : 57.29577951308232
    }
    parts = ins ? 1e6 : 1e3
}
FNR == 1 { file++ }
file == 1 {
    match($0, /^ */)
    depth = RLENGTH / 2
    if (/\[$/) item[depth + 1] = 0
    key = $0
    if (sub(/": .*/, "", key)) path[depth] = strip(key) "."
    else if (/\{$/ || $0 ~ /^ *[-0-9]/) path[depth] = ++item[depth] "."
    name = ""
    for (i = 1; i <= depth; i++) name = name path[i]
    sub(/\.$/, "", name)
    value = $0
    sub(/^[^:]*: /, "", value)
    if (value ~ /^\[./) {
        n = split(value, list, ",")
        for (i = 1; i <= n; i++) json[name "," i] = strip(list[i])
    } else json[name] = strip(value)
    next
}
