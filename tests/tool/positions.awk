# SPDX-License-Identifier: MIT
#
# Positions of one family, at random: awk -v family=F -v count=N -v seed=S -f random.awk -f positions.awk
# Rows are x,y,z in m/s^2 of a sensor with errors of some percent, in a field of 9.80665.
#
#   sphere      any direction             plane     in a plane through the centre
#   cone        at one angle to an axis   circles   on two parallel circles
#   cap         within 3 degrees          repeated  8 positions over and over
#   hyperboloid x^2 + y^2 - z^2 = 1       cylinder  x^2 + y^2 = 1
#   noise       nothing but noise
function direction(    n) {
    do {
        x = normal(); y = normal(); z = normal()
        n = sqrt(x * x + y * y + z * z)
    } while (n < 0.01)
    x /= n; y /= n; z /= n
}
# A point at height h over the circle of radius r about the axis (a b c).
function on_circle(h, r,    t, d, n) {
    do {
        direction()
        d = x * a + y * b + z * c
        x -= d * a; y -= d * b; z -= d * c
        n = sqrt(x * x + y * y + z * z)
    } while (n < 0.1)
    x = h * a + r * x / n; y = h * b + r * y / n; z = h * c + r * z / n
}
function reading() {
    printf "%.9g,%.9g,%.9g\n", 9.80665 * (1.02 * x + 0.004 * y + 0.03) + 0.001 * normal(),
        9.80665 * (0.97 * y - 0.01 * z - 0.02) + 0.001 * normal(),
        9.80665 * (1.01 * z + 0.002 * x + 0.01) + 0.001 * normal()
}
BEGIN {
    begin_random(seed)
    direction()
    a = x; b = y; c = z
    angle = 0.3 + uniform()
    for (i = 0; i < 8; i++) {
        direction()
        fixed[i, 0] = x; fixed[i, 1] = y; fixed[i, 2] = z
    }
    for (i = 0; i < count; i++) {
        if (family == "plane") on_circle(0, 1)
        else if (family == "cone") on_circle(cos(angle), sin(angle))
        else if (family == "circles") on_circle(i % 2 ? 0.3 : -0.6, i % 2 ? sqrt(0.91) : 0.8)
        else if (family == "cap") on_circle(cos(0.05 * uniform()), 0.05 * uniform())
        else direction()
        if (family == "repeated") {
            x = fixed[i % 8, 0]; y = fixed[i % 8, 1]; z = fixed[i % 8, 2]
        }
        if (family == "hyperboloid" || family == "cylinder") {
            n = sqrt(x * x + y * y)
            h = 4 * uniform() - 2
            r = family == "cylinder" ? 1 : sqrt(1 + h * h)
            x *= r / n; y *= r / n; z = h
        }
        if (family == "noise") {
            x *= 3 * uniform(); y *= 3 * uniform(); z *= 3 * uniform()
        }
        reading()
    }
}
