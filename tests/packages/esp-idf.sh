#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154,SC2034 # package.sh sets, and options.sh uses, what is not set or used here
#
# The component, without ESP-IDF: the manifest by the rules of its reference, and by Espressif's
# compote where that is installed (pip install idf-component-manager); options by Kconfig's own
# language (kconfiglib); the build and the example with mocks of what they call (tests/packages/esp-idf).
# This checks that we use ESP-IDF as its documentation says; it does not check ESP-IDF.
. "$(dirname "$0")/../package.sh"
need cmake cc python3
component=$out/invcal
kconfig=$component/Kconfig
enable=
. tests/packages/rtos/options.sh
. tests/packages/rtos/sample.sh

stage_component() { # its folder gives it its name
    sh port/stage.sh esp-idf "$component"
}

# https://docs.espressif.com/projects/idf-component-manager/en/latest/reference/manifest_file.html
manifest() {
    /usr/bin/python3 - "$component" "$(sh port/version.sh)" "$(sh port/address.sh)" <<'EOF'
import os, sys, yaml

component, version, address = sys.argv[1:]
manifest = yaml.safe_load(open(f"{component}/idf_component.yml"))
assert set(manifest) == {"version", "description", "license", "url", "tags", "dependencies"}, manifest
assert manifest["version"] == version, manifest["version"]
assert manifest["url"] == address, manifest["url"]
assert manifest["license"] == "MIT" and os.path.isfile(f"{component}/LICENSE")
assert all(isinstance(tag, str) and 3 <= len(tag) <= 32 for tag in manifest["tags"])
assert manifest["dependencies"] == {"idf": ">=5.0"}
EOF
}

builds() { # PROJECT
    rm -rf "$out/build"
    IDF_PATH=$root/tests/packages/esp-idf cmake -S "$1" -B "$out/build" \
        -DCONFIG="$out/config.cmake" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON && cmake --build "$out/build"
}

builds_example() {
    configure && builds "$component/examples/calibrate"
}

# A program as the main component of a project like the example's.
builds_program() { # FILE
    project=$component/examples/program
    rm -rf "$project"
    mkdir -p "$project/main" && cp "$component/examples/calibrate/CMakeLists.txt" "$project/" &&
        sed 's/ sensor.c//' "$component/examples/calibrate/main/CMakeLists.txt" \
            > "$project/main/CMakeLists.txt" &&
        { echo 'int app_main(void);' && sed 's/int main(void)/int app_main(void)/' "$1"; } \
            > "$project/main/main.c" && builds "$project"
}

builds_with_options() {
    others && others_as_program && builds_program "$out/others.c" &&
        others_everywhere "$out/build/compile_commands.json"
}

runs_example_program() {
    configure && builds_program "$example" && prints_as_expected "$out/build/calibrate.elf"
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
check "they and their defaults are those of the headers" same_defaults
check "and so are their ranges" same_ranges
check "each reaches the library and components that require it" builds_with_options
check "the example prints what it must" runs_example_program
check "the component's own example builds, without a warning" builds_example
check "a calibration can be simulated" simulate
check "the example calibrates and stores" calibrates "$out/build/calibrate.elf"
check "what it prints is true within 4 sigma" near_truth
check "started again, it applies what was stored" starts_again "$out/build/calibrate.elf" 1
finish
