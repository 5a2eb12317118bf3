#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The picture of port/manual/tool.md: the two halves of the sphere, from the report on the Xsens positions.
#
#     sh tests/picture.sh path/to/invcal > port/host/sphere.svg
#     sh tests/picture.sh path/to/invcal --check      that file is up to date
here=$(dirname "$0")
tool=$1
page=$(mktemp) || exit 2
trap 'rm -f "$page" "$page.svg"' EXIT

# The styles of the page, and its parts side by side and below one another.
"$tool" calibrate "$here/data/xsens_mti_positions.csv" --positions --gravity 9.81744 \
    --zero 33123,33276,32360 --lsb 0.002409639,0.002421308,0.002409639 --quiet --report "$page" &&
awk 'BEGIN {
        print "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"invcal\" role=\"img\" width=\"680\"" \
            " height=\"440\" viewBox=\"0 0 680 440\" font-family=\"sans-serif\" font-size=\"14\">"
        print "<title>Where 38 positions lie, and how well every direction is known</title>"
    }
    /^<style>/ { styles++ }
    styles == 2 && !styled { print } # those of the pictures; the first are those of the page
    /^<\/style>/ && styles == 2 && !styled { styled = 1; print "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>" }
    /<div class="row">/ { in_row = 1 }
    in_row && /^<svg/ { printf "<g transform=\"translate(%d %d)\">\n", part % 2 * 344, (part < 2 ? 0 : 352); part++; inside = 1 }
    inside { print }
    inside && /^<\/svg>/ { print "</g>"; inside = 0 }
    in_row && /^<\/div>/ { exit }
    END { print "</svg>" }' "$page" > "$page.svg" || exit 1
if [ "$2" = --check ]; then
    cmp "$page.svg" "$here/../port/host/sphere.svg"
else
    cat "$page.svg"
fi
