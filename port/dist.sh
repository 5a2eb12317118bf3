#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/dist.sh FOLDER
# Makes a release of the last commit in FOLDER/dist, which it empties first:
#
#     invcal-VERSION.tar.gz            the sources
#     invcal-VERSION-PACKAGE.zip       each package as it is laid out; the IDE of Arduino can add its zip
#     invcal.invcal.VERSION.pack       the CMSIS pack, by the name that it must have
#     SHA256SUMS                       of these
#
# The same commit gives the same bytes in every clone, with the same git, gzip and zip: sorted names, root as owner,
# the time of the commit, no time in the gzip header, and no git settings of the user or the machine.
fail() {
    echo "dist.sh: $1" >&2
    exit 1
}

[ $# -eq 1 ] || fail "usage: sh port/dist.sh FOLDER"
mkdir -p "$1" || fail "$1 cannot be made"
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/.." || exit 1
# In a tarball unpacked inside some other clone, git would answer for that clone.
git ls-files --error-unmatch port/dist.sh > /dev/null 2>&1 ||
    fail "git does not know these files: a tarball is made from a clone"
changed=$(git status --porcelain | head -n 1)
[ -z "$changed" ] || fail "a tarball is made of the last commit, which lacks this: $changed"
version=$(sh port/version.sh) || exit 1
name=invcal-$version
case $(sh port/address.sh) in
*//example.org/*) echo "dist.sh: the project's address is not set yet: port/address.sh" >&2 ;;
esac

export GIT_ATTR_NOSYSTEM=1 GIT_CONFIG_NOSYSTEM=1 GIT_CONFIG_GLOBAL=/dev/null LC_ALL=C TZ=UTC
unset GZIP ZIPOPT
umask 022
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
rm -rf "$folder/dist" && mkdir "$folder/dist" || fail "$folder/dist cannot be made"
git -c tar.umask=0022 -c core.autocrlf=false archive --format=tar --prefix="$name/" -o "$work/$name.tar" HEAD ||
    fail "git archive failed"
tar -xf "$work/$name.tar" -C "$work" || fail "tar failed"
gzip -9 -n "$work/$name.tar" && mv "$work/$name.tar.gz" "$folder/dist" || fail "gzip failed"

# The packages, from the sources in the tarball. A zip contains a folder invcal; the pack does not.
time=$(git log -1 --format=%ct)
pack() { # PACKAGE FOLDER ZIP
    sh "$work/$name/port/stage.sh" "$1" "$work/$1/$2" && rm "$work/$1/$2/.invcal-$1" &&
        find "$work/$1" -exec touch -d "@$time" {} + &&
        (cd "$work/$1" && find . -type f | sed 's|^\./||' | sort | zip -q -9 -X "$folder/dist/$3" -@) ||
        fail "$3 cannot be made"
}
for list in port/*/files; do
    package=$(basename "$(dirname "$list")")
    case $package in
    cmsis-pack) pack $package . "invcal.invcal.$version.pack" ;;
    amalgamation) pack $package . "$name-$package.zip" ;;
    *) pack "$package" invcal "$name-$package.zip" ;;
    esac
done
cd "$folder/dist" && sha256sum -- * > "$work/sums" && mv "$work/sums" SHA256SUMS && cat SHA256SUMS
