/* SPDX-License-Identifier: MIT */
#include "apply/thermal_correction.h"

#include <math.h>

#include "cli/message.h"
#include "text/number.h"

void thermal_correction_begin(thermal_correction *c, const calibration_file *file)
{
    *c = (thermal_correction){.file = file,
                              .current = file->calibration,
                              .temperature = NUMBER_UNKNOWN,
                              .coldest = file->thermal.min,
                              .warmest = file->thermal.max};
}

const invcal_calibration *thermal_correction_at(thermal_correction *c, double temperature)
{
    invcal_calibration here;

    if (!c->file->has_thermal) {
        return &c->current;
    }
    c->readings++;
    const double margin = THERMAL_CORRECTION_MARGIN * (c->file->thermal.max - c->file->thermal.min);
    c->below += temperature < c->file->thermal.min - margin;
    c->above += temperature > c->file->thermal.max + margin;
    c->coldest = fmin(c->coldest, temperature);
    c->warmest = fmax(c->warmest, temperature);
    /* It is valid at both ends of its range (calibration_file.c); if it is not in between, the last
     * one is kept. */
    if (!(fabs(temperature - c->temperature) <= THERMAL_CORRECTION_STEP) &&
        calibration_file_at(c->file, temperature, &here)) {
        c->current = here;
        c->temperature = temperature;
    }
    return &c->current;
}

void thermal_correction_end(const thermal_correction *c, const char *log)
{
    const invcal_thermal *t = &c->file->thermal;
    const double farthest = fmax(t->min - c->coldest, c->warmest - t->max);

    if (c->below + c->above > 0) {
        message("warning: %s: %lu of %lu readings are up to %.3g K outside %.6g ... %.6g °C, the "
                "range of the calibration: they are corrected as at its edge",
                log, c->below + c->above, c->readings, farthest, t->min, t->max);
    }
}
