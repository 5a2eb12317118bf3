# SPDX-License-Identifier: MIT
#
# Every figure of the section "At the stand" of a page is that of the JSON of the same run, to its last digit:
#
#     awk -f stand_page.awk result.json page.html
#
# Says how many figures it has compared, or what differs.
function strip(text) { gsub(/[][",{} ]/, "", text); return text }
# A figure of the page, with the decimals that it has.
function same(text, value, what,    decimals, d) {
    sub(/−/, "-", text)
    if (text !~ /^[-+]?[0-9]/) { print what ": " text " is no figure"; wrong = 1; return }
    decimals = match(text, /\./) ? length(text) - RSTART : 0
    d = text - value
    if (!(d <= 0.501 * 10 ^ -decimals && d >= -0.501 * 10 ^ -decimals)) {
        print what ": " text " is not " value
        wrong = 1
    }
    count++
}
# Its ± is 95 %: so many sigma of the JSON.
function same_with_sigma(cell, value, sigma, wide, what,    part) {
    split(cell, part, / */)
    same(part[1], value, what)
    if (part[2] != "±") { print what ": no sigma in " cell; wrong = 1 }
    same(part[3], wide * sigma, "± of " what)
}
# delta, dk, gamma one behind the other: parameter 1 ... 9 of what stands at a path.
function nine(path, r) { return json[path member[int((r - 1) / 3)] "," (r - 1) % 3 + 1] }
BEGIN {
    split("x y z", axes, " ")
    split("offset scale angle", kind, " ")
    split("xy xz zy", pairs, " ")
    member[0] = "delta"; member[1] = "dk"; member[2] = "gamma"
    for (r = 1; r <= 9; r++) {
        k = int((r - 1) / 3)
        number[kind[k + 1] " " (k < 2 ? axes[r - 3 * k] : pairs[r - 6])] = r
        unit[r] = k == 0 ? 1e3 : k == 1 ? 1e2 : 57.29577951308232
    }
    # which coefficients tell a parameter: group, first, sign, second, sign
    split("2 3 -1 0 0 3 3 1 0 0|1 2 1 0 0 3 2 1 0 0|1 3 1 0 0 2 2 -1 0 0|" \
        "2 1 1 4 -1 3 1 1 4 -1|1 1 1 4 1 3 1 1 4 1|1 1 1 4 -1 2 1 1 4 1", tells, "|")
}
FNR == 1 { file++ }
file == 1 {
    match($0, /^ */)
    depth = RLENGTH / 2
    if (/\[$/) item[depth + 1] = 0
    key = $0
    if (sub(/": .*/, "", key)) path[depth] = strip(key) "."
    else if (/\{$/) path[depth] = ++item[depth] "."
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
/<h2>At the stand</ { on = 1 }
/<\/section>/ { on = 0 }
!on { next }
/^<tr><th scope="row"/ {
    gsub(/<\/t[hd]>/, "|"); gsub(/<[^>]*>/, "")
    n = split($0, cell, "|") - 1
    if (cell[1] ~ /^about /) {
        i = index("xyz", substr(cell[1], 7))
        same_with_sigma(cell[2], json["stand.mounting," i], json["stand.sigma," i], json["stand.interval95"], cell[1])
    } else if (cell[1] in number && n == 5) {
        r = number[cell[1]]
        j1 = nine("stand.vertical.", r)
        lengths = nine("", r)
        sigma = nine("stand.vertical_sigma.", r)
        same_with_sigma(cell[2], unit[r] * j1, unit[r] * sigma, json["stand.vertical_interval95"], cell[1] " by J1")
        same(cell[3], unit[r] * lengths, cell[1] " by lengths")
        same(cell[4], unit[r] * (j1 - lengths), cell[1] " difference")
        same(cell[5], (j1 - lengths) / sigma, cell[1] " over sigma")
    } else if (cell[1] in number) {
        r = number[cell[1]]
        same_with_sigma(cell[2], unit[r] * nine("stand.series_parameters.", r),
            unit[r] * nine("stand.series_sigma.", r), json["stand.series_interval95"], cell[1] " by the series")
        if (r > 6) next
        split(tells[r], t, " ")
        for (i = 0; i < 2; i++) {
            g = "stand.series." t[5 * i + 1] ".coefficients,"
            told = t[5 * i + 3] * json[g t[5 * i + 2]] + (t[5 * i + 5] ? t[5 * i + 5] * json[g t[5 * i + 4]] : 0)
            same(cell[4 + i], unit[r] * told, cell[1] " of a group")
        }
        same_with_sigma(cell[6], unit[r] * json["stand.closure," r], unit[r] * json["stand.closure_sigma," r],
            json["stand.series_interval95"], "closure of " cell[1])
        same(cell[7], json["stand.closure," r] / json["stand.closure_sigma," r], "closure over sigma")
    } else if (cell[1] ~ /positions$/) {
        g = "stand.series." ++group
        same(substr(cell[1], index(cell[1], ", ") + 2) + 0, json[g ".positions"], "positions of a group")
        for (i = 1; i <= 5; i++)
            same_with_sigma(cell[i + 1], 1e6 * json[g ".coefficients," i], 1e6 * json[g ".sigma," i],
                json["stand.series_interval95"], "a coefficient")
    }
}
/^<p>All six closures/ {
    split($0, word, " ")
    same(word[7], json["stand.closure_f"], "F")
    same(word[11], json["stand.closure_dof"], "degrees of freedom")
    match($0, /in [0-9.e+-]* %/)
    percent = substr($0, RSTART + 3)
    sub(/ .*/, "", percent)
    same(percent, 100 * json["stand.closure_chance"], "chance")
}
/agree to [0-9.]* mrad/ {
    match($0, /to [0-9.]*/)
    same(substr($0, RSTART + 3, RLENGTH - 3), 1000 * json["stand.scatter"] / 57.29577951308232, "scatter")
}
/^<p>Misset: .* mrad/ {
    match($0, /by [0-9.]* mrad/)
    same(substr($0, RSTART + 3, RLENGTH - 8), 1000 * json["stand.misset.1.angle"] / 57.29577951308232, "misset")
    match($0, /alpha by [-+0-9.]*/)
    same(substr($0, RSTART + 9, RLENGTH - 9), json["stand.misset.1.alpha"], "misset in alpha")
}
END { if (!wrong) print count + 0 }
