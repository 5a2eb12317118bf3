#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# What `make dist` makes of the last commit is the same in every clone; the tarball is complete, and works
# by itself. FULL=1: runs all tests in it.
. "$(dirname "$0")/../package.sh"
need git gzip tar zip unzip cc
git clone -q "$root" "$out/one" || exit 1
version=$(sh "$out/one/port/version.sh")
tarball=build/dist/invcal-$version.tar.gz
tree=$out/invcal-$version

made() {
    make -s -C "$out/one" dist
}

made_again() { # elsewhere, by somebody with other settings
    git clone -q "$root" "$out/two" || return
    git -C "$out/two" config core.autocrlf true
    git -C "$out/two" config tar.umask 0077
    (
        umask 077
        TZ=Asia/Tokyo LC_ALL=C.UTF-8 GZIP=-1 make -s -C "$out/two" dist
    ) && diff -r "$out/one/build/dist" "$out/two/build/dist"
}

refuses_change() { # what is not committed would be missing
    echo >> "$out/two/README.md"
    ! make -s -C "$out/two" dist 2> "$out/refused" && grep -q 'lacks this:  M README.md$' "$out/refused"
}

is_complete() { # the files of the commit, and nothing else
    tar -xzf "$out/one/$tarball" -C "$out" || return
    (cd "$tree" && find . -type f | sed 's|^./||' | sort) > "$out/in"
    git ls-tree -r --name-only HEAD | sort | diff - "$out/in"
}

is_of_root() {
    ! tar -tvzf "$out/one/$tarball" | grep -v ' root/root ' &&
        [ "$(tar -tvzf "$out/one/$tarball" | awk '{ print $4, $5 }' | sort -u | wc -l)" -eq 1 ]
}

demo_works() {
    make -s -C "$tree" demo CFLAGS=-O0 > "$out/demo" && grep -q '^Good: ' "$out/demo"
}

all_tests_pass() {
    make -s -C "$tree" clean && make -s -C "$tree" test > "$out/test"
    result=$?
    tail -n 1 "$out/test"
    return $result
}

# The zips contain what make package lays out; Arduino's IDE can add its library.
packages_are_zipped() {
    for package in amalgamation arduino cmsis-pack esp-idf platformio zephyr; do
        top=invcal zip=invcal-$version-$package.zip
        case $package in cmsis-pack) top=. zip=invcal.invcal.$version.pack ;; amalgamation) top=. ;; esac
        mkdir -p "$out/zipped/$package" && unzip -q "$out/one/build/dist/$zip" -d "$out/zipped/$package" &&
            make -s -C "$tree" package PACKAGE=$package && rm "$tree/build/packages/$package/.invcal-$package" &&
            diff -r "$out/zipped/$package/$top" "$tree/build/packages/$package" || return
    done
    [ -s "$out/zipped/arduino/invcal/library.properties" ] && (cd "$out/one/build/dist" && sha256sum -c --quiet SHA256SUMS)
}

packages_are_laid_out() {
    make -s -C "$tree" packages && [ -s "$tree/build/packages/amalgamation/invcal/invcal.c" ]
}

# Only this needs git, and must not mistake an enclosing clone for its own: one line.
refuses_dist() {
    ! make -s -C "$tree" dist 2> "$out/refused" && grep -q 'is made from a clone$' "$out/refused" &&
        [ "$(grep -vc '^make' "$out/refused")" -eq 1 ]
}

named() {
    grep -q "invcal-$version\.tar\.gz" "$tree/port/README.md" &&
        ! grep -o 'invcal-[0-9.]*\.tar' "$tree/port/README.md" | grep -vFx "invcal-$version.tar"
}

# What it writes is kept for later releases.
kept() {
    releases=$tree/tests/reference/releases
    grep -q "^## $version " "$tree/CHANGELOG.md" && [ -s "$releases/$version.txt" ] &&
        grep -q "^| $version |" "$releases/README.md"
}

check "make dist makes tarball and packages" made
check "made again in another clone, it has the same bytes" made_again
check "it refuses to leave out what is not committed" refuses_change
check "it holds the files of the commit" is_complete
check "owner and time are the same for all of them" is_of_root
check "make demo works in it" demo_works
check "make packages works in it" packages_are_laid_out
check "the packages are zipped, as make package lays them out" packages_are_zipped
check "make dist in it says that it needs a clone" refuses_dist
check "port/README.md names it" named
check "CHANGELOG.md lists it, and what it writes is kept" kept
[ -z "$FULL" ] || check "make test passes in it" all_tests_pass
finish
