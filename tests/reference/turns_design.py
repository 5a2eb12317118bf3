# SPDX-License-Identifier: MIT
"""What programs of turns determine, for tests/unit/test_turns.c and tests/tool/plan_moves_test.sh.

Needs numpy. A turn is integrated in small steps, what it says of the parameters is a difference of two
integrations, ranks and conditions are those of numpy: nothing of this is the library's. Unit: the noise of a
position mean; a turn's two angles have sqrt(2) of it. Prints the figures that the tests state.
"""
import numpy as np

STEPS = 20000
RIDGE = 0.01
CLEARLY = 1.001
NAMES = ["gyro_" + a + b for a in "xyz" for b in "xyz"] + [
    "delta_x", "delta_y", "delta_z", "dk_x", "dk_y", "dk_z", "gamma_xy", "gamma_xz", "gamma_zy"]
TOUR = "+z +x +y +z -x +y -z +x -y -z -x -y +z".split()


def up(word):
    v = np.zeros(3)
    for sign, axis in zip(word[::2], word[1::2]):
        v["xyz".index(axis)] = 1 if sign == "+" else -1
    return v / np.linalg.norm(v)


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def integrate(rate, m):
    """Rotation of a turn at constant nominal rate (rad altogether), gyroscope matrix m: Cayley, fine steps."""
    w = hat(m @ rate) / STEPS
    return np.linalg.matrix_power(np.linalg.solve(np.eye(3) - w / 2, np.eye(3) + w / 2), STEPS)


def reading(p, d):
    s = np.array([[p[3], p[6] / 2, p[7] / 2], [p[6] / 2, p[4], p[8] / 2], [p[7] / 2, p[8] / 2, p[5]]])
    u = (np.eye(3) + s) @ d + p[:3]
    return u / np.linalg.norm(u), np.linalg.norm(u)


def rows_of_rest(u):
    h = 1e-5
    return np.array([[(reading(h * e[9:], u)[1] - reading(-h * e[9:], u)[1]) / (2 * h) for e in np.eye(18)]])


def rows_of_turn(rate, before, after):
    """The two angles, each over sqrt(2)."""
    across = np.linalg.svd(before[None, :])[2][1:]

    def angles(x):
        c = integrate(rate, np.eye(3) + x[:9].reshape(3, 3))
        return across @ np.cross(c @ reading(x[9:], after)[0], reading(x[9:], before)[0]) / np.sqrt(2)

    h = 1e-5
    return np.array([(angles(h * e) - angles(-h * e)) / (2 * h) for e in np.eye(18)]).T


def arc(before, after):
    x = np.cross(after, before)
    s = np.linalg.norm(x)
    return x / s * np.arctan2(s, before @ after)


class Program:
    def __init__(self, n, start):
        self.n, self.up, self.turns, self.path = n, up(start), 0, [start]
        self.a = np.zeros((n, n))
        self.rest()

    def rest(self):
        if self.n == 18:
            h = rows_of_rest(self.up)
            self.a += h.T @ h

    def told(self, rate):
        after = np.linalg.inv(integrate(rate, np.eye(3))) @ self.up
        h = rows_of_turn(rate, self.up, after)
        h = np.vstack([h, rows_of_rest(after)]) if self.n == 18 else h[:, :9]
        return h, after

    def turn(self, rate):
        h, self.up = self.told(rate)
        self.a += h.T @ h
        self.turns += 1

    def to(self, word):
        self.turn(arc(self.up, up(word)))
        self.up = up(word)
        self.path.append(word)

    def next(self):
        k = np.linalg.inv(self.a + RIDGE * np.eye(self.n))
        best, chosen = 0, None
        for z in "+ -":
            for y in "+ -":
                for x in "+ -":
                    word = "".join(s + a for s, a in ((x, "x"), (y, "y"), (z, "z")) if s != " ")
                    if not word or np.linalg.norm(np.cross(up(word), self.up)) < 0.3:
                        continue
                    h, _ = self.told(arc(self.up, up(word)))
                    merit = np.linalg.det(np.eye(len(h)) + h @ k @ h.T)
                    if merit > CLEARLY * best:
                        best, chosen = merit, word
        self.to(chosen)

    def rank(self):
        w = np.linalg.eigvalsh(self.a)
        return int((w > 1e-7 * w[-1]).sum())

    def print(self, name):
        w = np.linalg.eigvalsh(self.a)
        print("%s: %d unknowns, %d turns, rank %d" % (name, self.n, self.turns, self.rank()), end="")
        if self.rank() < self.n:
            null = np.linalg.eigh(self.a)[1][:, :self.n - self.rank()]
            share = (null ** 2).sum(1)
            print("; open: " + " ".join(NAMES[i] for i in range(self.n) if share[i] > 1e-6))
            print("   ", share.round(3))
            return
        root = np.sqrt(np.diag(np.linalg.inv(self.a)))
        det = np.exp(np.linalg.slogdet(self.a)[1] / self.n)
        print("; condition %.6f, det^(1/n) per turn %.4f" % (w[-1] / w[0], det / self.turns))
        print("   ", " ".join("%.5f" % r for r in root))


def follow(n, words):
    p = Program(n, words[0])
    for word in words[1:]:
        if ":" in word:
            p.turn((up(word[:2])) * np.radians(float(word[3:])))
        else:
            p.to(word)
    return p


def greedy(n, turns):
    p = Program(n, "+z")
    for _ in range(turns):
        p.next()
    return p


FULL = "+x:360 +y:360 +y +z:360".split()

if __name__ == "__main__":
    for n in (9, 18):
        follow(n, TOUR).print("tour12")
        follow(n, TOUR[:10]).print("its first 9")
        follow(n, TOUR + TOUR[-2::-1]).print("tour24")
        follow(n, TOUR + FULL).print("tour16")
        for turns in (12, 24):
            p = greedy(n, turns)
            p.print("greedy%d" % turns)
            print("   ", " ".join(p.path))
        follow(n, ["+z"] + 8 * ["+x:90"]).print("about x")
        follow(n, ["+z"] + 4 * ["+x:90"] + 4 * ["+y:90"]).print("about x and y")
        follow(n, ["+z", "+x", "+y", "+z"]).print("three turns")
