/* SPDX-License-Identifier: MIT
 *
 * export/format.h: a calibration in the formats of other systems.
 *
 * To add a format: one export_format in a file of its own, one line here, one in export.c's
 * table. The comment above it derives the mapping from the system's own source.
 */
#ifndef EXPORT_FORMAT_H
#define EXPORT_FORMAT_H

#include <stdio.h>

#include "result/calibration_file.h"

/* What is exported, and what the command line adds. */
typedef struct {
    calibration_file file;
    const char *source;        /* name of the file, for messages and comments */
    const char *format;        /* name of the format */
    const char *name;          /* --name; null: the format's own */
    double si;                 /* m/s^2 per field unit; 0: the field is no acceleration */
    const char *driver_from;   /* source of the driver's scale, in words */
    invcal_calibration driver; /* from the driver's readings, m/s^2, to calibrated, m/s^2 */
    unsigned instance;         /* of the sensor, from 0 */
    double device_id;          /* NUMBER_UNKNOWN: leave the system's own alone */
} export_job;

/* What a format needs, and so which options it has. */
enum {
    EXPORT_NAMED = 1,        /* --name */
    EXPORT_GRAVITY = 2,      /* the length of the field must be known */
    EXPORT_ACCELERATION = 4, /* accelerometers only */
    EXPORT_DRIVER = 8,       /* readings in m/s^2, as the driver delivers them: --zero, --lsb */
    EXPORT_INSTANCE = 16,    /* --instance, --device-id */
    EXPORT_GYRO = 32         /* the file must hold a gyroscope */
};

typedef struct {
    const char *name;
    unsigned takes;
    /* Refuses, with a message, a calibration that the system could not use; prints warnings.
     * Null: accepts everything. Returns an exit code. */
    int (*check)(const export_job *job);
    void (*write)(FILE *file, const export_job *job);
} export_format;

extern const export_format export_c;
extern const export_format export_c_arrays;
extern const export_format export_px4;
extern const export_format export_ardupilot;
extern const export_format export_ros;
extern const export_format export_imu_tk;
extern const export_format export_imu_tk_gyro;
extern const export_format export_fusion;

#endif
