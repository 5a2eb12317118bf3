#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154,SC2034 # package.sh sets, and options.sh uses, what is not set or used here
#
# The Zephyr module, without Zephyr: module.yml by the rules of scripts/zephyr_module.py, options by
# Kconfig's own language (kconfiglib), the build and the sample with mocks of what they call
# (tests/packages/zephyr). This checks that we use Zephyr as its documentation says; it does not check Zephyr.
. "$(dirname "$0")/../package.sh"
need cmake cc python3
module=$out/zephyr
kconfig=$out/Kconfig
enable=INVCAL=y
. tests/packages/rtos/options.sh
. tests/packages/rtos/sample.sh

# The keys that zephyr_module.py allows, with their types; and what they name exists.
module_yml() { # ROOT
    /usr/bin/python3 - "$1" <<'EOF'
import os, sys, yaml

root = sys.argv[1]
meta = yaml.safe_load(open(f"{root}/zephyr/module.yml"))
build = meta.pop("build")
samples = meta.pop("samples")
assert meta == {"name": "invcal"}, meta
assert set(build) == {"cmake", "kconfig"}, build
assert os.path.isfile(f"{root}/{build['cmake']}/CMakeLists.txt"), build
assert os.path.isfile(f"{root}/{build['kconfig']}"), build
assert all(os.path.isdir(f"{root}/{sample}") for sample in samples), samples
EOF
}

# The keys of twister's testsuite-schema.yaml that it uses, with their types.
sample_yaml() {
    /usr/bin/python3 - "$module/zephyr/samples/calibrate/sample.yaml" <<'EOF'
import sys, yaml

sample = yaml.safe_load(open(sys.argv[1]))
assert set(sample) == {"sample", "tests"}, sample
assert set(sample["sample"]) == {"name", "description"}, sample["sample"]
for name, test in sample["tests"].items():
    assert set(test) == {"build_only", "tags", "filter", "integration_platforms"}, (name, test)
    assert test["build_only"] is True and isinstance(test["tags"], str)
    assert isinstance(test["filter"], str) and all(isinstance(board, str)
        for board in test["integration_platforms"])
EOF
}

# As Zephyr's build includes it, with the only symbol of Zephyr's that it selects.
top_kconfig() { # ROOT
    printf '%s\n' 'config REQUIRES_FULL_LIBC' '    bool' "source \"$1/zephyr/Kconfig\"" > "$kconfig"
}

builds() { # MODULE APPLICATION
    rm -rf "$out/build"
    ZEPHYR_BASE=$root/tests/packages/zephyr cmake -S "$2" -B "$out/build" \
        -DZEPHYR_EXTRA_MODULES="$1" -DCONFIG="$out/config.cmake" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON &&
        cmake --build "$out/build"
}

builds_sample() { # MODULE NAME=VALUE...
    from=$1
    shift
    top_kconfig "$from" && configure "$@" && grep -q REQUIRES_FULL_LIBC "$out/config.cmake" &&
        builds "$from" "$from/zephyr/samples/calibrate"
}

builds_program() { # FILE: as an application, with the staged module
    rm -rf "$out/application"
    mkdir -p "$out/application/src" && cp "$1" "$out/application/src/main.c" &&
        cp "$module/zephyr/samples/calibrate/CMakeLists.txt" "$out/application/" &&
        builds "$module" "$out/application"
}

builds_with_options() {
    others && others_as_program && builds_program "$out/others.c" &&
        others_everywhere "$out/build/compile_commands.json"
}

# Switched off, it adds nothing to a build.
builds_without() {
    echo 'int main(void) { return 0; }' > "$out/empty.c"
    (enable='' && configure) && builds_program "$out/empty.c" && ! find "$out/build" -name '*.a' | grep .
}

check "it can be staged" stage zephyr
check "module.yml keeps to the rules, and names what is there" module_yml "$module"
check "the same in the repository, where port/ is the module" module_yml port
check "sample.yaml keeps to the rules" sample_yaml
check "its Kconfig can be read" top_kconfig "$module"
check "its options can be listed" read_options
check "they and their defaults are those of the headers" same_defaults
check "and so are their ranges" same_ranges
check "each reaches the library and the application" builds_with_options
check "without CONFIG_INVCAL it adds nothing" builds_without
check "the sample builds with the repository as module, without a warning" builds_sample "$root/port"
check "the same in double" builds_sample "$root/port" INVCAL_DOUBLE=y
check "the sample builds with the staged module, without a warning" builds_sample "$module"
check "a calibration can be simulated" simulate --lsb 0.00001
check "the sample calibrates and stores" calibrates "$out/build/app"
check "what it prints is true within 4 sigma" near_truth
check "started again, it applies what was stored" starts_again "$out/build/app" 9.80665
finish
