/* SPDX-License-Identifier: MIT
 *
 * Axes: those of the case, from its faces; those of a stand, from its program.
 */
#include "digest.h"
#include "stand/directions.h"

#include "invcal/frame.h"
#include "plan/plan_axes.h"

static invcal_calibration nominal;

/* The reading of a direction, by a sensor that sits askew in its case. */
static void read_askew(const float up[3], float raw[3])
{
    static const float askew[3] = {0.04f, -0.07f, 0.1f};

    memcpy(raw, up, 3 * sizeof *raw);
    input_turn(raw, askew);
    for (int i = 0; i < 3; i++) {
        raw[i] = 32768 + 4096 * (raw[i] + 1e-3f * input_noise());
    }
}

static void faces(void)
{
    invcal_frame frame;
    invcal_frame_quality quality;
    invcal_calibration calibration = nominal;
    invcal_rotation rotation;

    digest_set("faces");
    invcal_frame_init(&frame);
    for (int i = 0; i < 6; i++) {
        float up[3] = {0, 0, 0}, raw[3];
        up[i / 2] = i % 2 ? -1 : 1;
        read_askew(up, raw);
        digest_bits("added", invcal_frame_add(&frame, &nominal, raw, up));
    }
    digest_bits("status", invcal_frame_solve(&frame, &rotation, &quality));
    digest_reals("rotation", rotation.r[0], 9);
    digest_reals("sigma", quality.sigma, 3);
    digest_reals("scatter", &quality.scatter, 1);
    invcal_rotate(&calibration, &rotation);
    digest_reals("matrix", calibration.matrix[0], 9);
}

static void level(void)
{
    static const float up[3] = {0, 0, 1};
    invcal_frame frame;
    invcal_rotation rotation;
    float raw[3];

    digest_set("level");
    invcal_frame_init(&frame);
    for (int i = 0; i < 3; i++) {
        read_askew(up, raw);
        digest_bits("added", invcal_frame_add(&frame, &nominal, raw, up));
    }
    digest_bits("status", invcal_frame_level(&frame, up, &rotation));
    digest_reals("rotation", rotation.r[0], 9);
}

/* The sums of a stand whose axes are known. */
static void add_to(invcal_directions *linear, const float vertical[3])
{
    float raw[3];

    read_askew(vertical, raw);
    digest_bits("added", invcal_directions_add(linear, &nominal, raw, vertical));
    digest_bits("added", invcali_directions_add_scalar(linear, &nominal, raw, vertical));
}

static void solve_linear(invcal_directions *linear)
{
    invcal_calibration calibration;
    float x[INVCAL_PARAMETERS];

    digest_set("linear");
    digest_bits("status", invcal_directions_solve(linear, &nominal, &calibration, x));
    digest_calibration(&calibration, &nominal);
    digest_reals("x", x, INVCAL_PARAMETERS);
}

static void stand(void)
{
    invcal_plan plan = {.per_group = 0, .start_deg = {0, 0, 0}};
    invcal_directions linear;

    digest_set("stand");
    invcal_directions_init(&linear);
    digest_bits("starts", invcal_plan_init(&plan, 6));
    digest_reals("start", plan.start_deg, INVCAL_PLAN_GROUPS);
    for (unsigned i = 0; i < 3 * plan.per_group; i++) {
        invcal_plan_position position;
        digest_bits("status", invcal_plan_get(&plan, i, &position));
        digest_reals("alpha", &position.alpha_deg, 1);
        digest_reals("beta", &position.beta_deg, 1);
        digest_reals("vertical", position.up, 3);
        digest_bits("axis_up", invcali_axis_up(position.up));
        add_to(&linear, position.up);
    }
    solve_linear(&linear);
}

void part_frame(void)
{
    input_nominal(&nominal);
    faces();
    level();
    stand();
}
