#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What the finished library may contain: $1 is the build folder with float/ and double/.
# It needs from libc only memcpy, memset and square roots (fabs is allowed), it keeps
# no writable data, and its float build holds no double arithmetic.
build=$1
passed=0
failed=0

result() {
    if [ -z "$2" ]; then
        echo "library: $1: PASS"
        passed=$((passed + 1))
    else
        echo "library: $1: FAIL: $2"
        failed=$((failed + 1))
    fi
}

undefined() {
    nm -g "$1" | awk '$1 == "U" { wanted[$2] } NF == 3 { defined[$3] }
        END { for (name in wanted) if (!(name in defined)) print name }' |
        grep -vxE "$2" | tr '\n' ' '
}

writable() {
    size "$1" | awk 'NR > 1 && $2 + $3 > 0 { printf "%s has %d bytes of .data + .bss; ", $NF, $2 + $3 }'
}

# What is public is declared in a header; what is not has another prefix.
foreign() { # LIBRARY
    nm -g "$1" | awk '
        FILENAME != "-" {
            if (/^[a-zA-Z]/ && match($0, /invcal_[a-z0-9_]+\(/)) {
                name = substr($0, RSTART + 7, RLENGTH - 8)
                is_public["invcal_" name]
                is_public["invcald_" name]
            }
            next
        }
        NF == 3 && !($3 in is_public) && $3 !~ /^invcald?i_/ { printf "%s ", $3 }' include/invcal/*.h -
}

# Scalar and packed double instructions of SSE2. Other machines' have other names; the tests of the
# targets look for those.
doubles() {
    objdump -d "$1" | awk '/[ \t](cvtss2sd|cvtsd2ss|(add|sub|mul|div|sqrt|ucomi|comi|max|min)[sp]d)[ \t]/ { n++ }
        END { if (n) printf "%d double instructions", n }'
}

# Positions are computed: no tables in these modules. Single constants are not tables.
tables() {
    size -A "$1/src/plan/plan.o" "$1/src/core/circle.o" |
        awk '$1 ~ /^\.rodata/ && $1 !~ /^\.rodata\.cst/ { n += $2 }
            END { if (n > 64) printf "%d bytes of read-only data", n }'
}

# A folder of src calls, like includes, only those before it in folders.txt. What public headers declare, no include shows.
later() {
    nm -g "$1"/src/*/*.o | awk '
        FILENAME != "-" { place[$1] = FNR; next }
        /:$/ { n = split($0, part, "/"); folder = part[n - 2] "/" part[n - 1]; next }
        $1 == "U" { calls[folder, $2]; next }
        { home[$3] = folder }
        END {
            for (call in calls) {
                split(call, part, SUBSEP)
                if (part[2] in home && place[home[part[2]]] > place[part[1]]) printf "%s calls %s of %s; ", part[1], part[2], home[part[2]]
            }
        }' "${0%/*}/rules/folders.txt" -
}

for command in nm size objdump; do
    command -v $command > /dev/null || result "$command is there" "$command is not installed (binutils)"
done
for real in float double; do
    lib=$build/$real/libinvcal.a
    if [ ! -s "$lib" ]; then
        result "$real: the library is there" "$lib is missing"
        continue
    fi
    result "$real: the library is there" ""
    allowed='memcpy|memset|sqrtf|fabsf'
    [ $real = double ] && allowed='memcpy|memset|sqrt|fabs'
    # Sanitizers and coverage add code and data that are not the library's; tcc writes to no constant, but stores them
    # with the data, and copies structures by memmove, which clang makes of loops.
    case " $CFLAGS $(${CC:-cc} -v 2>&1)" in *-fsanitize* | *coverage* | *" tcc version"*)
        echo "library: $real: the rest is not tried: built with sanitizers, coverage or tcc"
        continue
        ;;
    *"clang version"*) allowed="$allowed|memmove" ;;
    esac
    result "$real: needs nothing but $allowed" "$(undefined "$lib" "$allowed")"
    result "$real: no writable data" "$(writable "$lib")"
    result "$real: plan and circle hold no table over 64 bytes" "$(tables "$build/$real")"
    result "$real: no folder of src calls one after it" "$(later "$build/$real")"
    result "$real: what no header declares begins with invcali_" "$(foreign "$lib")"
done
case " $CFLAGS$(uname -m)" in
*-fsanitize* | *coverage*) ;;
*x86_64) result "float: no double arithmetic" "$(doubles "$build/float/libinvcal.a")" ;;
*) echo "library: double arithmetic is not tried: this machine has other names for it than x86_64" ;;
esac

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
