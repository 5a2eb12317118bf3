#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/words.sh
# The English of all text and comments: codespell finds no word that is misspelt, and no word of
# tests/words.txt is there. Prints FILE:LINE, the word and the better one.
cd "$(dirname "$0")/.." || exit 1
command -v codespell > /dev/null || { echo "codespell is not installed: make deps" >&2; exit 1; }
not_ours="-name unity -o -path tests/data -o -name words.txt -o -name package-lock.json"
# shellcheck disable=SC2086 # words
all=$(find README.md CHANGELOG.md .github include src port tests '(' $not_ours ')' -prune -o -type f -print |
    LC_ALL=C sort)
read_by_users=$(echo "$all" |
    grep -E '^(README|CHANGELOG|\.github/|include/|src/|port/web/page\.html|port/(.*/)?[^/]*\.md$)')

# What the tool and the page say: their string literals with a blank, each as FILE:LINE: "TEXT". Words without a
# blank are names and values.
literals() {
    echo "$all" | grep -E '^port/(host/.*\.(c|h|json)|web/[^/]*\.(c|js))$' | xargs awk '
        /^ *(#include|\/\/|\/?\*)/ { next }
        {
            gsub(/\047"\047/, "")
            while (match($0, /"([^"\\]|\\.)*"|`[^`]*`/)) {
                text = substr($0, RSTART, RLENGTH)
                $0 = substr($0, RSTART + RLENGTH)
                gsub(/\\n/, " ", text)
                if (text ~ / /) print FILENAME ":" FNR ": " text
            }
        }'
}
# The comments of the tool, in the same form.
comments() {
    echo "$all" | grep -E '^port/host/.*\.(c|h)$' | xargs awk '
        FNR == 1 { is_open = 0 }
        is_open || match($0, /\/\*/) {
            text = is_open ? $0 : substr($0, RSTART + 2)
            is_open = !sub(/\*\/.*/, "", text)
            print FILENAME ":" FNR ": " text
        }'
}
said=$(literals)
noted=$(comments)

# Parts of identifiers, of printf's formats and of instruction sets.
echo "$all" | xargs codespell -L 'rsource,ontext,shold,rcall,te'
wrong=$?

[ -n "$said" ] && [ -n "$noted" ] && [ -s tests/words.txt ] || exit 1
grep -v '^#' tests/words.txt | {
    while IFS=$(printf '\t') read -r where word better; do
        case $where in
        all) files=$all ;;
        users) files=$read_by_users ;;
        tool) files= ;;
        *) echo "tests/words.txt: all, users or tool is expected: $where"; exit 1 ;;
        esac
        echo | grep -E -- "$word" > /dev/null
        [ $? -lt 2 ] && [ -n "$better" ] || { echo "tests/words.txt: no rule: $word"; exit 1; }
        # shellcheck disable=SC2086 # files
        {
            [ -n "$files" ] && LC_ALL=C.UTF-8 grep -EHIinow -- "$word" $files
            [ "$where" != all ] && echo "$said" | LC_ALL=C.UTF-8 grep -aEiw -- "$word"
            [ "$where" = users ] && echo "$noted" | LC_ALL=C.UTF-8 grep -aEiw -- "$word"
        } | awk -v better="$better" '{ print $0 ": better: " better } END { exit NR > 0 }' || wrong=1
    done
    exit "$wrong"
}
