# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2154 # package.sh sets what is not set here
#
# For packages whose options come from Kconfig: they are those of the headers, and they reach the
# compiler. The caller sets kconfig, the Kconfig file, and enable, which makes the options visible
# (INVCAL=y, or nothing).

kconfig_py() { # set or options, NAME=VALUE...
    command=$1
    shift
    /usr/bin/python3 tests/packages/rtos/kconfig.py "$kconfig" "$command" ${enable:+"$enable"} "$@"
}

configure() { # NAME=VALUE...: makes $out/config.cmake
    kconfig_py set "$@" > "$out/config.cmake"
}

# $out/options: NAME LEAST MOST DEFAULT of each.
read_options() {
    kconfig_py options | sort > "$out/options" && [ -s "$out/options" ]
}

same_defaults() {
    awk '$1 == "#ifndef" { name = $2; next }
        $1 == "#define" && $2 == name && name !~ /_PRIVATE_/ && $3 ~ /^[0-9]+$/ { value[name] = $3 }
        END { for (name in value) print name, value[name] }' include/invcal/config.h | sort > "$out/defaults"
    cut -d ' ' -f 1,4 "$out/options" | diff "$out/defaults" -
}

accepts() { # NAME VALUE: do the headers?
    printf '#include "invcal/%s.h"\n' allan gyro thermal | cc -Iinclude "-D$1=$2" -fsyntax-only -x c -
}

takes() { # NAME VALUE: does Kconfig? Its booleans are n and y.
    case $1=$2 in
    INVCAL_DOUBLE=0 | INVCAL_FAST=0) configure "$1=n" ;;
    INVCAL_DOUBLE=1 | INVCAL_FAST=1) configure "$1=y" ;;
    *) configure "$1=$2" ;;
    esac
}

# Kconfig and the headers accept the same minimum and maximum, and refuse what is beyond.
same_ranges() {
    while read -r option least most rest; do
        for value in "$least" "$most"; do
            accepts "$option" "$value" || { echo "the headers refuse $option $value"; return 1; }
            takes "$option" "$value" || { echo "Kconfig refuses $option $value"; return 1; }
        done
        for value in $((least - 1)) $((most + 1)); do
            ! accepts "$option" "$value" || { echo "the headers accept $option $value"; return 1; }
            ! takes "$option" "$value" || { echo "Kconfig accepts $option $value"; return 1; }
        done
    done < "$out/options"
}

# Each option at a value that is not its default.
others() {
    awk '{ value = $4 == $3 ? $2 : $3; print $1, value }' "$out/options" > "$out/others"
    # shellcheck disable=SC2046 # names and numbers
    configure $(sed -e 's/^\(INVCAL_DOUBLE\) 1/\1 y/' -e 's/^\(INVCAL_FAST\) 1/\1 y/' -e 's/ /=/' "$out/others")
}

# A program that compiles only if all of them have reached it.
others_as_program() {
    awk '{ print "#if " $1 " != " $2 "\n#error \"" $1 " is not as chosen\"\n#endif" }
        BEGIN { print "#include \"invcal/allan.h\"\n#include \"invcal/gyro.h\"\n#include \"invcal/thermal.h\"" }
        END { print "int main(void) { return invcal_status_text(INVCAL_OK)[0] == 0; }" }' \
        "$out/others" > "$out/others.c"
}

# All files of the library were compiled with them. $1: compile_commands.json.
others_everywhere() {
    sources=$(find src -name '*.c' | wc -l)
    while read -r option value; do
        count=$(grep -E '^ *"command".*/src/[a-z]+/[a-z0-9_]+\.c"' "$1" |
            grep -c -- "-D$option=$value ")
        [ "$count" -eq "$sources" ] ||
            { echo "$option=$value reached $count of $sources files"; return 1; }
    done < "$out/others"
}
