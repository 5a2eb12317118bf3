# SPDX-License-Identifier: MIT
#
# Evaluates the directions of `invcal plan --json` independently, and checks its figures: sigma, ln
# det H'H, the angles, the axes. Prints "n sigma_delta sigma_dk sigma_gamma ln_det below", where below
# is how far ln det is below the bound of a spherical 4-design; or one line that begins with "wrong".
# K is found by Gauss-Jordan elimination, which the library does not use.
function abs(x) { return x < 0 ? -x : x }
function apart(a, b) { return !(abs(a - b) <= 1e-9 * (1 + abs(b))) }
function numbers(text, out) {
    gsub(/.*: |[][,]/, " ", text)
    return split(text, out, " ")
}
function wrong(what) {
    if (!said) print "wrong: " what
    said = 1
}
/^  "(sigma_[a-z]*|log_det|labour)"/ {
    name = $1
    gsub(/[":]/, "", name)
    numbers($0, v)
    claimed[name] = v[1]
}
/^  "axes_covered"/ { covered = $0; gsub(/.*: |[][," ]/, "", covered) }
/^      "alpha"/ { numbers($0, v); alpha = v[1] }
/^      "beta"/ { numbers($0, v); beta = v[1] }
/^      "vertical"/ {
    if (numbers($0, v) != 3) wrong("no vertical")
    x = v[1]; y = v[2]; z = v[3]
    degree = atan2(0, -1) / 180
    if (apart(x * x + y * y + z * z, 1)) wrong("no unit vector")
    if (apart(x, sin(alpha * degree) * sin(beta * degree)) || apart(y, cos(alpha * degree)) ||
        apart(z, sin(alpha * degree) * cos(beta * degree))) wrong("angles of position " n + 1)
    if (!(alpha > -180 && alpha <= 180 && beta > -180 && beta <= 180)) wrong("angle not wrapped")
    if (x > 0.9999985) up["+x"]; if (x < -0.9999985) up["-x"]
    if (y > 0.9999985) up["+y"]; if (y < -0.9999985) up["-y"]
    if (z > 0.9999985) up["+z"]; if (z < -0.9999985) up["-z"]
    h[1] = x; h[2] = y; h[3] = z
    h[4] = x * x; h[5] = y * y; h[6] = z * z; h[7] = x * y; h[8] = x * z; h[9] = y * z
    for (r = 1; r <= 9; r++) for (c = 1; c <= 9; c++) a[r, c] += h[r] * h[c]
    n++
}
END {
    for (r = 1; r <= 9; r++) for (c = 1; c <= 9; c++) a[r, c + 9] = r == c
    log_det = 0
    for (k = 1; k <= 9; k++) {
        best = k
        for (r = k; r <= 9; r++) if (abs(a[r, k]) > abs(a[best, k])) best = r
        pivot = a[best, k]
        if (abs(pivot) < 1e-9) { wrong("singular"); exit }
        for (c = 1; c <= 18; c++) { t = a[best, c]; a[best, c] = a[k, c]; a[k, c] = t / pivot }
        log_det += log(abs(pivot))
        for (r = 1; r <= 9; r++) if (r != k) {
            f = a[r, k]
            for (c = 1; c <= 18; c++) a[r, c] -= f * a[k, c]
        }
    }
    for (b = 0; b < 3; b++) {
        s[b] = 0
        for (r = 3 * b + 1; r <= 3 * b + 3; r++) if (a[r, r + 9] > s[b]) s[b] = a[r, r + 9]
        s[b] = sqrt(s[b])
    }
    order = "+x-x+y-y+z-z"
    for (i = 1; i < 12; i += 2) if (substr(order, i, 2) in up) axes = axes substr(order, i, 2)
    if (axes != covered) wrong("axes: " axes " not " covered)
    if (n != claimed["labour"]) wrong("labour")
    if (apart(s[0], claimed["sigma_delta"]) || apart(s[1], claimed["sigma_dk"]) ||
        apart(s[2], claimed["sigma_gamma"]) || apart(log_det, claimed["log_det"])) wrong("sigma")
    if (said) exit
    bound = 4 * log(n / 3) + 2 * log(2 * n / 15) + 3 * log(n / 15)
    printf "%d %.9f %.9f %.9f %.9f %.9f\n", n, s[0], s[1], s[2], log_det, bound - log_det
}
