/* SPDX-License-Identifier: MIT */
#include "simulate/wave_write.h"

#include "cli/output.h"
#include "text/json_write.h"
#include "text/unit.h"

int wave_write_log(wave *w)
{
    wave_sample s;

    printf("t,ax,ay,az,mx (uT),my (uT),mz (uT)\n");
    while (wave_next(w, &s) && !ferror(stdout)) {
        printf("%.6f,%ld,%ld,%ld,%.3f,%.3f,%.3f\n", s.time, (long)s.raw[0], (long)s.raw[1],
               (long)s.raw[2], s.field[0], s.field[1], s.field[2]);
    }
    return output_flush();
}

void wave_write_truth(FILE *file, const wave *w)
{
    const wave_model *m = w->model;
    const invcal_calibration truth = wave_truth(m);
    const invcal_calibration accelerometer = scene_truth(w->accelerometer);
    double delta[3];
    double axes[3][3];
    json_writer json;

    wave_axes(m, axes);
    for (unsigned i = 0; i < 3; i++) {
        delta[i] = m->hard[i] / m->field[0];
    }
    json_begin(&json, file);
    json_text(&json, "invcal", INVCAL_VERSION);
    json_number(&json, "gravity", m->field[0]);
    json_vector(&json, "offset", truth.offset);
    json_matrix(&json, "matrix", truth.matrix);
    json_vector(&json, "delta", delta);
    json_vector(&json, "dk", m->soft);
    json_vector(&json, "gamma", &m->soft[3]);
    json_number(&json, "noise", m->noise / m->field[0]);
    json_number(&json, "rate", w->accelerometer->rate);
    json_object(&json, "magnetometer");
    json_number(&json, "dip", m->field[1] * UNIT_DEGREE);
    json_matrix(&json, "rotation", (const double(*)[3])axes);
    json_object_end(&json);
    json_object(&json, "accelerometer");
    json_number(&json, "gravity", w->accelerometer->field);
    json_vector(&json, "offset", accelerometer.offset);
    json_matrix(&json, "matrix", accelerometer.matrix);
    json_object_end(&json);
    json_end(&json);
}
