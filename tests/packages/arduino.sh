#!/bin/sh
# SPDX-License-Identifier: MIT
# shellcheck disable=SC2154 # package.sh sets what is not set here
#
# The Arduino library, as Arduino's own builder takes it: each example is built for a board, and the image,
# as it would be flashed, runs in simavr on that board's processor, with a simulated MPU-6050 on its I2C bus
# and a hand that follows the instructions (tests/packages/arduino/board.c): from the first power-on to the
# last, when the calibration is found in the EEPROM. Calibrate runs on an Uno, with a reset, a power cut while
# the session is stored, and a wrong position; Gyroscope on a Mega, with a turn that is too quick and lost samples.
. "$(dirname "$0")/../package.sh"
need arduino-builder avr-g++ avr-size simavr gcc g++
library=$out/libraries/invcal
cores=/usr/share/arduino/hardware
board=${ARDUINO_BOARD:-uno} # or mega
case $board in
mega) fqbn=mega:cpu=atmega2560 mcu=atmega2560 ;;
uno) fqbn=uno mcu=atmega328p ;;
esac

stage_library() {
    sh port/stage.sh arduino "$library"
}

# https://docs.arduino.cc/arduino-cli/library-specification
properties() {
    awk -F = -v version="$(sh port/version.sh)" -v address="$(sh port/address.sh)" '
        /^#/ { next }
        { value[$1] = substr($0, length($1) + 2) }
        END {
            split("name version author maintainer sentence paragraph category url architectures", all, " ")
            for (i in all) if (value[all[i]] == "") { print "no " all[i]; bad++ }
            if (value["name"] !~ /^[A-Za-z0-9][A-Za-z0-9_. -]*$/) { print value["name"]; bad++ }
            if (value["version"] != version) { print value["version"]; bad++ }
            if (value["url"] != address) { print value["url"]; bad++ }
            if (value["category"] !~ /^(Display|Communication|Signal Input\/Output|Sensors|Device Control|Timing|Data Storage|Data Processing|Other)$/) {
                print value["category"]
                bad++
            }
            if (value["includes"] != "invcal.h") { print value["includes"]; bad++ }
            exit bad > 0
        }' "$library/library.properties"
}

# Files there are on the include path of every sketch.
one_header() {
    found=$(cd "$library/src" && find . -maxdepth 1 -type f)
    echo "$found"
    [ "$found" = ./invcal.h ]
}

# builds BOARD SKETCH [FLAG]: into $out/SKETCH.build. A warning in our files is an error.
# (Debian's gcc-avr 5.4 lacks DECIMAL_DIG in C++, which the core of 1.8.7 needs.)
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
        builds "$fqbn" Calibrate
}

ram() { # SKETCH
    avr-size "$out/$1.build/$1.ino.elf" | awk 'NR == 2 { print $2 + $3 }'
}

# 4 positions fewer, of 12 bytes each.
takes_options() {
    mkdir "$out/Small" && cp "$library"/examples/Calibrate/* "$out/Small/" &&
        mv "$out/Small/Calibrate.ino" "$out/Small/Small.ino" &&
        builds "$fqbn" Small -DINVCAL_MAX_POSITIONS=12 &&
        echo "$(ram Calibrate) bytes, with fewer positions $(ram Small)" &&
        [ $(($(ram Calibrate) - $(ram Small))) -eq 48 ]
}

builds_simulation() {
    gcc -O2 -std=c99 -Wall -Wextra -Wconversion -Wshadow -Werror -Iinclude -Itests/hand \
        tests/packages/arduino/board.c tests/hand/hand.c \
        "$build/float/libinvcal.a" -lsimavr -lm -o "$out/board"
}

# runs_on_board MCU SKETCH [gyroscope]: what it prints goes to $out/SKETCH.session, for the checks below.
runs_on_board() {
    session=$out/$2.session
    # shellcheck disable=SC2086 # or no argument
    timeout 600 "$out/board" "$1" "$out/$2.build/$2.ino.elf" $3 > "$session"
    status=$?
    tail -n 3 "$session"
    [ "$status" -eq 0 ]
}

# runs MCU SKETCH: what comes from the UART goes to $out/SKETCH.printed. simavr colours it, and shows
# carriage return and line feed as a dot each.
runs() {
    escape=$(printf '\033')
    timeout 300 simavr -m "$1" -f 16000000 "$out/$2.build/$2.ino.elf" > "$out/$2.raw" 2>&1 < /dev/null
    status=$?
    sed -n "s/^\(${escape}\[0m\)*${escape}\[32m\(.*\)\.\.\$/\2/p" "$out/$2.raw" > "$out/$2.printed"
    tail -n 3 "$out/$2.raw"
    [ "$status" -eq 0 ]
}

# said PATTERN...: lines that match the patterns were printed, in this order.
said() {
    printf '%s\n' "$@" > "$out/patterns"
    awk 'NR == FNR { pattern[++n] = $0; next }
        i < n && $0 ~ pattern[i + 1] { i++ }
        END { if (i < n) print "not said: " pattern[i + 1]; exit i < n }' \
        "$out/patterns" "$session"
}

# As many positions after each reset as were stored last.
went_on() {
    awk '/^world: power fails/ { cut = 1; next } # that position was not stored
        /^positions taken: / { before = stored; stored = $NF; next }
        /^goes on, / { found++; if ($NF != (cut ? before : stored)) { print; bad++ }; stored = $NF; cut = 0 }
        END { exit bad > 0 || found != 2 }' "$session"
}

# Only the one that was taken while somebody pulled.
outlier() {
    awk '/^world: somebody pulls/ { next_is = 1 }
        next_is && /^positions taken: / { wrong = $NF; next_is = 0 }
        /^left out, / { left++; if ($NF != wrong) { print "wrong is " wrong ": " $0; bad++ } }
        END { exit bad > 0 || left != 1 }' "$session"
}

# What the EEPROM holds, against the sensor that was simulated: within 2 mg in all directions.
near_truth() {
    awk '/^world: what is stored is wrong by / { n++; good += $(NF - 3) > 0 && $(NF - 3) < 2 }
        END { exit n != 1 || good != 1 }' "$session"
}

# Readings after the last power-on, where the sensor is held still: what points up, each within 5 of the
# noise of a sample, 2.4 mg, and their means within 3 mg.
readings() {
    awk '/^stored calibration: found/ { found = 1 }
        found && /^a, mg:/ { n++; for (i = 1; i <= 3; i++) { a[n, i] = $(2 + i); sum[i] += $(2 + i) } }
        /^world: up, mg:/ { for (i = 1; i <= 3; i++) up[i] = $(3 + i) }
        function off(x, y) { return x < y ? y - x : x - y }
        END {
            for (i = 1; i <= 3; i++) {
                for (k = 1; k <= n; k++) if (off(a[k, i], up[i]) > 12) { print a[k, i], up[i]; bad++ }
                if (n > 0 && off(sum[i] / n, up[i]) > 3) { print "mean", sum[i] / n, up[i]; bad++ }
            }
            exit bad > 0 || n < 5
        }' "$session"
}

# What the example takes, according to README.md: no less than is true, and at most a tenth more.
costs() {
    set -- "$(avr-size "$out/Calibrate.build/Calibrate.ino.elf" | awk 'NR == 2 { print $1 + $2, $2 + $3 }')" \
        "$(sed -n 's/^world: RAM .*, stack //p' "$session")" \
        "$(tr '\n' ' ' < "$library/README.md" | sed 's/,//g;
            s/.*takes \([0-9]*\) bytes of flash and \([0-9]*\) of RAM and up to \([0-9]*\) of stack.*/\1 \2 \3/')"
    echo "$@"
    echo "$@" | awk '{ for (i = 1; i <= 3; i++) good += $i > 0 && $(i + 3) >= $i && $(i + 3) <= 1.1 * $i }
        END { exit good != 3 }'
}

# Flash, and RAM including the deepest stack.
fits_uno() {
    set -- "$(avr-size "$out/Calibrate.build/Calibrate.ino.elf" | awk 'NR == 2 { print $1 + $2 }')" \
        "$(awk '/^world: RAM / { print $3 + $5 }' "$session")"
    echo "$1 bytes of flash, $2 of RAM"
    [ "$1" -le 28000 ] && [ "$2" -le 1713 ]
}

# An Uno, 32 KB of flash and 2 KB of RAM: a sketch that only applies what is stored pays only for that.
applies_on_uno() {
    mkdir "$out/Apply" && cp "$library"/examples/Calibrate/storage.* "$library/examples/Calibrate/cells.h" "$out/Apply/" &&
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
    if (invcal_save(&made, &quality, &calibration_store) == INVCAL_OK &&
        invcal_load(&found, &calibration_store) == INVCAL_OK) {
        invcal_apply(&found, raw[0], raw[1], raw[2], a);
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
    builds uno Apply && runs atmega328p Apply &&
        paste -s -d ' ' "$out/Apply.printed" | grep -qx '1.00 2.00 -6.00' &&
        avr-size "$out/Apply.build/Apply.ino.elf" &&
        avr-size "$out/Apply.build/Apply.ino.elf" |
        awk 'NR == 2 { exit $1 + $2 > 9000 || $2 + $3 > 300 }'
}

# The sketch of port/manual/arduino.md, with the files of the example.
builds_page() {
    mkdir "$out/Page" && cp "$library"/examples/Calibrate/*.cpp "$library"/examples/Calibrate/*.h "$out/Page/" &&
        awk '/^```cpp$/ { on = 1; next } /^```/ { on = 0 } on' port/manual/arduino.md > "$out/Page/Page.ino" &&
        [ "$(grep -c . "$out/Page/Page.ino")" -gt 10 ] && builds uno Page
}

# The other example: built for the board; and run here, with what the page sends on its serial port.
builds_browser() {
    mkdir "$out/Browser" && cp "$library"/examples/Browser/* "$out/Browser/" && builds "$fqbn" Browser &&
        avr-size "$out/Browser.build/Browser.ino.elf"
}

browser_stores() {
    g++ -std=c++11 -Wall -Wextra -Wno-unused-function -Itests/packages/arduino/mock -I"$library/src" \
        -I"$out/Browser" tests/packages/arduino/browser.cpp "$build/float/libinvcal.a" -lm -o "$out/browser" &&
        "$out/browser"
}

# On boards that emulate an EEPROM in flash, storage.cpp stores the same: two saves, one that fails, and each load after
# a power-on of its own.
emulated_stores() { # SKETCH BOARD'S-MACRO
    program=$out/emulated-$1-$2
    g++ -std=c++11 -Wall -Wextra "-D$2" -Itests/packages/arduino/emulated -I"$library/src" \
        -I"$library/examples/$1" tests/packages/arduino/emulated.cpp "$library/examples/$1/storage.cpp" \
        "$build/float/libinvcal.a" -lm -o "$program" || return
    ! "$program" "$program.flash" load && "$program" "$program.flash" save first &&
        [ "$("$program" "$program.flash" load)" = first ] && "$program" "$program.flash" save second &&
        ! "$program" "$program.flash" fail third && [ "$("$program" "$program.flash" load)" = second ]
}

# The example for both sensors says that it is not for an Uno.
builds_gyroscope() {
    mkdir -p "$out/Gyroscope" && cp "$library"/examples/Gyroscope/* "$out/Gyroscope/" &&
        builds mega:cpu=atmega2560 Gyroscope
}

too_large_for_uno() {
    ! builds uno Gyroscope && grep -q 'error.*this sketch takes 7 KB of RAM' "$out/Gyroscope.log"
}

# The moves that were spoilt, and no others.
refused_moves() {
    refused=$(sed -n 's/^move refused: //p' "$session" | paste -s -d , -)
    echo "$refused"
    [ "$refused" = "at the end of the range,samples were lost in the move" ]
}

# The gyroscope's nine are known to 0.1 %, and true within 4 sigma; the accelerometer within 2 mg.
near_both_truths() {
    near_truth && awk '/^world: gyro_.. sigma / { n++; good += $NF > 0 && $NF < 1e-3 }
        /^world: the gyroscope is wrong by / { n++; good += $7 > 0 && $7 < 4 && $(NF - 1) < 1 }
        END { exit n != 10 || good != 10 }' "$session"
}

# RAM including the deepest stack; half a kilobyte is left for the user's code.
fits_mega() {
    awk '/^world: RAM / { print $3 + 0, $5; exit !($3 > 0 && $3 + $5 <= 7680) }' "$session"
}

check "it can be staged" stage_library
check "library.properties keeps to the specification" properties
check "a sketch sees only one of its headers" one_header
check "the example builds for $board, without a warning" builds_example
check "a macro reaches the library and the sketch" takes_options
check "the simulated board builds" builds_simulation
check "the image runs on it, from power-on to the end" runs_on_board "$mcu" Calibrate
check "it asks for positions, takes them, and ends with a good verdict" said '^stored calibration: none$' \
    '^calibration begins$' '^next: [+]z up$' '^good: move on$' '^positions taken: 4$' \
    '^world: reset' '^goes on, positions taken: 4$' '^next: .*tilt' '^world: power fails' \
    '^goes on, positions taken: ' '^verdict: good$' '^calibration stored$' '^world: power returns$' \
    '^stored calibration: found$' '^a, mg: '
check "after a reset and a power cut it goes on with what was stored" went_on
check "a position that is wrong by 50 mg is left out" outlier
check "samples were lost, as the chip does not wait" said 'nobody has read: [1-9]'
check "what it stored is true within 2 mg" near_truth
check "after the last power-on it finds and applies what was stored" readings
check "README.md states its costs" costs
[ "$board" = mega ] || check "it leaves an Uno 4 KB of flash and 335 bytes of RAM" fits_uno
check "an Uno stores, finds and applies a calibration" applies_on_uno
check "the sketch of port/manual/arduino.md builds, without a warning" builds_page
check "the example for the page in a browser builds, without a warning" builds_browser
check "it prints readings, stores what the page sends, and refuses what is damaged" browser_stores
for macro in ESP32 ESP8266 ARDUINO_ARCH_RP2040; do
    check "storage.cpp of Calibrate stores with $macro" emulated_stores Calibrate $macro
    check "storage.cpp of Gyroscope stores with $macro" emulated_stores Gyroscope $macro
done
check "the example for both sensors builds for a Mega, without a warning" builds_gyroscope
long "its image runs there, from power-on to the end" runs_on_board atmega2560 Gyroscope gyroscope
long "it asks for each turn of the tour until it is made, and begins again on request" said \
    '^stored calibration: none$' '^calibration begins$' '^next: [+]z up$' '^good: move on$' '^next: [+]x up$' \
    '^turns made, of 12: 0$' '^turns made, of 12: 1$' '^move refused: ' '^turns made, of 12: 10$' \
    '^turns made, of 12: 11$' '^turns made, of 12: 12$' '^verdict: good$' \
    '^calibration stored$' '^world: power returns$' '^stored calibration: found$' '^rate, mrad/s: ' \
    '^calibration begins$'
long "the spoilt moves are refused" refused_moves
long "what it stored of both sensors is true" near_both_truths
long "after the last power-on it finds and applies that" readings
long "it leaves a Mega half a kilobyte of RAM" fits_mega
check "it says that an Uno is too small" too_large_for_uno
finish
