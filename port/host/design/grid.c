/* SPDX-License-Identifier: MIT
 *
 * Exchanging direction i for j multiplies det H'H by
 *
 *     (1 + d_j) (1 - d_i) + d_ij^2,     d_ij = h_i K h_j'     (Fedorov)
 */
#include "design/grid.h"

#include <math.h>
#include <string.h>

#include "maths/angles.h"
#include "design/covariance.h"

enum { P = INVCAL_PARAMETERS };

#define STEP_MIN 15u
#define CANDIDATES ((180 / STEP_MIN - 1) * (360 / STEP_MIN) + 2)
#define STARTS 200u      /* searches; the best is taken */
#define STARTS_LARGE 20u /* from LARGE positions on, since local optima are nearly equal there */
#define LARGE 20u
#define ROUNDS_MAX 100u /* at most, through all positions */
#define GAIN_MIN 1e-9

/* The directions that the stand can take. */
static struct {
    double up[CANDIDATES][3];
    double row[CANDIDATES][P];
    unsigned count;
    unsigned max_uses; /* of each */
} stops;

typedef struct {
    unsigned n;
    unsigned fixed;             /* the first `fixed` positions stay */
    unsigned stop[OPTIMAL_MAX]; /* of each position, its index */
    unsigned uses[CANDIDATES];  /* of each stop */
} selection;

static void add_stop(double alpha, double beta)
{
    double *up = stops.up[stops.count];

    angles_direction(alpha, beta, up);
    covariance_row(up, stops.row[stops.count++]);
}

/* Each direction once. The axes come first. */
static void list_stops(unsigned step)
{
    static const double axes[OPTIMAL_AXES][2] = {{0, 0},    {90, 0},   {90, 90},
                                                 {90, 180}, {90, -90}, {180, 0}};

    stops.count = 0;
    for (unsigned i = 0; i < OPTIMAL_AXES; i++) {
        add_stop(axes[i][0], axes[i][1]);
    }
    for (unsigned alpha = step; alpha < 180; alpha += step) {
        for (unsigned beta = 0; beta < 360; beta += step) {
            if (alpha != 90 || beta % 90 != 0) {
                add_stop(alpha, beta);
            }
        }
    }
}

/* The axes if they stay, the rest at random; a linear congruential generator will do. */
static void begin(selection *s, unsigned seed)
{
    unsigned long state = seed;

    memset(s->uses, 0, sizeof s->uses);
    for (unsigned i = 0; i < s->n; i++) {
        unsigned j = i;
        while (i >= s->fixed) {
            state = (state * 1103515245ul + 12345ul) & 0x7ffffffful;
            j = (unsigned)(state >> 8) % stops.count;
            if (s->uses[j] < stops.max_uses) {
                break;
            }
        }
        s->stop[i] = j;
        s->uses[j]++;
    }
}

static double covariance(const selection *s, double K[P][P])
{
    double up[OPTIMAL_MAX][3];

    for (unsigned i = 0; i < s->n; i++) {
        memcpy(up[i], stops.up[s->stop[i]], sizeof up[i]);
    }
    return covariance_find((const double(*)[3])up, NULL, s->n, K);
}

/* d_j of all stops. */
static void find_variances(double K[P][P], double variance[CANDIDATES])
{
    for (unsigned j = 0; j < stops.count; j++) {
        variance[j] = covariance_product(K, stops.row[j], stops.row[j]);
    }
}

/* Exchanges position i for the stop that makes det H'H largest. Returns 1 if one does. */
static int exchange(selection *s, unsigned i, double K[P][P], const double variance[CANDIDATES])
{
    const double own = variance[s->stop[i]];
    double max = 1 + GAIN_MIN;
    double image[P]; /* K h_i' */
    unsigned best = s->stop[i];

    covariance_image(K, stops.row[s->stop[i]], image);
    for (unsigned j = 0; j < stops.count; j++) {
        double both = 0;
        for (unsigned c = 0; c < P; c++) {
            both += image[c] * stops.row[j][c];
        }
        const double gain = (1 + variance[j]) * (1 - own) + both * both;
        if (s->uses[j] < stops.max_uses && gain > max) {
            max = gain + GAIN_MIN; /* so that rounding does not decide */
            best = j;
        }
    }
    if (best == s->stop[i]) {
        return 0;
    }
    s->uses[s->stop[i]]--;
    s->uses[best]++;
    s->stop[i] = best;
    return 1;
}

/* Exchanges as long as that increases det H'H. Returns ln det H'H. */
static double improve(selection *s)
{
    double K[P][P];
    double variance[CANDIDATES];
    double log_det = covariance(s, K);
    int has_improved = 1;

    find_variances(K, variance);
    for (unsigned round = 0; round < ROUNDS_MAX && has_improved; round++) {
        has_improved = 0;
        for (unsigned i = s->fixed; i < s->n; i++) {
            if (exchange(s, i, K, variance)) {
                log_det = covariance(s, K);
                find_variances(K, variance);
                has_improved = 1;
            }
        }
    }
    return log_det;
}

/* A search from one start. Axes that are fixed at first need not stay: without keeps_axes, a second
 * search may exchange them. */
static double search(selection *s, unsigned seed, int begins_with_axes, int keeps_axes)
{
    s->fixed = begins_with_axes ? OPTIMAL_AXES : 0;
    begin(s, seed);
    const double log_det = improve(s);
    if (!begins_with_axes || keeps_axes) {
        return log_det;
    }
    s->fixed = 0;
    return improve(s);
}

void grid_directions(unsigned n, unsigned step, int with_axes, double (*direction)[3])
{
    const unsigned starts = n < LARGE ? STARTS : STARTS_LARGE;
    selection s = {.n = n};
    double max = -HUGE_VAL;

    list_stops(step);
    stops.max_uses = (n + stops.count - 1) / stops.count;
    for (unsigned k = with_axes ? starts : 0; k < 2 * starts; k++) {
        const double log_det = search(&s, k % starts + 1, k >= starts, with_axes);
        if (log_det > max + GAIN_MIN) {
            max = log_det;
            for (unsigned i = 0; i < n; i++) {
                memcpy(direction[i], stops.up[s.stop[i]], sizeof direction[i]);
            }
        }
    }
}
