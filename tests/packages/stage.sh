#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# port/stage.sh itself, in a small tree with a package that copies, substitutes and makes files. Whatever
# is wrong gives one line, and changes nothing.
. "$(dirname "$0")/../package.sh"
tree=$out/tree
dest="$out/a folder/laid out"

mkdir -p "$tree/port/toy" "$tree/src" "$tree/include/invcal"
cp port/stage.sh port/version.sh "$tree/port/"
echo "echo https://a.invalid/b" > "$tree/port/address.sh"
printf '#define INVCAL_VERSION_%s\n' 'MAJOR 12' 'MINOR 0' 'PATCH 345' > "$tree/include/invcal/config.h"
echo 'version @VERSION@, @MAJOR@-@MINOR@-@PATCH@, @ADDRESS@' > "$tree/port/toy/manifest"
echo 'echo made > "$1/made.txt"' > "$tree/port/toy/make.sh"
echo 'exit 3' > "$tree/port/toy/fail.sh"
echo 'not @VERSION@' > "$tree/src/one.c"
touch "$tree/src/two.c"
mkdir "$tree/src/part"
touch "$tree/src/part/three.c"

lists() { # LINE...: what the package's files says
    printf '%s\n' '# a comment' '' "$@" > "$tree/port/toy/files"
}

stages() {
    rm -rf "$dest"
    sh "$tree/port/stage.sh" toy "$dest"
}

lays_out() {
    lists 'src/*.c ./' 'src/one.c deep/er/' 'port/toy/manifest renamed' 'run port/toy/make.sh deep' \
        'src/*/*.c all/*/'
    stages || return
    (cd "$dest" && find . -type f | sort | tr '\n' ' ') > "$out/found"
    echo './.invcal-toy ./all/part/three.c ./deep/er/one.c ./deep/made.txt ./one.c ./renamed ./two.c ' | tr -d '\n' | diff - "$out/found"
}

substitutes() { # in its own files only
    [ "$(cat "$dest/renamed")" = 'version 12.0.345, 12-0-345, https://a.invalid/b' ] &&
        [ "$(cat "$dest/one.c")" = 'not @VERSION@' ]
}

# Laid out again, among other files: removes what is no longer part of it, and nothing else.
upgrades() {
    echo mine > "$dest/deep/mine.txt"
    echo 'two, newer' > "$tree/src/two.c"
    lists 'src/two.c ./' 'src/one.c deep/'
    sh "$tree/port/stage.sh" toy "$dest" || return
    (cd "$dest" && find . -type f | sort | tr '\n' ' ') > "$out/found"
    printf '%s' './.invcal-toy ./deep/mine.txt ./deep/one.c ./two.c ' | diff - "$out/found" &&
        [ "$(cat "$dest/deep/mine.txt") $(cat "$dest/two.c")" = 'mine two, newer' ] && [ ! -e "$dest/deep/er" ]
}

stays() { # SAID: nothing has changed
    cp -R "$dest" "$out/before"
    sh "$tree/port/stage.sh" toy "$dest" 2> "$out/said"
    [ $? -eq 2 ] && echo "stage.sh: $dest/$1: move it away" | diff - "$out/said" && diff -r "$out/before" "$dest" &&
        rm -rf "$out/before"
}

# A file of ours that was edited, and a foreign one where ours would go.
keeps_others() {
    echo edited >> "$dest/two.c"
    stays 'two.c was changed since it was laid out' || return
    echo 'two, newer' > "$dest/two.c"
    lists 'src/*.c ./'
    echo foreign > "$dest/one.c"
    stays 'one.c exists, and is not listed as ours (0.1.0 kept no list)'
}

refuses() { # SAID LINE...
    said=$1
    shift
    lists "$@"
    stages 2> "$out/said"
    [ $? -eq 2 ] && [ ! -e "$dest" ] && echo "stage.sh: $said" | diff - "$out/said"
}

names_packages() {
    ! sh "$tree/port/stage.sh" none "$dest" 2> "$out/said" &&
        [ "$(cat "$out/said")" = "stage.sh: unknown package 'none'; packages: toy" ]
}

refuses_tilde() {
    ! (cd "$out" && sh "$tree/port/stage.sh" toy \~/toy 2> "$out/said") && [ ! -e "$out/~" ] &&
        grep -q '^stage.sh: DEST begins with ~' "$out/said"
}

make_says_where() {
    [ "$(make -s -C "$root" package PACKAGE=zephyr DEST="$out/made")" = "zephyr is in $out/made" ] &&
        [ -e "$out/made/README.md" ]
}

check "it copies, with folders and without, renames and makes" lays_out
check "a package's own files get the version of invcal.h" substitutes
check "a later version replaces it, and leaves other files alone" upgrades
check "foreign files and changed ones are left alone" keeps_others
check "a missing file is named" refuses 'port/toy/files:4: no file src/three.c' \
    'src/one.c ./' 'src/three.c ./'
check "a glob that matches nothing is named" refuses 'port/toy/files:3: no file src/*.h' 'src/*.h ./'
check "several files need a folder" refuses 'port/toy/files:3: 2 files, but all is not a folder/' \
    'src/*.c all'
check "a file does not overwrite another" \
    refuses 'port/toy/files:4: src/two.c would overwrite one.c' 'src/one.c ./' 'src/two.c one.c'
check "a line of one word is refused" refuses 'port/toy/files:3: not FROM TO' src/one.c
check "a script that fails is named" refuses 'port/toy/files:3: port/toy/fail.sh failed' \
    'run port/toy/fail.sh ./'
check "an unknown package: lists the known ones" names_packages
check "make package says where it is" make_says_where
check "a ~ that no shell expanded is refused" refuses_tilde
finish
