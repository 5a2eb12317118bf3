#!/bin/sh
# SPDX-License-Identifier: MIT
#
# This tool reads files that earlier releases of it wrote: release_test.sh path/to/invcal builddir. They
# are in tests/reference/releases, and are never regenerated, only added to. The expected results are
# computed here from their numbers. Prints a line for each check and a count.
here=$(dirname "$0")
# shellcheck source=tests/tool/support.sh
. "$here/support.sh"
releases=$here/../reference/releases

rows() { sed 1d "$1" | tr ',\n' '  '; }

# The top of a file: 3 numbers of offset, 9 of matrix, on one line.
correction() {
    awk '/^  "offset": / { gsub(/[^-+.0-9e ]/, ""); sub(/^ *e */, ""); print }
        /^  "matrix": / { on = 1; next }
        on && /^  \]/ { exit }
        on { gsub(/[^-+.0-9e ]/, ""); print }' "$1" | tr '\n' ' '
}

# The readings in raw.csv, corrected.
corrected() { # CORRECTION
    { echo "$1"; sed 1d "$work/raw.csv" | tr ',\n' '  '; } | tr '\n' ' ' | awk '{
        for (i = 13; i < NF; i += 3)
            for (r = 4; r <= 10; r += 3)
                printf "%.12g ", $r * ($i - $1) + $(r + 1) * ($(i + 1) - $2) + $(r + 2) * ($(i + 2) - $3)
    }'
}
corrects() { # SENTENCE CORRECTION
    check "$1" near 1e-7 "$(rows "$work/stdout")" "$(corrected "$2")"
}

printf 'x,y,z\n33000,33300,32400\n29000,37000,31000\n' > "$work/raw.csv"
for file in "$releases"/*-calibration.json; do
    accepts "${file##*/} is read" apply "$file" "$work/raw.csv"
    corrects "and corrects as its numbers say" "$(correction "$file")"
    for format in c px4 ardupilot ros imu_tk fusion; do
        run export "$file" --format $format # some state on stderr what they lose
        check "and is exported to $format" [ "$code" -eq 0 ]
    done
done

# Both sensors: the gyroscope's part is two blanks further in.
for file in "$releases"/*-gyroscope.json; do
    accepts "${file##*/} is read" apply "$file" "$work/raw.csv"
    corrects "and corrects an accelerometer" "$(correction "$file")"
    accepts "and for the gyroscope" apply --gyro "$file" "$work/raw.csv"
    sed '1,/^  "gyroscope"/d; s/^  //' "$file" > "$work/gyroscope.json"
    corrects "and corrects that as its numbers say" "$(correction "$work/gyroscope.json")"
done

# The sensor that terms of the axes describe, u = (I + S) eta + delta + q eta^2 + c eta^3: the directions come back.
vector() { sed -n "s/^ *\"$1\": \[\(.*\)\],*\$/\1/p" "$2" | head -n 1 | tr -d ,; }
for file in "$releases"/*-nonlinear.json; do
    for name in delta dk gamma quadratic cubic; do
        vector $name "$file"
    done | awk '{ for (i = 1; i <= 3; i++) x[NR, i] = $i }
        END {
            print "x,y,z"
            for (k = 0; k < 3; k++) {
                a = k == 0 ? 1 : 0.6 * (k == 1); b = k == 1 ? 0.8 : 0; c = k == 2 ? -1 : 0
                printf "%.15g,%.15g,%.15g\n", read(1, a) + x[3, 1] / 2 * b + x[3, 2] / 2 * c,
                    read(2, b) + x[3, 1] / 2 * a + x[3, 3] / 2 * c, read(3, c) + x[3, 2] / 2 * a + x[3, 3] / 2 * b
            }
        }
        function read(i, eta) { return eta + x[1, i] + x[2, i] * eta + x[4, i] * eta ^ 2 + x[5, i] * eta ^ 3 }' > "$work/bent.csv"
    accepts "${file##*/} is read" apply "$file" "$work/bent.csv"
    check "and gives the directions back" near 1e-8 "$(rows "$work/stdout")" "1 0 0 .6 .8 0 0 0 -1"
    run export "$file" --format c
    check "and is not exported, which is reported" [ "$code" -ne 0 ]
done

# A magnetometer.
printf 'mx,my,mz\n40,-20,10\n-5,30,-40\n' > "$work/raw.csv"
for file in "$releases"/*-magnetometer.json; do
    accepts "${file##*/} is read" apply "$file" "$work/raw.csv"
    corrects "and corrects as its numbers say" "$(correction "$file")"
done

# The sensor that a thermal calibration describes, u = (I + S) eta + delta with X = c0 + c1 t, in three
# directions at three temperatures: the correction must give the directions back.
for file in "$releases"/*-thermal.json; do
    sed -n '/^    "coefficients"/,/^    \]/s/^        "[a-z]*": \[\(.*\)\].*/\1/p' "$file" | tr -d , | awk '
        { for (i = 1; i <= 3; i++) c[++n] = $i }
        END {
            print "x,y,z,temperature"
            for (k = 0; k < 9; k++) {
                temperature = -10 + 30 * (k % 3)
                t = (temperature - 25) / 45
                for (i = 1; i <= 9; i++) s[i] = c[i] + c[i + 9] * t
                x = k < 3 ? 1 : 0.6 * (k < 6); y = k < 3 ? 0 : k < 6 ? 0.8 : 0; z = k < 6 ? 0 : -1
                printf "%.15g,%.15g,%.15g,%g\n", x + s[4] * x + s[7] / 2 * y + s[8] / 2 * z + s[1],
                    y + s[7] / 2 * x + s[5] * y + s[9] / 2 * z + s[2],
                    z + s[8] / 2 * x + s[9] / 2 * y + s[6] * z + s[3], temperature
            }
        }' > "$work/thermal.csv"
    accepts "${file##*/} is read" apply "$file" "$work/thermal.csv"
    cut -d , -f 1-3 "$work/stdout" > "$work/directions"
    check "and corrects at three temperatures" near 1e-8 "$(rows "$work/directions")" \
        "1 0 0 1 0 0 1 0 0 .6 .8 0 .6 .8 0 .6 .8 0 0 0 -1 0 0 -1 0 0 -1"
done

# White noise: what remains after that many seconds is the worst axis over their root, over g.
for file in "$releases"/*-noise.json; do
    accepts "${file##*/} is read" plan --limits 0.0002,0.0003,0.0005 --allan "$file" --json
    expected=$(awk -v seconds="$(json "$work/stdout" dwell)" '/"white": / && $2 + 0 > white { white = $2 + 0 }
        /^  "gravity"/ { g = $2 + 0 }
        END { printf "%.12g\n", white / sqrt(seconds) / g }' "$file")
    check "and gives the dwell" near 1e-12 "$(json "$work/stdout" dwell_sigma)" "$expected"
done

finish
