# SPDX-License-Identifier: MIT
#
# A log like the real one whose rests and moves are in tests/unit/gyro_logs.h: each rest lasts 3 s at its mean, and
# each segment of a move turns steadily.
#     awk -v name=xsens -v zero=32768 -v rate=4772 -v noise=1 -v shake=500 \
#         -f random.awk -f gyro_log.awk gyro_logs.h
#
# rate: counts per rad/s; zero: reading without a turn. Readings have a noise of +-`noise` counts; in moves the
# accelerometer is shaken by `shake`.
function rows(line) { gsub(/[{}]/, " ", line); gsub(/,/, " ", line); return line }
$0 ~ "^static.* " name "_" { split($0, word, /[ _\[]+/); part = $0 ~ /_mean\[/ ? "mean" : $0 ~ /_rest\[/ ? "rest" : "segment"; next }
/^};/ { part = "" }
part == "mean" { mean[means++] = rows($0) }
part == "rest" { rest[rests++] = rows($0) }
part == "segment" { segment[segments++] = rows($0) }
function any() { return 2 * uniform() - 1 } # a sine would pass for rest
function put(a, g) {
    printf "%.2f", n / 100
    for (i = 1; i <= 3; i++) printf ",%.2f", a[i] + noise * any()
    for (i = 1; i <= 3; i++) printf ",%.4f", zero + rate * g[i] + noise * any()
    print ""
    n++
}
END {
    begin_random(0)
    print "t,ax,ay,az,gx,gy,gz"
    for (r = 0; r < rests; r++) {
        split(rest[r], R)
        split(mean[r], A)
        for (k = 1; k <= 3; k++) G[k] = R[k] / 2^18
        count = R[5] > 0 ? R[5] : 0
        first = next_segment
        next_segment += count
        for (s = first; s < next_segment; s++) {
            split(segment[s], S)
            samples = int(S[7] / 2)
            for (j = 0; j < samples; j++) {
                share = (s - first + j / samples) / count
                for (k = 1; k <= 3; k++) {
                    W[k] = (S[k] / 2^15 + S[k + 3] / 2^18) * 100 / samples
                    # between the two, and shaken, so that it is not a rest
                    M[k] = B[k] + share * (A[k] - B[k]) + shake * any()
                }
                put(M, W)
            }
        }
        # a move that was refused: from one to the next, with rates that fit nothing
        for (j = 0; count == 0 && r > 0 && j < 100; j++) {
            for (k = 1; k <= 3; k++) { W[k] = 0.5; M[k] = B[k] + j / 100 * (A[k] - B[k]) + shake * any() }
            put(M, W)
        }
        for (j = 0; j < 300; j++) put(A, G)
        for (k = 1; k <= 3; k++) B[k] = A[k]
    }
}
