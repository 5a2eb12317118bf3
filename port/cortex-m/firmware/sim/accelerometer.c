/* SPDX-License-Identifier: MIT
 *
 * The simulated world of the firmware of the accelerometer alone.
 */
#include "flash.h"
#include "sim.h"

const uint16_t hand_script[HAND_PLACES] = {
    [2] = LEAVES_TOO_SOON, [5] = WEAK_FLASH | RESET, [7] = TURNS_BACK, [8] = PULLS,
    [9] = KNOCKS,          [10] = SLOW_FLASH,        [11] = POWER_CUT,
};

invcal_status load_record(invcal_record *record)
{
    uint8_t bytes[INVCAL_RECORD_SIZE];
    uint32_t size;
    const invcal_status status = invcal_store_load(&calibration_store, bytes, sizeof bytes, &size);

    return status == INVCAL_OK ? invcal_record_decode(bytes, size, record) : status;
}

int verify_others(void)
{
    return 1;
}
