# SPDX-License-Identifier: MIT
"""Vectors and small matrices, as lists, for the scripts of this folder."""
import math


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def scaled(factor, v):
    return [factor * x for x in v]


def unit(v):
    return scaled(1 / math.sqrt(dot(v, v)), v)


def across(v):
    """Two unit vectors across a unit vector and each other."""
    least = min(range(3), key=lambda i: abs(v[i]))
    first = unit(cross(v, identity(3)[least]))
    return [first, cross(v, first)]


def identity(n, factor=1.0):
    return [[factor if i == k else 0.0 for k in range(n)] for i in range(n)]


def times(a, v):
    return [dot(row, v) for row in a]


def product(a, b):
    columns = list(zip(*b))
    return [[dot(row, column) for column in columns] for row in a]


def eliminate(a):
    """Gauss-Jordan elimination with pivots: the inverse, and the determinant."""
    n = len(a)
    rows = [list(row) + unit_row for row, unit_row in zip(a, identity(n))]
    determinant = 1.0
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        determinant *= rows[pivot][i] * (1 if pivot == i else -1)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = scaled(1 / rows[i][i], rows[i])
        for r in range(n):
            if r != i:
                factor = rows[r][i]
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[i])]
    return [row[n:] for row in rows], determinant


def solve(matrix, right):
    return times(eliminate(matrix)[0], right)


def least_squares(rows, right, weights):
    n = len(rows[0])
    a, b = identity(n, 0.0), [0.0] * n
    for row, y, weight in zip(rows, right, weights):
        for i in range(n):
            b[i] += weight * row[i] * y
            for k in range(n):
                a[i][k] += weight * row[i] * row[k]
    return solve(a, b)
