# SPDX-License-Identifier: MIT
#
# A unit on a two-axis stand, as a file of positions with angles, or as a log of samples:
#
#     awk -v trouble=T -v seed=S -f random.awk -f stand.awk
#
# Readings are in m/s^2 of a sensor with the errors X, the program is the paper's of 18 (Table 2), the columns
# alpha and beta are what the stand states. trouble:
#
#   none       tilt       the unit is mounted 14 mrad off, about (1 2 -2)/3
#   misset     position 8 is off by 10 mrad in alpha           fine      the same by 1 mrad
#   several    positions 3 and 7 are off by 5 degrees in alpha, 11 by 5 degrees in beta
#   many       every second position is off by 5 degrees in alpha
#   swapped    positions 5 and 12 were visited in each other's place
#   repeated   position 7 is also visited in place of 8        twice     an additional position
#   columns    alpha and beta are exchanged                    reversed  beta has the opposite sense
#   zero       alpha reads 20 degrees where it is 0            alpha     alpha has the opposite sense
#   group      group 3 is missing                              offset    the centre of rotation is 0.3 m off
#   lost       position 9 is missing
#
# noise (over the field, default 1e-4), plain=1 (no columns alpha and beta), log=1 (samples, with t).
# The direction of angles, turned about (1 2 -2)/3 by `tilt` (Rodrigues), in the frame of the unit.
function set_direction(a, b,    c, s, d, x, y, z) {
    a *= degree; b *= degree
    x = sin(a) * sin(b); y = cos(a); z = sin(a) * cos(b)
    c = cos(tilt); s = sin(tilt)
    d = (x + 2 * y - 2 * z) / 3 * (1 - c)
    e[1] = c * x + s * (2 * z + 2 * y) / 3 + d / 3
    e[2] = c * y + s * (-2 * x - z) / 3 + 2 * d / 3
    e[3] = c * z + s * (y - 2 * x) / 3 - 2 * d / 3
}
# u = (I + S) eta + delta
function set_reading() {
    u[1] = (1 + X[4]) * e[1] + X[7] / 2 * e[2] + X[8] / 2 * e[3] + X[1]
    u[2] = X[7] / 2 * e[1] + (1 + X[5]) * e[2] + X[9] / 2 * e[3] + X[2]
    u[3] = X[8] / 2 * e[1] + X[9] / 2 * e[2] + (1 + X[6]) * e[3] + X[3]
}
function write_position(a, b,    i, row) {
    row = ""
    for (i = 1; i <= 3; i++) row = row sprintf("%.9f,", 9.80665 * (u[i] + noise * normal()))
    print row (plain ? 0 : a "," b)
}
# A turn of 1.5 s from the previous reading (with the acceleration of a lever arm), then a rest of 4 s.
function write_rest(a, b,    i, k, row) {
    for (k = 0; k < 550; k++) {
        row = sprintf("%.2f", 0.01 * time++)
        for (i = 1; i <= 3; i++) {
            v = k < 150 ? was[i] + (u[i] - was[i]) * k / 150 + (lever + 0.2) * sin(k * i / 3) : u[i]
            row = row sprintf(",%.7f", 9.80665 * (v + noise * 10 * normal()))
        }
        print row "," (k < 150 ? was_a + (a - was_a) * k / 150 : a) "," \
            (k < 150 ? was_b + (b - was_b) * k / 150 : b)
    }
    for (i = 1; i <= 3; i++) was[i] = u[i]
    was_a = a; was_b = b
}
function visit(n, a, b,    true_a, true_b) {
    true_a = a; true_b = b
    if (trouble == "misset" && n == 8) true_a += 0.01 / degree
    if (trouble == "fine" && n == 8) true_a += 0.001 / degree
    if (trouble == "several" && (n == 3 || n == 7)) true_a += 5
    if (trouble == "several" && n == 11) true_b += 5
    if (trouble == "many" && n % 2 == 0) true_a += 5
    if (trouble == "swapped" && n == 5) { true_a = A[12]; true_b = B[12] }
    if (trouble == "swapped" && n == 12) { true_a = A[5]; true_b = B[5] }
    if (trouble == "repeated" && n == 8) { true_a = A[7]; true_b = B[7] }
    set_direction(true_a, true_b)
    set_reading()
    if (trouble == "columns") { true_a = a; a = b; b = true_a }
    if (trouble == "reversed") b = -b
    if (trouble == "zero") a += 20
    if (trouble == "alpha") a = -a
    if (log_wanted) write_rest(a, b); else write_position(a, b)
}
BEGIN {
    begin_random(seed)
    degree = atan2(0, -1) / 180
    split("0.003 -0.002 0.004 0.004 -0.003 0.005 0.006 -0.002 0.003", X)
    if (noise == "") noise = 1e-4
    if (trouble == "tilt") tilt = 0.014
    if (trouble == "offset") lever = 0.3
    for (k = 0; k < 6; k++) {
        A[k + 1] = 30 + 60 * k; B[k + 1] = 0
        A[k + 7] = -90; B[k + 7] = 30 + 60 * k
        A[k + 13] = 120 + 60 * k; B[k + 13] = 90
    }
    print (log_wanted ? "t," : "") "x,y,z," (plain ? "note" : "alpha,beta")
    for (n = 1; n <= (trouble == "group" ? 12 : 18); n++) {
        if (trouble == "lost" && n == 9) continue
        visit(n, A[n], B[n])
        if (trouble == "twice" && n == 7) visit(n, A[n], B[n])
    }
}
