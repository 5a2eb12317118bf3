# SPDX-License-Identifier: MIT
#
# The rates of a corrected log (t x y z gx gy gz) in the rests that the truth of a simulation lists, where the true rate
# is 0: gyro_rests.awk truth.json corrected.csv. Prints the largest mean of an axis, degrees/s, or 0 without a rest.
BEGIN { FS = "[,: ]+" }
FNR == NR { if ($2 == "\"begin\"") begin[++rests] = $3; if ($2 == "\"end\"") end[rests] = $3; next }
FNR == 1 { at = 1; next }
{
    while (at <= rests && $1 > end[at] - 0.2) at++
    if (at > rests || $1 < begin[at] + 0.2) next
    n[at]++
    for (k = 0; k < 3; k++) sum[at, k] += $(5 + k)
}
END {
    for (i = 1; i <= rests; i++)
        for (k = 0; k < 3 && n[i] > 0; k++) {
            mean = sum[i, k] / n[i] * 57.29577951308232
            if (mean * mean > most * most) most = mean < 0 ? -mean : mean
        }
    print (n[1] > 0) ? most : "no rest"
}
