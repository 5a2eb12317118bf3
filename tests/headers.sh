#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/headers.sh
# The headers stay small enough to be read, and hold no function that nobody calls: each is called by a program, the
# tool, the page or the manual, or its comment, or that of its section or header, says what for: "for a memory".
cd "$(dirname "$0")/.." || exit 1
failed=0

most() { # WHAT COUNT LIMIT
    if [ "$2" -gt "$3" ]; then
        echo "$2 $1, at most $3"
        failed=1
    fi
}
functions() { # HEADER...: name, and 1 if it is said what for
    awk 'FNR == 1 { file = section = own = 0; level = "file" }
        FNR > 1 && /^\/\*/ { level = /^\/\* ----/ ? "section" : "own" }
        /^\/\* ----/ { section = 0 }
        /^\/\*/ { own = 0 }
        /[Ff]or a (memory|device)/ { if (level == "file") file = 1; else if (level == "section") section = 1; else own = 1 }
        /^(static|typedef|#|\/| )/ { next }
        match($0, /invcal_[a-z0-9_]+\(/) { print substr($0, RSTART, RLENGTH - 1), file || section || own }' "$@"
}

most 'functions in the headers' "$(functions include/invcal/*.h | wc -l)" 120
most 'words in the headers' "$(cat include/invcal/*.h | wc -w)" 16000
most 'functions in invcal.h' "$(functions include/invcal/invcal.h | wc -l)" 20
most 'lines in invcal.h' "$(wc -l < include/invcal/invcal.h)" 300
callers=$(find README.md port -name '*.[ch]' -o -name '*.ino' -o -name '*.cpp' -o -name '*.js' -o -name '*.md' |
    grep -v 'manual/migration\.md\|manual/errors\.md\|manual/mathematics')
for entry in $(functions include/invcal/*.h | tr ' ' ,); do
    # shellcheck disable=SC2086 # files are words
    if [ "${entry#*,}" = 0 ] && ! grep -qw "${entry%,*}" $callers; then
        echo "${entry%,*}: nobody calls it, and no comment says what it is for"
        failed=1
    fi
done
exit $failed
