#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/manual.sh BUILD
# Makes the manual, BUILD/manual/html, from the pages in port/manual and the headers, and checks that
# everything public is documented and no link is dead. Ends with `N passed, N failed`.
build=$(mkdir -p "$1" && cd "$1" && pwd) || exit 1
cd "$(dirname "$0")/.." || exit 1
html=$build/manual/html
log=$build/manual.log
passed=0
failed=0

gate() { # SENTENCE COMMAND...
    sentence=$1
    shift
    if "$@" > "$log" 2>&1; then
        echo "manual: $sentence: PASS"
        passed=$((passed + 1))
    else
        cat "$log"
        echo "manual: $sentence: FAIL"
        failed=$((failed + 1))
    fi
}

version=$(awk '/^#define INVCAL_VERSION_(MAJOR|MINOR|PATCH) / { v = v dot $3; dot = "." } END { print v }' \
    include/invcal/config.h)

pages() {
    rm -rf "$build/manual" && mkdir -p "$build/manual" && doxygen -l "$build/manual/default.xml" &&
        awk -f port/manual/layout.awk port/manual/README.md "$build/manual/default.xml" > "$build/manual/layout.xml" &&
        BUILD=$build VERSION=$version doxygen port/manual/Doxyfile && cat port/manual/style.css >> "$html/search/search.css"
}

# Doxygen does not warn of an enumerator without a comment.
enumerators() {
    ! awk '/^ *(typedef )?enum \{/ { on = 1; next } /^\}/ { on = 0 }
        on && /^ +INVCAL_/ && !/\/\*/ { print FILENAME ":" FNR ": no comment: " $1 }' \
        include/invcal/*.h | grep .
}

# Each member has its own entry on the page: a sentence that continues at the next one would be cut.
members() {
    ! awk '/^ +[a-z].*;.*\/\*.*([,:]|[^a-z](is|are|the|of|and|or)) \*\/$/ {
        print FILENAME ":" FNR ": the comment continues at the next member: " $1 " " $2 }' \
        include/invcal/*.h | grep .
}

# All links, as FILE#LABEL, lead to a file or a label that exists.
links() {
    cd "$html" || return 1
    awk '{
            text = $0
            while (match(text, /<a [^>]*href="[^"]*"/)) {
                link = substr(text, RSTART, RLENGTH)
                text = substr(text, RSTART + RLENGTH)
                sub(/.*href="/, "", link)
                sub(/"$/, "", link)
                if (link !~ /^(https?|javascript):/ && link != "") {
                    print (link ~ /^#/ ? FILENAME : "") link
                }
            }
        }' md_*.html index.html ./*_8h.html struct*.html | sort -u > "$build/manual.links"
    awk '{
            text = $0
            while (match(text, / (id|name)="[^"]*"/)) {
                name = substr(text, RSTART, RLENGTH)
                text = substr(text, RSTART + RLENGTH)
                gsub(/^[^"]*"|"$/, "", name)
                print FILENAME "#" name
            }
        }' ./*.html | sed 's,^\./,,' > "$build/manual.labels"
    ls >> "$build/manual.labels"
    test "$(wc -l < "$build/manual.links")" -gt 100 &&
        ! sed 's,^\./,,' "$build/manual.links" | grep -vxF -f "$build/manual.labels"
}

# Where Doxygen does not find a picture, it keeps the path.
pictures() {
    (cd "$html" && cat md_*.html index.html | grep -oE '<(img|object)[^>]*(src|data)="[^"]*"' | sed 's/.*="//; s/"$//' | sort -u) > "$build/manual.pictures"
    test "$(wc -l < "$build/manual.pictures")" -gt 5 && while read -r picture; do
        test -f "$html/$picture" || { echo "no picture $picture"; return 1; }
    done < "$build/manual.pictures"
}

# Links in the Markdown itself, as GitHub shows it: to files, and to headings in them.
sources() {
    find README.md CHANGELOG.md port tests -name '*.md' -exec awk '
        FNR == 1 { code = 0; folder = FILENAME; sub(/[^\/]*$/, "", folder) }
        /^```/ { code = !code }
        code { next }
        /^#/ {
            label = tolower($0)
            sub(/^#+ */, "", label)
            gsub(/[^a-z0-9 _-]/, "", label)
            gsub(/ /, "-", label)
            there[FILENAME "#" label]
        }
        { text = $0 }
        { while (match(text, /\]\([^)]*\)/)) {
            link = substr(text, RSTART + 2, RLENGTH - 3)
            text = substr(text, RSTART + RLENGTH)
            if (link ~ /^https?:/) continue
            link = link ~ /^#/ ? FILENAME link : folder link
            while (sub(/[^\/]+\/\.\.\//, "", link)) {
            }
            wanted[link] = FILENAME ":" FNR
        } }
        END {
            for (link in wanted) {
                file = link
                sub(/#.*/, "", file)
                links++
                if (system("test -e \"" file "\"") || (link ~ /#/ && !(link in there))) {
                    print wanted[link] ": nothing there: " link
                    lost = 1
                }
            }
            exit lost || links < 10
        }' {} +
}

# Markdown that Doxygen does not understand is in the page as it was typed.
leftovers() {
    ! awk '/<pre|class="fragment"/ { code = 1 } !code && /`|\*\*/ { print FILENAME ":" FNR ": " $0 }
        /<\/pre>|<\/div><!-- fragment -->/ { code = 0 }' "$html"/md_*.html "$html/index.html" | grep .
}

gate "no link of the pages is dead" sources
gate "Doxygen accepts the headers and pages" pages
gate "every enumerator has a comment" enumerators
gate "no comment of a member continues at the next" members
gate "no Markdown is left in the HTML" leftovers
gate "no link of the HTML is dead" links
gate "every picture of the HTML is there" pictures

echo "$html/index.html"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
