# SPDX-License-Identifier: MIT
#
# A sensor whose errors depend on temperature, as the reference computed its bound:
#
#   awk -v what=positions -v stations=-20,25,70 -v seed=S -v sigma=S -f random.awk -f thermal.awk expected.h
#       position means in g with a column temperature: the program of 18 at each station; the
#       positions `wrong` (such as 5,23, from 1) read 0.05 too much
#   awk -v what=grid -f random.awk -f thermal.awk expected.h
#       the same without noise in the directions and at the temperatures of the bound
#   awk -v what=NAME -f random.awk -f thermal.awk expected.h
#       the numbers of expected_NAME
function reading(x, y, z, temperature, sigma, error,    k, s, t) {
    t = (temperature - 25) / 45
    for (k = 1; k <= 9; k++) s[k] = number["thermal_constant", k] + number["thermal_slope", k] * t
    printf "%.12g,%.12g,%.12g,%s\n",
        (1 + error) * (x + s[4] * x + s[7] / 2 * y + s[8] / 2 * z) + s[1] + sigma * normal(),
        (1 + error) * (y + s[7] / 2 * x + s[5] * y + s[9] / 2 * z) + s[2] + sigma * normal(),
        (1 + error) * (z + s[8] / 2 * x + s[9] / 2 * y + s[6] * z) + s[3] + sigma * normal(),
        temperature
}
function positions(    k, i, n, station, count, list, is_wrong) {
    for (k = split(wrong, list, ","); k > 0; k--) is_wrong[list[k]] = 1
    count = split(stations, station, ",")
    for (k = 1; k <= count; k++) for (i = 0; i < 18; i++) {
        n++
        reading(number["plan18", 3 * i + 1], number["plan18", 3 * i + 2],
            number["plan18", 3 * i + 3], station[k], sigma, (n in is_wrong) ? 0.05 : 0)
    }
}
function grid(    k, a, b, i, j, long, short) { # an icosahedron: (0 +-1 +-phi) and round
    long = sqrt((1 + 1 / sqrt(5)) / 2)
    short = sqrt((1 - 1 / sqrt(5)) / 2)
    for (k = 0; k < 9; k++) for (i = -1; i <= 1; i += 2) for (j = -1; j <= 1; j += 2) {
        a = i * short
        b = j * long
        reading(0, a, b, 10 * k - 15, 0, 0)
        reading(a, b, 0, 10 * k - 15, 0, 0)
        reading(b, 0, a, 10 * k - 15, 0, 0)
    }
}
/^static const double expected_/ {
    name = $4
    sub(/^expected_/, "", name)
    sub(/\[.*/, "", name)
    sub(/.*=/, "")
}
name != "" {
    ends = /;/
    gsub(/[{};]/, " ")
    n = split($0, item, ",")
    for (i = 1; i <= n; i++) if (item[i] ~ /[0-9]/) number[name, ++size[name]] = item[i] + 0
    if (ends) name = ""
}
END {
    begin_random(seed)
    if (what == "positions" || what == "grid") print "x,y,z,temperature"
    if (what == "positions") positions()
    else if (what == "grid") grid()
    else for (i = 1; i <= size[what]; i++) printf "%.17g ", number[what, i]
}
