#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# `make install` into a scratch prefix, pkg-config from there, and `make uninstall`.
. "$(dirname "$0")/../package.sh"
need pkg-config cc
prefix=$out/prefix
stage=$out/stage
export PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig" # what the machine has besides is not asked

# With DESTDIR, as a distribution does it; then moved to where it is to be.
installs() {
    make -s install BUILD="$build" PREFIX="$prefix" DESTDIR="$stage" && [ ! -e "$prefix" ] &&
        mv "$stage$prefix" "$prefix"
}

tool_runs() {
    "$prefix/bin/invcal" --version | grep -qx "invcal $(sh port/version.sh)" &&
        [ ! -x "$prefix/share/invcal/schema.json" ]
}

version() { # NAME
    [ "$(pkg-config --modversion "$1")" = "$(sh port/version.sh)" ] &&
        grep -qxF "URL: $(sh port/address.sh)" "$prefix/lib/pkgconfig/$1.pc"
}

runs_example() { # NAME
    # shellcheck disable=SC2046 # flags are words
    cc -std=c99 -Wall -Wextra -Werror $(pkg-config --cflags "$1") "$example" \
        $(pkg-config --libs "$1") -o "$out/example" && prints_as_expected "$out/example"
}

# Only the sizes of the structures tell which it is; a wrong one would crash or lie.
is_double() { # NAME 0|1
    printf '%s\n' '#include "invcal/invcal.h"' \
        'int main(void) { return sizeof(invcal_real) == sizeof(double); }' > "$out/real.c"
    # shellcheck disable=SC2046 # flags are words
    cc $(pkg-config --cflags "$1") "$out/real.c" -o "$out/real" || return
    "$out/real"
    [ $? -eq "$2" ]
}

choices_told() { # what the libraries were compiled with goes into the flags of their users
    make -s pkg-config BUILD="$out" PREFIX=/usr DEGREE=2 CFLAGS='-O2 -DINVCAL_MAX_POSITIONS=40' &&
        grep -q '^Cflags: .*-DINVCAL_MAX_POSITIONS=40 -DINVCAL_THERMAL_DEGREE=2$' \
            "$out/invcal.pc" "$out/invcal-double.pc"
}

uninstalls() { # all of it, and nothing else
    echo mine > "$prefix/include/invcal/mine.h"
    make -s uninstall BUILD="$build" PREFIX="$prefix" || return
    left=$(cd "$prefix" && find . -type f)
    [ "$left" = ./include/invcal/mine.h ] || { echo "left: $left"; return 1; }
}

check "make install DESTDIR= puts all under it" installs
check "the installed tool runs" tool_runs
for package in invcal invcal-double; do
    check "$package tells the version of invcal.h" version $package
    check "$package: the example prints what it has to" runs_example $package
done
check "invcal is in float" is_double invcal 0
check "invcal-double is in double" is_double invcal-double 1
check "the flags tell what the libraries were compiled with" choices_told
check "make uninstall removes that and nothing else" uninstalls
finish
