#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/double.sh: prints include/invcal/double.h, the names of the functions of a double library, from the
# declarations in the headers. sh port/double.sh src: prints src/core/names.h, the same of internal functions.
cd "$(dirname "$0")/.." || exit 2
export LC_ALL=C # the order of a glob, and of sort

names() { # PREFIX IN-DOUBLE HEADER...
    prefix=$1 other=$2
    shift 2
    awk -v prefix="$prefix" '/^(static|typedef|#|\/| )/ { next }
        match($0, prefix "[a-z0-9_]+\\(") {
            print substr($0, RSTART + length(prefix), RLENGTH - length(prefix) - 1)
        }' "$@" | sort -u | awk -v prefix="$prefix" -v other="$other" '{ print "#define " prefix $0 " " other $0 }'
}

if [ "$1" = src ]; then
    cat << 'END'
/* SPDX-License-Identifier: MIT
 *
 * Internal: in a double library every internal function has another name, too: see double.h.
 * port/double.sh writes this list.
 */
#ifndef INVCAL_NAMES_H
#define INVCAL_NAMES_H

#include "invcal/config.h"

#if INVCAL_DOUBLE

END
    names invcali_ invcaldi_ src/*/*.h
else
    cat << 'END'
/* SPDX-License-Identifier: MIT
 *
 * invcal/double.h: in a double library every function has another name, so that neither links with
 * a program of the other kind. port/double.sh writes this list.
 */
#ifndef INVCAL_DOUBLE_H
#define INVCAL_DOUBLE_H

#include "invcal/config.h"

#if INVCAL_DOUBLE

END
    names invcal_ invcald_ include/invcal/*.h
fi
printf '\n#endif\n\n#endif\n'
