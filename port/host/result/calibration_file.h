/* SPDX-License-Identifier: MIT
 *
 * result/calibration_file.h: reads what `invcal calibrate --out` wrote.
 */
#ifndef CALIBRATION_FILE_H
#define CALIBRATION_FILE_H

#include "invcal/thermal.h"
#include "result/record.h"

#define CALIBRATION_FILE_WORD 32 /* longer words are cut */
#define CALIBRATION_FILE_NAMES 128

/* Quadratic and cubic errors of the axes (nonlinearity.h). */
typedef struct {
    double term[2][3];          /* of x y z, over the field; without --cubic the latter are 0 */
    double field;               /* its length */
    invcal_calibration nominal; /* whose axes they are of: its matrix, in field units */
} calibration_nonlinear;

/* All that is known of a calibration. A number that the file does not hold is NUMBER_UNKNOWN, a
 * text is "". */
typedef struct {
    invcal_calibration calibration;
    record record;        /* what it is filed under */
    double gravity;       /* length of the field, field units, */
    double gravity_sigma; /* and what it may be wrong by */
    double interval;      /* so many sigma to either side cover 95 % */
    double positions;     /* how many there were */
    double suspected;     /* and how many of them contradict one another */
    char frame[CALIBRATION_FILE_WORD];
    char unit[CALIBRATION_FILE_WORD];      /* of the readings: "g", "mg", "m/s^2", "counts", ... */
    double zero[3];                        /* the nominal calibration: input units, */
    double lsb[3];                         /* field units per input unit, */
    int is_skewed;                         /* and 1 if it also has cross terms, */
    char zero_from[CALIBRATION_FILE_WORD]; /* where it came from: "given", "range", ... */
    char lsb_from[CALIBRATION_FILE_WORD];
    double sigma_offset[3]; /* standard deviations: input units, */
    double sigma_dk[3];     /* of scale errors, */
    double sigma_gamma[3];  /* of angles, rad */
    char verdict[CALIBRATION_FILE_WORD];
    char undetermined[CALIBRATION_FILE_NAMES]; /* names with commas between */
    int is_magnetometer;     /* of one that was waved: of two sensors in a log this is meant */
    int is_field_measured;   /* of such a one: gravity is the mean length of its readings */
    int has_thermal;         /* the calibration is that at the reference temperature of */
    invcal_thermal thermal;  /* over the field, */
    double thermal_field;    /* of this length, */
    int is_triangular;       /* and its frame */
    int has_gyro;            /* there is a gyroscope, too: */
    invcal_calibration gyro; /* input units to rad/s, */
    double
        gyro_g[3]
              [3]; /* of which this, rad/s per field unit, times what is felt is taken off; or 0, */
    int has_gyro_g;
    double gyro_lsb;         /* nominal: rad/s in one, */
    int gyro_is_counts;      /* which has no name */
    double gyro_sigma[3][3]; /* of the matrix over gyro_lsb */
    char gyro_verdict[CALIBRATION_FILE_WORD];
    int has_nonlinear; /* the calibration is what is left for a linear one after */
    calibration_nonlinear nonlinear;
} calibration_file;

/* Reads a JSON object with "offset", 3 numbers in input units, and "matrix", 3 rows of 3 numbers
 * in field units per input unit; other members do not matter. "-" is the standard input.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the file is unreadable or malformed, or the
 * matrix is singular. */
int calibration_file_read(const char *path, invcal_calibration *out);

/* The same with unit, is_magnetometer, has_thermal and thermal, has_nonlinear and nonlinear, has_gyro and gyro, no other
 * members. */
int calibration_file_read_correction(const char *path, calibration_file *out);

/* The same with everything else in it; then the members above are checked as well. */
int calibration_file_read_all(const char *path, calibration_file *out);

/* The calibration at a temperature, in field units; at most that at the edge of the range seen.
 * Returns 1; 0, with out untouched, if there is none. */
int calibration_file_at(const calibration_file *file, double temperature, invcal_calibration *out);

#endif
