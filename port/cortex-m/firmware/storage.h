/* SPDX-License-Identifier: MIT
 *
 * storage.h: current session and calibration in the flash.
 *
 * A failure is reported on the UART, and returned. A flash that fails once may not fail again, so
 * saving is tried three times.
 */
#ifndef STORAGE_H
#define STORAGE_H

#include "invcal/store.h"

invcal_status storage_load_calibration(invcal_calibration *calibration);
invcal_status storage_save_calibration(const invcal_calibration *calibration,
                                       const invcal_quality *quality);

invcal_status storage_load_session(invcal_session *session);
invcal_status storage_save_session(const invcal_session *session);
invcal_status storage_erase_session(void);

#endif
