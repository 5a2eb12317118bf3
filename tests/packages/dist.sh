#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The tarball of `make dist`, made of the last commit in clones, is the same each time, complete, and
# works by itself. FULL=1: all tests run in it.
. "$(dirname "$0")/../package.sh"
need git gzip tar cc
git clone -q "$root" "$out/one" || exit 1
version=$(sh "$out/one/port/version.sh")
tarball=build/invcal-$version.tar.gz
tree=$out/invcal-$version

made() {
    make -s -C "$out/one" dist
}

made_again() { # elsewhere, by somebody who has set other things
    git clone -q "$root" "$out/two" || return
    git -C "$out/two" config core.autocrlf true
    git -C "$out/two" config tar.umask 0077
    (
        umask 077
        TZ=Asia/Tokyo LC_ALL=C.UTF-8 GZIP=-1 make -s -C "$out/two" dist
    ) && cmp "$out/one/$tarball" "$out/two/$tarball"
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
    make -s -C "$tree" demo > "$out/demo" && grep -q '^Good: ' "$out/demo"
}

all_tests_pass() {
    make -s -C "$tree" test > "$out/test"
    result=$?
    tail -n 1 "$out/test"
    return $result
}

packages_are_laid_out() {
    make -s -C "$tree" packages && [ -s "$tree/build/packages/amalgamation/invcal/invcal.c" ]
}

# Only this asks git, and must not take a clone around it for its own: one line.
refuses_dist() {
    ! make -s -C "$tree" dist 2> "$out/refused" && grep -q 'is made from a clone$' "$out/refused" &&
        [ "$(grep -vc '^make' "$out/refused")" -eq 1 ]
}

named() {
    grep -q "invcal-$version\.tar\.gz" "$tree/port/README.md" &&
        ! grep -o 'invcal-[0-9.]*\.tar' "$tree/port/README.md" | grep -vFx "invcal-$version.tar"
}

# What it writes is kept for those that come after it.
kept() {
    releases=$tree/tests/reference/releases
    grep -q "^## $version " "$tree/CHANGELOG.md" && [ -s "$releases/$version.txt" ] &&
        grep -q "^| $version |" "$releases/README.md"
}

check "make dist makes a tarball" made
check "made again in another clone, it is the same bytes" made_again
check "what is not committed is not forgotten" refuses_change
check "it holds the files of the commit" is_complete
check "owner and time are the same for all of them" is_of_root
check "make demo works in it" demo_works
check "make packages works in it" packages_are_laid_out
check "make dist in it says that there is no clone" refuses_dist
check "port/README.md names it" named
check "CHANGELOG.md has it, and what it writes is kept" kept
[ -z "$FULL" ] || check "make test passes in it" all_tests_pass
finish
