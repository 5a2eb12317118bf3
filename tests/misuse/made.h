/* SPDX-License-Identifier: MIT
 *
 * How to make a good object of each type.
 */
static void make_calibration(void *p)
{
    memcpy(p, &nominal, sizeof nominal);
}

static void make_good_positions(void *p)
{
    make_positions(p, 18);
}

static void make_good_quality(void *p)
{
    make_quality(p);
}

static void make_good_session(void *p)
{
    make_session(p);
}

static void make_background(void *p)
{
    invcal_background *b = p;

    if (invcal_background_init(b, sizeof *b, &nominal, 100) != INVCAL_OK) {
        abort();
    }
}

static void make_store(void *p)
{
    memcpy(p, &store, sizeof store);
}

static void make_sums(void *p)
{
    for (unsigned i = 0; i < 18; i++) {
        (void)invcal_sums_add(p, &nominal, mean[i].v, 1);
    }
}

static void make_record(void *p)
{
    invcal_quality q;

    make_quality(&q);
    invcal_record_init(p, &nominal, &q);
}

static void make_directions(void *p)
{
    for (unsigned i = 0; i < 18; i++) {
        const invcal_real *v = mean[i].v;
        const double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        const invcal_real eta[3] = {(invcal_real)(v[0] / length), (invcal_real)(v[1] / length),
                                    (invcal_real)(v[2] / length)};
        (void)invcal_directions_add(p, &nominal, v, eta);
    }
}

static void make_imu(void *p)
{
    invcal_imu *imu = p;

    make_session(&imu->session);
    if (invcal_imu_init(imu, sizeof *imu, 3753, 100) != INVCAL_OK) {
        abort();
    }
}

static void make_magnetometer(void *p)
{
    if (invcal_magnetometer_init(p, &nominal) != INVCAL_OK) {
        abort();
    }
    for (unsigned i = 0; i < 1000; i++) {
        (void)invcal_magnetometer_feed(p, mean[i].v[0], mean[i].v[1], mean[i].v[2]);
    }
}

static void make_allan(void *p)
{
    if (invcal_allan_init(p, sizeof(invcal_allan)) != INVCAL_OK) {
        abort();
    }
    for (int32_t i = 0; i < 1000; i++) {
        invcal_allan_feed(p, i * 7919 % 101);
    }
}

static void make_noise(void *p)
{
    invcal_allan allan;

    make_allan(&allan);
    if (invcal_allan_solve(&allan, 100, p) != INVCAL_OK) {
        abort();
    }
}

static void make_frame(void *p)
{
    const invcal_real up[2][3] = {{0, 0, 1}, {1, 0, 0}};
    const invcal_real raw[2][3] = {{0, 0, 16384}, {16384, 0, 0}};

    invcal_frame_init(p);
    for (unsigned i = 0; i < 2; i++) {
        (void)invcal_frame_add(p, &nominal, raw[i], up[i]);
    }
}

static void make_plan(void *p)
{
    if (invcal_plan_init(p, 6) != INVCAL_OK) {
        abort();
    }
}

static void make_thermal(void *p)
{
    invcal_positions positions;
    invcal_quality quality;

    make_positions(&positions, 36);
    if (invcal_thermal_calibrate(&positions, 1, p, &quality) != INVCAL_OK) {
        abort();
    }
}

/* What an _init function begins, and keeps state in. */
static const char *const begun[] = {"invcal_session", "invcal_background", "invcal_imu",
                                    "invcal_allan", "invcal_magnetometer"};

static const struct {
    const char *type;
    void (*make)(void *object);
} makers[] = {
    {"invcal_calibration", make_calibration},
    {"invcal_positions", make_good_positions},
    {"invcal_quality", make_good_quality},
    {"invcal_session", make_good_session},
    {"invcal_background", make_background},
    {"invcal_store", make_store},
    {"invcal_sums", make_sums},
    {"invcal_record", make_record},
    {"invcal_directions", make_directions},
    {"invcal_imu", make_imu},
    {"invcal_magnetometer", make_magnetometer},
    {"invcal_allan", make_allan},
    {"invcal_noise", make_noise},
    {"invcal_frame", make_frame},
    {"invcal_plan", make_plan},
    {"invcal_thermal", make_thermal},
};
