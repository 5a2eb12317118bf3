# SPDX-License-Identifier: MIT
#
# What Doxygen reads of a Markdown page: awk -f pages.awk FILE. Headings get a label, as GitHub gives
# them one; links to labels become references; links to what is not part of the manual (PAGES and the
# headers are) become plain text, for they would lead nowhere.
BEGIN {
    page = ARGV[1] # Doxygen gives it in full
    if (index(page, ENVIRON["PWD"] "/") == 1) {
        page = substr(page, length(ENVIRON["PWD"]) + 2)
    }
    folder = page ~ /\// ? page : ""
    sub(/[^\/]*$/, "", folder)
}

/^```/ { is_code = !is_code }
is_code { print; next }

/^##/ {
    text = $0
    sub(/^#+ */, "", text)
    print $0 " {#" label(page, slug(text)) "}"
    next
}

{ print names(links($0)) }

# A name of the library alone in a code span becomes a link.
function names(text,    out) {
    while (match(text, /`(invcal|INVCAL)_[A-Za-z0-9_]+`/)) {
        out = out substr(text, 1, RSTART - 1) "<tt>#" substr(text, RSTART + 1, RLENGTH - 2) "</tt>"
        text = substr(text, RSTART + RLENGTH)
    }
    return out text
}

function slug(text) {
    text = tolower(text)
    gsub(/[^a-z0-9 _-]/, "", text)
    gsub(/ /, "-", text)
    return text
}

# Unique among all pages.
function label(path, name) {
    sub(/^.*port\//, "", path)
    gsub(/[^A-Za-z0-9]+/, "-", path)
    return path "-" name
}

# A path from the top of the repository, without `..`.
function plain(path) {
    while (sub(/[^\/]+\/\.\.\//, "", path)) {
    }
    return path
}

function links(text,    out, link, words, target, name, hash) {
    while (match(text, /\[[^]]*\]\([^)]*\)/)) {
        link = substr(text, RSTART, RLENGTH)
        out = out substr(text, 1, RSTART - 1)
        is_picture = substr(out, length(out)) == "!"
        text = substr(text, RSTART + RLENGTH)
        hash = index(link, "](")
        words = substr(link, 2, hash - 2)
        target = substr(link, hash + 2, length(link) - hash - 2)
        out = out (is_picture || target ~ /^https?:/ ? link : resolved(words, target))
    }
    return out text
}

function resolved(words, target,    hash, name, path) {
    hash = index(target, "#")
    name = hash ? substr(target, hash + 1) : ""
    path = hash ? substr(target, 1, hash - 1) : target
    path = path == "" ? page : plain(folder path)
    if (name != "") {
        return "[" words "](@ref " label(path, name) ")"
    }
    if (sub(/^include\/invcal\//, "", path)) {
        return "[" words "](@ref " path ")"
    }
    if (path ~ /\.md$/) {
        return "[" words "](" path ")"
    }
    return words
}
