/* SPDX-License-Identifier: MIT */
#include "support.h"
#include "core/system.h"

#include <float.h>
#include <math.h>

#include "invcal/positions.h"
#include "core/system.h"
#include "unity.h"

static const double TURN = 6.283185307179586;

random_source random_start(uint32_t seed)
{
    return (random_source){0x9E3779B97F4A7C15u ^ ((uint64_t)seed * 0xD1342543DE82EF95u)};
}

static uint64_t random_bits(random_source *source)
{
    source->state ^= source->state >> 12;
    source->state ^= source->state << 25;
    source->state ^= source->state >> 27;
    return source->state * 0x2545F4914F6CDD1Du;
}

double random_uniform(random_source *source, double low, double high)
{
    const uint32_t bits = (uint32_t)(random_bits(source) >> 32);
    return low + (high - low) * (((double)bits + 0.5) / 4294967296.0);
}

/* The sum of the eight bytes of one draw: mean 1020, variance 8 (256^2 - 1) / 12 = 209^2. */
static double nearly_normal(random_source *source)
{
    uint64_t bits = random_bits(source);
    unsigned sum = 0;

    for (; bits > 0; bits >>= 8) {
        sum += (unsigned)(bits & 0xFF);
    }
    return ((double)sum - 1020) / 209;
}

/* Box and Muller; but where double is float, even a logarithm takes thousands of steps. */
double random_normal(random_source *source)
{
    if (DBL_MANT_DIG < 53) {
        return nearly_normal(source);
    }
    const double radius = sqrt(-2 * log(random_uniform(source, 0, 1)));
    return radius * cos(TURN * random_uniform(source, 0, 1));
}

void skip_long(void)
{
    TEST_IGNORE_MESSAGE("very many steps: run on the host and on a Cortex-M7");
}

void skip_slow(void)
{
    TEST_IGNORE_MESSAGE("many steps: run on 32-bit machines");
}

void skip_large(void)
{
    TEST_IGNORE_MESSAGE("needs more memory than there is here");
}

void needs_53_bits(void)
{
    if (DBL_MANT_DIG < 53) {
        TEST_IGNORE_MESSAGE("computes what it expects in double, which is float here");
    }
}

double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double invert(double *a, int n)
{
    double log_det = 0;

    for (int k = 0; k < n; k++) {
        const double pivot = 1 / a[k * n + k];
        log_det -= log(pivot);
        a[k * n + k] = 1;
        for (int c = 0; c < n; c++) {
            a[k * n + c] *= pivot;
        }
        for (int r = 0; r < n; r++) {
            if (r != k) {
                const double factor = a[r * n + k];
                a[r * n + k] = 0;
                for (int c = 0; c < n; c++) {
                    a[r * n + c] -= factor * a[k * n + c];
                }
            }
        }
    }
    return log_det;
}

double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

void random_direction(random_source *source, double direction[3])
{
    for (int i = 0; i < 3; i++) {
        direction[i] = random_normal(source);
    }
    const double length = length3(direction);
    for (int i = 0; i < 3; i++) {
        direction[i] /= length;
    }
}

/* Two random directions made orthogonal, and their cross product. */
void random_rotation(random_source *source, double m[3][3])
{
    random_direction(source, m[0]);
    random_direction(source, m[1]);
    const double along = m[0][0] * m[1][0] + m[0][1] * m[1][1] + m[0][2] * m[1][2];
    for (int i = 0; i < 3; i++) {
        m[1][i] -= along * m[0][i];
    }
    const double length = length3(m[1]);
    for (int i = 0; i < 3; i++) {
        m[1][i] /= length;
    }
    m[2][0] = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    m[2][1] = m[0][2] * m[1][0] - m[0][0] * m[1][2];
    m[2][2] = m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

void rotation_by(const double v[3], double rotation[3][3])
{
    const double angle = length3(v);
    const double s = angle > 1e-8 ? sin(angle) / angle : 1;
    const double k = angle > 1e-8 ? 2 * pow(sin(angle / 2) / angle, 2) : 0.5;

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            rotation[i][j] = k * v[i] * v[j] + (i == j ? 1 - k * angle * angle : 0);
        }
        rotation[i][(i + 1) % 3] -= s * v[(i + 2) % 3];
        rotation[i][(i + 2) % 3] += s * v[(i + 1) % 3];
    }
}

triad_truth triad_random(random_source *source, double size)
{
    triad_truth truth;

    for (int r = 0; r < INVCAL_PARAMETERS; r++) {
        truth.x[r] = random_uniform(source, -size, size);
    }
    return truth;
}

void triad_read(const triad_truth *truth, const double eta[3], double u[3])
{
    const double *x = truth->x;

    u[0] = (1 + x[3]) * eta[0] + x[6] / 2 * eta[1] + x[7] / 2 * eta[2] + x[0];
    u[1] = x[6] / 2 * eta[0] + (1 + x[4]) * eta[1] + x[8] / 2 * eta[2] + x[1];
    u[2] = x[7] / 2 * eta[0] + x[8] / 2 * eta[1] + (1 + x[5]) * eta[2] + x[2];
}

void read_positions(const triad_truth *truth, const double directions[][3], unsigned count,
                    double sigma, random_source *source, reading_set *out)
{
    double u[3];

    TEST_ASSERT_TRUE(count <= MAX_POSITIONS);
    out->count = count;
    for (unsigned i = 0; i < count; i++) {
        triad_read(truth, directions[i], u);
        for (int axis = 0; axis < 3; axis++) {
            const double noise = sigma > 0 ? sigma * random_normal(source) : 0;
            out->u[i][axis] = (invcal_real)(u[axis] + noise);
        }
    }
}

invcal_calibration unit_nominal(void)
{
    return (invcal_calibration){{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

invcal_sums sums_of(const reading_set *set)
{
    const invcal_calibration nominal = unit_nominal();
    invcal_sums sums;

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < set->count; i++) {
        TEST_ASSERT_EQUAL_INT(INVCAL_OK, invcal_sums_add(&sums, &nominal, set->u[i], 1));
    }
    return sums;
}

double element(const invcal_sums *sums, unsigned r, unsigned c)
{
    return (double)sums->sum[INVCAL_PACKED(r, c)];
}

invcal_status calibrate_set(const reading_set *set, double noise, invcal_calibration *calibration,
                            invcal_quality *quality)
{
    const invcal_calibration nominal = unit_nominal();

    const invcal_positions given = {.mean = (const invcal_vector *)set->u,
                                    .count = set->count,
                                    .nominal = &nominal,
                                    .noise = (invcal_real)noise};

    return invcal_calibrate_plain(&given, calibration, quality);
}

double calibrated_length(const invcal_calibration *calibration, const triad_truth *truth,
                         const double eta[3])
{
    double u[3];
    invcal_real raw[3];
    invcal_real out[3];

    triad_read(truth, eta, u);
    for (int i = 0; i < 3; i++) {
        raw[i] = (invcal_real)u[i];
    }
    invcal_apply(calibration, raw[0], raw[1], raw[2], out);
    const double v[3] = {(double)out[0], (double)out[1], (double)out[2]};
    return length3(v);
}

void inverse3(const double m[3][3], double inverse[3][3])
{
    for (int i = 0; i < 3; i++) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        for (int j = 0; j < 3; j++) {
            const int j1 = (j + 1) % 3;
            const int j2 = (j + 2) % 3;
            inverse[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
    }
    const double det = m[0][0] * inverse[0][0] + m[0][1] * inverse[1][0] + m[0][2] * inverse[2][0];
    for (int i = 0; i < 9; i++) {
        inverse[i / 3][i % 3] /= det;
    }
}

triad_truth truth_of(const invcal_calibration *calibration, const invcal_calibration *nominal)
{
    static const int pair[3][2] = {{0, 1}, {0, 2}, {2, 1}};
    double m[3][3];
    double inverse[3][3];
    double p[3][3] = {{0}}; /* I + S */
    triad_truth truth;

    for (int i = 0; i < 9; i++) {
        m[i / 3][i % 3] = (double)calibration->matrix[i / 3][i % 3];
    }
    inverse3((const double(*)[3])m, inverse);
    for (int i = 0; i < 3; i++) {
        truth.x[i] = 0;
        for (int k = 0; k < 3; k++) {
            const double n = (double)nominal->matrix[i][k];
            truth.x[i] += n * ((double)calibration->offset[k] - (double)nominal->offset[k]);
            for (int j = 0; j < 3; j++) {
                p[i][j] += n * inverse[k][j];
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        truth.x[INVCAL_DK_X + i] = p[i][i] - 1;
        truth.x[INVCAL_GAMMA_XY + i] = p[pair[i][0]][pair[i][1]] + p[pair[i][1]][pair[i][0]];
    }
    return truth;
}

double parameter(const invcal_calibration *calibration, unsigned r)
{
    const invcal_calibration nominal = unit_nominal();

    return truth_of(calibration, &nominal).x[r];
}

uint32_t crc_by_table(const uint8_t *bytes, uint32_t count)
{
    static uint32_t table[256];
    uint32_t crc = 0xFFFFFFFFu;

    for (uint32_t i = 0; i < 256 && table[255] == 0; i++) {
        uint32_t c = i;
        for (int k = 0; k < 8; k++) {
            c = (c >> 1) ^ (0xEDB88320u & (0u - (c & 1u)));
        }
        table[i] = c;
    }
    for (uint32_t i = 0; i < count; i++) {
        crc = (crc >> 8) ^ table[(crc ^ bytes[i]) & 0xFFu];
    }
    return ~crc;
}

void seal_bytes(uint8_t *bytes, uint32_t count)
{
    const uint32_t crc = crc_by_table(bytes, count);

    for (unsigned i = 0; i < 4; i++) {
        bytes[count + i] = (uint8_t)(crc >> 8 * i);
    }
}
