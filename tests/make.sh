#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh tests/make.sh FOLDER
# What make builds again, one object for all of a kind, and what it refuses, in one line. FOLDER is a path from the
# root of the sources.
cd "$(dirname "$0")/.." || exit 1
out=$1
passed=0
failed=0
# What is tested is stated below, and nothing else.
unset MAKEFLAGS MFLAGS MAKELEVEL CC CFLAGS STD DEGREE ASSERT LONG UNITY BUILD OPT REAL QUICK PART TYPES V
rm -rf "$out"
mkdir -p "$out" || exit 1

check() { # SENTENCE COMMAND...
    sentence=$1
    shift
    if "$@" > "$out/log" 2>&1; then
        echo "make: $sentence: PASS"
        passed=$((passed + 1))
    else
        cat "$out/log"
        echo "make: $sentence: FAIL"
        failed=$((failed + 1))
    fi
}

# The compiler with which nothing but an object of the host's is made, for a target too.
host() { make -s BUILD="$out" "$@"; }
target() { make -s -f port/build.mk TARGET=port/powerpc PREFIX= BUILD="$out" "$@"; }

is_current() { # host|target FILE OPTION...
    how=$1
    shift
    "$how" -q "$@"
}
# Not current, as it was made with other words; made again it is.
follows() { # host|target FILE OPTION...
    how=$1
    shift
    ! is_current "$how" "$@" && "$how" "$@" && is_current "$how" "$@"
}
keeps() { "$1" "$2" && is_current "$@"; }

library=$out/float/src/allan/noise.o
tool=$out/tool/port/host/maths/median.o
unit=$out/float/tests/unit/test_moves_few.o
device=$out/powerpc/src/allan/noise.o

for option in CFLAGS=-O0 CC='env cc' STD=c11 DEGREE=2 ASSERT=1 AR='env ar' ''; do
    check "the library follows ${option:-the defaults again}" follows host "$library" ${option:+"$option"}
done
for option in CFLAGS=-O0 CC='env cc' STD=c11 ASSERT=1 ''; do
    check "the tool follows ${option:-the defaults again}" follows host "$tool" ${option:+"$option"}
done
check "an option of the library is none of the tool" keeps host "$tool" CFLAGS='-O1 -DINVCAL_MAX_POSITIONS=64'
check "nor apart from its -D" keeps host "$tool" CFLAGS='-O1 -D INVCAL_MAX_POSITIONS=64'
check "nor are LONG and DEGREE" keeps host "$tool" LONG=1 DEGREE=2
check "nor is LONG one of the library" keeps host "$library" LONG=1
cp -R tests/unity "$out/unity"
for option in LONG=1 UNITY="$out/unity" ''; do
    check "the unit tests follow ${option:-the defaults again}" follows host "$unit" ${option:+"$option"}
done
check "the page follows STD" follows host "$out/words/page" STD=c11
for option in OPT=-Os REAL=1 CC='env cc' ''; do
    check "a target follows ${option:-the defaults again}" follows target "$device" ${option:+"$option"}
done
apart() { target "$device" && target "$out/powerpc-quick/src/allan/noise.o" QUICK=1 && is_current target "$device"; }
check "with QUICK it has a folder of its own" apart

# Without -MMD objects depend on all headers.
# shellcheck disable=SC2016 # for that shell
echo 'for word; do case $word in -MM*) exit 1 ;; esac; done; exec cc "$@"' > "$out/plain"
follows_headers() {
    host "$library" CC="sh $out/plain" && is_current host "$library" CC="sh $out/plain" &&
        make -s -W src/core/vector.h BUILD="$out" -n "$library" CC="sh $out/plain" > "$out/said" && [ -s "$out/said" ]
}
check "a compiler without -MMD builds, and follows headers" follows_headers

refuses() { # PATTERN host|target ARGUMENT...
    pattern=$1
    shift
    ! "$@" > "$out/said" 2>&1 && cat "$out/said" && [ "$(wc -l < "$out/said")" -eq 1 ] && grep -Eq -- "$pattern" "$out/said"
}
for flags in -DINVCAL_MAX_POSITION=64 '-O1 -D INVCAL_MAX_POSITION=64' "'-DINVCAL_MAX_POSITION(x)=x'"; do
    check "an unknown option is refused: CFLAGS=$flags" \
        refuses 'CFLAGS: INVCAL_MAX_POSITION is no option .* INVCAL_MAX_POSITIONS' host all CFLAGS="$flags"
done
check "for a target, too" refuses 'OPT: INVCAL_MAX_POSITION is no option' target tests OPT=-DINVCAL_MAX_POSITION=64
check "the number type is no flag" refuses 'CFLAGS: INVCAL_DOUBLE is not chosen there' host all CFLAGS=-DINVCAL_DOUBLE=1
# shellcheck disable=SC2016 # as they are
for folder in 'a b' "it's" 'a&b' 'a\b' 'a$$b' 'a=b' 'a(b'; do
    check "BUILD=$folder is refused" refuses '\*\*\* BUILD: rules of make cannot have' host all BUILD="$folder"
done
check "UNITY with a blank is refused" refuses '\*\*\* UNITY: rules of make cannot have' host test UNITY='a b'
check "a BUILD beyond ASCII is not" host "$out/Übung/float/src/allan/noise.o" BUILD="$out/Übung"

# Values out of range: the compiler's message names the option.
names() { # OPTION HEADER
    option=$1
    echo "#include \"invcal/$2.h\"" > "$out/value.c"
    ! cc -Iinclude "-D$option" -c "$out/value.c" -o "$out/value.o" 2> "$out/said" &&
        cat "$out/said" && grep -Eq "error: .*${option%%=*} must be" "$out/said"
}
for option in INVCAL_DOUBLE=2 INVCAL_FAST=2 INVCAL_MAX_POSITIONS=65; do
    check "$option is refused by name" names $option invcal
done
for option in MAX_SEGMENTS=1001:gyro THERMAL_DEGREE=3:thermal ALLAN_TAUS=0:allan; do
    check "INVCAL_${option%:*} is refused by name" names "INVCAL_${option%:*}" "${option#*:}"
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
