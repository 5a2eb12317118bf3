# SPDX-License-Identifier: MIT
#
# Every figure of a report that is also in the JSON of the same run has the same value, to its last digit; ± is 95 %:
#
#     awk -f figures.awk -f page_json.awk result.json page.html
#
# Prints how many figures it compared, or what differs. (For a stand: stand_page.awk.)
# The first number after a text.
function behind(text, words,    at) {
    at = index(text, words)
    if (!at) return ""
    text = substr(text, at + length(words))
    match(text, /[-+]?[0-9.]+(e[-+]?[0-9]+)?/)
    return substr(text, RSTART, RLENGTH)
}
/<h2>/ { section = $0; gsub(/<[^>]*>/, "", section) }
/<p class="answer/ {
    line = $0
    gsub(/<[^>]*>/, "", line)
    split(line, word, " ")
    if (word[2] != json["pass.answer"] ":") { print "answer: " line; wrong = 1 }
    if (line ~ / within /)
        same(behind(line, " within "), json["accuracy95"] / json["need.wanted"] * behind(line, " of "), "need")
    answers++
}
/standard deviations\.<\/p>/ { same(behind($0, "parameters, "), json["interval95"], "interval95") }
section == "The nine parameters" && /^<tr( class="bad")?><th scope="row"/ {
    is_bad = /class="bad"/
    gsub(/<\/t[hd]>/, "|"); gsub(/<[^>]*>/, "")
    n = split($0, cell, "|") - 1
    r = number[cell[1]]
    spread = json["interval95"] * nine("sigma.", r)
    same_spread(cell[2], unit[r] * nine("", r), unit[r] * spread, cell[1])
    at = 3
    if (("pass.limit.delta,1") in json) {
        same(cell[3], unit[r] * nine("pass.limit.", r), "limit of " cell[1])
        same(cell[4], 100 * nine("pass.used.", r), "use of " cell[1])
        failed = nine("pass.used.", r) > 1
        if (failed != is_bad) { print cell[1] ": red " is_bad ", failed " failed; wrong = 1 }
        at = 5
    }
    if (r <= 3) {
        same_spread(cell[at], json["offset," r], json["interval95"] * json["sigma.offset," r], cell[1] " as it reads")
    } else if (r <= 6) {
        per_unit = 1 / json["nominal.lsb," r - 3]
        same_spread(cell[at], per_unit * (1 + nine("", r)), (per_unit < 0 ? -per_unit : per_unit) * spread,
            cell[1] " as it reads")
    }
}
/<dt>/ {
    name_of_figure = $0
    gsub(/<[^>]*>/, "", name_of_figure)
}
/^<dd>/ {
    line = $0
    gsub(/<[^>]*>/, "", line)
    if (name_of_figure == "noise of a position mean") same(line, parts * json["noise"] / json["gravity"], "noise")
    if (name_of_figure ~ /^positions/ && section != "How it was made") same(line, json["positions"], "positions")
    if (name_of_figure == "condition") same(line, json["condition"], "condition")
    if (name_of_figure == "degrees of freedom") same(line, json["degrees_of_freedom"], "degrees of freedom")
    if (name_of_figure == "field") same(line, json["gravity"], "field")
}
section == "Temperature" && /^<tr><th scope="row"/ {
    gsub(/<\/t[hd]>/, "|"); gsub(/<[^>]*>/, "")
    split($0, cell, "|")
    r = number[cell[1]]
    per_kelvin = r > 3 && r < 7 ? 1e6 : unit[r]
    same_spread(cell[2], per_kelvin * nine("thermal.slope.", r),
        json["interval95"] * per_kelvin * nine("thermal.slope_sigma.", r), "slope of " cell[1])
}
/^<dd>.* → .* m?µ?g<\/dd>/ && !seen++ {
    gsub(/<[^>]*>/, "")
    split($0, word, " ")
    same(word[1], parts * json["residual_before"], "rms before")
    same(word[3], parts * json["residual_rms"], "rms after")
}
/Left out: position/ {
    gsub(/<[^>]*>/, "")
    k = ++left
    e = json["rejected_excess." k]
    same(behind($0, "position "), json["rejected," k], "number left out")
    same(behind($0, "reads "), parts * (e < 0 ? -e : e), "its error")
    if ((e < 0) != / too little\./) { print "its sign: " $0; wrong = 1 }
}
section == "The positions in numbers" && /^<tr><th scope="row"/ {
    gsub(/<\/t[hd]>/, "|"); gsub(/<[^>]*>/, "")
    n = split($0, cell, "|") - 1
    last = cell[n] ~ /left out|^$/ ? n - 1 : n
    after = cell[last]
    gsub(/−/, "-", after)
    if (cell[n] == "left out") {
        same(after, parts * json["rejected_excess." ++row_left], "excess in the table")
        next
    }
    squares += after * after
    kept++
    if (cell[1] == json["residual_worst"]) same(after + 0 < 0 ? -after : after, parts * json["residual_max"], "largest residual")
}
END {
    if (kept && kept == json["positions"] - left && !json["degree"]) {
        rms = sqrt(squares / kept)
        if (rms > 0) same(sprintf(ins ? "%.1f" : "%.3f", rms), parts * json["residual_rms"], "rms of the table")
    }
    if ((("pass.answer") in json) != answers + 0) { print "answers: " answers + 0; wrong = 1 }
    if (!wrong) print count + 0
}
