/* SPDX-License-Identifier: MIT */
#include "keep.h"

#include <string.h>

#include "flash.h"
#include "invcal/record.h"
#include "invcal/resume.h"
#include "tell.h"

static uint8_t bytes[INVCAL_RESUME_SIZE]; /* what is stored or loaded; a record is smaller */

/* A flash that fails once may not fail again: its slot is erased anew. */
static invcal_status save(const invcal_store *store, uint32_t size, const char *failed)
{
    invcal_status status = INVCAL_IO;

    for (unsigned tries = 0; tries < 3 && status == INVCAL_IO; tries++) {
        status = invcal_store_save(store, bytes, size);
        if (status != INVCAL_OK) {
            tell(failed, invcal_status_text(status));
        }
    }
    return status;
}

/* ---- calibration ------------------------------------------------------------------------------ */

invcal_status keep_load_calibration(invcal_calibration *calibration)
{
    uint32_t size;
    invcal_record record;
    invcal_status status = invcal_store_load(&calibration_store, bytes, sizeof bytes, &size);

    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes, size, &record);
    }
    if (status == INVCAL_OK) {
        *calibration = record.calibration;
    }
    tell("stored calibration", status == INVCAL_OK ? "found" : invcal_status_text(status));
    return status;
}

static void fill(invcal_record *record, const invcal_solution *solution,
                 const invcal_quality *quality)
{
    record->calibration = solution->calibration;
    memcpy(record->delta, solution->delta, sizeof record->delta);
    memcpy(record->dk, solution->dk, sizeof record->dk);
    memcpy(record->gamma, solution->gamma, sizeof record->gamma);
    memcpy(record->sigma_offset, quality->sigma_offset, sizeof record->sigma_offset);
    memcpy(record->sigma_delta, quality->sigma_delta, sizeof record->sigma_delta);
    memcpy(record->sigma_dk, quality->sigma_dk, sizeof record->sigma_dk);
    memcpy(record->sigma_gamma, quality->sigma_gamma, sizeof record->sigma_gamma);
    record->noise = quality->noise;
    record->residual_rms = quality->residual_rms;
    record->condition = quality->condition;
    record->undetermined = quality->undetermined;
    record->verdict = quality->verdict;
}

invcal_status keep_save_calibration(const invcal_session *session, const invcal_solution *solution,
                                    const invcal_quality *quality)
{
    invcal_record record = {
        .field = session->setup.settings.field,
        .temperature = session->temperature,
        .temperature_known = 1,
        .positions = (uint16_t)session->normal.count,
    };

    fill(&record, solution, quality);
    invcal_status status = invcal_record_encode(&record, bytes);
    if (status == INVCAL_OK) {
        status = save(&calibration_store, INVCAL_RECORD_SIZE, "calibration not stored");
    }
    if (status == INVCAL_OK) {
        tell_count("calibration stored, bytes", INVCAL_RECORD_SIZE);
    }
    return status;
}

/* ---- session ---------------------------------------------------------------------------------- */

invcal_status keep_load_session(invcal_session *session)
{
    uint32_t size;
    invcal_status status = invcal_store_load(&session_store, bytes, sizeof bytes, &size);

    if (status == INVCAL_OK) {
        status = invcal_resume_decode(bytes, size, session);
    }
    if (status == INVCAL_OK) {
        tell_count("stored session found, positions", session->normal.count);
    } else {
        tell("stored session", invcal_status_text(status));
    }
    return status;
}

invcal_status keep_save_session(const invcal_session *session)
{
    uint32_t size;
    invcal_status status = invcal_resume_encode(session, bytes, &size);

    if (status == INVCAL_OK) {
        status = save(&session_store, size, "session not stored");
    }
    if (status == INVCAL_OK) {
        tell_count("session stored, positions", session->normal.count);
    }
    return status;
}

invcal_status keep_forget_session(void)
{
    const invcal_status status = invcal_store_erase(&session_store);

    if (status != INVCAL_OK) {
        tell("session not erased", invcal_status_text(status));
    }
    return status;
}
