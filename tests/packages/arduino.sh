#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The Arduino library, as Arduino's own builder takes it: the example for a Mega 2560; and, with a bus
# in place of Wire on which there is a simulated MPU-6050 (tests/packages/arduino), run in simavr from
# power-on to the calibration found in the EEPROM after a reset.
. "$(dirname "$0")/../package.sh"
need arduino-builder avr-g++ avr-size simavr
library=$out/libraries/invcal
cores=/usr/share/arduino/hardware

stage_library() {
    sh port/stage.sh arduino "$library"
}

# https://docs.arduino.cc/arduino-cli/library-specification
properties() {
    awk -F = -v version="$(sh port/version.sh)" '
        /^#/ { next }
        { value[$1] = substr($0, length($1) + 2) }
        END {
            split("name version author maintainer sentence paragraph category url architectures", all, " ")
            for (i in all) if (value[all[i]] == "") { print "no " all[i]; bad++ }
            if (value["name"] !~ /^[A-Za-z0-9][A-Za-z0-9_. -]*$/) { print value["name"]; bad++ }
            if (value["version"] != version) { print value["version"]; bad++ }
            if (value["category"] !~ /^(Display|Communication|Signal Input\/Output|Sensors|Device Control|Timing|Data Storage|Data Processing|Other)$/) {
                print value["category"]
                bad++
            }
            if (value["includes"] != "invcal.h") { print value["includes"]; bad++ }
            exit bad > 0
        }' "$library/library.properties"
}

# What stands there is on the include path of every sketch.
one_header() {
    found=$(cd "$library/src" && find . -maxdepth 1 -type f)
    echo "$found"
    [ "$found" = ./invcal.h ]
}

# builds BOARD SKETCH [FLAG]: into $out/SKETCH.build. A warning in our files is an error.
# (Debian's gcc-avr 5.4 has no DECIMAL_DIG in C++, which the core of 1.8.7 asks for.)
builds() {
    rm -rf "$out/$2.build"
    mkdir -p "$out/$2.build"
    arduino-builder -hardware /usr/share/arduino-builder -hardware "$cores" -tools /usr/bin \
        -libraries "$out/libraries" -built-in-libraries "$cores/arduino/avr/libraries" \
        -prefs "compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ $3" \
        -prefs "compiler.c.extra_flags=$3" -warnings all \
        -fqbn "arduino:avr:$1" -build-path "$out/$2.build" "$out/$2/$2.ino" > "$out/$2.log" 2>&1 ||
        { tail -n 20 "$out/$2.log"; return 1; }
    ! grep -F "$out/" "$out/$2.log" | grep warning
}

builds_example() {
    mkdir "$out/Calibrate" && cp "$library"/examples/Calibrate/* "$out/Calibrate/" &&
        builds mega:cpu=atmega2560 Calibrate
}

ram() { # SKETCH
    avr-size "$out/$1.build/$1.ino.elf" | awk 'NR == 2 { print $2 + $3 }'
}

# 12 positions fewer, of 13 bytes each.
takes_options() {
    mkdir "$out/Small" && cp "$library"/examples/Calibrate/* "$out/Small/" &&
        mv "$out/Small/Calibrate.ino" "$out/Small/Small.ino" &&
        builds mega:cpu=atmega2560 Small -DINVCAL_MAX_POSITIONS=20 &&
        echo "$(ram Calibrate) bytes, and with fewer positions $(ram Small)" &&
        [ $(($(ram Calibrate) - $(ram Small))) -eq 156 ]
}

builds_simulation() {
    cp -R tests/packages/arduino/Wire "$out/libraries/" &&
        mkdir "$out/Simulated" && cp "$library"/examples/Calibrate/* "$out/Simulated/" &&
        mv "$out/Simulated/Calibrate.ino" "$out/Simulated/Simulated.ino" &&
        builds mega:cpu=atmega2560 Simulated
}

# runs MCU SKETCH: what comes from the UART, into $out/SKETCH.printed. simavr colours it, and shows
# carriage return and line feed as a dot each.
runs() {
    escape=$(printf '\033')
    timeout 300 simavr -m "$1" -f 16000000 "$out/$2.build/$2.ino.elf" > "$out/$2.raw" 2>&1 < /dev/null
    status=$?
    sed -n "s/^\(${escape}\[0m\)*${escape}\[32m\(.*\)\.\.\$/\2/p" "$out/$2.raw" > "$out/$2.printed"
    tail -n 3 "$out/$2.raw"
    [ "$status" -eq 0 ]
}

# said PATTERN...: lines that match them were printed, in this order.
said() {
    printf '%s\n' "$@" > "$out/patterns"
    awk 'NR == FNR { pattern[++n] = $0; next }
        i < n && $0 ~ pattern[i + 1] { i++ }
        END { if (i < n) print "not said: " pattern[i + 1]; exit i < n }' \
        "$out/patterns" "$out/Simulated.printed"
}

# Offsets and scale errors within 4 of the sigma printed with them.
near_truth() {
    awk '
        /^world: truth / { n++; truth["offset,", n] = $3; truth["scale", n] = $4; next }
        /^(offset|scale)/ { of = $1; for (i = 1; i <= 3; i++) value[of, i] = $(NF - 3 + i); next }
        of != "" && /^sigma:/ { for (i = 1; i <= 3; i++) sigma[of, i] = $(1 + i); of = "" }
        END {
            for (key in truth) {
                off = value[key] - truth[key]
                if (sigma[key] > 0 && off * off <= 16 * sigma[key] ^ 2) good++
                else print value[key], "+-", sigma[key], "truth", truth[key]
            }
            exit good != 6
        }' "$out/Simulated.printed"
}

# Readings after the reset, where the sensor is held still.
readings() {
    awk '/^stored calibration: found/ { found = 1 }
        found && /^a, g:/ { n++; l = sqrt($3 ^ 2 + $4 ^ 2 + $5 ^ 2)
            if (l < 0.98 || l > 1.02) { print; bad++ } }
        END { exit bad > 0 || n < 5 }' "$out/Simulated.printed"
}

# What README.md says that the example takes: enough, and not more than a tenth too much.
costs() {
    set -- "$(avr-size "$out/Calibrate.build/Calibrate.ino.elf" | awk 'NR == 2 { print $1 + $2, $2 + $3 }')" \
        "$(sed -n 's/^world: stack, bytes: //p' "$out/Simulated.printed")" \
        "$(tr '\n' ' ' < "$library/README.md" | sed 's/,//g;
            s/.*takes \([0-9]*\) bytes of flash and \([0-9]*\) of RAM and up to \([0-9]*\) of stack.*/\1 \2 \3/')"
    echo "$@"
    echo "$@" | awk '{ for (i = 1; i <= 3; i++) good += $i > 0 && $(i + 3) >= $i && $(i + 3) <= 1.1 * $i }
        END { exit good != 3 }'
}

# An Uno, 2 KB of RAM: who only applies a calibration pays only for that.
applies_on_uno() {
    mkdir "$out/Apply" && cat > "$out/Apply/Apply.ino" <<'EOF'
#include <invcal.h>
#include <avr/sleep.h>

void setup()
{
    const invcal_calibration calibration = {{100, -200, 300}, {{0.01f, 0, 0}, {0, 0.01f, 0}, {0, 0, 0.02f}}};
    float a[3] = {200, 0, 0};

    Serial.begin(115200);
    invcal_apply(&calibration, a, a);
    for (int i = 0; i < 3; i++) {
        Serial.println(a[i]);
    }
    Serial.flush();
    cli();
    sleep_enable();
    sleep_cpu();
}

void loop()
{
}
EOF
    builds uno Apply && runs atmega328p Apply && paste -s -d ' ' "$out/Apply.printed" |
        grep -qx '1.00 2.00 -6.00' &&
        avr-size "$out/Apply.build/Apply.ino.elf" | awk 'NR == 2 { exit $2 + $3 > 300 }'
}

check "it can be staged" stage_library
check "library.properties keeps to the specification" properties
check "a sketch sees one header of it, no others" one_header
check "the example builds for a Mega 2560, without a warning" builds_example
check "a macro reaches library and sketch" takes_options
check "it builds with a simulated sensor on the bus" builds_simulation
check "it runs, from power-on to the end" runs atmega2560 Simulated
check "it asks, takes positions, and is content" said '^stored calibration: nothing is stored' \
    '^calibration begins$' '^next: [+]z up$' '^hold still, percent: ' '^good: move on$' '^next: .*tilt' \
    '^positions taken: 12$' '^verdict: good$' '^calibration stored$' '^a, g: '
check "samples were lost, as the chip does not wait" said '^world: .*nobody has read: [1-9]'
check "what it prints is true within 4 sigma" near_truth
check "after a reset it finds and applies what was stored" readings
check "README.md says what it takes" costs
check "an Uno applies a calibration" applies_on_uno
finish
