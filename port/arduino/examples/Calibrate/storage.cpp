/* SPDX-License-Identifier: MIT
 *
 * For the EEPROM of an AVR. Boards that keep one in flash want EEPROM.begin(size) in setup and
 * EEPROM.commit() at the end of erase_slot and program; what their own erasing does to the other
 * slot when power fails, their documentation must tell.
 */
#include "storage.h"

#include <EEPROM.h>
#include <string.h>

/* Two slots at the beginning of the EEPROM. */
const int SLOT = INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1);

static int read(void *, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        bytes[i] = EEPROM.read((int)slot * SLOT + (int)(offset + i));
    }
    return 0;
}

static int erase_slot(void *, unsigned slot)
{
    for (int i = 0; i < SLOT; i++) {
        EEPROM.update((int)slot * SLOT + i, 0xFF);
    }
    return 0;
}

static int program(void *, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        EEPROM.update((int)slot * SLOT + (int)(offset + i), bytes[i]);
    }
    return 0;
}

static const invcal_store store = {read, erase_slot, program, NULL, (uint32_t)SLOT, 1};

invcal_status storage_load(invcal_calibration &calibration)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    uint32_t size;
    invcal_record record;
    invcal_status status = invcal_store_load(&store, bytes, sizeof bytes, &size);

    if (status == INVCAL_OK) {
        status = invcal_record_decode(bytes, size, &record);
    }
    if (status == INVCAL_OK) {
        calibration = record.calibration;
    }
    return status;
}

invcal_status storage_save(const invcal_session &session, const invcal_solution &solution,
                           const invcal_quality &quality)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record = {};

    record.calibration = solution.calibration;
    memcpy(record.delta, solution.delta, sizeof record.delta);
    memcpy(record.dk, solution.dk, sizeof record.dk);
    memcpy(record.gamma, solution.gamma, sizeof record.gamma);
    memcpy(record.sigma_offset, quality.sigma_offset, sizeof record.sigma_offset);
    memcpy(record.sigma_delta, quality.sigma_delta, sizeof record.sigma_delta);
    memcpy(record.sigma_dk, quality.sigma_dk, sizeof record.sigma_dk);
    memcpy(record.sigma_gamma, quality.sigma_gamma, sizeof record.sigma_gamma);
    record.field = session.setup.settings.field;
    record.temperature = session.temperature;
    record.temperature_known = 1;
    record.noise = quality.noise;
    record.residual_rms = quality.residual_rms;
    record.condition = quality.condition;
    record.verdict = quality.verdict;
    record.positions = (uint16_t)session.normal.count;
    record.undetermined = quality.undetermined;
    const invcal_status status = invcal_record_encode(&record, bytes);
    return status == INVCAL_OK ? invcal_store_save(&store, bytes, sizeof bytes) : status;
}
