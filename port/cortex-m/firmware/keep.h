/* SPDX-License-Identifier: MIT
 *
 * keep.h: what is kept in the flash: the current session, and the calibration.
 *
 * A failure is reported on the UART, and returned. A flash that fails once may not fail again, so saving is
 * tried three times.
 */
#ifndef KEEP_H
#define KEEP_H

#include "invcal/store.h"

invcal_status keep_load_calibration(invcal_calibration *calibration);
invcal_status keep_save_calibration(const invcal_calibration *calibration,
                                    const invcal_quality *quality);

invcal_status keep_load_session(invcal_session *session);
invcal_status keep_save_session(const invcal_session *session);
invcal_status keep_forget_session(void);

#endif
