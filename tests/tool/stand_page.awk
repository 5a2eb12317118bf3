# SPDX-License-Identifier: MIT
#
# Every figure in the section "At the stand" of a page is that of the JSON of the same run, to its last digit:
#
#     awk -f figures.awk -f stand_page.awk result.json page.html
#
# Prints how many figures it compared, or what differs.
function same_with_sigma(cell, value, sigma, wide, what) { same_spread(cell, value, wide * sigma, what) }
BEGIN {
    # which coefficients determine a parameter: group, first, sign, second, sign
    split("2 3 -1 0 0 3 3 1 0 0|1 2 1 0 0 3 2 1 0 0|1 3 1 0 0 2 2 -1 0 0|" \
        "2 1 1 4 -1 3 1 1 4 -1|1 1 1 4 1 3 1 1 4 1|1 1 1 4 -1 2 1 1 4 1", terms, "|")
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
            unit[r] * nine("stand.series_sigma.", r), json["stand.series_interval95"], cell[1] " from series")
        if (r > 6) next
        split(terms[r], t, " ")
        for (i = 0; i < 2; i++) {
            g = "stand.series." t[5 * i + 1] ".coefficients,"
            of_group = t[5 * i + 3] * json[g t[5 * i + 2]] + (t[5 * i + 5] ? t[5 * i + 5] * json[g t[5 * i + 4]] : 0)
            same(cell[4 + i], unit[r] * of_group, cell[1] " of a group")
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
/agree within [0-9.]* mrad/ {
    match($0, /within [0-9.]*/)
    same(substr($0, RSTART + 7, RLENGTH - 7), 1000 * json["stand.scatter"] / 57.29577951308232, "scatter")
}
/^<p>Misset: .* mrad/ {
    match($0, /by [0-9.]* mrad/)
    same(substr($0, RSTART + 3, RLENGTH - 8), 1000 * json["stand.misset.1.angle"] / 57.29577951308232, "misset")
    match($0, /alpha by [-+0-9.]*/)
    same(substr($0, RSTART + 9, RLENGTH - 9), json["stand.misset.1.alpha"], "misset in alpha")
}
END { if (!wrong) print count + 0 }
