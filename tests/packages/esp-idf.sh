#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154,SC2034 # package.sh sets, and options.sh uses, what is not set or used here
#
# The component, without ESP-IDF: its options by Kconfig's own language (kconfiglib), the build with a
# mock of idf_component_register (tests/packages/esp-idf), the manifest by the rules of its reference,
# and by Espressif's compote where that is installed (pip install idf-component-manager).
. "$(dirname "$0")/../package.sh"
need cmake cc python3
component=$out/invcal
kconfig=$component/Kconfig
enable=
. tests/packages/kconfig/options.sh

stage_component() { # its folder is its name
    sh port/stage.sh esp-idf "$component"
}

# https://docs.espressif.com/projects/idf-component-manager/en/latest/reference/manifest_file.html
manifest() {
    /usr/bin/python3 - "$component" "$(sh port/version.sh)" <<'EOF'
import os, sys, yaml

component, version = sys.argv[1:]
manifest = yaml.safe_load(open(f"{component}/idf_component.yml"))
assert set(manifest) == {"version", "description", "license", "tags", "dependencies"}, manifest
assert manifest["version"] == version, manifest["version"]
assert manifest["license"] == "MIT" and os.path.isfile(f"{component}/LICENSE")
assert all(isinstance(tag, str) and 3 <= len(tag) <= 32 for tag in manifest["tags"])
assert manifest["dependencies"] == {"idf": ">=5.0"}
EOF
}

builds() { # PROGRAM
    rm -rf "$out/build"
    cmake -S tests/packages/esp-idf -B "$out/build" -DCOMPONENT="$component" \
        -DCONFIG="$out/config.cmake" -DMAIN="$1" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON &&
        cmake --build "$out/build"
}

builds_with_options() {
    others && others_as_program && builds "$out/others.c" &&
        others_everywhere "$out/build/compile_commands.json"
}

runs_example() {
    configure && builds "$out/example.c" && prints_as_expected "$out/build/main"
}

check "it can be staged" stage_component
check "its manifest keeps to the rules" manifest
if command -v compote > /dev/null; then
    check "compote packs it" compote component pack --name invcal --project-dir "$component" \
        --dest-dir "$out/packed"
else
    echo "$name: compote is not installed: its own check of the manifest is skipped"
fi
check "its options can be listed" read_options
check "they and their defaults are those of config.h" same_defaults
check "and so are their ranges" same_ranges
check "each reaches the library and who requires it" builds_with_options
check "README.md has an example" example
check "it prints what README.md says" runs_example
finish
