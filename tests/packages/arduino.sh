#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The Arduino library, as Arduino's own builder takes it: the example for a Mega 2560; and, with a bus
# in place of Wire on which there is a simulated MPU-6050, and an EEPROM that takes its time
# (tests/packages/arduino), run in simavr from power-on to the calibration found in the EEPROM after the
# last reset: through a reset, a power cut while the session is stored, and a position that is wrong.
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

# 4 positions fewer, of 12 bytes each.
takes_options() {
    mkdir "$out/Small" && cp "$library"/examples/Calibrate/* "$out/Small/" &&
        mv "$out/Small/Calibrate.ino" "$out/Small/Small.ino" &&
        builds mega:cpu=atmega2560 Small -DINVCAL_MAX_POSITIONS=20 &&
        echo "$(ram Calibrate) bytes, and with fewer positions $(ram Small)" &&
        [ $(($(ram Calibrate) - $(ram Small))) -eq 48 ]
}

builds_simulation() {
    cp -R tests/packages/arduino/* "$out/libraries/" &&
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

# As many positions after each reset as were stored last.
went_on() {
    awk '/^world: power fails/ { cut = 1; next } # that position was not stored
        /^positions taken: / { before = stored; stored = $NF; next }
        /^goes on, / { found++; if ($NF != (cut ? before : stored)) { print; bad++ }; stored = $NF; cut = 0 }
        END { exit bad > 0 || found != 2 }' "$out/Simulated.printed"
}

# The one that was taken while somebody pulled, and no other.
outlier() {
    awk '/^world: somebody pulls/ { next_is = 1 }
        next_is && /^positions taken: / { wrong = $NF; next_is = 0 }
        /^left out, / { left++; if ($NF != wrong) { print "wrong is " wrong ": " $0; bad++ } }
        END { exit bad > 0 || left != 1 }' "$out/Simulated.printed"
}

# Offsets within 4 of the sigma printed with them, which is in mg.
near_truth() {
    awk '/^offset, counts:/ { for (i = 1; i <= 3; i++) value[i] = $(NF - 3 + i) }
        /^sigma, mg:/ { for (i = 1; i <= 3; i++) sigma[i] = 16.384 * $(NF - 3 + i) }
        /^world: offset/ { for (i = 1; i <= 3; i++) truth[i] = $(NF - 3 + i) }
        END {
            for (i = 1; i <= 3; i++) {
                off = value[i] - truth[i]
                if (sigma[i] > 0 && off * off <= 16 * sigma[i] ^ 2) good++
                else print value[i], "+-", sigma[i], "truth", truth[i]
            }
            exit good != 3
        }' "$out/Simulated.printed"
}

# Readings after the last reset, where the sensor is held still: what points up, each within 5 of the
# noise of a sample, 2.4 mg, and their means within 3 mg.
readings() {
    awk '/^stored calibration: found/ { found = 1 }
        found && /^a, g:/ { n++; for (i = 1; i <= 3; i++) { a[n, i] = $(2 + i); sum[i] += $(2 + i) } }
        /^world: up/ { for (i = 1; i <= 3; i++) up[i] = $(2 + i) }
        function off(x, y) { return x < y ? y - x : x - y }
        END {
            for (i = 1; i <= 3; i++) {
                for (k = 1; k <= n; k++) if (off(a[k, i], up[i]) > 0.012) { print a[k, i], up[i]; bad++ }
                if (n > 0 && off(sum[i] / n, up[i]) > 0.003) { print "mean", sum[i] / n, up[i]; bad++ }
            }
            exit bad > 0 || n < 5
        }' "$out/Simulated.printed"
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

# An Uno, 32 KB of flash and 2 KB of RAM: who only applies what is stored pays only for that.
applies_on_uno() {
    mkdir "$out/Apply" && cp "$library"/examples/Calibrate/storage.* "$out/Apply/" &&
        cat > "$out/Apply/Apply.ino" <<'EOF'
#include <avr/sleep.h>
#include <invcal.h>
#include "storage.h"

void setup()
{
    invcal_calibration made = {{100, -200, 300}, {{0.01f, 0, 0}, {0, 0.01f, 0}, {0, 0, 0.02f}}};
    const invcal_quality quality = invcal_quality();
    invcal_calibration found;
    const int32_t raw[3] = {200, 0, 0};
    float a[3];

    Serial.begin(115200);
    if (invcal_save(&calibration_store, &made, &quality) == INVCAL_OK &&
        invcal_load(&calibration_store, &found) == INVCAL_OK) {
        invcal_apply_counts(&found, raw, a);
        for (int i = 0; i < 3; i++) {
            Serial.println(a[i]);
        }
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
    mv "$out/libraries/EEPROM" "$out/EEPROM" && builds uno Apply && runs atmega328p Apply &&
        paste -s -d ' ' "$out/Apply.printed" | grep -qx '1.00 2.00 -6.00' &&
        avr-size "$out/Apply.build/Apply.ino.elf" &&
        avr-size "$out/Apply.build/Apply.ino.elf" |
        awk 'NR == 2 { exit $1 + $2 > 9000 || $2 + $3 > 300 }'
}

check "it can be staged" stage_library
check "library.properties keeps to the specification" properties
check "a sketch sees one header of it, no others" one_header
check "the example builds for a Mega 2560, without a warning" builds_example
check "a macro reaches library and sketch" takes_options
check "it builds with a simulated sensor on the bus" builds_simulation
check "it runs, from power-on to the end" runs atmega2560 Simulated
check "it asks, takes positions, and is content" said '^stored calibration: none$' \
    '^calibration begins$' '^next: [+]z up$' '^good: move on$' '^positions taken: 4$' \
    '^world: reset' '^goes on, positions taken: 4$' '^next: .*tilt' '^world: power fails' \
    '^goes on, positions taken: ' '^verdict: good$' '^calibration stored$' '^a, g: ' '^world: reset' \
    '^stored calibration: found$' '^a, g: '
check "after a reset and a power cut it goes on with what was stored" went_on
check "a position that is wrong by 50 mg is left out" outlier
check "samples were lost, as the chip does not wait" said 'nobody has read: [1-9]'
check "what it prints is true within 4 sigma" near_truth
check "after the last reset it finds and applies what was stored" readings
check "README.md says what it takes" costs
check "an Uno stores, finds and applies a calibration" applies_on_uno
finish
