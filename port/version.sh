#!/bin/sh
# SPDX-License-Identifier: MIT
#
# sh port/version.sh: prints the version, such as 0.1.0, as include/invcal/config.h states it.
awk '$1 == "#define" && $2 ~ /^INVCAL_VERSION_(MAJOR|MINOR|PATCH)$/ && $3 ~ /^[0-9]+$/ {
        part[substr($2, 16)] = $3
        found++
    }
    END {
        if (found != 3) {
            print "include/invcal/config.h: no INVCAL_VERSION_MAJOR, _MINOR and _PATCH" > "/dev/stderr"
            exit 1
        }
        print part["MAJOR"] "." part["MINOR"] "." part["PATCH"]
    }' "$(dirname "$0")/../include/invcal/config.h"
