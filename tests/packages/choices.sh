#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# A program and a library that were compiled with different options have different structures. With another
# number type no function links; with another capacity every _init refuses its structure, see choices.c.
. "$(dirname "$0")/../package.sh"
need cc

awk -f tests/prototypes.awk include/invcal/*.h | sed 's/(.*//; s/.*[ *]//' | sort -u > "$out/functions"

# A program that uses them all.
{
    printf '#include "%s"\n' include/invcal/*.h | sed 's|include/||'
    awk '{ print "    (void (*)(void))" $0 "," }
        BEGIN { print "void (*volatile const functions[])(void) = {" }
        END { print "};\nint main(void) { return functions[0] == 0; }" }' "$out/functions"
} > "$out/all.c"

links() { # LIBRARY FLAG...
    library=$1
    shift
    cc -std=c99 -O1 -Iinclude "$@" "$out/all.c" "$library" -lm -o "$out/all"
}

# Not one of them.
refuses() { # LIBRARY FLAG...
    ! links "$@" > "$out/said" 2>&1 &&
        [ "$(grep -o "undefined reference to .invcald*_[a-z0-9_]*" "$out/said" | sort -u | wc -l)" -eq \
            "$(wc -l < "$out/functions")" ]
}

check "a float library has every function of the headers" links "$build/float/libinvcal.a"
check "a double library has every function of the headers" links "$build/double/libinvcal.a" -DINVCAL_DOUBLE=1
check "a double program finds no function in a float library" refuses "$build/float/libinvcal.a" -DINVCAL_DOUBLE=1
check "a float program finds no function in a double library" refuses "$build/double/libinvcal.a"

# Both in one program: no name is in both.
both() {
    nm -g --defined-only "$build/float/libinvcal.a" "$build/double/libinvcal.a" |
        awk 'NF == 3 { print $3 }' | sort | uniq -d > "$out/twice"
    [ ! -s "$out/twice" ]
}
check "a float and a double library have no name in common" both

# refused STRUCTURES OPTION...: a program with these options, and the library as it is
refused() {
    structures=$1
    shift
    for structure in SESSION MOVES ALLAN; do
        case $structures in
        *$structure*) set -- "$@" -D$structure=1 ;;
        *) set -- "$@" -D$structure=0 ;;
        esac
    done
    cc -std=c99 -O1 -w -Iinclude "$@" tests/packages/choices.c "$build/float/libinvcal.a" -lm -o "$out/choices" &&
        "$out/choices"
}
for option in MAX_POSITIONS=12 MAX_POSITIONS=23 MAX_POSITIONS=25 MAX_POSITIONS=64; do
    check "$option: a session, and one in the background, are refused" refused SESSION -DINVCAL_$option
done
for option in MAX_SEGMENTS=64 MAX_SEGMENTS=191 MAX_SEGMENTS=193 MAX_SEGMENTS=1000; do
    check "$option: moves are refused" refused MOVES -DINVCAL_$option
done
for option in ALLAN_TAUS=1 ALLAN_TAUS=15 ALLAN_TAUS=17 ALLAN_TAUS=31; do
    check "$option: an Allan deviation is refused" refused ALLAN -DINVCAL_$option
done
check "all of them at once" refused SESSION+MOVES+ALLAN -DINVCAL_MAX_POSITIONS=64 -DINVCAL_MAX_SEGMENTS=100 \
    -DINVCAL_ALLAN_TAUS=8
# All structures are those of the library: no _init refuses.
same() { # FLAG
    ! refused SESSION+MOVES+ALLAN "$1" > "$out/said" &&
        for function in session_init background_init imu_init allan_init; do
            grep -qx $function "$out/said" || return 1
        done
}
for option in FAST=1 THERMAL_DEGREE=0 THERMAL_DEGREE=2; do
    check "$option changes no structure" same -DINVCAL_$option
done
finish
