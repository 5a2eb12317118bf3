# SPDX-License-Identifier: MIT
#
# Prepares a Markdown page for Doxygen: awk -f pages.awk FILE. Headings get labels as on GitHub; links
# to labels and headers become references; links to files that are neither headers nor pages become
# plain text, as they would be dead.
BEGIN {
    page = ARGV[1] # Doxygen passes the full path
    if (index(page, ENVIRON["PWD"] "/") == 1) {
        page = substr(page, length(ENVIRON["PWD"]) + 2)
    }
    folder = page ~ /\// ? page : ""
    sub(/[^\/]*$/, "", folder)
}

/^```/ { is_code = !is_code; print; next }
is_code { print; next }

FNR > 1 && /^#/ {
    text = $0
    sub(/^#+ */, "", text)
    # Headings of the index are groups of the navigation already (layout.awk), so not sections.
    print (page == "port/manual/README.md" ? "<h1>" text "</h1>" : $0 " {#" label(page, slug(text)) "}")
    next
}

# Joins a code span that continues on the next line.
{ text = before $0; before = "" }
gsub(/`/, "&", text) % 2 && $0 != "" { before = text " "; next }

{ print spans(names(links(text))) }

# Doxygen takes a code span with a ' for a quotation, and replaces $(NAME) by the environment's. A browser would
# break code after a hyphen: style.css keeps words with a hyphen whole, and short code if there is space for it.
function spans(text,    out, code, is_short, before) {
    while (match(text, /`[^`]*`/)) {
        before = substr(text, 1, RSTART - 1)
        code = substr(text, RSTART, RLENGTH)
        is_short = RLENGTH <= 32
        text = substr(text, RSTART + RLENGTH)
        out = out joined(before)
        if (code ~ /\047|\$\(|-/) {
            code = "<tt>" unbroken(substr(code, 2, length(code) - 2)) "</tt>"
        }
        out = out (code ~ /-/ && is_short ? "<span class=\"whole\">" code "</span>" : code)
    }
    return out joined(text)
}

# A space that does not break keeps a % from the beginning of a line, and a ± from its end.
function joined(text) {
    if ($0 !~ /^    /) {
        gsub(/ %/, "\302\240%", text)
        while (match(text, /± [0-9]/)) {
            text = substr(text, 1, RSTART + RLENGTH - 3) "\302\240" substr(text, RSTART + RLENGTH - 1)
        }
    }
    return text
}

function unbroken(code,    n, i, word, out) {
    n = split(code, word, " ")
    for (i = 1; i <= n; i++) {
        code = word[i]
        gsub(/[\\$<>&#@%*_]/, "\\\\&", code)
        gsub(/--/, "\\\\&", code)
        out = out (i > 1 ? " " : "") (code ~ /-/ && length(code) <= 40 ? "<span class=\"word\">" code "</span>" : code)
    }
    return out
}

# A code span that is a name of the library becomes a link, which is an error if there is no such name.
# (INVCAL_CONFIG_HEADER is defined only by users; migration.md names what is gone: tests/migration.sh checks it.)
function names(text,    out, name) {
    while (match(text, /`(invcal|INVCAL)_[A-Za-z0-9_]+`/)) {
        name = substr(text, RSTART + 1, RLENGTH - 2)
        out = out substr(text, 1, RSTART - 1) "<tt>" (name == "INVCAL_CONFIG_HEADER" || FILENAME ~ /migration/ ? "" : "#") name "</tt>"
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
    gsub(/[^A-Za-z0-9]+/, "-", path)
    return path "-" name
}

# A path from the top of the repository, without `..`.
function plain(path) {
    while (sub(/[^\/]+\/\.\.\//, "", path)) {
    }
    return path
}

function links(text,    out, link, words, target, hash, is_picture) {
    while (match(text, /\[[^]]*\]\([^)]*\)/)) {
        link = substr(text, RSTART, RLENGTH)
        out = out substr(text, 1, RSTART - 1)
        is_picture = substr(out, length(out)) == "!"
        text = substr(text, RSTART + RLENGTH)
        hash = index(link, "](")
        words = substr(link, 2, hash - 2)
        target = substr(link, hash + 2, length(link) - hash - 2)
        if (is_picture) { # IMAGE_PATH contains the folder
            sub(/.*\//, "", target)
            link = "[" words "](" target ")"
        }
        out = out (is_picture || target ~ /^https?:/ ? link : resolved(words, target))
    }
    return out text
}

function resolved(words, target,    hash, name, path) {
    hash = index(target, "#")
    name = hash ? substr(target, hash + 1) : ""
    path = hash ? substr(target, 1, hash - 1) : target
    path = path == "" ? page : plain(folder path)
    gsub(/`/, "", words) # Doxygen would show them
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
