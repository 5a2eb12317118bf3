/* SPDX-License-Identifier: MIT */
#include "storage.h"

#include "flash.h"
#include "report.h"

enum { TRIES = 3 };

invcal_status storage_load_calibration(invcal_calibration *calibration)
{
    const invcal_status status = invcal_load(calibration, &calibration_store);

    report("stored calibration", status == INVCAL_OK ? "found" : invcal_status_text(status));
    return status;
}

invcal_status storage_save_calibration(const invcal_calibration *calibration,
                                       const invcal_quality *quality)
{
    invcal_status status = INVCAL_IO;

    for (unsigned i = 0; i < TRIES && status == INVCAL_IO; i++) {
        status = invcal_save(calibration, quality, &calibration_store);
        report(status == INVCAL_OK ? "calibration stored" : "calibration not stored",
               invcal_status_text(status));
    }
    return status;
}

invcal_status storage_load_session(invcal_session *session)
{
    const invcal_status status = invcal_session_load(session, &session_store);

    if (status == INVCAL_OK) {
        report_count("stored session found, positions", session->count);
    } else {
        report("stored session", invcal_status_text(status));
    }
    return status;
}

invcal_status storage_save_session(const invcal_session *session)
{
    invcal_status status = INVCAL_IO;

    for (unsigned i = 0; i < TRIES && status == INVCAL_IO; i++) {
        status = invcal_session_save(session, &session_store);
        if (status == INVCAL_OK) {
            report_count("session stored, positions", session->count);
        } else {
            report("session not stored", invcal_status_text(status));
        }
    }
    return status;
}

invcal_status storage_erase_session(void)
{
    const invcal_status status = invcal_store_erase(&session_store);

    if (status != INVCAL_OK) {
        report("session not erased", invcal_status_text(status));
    }
    return status;
}
