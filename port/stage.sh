#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/stage.sh PACKAGE DEST
# Lays out a package in the folder DEST, which is created if necessary. port/PACKAGE/files lists its
# contents, a line each:
#
#     FROM TO        FROM is a path or a glob, from the repository's root, of files. TO is a folder
#                    in DEST if it ends in /, else a file; if it ends in */, each file keeps the folder that it is in
#     run SCRIPT TO  the shell script SCRIPT, from the repository's root, makes files in the folder
#                    DEST/TO, its argument
#     # ...          a comment
#
# In files of the package itself, under port/PACKAGE, @VERSION@, @MAJOR@, @MINOR@ and @PATCH@
# become those of include/invcal/config.h, @ADDRESS@ what address.sh prints.
#
# DEST may contain other files. DEST/.invcal-PACKAGE lists what was laid out, with checksums: the next time these files
# are replaced, and those no longer in the package are removed. Nothing else is touched: it fails if a foreign file is in
# the way, or if one of ours was changed. If it fails, it exits with 2 and one line; DEST is not touched before everything
# is made.
fail() {
    echo "stage.sh: $1" >&2
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
esac || fail "unknown package '$package'; packages: $(printf '%s\n' port/*/files |
    sed 's|^port/\(.*\)/files$|\1|' | paste -s -d ' ' -)"
[ ! -e "$dest" ] || [ -d "$dest" ] || fail "$dest is not a folder"
version=$(sh port/version.sh) || exit 2
address=$(sh port/address.sh) || exit 2
major=${version%%.*}
minor=${version#*.}
minor=${minor%.*}
manifest=.invcal-$package
new=$(mktemp -d) || exit 2
trap 'rm -rf "$new" "$new.old" "$new.list"' EXIT

# ---- all files, in a folder of their own --------------------------------------------------------

copy() { # FROM TO: one file
    folder=${1%/*}
    case $2 in
    */'*/') target=$new/${2%'*/'}${folder##*/}/${1##*/} ;;
    */) target=$new/$2${1##*/} ;;
    *) target=$new/$2 ;;
    esac
    [ -f "$1" ] || fail "$list:$number: no file $1"
    [ ! -e "$target" ] || fail "$list:$number: $1 would overwrite ${target#"$new"/}"
    mkdir -p "${target%/*}" && cp "$1" "$target" || fail "$list:$number: $1 cannot be copied"
    case $1 in
    port/"$package"/*)
        sed -e "s/@VERSION@/$version/g" -e "s/@MAJOR@/$major/g" -e "s/@MINOR@/$minor/g" \
            -e "s/@PATCH@/${version##*.}/g" -e "s|@ADDRESS@|$address|g" "$1" > "$target" || fail "$list:$number: cannot read $1"
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
        mkdir -p "$new/$rest" || fail "$list:$number: $rest cannot be made"
        sh "$to" "$new/$rest" < /dev/null || fail "$list:$number: $to failed"
        ;;
    *)
        [ -n "$to" ] && [ -z "$rest" ] || fail "$list:$number: not FROM TO"
        # shellcheck disable=SC2086 # from may be a glob
        set -- $from
        case $#:$to in 1:* | *:*/) ;; *) fail "$list:$number: $# files, but $to is not a folder/" ;; esac
        for file; do
            copy "$file" "$to"
        done
        ;;
    esac
done < "$list"

# ---- what is in their way -----------------------------------------------------------------------

# A line "CHECKSUM SIZE NAME" each, as cksum writes it.
: > "$new.old"
[ ! -f "$dest/$manifest" ] || cp "$dest/$manifest" "$new.old" || exit 2
(cd "$new" && find . -type f | sed 's|^\./||' | LC_ALL=C sort | while IFS= read -r file; do
    cksum "$file"
done) > "$new.list" || exit 2

while read -r sum size file; do
    [ ! -e "$dest/$file" ] || [ "$(cd "$dest" && cksum "$file")" = "$sum $size $file" ] ||
        fail "$dest/$file was changed since it was laid out: move it away"
done < "$new.old"
while read -r _ _ file; do
    if [ -e "$dest/$file" ] && ! cmp -s "$new/$file" "$dest/$file" &&
        ! sed 's/^[0-9]* [0-9]* //' "$new.old" | grep -qxF "$file"; then
        fail "$dest/$file exists, and is not listed as ours (0.1.0 kept no list): move it away"
    fi
done < "$new.list"

# ---- there --------------------------------------------------------------------------------------

mkdir -p "$dest" 2> /dev/null && [ -w "$dest" ] || fail "$dest cannot be made or written"
sed 's/^[0-9]* [0-9]* //' "$new.old" | while IFS= read -r file; do
    rm -f "$dest/$file"
    case $file in */*) (cd "$dest" && rmdir -p "${file%/*}" 2> /dev/null) || : ;; esac
done
cp -R "$new/." "$dest" && cp "$new.list" "$dest/$manifest" || fail "$dest cannot be written"
