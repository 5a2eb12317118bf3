# SPDX-License-Identifier: MIT
#
# 24 positions of a sensor in trouble: awk -v trouble=T -v seed=S -f random.awk -f trouble.awk
# Rows are x,y,z in m/s^2 of a sensor with errors of some percent, in a field of 9.80665, with a noise of
# 0.1 mg: random directions, in the order of the visits.
#
#   none
#   drift       the offsets grow by 3, -4, 0 mg from the first position to the last
#   step        the offset of y steps by 10 mg after the eleventh
#   quadratic   y reads 5 mg (y^2 - 1/3) too much
#   cubic       x reads 20 mg (x^3 - 3/5 x) too much
#   hysteresis  z reads 2 mg more after it was turned upwards, 2 mg less after downwards
#   repeated    nine directions, again and again
#   noisy       5 times the noise
#   wrong       the fourth and the twentieth position read 20 mg too much
#   spoilt      seven positions read 20 mg too much
function direction(    a, n) {
    do {
        n = 0
        for (a = 0; a < 3; a++) { v[a] = normal(); n += v[a] * v[a] }
    } while (n < 0.01)
    for (a = 0; a < 3; a++) v[a] /= sqrt(n)
}
BEGIN {
    begin_random(seed)
    count = 24
    for (i = 0; i < count; i++) {
        direction()
        for (a = 0; a < 3; a++) {
            if (trouble == "repeated" && i >= 9) v[a] = old[i % 9, a]
            old[i, a] = v[a]
        }
        tau = i / (count - 1) - 0.5
        u[0] = 1.02 * v[0] + 0.004 * v[1] + 0.03
        u[1] = 0.97 * v[1] + 0.004 * v[0] - 0.01 * v[2] - 0.02
        u[2] = 1.01 * v[2] - 0.01 * v[1] + 0.01
        if (trouble == "drift") { u[0] += 0.003 * tau; u[1] -= 0.004 * tau }
        if (trouble == "step" && i > 10) u[1] += 0.01
        if (trouble == "quadratic") u[1] += 0.005 * (v[1] * v[1] - 1 / 3)
        if (trouble == "cubic") u[0] += 0.02 * (v[0] ^ 3 - 0.6 * v[0])
        if (trouble == "hysteresis" && i > 0) u[2] += v[2] > old[i - 1, 2] ? 0.002 : -0.002
        wrong = trouble == "wrong" && (i == 3 || i == 19) || trouble == "spoilt" && i % 3 == 1
        for (a = 0; a < 3; a++) {
            if (wrong) u[a] += 0.02 * v[a]
            u[a] += (trouble == "noisy" ? 5 : 1) * 1e-4 * normal()
        }
        printf "%.9g,%.9g,%.9g\n", 9.80665 * u[0], 9.80665 * u[1], 9.80665 * u[2]
    }
}
