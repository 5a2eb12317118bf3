# SPDX-License-Identifier: MIT
#
# awk -f prototypes.awk HEADER...: the declaration of each function, a line each, without comments and attributes.
FNR == 1 { text = "" }
{
    line = $0
    was_continued = is_continued
    is_continued = line ~ /\\$/
    if (was_continued) next
    while (1) {
        if (in_comment) {
            if (!(at = index(line, "*/"))) next
            line = substr(line, at + 2)
            in_comment = 0
        }
        if (!(at = index(line, "/*"))) break
        head = substr(line, 1, at - 1)
        line = substr(line, at + 2)
        if ((at = index(line, "*/"))) line = head substr(line, at + 2)
        else {
            text = text " " head
            in_comment = 1
            next
        }
    }
}
line ~ /^#/ || line ~ /^(typedef|extern)/ || line ~ /^[{}]/ { text = ""; next }
{
    text = text " " line
    if (line !~ /;/) next
    gsub(/INVCAL_NODISCARD/, "", text)
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    if (text ~ /^[a-z][a-z0-9_ ]*[ *]invcal_[a-z0-9_]+\(.*\);$/) print text
    text = ""
}
