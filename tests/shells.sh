#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/shells.sh BUILD
# The scripts that `make test` runs, with the tool in BUILD, under other shells and awks than this machine's: `sh` and
# `awk` are the first ones in PATH. What builds and demonstrates needs an awk, too, even one without mathematics, as
# that of Debian's busybox. ONLY: see run.sh. BUSYBOX: another one. Ends with `N passed, N failed`.
build=$1
cd "$(dirname "$0")/.." || exit 1
. tests/target.sh
busybox=${BUSYBOX:-busybox}
need mawk gawk original-awk bash dash "$busybox" || exit 1
passed=0
failed=0
rm -rf "$build/shells"

result() { # 0 or 1, SENTENCE
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
        echo "shells: $2: PASS"
    else
        failed=$((failed + 1))
        echo "shells: $2: FAIL"
    fi
}

# Lays out $out, with what run.sh takes from BUILD, and sets $path. Links, as a shell and busybox go by their names.
lay_out() { # SHELL AWK...
    out=$build/shells/$(basename "$1")-$(basename "$2")
    mkdir -p "$out/bin" || exit 1
    for part in float double tool words invcal; do
        ln -s "../../$part" "$out/$part"
    done
    path=$(cd "$out/bin" && pwd):$PATH
    ln -s "$(command -v "$1")" "$out/bin/sh"
    shift
    case $# in
    1) ln -s "$(command -v "$1")" "$out/bin/awk" ;;
    *) printf '#!/bin/sh\nexec %s "$@"\n' "$*" > "$out/bin/awk" && chmod +x "$out/bin/awk" ;;
    esac
}

under() { # SHELL AWK...
    lay_out "$@"
    shell=$1
    shift
    env PATH="$path" PART=host LONG='' ONLY="${ONLY:-^[a-z0-9_]+\$}" sh tests/run.sh "$out" > "$out/log" 2>&1
    counts=$(tail -n 1 "$out/log" | grep -E '^[0-9]+ passed, [0-9]+ failed$' || echo '0 passed, 1 failed')
    case $counts in *', 0 failed') ;; *) sed '$d' "$out/log" ;; esac
    echo "shells: sh is $shell, awk is $*: $counts"
    passed=$((passed + ${counts%% *}))
    counts=${counts#*, }
    failed=$((failed + ${counts% *}))
}

# What make does with awk before any test.
same() { # COMMAND...: it prints the same there
    "$@" > "$out/here" && env PATH="$path" "$@" > "$out/there" && cmp "$out/here" "$out/there"
}
# shellcheck disable=SC2016 # for that shell
amalgamates='mkdir "$0" && sh port/amalgamation/amalgamate.sh "$0" && cat "$0/invcal.h" "$0/invcal.c" && rm -r "$0"'
builds_the_same() { # AWK
    same awk -f tests/data/to_c.awk tests/data/*_positions.csv && same sh port/host/man.sh "$build/invcal" &&
        same sh -c "$amalgamates" "$out/two" &&
        env PATH="$path" make help > "$out/there" && grep -q '^make check-shells ' "$out/there"
    result $? "with $1 make builds the same"
}
refuses_tests() { # in one line
    ! env PATH="$path" PART=host sh tests/run.sh "$out" > "$out/said" 2>&1 && cat "$out/said" &&
        [ "$(wc -l < "$out/said")" -eq 1 ] && grep -q '^awk has no mathematics' "$out/said"
    result $? "an awk without mathematics is refused"
}

under "$busybox" original-awk
builds_the_same original-awk
under bash gawk --posix
if "$busybox" awk 'BEGIN { exit sqrt(4) != 2 }' 2> /dev/null; then
    under dash "$busybox"
else
    under dash mawk
    lay_out dash "$busybox"
    refuses_tests
fi
builds_the_same "$busybox"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
