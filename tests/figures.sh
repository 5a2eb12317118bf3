#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The figures of the manual: mathematics.md names the command that draws each, build/invcal ... --svg
# NAME.svg.
#
#     sh tests/figures.sh path/to/invcal             draws them again in port/manual
#     sh tests/figures.sh path/to/invcal --check     they are what stands there, and below 60 kB
manual=$(dirname "$0")/../port/manual
tool=$1
drawn=$(mktemp -d) || exit 2
trap 'rm -rf "$drawn"' EXIT

sed -n 's,^    build/invcal \(plan .*--svg [a-z]*\.svg\)$,\1,p' "$manual/mathematics.md" > "$drawn/commands"
while read -r command; do
    name=${command##* }
    # shellcheck disable=SC2086 # words
    "$tool" ${command% *} "$drawn/$name" --quiet || exit 1
    if [ "$2" = --check ]; then
        cmp "$drawn/$name" "$manual/$name" || exit 1
        test "$(wc -c < "$drawn/$name")" -lt 60000 || exit 1
    else
        cp "$drawn/$name" "$manual/$name"
    fi
done < "$drawn/commands"

# Every figure has its command.
test "$(grep -c . "$drawn/commands")" -eq "$(find "$manual" -name '*.svg' | grep -c .)"
