/* SPDX-License-Identifier: MIT */
#include "maths/rotation.h"

#include <math.h>

void rotation_vector(const double (*r)[3], double angle[3])
{
    const double trace = r[0][0] + r[1][1] + r[2][2];
    double q[4] = {1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};

    for (unsigned i = 0; i < 3; i++) {
        const double square = 1 + 2 * r[i][i] - trace;
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        if (square > q[0] && square > 1) {
            q[0] = r[k][j] - r[j][k];
            q[1 + i] = square;
            q[1 + j] = r[j][i] + r[i][j];
            q[1 + k] = r[k][i] + r[i][k];
            break;
        }
    }
    const double sign = q[0] < 0 ? -1 : 1;
    const double sine = sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double scale = sine > 0 ? 2 * atan2(sine, sign * q[0]) / sine : 0;
    for (unsigned i = 0; i < 3; i++) {
        angle[i] = sign * scale * q[1 + i];
    }
}

void rotation_about(const double axis[3], double angle, double r[3][3])
{
    const double c = cos(angle);
    const double s = sin(angle);

    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        r[i][i] = c + (1 - c) * axis[i] * axis[i];
        r[i][j] = (1 - c) * axis[i] * axis[j] - s * axis[k];
        r[i][k] = (1 - c) * axis[i] * axis[k] + s * axis[j];
    }
}
