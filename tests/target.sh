# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# For the scripts that build and run targets: . tests/target.sh

unset MAKEFLAGS # a CC=... meant for the host would be taken for every target

# all_targets: the folders of all targets under port/
all_targets() {
    find port -name target.mk | sed 's|/target.mk||' | sort
}

# target_make BUILD FOLDER GOAL...
target_make() {
    build_in=$1
    built_for=${2%/}
    shift 2
    make -s --no-print-directory -f port/build.mk BUILD="$build_in" TARGET="$built_for" "$@"
}

# target_facts BUILD FOLDER [LEVEL]: sets compiler, cpu, emulator, levels, processor, out, run, run_counting
# and unit from port/build.mk.
target_facts() {
    if [ ! -f "${2%/}/target.mk" ]; then
        echo "$2 is not a target; targets: $(all_targets | paste -s -d ' ' -)" >&2
        return 1
    fi
    facts=$(target_make "$1" "$2" LEVEL="$3" facts) || return
    eval "$facts"
}

# need COMMAND...: fails with one line if one is not installed.
need() {
    for command; do
        if ! command -v "$command" > /dev/null; then
            echo "$command is not installed: make deps" >&2
            return 1
        fi
    done
}
