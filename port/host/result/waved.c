/* SPDX-License-Identifier: MIT
 *
 * What is to be said of a magnetometer that was waved.
 */
#include "result/result.h"
#include "text/paint.h"
#include "text/plain.h"
#include "text/wrapped.h"

void calibrate_waved_print(FILE *file, const calibrate_result *result)
{
    const waved *m = result->magnetometer;
    char name[PLAIN_MAX];

    wrapped_printf(file, 0, "%s: %lu samples, %.6g s at %.4g samples a second%s",
                   plain_copy(result->data->name, name), m->samples, m->seconds, m->rate,
                   m->is_rate_known ? "" : " (a guess: --rate states it)");
    wrapped_printf(file, 9,
                   "%*u of %u directions covered; neighbours err alike: %.0f samples tell as one",
                   8, m->found.covered, INVCAL_CELLS, m->found.alike > 1 ? m->found.alike : 1);
    if (m->found.left_out > 0) {
        fprintf(file, "%*lu samples left out, which contradict the others\n", 8,
                (unsigned long)m->found.left_out);
    }
    if (m->found.disturbance != INVCAL_UNDISTURBED) {
        wrapped_printf(file, 0, "%sDisturbed:%s %s.", paint_on(file, PAINT_RED), paint_off(file),
                       invcal_disturbance_text((invcal_disturbance)m->found.disturbance));
    }
}

const char *calibrate_waved_fault(const calibrate_result *result, char text[CALIBRATE_LIMIT_MAX])
{
    const invcal_magnetometer_found *f = &result->magnetometer->found;
    char words[INVCAL_WORDS];

    if (result->quality.verdict == INVCAL_WEAK && f->gap > 45) {
        const double up[3] = {-result->magnetometer->next[0], -result->magnetometer->next[1],
                              -result->magnetometer->next[2]};
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "%u degrees of the sphere were never passed through. North of the equator hold it "
                 "%s, and swing it around.",
                 f->gap, invcal_words(up, words));
    } else if (f->disturbance > INVCAL_PASSING) {
        snprintf(text, CALIBRATE_LIMIT_MAX, "%s.",
                 invcal_disturbance_text((invcal_disturbance)f->disturbance));
    } else {
        snprintf(text, CALIBRATE_LIMIT_MAX,
                 "%lu of %lu samples contradict the others: repeat it away from iron and magnets.",
                 (unsigned long)f->left_out, (unsigned long)(f->left_out + f->samples));
    }
    return text;
}

void calibrate_waved_json(json_writer *w, const calibrate_result *result)
{
    static const char *const names[] = {"none", "passing", "places", "step"};
    const invcal_magnetometer_found *f = &result->magnetometer->found;

    json_object(w, "magnetometer");
    json_number(w, "samples", f->samples);
    json_number(w, "left_out", f->left_out);
    json_number(w, "covered", f->covered);
    json_number(w, "gap", f->gap);
    json_vector(w, "next", result->magnetometer->next);
    json_number(w, "sample_rms", f->rms);
    json_number(w, "alike", f->alike);
    json_text(w, "disturbance", names[f->disturbance]);
    json_object_end(w);
}
