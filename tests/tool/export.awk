# SPDX-License-Identifier: MIT
#
# Another system's correction, applied as that system does, against the truth:
#
#   awk -v how=NAME -v field=F -v show=WHAT -f export.awk PARAMETERS TRUTH
#
# PARAMETERS are the numbers of an export, in the order of the file. TRUTH has a line for each
# reading: the reading x y z as that system gets it, and the true field x y z.
#
#   diagonal    offset, scale                      scale (d - offset), axis by axis
#   ros         SM by rows, bias                   SM d - bias
#   imu_tk      T by rows, K by rows, B            T K (d - B)
#   inertial    M by rows, s, b                    M ((d - b) s)
#   magnetic    matrix by rows, offset             matrix (d - offset)
#
# show=error: the largest error of any number. show=figures: rms and largest length of the error,
# rms and largest error of the length, in mg (thousandths of the field).
function mul(at, u, out,    i) {
    for (i = 0; i < 3; i++) {
        out[i] = p[at + 3 * i] * u[0] + p[at + 3 * i + 1] * u[1] + p[at + 3 * i + 2] * u[2]
    }
}
function less(at, u,    i) {
    for (i = 0; i < 3; i++) u[i] -= p[at + i]
}
function times(at, u,    i) {
    for (i = 0; i < 3; i++) u[i] *= p[at + i]
}
function correct(u, out,    v) {
    if (how == "diagonal") {
        less(0, u); times(3, u)
        out[0] = u[0]; out[1] = u[1]; out[2] = u[2]
    } else if (how == "ros") {
        mul(0, u, out); less(9, out)
    } else if (how == "imu_tk") {
        less(18, u); mul(9, u, v); mul(0, v, out)
    } else if (how == "inertial") {
        less(12, u); times(9, u); mul(0, u, out)
    } else if (how == "magnetic") {
        less(9, u); mul(0, u, out)
    }
}
FNR == NR {
    for (i = 1; i <= NF; i++) p[n++] = $i
    next
}
{
    for (i = 0; i < 3; i++) { u[i] = $(i + 1); t[i] = $(i + 4) }
    correct(u, out)
    square = length2 = 0
    for (i = 0; i < 3; i++) {
        e = out[i] - t[i]
        if (e < 0) e = -e
        if (!(e <= worst)) worst = e
        square += e * e
        length2 += out[i] * out[i]
    }
    stretch = sqrt(length2) - field
    squares += square
    stretches += stretch * stretch
    if (square > largest) largest = square
    if (stretch < 0) stretch = -stretch
    if (stretch > longest) longest = stretch
    count++
}
END {
    if (!count || !n) exit 1
    if (show == "error") printf "%.17g\n", worst
    else printf "%.9g %.9g %.9g %.9g\n", 1000 * sqrt(squares / count) / field,
        1000 * sqrt(largest) / field, 1000 * sqrt(stretches / count) / field, 1000 * longest / field
}
