#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python3 gyro_samples.py FOLDER > gyro_samples.h

Real gyroscopes with their accelerometers, solved from all samples: for test_moves_logs.c and gyro_test.sh, which use
what the library keeps of the same logs. gyro_logs.c names the logs; they are not part of the project. Gauss-Newton
steps over the samples of every move, with turns from sample to sample by Rodrigues' formula.
"""
import math
import sys

from vectors import across, cross, dot, identity, least_squares, times, unit

RATE = 100.0
DEGREE = math.pi / 180


def mean(rows):
    return [sum(column) / len(rows) for column in zip(*rows)]


def turned(c, w):
    """c exp[w x]"""
    square = dot(w, w)
    angle = math.sqrt(square)
    s, k = (math.sin(angle) / angle, (1 - math.cos(angle)) / square) if angle > 1e-9 else (1.0, 0.5)
    across = [cross(row, w) for row in c]
    return [[x + s * y + k * z for x, y, z in zip(row, first, cross(first, w))] for row, first in zip(c, across)]


# ---- logs ----------------------------------------------------------------------------------------

def read(path):
    with open(path, encoding="ascii") as file:
        return [[float(cell) for cell in line.split()] for line in file]


def runs(is_quiet, least):
    """Where at least that many samples are quiet: first and end of each."""
    found, begin = [], None
    for n, quiet in enumerate(is_quiet + [False]):
        if quiet and begin is None:
            begin = n
        if not quiet and begin is not None:
            if n - begin >= least:
                found.append((begin, n))
            begin = None
    return found


def at_rest(force):
    """The middle of every second in which the length of the specific force hardly changes."""
    lengths = [math.sqrt(dot(u, u)) for u in force]
    half = int(RATE / 2)
    quiet = [False] * len(lengths)
    for n in range(half, len(lengths) - half):
        part = lengths[n - half:n + half]
        middle = sum(part) / len(part)
        quiet[n] = sum((x - middle) ** 2 for x in part) / len(part) < 0.002 ** 2
    return quiet


def slow(rate):
    """The authors' method: 0.13 rad/s are not exceeded 0.6 s before and after."""
    fast = [n for n, w in enumerate(rate) if math.sqrt(dot(w, w)) >= 0.13]
    quiet = [True] * len(rate)
    for n in fast:
        for k in range(max(0, n - 60), min(len(rate), n + 61)):
            quiet[k] = False
    return quiet


# ---- the solution --------------------------------------------------------------------------------

class Log:
    """Specific force over the field and rate in rad/s, by the data sheet; the moves are between the rests."""

    def __init__(self, force, rate, rests):
        self.rests = rests
        self.force = [mean(force[begin:end]) for begin, end in rests]
        self.bias = [mean(rate[begin:end]) for begin, end in rests]
        self.moves = [rate[first[1]:then[0]] for first, then in zip(rests, rests[1:])]
        self.slope = [[0.0] * 3] * 3
        self.m = identity(3)
        self.p = [0.0] * 9

    def fit_slope(self):
        """g-sensitivity: the fit of the biases, G up + drift t + b, and the sigma of G."""
        rows = [unit(u) + [begin / self.rests[-1][0], 1.0] for u, (begin, _) in zip(self.force, self.rests)]
        self.slope = [least_squares(rows, [b[i] for b in self.bias], [1.0] * len(rows))[:3] for i in range(3)]

    def up(self, rest, p):
        """Calibrated: (I + S)^-1 (u - delta), by a series."""
        u = [x - d for x, d in zip(self.force[rest], p)]
        s = [[p[3], p[6] / 2, p[7] / 2], [p[6] / 2, p[4], p[8] / 2], [p[7] / 2, p[8] / 2, p[5]]]
        eta = u
        for _ in range(8):
            eta = [x - y for x, y in zip(u, times(s, eta))]
        return eta

    def integrate(self, k):
        """The rotation of move k, and how changes of m rotate it: three rows of nine."""
        ups = [unit(self.up(k, self.p)), unit(self.up(k + 1, self.p))]
        bias = mean(self.bias[k:k + 2])
        middle = mean(ups)
        c = identity(3)
        s = [[0.0] * 9 for _ in range(3)]
        for w in self.moves[k]:
            now = times(zip(*c), ups[0])
            away = times(self.slope, [x - y for x, y in zip(now, middle)])
            u = [(x - b - g) / RATE for x, b, g in zip(w, bias, away)]
            before, c = c, turned(c, times(self.m, u))
            for i in range(3):
                for j in range(3):
                    half = (before[i][j] + c[i][j]) / 2
                    for a in range(3):
                        s[i][3 * j + a] += half * u[a]
        return c, s

    def angles(self, k, c, p):
        """The two angles by which gyroscope and accelerometer disagree after move k."""
        up = unit(self.up(k, p))
        end = times(c, unit(self.up(k + 1, p)))
        off = cross(end, up)
        return times(across(unit(self.up(k, self.p))), off)

    def equations(self):
        """Rows of 18 and right-hand sides, for the lengths and the moves."""
        def changed(i):
            return [x + (1e-6 if i == k else 0) for k, x in enumerate(self.p)]

        lengths, moves = [], []
        for k in range(len(self.rests)):
            length = math.sqrt(dot(self.up(k, self.p), self.up(k, self.p)))
            moved = [math.sqrt(dot(self.up(k, changed(i)), self.up(k, changed(i)))) for i in range(9)]
            lengths.append(([0.0] * 9 + [(x - length) / 1e-6 for x in moved], 1 - length))
        for k in range(len(self.moves)):
            c, s = self.integrate(k)
            angles = self.angles(k, c, self.p)
            moved = [self.angles(k, c, changed(i)) for i in range(9)]
            for n, b in enumerate(across(unit(self.up(k, self.p)))):
                of_p = [(x[n] - angles[n]) / 1e-6 for x in moved]
                of_m = [-dot(b, [s[i][j] for i in range(3)]) for j in range(9)]
                moves.append((of_m + of_p, -angles[n]))
        return lengths, moves

    def solve(self):
        """Returns the root mean square of the moves' angles."""
        for _ in range(8):
            lengths, moves = self.equations()
            squares = [sum(y * y for _, y in part) / len(part) for part in (lengths, moves)]
            rows, right = zip(*(lengths + moves))
            weights = [1 / max(square, 1e-9) for square, part in zip(squares, (lengths, moves)) for _ in part]
            step = least_squares(rows, right, weights)
            for i in range(9):
                self.m[i // 3][i % 3] += step[i]
            self.p = [x + y for x, y in zip(self.p, step[9:])]
        return math.sqrt(squares[1])


def print_solution(name, log, residual):
    for what, values in (("gyro", sum(log.m, [])), ("accelerometer", log.p)):
        print("static const double %s_%s[9] = {\n    %s};" % (name, what, ", ".join("%.5f" % x for x in values)))
    print("static const double %s_residual = %.5f;" % (name, residual))


def xsens(folder):
    """The first 16 rests, which the library keeps, and their g-sensitivity."""
    def rows(name, scale):
        return [[(x - 32768) / scale for x in row[1:]] for row in read("%s/xsens_mti_%s.txt" % (folder, name))]

    force = rows("acc", 414.4 * 9.81744)
    log = Log(force, rows("gyro", 4772), runs(at_rest(force), 50)[:16])
    log.fit_slope()
    print_solution("xsens", log, log.solve())
    print("static const double xsens_slope[9] = { /* degrees/s per g */\n    %s};" %
          ", ".join("%.4f" % (x / DEGREE) for x in sum(log.slope, [])))


def mpu(folder):
    """All rests but the last, which ends the log."""
    rows = read(folder + "/mpu9150_0.txt")
    rate = [row[3:] for row in rows]
    log = Log([[x / 9.81 for x in row[:3]] for row in rows], rate, runs(slow(rate), 32)[:-1])
    print_solution("mpu", log, log.solve())


def main():
    print("/* SPDX-License-Identifier: MIT\n *\n * Made by gyro_samples.py of logs that are not kept here: see there. */")
    print("#ifndef GYRO_SAMPLES_H\n#define GYRO_SAMPLES_H\n")
    print("/* M by rows, and delta, dk and gamma of the accelerometer, over the data sheet's scales; and the root mean square\n"
          " * of the moves' residuals on an axis, rad. */")
    xsens(sys.argv[1])
    mpu(sys.argv[1])
    print("\n#endif")


main()
