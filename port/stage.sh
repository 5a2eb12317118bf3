#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/stage.sh PACKAGE DEST
# Lays a package out in the folder DEST, which is made, and must be empty if it is there. What goes
# into it stands in port/PACKAGE/files, a line each:
#
#     FROM TO        FROM is a path or a glob, from the repository's root, of files. TO is a folder
#                    in DEST if it ends in /, else a file
#     run SCRIPT TO  the shell script SCRIPT, from the repository's root, is handed the folder
#                    DEST/TO, and makes files in it
#     # ...          a comment
#
# In files of the package itself, under port/PACKAGE, @VERSION@, @MAJOR@, @MINOR@ and @PATCH@
# become those of include/invcal/invcal.h. Exit status 2, one line, and no DEST if that fails.
fail() {
    echo "stage.sh: $1" >&2
    [ -z "$begun" ] || rm -rf "$dest"
    exit 2
}

[ $# -eq 2 ] || fail "usage: sh port/stage.sh PACKAGE DEST"
package=$1
dest=$2
case $dest in
'') fail "DEST is empty" ;;
'~'*) fail "DEST begins with ~, which not every shell expands there: write \$HOME" ;;
/*) ;;
*) dest=$PWD/$dest ;;
esac
cd "$(dirname "$0")/.." || exit 2

list=port/$package/files
case $package in
'' | */*) false ;;
*) [ -f "$list" ] ;;
esac || fail "unknown package '$package': there are $(printf '%s\n' port/*/files |
    sed 's|^port/\(.*\)/files$|\1|' | paste -s -d ' ' -)"
if [ -e "$dest" ] && { [ ! -d "$dest" ] || [ -n "$(ls -A "$dest")" ]; }; then
    fail "$dest is not an empty folder"
fi
version=$(sh port/version.sh) || exit 2
major=${version%%.*}
minor=${version#*.}
minor=${minor%.*}
begun=1
mkdir -p "$dest" || fail "$dest cannot be made"

copy() { # FROM TO: one file
    target=$dest/$2
    case $2 in */) target=$target${1##*/} ;; esac
    [ -f "$1" ] || fail "$list:$number: no file $1"
    [ ! -e "$target" ] || fail "$list:$number: $1 would be written over ${target#"$dest"/}"
    mkdir -p "${target%/*}" && cp "$1" "$target" || fail "$list:$number: $1 cannot be copied"
    case $1 in
    port/"$package"/*)
        sed -e "s/@VERSION@/$version/g" -e "s/@MAJOR@/$major/g" -e "s/@MINOR@/$minor/g" \
            -e "s/@PATCH@/${version##*.}/g" "$1" > "$target" || fail "$list:$number: cannot read $1"
        ;;
    esac
}

number=0
while read -r from to rest || [ -n "$from" ]; do
    number=$((number + 1))
    case $from in
    '' | '#'*) ;;
    run)
        [ -n "$rest" ] || fail "$list:$number: not run SCRIPT TO"
        mkdir -p "$dest/$rest" || fail "$list:$number: $rest cannot be made"
        sh "$to" "$dest/$rest" < /dev/null || fail "$list:$number: $to failed"
        ;;
    *)
        [ -n "$to" ] && [ -z "$rest" ] || fail "$list:$number: not FROM TO"
        # shellcheck disable=SC2086 # from may be a glob
        set -- $from
        case $#:$to in 1:* | *:*/) ;; *) fail "$list:$number: $# files, and $to is no folder/" ;; esac
        for file; do
            copy "$file" "$to"
        done
        ;;
    esac
done < "$list"
