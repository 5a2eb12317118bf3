#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/dist.sh FOLDER
# Makes FOLDER/invcal-VERSION.tar.gz of the last commit, and prints its SHA-256. The same commit gives
# the same bytes in every clone, by the same git and gzip: names in order, root as owner, the time of
# the commit, no time in the gzip header, and nothing of what a user or machine has set for git.
fail() {
    echo "dist.sh: $1" >&2
    exit 1
}

[ $# -eq 1 ] || fail "usage: sh port/dist.sh FOLDER"
mkdir -p "$1" || fail "$1 cannot be made"
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/.." || exit 1
# In a tarball that was unpacked within some other clone, git would answer for that.
git ls-files --error-unmatch port/dist.sh > /dev/null 2>&1 ||
    fail "git does not know these files: a tarball is made from a clone"
changed=$(git status --porcelain | head -n 1)
[ -z "$changed" ] || fail "a tarball is made of the last commit, which lacks this: $changed"
name=invcal-$(sh port/version.sh) || exit 1

export GIT_ATTR_NOSYSTEM=1 GIT_CONFIG_NOSYSTEM=1 GIT_CONFIG_GLOBAL=/dev/null
unset GZIP
git -c tar.umask=0022 -c core.autocrlf=false archive --format=tar --prefix="$name/" -o "$folder/$name.tar" HEAD ||
    fail "git archive failed"
gzip -9 -n -f "$folder/$name.tar" || fail "gzip failed"
cd "$folder" && sha256sum "$name.tar.gz"
