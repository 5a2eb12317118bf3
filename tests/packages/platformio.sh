#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The PlatformIO library: its manifest by the rules of the documentation, and by `pio pkg pack` where
# that is installed (pip install platformio). Compiled as PlatformIO, which would download a platform,
# compiles it: the folders of src, with include, src and the manifest's flags.
. "$(dirname "$0")/../package.sh"
need cc avr-gcc python3
library=$out/platformio

# https://docs.platformio.org/en/latest/manifests/library-json/
manifest() {
    /usr/bin/python3 - "$library" "$(sh port/version.sh)" "$(sh port/address.sh)" <<'EOF'
import json, os, re, sys

library, version, address = sys.argv[1:]
manifest = json.load(open(f"{library}/library.json"))
assert set(manifest) == {"$schema", "name", "version", "description", "homepage", "keywords", "license",
                         "authors", "frameworks", "platforms", "headers", "examples", "build"}
assert re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", manifest["name"]) and len(manifest["name"]) <= 50
assert manifest["version"] == version
assert manifest["homepage"] == address
assert len(manifest["description"]) <= 255
assert all(re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", word) for word in manifest["keywords"])
assert manifest["license"] == "MIT" and os.path.isfile(f"{library}/LICENSE")
assert all(set(author) <= {"name", "email", "url", "maintainer"} for author in manifest["authors"])
for header in manifest["headers"]:
    assert os.path.isfile(f"{library}/include/{header}"), header
for example in manifest["examples"]:
    files = sorted(os.listdir(f"{library}/{example['base']}"))
    assert sorted(example["files"]) == files, files
print(manifest["build"].pop("flags"))
assert manifest["build"] == {}
EOF
}

# Without the license, which pio would compare with a list that it downloads.
packs() {
    cp -R "$library" "$out/unlicensed" &&
        sed -i '/"license"/d' "$out/unlicensed/library.json" &&
        (cd "$out/unlicensed" && pio pkg pack -o "$out") &&
        tar -tzf "$out/invcal-$(sh port/version.sh).tar.gz" | grep -qx src/session/session.c
}

compiles() { # FOLDER COMPILER FLAG...
    folder=$out/$1
    shift
    mkdir -p "$folder"
    flags=$(manifest) && for source in "$library"/src/*/*.c; do
        # shellcheck disable=SC2086 # flags are words
        "$@" $flags -I"$library/include" -I"$library/src" -c "$source" \
            -o "$folder/$(basename "$source").o" || return
    done
}

runs_example() {
    compiles native cc && cc -I"$library/include" "$example" "$out"/native/*.o -lm \
        -Wl,--gc-sections -o "$out/native/program" && prints_as_expected "$out/native/program"
}

# Its example is Arduino's, which tests/packages/arduino.sh runs; here <invcal.h> must be found, too.
same_example() {
    diff -r port/arduino/examples/Calibrate "$library/examples/Calibrate" &&
        printf '#include <invcal.h>\nint main(void) { return INVCAL_OK; }\n' > "$out/arduino.c" &&
        cc -I"$library/include" -fsyntax-only "$out/arduino.c"
}

check "it can be staged" stage platformio
check "library.json keeps to the rules, and names what is there" manifest
if command -v pio > /dev/null; then
    check "pio packs it" packs
else
    echo "$name: pio is not installed: its own check of the manifest is skipped"
fi
check "the example prints what it must" runs_example
check "only what is called is linked" drops_uncalled "$out/native/program"
check "it compiles for an AVR" compiles avr avr-gcc -mmcu=atmega2560 -Os
check "its example is the Arduino library's" same_example
finish
