#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/double.sh: prints include/invcal/double.h, the names of the functions of a double library,
# from the declarations in the headers.
cd "$(dirname "$0")/.." || exit 2
export LC_ALL=C # the order of a glob, and of sort

names() { # HEADER...
    awk '/^(static|typedef|#|\/| )/ { next }
        match($0, /invcal_[a-z0-9_]+\(/) { print substr($0, RSTART + 7, RLENGTH - 8) }' "$@" |
        sort | awk '{ print "#define invcal_" $0 " invcald_" $0 }'
}

cat << 'EOF'
/* SPDX-License-Identifier: MIT
 *
 * invcal/double.h: in a double library every function has another name, so that it may be linked
 * with a float one, and neither with a program of the other kind. port/double.sh writes this list.
 */
#ifndef INVCAL_DOUBLE_H
#define INVCAL_DOUBLE_H

#include "invcal/config.h"

#if INVCAL_DOUBLE

EOF
set -- include/invcal/*.h
names "$@"
printf '\n/* Of the library alone. */\n'
names src/*/*.h
printf '\n#endif\n\n#endif\n'
