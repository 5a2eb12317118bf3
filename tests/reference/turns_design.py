#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python3 turns_design.py > turns_design.h

What programs of turns determine, for test_turns.c, test_gyro.c and plan_moves_test.sh. A turn is integrated in small
steps, its derivatives by the parameters are differences of two integrations, ranks and conditions are from
eigenvalues: none of this is as in the library. Unit: the noise of a position mean; the two angles of a turn have
sqrt(2) times that.
"""
import math

from vectors import across, cross, dot, eliminate, identity, product, scaled, times, unit

HALVINGS = 14  # a turn is integrated in 2^14 equal steps
STEP = 1e-5  # of the differences
RIDGE = 0.01  # information of a prior, ten times the noise: the choice of a turn begins with it
CLEARLY = 1.001  # better than the best so far, so that rounding decides nothing
SMALL = 1e-7  # an eigenvalue below this share of the largest is none
GYRO, ALL = 9, 18  # unknowns: of the gyroscope, of both sensors
TOUR = "+z +x +y +z -x +y -z +x -y -z -x -y +z".split()
FULL = "+x:360 +y:360 +y +z:360".split()


def added(a, b):
    return [[x + y for x, y in zip(p, q)] for p, q in zip(a, b)]


def eigen(a):
    """Jacobi's rotations: the eigenvalues of a symmetric matrix, and its eigenvectors as rows."""
    n = len(a)
    a, v = [list(row) for row in a], identity(n)
    while sum(a[i][k] ** 2 for i in range(n) for k in range(i)) > 1e-24 * sum(a[i][i] ** 2 for i in range(n)):
        for p in range(n):
            for q in range(p + 1, n):
                angle = math.atan2(2 * a[p][q], a[q][q] - a[p][p]) / 2
                c, s = math.cos(angle), math.sin(angle)
                for row in a:
                    row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
                for m in (a, v):
                    m[p], m[q] = ([c * x - s * y for x, y in zip(m[p], m[q])],
                                  [s * x + c * y for x, y in zip(m[p], m[q])])
    return [a[i][i] for i in range(n)], v


# ---- what a turn and a rest tell -----------------------------------------------------------------

def up(word):
    v = [0.0] * 3
    for sign, axis in zip(word[::2], word[1::2]):
        v["xyz".index(axis)] = 1.0 if sign == "+" else -1.0
    return unit(v)


def integrate(rate, m):
    """Rotation of a turn at constant nominal rate (rad in total), gyroscope matrix m: by Cayley's map."""
    half = scaled(0.5 / 2 ** HALVINGS, times(m, rate))
    plus, minus = identity(3), identity(3)
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        plus[k][j] += half[i]
        plus[j][k] -= half[i]
        minus[k][j] -= half[i]
        minus[j][k] += half[i]
    c = product(eliminate(minus)[0], plus)
    for _ in range(HALVINGS):
        c = product(c, c)
    return c


def reading(p, d):
    """Direction and length of the accelerometer's reading at d, with parameters p that are assumed to be 0."""
    s = [[1 + p[3], p[6] / 2, p[7] / 2], [p[6] / 2, 1 + p[4], p[8] / 2], [p[7] / 2, p[8] / 2, 1 + p[5]]]
    u = [x + y for x, y in zip(times(s, d), p)]
    return unit(u), math.sqrt(dot(u, u))


def differences(function, n):
    """The rows of the derivative of a function by n parameters, all 0."""
    columns = []
    for k in range(n):
        x = [0.0] * n
        x[k] = STEP
        plus = function(x)
        x[k] = -STEP
        columns.append([(p - q) / (2 * STEP) for p, q in zip(plus, function(x))])
    return [list(row) for row in zip(*columns)]


def rows_of_rest(at):
    return [[0.0] * GYRO + row for row in differences(lambda p: [reading(p, at)[1]], ALL - GYRO)]


def rows_of_turn(rate, before, after):
    """The two angles across the previous direction, each over sqrt(2)."""
    def angles(c, p):
        off = cross(times(c, reading(p, after)[0]), reading(p, before)[0])
        return scaled(math.sqrt(0.5), times(across(before), off))

    none = [0.0] * 9
    of_gyro = differences(
        lambda x: angles(integrate(rate, added(identity(3), [x[0:3], x[3:6], x[6:9]])), none), GYRO)
    c = integrate(rate, identity(3))
    return [g + a for g, a in zip(of_gyro, differences(lambda p: angles(c, p), ALL - GYRO))]


def arc(before, after):
    """The rotation vector of the shortest turn that brings `after` up."""
    x = cross(after, before)
    sine = math.sqrt(dot(x, x))
    return scaled(math.atan2(sine, dot(before, after)) / sine, x)


# ---- programs ------------------------------------------------------------------------------------

class Program:
    """Turns from a first rest on, and the information that they and the rests give of n unknowns."""

    def __init__(self, n, start):
        self.n, self.up, self.path = n, up(start), [start]
        self.information = identity(n, 0.0)
        self.add(self.rest(self.up))

    def rest(self, at):
        return rows_of_rest(at) if self.n == ALL else []

    def add(self, rows):
        for row in rows:
            self.information = [[a + x * y for a, y in zip(line, row)] for line, x in zip(self.information, row)]

    def step(self, rate):
        """The rows of a turn and of the rest after it, and the direction there."""
        after = times(zip(*integrate(rate, identity(3))), self.up)
        return [row[:self.n] for row in rows_of_turn(rate, self.up, after)] + self.rest(after), after

    def turn(self, rate):
        rows, self.up = self.step(rate)
        self.add(rows)

    def to(self, word):
        self.turn(arc(self.up, up(word)))
        self.up = up(word)
        self.path.append(word)

    def next(self):
        k = eliminate(added(self.information, identity(self.n, RIDGE)))[0]
        best, chosen = 0, None
        for z in "+ -":
            for y in "+ -":
                for x in "+ -":
                    word = "".join(s + a for s, a in ((x, "x"), (y, "y"), (z, "z")) if s != " ")
                    if not word or dot(cross(up(word), self.up), cross(up(word), self.up)) < 0.09:
                        continue
                    h, _ = self.step(arc(self.up, up(word)))
                    of_h = product(product(h, k), list(zip(*h)))
                    merit = eliminate(added(of_h, identity(len(h))))[1]
                    if merit > CLEARLY * best:
                        best, chosen = merit, word
        self.to(chosen)

    def sigma(self):
        inverse = eliminate(self.information)[0]
        return [math.sqrt(inverse[i][i]) for i in range(self.n)]

    def condition(self):
        values, _ = eigen(self.information)
        return max(values) / min(values)

    def root(self):
        """det^(1/n)"""
        return eliminate(self.information)[1] ** (1 / self.n)

    def open(self):
        """The rank, and the parameters that are open, as bits."""
        values, vectors = eigen(self.information)
        null = [v for value, v in zip(values, vectors) if value <= SMALL * max(values)]
        return self.n - len(null), sum(1 << i for i in range(self.n) if sum(v[i] ** 2 for v in null) > 1e-6)


def follow(n, words):
    p = Program(n, words[0])
    for word in words[1:]:
        if ":" in word:
            p.turn(scaled(math.radians(float(word[3:])), up(word[:2])))
        else:
            p.to(word)
    return p


# ---- the header ----------------------------------------------------------------------------------

def print_plan(name, p):
    lines = [", ".join("%.5f" % x for x in p.sigma()[k:k + 9]) for k in (0, 9)]
    print("static const double %s_sigma[18] = {\n    %s};" % (name, ",\n    ".join(lines)))
    print("static const double %s_condition = %.5f;" % (name, p.condition()))


def print_greedy(n):
    p = Program(n, "+z")
    for turns in (12, 24):
        while len(p.path) <= turns:
            p.next()
        print("static const double greedy%d_of_%d_root = %.5f;" % (turns, n, p.root()))
        if n == ALL:
            print_plan("greedy%d" % turns, p)
    print("static const char greedy_of_%d[] =\n    \"%s \"\n    \"%s\";\n" %
          (n, " ".join(p.path[:13]), " ".join(p.path[13:])))


def print_open(name, words):
    rank, parameters = follow(ALL, words).open()
    print("static const unsigned %s_rank = %d;" % (name, rank))
    print("static const uint32_t %s_open = UINT32_C(0x%05X);" % (name, parameters))


def main():
    print("/* SPDX-License-Identifier: MIT\n *\n * Made by turns_design.py, which says what it is. */")
    print("#ifndef TURNS_DESIGN_H\n#define TURNS_DESIGN_H\n\n#include <stdint.h>\n")
    print("/* Sigma over the noise of a position mean, both sensors unknown; and the condition. */")
    print_plan("tour12", follow(ALL, TOUR))
    print_plan("tour9", follow(ALL, TOUR[:10]))
    print_plan("tour16", follow(ALL, TOUR + FULL))
    print_plan("tour24", follow(ALL, TOUR + TOUR[-2::-1]))
    print("\n/* The turns that add most, of 9 and of 18 unknowns, and det^(1/n) after 12 and 24. */")
    print_greedy(GYRO)
    print_greedy(ALL)
    print("/* Turns about one axis, and about two. */")
    print_open("one_axis", ["+z"] + 8 * ["+x:90"])
    print_open("two_axes", ["+z"] + 4 * ["+x:90"] + 4 * ["+y:90"])
    print("\n#endif")


main()
