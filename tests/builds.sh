#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # target_facts sets what is not set here
#
# sh tests/builds.sh BUILD [TARGET...]
# The library must compute the same bits however it is built. Builds the digest (tests/digest) from
# separate sources, from the amalgamation and with link-time optimisation, at every level, with gcc and,
# for Arm and this machine, with clang; runs it, and compares it with what BUILD/float/digest prints.
# Nor may gcc take any access for one through a null pointer (port/manual/porting.md, "Compilers").
#
# A build has a name: m4f amalgamation -Os gcc. ONLY: a pattern for the names; BRIEF=1: a dozen.
# Prints the builds that differ or that a target is too small for, a line for each target, and at the
# end `N passed, N failed`. `--one BUILD TARGET SOURCES LEVEL COMPILER [fast]` makes one of them, as
# xargs does.
cd "$(dirname "$0")/.." || exit 1
. tests/target.sh
limit=200 # seconds for one program
too_large='overflowed by|will not fit in|is not within region'

# ---- which builds -----------------------------------------------------------------------------

# For Cortex-M3 and M7 clang optimises as for the M0+ and the M4F.
has_clang() {
    case $1 in */host | */m0plus | */m4f | */m33) return 0 ;; esac
    return 1
}

every_build() { # TARGET...
    for target; do
        for sources in separate amalgamation lto; do
            for level in -O0 -Og -Os -O1 -O2 -O3; do
                echo "$target $sources $level gcc"
            done
            for level in -O0 -Os -Oz -O1 -O2 -O3; do
                ! has_clang "$target" || echo "$target $sources $level clang"
            done
        done
    done
}

# With INVCAL_FAST=1 loops are unrolled, and functions inlined.
fast_builds() {
    cat << 'EOT'
tests/builds/host lto -O3 gcc fast
port/cortex-m/m0plus amalgamation -O2 gcc fast
port/cortex-m/m4f separate -O2 gcc fast
port/cortex-m/m4f amalgamation -Os gcc fast
port/cortex-m/m4f lto -O3 gcc fast
port/cortex-m/m4f amalgamation -O2 clang fast
port/cortex-m/m33 separate -O3 gcc fast
port/riscv/rv32imac amalgamation -O1 gcc fast
port/riscv/rv32imafc lto -O2 gcc fast
EOT
}

# Each kind of target, way, level and compiler.
brief_builds() {
    cat << 'EOT'
port/avr/atmega1284p amalgamation -Os gcc
port/cortex-m/m0plus amalgamation -O1 gcc
port/cortex-m/m0plus lto -O2 clang
tests/builds/m3 separate -O3 gcc
port/cortex-m/m4f separate -O2 gcc
port/cortex-m/m4f amalgamation -Os gcc
port/cortex-m/m4f lto -O2 gcc
port/cortex-m/m4f amalgamation -O2 gcc fast
port/cortex-m/m4f amalgamation -Oz clang
port/riscv/rv32imac amalgamation -O3 gcc
tests/builds/host amalgamation -O0 gcc
tests/builds/host lto -O3 clang
EOT
}

wanted_builds() { # TARGET...
    if [ "$BRIEF" ]; then
        brief_builds
    elif [ $# -gt 0 ]; then
        every_build "$@"
    else
        every_build tests/builds/host port/cortex-m/m0plus tests/builds/m3 port/cortex-m/m4f \
            port/cortex-m/m7 port/cortex-m/m33 port/riscv/rv32imac port/riscv/rv32imafc port/powerpc \
            port/avr/atmega1284p
        fast_builds
    fi | awk -v only="$ONLY" '{ name = $0; sub(/^[^ ]*\//, "", name) } name ~ only'
}

# ---- one build --------------------------------------------------------------------------------

# A tree in which the two files of the amalgamation replace the sources and include; the digest needs internal headers.
lay_amalgamation() {
    rm -rf "$tree" && mkdir -p "$tree/src" "$tree/include/invcal" &&
        sh port/stage.sh amalgamation "$tree/staged" && mv "$tree/staged/invcal" "$tree/src" || return
    for header in include/invcal/*.h; do
        cp "$tree/src/invcal/invcal.h" "$tree/$header" || return
    done
    for header in src/*/*.h; do
        mkdir -p "$tree/${header%/*}" && cp "$header" "$tree/${header%/*}" || return
    done
    ln -s "$PWD/port" "$PWD/tests" "$tree"
}

# The C library is gcc's. Newlib's headers need two macros that only gcc predefines.
clang_for_arm='clang-19 --target=arm-none-eabi -isystem /usr/include/newlib'
clang_for_arm="$clang_for_arm '-D__INT32_C(c)=c##L' '-D__UINT32_C(c)=c##UL'"
link_for_arm() {
    # shellcheck disable=SC2086 # flags are words
    libc=$($compiler $cpu -print-file-name=libc_nano.a) libgcc=$($compiler $cpu -print-libgcc-file-name)
    echo "-fuse-ld=lld -nostdlib -Wl,-T,port/cortex-m/sections.ld -L $target $libc ${libc%/*}/libm.a $libgcc"
}

# What gcc believes to be uninitialised depends on the level.
compile() { # BUILD COMPILER OPTIONS
    case $2-$target in
    gcc-*)
        target_make "$1" "$target" digest \
            OPT="$3 -Wno-maybe-uninitialized -fdump-tree-local-pure-const-details"
        ;;
    clang-*/host) target_make "$1" "$target" digest OPT="$3" CC=clang-19 LINK='-lm -fuse-ld=lld' ;;
    clang-*) target_make "$1" "$target" digest OPT="$3" CC="$clang_for_arm" LINK="$(link_for_arm)" ;;
    esac
}

build() { # SOURCES LEVEL COMPILER [fast]
    options=$2${4:+ -DINVCAL_FAST=1}
    case $1 in
    separate) compile "$place" "$3" "$options" ;;
    lto) compile "$place" "$3" "$options -flto" ;;
    amalgamation) cd "$tree" && compile "../${place##*/}" "$3" "$options" ;;
    esac
}

# Without optimisation gcc does not look for them.
null_accesses() { # LEVEL
    if [ "$1" != -O0 ] && ! find "$place" -name '*.local-pure-const*' | grep -q .; then
        echo "gcc does not say where it sees a NULL memory access"
    fi
    find "$place" -name '*.local-pure-const*' -exec awk '
        /^;; Function / { name = $3 }
        /NULL memory access/ {
            source = FILENAME
            gsub(/.*\/|\.[0-9]+t\.local-pure-const.*/, "", source)
            print "a NULL memory access in " name " (" source ")"
        }' {} + | sort -u
}

run_programs() {
    for image in "$out"/*.elf; do
        # shellcheck disable=SC2086 # the command and its options
        timeout -k 5 $limit $run "$image" < /dev/null 2>&1 | head -n 20000 > "${image%.elf}.log"
    done
}

# `same`, or what is wrong with the build.
judge() { # SOURCES LEVEL COMPILER [fast]
    if ! (build "$@") > "$place/make.log" 2>&1; then
        why=$(grep -m 1 -E "$too_large|error|undefined" "$place/make.log" || tail -n 1 "$place/make.log")
        echo "it cannot be built: $why"
        return
    fi
    run_programs
    bits=$(awk -f tests/digest/compare.awk "$builds/host.log" "$out"/digest*.log)
    null=
    [ "$3" != gcc ] || null=$(null_accesses "$2" | paste -s -d ',' - | sed 's/,/, /g')
    case $bits in
    same) echo "${null:-same}" ;;
    *) echo "$bits${null:+; $null}" ;;
    esac
}

one() { # TARGET SOURCES LEVEL COMPILER [fast]
    name=$(echo "${1##*/} $2 $3 $4 $5" | sed 's/ $//')
    place=$builds/$(echo "$name" | tr ' ' _)
    target=$1
    shift
    rm -rf "$place"
    mkdir -p "$place" && target_facts "$place" "$target" || return
    result=$(judge "$@")
    echo "$name: $result" > "$place.result"
    [ "$result" != same ] || rm -rf "$place"
}

# ---- all of them ------------------------------------------------------------------------------

summarize() {
    awk -v too_large="$too_large" '
        !($1 in of) { targets[++n] = $1 }
        { of[$1]++ }
        / same$/ { same[$1]++; next }
        { print }
        $0 ~ too_large { large[$1]++ }
        END {
            for (i = 1; i <= n; i++) {
                t = targets[i]
                printf "%s: %d builds, %d the same%s\n", t, of[t], same[t],
                    large[t] ? ", " large[t] " too large for it" : ""
                passed += same[t]
                failed += of[t] - same[t] - large[t]
            }
            print passed + 0 " passed, " failed + 0 " failed"
            exit failed > 0 || !passed
        }'
}

if [ "$1" = --one ]; then
    builds=$2/builds
    tree=$builds/tree
    shift 2
    one "$@"
    exit
fi
build=$1
builds=$1/builds
tree=$builds/tree
shift
need gcc clang-19 ld.lld-19 || exit 1
mkdir -p "$builds"
rm -f "$builds"/*.result
wanted_builds "$@" > "$builds/list"
cut -d ' ' -f 1 "$builds/list" | sort -u > "$builds/targets"
while read -r target; do
    target_facts "$builds" "$target" && need "$compiler" "$emulator" || exit 1
done < "$builds/targets"
lay_amalgamation && "$build/float/digest" > "$builds/host.log" || exit 1
xargs -L 1 -P 2 sh tests/builds.sh --one "$build" < "$builds/list"
while read -r target rest; do
    name="${target##*/} $rest"
    cat "$builds/$(echo "$name" | tr ' ' _).result" 2> /dev/null || echo "$name: it did not end"
done < "$builds/list" | summarize
