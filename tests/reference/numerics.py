# SPDX-License-Identifier: MIT
"""numerics.py FOLDER COUNT

Rounding errors: the library solves COUNT random sets of positions (tests/numerics/problems.c, in FOLDER
with both builds of solve.c) in float and in double; this script solves them with 50 digits, from exactly
the same readings. Every loss must be within the bound that the header states, no bound may be ten times
too wide, and nothing may be refused needlessly.

It shares no code with the library: rows, sums and the closed form are written out from mathematics.md;
the root of a matrix is by Denman and Beavers, sigma from the covariance of the calibrated unit vectors
and Sylvester's equation, the condition by squaring. The arithmetic is MPFR's (gmpy2); every MPMATH-th
problem is also solved with mpmath, thirty times as slow, for comparison.
"""
import math
import operator
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor

import gmpy2
import mpmath

DIGITS = 50
CHUNK = 100  # problems made and solved at a time
HARDEST = (290, 106, 111, 256, 70)  # of 300 chunks those nearest to the bounds: always included
MPMATH = 100  # one problem in this many is also solved with mpmath,
CONDITION = 20  # and in this many its bound is compared with the condition
AGAIN = 5  # one in this many is solved again with its calibration as nominal
ABOVE, BELOW = 1.73, -2.8  # 95 % are below the one, 99.9 % above the other
HOPELESS = 1e6  # the sum of the nine (sigma / noise)^2: above this it is refused
HIGHEST = 1e6  # the bounds are stated up to here
WIDEST = 10  # a bound wider than this times the largest loss is useless

gmpy2.get_context().precision = math.ceil(DIGITS * math.log2(10))
mpmath.mp.dps = DIGITS


class Arithmetic:
    def __init__(self, real, sqrt):
        self.real = real
        self.sqrt = sqrt


MPFR = Arithmetic(gmpy2.mpfr, gmpy2.sqrt)
MP = Arithmetic(mpmath.mpf, mpmath.sqrt)


class Refused(Exception):
    pass


# ---- linear algebra ---------------------------------------------------------------------------


def dot(a, b):
    return sum(map(operator.mul, a, b))


def transpose(a):
    return list(zip(*a))


def apply(a, x):
    return [dot(row, x) for row in a]


def times(a, b):
    columns = transpose(b)
    return [[dot(row, column) for column in columns] for row in a]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def largest(a):
    return max(abs(x) for row in a for x in row)


def solve(a, right):
    """The columns of a^-1 right: Gauss-Jordan elimination with the largest pivot."""
    n = len(a)
    rows = [list(a[i]) + list(right[i]) for i in range(n)]
    for c in range(n):
        best = max(range(c, n), key=lambda r: abs(rows[r][c]))
        rows[c], rows[best] = rows[best], rows[c]
        if rows[c][c] == 0:
            raise Refused("singular")
        pivot = rows[c] = rows[c][:c] + [x / rows[c][c] for x in rows[c][c:]]
        for r in range(n):
            factor = rows[r][c]
            if r != c and factor != 0:
                rows[r][c:] = [x - factor * y for x, y in zip(rows[r][c:], pivot[c:])]
    return [row[n:] for row in rows]


def identity(n):
    return [[int(i == j) for j in range(n)] for i in range(n)]


def inverse(a):
    return solve(a, identity(len(a)))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def inverse_of_three(a):
    """By cross products of the rows."""
    columns = [cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])]
    det = dot(a[0], columns[0])
    if det == 0:
        raise Refused("singular")
    return [[column[i] / det for column in columns] for i in range(3)]


def mean(a, b):
    return [[(x + y) / 2 for x, y in zip(r, s)] for r, s in zip(a, b)]


def square_root(a):
    """Denman and Beavers: y to the root of a, z to its inverse."""
    y, z = a, identity(3)
    for _ in range(60):
        following = mean(y, inverse_of_three(z))
        z = mean(z, inverse_of_three(y))
        if largest(map(minus, following, y)) < 1e-45:
            return following
        y = following
    raise Refused("no root")


def is_positive_definite(a):
    return a[0][0] > 0 and a[0][0] * a[1][1] > a[0][1] ** 2 and dot(a[0], cross(a[1], a[2])) > 0


def upper_factor(q, sqrt):
    """The upper triangular u with u'u = q."""
    u = [[0] * 3 for _ in range(3)]
    for i in range(3):
        for j in range(i, 3):
            rest = q[i][j] - sum(u[k][i] * u[k][j] for k in range(i))
            u[i][j] = sqrt(rest) if i == j else rest / u[i][i]
    return u


def square(a):
    """Of a symmetric matrix."""
    half = [[dot(a[r], a[c]) for c in range(r + 1)] for r in range(len(a))]
    return [[half[max(r, c)][min(r, c)] for c in range(len(a))] for r in range(len(a))]


def largest_eigenvalue(a, squarings):
    """a^(2^k) is lambda^(2^k) v v' once the rest has vanished."""
    power = a
    for _ in range(squarings):
        scale = sum(power[i][i] for i in range(len(a)))
        power = square([[x / scale for x in row] for row in power])
    v = max(power, key=lambda row: dot(row, row))
    return dot(v, apply(a, v)) / dot(v, v)


def trace(a):
    return sum(a[i][i] for i in range(len(a)))


def condition_of(a, inverse_of_a, squarings):
    return float(largest_eigenvalue(a, squarings) * largest_eigenvalue(inverse_of_a, squarings))


# ---- the exact solution (mathematics.md) -------------------------------------------------------


def row_of(a):
    x, y, z = a
    return [x, y, z, x * x, y * y, z * z, x * y, x * z, y * z]


def excess(a):
    return (dot(a, a) - 1) / 2


def sums(rows, right, weights):
    """H'WH and H'Wj."""
    columns = transpose(rows)
    hth = [[0] * 9 for _ in range(9)]
    htj = []
    for r in range(9):
        weighted = list(map(operator.mul, columns[r], weights))
        for c in range(r + 1):
            hth[r][c] = hth[c][r] = dot(weighted, columns[c])
        htj.append(dot(weighted, right))
    return hth, htj


class Problem:
    """One line of problems.c."""

    def __init__(self, line, arithmetic):
        words = line.split()
        value = [arithmetic.real(float.fromhex(word)) for word in words[2:]]
        self.count = int(words[0])
        self.is_triangular = words[1] == "1"
        self.noise = value[0]
        self.zero = value[1:4]
        self.nominal = [value[4:7], value[7:10], value[10:13]]
        self.raw = [value[13 + 3 * i : 16 + 3 * i] for i in range(self.count)]


class Exact:
    def __init__(self, problem, arithmetic):
        self.sqrt = arithmetic.sqrt
        self.problem = problem
        self.u = [apply(problem.nominal, minus(raw, problem.zero)) for raw in problem.raw]
        rows = [row_of(u) for u in self.u]
        hth, htj = sums(rows, [excess(u) for u in self.u], [1] * problem.count)
        self.in_nominal_units = hth
        self.close([-p for (p,) in solve(hth, [[x] for x in htj])])

    def close(self, p):
        q = [[1 + 2 * p[3], p[6], p[7]], [p[6], 1 + 2 * p[4], p[8]], [p[7], p[8], 1 + 2 * p[5]]]
        self.delta = [-x for x in apply(inverse_of_three(q), p[:3])]
        k = 1 + dot(self.delta, apply(q, self.delta))
        q = [[x / k for x in line] for line in q]
        if not is_positive_definite(q):
            raise Refused("not on an ellipsoid")
        self.a = square_root(q)
        self.s = s = inverse_of_three(self.a)  # I + S
        self.parameters = self.delta + [s[0][0] - 1, s[1][1] - 1, s[2][2] - 1,
                                        2 * s[0][1], 2 * s[0][2], 2 * s[1][2]]
        self.correction = upper_factor(q, self.sqrt) if self.problem.is_triangular else self.a

    def assess(self):
        """noise, sigma and condition as invcal.h and expert.h define them."""
        eta = [apply(self.a, minus(u, self.delta)) for u in self.u]
        self.lengths = [self.sqrt(dot(e, e)) for e in eta]
        gradients = [apply(self.a, e) for e in eta]
        weights = [1 / dot(g, g) for g in gradients]
        right = [excess(e) for e in eta]
        of_vectors, _ = sums([row_of(e) for e in eta], right, weights)
        self.k = inverse(of_vectors)
        dof = self.problem.count - 9
        squares = dot(weights, map(operator.mul, right, right))
        self.noise = self.noise_of(squares, dof)
        self.sigma = self.spread_offset() + self.spread_matrix()
        self.sigma_offset = [self.sqrt(sum((n * s) ** 2 for n, s in zip(line, self.sigma)))
                             for line in inverse_of_three(self.problem.nominal)]
        slopes = [[*g, g[0] * e[0], g[1] * e[1], g[2] * e[2], (g[0] * e[1] + g[1] * e[0]) / 2,
                   (g[0] * e[2] + g[2] * e[0]) / 2, (g[1] * e[2] + g[2] * e[1]) / 2]
                  for g, e in zip(gradients, eta)]
        self.information, _ = sums(slopes, right, weights)
        self.covariance = inverse(self.information)
        self.bound = trace(self.information) * trace(self.covariance)

    def noise_of(self, squares, dof):
        """The stated noise counts as four residuals, unless the real ones show clearly more, or almost
        none of it: the root of 2 chi squared is about that of 2 dof - 1 (Fisher)."""
        known = self.problem.noise ** 2
        above = 0
        if known > 0 and dof > 0:
            above = self.sqrt(2 * squares / known) - math.sqrt(2 * dof - 1)
        weight = 4 if known > 0 and BELOW <= above <= ABOVE else 0
        return self.sqrt((weight * known + squares) / (weight + dof)) if weight + dof > 0 else 1

    def condition(self):
        """8 squarings give it to a percent."""
        return condition_of(self.information, self.covariance, 8)

    def highest(self):
        """The bound of the condition, and that of the sums before the calibration; the larger of
        the traces of both K."""
        before = self.in_nominal_units
        k_before = trace(inverse(before))
        bound = max(self.bound, trace(before) * k_before)
        return float(bound), float(max(trace(self.covariance), k_before))

    def variance(self, x, first):
        n = len(x)
        block = [line[first : first + n] for line in self.k[first : first + n]]
        return self.noise * self.sqrt(dot(x, apply(block, x)))

    def spread_offset(self):
        """d delta = P d delta'."""
        return [self.variance(line, 0) for line in self.s]

    def spread_matrix(self):
        """dP by dP P + P dP = 2 P dS P, for each of the six dS."""
        places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
        index = {pair: i for i, pair in enumerate(places)}
        index.update({(b, a): i for (a, b), i in list(index.items())})
        left = [[0] * 6 for _ in range(6)]
        right = [[0] * 6 for _ in range(6)]
        p = self.s
        for row, (i, j) in enumerate(places):
            for m in range(3):
                left[row][index[i, m]] += p[m][j]
                left[row][index[m, j]] += p[i][m]
            for column, (a, b) in enumerate(places):
                # an angle is the sum of both elements off the diagonal
                right[row][column] = 2 * p[i][a] * p[b][j] if a == b else (
                    p[i][a] * p[b][j] + p[i][b] * p[a][j])
        slopes = solve(left, right)
        return [(1 if row < 3 else 2) * self.variance(slopes[row], 3) for row in range(6)]


# ---- the library's answers --------------------------------------------------------------------

OK = 0
GOOD = 0


class Answer:
    """One line of solve.c."""

    def __init__(self, line, real):
        words = line.split()
        value = [real(float.fromhex(word)) for word in words[2:]]
        self.status, self.verdict = int(words[0]), int(words[1])
        self.parameters, self.offset = value[:9], value[9:12]
        self.matrix = [value[12:15], value[15:18], value[18:21]]
        self.sigma, self.sigma_offset = value[21:30], value[30:33]
        self.noise, self.rms, self.worst, self.condition = value[33:37]


def loss_of_parameters(exact, answer):
    """Of the nine, and of the matrix against nominal."""
    matrix = times(answer.matrix, inverse_of_three(exact.problem.nominal))
    return max(largest([minus(answer.parameters, exact.parameters)]),
               largest(map(minus, matrix, exact.correction)))


def loss_of_lengths(exact, answer):
    """Of |calibrated| at the positions, by the delivered offset and matrix."""
    worst = 0
    for raw, length in zip(exact.problem.raw, exact.lengths):
        a = apply(answer.matrix, minus(raw, answer.offset))
        worst = max(worst, abs(exact.sqrt(dot(a, a)) - length))
    return worst


def loss_of_sigma(exact, answer):
    """Relative, of each sigma; without that of the noise, which depends on the loss of residuals."""
    pairs = zip(answer.sigma + answer.sigma_offset, exact.sigma + exact.sigma_offset)
    return max(abs(got / answer.noise * exact.noise / want - 1) for got, want in pairs)


# ---- results ----------------------------------------------------------------------------------

BUILDS = ("float", "double")
LAWS = ("parameters", "lengths", "sigma", "again")
BY_ROOT = ("lengths", "noise", "again")  # in proportion to the root of the condition


class Header:
    """The first line of solve.c: what the headers promise for a build."""

    def __init__(self, line):
        value = [float.fromhex(word) for word in line.split()]
        self.bound = dict(zip(LAWS, value))
        self.bound["noise"] = self.bound["lengths"]  # of residuals, which are lengths
        self.bound["condition"] = self.bound["sigma"]  # of the same sums
        self.epsilon, self.floor, self.undetermined = value[len(LAWS) :]

    def share(self, law, loss, condition):
        """The loss over its bound."""
        scale = math.sqrt(condition) if law in BY_ROOT else condition
        return float(loss) / (self.bound[law] * self.epsilon * scale)


def losses(exact, answer):
    yield "parameters", loss_of_parameters(exact, answer)
    yield "lengths", loss_of_lengths(exact, answer)
    yield "sigma", loss_of_sigma(exact, answer)
    if exact.noise < 1 and answer.noise < 1:  # 1: unknown
        yield "noise", abs(answer.noise - exact.noise)
    yield "condition", abs(answer.condition / exact.bound - 1)


def exact_of(line, arithmetic):
    exact = Exact(Problem(line, arithmetic), arithmetic)
    exact.assess()
    return exact


def disagreement(exact, line):
    """MPFR against mpmath, relative."""
    other = exact_of(line, MP)
    pairs = zip(exact.parameters + exact.sigma, other.parameters + other.sigma)
    return float(max(abs(mpmath.mpf(str(x)) / y - 1) for x, y in pairs))


def renewed(line, answer):
    """The same readings with the calibration found as nominal."""
    words = line.split()
    found = answer.split()[2:]
    return " ".join(words[:3] + found[9:21] + words[15:])


class Tally:
    """What a set of problems showed; tallies can be added."""

    def __init__(self):
        self.problems = 0
        self.largest = {}  # (build, law, decade of the condition): the largest share of the bound
        self.delivered = {}  # (build, decade)
        self.refused = {}
        self.ratio = {}  # decade: the smallest and largest bound over the condition
        self.good = 0  # the largest loss of a parameter in float, verdict good
        self.mpmath = 0
        self.faults = []

    def add(self, other):
        self.problems += other.problems
        self.good = max(self.good, other.good)
        self.mpmath = max(self.mpmath, other.mpmath)
        self.faults += other.faults
        for decade, (low, high) in other.ratio.items():
            mine = self.ratio.get(decade, (low, high))
            self.ratio[decade] = min(low, mine[0]), max(high, mine[1])
        for key, share in other.largest.items():
            self.largest[key] = max(self.largest.get(key, 0), share)
        for mine, theirs in (self.delivered, other.delivered), (self.refused, other.refused):
            for key, count in theirs.items():
                mine[key] = mine.get(key, 0) + count

    def count(self, of, build, condition):
        key = build, int(math.log10(condition))
        of[key] = of.get(key, 0) + 1

    def fault(self, number, build, what):
        self.faults.append(f"problem {number}, {build}: {what}")

    def refusal(self, number, build, header, answer, exact):
        """Only if the condition is too high."""
        self.count(self.refused, build, exact.bound)
        if answer.status != header.undetermined:
            self.fault(number, build, f"status {answer.status}")
        bound, k = exact.highest()
        if bound * header.floor < 1 and k < 0.8 * HOPELESS:
            self.fault(number, build, f"refused, condition {bound:.3g}")

    def delivery(self, number, build, header, answer, exact):
        stated = float(answer.condition)
        self.count(self.delivered, build, stated)
        if stated * header.floor >= 2 or exact.bound * header.floor > 8:
            self.fault(number, build, f"delivered, condition {stated:.3g}")
        for law, loss in losses(exact, answer):
            share = header.share(law, loss, stated)
            if stated > HIGHEST and law in ("sigma", "condition"):
                continue
            self.judge(number, build, law, share, stated)
            if law == "parameters" and build == "float" and answer.verdict == GOOD:
                self.good = max(self.good, float(loss))

    def look(self, exact):
        """The bound, relative to the condition."""
        ratio = float(exact.bound / exact.condition())
        decade = int(math.log10(exact.bound))
        low, high = self.ratio.get(decade, (ratio, ratio))
        self.ratio[decade] = min(low, ratio), max(high, ratio)

    def judge(self, number, build, law, share, stated):
        key = build, law, int(math.log10(stated))
        self.largest[key] = max(self.largest.get(key, 0), share)
        if not share <= 1:
            self.fault(number, build, f"{law}: {share:.3g} of the bound, condition {stated:.3g}")

    def again(self, number, line, build, header, answer):
        stated = float(answer.condition)
        if answer.status == OK and stated <= HIGHEST:
            exact = Exact(Problem(line, MPFR), MPFR)
            share = header.share("again", loss_of_parameters(exact, answer), stated)
            self.judge(number, build, "again", share, stated)

    def take(self, number, line, headers, answers):
        self.problems += 1
        exact = exact_of(line, MPFR)
        if number % MPMATH == 0:
            self.mpmath = max(self.mpmath, disagreement(exact, line))
        if number % CONDITION == 0:
            self.look(exact)
        for build, header, answer in zip(BUILDS, headers, answers):
            if answer.status == OK:
                self.delivery(number, build, header, answer, exact)
            else:
                self.refusal(number, build, header, answer, exact)


def run(command, text=""):
    return subprocess.run(command, input=text, capture_output=True, text=True,
                          check=True).stdout.splitlines()


def solve_all(folder, build, lines):
    """What the headers promise, and the answers."""
    first, *answers = run([folder + "/solve-" + build], "\n".join(lines) + "\n")
    return Header(first), answers


def chunk(folder, seed):
    lines = run([folder + "/problems", str(seed), str(CHUNK)])
    solved = [solve_all(folder, build, lines) for build in BUILDS]
    headers = [header for header, _ in solved]
    tally = Tally()
    for i, line in enumerate(lines):
        answers = [Answer(words[i], MPFR.real) for _, words in solved]
        tally.take(seed * CHUNK + i, line, headers, answers)
    for build, (header, words) in zip(BUILDS, solved):
        some = [i for i in range(0, CHUNK, AGAIN) if words[i].startswith("0 ")]
        second = [renewed(lines[i], words[i]) for i in some]
        for i, line, answer in zip(some, second, solve_all(folder, build, second)[1]):
            tally.again(seed * CHUNK + i, line, build, header, Answer(answer, MPFR.real))
    return headers, tally


# ---- what is asserted -------------------------------------------------------------------------


def table(tally):
    print("condition  " + "".join(f"| {build:>6}: number refused " + " ".join(
        f"{law:>10}" for law in LAWS) for build in BUILDS))
    for decade in range(9):
        cells = []
        for build in BUILDS:
            shares = [tally.largest.get((build, law, decade)) for law in LAWS]
            cells.append(f"| {tally.delivered.get((build, decade), 0):14} "
                         f"{tally.refused.get((build, decade), 0):7} "
                         + " ".join(" " * 10 if s is None else f"{s:10.2f}" for s in shares))
        print(f"10^{decade}...    " + "".join(cells))


def checks(tally, headers, count):
    yield f"{tally.problems} problems", tally.problems >= count
    yield f"MPFR and mpmath agree within {tally.mpmath:.0e}", 0 < tally.mpmath < 1e-35
    yield "every loss within its bound, refused where it must be and only there", not tally.faults
    for build, header in zip(BUILDS, headers):
        for law, value in header.bound.items():
            share = max(s for (b, l, _), s in tally.largest.items() if (b, l) == (build, law))
            yield f"{build}, {law}: at most {share * value:.2f}, bound {value:g}", share <= 1
        refused = sum(n for (b, _), n in tally.refused.items() if b == build)
        yield f"{build}: {refused} refused", refused > 0
    for law in LAWS:
        share = max(s for (_, l, _), s in tally.largest.items() if l == law)
        yield f"{law}: the bound is {1 / share:.1f} times the largest loss", share * WIDEST > 1
    for decade, (low, high) in sorted(tally.ratio.items()):
        print(f"quality.condition 10^{decade}...: {low:.1f} to {high:.1f} times the condition")
    print(f"float, verdict good: a parameter loses at most {tally.good:.1e}")


def main():
    folder, count = sys.argv[1], int(sys.argv[2])
    total = Tally()
    with ProcessPoolExecutor(2) as pool:
        others = [seed for seed in range(math.ceil(count / CHUNK)) if seed not in HARDEST]
        seeds = (list(HARDEST) + others)[: math.ceil(count / CHUNK)]
        for headers, tally in pool.map(chunk, [folder] * len(seeds), seeds):
            total.add(tally)
    table(total)
    print("\n".join(total.faults[:20]))
    results = list(checks(total, headers, count))
    for what, holds in results:
        print(f"{what}: {'PASS' if holds else 'FAIL'}")
    failed = sum(not holds for _, holds in results)
    print(f"{len(results) - failed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
