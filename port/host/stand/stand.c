/* SPDX-License-Identifier: MIT */
#include "stand/stand.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/expert.h"
#include "invcal/plan.h"
#include "maths/angles.h"
#include "cli/command.h"
#include "maths/matrix.h"
#include "cli/message.h"
#include "text/number.h"
#include "core/sums.h"
#include "core/system.h"

#define SCATTERED 0.01     /* rad: more than a stand with a scale has, unless */
#define SCATTERED_NOISE 10 /* it is within this multiple of the noise of a mean */
#define MANY_PART 8u       /* one position in 8 misset is many */
#define RADIANS_MAX 12.6   /* two turns */
#define SCATTER_MAX 0.05   /* rad: readings with more do not belong to these directions */

enum { NINE = INVCAL_PARAMETERS };

/* ---- which angles -------------------------------------------------------------------------------- */

int stand_check(const stand_options *options, const positions *data)
{
    if (!options->is_wanted) {
        return EXIT_GOOD;
    }
    if (!options->plan && !data->has_angles) {
        message("%s: --stand needs columns alpha and beta: name them in a header, or state --plan "
                "if the positions are those of a program, in its order",
                data->name);
        return EXIT_FILE;
    }
    if (options->plan && options->plan->count != data->count) {
        const unsigned group = options->plan->plan.per_group;
        message("%s: holds %u positions, but --plan %s has %u: add columns alpha and beta to find "
                "the one that is missing or extra%s",
                data->name, data->count, options->plan->name, options->plan->count,
                group > 0 && data->count + group == options->plan->count
                    ? "; was a whole group not visited?"
                    : "");
        return EXIT_FILE;
    }
    return EXIT_GOOD;
}

/* The angles of a position in the convention of the paper. */
static stand_angles stated_angles(const stand_options *options, const positions *data, unsigned i)
{
    if (options->plan) {
        return (stand_angles){options->plan->position[i].alpha, options->plan->position[i].beta};
    }
    return (stand_angles){options->sense[0] * (data->origin[i].alpha - options->zero[0]),
                          options->sense[1] * (data->origin[i].beta - options->zero[1])};
}

static void collect(stand *s, const stand_options *options, const positions *data,
                    const rejection *kept, const double *raw)
{
    s->may_be_radians = !options->plan;
    for (unsigned k = 0; k < kept->kept_count; k++) {
        const unsigned number = rejection_original(kept, k);
        const stand_angles angle = stated_angles(options, data, number);
        if (isnan(angle.alpha) || isnan(angle.beta)) {
            s->without_angles++;
            continue;
        }
        s->may_be_radians = s->may_be_radians && fabs(data->origin[number].alpha) <= RADIANS_MAX &&
                            fabs(data->origin[number].beta) <= RADIANS_MAX;
        mounting_position *p = &s->position[s->count++];
        *p = (mounting_position){.number = number, .alpha = angle.alpha, .beta = angle.beta};
        memcpy(p->raw, &raw[3 * (size_t)k], sizeof p->raw);
    }
}

static unsigned missing_of(const unsigned *group, unsigned count)
{
    unsigned visited[INVCAL_PLAN_GROUPS + 1] = {0};
    unsigned missing = 0;
    unsigned complete = 0;

    for (unsigned i = 0; i < count; i++) {
        visited[group[i]]++;
    }
    for (unsigned g = 1; g <= INVCAL_PLAN_GROUPS; g++) {
        missing = visited[g] == 0 ? g : missing;
        complete += visited[g] >= INVCAL_PLAN_PER_GROUP_MIN;
    }
    return complete == INVCAL_PLAN_GROUPS - 1 ? missing : 0;
}

unsigned stand_missing_group(const stand_options *options, const positions *data)
{
    mounting_position *p = calloc((size_t)data->count + 1, sizeof *p);
    unsigned *group = calloc((size_t)data->count + 1, sizeof *group);
    unsigned missing = 0;

    if (p && group && (options->plan || data->has_angles)) {
        for (unsigned i = 0; i < data->count; i++) {
            const stand_angles angle = stated_angles(options, data, i);
            p[i].alpha = angle.alpha;
            p[i].beta = angle.beta;
        }
        group_series_groups(p, data->count, group);
        missing = missing_of(group, data->count);
    }
    free(p);
    free(group);
    return missing;
}

/* ---- their convention ---------------------------------------------------------------------------- */

static void apply_convention(stand *s, stand_convention convention)
{
    const int is_swapped = convention == STAND_SWAPPED || convention == STAND_SWAPPED_REVERSED;
    const int is_reversed =
        convention == STAND_BETA_REVERSED || convention == STAND_SWAPPED_REVERSED;

    for (unsigned i = 0; i < s->count; i++) {
        mounting_position *p = &s->position[i];
        const double alpha = is_swapped ? p->beta : p->alpha;
        const double beta = is_swapped ? p->alpha : p->beta;
        angles_direction(alpha, is_reversed ? -beta : beta, p->eta);
        p->is_left_out = 0;
    }
}

static invcal_status try_convention(stand *s, stand_convention convention,
                                    const invcal_calibration *nominal)
{
    apply_convention(s, convention);
    const invcal_status status =
        misset_find(s->position, s->count, nominal, &s->mounting, s->misset, &s->missets);
    return status == INVCAL_OK && !(s->mounting.scatter <= SCATTER_MAX) ? INVCAL_NOT_ELLIPSOID
                                                                        : status;
}

/* As stated, if that fits; else the first convention that does. If many positions would be misset, a
 * convention with fewer of them is better: another one may fit what is left in a few planes. */
static void find_convention(stand *s, const invcal_calibration *nominal)
{
    unsigned fewest = UINT_MAX;

    s->convention = STAND_STRANGE;
    for (stand_convention r = STAND_AS_STATED; r < STAND_STRANGE; r++) {
        const invcal_status status = try_convention(s, r, nominal);
        if (r == STAND_AS_STATED &&
            (status == INVCAL_TOO_FEW || (status != INVCAL_OK && s->count < 6))) {
            s->convention = STAND_FEW;
            return;
        }
        if (status == INVCAL_OK && s->missets < fewest) {
            fewest = s->missets;
            s->convention = r;
        }
        if (fewest <= s->count / MANY_PART) {
            return;
        }
    }
    if (s->convention < STAND_STRANGE) {
        (void)try_convention(s, s->convention, nominal); /* it fitted before */
    }
}

/* ---- the vertical composition -------------------------------------------------------------------- */

/* J + h p = 0 with p = -X. */
static double residual(const mounting_position *p, const mounting *m,
                       const invcal_calibration *nominal, const double x[NINE])
{
    invcali_row row;
    double up[3];
    double u[3];

    mounting_turn(m, p->eta, up);
    invcal_apply(nominal, p->raw[0], p->raw[1], p->raw[2], u);
    double j = u[0] * up[0] + u[1] * up[1] + u[2] * up[2] - 1;
    const invcal_calibration unit = {{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    (void)invcali_observe(&unit, up, &row);
    for (unsigned r = 0; r < NINE; r++) {
        j -= row.h[r] * x[r];
    }
    return j;
}

/* By J1 on the true up directions of the unit: without misset positions, the mounting corrected. */
static void find_vertical(stand *s, const invcal_calibration *nominal)
{
    stand_vertical *v = &s->vertical;
    invcal_directions linear;
    invcal_calibration c;
    double squares = 0;

    invcal_directions_init(&linear);
    for (unsigned i = 0; i < s->count; i++) {
        double up[3];
        mounting_turn(&s->mounting, s->position[i].eta, up);
        if (!s->position[i].is_left_out) {
            (void)invcal_directions_add(&linear, nominal, s->position[i].raw, up);
        }
    }
    invcal_sums sums = linear.sums;
    v->is_known = invcal_directions_solve(&linear, nominal, &c, v->x) == INVCAL_OK;
    if (!v->is_known || !matrix_invert_packed(sums.sum, NINE)) {
        v->is_known = 0;
        return;
    }
    for (unsigned i = 0; i < s->count; i++) {
        const double r = residual(&s->position[i], &s->mounting, nominal, v->x);
        squares += s->position[i].is_left_out ? 0 : r * r;
    }
    v->dof = sums.count - NINE;
    v->noise = v->dof > 0 ? sqrt(squares / v->dof) : NUMBER_UNKNOWN;
    for (unsigned r = 0; r < NINE; r++) {
        v->sigma[r] = v->noise * sqrt(sums.sum[INVCAL_PACKED(r, r)]);
    }
}

/* ---- all results --------------------------------------------------------------------------------- */

static int find_series(stand *s, const invcal_calibration *nominal)
{
    unsigned *group = calloc((size_t)s->count + 1, sizeof *group);

    if (!group) {
        return 0;
    }
    group_series_groups(s->position, s->count, group);
    group_series_find(s->position, group, s->count, &s->mounting, nominal, &s->series);
    free(group);
    return 1;
}

int stand_find(stand *s, const stand_options *options, const positions *data, const rejection *kept,
               const double *raw, const invcal_calibration *nominal, double noise)
{
    *s = (stand){.from = options->plan ? options->plan->name : "columns"};
    memcpy(s->sense, options->sense, sizeof s->sense);
    memcpy(s->zero, options->zero, sizeof s->zero);
    s->position = calloc((size_t)kept->kept_count + 1, sizeof *s->position);
    s->misset = calloc((size_t)kept->kept_count + 1, sizeof *s->misset);
    int is_done = s->position && s->misset;
    if (is_done) {
        collect(s, options, data, kept, raw);
        find_convention(s, nominal);
    }
    if (is_done && s->convention == STAND_AS_STATED && s->mounting.scatter > SCATTERED &&
        !(s->mounting.scatter <= SCATTERED_NOISE * noise)) {
        s->convention = STAND_SCATTERED;
    }
    if (is_done && s->convention == STAND_AS_STATED) {
        find_vertical(s, nominal);
        is_done = find_series(s, nominal);
    }
    if (!is_done) {
        message("%s: not enough memory for %u positions", data->name, data->count);
    }
    return is_done ? EXIT_GOOD : EXIT_FILE;
}

void stand_turn(const stand *s, invcal_calibration *calibration)
{
    const invcal_calibration was = *calibration;
    const double(*r)[3] = s->mounting.turn;

    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            calibration->matrix[i][j] = r[0][i] * was.matrix[0][j] + r[1][i] * was.matrix[1][j] +
                                        r[2][i] * was.matrix[2][j];
        }
    }
}

void stand_free(stand *s)
{
    free(s->position);
    free(s->misset);
    s->position = NULL;
    s->misset = NULL;
}

const char *stand_convention_name(stand_convention convention)
{
    static const char *const names[] = {"as stated",
                                        "beta reversed",
                                        "alpha and beta swapped",
                                        "alpha and beta swapped, beta reversed",
                                        "strange",
                                        "scattered",
                                        "few"};

    return names[convention];
}

const char *stand_advice(const stand *s)
{
    static char text[STAND_ADVICE_MAX];
    static const char *const texts[] = {
        "",
        "the angles fit the readings only with the sense of beta reversed: state --stand-sense "
        "%g,%g (unless an axis of the sensor has the wrong sign).",
        "the angles fit the readings only with alpha and beta swapped: exchange the two columns.",
        "the angles fit the readings only with alpha and beta swapped and the sense of the new "
        "beta reversed: exchange the two columns, and state --stand-sense %g,%g.",
        "the angles do not fit the readings, not even with alpha and beta swapped or a sense "
        "reversed: check the zeros of the angles (--stand-zero) and the order of the positions.",
        "the angles are off by more than 10 mrad (0.6 degrees), root mean square, which is more "
        "than noise: too many positions are misset to tell which. Check all angles, and the order "
        "of the positions.",
        "too few positions have angles to compare."};

    const int is_swapped = s->convention == STAND_SWAPPED_REVERSED;

    if (s->may_be_radians && s->convention == STAND_STRANGE) {
        return "the angles do not fit the readings: are they in radians? Head them alpha (rad) and "
               "beta (rad).";
    }
    if (strcmp(s->from, "columns") != 0 && s->convention >= STAND_BETA_REVERSED &&
        s->convention <= STAND_STRANGE) {
        return "the readings do not fit the angles of the plan: check the order of the positions, "
               "and the senses and zeros of the stand; or add columns alpha and beta.";
    }
    snprintf(text, sizeof text, texts[s->convention], s->sense[is_swapped], -s->sense[!is_swapped]);
    return text;
}
