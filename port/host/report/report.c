/* SPDX-License-Identifier: MIT */
#include "report/report.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "cli/command.h"
#include "fit/gravity.h"
#include "cli/input.h"
#include "result/faces.h"
#include "text/number.h"
#include "cli/options.h"
#include "design/parameters.h"
#include "report/facts.h"
#include "result/need.h"
#include "result/pass.h"
#include "result/verdict.h"

#define TEXT_MAX 800
#define SUPPORT_MAX 200

/* ---- the verdict ------------------------------------------------------------------------------- */

/* ± of the length in the worst direction, including that of the field. */
static const char *worst_spread(const report_facts *f, char text[FIGURE_MAX])
{
    return figure_digits(hypot(f->length_worst, f->field_spread), 2, text);
}

/* The part of it that is from the field. */
static const char *part_of_field(const report_facts *f, char text[SUPPORT_MAX])
{
    char spread[FIGURE_MAX];

    text[0] = '\0';
    if (f->field_spread > 0) {
        snprintf(text, SUPPORT_MAX, " (±%s %s of it is from %s itself%s)",
                 figure_digits(f->field_spread, 2, spread), f->unit,
                 f->is_gravity ? "g" : "the field",
                 f->result->is_field_stated ? "" : "; --gravity or --latitude reduces it");
    }
    return text;
}

/* What confirms the result. */
static void describe_support(const report_facts *f, char text[SUPPORT_MAX])
{
    const fit_quality *q = &f->result->quality;
    char list[128];

    if (q->from_prior) {
        snprintf(text, SUPPORT_MAX, "but %s by the prior rather than by the positions",
                 parameters_list(q->from_prior, list, sizeof list));
    } else {
        snprintf(text, SUPPORT_MAX, "and redundant positions confirm them");
    }
}

static void describe_good(const report_facts *f, char *text)
{
    const rejection *rejected = &f->result->rejected;
    const unsigned count = rejected->count - rejection_drifting(rejected);
    char spread[FIGURE_MAX];
    char left_out[128] = "";
    char support[SUPPORT_MAX];
    char field[SUPPORT_MAX];
    char where[64] = "";

    if (f->result->temperature == CALIBRATE_THERMAL) {
        snprintf(where, sizeof where, " at %.2f °C", f->result->fit.calibration.reference);
    }
    if (count > 0) {
        snprintf(left_out, sizeof left_out, " %u position%s the others and %s left out.", count,
                 count == 1 ? " contradicts" : "s contradict", count == 1 ? "is" : "are");
    }
    describe_support(f, support);
    snprintf(text, TEXT_MAX,
             "All nine parameters are determined, %s. The length of corrected readings%s matches "
             "%s within ±%s %s in every direction, apart from their noise%s.%s",
             support, where, f->is_gravity ? "gravity" : "the field", worst_spread(f, spread),
             f->unit, part_of_field(f, field), left_out);
}

static void describe_weak(const report_facts *f, char *text)
{
    char list[128];
    char spread[FIGURE_MAX];

    snprintf(text, TEXT_MAX,
             "The positions hardly determine %s: rely on the calibration only within its ±. In the "
             "worst direction (%s), the length of a corrected reading is uncertain by ±%s %s.",
             parameters_list(f->result->quality.weak, list, sizeof list),
             f->length_spread.worst_words, worst_spread(f, spread),
             f->knows_noise ? f->unit : "times the noise of a position mean");
}

/* What to do with a good calibration. */
static void describe_use(const report_facts *f, char *text, size_t size)
{
    const char *saved = f->invocation->saved;
    char path[MESSAGE_MAX];

    snprintf(text, size, "%scorrect readings with invcal apply %s LOG.",
             saved ? "" : "save it with --out CAL.json, and ",
             options_quoted(saved ? saved : "CAL.json", path, sizeof path));
}

/* The box of the verdict, with the outcome of --need and --tolerance. */
static void write_box(page *p, const report_facts *f, page_severity severity, const char *word,
                      const char *sentence, const char *next)
{
    char text[PASS_MAX];
    char advice[NEED_MAX] = "";
    char more[2 * TEXT_MAX + NEED_MAX];
    const page_answer answer = {f->outcome.has_criteria ? pass_text(f->result, text) : NULL,
                                f->outcome.is_passed};

    if (f->result->need > 0) {
        (void)need_advice(f->result, advice);
    }
    snprintf(more, sizeof more, "%s%s%s", sentence, *advice ? " " : "", advice);
    page_verdict_with_answer(p, severity, word, &answer, more, next);
}

static void write_weak(page *p, const report_facts *f)
{
    char sentence[TEXT_MAX];
    char next[TEXT_MAX];
    char advice[128];

    describe_weak(f, sentence);
    if (calibrate_lacks_slopes(f->result)) {
        snprintf(next, sizeof next,
                 "measure nine positions or more at each of two temperatures, at least 5 K apart.");
    } else {
        snprintf(next, sizeof next, "add positions with %s. Begin with: %s.",
                 parameters_advice(f->result->quality.weak, advice, sizeof advice), f->next_words);
    }
    write_box(p, f, PAGE_BAD, "✗ Weak", sentence, next);
}

static void write_six_faces(page *p, const report_facts *f)
{
    char cost[VERDICT_MAX];
    char sentence[TEXT_MAX];

    snprintf(sentence, sizeof sentence, "%s", faces_cost(f->result, cost));
    sentence[0] = (char)toupper((unsigned char)sentence[0]);
    page_verdict(p, PAGE_CAUTION, "! Good for offsets and scales", sentence,
                 "to measure the angles, add six positions and leave out --six-faces: " FACES_EDGES
                 ".");
}

static void write_verdict(page *p, const report_facts *f)
{
    const invcal_verdict verdict = f->result->quality.verdict;
    const char *word = verdict_word(f->result);
    char marked[64];
    char sentence[TEXT_MAX];
    char next[MESSAGE_MAX + TEXT_MAX];
    char text[VERDICT_MAX];

    if (faces_are_good(f->result)) {
        write_six_faces(p, f);
    } else if (strcmp(word, "Good") == 0) {
        describe_good(f, sentence);
        describe_use(f, next, sizeof next);
        write_box(p, f, PAGE_GOOD, "✓ Good", sentence, next);
        if (*verdict_unchecked(f->result, text)) {
            page_say(p, "%s", text);
        }
    } else if (verdict == INVCAL_NO_REDUNDANCY && !f->result->magnetometer) {
        snprintf(next, sizeof next,
                 "add three or more positions in other directions. Begin with: %s.", f->next_words);
        write_box(p, f, PAGE_CAUTION, "! No redundancy",
                  "All nine parameters are determined, but there is no redundancy: nothing checks "
                  "the result, and one wrong position would spoil it unnoticed.",
                  next);
    } else if (verdict == INVCAL_WEAK && !f->result->magnetometer) {
        write_weak(p, f);
    } else {
        const int is_bad = verdict >= INVCAL_DRIFTING;
        snprintf(marked, sizeof marked, "%s %s", is_bad ? "✗" : "!", word);
        (void)verdict_cause(f->result, sentence);
        sentence[0] = (char)toupper((unsigned char)sentence[0]);
        write_box(p, f, is_bad ? PAGE_BAD : PAGE_CAUTION, marked, sentence,
                  verdict_remedy(f->result, text));
    }
}

/* The error of lengths before and after. Before needs a nominal calibration; after needs
 * redundancy, or it is always zero. */
static void write_improvement(page *p, const report_facts *f)
{
    const calibrate_result *r = f->result;
    char text[128];
    char before[FIGURE_MAX];
    char after[FIGURE_MAX];
    char what[128];

    if (!(r->quality.dof > 0)) {
        return;
    }
    snprintf(text, sizeof text, "%s%s%s %s",
             f->has_before ? figure_digits(f->scale * r->residual_before, 3, before) : "",
             f->has_before ? " → " : "", figure_digits(f->scale * r->quality.rms, 3, after),
             f->unit);
    snprintf(what, sizeof what, "rms error of %s in these positions, %s", f->length,
             f->has_before ? "before and after" : "calibrated");
    page_figure(p, text, what);
}

static void write_figures(page *p, const report_facts *f)
{
    const calibrate_result *r = f->result;
    char text[128];
    char number[FIGURE_MAX];
    char what[128];

    page_figures_begin(p);
    write_improvement(p, f);
    snprintf(text, sizeof text, "%u", r->data->count);
    snprintf(what, sizeof what,
             r->magnetometer     ? "direction cells with samples"
             : r->rejected.count ? "positions, %u of them left out"
                                 : "positions",
             r->rejected.count);
    page_figure(p, text, what);
    if (f->knows_noise) {
        snprintf(text, sizeof text, "%s %s", figure_digits(f->noise, 3, number), f->unit);
        page_figure(p, text, "noise of a position mean");
    }
    page_figures_end(p);
}

/* ---- how it was made --------------------------------------------------------------------------- */

static void write_nominal(page *p, const report_facts *f)
{
    const nominal_choice *n = &f->result->nominal;

    if (!nominal_is_stated(n)) {
        page_fact(p, f->invocation->nominal_name,
                  "unknown; state --sensor, --unit, or --zero and --lsb");
    } else if (n->zero == n->lsb) {
        page_fact(p, f->invocation->nominal_name, "zero and scale %s",
                  nominal_origin_text(n->zero));
    } else {
        page_fact(p, f->invocation->nominal_name, "zero %s, scale %s", nominal_origin_text(n->zero),
                  nominal_origin_text(n->lsb));
    }
    if (n->sensor.type) {
        char limits[SENSORS_TEXT_MAX];
        page_fact(p, "sensor", "%s at %s", n->sensor.type->name, n->sensor.range->name);
        page_fact(p, "its limits", "%s", sensors_limits_text(&n->sensor, limits));
        page_fact(p, "data sheet", "%s", n->sensor.type->sheet);
    }
}

static void write_temperature(page *p, const report_facts *f)
{
    const positions *data = f->result->data;
    double min = HUGE_VAL;
    double max = -HUGE_VAL;

    for (unsigned n = 0; n < data->count && data->has_temperature; n++) {
        min = fmin(min, data->origin[n].temperature);
        max = fmax(max, data->origin[n].temperature);
    }
    if (min <= max) {
        page_fact(p, "temperature", "%.1f ... %.1f °C, where the result is valid", min, max);
    }
    if (f->result->temperature == CALIBRATE_THERMAL) {
        page_fact(p, "offset and matrix", "at %.2f °C", f->result->fit.calibration.reference);
    }
}

static void write_frame(page *p, const calibrate_result *r)
{
    char axes[CALIBRATE_AXES_MAX];

    if (*calibrate_axes_text(r, axes) != '\0') {
        page_fact(p, "axes", "%s", axes);
    }
    if (r->is_dip_frame) {
        page_fact(p, "frame", "accelerometer: the axes of the accelerometer in the same log");
        return;
    }
    if (r->frame.used > 0) {
        char text[CALIBRATE_LIMIT_MAX];
        page_fact(p, "frame", "%s", calibrate_case_text(r, text));
        return;
    }
    page_fact(p, "frame", "%s",
              r->is_stand_frame ? "stand: rotated to the axes of the stand, by its angles"
              : r->settings.is_triangular
                  ? "triangular: only the x sensor responds to a field along the x axis"
                  : "symmetric: axes as close to the case as possible");
}

/* What limits the accuracy. */
static void write_limit(page *p, const report_facts *f)
{
    char text[CALIBRATE_LIMIT_MAX];

    page_say(p, "Accuracy limited by: %s", calibrate_limit(f->result, &f->length_spread, text));
}

void report_file(page *p, const report_facts *f)
{
    const calibrate_result *r = f->result;
    char seen[COLUMNS_TEXT_MAX];

    page_fact(p, "file", "%s, %llu bytes, CRC-32 %08lx", r->data->name,
              (unsigned long long)r->data->bytes, (unsigned long)r->data->crc);
    page_fact(p, "read as", "%s", columns_describe(&r->data->seen, seen, sizeof seen));
    page_literal(p, "command", f->invocation->command);
    page_fact(p, "invcal", "%s", INVCAL_VERSION);
}

/* The samples of a magnetometer. */
static void write_magnetometer(page *p, const magnetometer_log *m)
{
    page_fact(p, "samples",
              "%lu, %lu left out, in %u of %u direction cells; correlated: %.0f count as one",
              m->samples, (unsigned long)m->found.dropped, m->found.covered, INVCAL_CELLS,
              m->found.alike > 1 ? m->found.alike : 1);
    page_fact(p, "lengths", "differ by %.3g %% rms after calibration", 100 * m->sample_rms);
    if (m->found.disturbance != INVCAL_UNDISTURBED) {
        page_fact(p, "disturbed", "%s", invcal_disturbance_text(m->found.disturbance));
    }
}

static void write_origin(page *p, const report_facts *f)
{
    const calibrate_result *r = f->result;
    char number[NUMBER_TEXT_MAX];

    page_section(p, "How it was made");
    page_facts_begin(p);
    report_file(p, f);
    page_fact(p, "field", "%s %s", number_text(r->settings.field, number), calibrate_field_unit(r));
    if (r->place) {
        page_fact(p, "normal gravity",
                  "at %.6g°, %.6g m, ±%.4f m/s²; its error scales all readings alike", r->place[0],
                  r->place[1], REPORT_NORMAL * GRAVITY_SIGMA);
    }
    if (r->magnetometer) {
        write_magnetometer(p, r->magnetometer);
    } else {
        page_fact(p, "positions", "%u used, %u left out", r->rejected.kept_count,
                  r->rejected.count);
    }
    write_temperature(p, f);
    write_nominal(p, f);
    write_frame(p, r);
    page_fact(p, "condition", "%.4g", r->quality.condition);
    page_fact(p, "degrees of freedom", "%.4g", r->quality.dof);
    if (r->settings.noise > 0) {
        page_fact(p, "noise", "%.3g %s of a position mean, %s",
                  r->settings.noise * r->settings.field, calibrate_field_unit(r),
                  r->is_noise_given ? "stated" : "from the scatter of the samples");
    }
    page_facts_end(p);
    page_note(p, "Lengths do not determine the rotation of the calibrated axes to the case.");
}

/* The meaning of ±, once for the whole page. */
static void write_convention(page *p, const report_facts *f)
{
    if (f->knows_noise) {
        page_note(p,
                  "Every ± on this page is a 95 %% interval: for the parameters, %.2f standard "
                  "deviations.",
                  f->coverage);
    } else {
        page_note(p, "There is no ±, because the noise is unknown: state --noise, or add positions "
                     "for redundancy.");
    }
}

/* The record of the calibration. */
static void write_record(page *p, const record *r)
{
    if (record_is_empty(r)) {
        return;
    }
    page_facts_begin(p);
    for (unsigned k = 0; k < RECORD_TEXTS; k++) {
        if (*r->text[k] != '\0') {
            page_fact(p, record_name((record_text)k), "%s", r->text[k]);
        }
    }
    page_facts_end(p);
}

int report_write(FILE *file, const calibrate_result *result, const calibrate_invocation *invocation)
{
    report_facts f;
    page p;
    char title[TEXT_MAX];
    char head[RECORD_LINE_MAX];
    const int failure = report_facts_find(&f, result, invocation);

    if (!failure) {
        snprintf(title, sizeof title, "Calibration of %.300s", input_file_name(result->data->name));
        page_begin_headed(&p, file, title, record_line(&result->record, head));
        write_record(&p, &result->record);
        write_verdict(&p, &f);
        report_gyro_summary(&p, &f);
        write_convention(&p, &f);
        report_use(&p, &f);
        page_section(&p, "Accuracy");
        write_figures(&p, &f);
        write_limit(&p, &f);
        report_parameters(&p, &f);
        report_positions(&p, &f);
        report_stand(&p, &f);
        report_temperature(&p, &f);
        report_gyro(&p, &f);
        report_sphere(&p, &f);
        report_timeline(&p, &f);
        report_numbers(&p, &f);
        write_origin(&p, &f);
        page_end(&p);
    }
    report_facts_release(&f);
    return failure;
}
