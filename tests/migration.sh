#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/migration.sh BUILD: does port/manual/migration.md have a row for each function of 0.2.0 that was declared in
# another way, and does every function that it leads to exist? Prints what is missing.
out=$1/migration
page=port/manual/migration.md
mkdir -p "$out"
export LC_ALL=C
awk -f tests/prototypes.awk include/invcal/*.h | sort > "$out/now"
names() { sed 's/(.*//; s/.*[ *]//' "$1" | sort -u; }

comm -23 tests/reference/functions_of_0.2.0.txt "$out/now" > "$out/changed"
names "$out/changed" > "$out/changed.names"
names "$out/now" > "$out/now.names"
# A row: | `old`, `old` | `new(...)` | why |
awk -F ' *[|] *' '/^\| `invcal_/ { print $2 }' "$page" | grep -o 'invcal_[a-z0-9_]*' | sort -u > "$out/rows"
awk -F ' *[|] *' '/^\| `invcal_/ { print $3 }' "$page" | grep -o 'invcal_[a-z0-9_]*' | sort -u > "$out/leads"
{
    comm -23 "$out/changed.names" "$out/rows" | sed "s|^|$page has no row for |"
    names tests/reference/functions_of_0.2.0.txt | comm -13 - "$out/rows" | sed "s|^|$page has a row for what 0.2.0 has not: |"
    comm -23 "$out/leads" "$out/now.names" | sed "s|^|$page leads to what there is not: |"
} > "$out/missing"
cat "$out/missing"
[ ! -s "$out/missing" ]
