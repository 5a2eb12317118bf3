#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The CMSIS-Pack, without Arm's tools: its description by those rules of PACK.xsd that it needs
# (tests/packages/cmsis-pack/pdsc.xsd), the files that it names, and its component, built as it says.
. "$(dirname "$0")/../package.sh"
need xmllint python3 cc arm-none-eabi-gcc
pack=$out/cmsis-pack
pdsc=$pack/invcal.invcal.pdsc
version=$(sh port/version.sh)

keeps_to_rules() {
    xmllint --noout --schema tests/packages/cmsis-pack/pdsc.xsd "$pdsc"
}

# chosen XPATH: the attributes or texts, a line each.
chosen() {
    xmllint --xpath "$1" "$pdsc" | sed 's/^ *[A-Za-z]*="\(.*\)"$/\1/'
}

# A pack is a zip with the description in its root: VENDOR.NAME.VERSION.pack, VENDOR.NAME.pdsc.
named_after_content() {
    full=$(xmllint --xpath 'concat(/package/vendor, ".", /package/name)' "$pdsc")
    [ "$full" = invcal.invcal ] &&
        [ "$(chosen /package/releases/release/@version | head -n 1)" = "$version" ] &&
        [ "$(chosen //component/@Cversion)" = "$version" ] &&
        [ -f "$pack/$(xmllint --xpath 'string(/package/license)' "$pdsc")" ] &&
        [ "$(cd "$pack" && find . -name '*.pdsc')" = ./invcal.invcal.pdsc ]
}

names_what_is_there() {
    chosen '//file[@category != "include"]/@name' > "$out/named" && while read -r file; do
        [ -f "$pack/$file" ] || { echo "no file $file"; return 1; }
    done < "$out/named"
    chosen '//file[@category = "include"]/@name' > "$out/folders" && while read -r folder; do
        case $folder in */) [ -d "$pack/$folder" ] ;; *) false ;; esac ||
            { echo "no folder $folder"; return 1; }
    done < "$out/folders"
}

names_all_sources() {
    chosen '//file[@category = "source"]/@name' | LC_ALL=C sort > "$out/sources" &&
        printf '%s\n' src/*/*.c | LC_ALL=C sort | diff - "$out/sources"
}

# Like a tool that puts the component into a project: sources and include folders as listed.
compiles() { # FOLDER COMPILER FLAG...
    folder=$out/$1
    shift
    mkdir -p "$folder"
    while read -r file; do
        # shellcheck disable=SC2046 # folders without blanks
        "$@" -std=c99 $(sed "s|^|-I$pack/|" "$out/folders") -c "$pack/$file" \
            -o "$folder/$(basename "$file").o" || return
    done < "$out/sources"
}

stated() { # C or Link: the options that README.md states
    sed -n 's/^    //p' "$pack/README.md" | /usr/bin/python3 -c '
import sys, yaml
print(*yaml.safe_load(sys.stdin)["project"]["misc"][0][sys.argv[1]])' "$1"
}

runs_example() {
    # shellcheck disable=SC2046 # options are words
    compiles host cc -O2 $(stated C) && cc -I"$pack/include" "$example" \
        "$out"/host/*.o -lm $(stated Link) -o "$out/host/program" && prints_as_expected "$out/host/program"
}

check "it can be staged" stage cmsis-pack
check "the description keeps to the rules" keeps_to_rules
check "names and versions agree" named_after_content
check "what it names is there" names_what_is_there
check "it names all sources" names_all_sources
check "its component: the example prints what it must" runs_example
check "with the options of its README.md only what is called is linked" drops_uncalled "$out/host/program"
check "its component compiles for a Cortex-M4F" compiles m4f arm-none-eabi-gcc -mcpu=cortex-m4 \
    -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -Wall -Wextra -Werror
finish
