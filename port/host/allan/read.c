/* SPDX-License-Identifier: MIT
 *
 * One pass over the log: the Allan deviation of each axis, and whether the sensor was at rest.
 */
#include <math.h>
#include <string.h>

#include "allan/allan.h"
#include "cli/command.h"
#include "cli/message.h"
#include "read/motion.h"
#include "cli/progress.h"

#define TAU_TOLERANCE 1e-6 /* relative: --tau is a multiple of the interval if it is this close */
#define UNREACHABLE 1e-3   /* of the smallest deviation: a sigma below any floor */
#define FLOOR_SQUARE 0.44127120 /* 2 ln 2 / pi */

/* Too large for the stack. */
static samples input;
static motion motion_seen;
static invcal_allan stream[3];

/* ---- averaging times --------------------------------------------------------------------------- */

/* The stride of windows of m samples (invcal/allan.h). */
static uint32_t stride_of(uint32_t m)
{
    uint32_t stride = 1;

    while (m > stride * INVCAL_PRIVATE_OVERLAP) {
        stride *= 2;
    }
    return stride;
}

static int refuse_tau(double tau, double rate, const char *what, double interval)
{
    return message_usage("allan", "--tau: %.9g s at %.9g samples per second %s %.9g s", tau, rate,
                         what, interval);
}

/* One averaging time in samples. */
static int find_length(double tau, double rate, uint32_t *m)
{
    const double length = nearbyint(tau * rate);

    if (!(length >= 1) || fabs(tau * rate - length) > TAU_TOLERANCE * length) {
        return refuse_tau(tau, rate, "is not a multiple of the interval,", 1 / rate);
    }
    if (!(length <= INVCAL_ALLAN_LONGEST)) {
        return refuse_tau(tau, rate, "is beyond", INVCAL_ALLAN_LONGEST / rate);
    }
    *m = (uint32_t)length;
    const uint32_t stride = stride_of(*m);
    if (*m % stride != 0) {
        return refuse_tau(tau, rate, "must be a multiple of", stride / rate);
    }
    return EXIT_GOOD;
}

static int begin_streams(const allan_settings *settings, double rate)
{
    uint32_t m[INVCAL_ALLAN_TAUS];

    for (unsigned k = 0; k < settings->taus; k++) {
        const int failure = find_length(settings->tau[k], rate, &m[k]);
        if (failure) {
            return failure;
        }
    }
    for (unsigned i = 0; i < 3; i++) {
        const invcal_status status =
            settings->taus > 0 ? invcal_allan_init_taus(&stream[i], sizeof stream[i], m,
                                                        settings->taus, settings->is_apart)
                               : invcal_allan_init(&stream[i], sizeof stream[i]);
        if (status != INVCAL_OK) {
            return message_usage("allan", "--tau: must ascend, at most %u times",
                                 (unsigned)INVCAL_ALLAN_TAUS);
        }
    }
    return EXIT_GOOD;
}

/* ---- the pass ---------------------------------------------------------------------------------- */

static void add_sample(allan_result *r, const sample *s)
{
    if (r->samples == 0) {
        r->from = s->clock;
    }
    r->to = s->clock;
    r->gaps += r->samples > 0 && s->is_gap;
    for (unsigned i = 0; i < 3; i++) {
        if (s->is_gap) {
            invcal_allan_gap(&stream[i]);
        }
        invcal_allan_feed(&stream[i], s->raw[i]);
    }
    motion_add(&motion_seen, s);
    r->samples++;
}

static int read_all(allan_result *r, const allan_settings *settings)
{
    sample s;
    int more;

    motion_begin(&motion_seen);
    while ((more = samples_next(&input, &s)) == 1) {
        progress_show(input.table.file, input.table.line, PROGRESS_ROWS);
        if (s.clock >= settings->from && s.clock <= settings->to) {
            add_sample(r, &s);
        }
    }
    progress_end();
    if (more == 0 && r->samples == 0) {
        message("%s: no sample within --from and --to; the log ends at %.9g s", input.table.name,
                s.clock);
        return EXIT_DATA;
    }
    return more < 0 ? EXIT_FILE : EXIT_GOOD;
}

static int check_rest(const allan_result *r)
{
    motion_place where;

    if (motion_find(&motion_seen, &where)) {
        message("%s:%lu: not at rest: at %.6g s the readings of %c %s; choose the part at rest "
                "with --from and --to",
                r->name, where.line, where.clock, "xyz"[where.axis],
                where.is_shaking ? "scatter far more than elsewhere" : "change their level");
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}

/* ---- the result -------------------------------------------------------------------------------- */

/* Units of the result per input unit. */
static double find_unit(allan_result *r, const allan_settings *settings)
{
    const double field = settings->gravity > 0 ? settings->gravity : UNIT_STANDARD_GRAVITY;

    if (r->seen.is_gyro) {
        r->gravity = (double)NAN;
        r->rate_unit = settings->lsb > 0 ? 1 : r->seen.rate_unit;
        r->unit =
            r->rate_unit > 0 ? unit_angular_rate_words(r->rate_unit) : unit_words(r->seen.unit);
        return settings->lsb > 0 ? settings->lsb : 1;
    }
    if (settings->unit != UNIT_UNKNOWN) {
        r->seen.unit = settings->unit;
        r->seen.unit_from = UNIT_FROM_OPTION;
    }
    const double scale = settings->lsb > 0        ? settings->lsb
                         : unit_is_gravity(field) ? unit_scale(r->seen.unit, field)
                                                  : 0;
    r->is_ms2 = scale > 0 && unit_is_gravity(field);
    r->gravity = scale > 0 || settings->gravity > 0 ? field : (double)NAN;
    r->unit = r->is_ms2 ? "m/s²" : scale > 0 ? "field units" : unit_words(r->seen.unit);
    return scale > 0 ? scale : 1;
}

/* One averaging time of all axes. Returns 0 if it has no differences, or if their sum is too
 * large. */
static int find_row(allan_row *row, unsigned k, double rate, double unit)
{
    invcal_allan_point p;

    for (unsigned i = 0; i < 3; i++) {
        if (invcal_allan_get(&stream[i], k, &p) != INVCAL_OK) {
            return 0;
        }
        row->adev[i] = unit * p.adev;
    }
    row->seconds = p.m / rate; /* this and the following are the same on all axes */
    row->count = p.count;
    row->edf = p.edf;
    row->relative = p.relative;
    return 1;
}

static void find_rows(allan_result *r, unsigned taus, double unit)
{
    while (r->rows < taus && find_row(&r->row[r->rows], r->rows, r->rate, unit)) {
        r->rows++;
    }
}

static int find_noise(allan_result *r, double unit)
{
    for (unsigned i = 0; i < 3; i++) {
        invcal_noise *n = &r->noise[i];
        if (r->samples > 1 && motion_is_frozen(&motion_seen, i)) {
            message("%s: %c never changes: its noise is less than one count, or it is not read",
                    r->name, "xyz"[i]);
            return EXIT_DATA;
        }
        if (invcal_allan_solve(&stream[i], r->rate, n) != INVCAL_OK) {
            message("%s: %lu sample%s no noise of %c at these averaging times: log longer, at rest",
                    r->name, r->samples, r->samples == 1 ? " shows" : "s show", "xyz"[i]);
            return EXIT_DATA;
        }
        n->minimum *= unit;
        for (unsigned k = 0; k < INVCAL_NOISE_KINDS; k++) {
            n->coefficient[k] *= unit;
        }
    }
    return EXIT_GOOD;
}

/* The kind of noise, `first` or a later one, that contributes most to the deviation after tau. */
static unsigned find_limit(const invcal_noise *n, double tau, unsigned first)
{
    const double *c = n->coefficient;
    const double part[] = {c[0] * c[0] / tau, FLOOR_SQUARE * c[1] * c[1], c[2] * c[2] * tau / 3};
    unsigned max = first;

    for (unsigned k = first + 1; k < INVCAL_NOISE_KINDS; k++) {
        max = part[k] > part[max] ? k : max;
    }
    return max;
}

static int find_dwell(const invcal_noise *n, double wanted, allan_dwell *out)
{
    static const allan_end ends[] = {ALLAN_REACHED, ALLAN_BEYOND, ALLAN_FLOOR};
    invcal_dwell d = {n->longest, invcali_noise_sigma(n, n->longest), INVCAL_DWELL_REACHED};
    const int has_floor = (n->visible >> INVCAL_NOISE_WHITE) > 1;

    if (wanted > 0 || has_floor) {
        if (invcal_noise_dwell(n, wanted > 0 ? wanted : UNREACHABLE * n->minimum, &d) !=
            INVCAL_OK) {
            return EXIT_DATA;
        }
    }
    *out = (allan_dwell){.seconds = d.seconds, .sigma = d.sigma};
    out->end = wanted > 0 || has_floor ? ends[d.end] : ALLAN_LONGEST;
    /* white noise averages out, so it cannot limit a floor */
    out->limit = find_limit(
        n, d.seconds, out->end == ALLAN_FLOOR ? INVCAL_NOISE_INSTABILITY : INVCAL_NOISE_WHITE);
    return EXIT_GOOD;
}

/* Whether dwell a is worse than b: one at a floor is; of two at a floor, or two longest times, that
 * of the larger sigma; else the longer one. */
static int is_worse(const allan_dwell *a, const allan_dwell *b)
{
    if ((a->end == ALLAN_FLOOR) != (b->end == ALLAN_FLOOR)) {
        return a->end == ALLAN_FLOOR;
    }
    return a->end == ALLAN_FLOOR || a->end == ALLAN_LONGEST ? a->sigma > b->sigma
                                                            : a->seconds > b->seconds;
}

static int find_dwells(allan_result *r, double wanted)
{
    for (unsigned i = 0; i < 3; i++) {
        if (find_dwell(&r->noise[i], wanted, &r->dwell[i])) {
            message("%s: --sigma %.6g: %c would need too long a time", r->name, wanted, "xyz"[i]);
            return EXIT_DATA;
        }
        if (is_worse(&r->dwell[i], &r->dwell[r->worst])) {
            r->worst = i;
        }
    }
    return EXIT_GOOD;
}

/* A gyroscope has the unit of its header, or that of --lsb. */
static int check_gyro(const allan_result *r, const allan_settings *settings)
{
    const char *option = settings->unit != UNIT_UNKNOWN               ? "--unit"
                         : settings->gravity > 0                      ? "--gravity"
                         : settings->lsb > 0 && r->seen.rate_unit > 0 ? "--lsb"

                                                                      : NULL;

    return r->seen.is_gyro && option
               ? message_usage("allan", "%s: %s %s %s are columns of a gyroscope%s: leave it out",
                               option, r->seen.name[COLUMN_X], r->seen.name[COLUMN_Y],
                               r->seen.name[COLUMN_Z],
                               r->seen.rate_unit > 0 ? ", whose unit the header states"
                                                     : "; --lsb states rad/s per input unit")
               : EXIT_GOOD;
}

static int evaluate(allan_result *r, const allan_settings *settings)
{
    int failure = check_gyro(r, settings);
    failure = failure ? failure : check_rest(r);

    if (failure) {
        return failure;
    }
    const double unit = find_unit(r, settings) * input.unit;
    find_rows(r, settings->taus > 0 ? settings->taus : INVCAL_ALLAN_TAUS, unit);
    failure = find_noise(r, unit);
    return failure ? failure : find_dwells(r, settings->sigma);
}

int allan_read(allan_result *r, const allan_settings *settings)
{
    int failure = samples_open(&input, settings->file, COLUMNS_LOG, settings->rate, 0);

    *r = (allan_result){.name = input.table.name, .rate = input.rate};
    if (!failure && !input.is_rate_known) {
        failure = message_usage("allan", "--rate: is needed, because %s has no times", r->name);
    }
    failure = failure ? failure : begin_streams(settings, r->rate);
    failure = failure ? failure : read_all(r, settings);
    r->seen = input.where.seen;
    r->bytes = input.table.bytes;
    r->crc = input.table.crc;
    samples_close(&input);
    return failure ? failure : evaluate(r, settings);
}
