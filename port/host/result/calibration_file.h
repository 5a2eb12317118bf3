/* SPDX-License-Identifier: MIT
 *
 * result/calibration_file.h: reads the output of `invcal calibrate --out`.
 */
#ifndef CALIBRATION_FILE_H
#define CALIBRATION_FILE_H

#include "invcal/thermal.h"
#include "result/record.h"

#define CALIBRATION_FILE_WORD 32 /* longer words are cut */
#define CALIBRATION_FILE_NAMES 128

/* Quadratic and cubic errors of the axes (nonlinearity.h). */
typedef struct {
    double term[2][3];          /* quadratic and cubic, of x y z, over the field; 0: none */
    double field;               /* its length */
    invcal_calibration nominal; /* its matrix, in field units, defines the axes of the errors */
} calibration_nonlinear;

/* The content of a file. A number that it does not hold is NUMBER_UNKNOWN, a text "". */
typedef struct {
    invcal_calibration calibration;
    record record;
    double gravity;       /* length of the field, field units */
    double gravity_sigma; /* its standard deviation */
    double interval;      /* number of sigma to either side that cover 95 % */
    double positions;     /* number of positions */
    double suspected;     /* number of positions that contradict one another */
    char frame[CALIBRATION_FILE_WORD];
    char unit[CALIBRATION_FILE_WORD];      /* of the readings: "g", "mg", "m/s^2", "counts", ... */
    double zero[3];                        /* nominal: input units */
    double lsb[3];                         /* nominal: field units per input unit */
    int has_cross_terms;                   /* the nominal calibration has cross terms */
    char zero_from[CALIBRATION_FILE_WORD]; /* source of zero: "given", "range", ... */
    char lsb_from[CALIBRATION_FILE_WORD];  /* source of lsb */
    char sensor[CALIBRATION_FILE_WORD];    /* whose data sheet states them: "mpu6050:2g" */
    double sigma_offset[3];                /* standard deviations: input units */
    double sigma_dk[3];                    /* of scale errors */
    double sigma_gamma[3];                 /* of angles, rad */
    char verdict[CALIBRATION_FILE_WORD];
    char undetermined[CALIBRATION_FILE_NAMES]; /* names separated by commas */
    int is_magnetometer;     /* that was waved; of a log with two sensors, correct this one */
    int is_field_measured;   /* of a magnetometer: gravity is the mean length of its readings */
    int has_thermal;         /* `calibration` is that at the reference temperature of `thermal` */
    invcal_thermal thermal;  /* over the field */
    double thermal_field;    /* length of that field */
    int is_triangular;       /* frame of `thermal` */
    int has_gyro;            /* the file has a gyroscope */
    invcal_calibration gyro; /* input units to rad/s */
    double gyro_g[3][3];     /* g-sensitivity to subtract, rad/s per field unit; 0: none */
    int has_gyro_g;
    double gyro_lsb;         /* nominal: rad/s per input unit */
    int gyro_is_counts;      /* the input unit is counts */
    double gyro_sigma[3][3]; /* of the matrix over gyro_lsb */
    char gyro_verdict[CALIBRATION_FILE_WORD];
    int has_nonlinear; /* remove `nonlinear` from a reading before `calibration` is applied */
    calibration_nonlinear nonlinear;
} calibration_file;

/* Reads a JSON object with "offset", 3 numbers in input units, and "matrix", 3 rows of 3 numbers
 * in field units per input unit; other members are ignored. "-" is the standard input.
 *
 * Returns EXIT_GOOD; EXIT_FILE, with a message, if the file is unreadable or malformed, or the
 * matrix is singular. */
int calibration_file_read(const char *path, invcal_calibration *out);

/* The same with everything that apply needs: unit, gravity (NUMBER_UNKNOWN if it is no number),
 * is_magnetometer, has_thermal and thermal, has_nonlinear and nonlinear, has_gyro and gyro. */
int calibration_file_read_correction(const char *path, calibration_file *out);

/* The same with all members. */
int calibration_file_read_all(const char *path, calibration_file *out);

/* The calibration at a temperature, in field units; outside the range of the data, that at its
 * edge. Returns 1; 0, with out untouched, if there is none. */
int calibration_file_at(const calibration_file *file, double temperature, invcal_calibration *out);

#endif
