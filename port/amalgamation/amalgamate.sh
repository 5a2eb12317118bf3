#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/amalgamation/amalgamate.sh FOLDER
# Turns the whole library into two files in FOLDER: invcal.h from include/invcal, and invcal.c from src. A
# header precedes the first that includes it; system headers are on top, once. The other names of
# include/invcal forward to invcal.h. The same sources give the same bytes.
if [ $# -ne 1 ] || [ ! -d "$1" ]; then
    echo "usage: sh port/amalgamation/amalgamate.sh FOLDER" >&2
    exit 2
fi
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.." || exit 2
export LC_ALL=C # the order of a glob, and of sort
version=$(sh port/version.sh) || exit 2

join() { # FOLDER FILE...: the files, and before each what it includes from FOLDER, include or src
    awk -v folder="$1" '
        function beside(file, name) { # "vector.h" or "../core/vector.h"
            sub(/[^\/]*$/, "", file)
            if (sub(/^\.\.\//, "", name)) {
                sub(/[^\/]*\/$/, "", file)
            }
            return file name
        }
        function add(file,    line, body, part) {
            if (file in added) {
                return
            }
            added[file]
            while ((getline line < file) > 0) {
                if (line ~ /^#include </) {
                    if (!(line in hoisted)) {
                        hoisted[line]
                        top = top line "\n"
                    }
                } else if (line ~ /^#include "/) {
                    split(line, part, "\"")
                    if (folder == "include") {
                        add("include/" part[2])
                    } else if (part[2] !~ /^invcal\//) {
                        add(beside(file, part[2]))
                    }
                } else if (line != "" || body !~ /\n\n$/) {
                    sub(/SPDX-License-Identifier: MIT/, "==== " file " ====", line)
                    body = body line "\n"
                }
            }
            close(file)
            if (body == "") {
                print "amalgamate.sh: " file " cannot be read" > "/dev/stderr"
                failed = 1
            }
            text = text "\n" body
        }
        BEGIN {
            for (i = 2; i < ARGC; i++) {
                add(ARGV[i])
            }
            printf "%s%s", top, text
            exit failed
        }' "$@"
}

begin() { # FILE: licence and version
    printf '/* SPDX-License-Identifier: MIT\n *\n * %s\n *\n' "$1"
    sed -e 's/^/ * /' -e 's/ *$//' LICENSE
    printf ' */\n'
}

{
    begin "invcal $version, the whole library: put invcal.c into your build, as C or C++, and link with -lm."
    printf '#ifndef INVCAL_AMALGAMATION_H\n#define INVCAL_AMALGAMATION_H\n\n'
    join include include/invcal/invcal.h include/invcal/*.h || exit 2
    printf '\n#endif\n'
} > "$folder/invcal.h"
{
    begin "invcal $version, the whole library: invcal.h is its manual."
    printf '#include "invcal.h"\n\n'
    printf '#ifdef __cplusplus\n#define restrict __restrict /* no word of C++, but of its compilers */\n#endif\n\n'
    # In the order of file names: in another one, some local names would shadow types of other files.
    # shellcheck disable=SC2046 # names without blanks
    join src $(printf '%s\n' src/*/*.c | sort -t / -k 3) || exit 2
} > "$folder/invcal.c"
for header in include/invcal/*.h; do
    name=${header##*/}
    [ "$name" = invcal.h ] || printf '/* SPDX-License-Identifier: MIT */\n#include "invcal.h"\n' > "$folder/$name"
done
