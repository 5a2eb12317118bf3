/* SPDX-License-Identifier: MIT */
#include "allan/allan.h"
#include "cli/command.h"
#include "text/json_write.h"
#include "text/number.h"

static const char *const axes[] = {"x", "y", "z"};

static void write_rows(json_writer *w, const allan_result *r)
{
    double list[INVCAL_ALLAN_TAUS];

    for (unsigned k = 0; k < r->rows; k++) {
        list[k] = r->row[k].seconds;
    }
    json_numbers(w, "tau", list, r->rows);
    json_object(w, "adev");
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned k = 0; k < r->rows; k++) {
            list[k] = r->row[k].adev[i];
        }
        json_numbers(w, axes[i], list, r->rows);
    }
    json_object_end(w);
    for (unsigned k = 0; k < r->rows; k++) {
        list[k] = r->row[k].count;
    }
    json_numbers(w, "count", list, r->rows);
    for (unsigned k = 0; k < r->rows; k++) {
        list[k] = r->row[k].edf;
    }
    json_numbers(w, "edf", list, r->rows);
    for (unsigned k = 0; k < r->rows; k++) {
        list[k] = r->row[k].relative;
    }
    json_numbers(w, "relative", list, r->rows);
}

static void write_noise(json_writer *w, const invcal_noise *n)
{
    static const char *const kinds[][2] = {{"white", "white_relative"},
                                           {"instability", "instability_relative"},
                                           {"walk", "walk_relative"}};

    for (unsigned k = 0; k < INVCAL_NOISE_KINDS; k++) {
        json_number(w, kinds[k][0], n->coefficient[k]);
        json_number(w, kinds[k][1], n->visible >> k & 1u ? n->relative[k] : NUMBER_UNKNOWN);
    }
    json_number(w, "misfit", n->misfit);
    json_number(w, "minimum", n->minimum);
    json_number(w, "best", n->best);
    json_number(w, "shortest", n->shortest);
    json_number(w, "longest", n->longest);
}

static void write_dwell(json_writer *w, const allan_result *r, const allan_settings *settings)
{
    static const char *const ends[] = {"reached", "beyond", "floor", "longest"};
    const allan_dwell *d = &r->dwell[r->worst];

    json_number(w, "dwell", d->seconds);
    json_number(w, "dwell_sigma", d->sigma);
    json_text(w, "dwell_axis", axes[r->worst]);
    json_text(w, "dwell_end", ends[d->end]);
    json_text(w, "dwell_limit", allan_kinds[d->limit]);
    if (settings->sigma > 0) {
        json_number(w, "wanted", settings->sigma);
    }
}

void allan_json(FILE *file, const allan_result *r, const allan_settings *settings)
{
    json_writer w;
    char crc[16];

    snprintf(crc, sizeof crc, "%08lx", (unsigned long)r->crc);
    json_begin(&w, file);
    json_text(&w, "invcal", INVCAL_VERSION);
    json_text(&w, "source_file", r->name);
    json_text(&w, "source_crc", crc);
    json_text(&w, "unit",
              r->is_ms2          ? "m/s^2"
              : r->gravity > 0   ? "field"
              : r->rate_unit > 0 ? unit_angular_rate_name(r->rate_unit)
                                 : "input");
    json_number(&w, "gravity", r->gravity);
    json_number(&w, "rate", r->rate);
    json_number(&w, "samples", (double)r->samples);
    json_number(&w, "gaps", (double)r->gaps);
    json_number(&w, "from", r->from);
    json_number(&w, "to", r->to);
    json_text(&w, "estimator", allan_estimator(settings));
    write_rows(&w, r);
    json_object(&w, "noise");
    for (unsigned i = 0; i < 3; i++) {
        json_object(&w, axes[i]);
        write_noise(&w, &r->noise[i]);
        json_object_end(&w);
    }
    json_object_end(&w);
    write_dwell(&w, r, settings);
    json_end(&w);
}
