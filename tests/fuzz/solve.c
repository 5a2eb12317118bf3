/* SPDX-License-Identifier: MIT
 *
 * Sums, rows, readings and conditions that may be anything: if a calibration is delivered, it is
 * finite, positive definite, and its sigma finite and not negative; if not, the outputs are untouched.
 * The same for the other functions: known directions, a prior, judgement, temperature, guidance, Allan
 * deviation, programs, and what is done with a calibration.
 * fuzz: more than 50 inputs per second of CPU time
 */
#include <math.h>
#include <string.h>

#include "../positions.h"
#include "stand/directions.h"
#include "fuzz.h"
#include "plan/guidance.h"
#include "invcal/allan.h"
#include "invcal/plan.h"
#include "invcal/thermal_store.h"
#include "calibrate/judge.h"
#include "allan/noise.h"
#include "plan/plan_axes.h"
#include "core/solve.h"
#include "core/sums.h"
#include "core/vector.h"

enum { MOST = 40 }; /* positions */

/* ---- sums --------------------------------------------------------------------------------------- */

/* Whatever may stand in them. */
static invcal_sums any_sums(source *s)
{
    invcal_sums sums;

    invcal_sums_init(&sums);
    for (unsigned r = 0; r <= INVCAL_PARAMETERS; r++) {
        for (unsigned c = 0; c <= r; c++) {
            sums.sum[INVCAL_PACKED(r, c)] = take_real(s, r == c ? 3 : 0);
        }
    }
    sums.count = take_byte(s) % 2 ? take_u32(s) : 18;
    return sums;
}

static invcal_real take_weight(source *s)
{
    const invcal_real weight = take_real(s, 1);

    return is_finite(weight) && weight >= 0 ? weight : 1;
}

static void take_reading(source *s, unsigned number, invcal_real raw[3])
{
    invcal_real up[3];

    direction_of(number, up);
    for (unsigned a = 0; a < 3; a++) {
        raw[a] = take_real(s, 1000 * up[a]);
    }
}

/* Sums of rows with weights, or of readings; a reading that is refused leaves them as they are. */
static invcal_sums sums_of_rows(source *s, const conditions *c)
{
    const unsigned count = take_byte(s) % MOST;
    invcal_real raw[3];
    invcal_sums sums;
    invcali_row row;

    invcal_sums_init(&sums);
    for (unsigned i = 0; i < count; i++) {
        take_reading(s, i, raw);
        const invcal_sums before = sums;
        const invcal_status status = invcali_observe(&c->nominal, raw, &row);
        if (take_byte(s) % 4 == 0) {
            REQUIRE(invcal_sums_add(&sums, &c->nominal, raw, 1) == status);
            REQUIRE(status == INVCAL_OK || memcmp(&before, &sums, sizeof sums) == 0);
        } else if (status == INVCAL_OK) {
            invcali_sums_add_row(&sums, &row, take_weight(s));
        }
        if (status == INVCAL_OK) {
            require_finite(row.h, INVCAL_PARAMETERS);
            require_finite(&row.h[INVCAL_J], 1);
        }
        REQUIRE(sums.count == before.count + (status == INVCAL_OK));
    }
    return sums;
}

static void solve(invcal_sums *sums, const conditions *c)
{
    invcal_calibration out;

    mark(&out, sizeof out);
    if (invcal_sums_solve(sums, &c->nominal, &out) != INVCAL_OK) {
        require_mark(&out, sizeof out);
    } else if (invcali_nominal_check(&c->nominal) == INVCAL_OK) {
        require_solution(&out, c);
    }
}

/* Known directions, by either composition. */
static void solve_linear(source *s, const conditions *c)
{
    const int is_vertical = take_byte(s) % 2;
    const unsigned count = take_byte(s) % MOST;
    invcal_real x[INVCAL_PARAMETERS];
    invcal_real raw[3];
    invcal_real eta[3];
    invcal_calibration out;
    invcal_directions linear;

    invcal_directions_init(&linear);
    for (unsigned i = 0; i < count; i++) {
        take_reading(s, i, raw);
        direction_of(i, eta);
        eta[i % 3] = take_real(s, eta[i % 3]);
        const invcal_directions before = linear;
        const invcal_status status =
            is_vertical ? invcal_directions_add(&linear, &c->nominal, raw, eta)
                        : invcali_directions_add_scalar(&linear, &c->nominal, raw, eta);
        REQUIRE(status == INVCAL_OK || memcmp(&before, &linear, sizeof linear) == 0);
    }
    mark(&out, sizeof out);
    mark(x, sizeof x);
    if (invcal_directions_solve(&linear, &c->nominal, &out, x) != INVCAL_OK) {
        require_mark(&out, sizeof out);
        require_mark(x, sizeof x);
        return;
    }
    require_finite(x, INVCAL_PARAMETERS);
    if (invcali_nominal_check(&c->nominal) == INVCAL_OK) {
        require_solution(&out, c);
    }
}

/* ---- position means --------------------------------------------------------------------------- */

/* Some thousand counts, a triad's or anybody's. Returns how many. */
static unsigned take_means(source *s, invcal_real mean[MOST][3])
{
    const unsigned count = take_byte(s) % (MOST + 1);
    const invcal_real offset = take_real(s, 20);
    const invcal_real scale = take_real(s, 1010);

    for (unsigned i = 0; i < count; i++) {
        invcal_real up[3];
        direction_of(i, up);
        const unsigned wrong = take_byte(s);
        for (unsigned a = 0; a < 3; a++) {
            mean[i][a] = offset + scale * up[a] + (invcal_real)((i * 7 + a * 5) % 11) / 10;
            if (wrong >> a & 1u) {
                mean[i][a] = take_real(s, mean[i][a]);
            }
        }
    }
    return count;
}

/* What is said of a refusal, and what comes next. */
static void look_at_guidance(const invcal_real *raw, unsigned count, const conditions *c, source *s)
{
    const int is_nominal = invcali_nominal_check(&c->nominal) == INVCAL_OK;
    const unsigned bad = invcal_bad_reading(POSITIONS_OF(raw, count, &c->nominal, 0));
    invcal_real root[INVCAL_PARAMETERS];
    invcal_real up[3];
    invcali_row row;

    REQUIRE(bad <= count);
    for (unsigned i = 0; i < bad; i++) {
        REQUIRE(invcali_observe(&c->nominal, raw + 3 * i, &row) == INVCAL_OK);
    }
    REQUIRE(bad == count || invcali_observe(&c->nominal, raw + 3 * bad, &row) != INVCAL_OK);
    if (!is_nominal) {
        return;
    }
    REQUIRE(invcal_undetermined(POSITIONS_OF(raw, count, &c->nominal, 0)) <
            1u << INVCAL_PARAMETERS);
    invcali_next(POSITIONS_OF(raw, count, &c->nominal, 0), up);
    require_direction(up);
    invcali_prospect(POSITIONS_OF(raw, count, &c->nominal, 0), take_byte(s) % 2 ? up : NULL, root);
    require_sigma(root, INVCAL_PARAMETERS);
}

/* The offset's sigma, in counts. */
static void look_at_offset(const invcal_quality *quality, const conditions *c)
{
    invcal_real sigma[3];

    invcal_sigma_offset(quality, &c->nominal, sigma);
    require_sigma(sigma, 3);
}

static void calibrate(source *s)
{
    invcal_real mean[MOST][3];
    const unsigned count = take_means(s, mean);
    const conditions c = take_conditions(s);
    const invcal_mask left_out = take_byte(s) % 2 ? take_u32(s) : 0;
    const invcal_mask all =
        (invcal_mask) ~(invcal_mask)0 >> (sizeof all * 8 - INVCAL_MAX_POSITIONS);
    invcal_calibration out;
    invcal_quality quality;

    mark(&out, sizeof out);
    mark(&quality, sizeof quality);
    if (invcali_positions_calibrate(
            SELECTION(&mean[0][0], count, left_out & all, &c.nominal, c.noise), &out, &quality) ==
        INVCAL_OK) {
        require_solution(&out, &c);
        invcal_mask of_these = left_out & all;
        of_these &= count < INVCAL_MAX_POSITIONS ? ((invcal_mask)1 << count) - 1 : all;
        REQUIRE(quality.left_out == (left_out & all));
        quality.left_out = of_these; /* what stands behind the last position leaves nothing out */
        require_quality(&quality, count);
        require_noise(&quality, c.noise);
        look_at_offset(&quality, &c);
    } else {
        require_mark(&out, sizeof out);
        require_mark(&quality, sizeof quality);
    }
    look_at_guidance(&mean[0][0], count, &c, s);
}

/* The verdict is not about angles, and only these are held. */
static void calibrate_six_faces(const invcal_real *mean, unsigned count, const conditions *c)
{
    const unsigned angles = 7u << INVCAL_GAMMA_XY;
    const invcal_real gamma = c->prior[INVCAL_GAMMA_XY];
    invcal_calibration out;
    invcal_quality quality;

    mark(&out, sizeof out);
    mark(&quality, sizeof quality);
    if (invcal_calibrate_faces(POSITIONS_OF(mean, count, &c->nominal, c->noise), gamma, &out,
                               &quality) != INVCAL_OK) {
        require_mark(&out, sizeof out);
        require_mark(&quality, sizeof quality);
        return;
    }
    require_solution(&out, c);
    require_quality(&quality, count);
    REQUIRE(count >= 6 && gamma > 0 && gamma < 1);
    REQUIRE((quality.held & ~angles) == 0 && (quality.weak & angles) == 0);
    REQUIRE((quality.weak != 0) == (quality.verdict == INVCAL_WEAK));
    const invcal_real right = invcal_accuracy(&quality, 0);
    quality.held = 0; /* as if all were measured */
    REQUIRE(right >= 0 && right <= invcal_accuracy(&quality, 0) * (1 + 8 * INVCAL_EPSILON));
}

/* Sigma is never above the prior. */
static void calibrate_with_prior(source *s)
{
    invcal_real mean[MOST][3];
    const unsigned count = take_means(s, mean);
    const conditions c = take_conditions(s);
    invcal_calibration out;
    invcal_quality quality;

    calibrate_six_faces(&mean[0][0], count, &c);
    mark(&out, sizeof out);
    mark(&quality, sizeof quality);
    if (invcal_calibrate_prior(POSITIONS_OF(&mean[0][0], count, &c.nominal, c.noise), c.prior, &out,
                               &quality) != INVCAL_OK) {
        require_mark(&out, sizeof out);
        require_mark(&quality, sizeof quality);
        return;
    }
    require_solution(&out, &c);
    require_quality(&quality, count);
    require_noise(&quality, c.noise);
    REQUIRE(quality.held < 1u << INVCAL_PARAMETERS);
    const invcal_real most = 1 + 8 * INVCAL_EPSILON;
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        REQUIRE(c.prior[r] >= 0);
        REQUIRE(c.prior[r] > 0 || !(quality.held >> r & 1u));
        REQUIRE(c.prior[r] == 0 || quality.sigma[r] <= c.prior[r] * most);
    }
}

/* In the order in which they were visited: what contradicts the others is left out. */
static void calibrate_judged(source *s)
{
    invcal_real mean[MOST][3];
    const unsigned count = take_means(s, mean);
    const conditions c = take_conditions(s);
    const int is_robust = take_byte(s) % 4 == 0;
    invcal_calibration out;
    invcal_quality quality;

    mark(&out, sizeof out);
    mark(&quality, sizeof quality);
    if ((is_robust ? invcal_calibrate_robust : invcal_calibrate)(
            POSITIONS_OF(&mean[0][0], count, &c.nominal, c.noise), &out, &quality) != INVCAL_OK) {
        require_mark(&out, sizeof out);
        require_mark(&quality, sizeof quality);
        return;
    }
    REQUIRE(count >= INVCAL_PARAMETERS && count <= INVCAL_MAX_POSITIONS);
    require_solution(&out, &c);
    require_quality(&quality, count);
    require_noise(&quality, c.noise);
    REQUIRE(((quality.left_out | quality.suspected) >> (count - 1)) <= 1);
    const unsigned left_out = count_bits(quality.left_out);
    REQUIRE(left_out == 0 || left_out + INVCAL_PARAMETERS + 2 <= count);
    REQUIRE(left_out * 6 <= count || quality.verdict >= INVCAL_ROUGH);
    REQUIRE(!is_robust ||
            (quality.unchecked == 0x1E && quality.systematic == INVCAL_NO_SYSTEMATIC));
}

/* ---- temperature ------------------------------------------------------------------------------ */

static void look_at_thermal(const invcal_thermal *thermal, const invcal_quality *quality,
                            unsigned count, source *s)
{
    uint8_t bytes[INVCAL_THERMAL_RECORD_SIZE];
    invcal_thermal decoded;
    invcal_record about;
    invcal_thermal_place place;
    invcal_calibration out;

    require_finite(&thermal->x[0][0], 3 * INVCAL_PARAMETERS);
    REQUIRE(thermal->degree <= INVCAL_THERMAL_DEGREE && thermal->fitted <= thermal->degree);
    REQUIRE(thermal->min <= thermal->max && thermal->fallback <= INVCAL_THERMAL_OPEN);
    require_quality(quality, count);
    mark(&out, sizeof out);
    if (invcal_thermal_at(thermal, take_real(s, 25), &out, &place) == INVCAL_OK) {
        require_calibration(&out, &thermal->nominal, 1);
        REQUIRE(place <= INVCAL_THERMAL_ABOVE);
    } else {
        require_mark(&out, sizeof out);
    }
    if (invcal_thermal_at(thermal, thermal->reference, &out, NULL) == INVCAL_OK) {
        invcal_record_init(&about, &out, quality);
        REQUIRE(invcal_thermal_encode(thermal, &about, bytes) != INVCAL_OK ||
                invcal_thermal_decode(bytes, sizeof bytes, &decoded, NULL) == INVCAL_OK);
    }
}

/* Positions at some temperatures, each a little wrong by them. Returns how many. */
static unsigned take_thermal_means(source *s, invcal_real mean[MOST][3],
                                   invcal_real temperature[MOST])
{
    const unsigned count = take_means(s, mean);
    const unsigned levels = take_byte(s) % 4 + 1;
    const invcal_real step = take_real(s, 30);

    for (unsigned i = 0; i < count; i++) {
        temperature[i] = take_real(s, step * (invcal_real)(i % levels) - 10);
        mean[i][0] += temperature[i] / 2;
    }
    return count;
}

static void calibrate_thermal(source *s)
{
    invcal_real mean[MOST][3];
    invcal_real temperature[MOST];
    const unsigned count = take_thermal_means(s, mean, temperature);
    const conditions c = take_conditions(s);
    invcal_thermal thermal;
    invcal_quality quality;

    mark(&thermal, sizeof thermal);
    mark(&quality, sizeof quality);
    if (invcal_thermal_calibrate(POSITIONS_AT(&mean[0][0], temperature, count, &c.nominal, c.noise),
                                 INVCAL_THERMAL_DEGREE, &thermal, &quality) != INVCAL_OK) {
        require_mark(&thermal, sizeof thermal);
        require_mark(&quality, sizeof quality);
        return;
    }
    look_at_thermal(&thermal, &quality, count, s);
}

/* Of nothing, of slopes, or of anything. */
static invcal_thermal_prior take_thermal_prior(source *s)
{
    enum { VALUES = 1, SLOPES = 2, BENDS = 4 };
    const unsigned unusual = take_byte(s);
    invcal_thermal_prior prior;

    memset(&prior, 0, sizeof prior);
    for (unsigned a = 0; a < 3; a++) {
        for (unsigned r = 0; r < INVCAL_PARAMETERS && unusual & (unsigned)VALUES << a; r++) {
            prior.sigma[a][r] = take_real(s, a == 0 ? INVCAL_REAL(0.05) : INVCAL_REAL(0.001));
        }
    }
    return prior;
}

/* The same with a prior, and in turns, each from the last. */
static void renew_thermal(source *s)
{
    invcal_real mean[MOST][3];
    invcal_real temperature[MOST];
    const unsigned count = take_thermal_means(s, mean, temperature);
    const conditions c = take_conditions(s);
    const invcal_thermal_prior prior = take_thermal_prior(s);
    const invcal_thermal_prior *known = take_byte(s) % 2 ? &prior : NULL;
    const invcal_positions *positions =
        POSITIONS_AT(&mean[0][0], temperature, count, &c.nominal, c.noise);
    const invcal_thermal *from = NULL;
    invcal_thermal base;
    invcal_quality quality;

    mark(&base, sizeof base);
    for (unsigned rounds = take_byte(s) % 3 + 1; rounds > 0; rounds--) {
        const invcal_thermal before = base;
        mark(&quality, sizeof quality);
        if (invcal_thermal_fit(positions, known, from, take_byte(s) % 4, &base, &quality) !=
            INVCAL_OK) {
            REQUIRE(memcmp(&before, &base, sizeof base) == 0);
            require_mark(&quality, sizeof quality);
            return;
        }
        look_at_thermal(&base, &quality, count, s);
        from = &base;
    }
    mark(&quality, sizeof quality);
    if (invcal_thermal_judge(positions, known, &base, take_real(s, 25), &quality) == INVCAL_OK) {
        require_quality(&quality, count);
    } else {
        require_mark(&quality, sizeof quality);
    }
}

/* ---- noise ------------------------------------------------------------------------------------ */

static void look_at_noise(const invcal_noise *noise, source *s)
{
    invcal_dwell dwell;

    mark(&dwell, sizeof dwell);
    if (invcal_noise_dwell(noise, take_real(s, INVCAL_REAL(0.001)), &dwell) != INVCAL_OK) {
        require_mark(&dwell, sizeof dwell);
        return;
    }
    REQUIRE(is_finite(dwell.seconds) && dwell.seconds > 0);
    require_sigma(&dwell.sigma, 1);
    REQUIRE(dwell.end <= INVCAL_DWELL_FLOOR);
}

static void push_samples(invcal_allan *allan, source *s)
{
    const unsigned count = (take_byte(s) & 31u) << (take_byte(s) % 8);
    const unsigned kind = take_byte(s) % 4;
    const uint32_t size = kind == 3 ? take_u32(s) : take_byte(s);
    uint32_t state = take_byte(s);

    for (unsigned i = 0; i < count; i++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        const uint32_t bits = kind == 0   ? size
                              : kind == 1 ? state >> 24
                                          : (state >> 8) % (size + !size);
        invcal_allan_feed(allan, kind == 2 ? (int32_t)bits : (int32_t)(bits & INT32_MAX));
    }
}

static void look_at_points(const invcal_allan *allan, unsigned count)
{
    invcal_allan_point point;

    for (unsigned i = 0; i <= count; i++) {
        mark(&point, sizeof point);
        if (invcal_allan_get(allan, i, &point) == INVCAL_OK) {
            REQUIRE(i < count && point.count > 0);
            require_sigma(&point.adev, 1);
            REQUIRE(is_finite(point.edf) && point.edf > 0);
            REQUIRE(is_finite(point.relative) && point.relative > 0);
        } else {
            require_mark(&point, sizeof point);
        }
    }
}

/* Returns how many averaging times there are; 0 if the list was refused. */
static unsigned begin_allan(invcal_allan *allan, source *s)
{
    uint32_t m[INVCAL_ALLAN_TAUS + 1];
    const unsigned count = take_byte(s) % (INVCAL_ALLAN_TAUS + 2);

    if (take_byte(s) % 2 == 0) {
        REQUIRE(invcal_allan_init(allan, sizeof *allan) == INVCAL_OK);
        return INVCAL_ALLAN_TAUS;
    }
    for (unsigned i = 0; i < count; i++) {
        const uint32_t step = take_byte(s);
        m[i] =
            step > 250 ? take_u32(s) : (i > 0 ? m[i - 1] : 0) + (step & 15u) * (1u << (step >> 4));
    }
    if (invcal_allan_init_taus(allan, sizeof *allan, m, count, take_byte(s) % 2) != INVCAL_OK) {
        REQUIRE(allan->taus == 0);
        return 0;
    }
    return count;
}

static void look_at_allan(source *s)
{
    invcal_allan allan;
    invcal_noise noise;
    const unsigned count = begin_allan(&allan, s);

    if (count == 0) {
        return;
    }
    while (s->left > 8) {
        push_samples(&allan, s);
        if (take_byte(s) % 8 == 1) {
            invcal_allan_gap(&allan);
        }
    }
    look_at_points(&allan, count);
    mark(&noise, sizeof noise);
    if (invcal_allan_solve(&allan, take_real(s, 100), &noise) != INVCAL_OK) {
        require_mark(&noise, sizeof noise);
        return;
    }
    require_sigma(noise.coefficient, INVCAL_NOISE_KINDS);
    require_sigma(noise.relative, INVCAL_NOISE_KINDS);
    require_sigma(&noise.misfit, 1);
    look_at_noise(&noise, s);
}

static void any_noise(source *s)
{
    invcal_noise noise;

    memset(&noise, 0, sizeof noise);
    for (unsigned k = 0; k < INVCAL_NOISE_KINDS; k++) {
        noise.coefficient[k] = take_real(s, INVCAL_REAL(0.001));
    }
    noise.shortest = take_real(s, INVCAL_REAL(0.01));
    noise.longest = take_real(s, 100);
    look_at_noise(&noise, s);
}

/* ---- the rest --------------------------------------------------------------------------------- */

static void look_at_plan(source *s)
{
    invcal_plan plan = {take_byte(s) % 2 ? take_u32(s) % 1100 : 6, {0, 0, 0}};
    invcal_plan_position position;

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        plan.start_deg[g] = take_real(s, 30);
    }
    mark(&position, sizeof position);
    if (invcal_plan_get(&plan, take_byte(s), &position) == INVCAL_OK) {
        require_direction(position.up);
        REQUIRE(position.group >= 1 && position.group <= INVCAL_PLAN_GROUPS);
        REQUIRE(position.alpha_deg > -180 && position.alpha_deg <= 180);
        REQUIRE(position.beta_deg > -180 && position.beta_deg <= 180);
    } else {
        require_mark(&position, sizeof position);
    }
    const uint8_t axes = invcali_axis_up(position.up); /* be it what it may */
    REQUIRE((axes & (axes - 1)) == 0 && axes < 1u << INVCAL_AXES);
    if (invcal_plan_init(&plan, plan.per_group) == INVCAL_OK) {
        REQUIRE(invcali_plan_check(&plan) == INVCAL_OK);
    }
}

/* A nominal calibration, and a calibration in use. */
static void use(source *s)
{
    const conditions c = take_conditions(s);
    char words[INVCAL_TEXT_SIZE];
    invcal_calibration made;
    invcal_real zero[3];
    invcal_real counts[3];
    invcal_real raw[3];
    invcal_real same[3];
    int32_t sample[3];

    for (unsigned a = 0; a < 3; a++) {
        zero[a] = take_real(s, 20);
        counts[a] = take_real(s, 1000);
        sample[a] = take_i32(s);
        raw[a] = (invcal_real)sample[a];
    }
    mark(&made, sizeof made);
    if (invcal_nominal(zero, counts, &made) == INVCAL_OK) {
        require_regular(&made);
        require_solution(&made, &(conditions){.nominal = made, .field = c.field});
    } else {
        require_mark(&made, sizeof made);
    }
    invcal_apply(&c.nominal, raw[0], raw[1], raw[2], same);
    invcal_apply(&c.nominal, raw[0], raw[1], raw[2], raw); /* the same array */
    REQUIRE(memcmp(raw, same, sizeof raw) == 0);
    invcal_apply(&c.nominal, (invcal_real)sample[0], (invcal_real)sample[1], (invcal_real)sample[2],
                 raw);
    REQUIRE(memcmp(raw, same, sizeof raw) == 0);
    REQUIRE(invcal_direction_text(raw, words) == words && memchr(words, '\0', sizeof words));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    const unsigned what = take_byte(&s) % 12;
    conditions c;
    invcal_sums sums;

    switch (what) {
    case 0:
        c = take_conditions(&s);
        sums = any_sums(&s);
        solve(&sums, &c);
        break;
    case 1:
        c = take_conditions(&s);
        sums = sums_of_rows(&s, &c);
        solve(&sums, &c);
        break;
    case 2:
        calibrate_judged(&s);
        break;
    case 3:
        calibrate_thermal(&s);
        break;
    case 4:
        renew_thermal(&s);
        break;
    case 5:
        look_at_allan(&s);
        break;
    case 6:
        any_noise(&s);
        break;
    case 7:
        look_at_plan(&s);
        break;
    case 8:
        use(&s);
        break;
    case 9:
        c = take_conditions(&s);
        c.is_linear = 1;
        solve_linear(&s, &c);
        break;
    default:
        if (take_byte(&s) % 2) {
            calibrate_with_prior(&s);
        } else {
            calibrate(&s);
        }
        break;
    }
    return 0;
}
