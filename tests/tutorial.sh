#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Follows a page of the manual word by word: sh tests/tutorial.sh BUILD PAGE. CC and CFLAGS as for the
# library.
#
#     ```sh          is run, block after block in one shell, which stops at the first failure
#     ```text        after it, is what that prints; `...` stands for any text, or on a line of its own for any lines
#     ```c, ```cpp   is saved under the name in its first line, and compiles without a warning
#     ```python      is saved under the name in its first line
#
# `git clone` copies this tree and what BUILD contains, so nothing is built twice; `cc` is $CC, and
# $INVCAL this tree. C++ is skipped without a compiler for it. Ends with `N passed, N failed`.
build=$(cd "$1" && pwd) || exit 1
cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
page=$root/port/manual/$2.md
out=$build/tutorial/$2
passed=0
failed=0
rm -rf "$out"
mkdir -p "$out/work" || exit 1

result() { # 0 or 1, SENTENCE
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
        echo "$2: PASS"
    else
        failed=$((failed + 1))
        echo "$2: FAIL"
    fi
}

# Turns the page into a script, and what it must print into $out/N.text.
awk -v out="$out" '
    /^```/ && kind != "" {
        if (kind == "c" || kind == "python") print "END_OF_FILE"
        if (kind == "c") print "compiles " name
        if (kind == "sh") print "} > \"$out/" n ".said\" 2>&1"
        kind = ""
        next
    }
    /^```sh$/ { print "echo " ++n " > \"$out/step\"\n{"; kind = "sh"; next }
    /^```text$/ { kind = "text"; next }
    /^```(c|cpp|python)$/ { kind = "name"; language = substr($0, 4); next }
    kind == "name" { # /* name.c ... */ or // name.cpp or # name.py
        name = $2
        print "cat > " name " << \"END_OF_FILE\""
        kind = language == "python" ? language : "c"
    }
    kind == "text" { print > (out "/" n ".text") }
    kind == "sh" || kind == "c" || kind == "python"' "$page" > "$out/script"

# Functions for the script.
git() { # clone ADDRESS FOLDER
    mkdir "$3" "$3/build" "$3/build/float" "$3/build/double" &&
        cp -Rp "$root/Makefile" "$root/README.md" "$root/include" "$root/src" "$root/port" "$root/tests" "$3" &&
        cp -Rp "$build/words" "$build/tool" "$build/invcal" "$3/build" &&
        cp -Rp "$build/float/src" "$build/float/libinvcal.a" "$3/build/float" &&
        cp -Rp "$build/double/src" "$build/double/libinvcal.a" "$3/build/double"
}
# shellcheck disable=SC2086 # words
cc() { command ${CC:-cc} $CFLAGS "$@"; }
# shellcheck disable=SC2086
compiles() { # NAME
    case $1 in
    *.c) compiler=${CC:-cc} std=c99 ;;
    *) compiler=$(command -v c++ || command -v clang++-19) std=c++11 ;;
    esac
    [ -n "$compiler" ] || { echo "$1 is not tried: there is no C++ compiler"; return 0; }
    $compiler -std=$std -Wall -Wextra -pedantic -Werror -I"$root/include" -I. -c "$1" -o "$1.o" \
        > "$out/$1.log" 2>&1 && echo 0 > "$out/$1.compiled" || echo 1 > "$out/$1.compiled"
}

(
    unset MAKEFLAGS MAKELEVEL COLUMNS
    # shellcheck disable=SC2034 # the page uses it
    INVCAL=$root
    PATH=$build:$PATH # for the tool
    cd "$out/work" && set -e
    # shellcheck source=/dev/null
    . "$out/script"
)
status=$?
step=$(cat "$out/step" 2> /dev/null || echo 0)
if [ "$status" -ne 0 ]; then
    cat "$out/$step.said" 2> /dev/null
    result 1 "$2: block $step ends with exit status $status"
fi

for file in "$out"/*.compiled; do
    [ -s "$file" ] || continue
    name=$(basename "$file" .compiled)
    cat "$out/$name.log"
    result "$(cat "$file")" "$2: $name compiles without a warning"
done

# Compares what a block printed with the page, line by line.
agrees() { # PAGE SAID
    awk 'function pattern(line) {
            gsub(/[][\\^$.|?*+(){}]/, "\\\\&", line)
            gsub(/\\\.\\\.\\\./, ".*", line)
            return "^" line "$"
        }
        NR == FNR { want[++wanted] = $0; next }
        { said[++n] = $0 }
        END {
            for (w = 1; w <= wanted; w++) {
                if (want[w] == "...") { any = 1; continue }
                while (any && i < n && said[i + 1] !~ pattern(want[w])) i++
                any = 0
                if (said[++i] !~ pattern(want[w])) {
                    print "wanted:  " want[w] "\nprinted: " said[i]
                    exit 1
                }
            }
            if (!any && i < n) { print "also printed: " said[i + 1]; exit 1 }
        }' "$1" "$2"
}

for text in "$out"/*.text; do
    n=$(basename "$text" .text)
    [ -e "$text" ] && [ "$n" -le "$step" ] || continue
    agrees "$text" "$out/$n.said"
    result $? "$2: block $n prints what the page says"
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
