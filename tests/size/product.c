/* SPDX-License-Identifier: MIT
 *
 * What `make size` calls the product: an accelerometer that calibrates itself, from power-on to
 * calibrated readings, with guidance in words, reasons, and a session that survives a reset. The
 * program of README.md; board_... are yours.
 */
#include "invcal/store.h"

const int32_t *board_sample(void);
void board_show(const char *text);
void board_use(const invcal_real calibrated[3]);
extern const invcal_store board_calibration;
extern const invcal_store board_session;

@README@
