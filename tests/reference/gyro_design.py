# SPDX-License-Identifier: MIT
"""sqrt(K) of the octahedron tour, gyroscope and accelerometer in one solution, for tests/unit/test_gyro.c.

Needs numpy. Prints the 18 roots over the noise of a position mean; a move's two angles have sqrt(2) of it. The
rotation of a move is integrated in small steps, its sensitivity by differences: nothing of this is the library's.
"""
import numpy as np

TOUR = "zxyZXyzXYZxYz"
STEPS = 400


def up(letter):
    v = np.zeros(3)
    v["xyz".index(letter.lower())] = 1 if letter.islower() else -1
    return v


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def turn(rate, m):
    """Rotation of a move at constant nominal rate (rad altogether), gyroscope matrix m."""
    w = hat(m @ rate) / STEPS
    step = np.linalg.solve(np.eye(3) - w / 2, np.eye(3) + w / 2)  # Cayley: fine steps
    return np.linalg.matrix_power(step, STEPS)


def reading(p, d):
    """Direction and length that the accelerometer reads at d, with parameters p taken for none."""
    s = np.array([[p[3], p[6] / 2, p[7] / 2], [p[6] / 2, p[4], p[8] / 2], [p[7] / 2, p[8] / 2, p[5]]])
    u = (np.eye(3) + s) @ d + p[:3]
    return u / np.linalg.norm(u), np.linalg.norm(u)


def residuals(x):
    m = np.eye(3) + x[:9].reshape(3, 3)
    out = []
    for c in TOUR:
        out.append(reading(x[9:], up(c))[1])
    for a, b in zip(TOUR, TOUR[1:]):
        # u_meas = M^-1 omega is fixed, so a changed m turns the move
        rate = np.cross(up(b), up(a)) * np.pi / 2
        c = turn(rate, m)
        off = np.cross(c @ reading(x[9:], up(b))[0], reading(x[9:], up(a))[0])
        across = np.array([np.cross(up(a), up(b)), up(b)])
        out.extend(across @ off / np.sqrt(2))
    return np.array(out)


def main():
    h = 1e-5
    j = np.array([(residuals(h * e) - residuals(-h * e)) / (2 * h) for e in np.eye(18)]).T
    root = np.sqrt(np.diag(np.linalg.inv(j.T @ j)))
    print(" ".join("%.4f" % r for r in root))


main()
