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
};
