#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# `make install` into a scratch prefix, pkg-config from there, and `make uninstall`.
. "$(dirname "$0")/../package.sh"
need pkg-config cc
prefix=$out/prefix
stage=$out/stage
export PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig" # ignore other .pc files of this machine

# With DESTDIR, as a distribution does it; then moved to its prefix.
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
        $(pkg-config --libs "$1") -Wl,--gc-sections -o "$out/example" && prints_as_expected "$out/example"
}

links_what_is_called() {
    runs_example invcal && drops_uncalled "$out/example"
}

# Programs depend on the sizes of structures; with the wrong type they would crash or give wrong results.
is_double() { # NAME 0|1
    printf '%s\n' '#include "invcal/invcal.h"' \
        'int main(void) { return sizeof(invcal_real) == sizeof(double); }' > "$out/real.c"
    # shellcheck disable=SC2046 # flags are words
    cc $(pkg-config --cflags "$1") "$out/real.c" -o "$out/real" || return
    "$out/real"
    [ $? -eq "$2" ]
}

has_choices() { # the flags for users contain the options of the libraries
    make -s pkg-config BUILD="$out" PREFIX=/usr DEGREE=2 CFLAGS='-O2 -DINVCAL_MAX_POSITIONS=40' &&
        grep -q '^Cflags: .*-DINVCAL_MAX_POSITIONS=40 -DINVCAL_THERMAL_DEGREE=2$' \
            "$out/invcal.pc" "$out/invcal-double.pc"
}

# As typed, whatever is special to sed, a shell or pkg-config. (A dollar would be installed, but pkgconf prints it bare.)
installs_anywhere() {
    strange="$out/a b'c&d\\e"
    make -s install BUILD="$build" PREFIX="$strange" && "$strange/bin/invcal" --version > /dev/null || return
    flags=$(PKG_CONFIG_LIBDIR="$strange/lib/pkgconfig" pkg-config --cflags --libs invcal) &&
        eval "set -- $flags" && cc -std=c99 "$example" "$@" -o "$out/example" && prints_as_expected "$out/example"
}

# Other flags, an option among them, make the library again; an option that it does not have is named.
remakes() {
    make -s BUILD="$out/other" "$out/other/float/src/session.o" CFLAGS=-O0 &&
        make -s BUILD="$out/other" "$out/other/float/src/session.o" CFLAGS='-O0 -DINVCAL_MAX_POSITIONS=40' &&
        nm "$out/other/float/src/session.o" | grep -q _max_positions_40$
}

names_what_is_unknown() {
    ! make -s BUILD="$out/other" all CFLAGS=-DINVCAL_MAX_POSITION=40 > "$out/said" 2>&1 &&
        grep -q 'INVCAL_MAX_POSITION: invcal has no such option' "$out/said"
}

uninstalls() { # all of it, and nothing else
    echo mine > "$prefix/include/invcal/mine.h"
    make -s uninstall BUILD="$build" PREFIX="$prefix" || return
    left=$(cd "$prefix" && find . -type f)
    [ "$left" = ./include/invcal/mine.h ] || { echo "left: $left"; return 1; }
}

check "make install DESTDIR= installs everything below it" installs
check "the installed tool runs" tool_runs
for package in invcal invcal-double; do
    check "$package has the version of invcal.h" version $package
    check "$package: the example prints what it must" runs_example $package
done
check "only what is called is linked" links_what_is_called
check "invcal is in float" is_double invcal 0
check "invcal-double is in double" is_double invcal-double 1
check "the flags contain the options of the libraries" has_choices
check "a prefix may contain anything" installs_anywhere
check "other flags make the library again" remakes
check "an unknown option is named" names_what_is_unknown
check "make uninstall removes all of it, and nothing else" uninstalls
finish
