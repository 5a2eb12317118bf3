# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2154 # package.sh sets what is not set here
#
# For the examples for Zephyr and ESP-IDF: run on a simulated log, they calibrate, and print the true
# values.

simulate() { # OPTION... of invcal simulate: $out/log.csv and $out/truth.json
    "$build/invcal" simulate --plan edges --offset 0.041,-0.025,0.062 --dk 0.012,-0.02,0.017 \
        --rate 100 --noise 0.002 --truth "$out/truth.json" "$@" > "$out/log.csv"
}

calibrates() { # PROGRAM
    (cd "$out" && "$1" < log.csv > printed) && grep -qx 'verdict: good' "$out/printed" &&
        grep -qx 'calibration stored' "$out/printed"
}

# Offsets and scale errors are true within 4 of the sigmas printed with them.
near_truth() {
    tr -d '\n' < "$out/truth.json" > "$out/truth"
    awk '
        function numbers(name, value,    text) {
            text = truth
            if (!sub(".*\"" name "\": *\\[", "", text)) return 0
            sub("].*", "", text)
            return split(text, value, ",")
        }
        NR == FNR { truth = $0; next }
        /^(offset|scale)/ { for (i = 1; i <= 3; i++) v[i] = $(NF - 3 + i); of = $1; next }
        of != "" && /^sigma:/ {
            n = numbers(of == "scale" ? "dk" : "offset", t)
            for (i = 1; i <= 3; i++) {
                off = v[i] - t[i]
                if (n == 3 && $(1 + i) > 0 && off * off <= 16 * $(1 + i) ^ 2) good++
                else print of, v[i], "+-", $(1 + i), "truth", t[i]
            }
            of = ""
        }
        END { exit good != 6 }' "$out/truth" "$out/printed"
}

# Started again, it finds what was stored, and its first readings, at rest, have LENGTH within 2 %.
starts_again() { # PROGRAM LENGTH
    (cd "$out" && "$1" < log.csv > again) && grep -q '^stored calibration: found$' "$out/again" &&
        awk -v field="$2" '/^a, / && n++ < 5 {
                l = sqrt($3 ^ 2 + $4 ^ 2 + $5 ^ 2) / field
                if (l < 0.98 || l > 1.02) { print; bad++ }
            }
            END { exit bad > 0 || n < 5 }' "$out/again"
}
