#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/sources.sh c|sh: the C sources that are formatted by .clang-format, or all shell scripts, a
# line each. Uses find, as an unpacked tarball has no git to ask.
cd "$(dirname "$0")/.." || exit 1
case $1 in
c) find include src port tests -name '*.[ch]' | grep -vE '^tests/(unity|reference)/' ;;
sh) find .ci/run port tests -type f '(' -name '*.sh' -o -name run ')' ;;
*)
    echo "usage: sh tests/sources.sh c|sh" >&2
    exit 2
    ;;
esac | sort
