#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python3 magnetometer.py ck_acc_mag.csv > magnetometer.h

Independent fits of a real magnetometer in motion, for test_magnetometer.c: 12,000 samples in gauss from a
hand-held board (CK-Explorer/Magnetometer-and-Accelerometer-Calibration, acc_mag_log.csv, Apache-2.0). The log
itself is not part of the project: only these fits, and the means of each 16 samples. Least squares of
|A (v - c)| - 1, A symmetric, by Gauss-Newton steps.
"""
import math
import sys

from vectors import cross, dot, solve, unit

MEAN_OF = 16


def read(path, wanted):
    with open(path, encoding="ascii") as file:
        names = file.readline().strip().split(",")
        columns = [names.index(name) for name in wanted]
        return [[float(cells[c]) for c in columns] for cells in (line.split(",") for line in file)]


PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


def symmetric(a):
    return [[a[0], a[3], a[4]], [a[3], a[1], a[5]], [a[4], a[5], a[2]]]


def calibrated(x, v):
    d = [v[i] - x[i] for i in range(3)]
    a = symmetric(x[3:])
    return d, [sum(a[i][k] * d[k] for k in range(3)) for i in range(3)]


def residual(x, v):
    return math.hypot(*calibrated(x, v)[1]) - 1


def fit(samples, weights, x):
    for _ in range(20):
        normal = [[0.0] * 9 for _ in range(9)]
        right = [0.0] * 9
        a = symmetric(x[3:])
        for v, weight in zip(samples, weights):
            d, w = calibrated(x, v)
            length = math.hypot(*w)
            e = [c / length for c in w]
            row = [-sum(e[i] * a[i][k] for i in range(3)) for k in range(3)]
            row += [e[i] * d[j] + (e[j] * d[i] if i != j else 0) for i, j in PAIRS]
            r = length - 1
            for i in range(9):
                scaled = weight * row[i]
                right[i] -= scaled * r
                line = normal[i]
                for k in range(i + 1):
                    line[k] += scaled * row[k]
        for i in range(9):
            for k in range(i):
                normal[k][i] = normal[i][k]
        step = solve(normal, right)
        x = [p + q for p, q in zip(x, step)]
        if max(map(abs, step)) < 1e-12:
            break
    return x


def first_guess(samples):
    low = [min(v[i] for v in samples) for i in range(3)]
    high = [max(v[i] for v in samples) for i in range(3)]
    radius = sum(h - l for h, l in zip(high, low)) / 6
    return [(h + l) / 2 for h, l in zip(high, low)] + [1 / radius] * 3 + [0.0] * 3


def by_cells(samples, x):
    """The mean of each cell, of 10 degrees in elevation and about as much in azimuth."""
    cells = {}
    for v in samples:
        w = calibrated(x, v)[1]
        row = int(math.degrees(math.asin(w[2] / math.hypot(*w))) // 10)
        across = max(1, round(36 * math.cos(math.radians(10 * row + 5))))
        column = int((math.degrees(math.atan2(w[1], w[0])) % 360) * across / 360)
        cells.setdefault((row, column), []).append(v)
    return [[sum(v[i] for v in cell) / len(cell) for i in range(3)] for cell in cells.values()]


def robust(samples, x):
    """Tukey's biweight."""
    for _ in range(15):
        r = [abs(residual(x, v)) for v in samples]
        limit = 4.685 * 1.4826 * sorted(r)[len(r) // 2]
        x = fit(samples, [(1 - (e / limit) ** 2) ** 2 if e < limit else 0.0 for e in r], x)
    return x


def rotate(angle, v):
    """By a rotation vector (Rodrigues)."""
    size = math.hypot(*angle) or 1e-300
    e = [c / size for c in angle]
    across = cross(e, v)
    along = dot(e, v) * (1 - math.cos(size))
    return [math.cos(size) * v[i] + math.sin(size) * across[i] + along * e[i] for i in range(3)]


def axes(ups, fields):
    """The rotation vector that makes up . R field most nearly constant, and that constant: by Gauss-Newton
    steps with differences."""
    def errors(x):
        return [sum(p * q for p, q in zip(u, rotate(x[:3], m))) - x[3] for u, m in zip(ups, fields)]

    x = [0.0] * 4
    for _ in range(8):
        e = errors(x)
        columns = []
        for k in range(4):
            moved = list(x)
            moved[k] += 1e-5
            columns.append([(p - q) / 1e-5 for p, q in zip(errors(moved), e)])
        normal = [[sum(p * q for p, q in zip(a, b)) for b in columns] for a in columns]
        step = solve(normal, [-sum(p * q for p, q in zip(a, e)) for a in columns])
        x = [p + q for p, q in zip(x, step)]
    return x


def both_directions(ups, samples, x):
    """From the instants at which the accelerometer has its usual length within 10 %."""
    lengths = [math.hypot(*u) for u in ups]
    usual = sorted(lengths)[len(lengths) // 2]
    kept = [n for n, length in enumerate(lengths) if abs(length - usual) <= 0.1 * usual]
    return [unit(ups[n]) for n in kept], [unit(calibrated(x, samples[n])[1]) for n in kept]


def main():
    samples = read(sys.argv[1], ("mx", "my", "mz"))
    all_of = fit(samples, [1.0] * len(samples), first_guess(samples))
    cells = by_cells(samples, all_of)
    fits = (("all", all_of), ("cells", fit(cells, [1.0] * len(cells), all_of)),
            ("robust", robust(samples[::4], all_of)))
    means = [[sum(v[i] for v in samples[n:n + MEAN_OF]) / MEAN_OF for i in range(3)]
             for n in range(0, len(samples) - MEAN_OF + 1, MEAN_OF)]
    print("/* SPDX-License-Identifier: MIT\n *\n * Made by magnetometer.py of a log that is not kept here: see there. */")
    print("#ifndef MAGNETOMETER_REFERENCE_H\n#define MAGNETOMETER_REFERENCE_H\n\n#include <stdint.h>\n")
    print("/* Offsets in gauss by three fits: of all samples, of one mean for each 10 degrees, and robust. */")
    print("static const double reference_offsets[3][3] = {")
    print(",\n".join("    {" + ", ".join(f"{c:.6f}" for c in x[:3]) + "}" for _, x in fits) + "};\n")
    rms = math.sqrt(sum(residual(all_of, v) ** 2 for v in samples) / len(samples))
    print(f"/* What samples differ from the first by, over field, root mean square. */\nstatic const double reference_rms = {rms:.6f};\n")
    x = axes(*both_directions(read(sys.argv[1], ("ax", "ay", "az")), samples, all_of))
    print("/* The rotation from its axes to those of the accelerometer, a vector, and the sine of how far the field\n"
          " * points up. */\nstatic const double reference_axes[4] = {" + ", ".join(f"{c:.5f}" for c in x) + "};\n")
    print(f"/* Means of {MEAN_OF} samples each, microgauss. */\nstatic const int32_t reference_means[][3] = {{")
    lines = []
    for n in range(0, len(means), 4):
        lines.append("    " + ", ".join("{" + ", ".join(str(round(c * 1e6)) for c in v) + "}" for v in means[n:n + 4]))
    print(",\n".join(lines) + "};\n\n#endif")


main()
