#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The tool for Windows, built with MinGW-w64, also by CMake; under Wine it writes the same bytes as the tool here.
. "$(dirname "$0")/../package.sh"
need x86_64-w64-mingw32-gcc cmake wine
export WINEPREFIX="$out/wine" WINEDEBUG=-all NO_COLOR=1 COLUMNS=80
mkdir "$out/here" "$out/there"
ln -s "$build/invcal" "$out/here/invcal"

compiles() {
    make -s BUILD="$below" windows > "$out/said" 2>&1 && [ ! -s "$out/said" ] && cp "$build/invcal.exe" "$out/there/invcal"
}

# Not optimised, which takes half as long.
cmake_builds() {
    cmake -S port/cmake -B "$out/cmake" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc &&
        cmake --build "$out/cmake" --target invcal_tool && wine "$out/cmake/invcal.exe" --version | grep -q '^invcal '
}

# The same in both folders: the files, the output and the exit status, which is CODE.
same() { # CODE ARGUMENT...
    code=$1
    shift
    number=$((number + 1))
    (cd "$out/here" && ./invcal "$@" > "$number.out" 2> "$number.err"; echo $? > "$number.code")
    (cd "$out/there" && timeout 120 wine invcal "$@" > "$number.out" 2> "$number.err"; echo $? > "$number.code")
    [ "$(cat "$out/here/$number.code")" -eq "$code" ] && diff -r -x invcal "$out/here" "$out/there"
}
number=0

check "it compiles without a warning" compiles
check "Wine starts" wine wineboot
long "CMake builds it" cmake_builds
check "simulate" same 0 simulate --plan edges --seed 3 --truth truth.json
for folder in here there; do
    cp "$out/$folder/1.out" "$out/$folder/log.csv"
done
check "calibrate, its report and file" same 0 calibrate log.csv --sensor mpu6050:2g --out cal.json --report page.html
check "replaces a file" same 0 calibrate log.csv --sensor mpu6050:2g --out cal.json --serial 7
check "apply, through a temporary file" same 0 apply cal.json log.csv
check "export" same 0 export cal.json --format c
check "plan" same 0 plan --limits 0.4,0.6,1
check "watch" same 0 watch log.csv
check "a file that is not there" same 3 calibrate nothing.csv
check "the log is not overwritten" same 2 calibrate log.csv --out log.csv
check "a folder for a file" same 3 calibrate .
finish
