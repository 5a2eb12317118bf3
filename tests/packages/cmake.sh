#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# CMake: the library installed and found by find_package, or fetched by FetchContent, here from this tree.
. "$(dirname "$0")/../package.sh"
need cmake cc arm-none-eabi-gcc
unset CFLAGS LDFLAGS
version=$(sh port/version.sh)
prefix=$out/prefix

# Not optimised: Release's -O3 takes four times as long.
installs() { # CHOICE...: into $prefix
    rm -rf "$prefix" "$out/library"
    cmake -S port/cmake -B "$out/library" -DCMAKE_INSTALL_PREFIX="$prefix" \
        -DCMAKE_C_FLAGS='-Wall -Wextra -Wconversion -Werror' -DCMAKE_C_FLAGS_RELEASE='-O0 -DNDEBUG' "$@" &&
        cmake --build "$out/library" && cmake --install "$out/library"
}

tool_is_there() {
    "$prefix/bin/invcal" plan --limits 0.4,0.6,1 > "$out/plan" && "$build/invcal" plan --limits 0.4,0.6,1 | diff - "$out/plan"
}

project() { # NAME LINE...: a project with these lines, and the example
    folder=$out/$1
    shift
    rm -rf "$folder"
    mkdir -p "$folder"
    cp "$example" "$folder/"
    {
        printf '%s\n' 'cmake_minimum_required(VERSION 3.18)' 'project(example LANGUAGES C)' "$@"
    } > "$folder/CMakeLists.txt"
}

builds() { # OPTION...: builds the latest project
    cmake -S "$folder" -B "$folder/build" "$@" && cmake --build "$folder/build"
}

found() { # TARGET
    project found "find_package(invcal $version CONFIG REQUIRED)" 'add_executable(example example.c)' \
        "target_link_libraries(example PRIVATE $1)"
    builds -DCMAKE_PREFIX_PATH="$prefix" && prints_as_expected "$folder/build/example"
}

# If this is 0.1, then 0.0, 0.2 and 1 have other APIs.
refused() { # VERSION
    project refused "find_package(invcal $1 CONFIG REQUIRED)"
    ! builds -DCMAKE_PREFIX_PATH="$prefix" > "$out/refused.log" 2>&1 &&
        grep -q "version: $version" "$out/refused.log"
}

# The lines that port/README.md shows.
fetched() { # TARGET
    awk '/^```cmake$/ { on = 1; next } /^```$/ { on = 0 } on' port/README.md > "$out/lines"
    grep -q 'PRIVATE invcal::invcal)' "$out/lines" || return
    project fetched 'add_executable(example example.c)' \
        "$(sed "s/PRIVATE invcal::invcal)/PRIVATE $1)/" "$out/lines")" 'install(TARGETS example)'
    builds -DFETCHCONTENT_SOURCE_DIR_INVCAL="$root" && prints_as_expected "$folder/build/example" &&
        cmake --install "$folder/build" --prefix "$out/nothing" && [ ! -e "$out/nothing/include" ]
}

# The choices reach the user of the library, as main checks; INVCAL_FAST only the library.
chosen() {
    echo '#define INVCAL_MAX_POSITIONS 17' > "$out/choices.h"
    installs -DINVCAL_TOOL=OFF -DINVCAL_FAST=ON -DINVCAL_THERMAL_DEGREE=2 \
        -DINVCAL_CONFIG_HEADER="$out/choices.h" || return
    mv "$out/choices.h" "$out/moved.h"
    project chosen "find_package(invcal $version CONFIG REQUIRED)" 'add_executable(example main.c)' \
        'target_link_libraries(example PRIVATE invcal::double)'
    printf '%s\n' '#include "invcal/thermal.h"' \
        '#if INVCAL_DOUBLE != 1 || INVCAL_THERMAL_DEGREE != 2 || INVCAL_MAX_POSITIONS != 17 || INVCAL_FAST != 0' \
        '#error "not as chosen"' '#endif' \
        'int main(void) { return invcal_status_text(INVCAL_OK)[0] == 0; }' > "$folder/main.c"
    builds -DCMAKE_PREFIX_PATH="$prefix" && "$folder/build/example"
}

# In the small library a dot product is a function, in the fast one it is inline.
is_small() {
    nm "$out/library/libinvcal.a" | grep ' T invcali_dot$'
}

is_fast() {
    ! is_small && nm "$out/library/libinvcal.a" | grep -q ' T invcal_sums_solve$'
}

# Cross-compiled, as part of a project for a machine without an operating system.
crossed() {
    project crossed "add_subdirectory(\"$root/port/cmake\" invcal)" \
        'add_executable(example example.c)' 'target_link_libraries(example PRIVATE invcal::invcal)'
    builds -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER=arm-none-eabi-gcc \
        -DCMAKE_C_FLAGS='-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16' \
        -DCMAKE_EXE_LINKER_FLAGS='--specs=rdimon.specs -Wl,--gc-sections'
}

# In one line, which names it; and not again when it has been corrected.
refuses() { # OPTION
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(p LANGUAGES C)\n%s\nadd_subdirectory("%s" invcal)\n' \
        "$2" "$root/port/cmake" > "$out/part/CMakeLists.txt"
    # shellcheck disable=SC2086 # nothing, or one word
    ! cmake -S "$3" -B "$out/part/build" $1 > "$out/said" 2>&1 &&
        grep -q '^ *INVCAL_MAX_POSITION is no option of invcal here' "$out/said"
}
refuses_unknown() {
    mkdir -p "$out/part"
    for folder in port/cmake "$out/part"; do
        rm -rf "$out/part/build"
        refuses -DINVCAL_MAX_POSITION=64 '' "$folder" && refuses -DCMAKE_C_FLAGS=-DINVCAL_MAX_POSITION=64 '' "$folder" &&
            cmake -S "$folder" -B "$out/part/build" -DINVCAL_MAX_POSITIONS=64 -DCMAKE_C_FLAGS=-DINVCAL_ALLAN_TAUS=10 || return
    done
    refuses '' 'add_compile_definitions(INVCAL_MAX_POSITION=64)' "$out/part"
}
keeps_others() { # another project's own variable
    ! refuses '' 'set(INVCAL_MINE 1 CACHE STRING mine)' "$out/part" && cmake -S "$out/part" -B "$out/part/build"
}

check "it installs" installs
check "an option that is unknown is refused by name" refuses_unknown
check "a variable of another project is not" keeps_others
check "it installs the tool, the same that make builds" tool_is_there
check "what it installs is optimised" grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' \
    "$out/library/CMakeCache.txt"
check "and small" is_small
for target in invcal::invcal invcal::double; do
    check "find_package, $target: the example prints what it must" found $target
    check "FetchContent, $target: the example prints what it must" fetched $target
done
case $version in
0.*)
    check "find_package does not take it for an older API" refused 0.0.9
    check "find_package does not take it for a later API" refused "0.$(($(echo "$version" | cut -d . -f 2) + 1))"
    ;;
esac
check "find_package does not take it for the next major version" refused "$((${version%%.*} + 1))"
long "choices reach a project that links it" chosen
long "INVCAL_FAST reaches the library" is_fast
check "it builds for a Cortex-M4F" crossed
check "only what is called is linked there" drops_uncalled "$folder/build/example" arm-none-eabi-nm
finish
