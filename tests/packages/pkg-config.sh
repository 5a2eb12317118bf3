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
    make -s install BUILD="$below" PREFIX="$prefix" DESTDIR="$stage" && [ ! -e "$prefix" ] &&
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
    flags=$(pkg-config --cflags --libs "$1") && eval "set -- $flags" &&
        cc -std=c99 -Wall -Wextra -Werror "$example" "$@" -Wl,--gc-sections -o "$out/example" &&
        prints_as_expected "$out/example"
}

links_what_is_called() {
    runs_example invcal && drops_uncalled "$out/example"
}

# Programs depend on the sizes of structures; with the wrong type they would crash or give wrong results.
is_double() { # NAME 0|1
    printf '%s\n' '#include "invcal/invcal.h"' \
        'int main(void) { return sizeof(invcal_real) == sizeof(double); }' > "$out/real.c"
    eval "cc $(pkg-config --cflags "$1")" '"$out/real.c" -o "$out/real"' || return
    "$out/real"
    [ $? -eq "$2" ]
}

has_choices() { # the flags for users contain the options of the libraries
    make -s pkg-config BUILD="${out#"$root"/}" PREFIX=/usr DEGREE=2 CFLAGS='-O2 -DINVCAL_MAX_POSITIONS=40' &&
        grep -q '^Cflags: .*-DINVCAL_MAX_POSITIONS=40 -DINVCAL_THERMAL_DEGREE=2$' \
            "$out/invcal.pc" "$out/invcal-double.pc"
}

# In another folder than what has just been built, with other flags: so are the libraries, and the flags are theirs. A
# program with other choices than its library's does not link.
installs_choices() {
    mkdir "$out/chosen" && cp -Rp "$build/float" "$build/double" "$build/tool" "$build/words" "$build/invcal" "$out/chosen" &&
        make -s install BUILD="${out#"$root"/}/chosen" PREFIX="$prefix" "$@" \
            CFLAGS="-O0 -D INVCAL_MAX_POSITIONS=33 '-DINVCAL_CONFIG_HEADER=\"my_choices.h\"' -I${out#"$root"/}" \
            DEGREE=2
}
has_header() { # what a program sees
    printf '%s\n' '#include "invcal/thermal.h"' \
        '#if INVCAL_MAX_POSITIONS != 33 || INVCAL_MAX_SEGMENTS != 77 || INVCAL_THERMAL_DEGREE != 2' '#error "not as chosen"' '#endif' > "$out/chosen.c"
    eval "cc $(pkg-config --cflags "$1")" '-I"$out" -fsyntax-only "$out/chosen.c"' &&
        eval "cc -std=c99 $(pkg-config --cflags "$1")" '-I"$out" "$example"' "$(pkg-config --libs "$1")" '-o "$out/example"' &&
        prints_as_expected "$out/example"
}

# pkg-config leaves $ ( ) as they are, for make; so they are not for eval, and in a folder that needs it not tried.
takes_prefix() { # NAME DESTDIR
    odd=$out/odd/$1
    make -s install BUILD="$below" PREFIX="$odd" DESTDIR="$2" || return
    [ -z "$2" ] || { mkdir -p "$out/odd" && mv "$2$odd" "$odd"; } || return
    flags=$(PKG_CONFIG_LIBDIR=$odd/lib/pkgconfig pkg-config --cflags --libs invcal-double) || return
    case $1 in
    *[\$\(]*)
        # shellcheck disable=SC2086 # flags are words
        cc -std=c99 "$example" $flags -o "$out/example"
        ;;
    *) eval 'cc -std=c99 "$example"' "$flags" '-o "$out/example"' ;;
    esac && prints_as_expected "$out/example" && make -s uninstall BUILD="$below" PREFIX="$odd" &&
        [ -z "$(find "$odd" -type f)" ]
}

uninstalls() { # all of it, and nothing else
    echo mine > "$prefix/include/invcal/mine.h"
    make -s uninstall BUILD="$below" PREFIX="$prefix" || return
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
# shellcheck disable=SC2016 # as they are
for prefix_name in 'a b' "it's" 'a&b' 'a\b' 'a"b' 'a#b' 'a|b;c<d>e' 'a`b' 'a*?[b]{c}' '~a!' '@PREFIX@' 'a$HOME' 'a(b)' 'é'; do
    case $prefix_name$out in *[\$\(]*[\ \'\&]*) continue ;; esac
    check "PREFIX=.../$prefix_name" takes_prefix "$prefix_name" ''
done
check "DESTDIR may be anything, too" takes_prefix plain "$out/it's a \"\$HOME\" & \\(new)"
refuses_variable() { # of pkg-config's
    # shellcheck disable=SC2016
    ! make -s pkg-config BUILD="$below" PREFIX='/usr/${x}' 2> "$out/refused" && grep -q '^PREFIX: contains' "$out/refused"
}
check "but for a variable of pkg-config" refuses_variable
check "make uninstall removes all of it, and nothing else" uninstalls
echo '#define INVCAL_MAX_SEGMENTS 77' > "$out/my_choices.h"
check "make install CFLAGS= compiles and installs what it says" installs_choices
for package in invcal invcal-double; do
    check "$package: its program sees the same, and links" has_header $package
done
finish
