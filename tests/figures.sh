#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The figures of the manual. The pages mathematics*.md name the commands that draw them, in blocks of `sh`: with --svg
# NAME.svg, or with --report NAME.html, a page that contains the figure under its title:
#
#     ![TITLE: what it shows](NAME.svg)
#
#     sh tests/figures.sh path/to/invcal             redraws them in port/manual
#     sh tests/figures.sh path/to/invcal --check     those there are up to date, and below 60 kB
manual=$(cd "$(dirname "$0")/../port/manual" && pwd) || exit 2
tool=$(cd "$(dirname "$1")" && pwd) || exit 2
drawn=$(mktemp -d) || exit 2
trap 'rm -rf "$drawn"' EXIT
PATH=$tool:$PATH

# The picture of that title, with the page's style for pictures, which is its second.
part() { # TITLE < PAGE
    awk -v title="<title>$1</title>" '
        /^<style>/ { styles++ }
        styles == 2 && !styled { style = style $0 "\n" }
        /^<\/style>/ && styles == 2 { styled = 1 }
        /^<svg/ { part = ""; wanted = 0; inside = 1 }
        inside { part = part $0 "\n" }
        inside && $0 == title { wanted = 1; part = part style "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n" }
        inside && /^<\/svg>/ { inside = 0; if (wanted) { printf "%s", part; exit } }'
}

cat "$manual"/mathematics*.md |
    awk '/^```sh$/ { on = 1; next } /^```/ { on = 0 } on' > "$drawn/commands"
(cd "$drawn" && sh -e commands > said 2>&1) || { cat "$drawn/said"; exit 1; }

sed -n 's/^!\[\([^]:]*\).*](\([a-z]*\)\.svg)$/\2 \1/p' "$manual"/mathematics*.md > "$drawn/figures"
while read -r name title; do
    [ -f "$drawn/$name.svg" ] || part "$title" < "$drawn/$name.html" > "$drawn/$name.svg" || exit 1
    if [ "$2" = --check ]; then
        cmp "$drawn/$name.svg" "$manual/$name.svg" || exit 1
        test "$(wc -c < "$drawn/$name.svg")" -lt 60000 || exit 1
    else
        cp "$drawn/$name.svg" "$manual/$name.svg"
    fi
done < "$drawn/figures"

# There is no other figure.
test "$(grep -c . "$drawn/figures")" -eq "$(find "$manual" -name '*.svg' | grep -c .)"
