/* SPDX-License-Identifier: MIT
 *
 * What the programs of README.md, and of gyroscope_firmware.md, wearable.md and thermal.md in port/manual, ask of a
 * board.
 */
#ifndef BOARD_H
#define BOARD_H

#include "invcal/store.h"

void board_read(int16_t v[3]);          /* waits for a sample: x y z in raw counts */
void board_show(const char *text);      /* to the person */
void board_use(const invcal_real g[3]); /* what the device is for */
void board_read_gyro(int16_t v[3]); /* of the gyroscope, which is read first; and in g and rad/s */
void board_use_both(const invcal_real g[3], const invcal_real rate[3]);
invcal_real board_temperature(void);            /* of the thermometer, degrees C */
void board_await(const char *climate);          /* waits until it is "cold" or "warm" */
void board_count_steps(const invcal_real g[3]); /* of a watch, */
int board_has_a_day_passed(void);               /* which ends after a month */
extern const invcal_store board_result;         /* two slots for the calibration, */
extern const invcal_store board_progress;       /* and two for the session */

#endif
