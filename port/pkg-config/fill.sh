#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Writes invcal.pc and invcal-double.pc into folder $1, with $prefix and $choices from the environment. Whatever the
# prefix contains: pkg-config reads a backslash before a character as a shell does.
here=$(dirname "$0")
version=$(sh "$here/../version.sh") && address=$(sh "$here/../address.sh") || exit
export version address
prefix=$(printf '%s' "$prefix" | sed 's|[^A-Za-z0-9/._+-]|\\&|g')
export prefix choices
for name in invcal invcal-double; do
    awk '
        function fill(line, mark, text,    at) {
            at = index(line, mark)
            return at ? substr(line, 1, at - 1) text substr(line, at + length(mark)) : line
        }
        {
            line = fill($0, "@PREFIX@", ENVIRON["prefix"])
            line = fill(line, "@VERSION@", ENVIRON["version"])
            line = fill(line, "@ADDRESS@", ENVIRON["address"])
            line = fill(line, "@CHOICES@", ENVIRON["choices"])
            sub(/ *$/, "", line)
            print line
        }' "$here/$name.pc.in" > "$1/$name.pc" || exit
done
