/* SPDX-License-Identifier: MIT
 *
 * Normal equations, rows, readings and settings that may be anything: if a calibration is
 * delivered, it is finite, positive definite, and its sigma finite and not negative; if not, the
 * outputs are untouched. Likewise the rooms about it: outliers, temperature, guidance, criteria,
 * series, Allan deviation, gravity.
 * fuzz: at least 50 inputs a second
 */
#include <string.h>

#include "fuzz.h"

enum { MOST = 40 }; /* positions */

/* ---- normal equations ------------------------------------------------------------------------ */

static invcal_normal any_sums(source *s)
{
    invcal_normal normal;

    memset(&normal, 0, sizeof normal);
    for (unsigned i = 0; i < INVCAL_MOMENTS; i++) {
        normal.moment[i] = take_real(s, (invcal_real)(i % 3));
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS; r++) {
        normal.htj[r] = take_real(s, 0);
    }
    normal.jtj = take_real(s, 0);
    normal.count = take_byte(s) % 2 ? take_u32(s) : 18;
    normal.model = take_byte(s) % 2 ? INVCAL_MODEL_LINEAR : INVCAL_MODEL_ELLIPSOID;
    return normal;
}

static invcal_observation any_row(source *s, unsigned number)
{
    invcal_observation row;
    invcal_real u[3];
    invcal_real up[3];

    direction_of(number, up);
    for (unsigned i = 0; i < 3; i++) {
        u[i] = take_real(s, up[i]);
    }
    memset(&row, 0, sizeof row);
    mark(&row, sizeof row);
    const unsigned kind = take_byte(s);
    const invcal_status status = kind % 4 < 2    ? invcal_observation_exact(u, &row)
                                 : kind % 4 == 2 ? invcal_observation_first_order(u, up, &row)
                                                 : invcal_observation_vertical(u, up, &row);
    if (status != INVCAL_OK) {
        require_mark(&row, sizeof row);
        memset(&row, 0, sizeof row);
        return row;
    }
    require_finite(row.h, INVCAL_PARAMETERS);
    require_finite(&row.h[INVCAL_J], 1);
    return row;
}

/* Sums of rows that were added, taken out, merged and faded. */
static invcal_normal sums_of_rows(source *s)
{
    const unsigned kind = take_byte(s) % 4; /* of all rows, or they would not mix */
    const unsigned count = take_byte(s) % MOST;
    invcal_normal normal;
    invcal_normal other;

    invcal_normal_init(&normal);
    invcal_normal_init(&other);
    for (unsigned i = 0; i < count; i++) {
        const invcal_observation row = any_row(s, i);
        const invcal_real weight = take_real(s, 1);
        const unsigned action = take_byte(s);
        if ((action + kind) % 16 == 1) {
            (void)invcal_normal_remove(&normal, &row, weight);
        } else {
            (void)invcal_normal_add(action % 16 == 2 ? &other : &normal, &row, weight);
        }
        if (action % 16 == 3) {
            (void)invcal_normal_scale(&normal, weight);
        }
    }
    (void)invcal_normal_merge(&normal, &other);
    return normal;
}

static void look_at_guidance(const invcal_normal *normal, const invcal_real *current)
{
    char words[INVCAL_GUIDANCE_WORDS];
    invcal_guidance next;

    mark(&next, sizeof next);
    if (invcal_guidance_next(normal, current, &next) != INVCAL_OK) {
        require_mark(&next, sizeof next);
        return;
    }
    require_finite(next.up, 3);
    REQUIRE(is_finite(next.gain) && next.gain >= 0);
    require_sigma(next.before, INVCAL_PARAMETERS);
    require_sigma(next.after, INVCAL_PARAMETERS);
    invcal_guidance_words(next.up, words);
    REQUIRE(memchr(words, '\0', sizeof words));
}

static void look_at_criteria(const invcal_normal *normal)
{
    invcal_criteria criteria;

    mark(&criteria, sizeof criteria);
    if (invcal_criteria_judge(normal, &criteria) != INVCAL_OK) {
        require_mark(&criteria, sizeof criteria);
        return;
    }
    require_sigma(&criteria.sigma_delta, 1);
    require_sigma(&criteria.sigma_dk, 1);
    require_sigma(&criteria.sigma_gamma, 1);
    REQUIRE(is_finite(criteria.condition) && criteria.condition >= 1);
    REQUIRE(is_finite(criteria.log_det));
}

static void assess(const invcal_solution *solution, const invcal_settings *settings, source *s)
{
    invcal_real covariance[INVCAL_PACKED_SIZE(INVCAL_PARAMETERS)];
    const unsigned count = take_byte(s) % MOST;
    invcal_residuals residuals;
    invcal_quality quality;
    invcal_real residual;
    invcal_real u[3];

    invcal_residuals_init(&residuals, solution);
    for (unsigned i = 0; i < count; i++) {
        direction_of(i, u);
        for (unsigned a = 0; a < 3; a++) {
            u[a] = take_real(s, u[a]);
        }
        if (invcal_residuals_add(&residuals, u, take_real(s, 1), &residual) == INVCAL_OK) {
            REQUIRE(is_finite(residual));
        }
    }
    mark(&quality, sizeof quality);
    if (invcal_assess(&residuals, residuals.count + take_byte(s) / 32, settings, solution,
                      &quality) != INVCAL_OK) {
        require_mark(&quality, sizeof quality);
        return;
    }
    require_quality(&quality);
    if (invcal_covariance(&residuals, settings, quality.noise, covariance) == INVCAL_OK) {
        require_finite(covariance, INVCAL_PACKED_SIZE(INVCAL_PARAMETERS));
    }
}

static void solve(const invcal_normal *normal, source *s)
{
    const invcal_settings settings = take_settings(s);
    invcal_real current[3];
    invcal_solution solution;

    mark(&solution, sizeof solution);
    if (invcal_solve(normal, &settings, &solution) == INVCAL_OK) {
        REQUIRE(invcal_settings_check(&settings) == INVCAL_OK);
        require_solution(&solution);
        assess(&solution, &settings, s);
    } else {
        require_mark(&solution, sizeof solution);
    }
    REQUIRE(invcal_undetermined(normal) < 1u << INVCAL_PARAMETERS);
    for (unsigned i = 0; i < 3; i++) {
        current[i] = take_real(s, i == 2);
    }
    look_at_guidance(normal, take_byte(s) % 2 ? current : NULL);
    look_at_criteria(normal);
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

static void calibrate(source *s)
{
    invcal_real mean[MOST][3];
    const unsigned count = take_means(s, mean);
    const invcal_settings settings = take_settings(s);
    invcal_solution solution;
    invcal_quality quality;
    invcal_reason reason = {0, 0};

    mark(&solution, sizeof solution);
    mark(&quality, sizeof quality);
    if (invcal_calibrate(&mean[0][0], count, &settings, &solution, &quality, &reason) !=
        INVCAL_OK) {
        require_mark(&solution, sizeof solution);
        require_mark(&quality, sizeof quality);
        REQUIRE(reason.position <= count);
        REQUIRE(reason.undetermined < 1u << INVCAL_PARAMETERS);
        return;
    }
    require_solution(&solution);
    require_quality(&quality);
    REQUIRE(quality.worst < count);
}

static void find_outliers(source *s)
{
    invcal_real mean[MOST][3];
    const unsigned count = take_means(s, mean);
    const invcal_settings settings = take_settings(s);
    invcal_outliers found;

    mark(&found, sizeof found);
    if (invcal_outliers_find(&mean[0][0], count, &settings, &found) != INVCAL_OK) {
        require_mark(&found, sizeof found);
        return;
    }
    REQUIRE(found.count <= INVCAL_OUTLIERS_MOST);
    require_sigma(&found.sigma, 1);
    for (unsigned i = 0; i < count; i++) {
        REQUIRE(found.checked[i] >= 0 && found.checked[i] <= 1);
    }
    for (unsigned i = 0; i < found.count; i++) {
        REQUIRE(found.position[i] < count && (found.removed >> found.position[i] & 1u));
        REQUIRE(i == 0 || found.position[i] > found.position[i - 1]);
        require_finite(&found.error[i], 1);
        require_finite(&found.w[i], 1);
    }
    REQUIRE((found.removed & found.suspected) == 0);
}

/* ---- temperature ------------------------------------------------------------------------------ */

static invcal_thermal_settings take_thermal(source *s)
{
    enum { SPAN = 1, SLOPE = 2, CURVATURE = 4, LESS = 8 };
    const unsigned unusual = take_byte(s);
    invcal_thermal_settings thermal;

    memset(&thermal, 0, sizeof thermal);
    if (unusual & SPAN) {
        thermal.reference = take_real(s, 25);
        thermal.span = take_real(s, 45);
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS && unusual & SLOPE; r++) {
        thermal.slope[r] = take_real(s, INVCAL_REAL(0.001));
    }
    for (unsigned r = 0; r < INVCAL_PARAMETERS && unusual & CURVATURE; r++) {
        thermal.curvature[r] = take_real(s, INVCAL_REAL(0.00001));
    }
    thermal.less = unusual & LESS ? take_byte(s) : 0;
    return thermal;
}

static void look_at_thermal(const invcal_thermal_calibration *calibration, source *s)
{
    invcal_thermal_place place;
    invcal_solution solution;

    require_finite(&calibration->x[0][0], INVCAL_THERMAL_ROWS * INVCAL_PARAMETERS);
    REQUIRE(calibration->degree <= INVCAL_THERMAL_DEGREE);
    REQUIRE(calibration->fitted <= calibration->degree);
    REQUIRE(calibration->least <= calibration->greatest);
    mark(&solution, sizeof solution);
    if (invcal_thermal_at(calibration, take_real(s, 25), &solution, &place) == INVCAL_OK) {
        require_solution(&solution);
    } else {
        require_mark(&solution, sizeof solution);
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
    const invcal_settings settings = take_settings(s);
    const invcal_thermal_settings thermal = take_thermal(s);
    invcal_thermal_calibration calibration;
    invcal_quality quality;
    invcal_reason reason;

    mark(&calibration, sizeof calibration);
    mark(&quality, sizeof quality);
    if (invcal_thermal_calibrate(&mean[0][0], temperature, count, &settings, &thermal, &calibration,
                                 &quality, &reason) != INVCAL_OK) {
        require_mark(&calibration, sizeof calibration);
        require_mark(&quality, sizeof quality);
        REQUIRE(reason.position <= count);
        return;
    }
    look_at_thermal(&calibration, s);
    require_quality(&quality);
    REQUIRE(!(invcal_thermal_drift_limit(&settings, &thermal) < 0));
}

/* The same position by position, with a base. */
static void renew_thermal(source *s)
{
    invcal_real mean[MOST][3];
    invcal_real temperature[MOST];
    const unsigned count = take_thermal_means(s, mean, temperature);
    const invcal_settings settings = take_settings(s);
    const invcal_thermal_settings thermal = take_thermal(s);
    invcal_thermal_calibration base;
    invcal_thermal_sums sums;
    invcal_quality quality;

    mark(&base, sizeof base);
    if (invcal_thermal_start(&settings, &thermal, &base) != INVCAL_OK) {
        require_mark(&base, sizeof base);
        return;
    }
    for (unsigned rounds = take_byte(s) % 3 + 1; rounds > 0; rounds--) {
        invcal_thermal_init(&sums);
        for (unsigned i = 0; i < count; i++) {
            (void)invcal_thermal_add(&sums, &base, mean[i], temperature[i]);
        }
        if (count > 0 && take_byte(s) % 4 == 1) {
            (void)invcal_thermal_remove(&sums, &base, mean[0], temperature[0]);
        }
        if (invcal_thermal_solve(&sums, &base, &settings, &thermal, &base) != INVCAL_OK) {
            return;
        }
        look_at_thermal(&base, s);
    }
    mark(&quality, sizeof quality);
    if (invcal_thermal_assess(&sums, &base, &settings, &thermal, take_real(s, 25), &quality) ==
        INVCAL_OK) {
        require_quality(&quality);
    } else {
        require_mark(&quality, sizeof quality);
    }
}

/* ---- the rest --------------------------------------------------------------------------------- */

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
        invcal_allan_push(allan, kind == 2 ? (int32_t)bits : (int32_t)(bits & INT32_MAX));
    }
}

static void look_at_allan(source *s)
{
    uint32_t m[INVCAL_ALLAN_TAUS + 1];
    const unsigned count = take_byte(s) % (INVCAL_ALLAN_TAUS + 2);
    const int are_octaves = take_byte(s) % 2 == 0;
    const invcal_allan_windows windows = (invcal_allan_windows)(take_byte(s) % 3);
    invcal_allan allan;
    invcal_allan_point point;
    invcal_noise noise;

    for (unsigned i = 0; i < count && !are_octaves; i++) {
        const uint32_t step = take_byte(s);
        m[i] =
            step > 250 ? take_u32(s) : (i > 0 ? m[i - 1] : 0) + (step & 15u) * (1u << (step >> 4));
    }
    mark(&allan, sizeof allan);
    if (invcal_allan_init(&allan, are_octaves ? NULL : m, count, windows) != INVCAL_OK) {
        require_mark(&allan, sizeof allan);
        return;
    }
    while (s->left > 8) {
        push_samples(&allan, s);
        if (take_byte(s) % 8 == 1) {
            invcal_allan_gap(&allan);
        }
    }
    for (unsigned i = 0; i <= count; i++) {
        mark(&point, sizeof point);
        if (invcal_allan_get(&allan, i, &point) == INVCAL_OK) {
            REQUIRE(i < count && point.count > 0);
            require_sigma(&point.adev, 1);
            REQUIRE(is_finite(point.edf) && point.edf > 0);
            REQUIRE(is_finite(point.relative) && point.relative > 0);
        } else {
            require_mark(&point, sizeof point);
        }
    }
    mark(&noise, sizeof noise);
    if (invcal_allan_noise(&allan, take_real(s, 100), take_real(s, INVCAL_REAL(0.001)), &noise) !=
        INVCAL_OK) {
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

static void look_at_plan(source *s)
{
    invcal_plan plan = {take_byte(s) % 2 ? take_u32(s) % 1100 : 6, {0, 0, 0}};
    invcal_real coefficient[INVCAL_PLAN_GROUPS][INVCAL_SERIES_TERMS];
    invcal_real x[INVCAL_PARAMETERS];
    invcal_plan_position position;
    invcal_series series;

    for (unsigned g = 0; g < INVCAL_PLAN_GROUPS; g++) {
        plan.start[g] = take_real(s, 30);
    }
    mark(&position, sizeof position);
    if (invcal_plan_position_at(&plan, take_byte(s), &position) == INVCAL_OK) {
        require_finite(position.vertical, 3);
        REQUIRE(position.group >= 1 && position.group <= INVCAL_PLAN_GROUPS);
    } else {
        require_mark(&position, sizeof position);
    }
    mark(&series, sizeof series);
    if (invcal_series_init(&series, &plan) != INVCAL_OK) {
        require_mark(&series, sizeof series);
        return;
    }
    for (unsigned i = 0; i < 3 * plan.per_group; i++) {
        (void)invcal_series_add(&series, take_real(s, INVCAL_REAL(0.01)));
    }
    if (invcal_series_coefficients(&series, coefficient) == INVCAL_OK) {
        require_finite(&coefficient[0][0], INVCAL_PLAN_GROUPS * INVCAL_SERIES_TERMS);
        REQUIRE(invcal_series_solve(&series, x) == INVCAL_OK);
        require_finite(x, INVCAL_PARAMETERS);
    }
}

static void look_at_gravity(source *s)
{
    const invcal_real latitude = take_real(s, 45);
    const invcal_real height = take_real(s, 100);
    invcal_real g = -1;

    if (invcal_gravity(latitude, height, &g) == INVCAL_OK) {
        REQUIRE(g > INVCAL_REAL(9.7) && g < INVCAL_REAL(9.9));
    } else {
        REQUIRE(g == -1);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    source s = {data, size};
    invcal_normal normal;

    switch (take_byte(&s) % 10) {
    case 0:
        normal = any_sums(&s);
        solve(&normal, &s);
        break;
    case 1:
        normal = sums_of_rows(&s);
        solve(&normal, &s);
        break;
    case 2:
        find_outliers(&s);
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
        look_at_gravity(&s);
        break;
    default:
        calibrate(&s);
        break;
    }
    return 0;
}
