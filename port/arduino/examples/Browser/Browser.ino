/* SPDX-License-Identifier: MIT
 *
 * An accelerometer that a page in a browser calibrates: it prints its readings, x,y,z in counts,
 * and stores the calibration that the page sends back. Open invcal.html (make web) in Chrome, Edge,
 * Opera or a recent Firefox, press "Serial port", turn the sensor as the page says, and press "Send
 * to the board".
 *
 * The page sends one line, "invcal " and the record of store.h as hexadecimal digits:
 *
 *     invcal ca0288000000...
 *
 * Calibrate.ino shows how your device uses it: invcal_load and invcal_apply.
 */
#include <invcal.h>
#include <invcal/store.h>

#include "sensor.h"
#include "storage.h"

const unsigned TIMEOUT = 500; /* milliseconds without a character: the line was cut off */

/* Returns the next character; -1 if none comes. */
static int next_character()
{
    char c;

    return Serial.readBytes(&c, 1) == 1 ? c : -1;
}

/* Returns 0 ... 15; -1 if it is not a hexadecimal digit. */
static int digit(int c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

static bool read_record(uint8_t bytes[INVCAL_RECORD_SIZE])
{
    for (unsigned i = 0; i < INVCAL_RECORD_SIZE; i++) {
        const int high = digit(next_character());
        const int low = high < 0 ? -1 : digit(next_character());
        if (low < 0) {
            return false;
        }
        bytes[i] = (uint8_t)(high << 4 | low);
    }
    return true;
}

/* Reads a whole line at once: an Uno's buffer of 64 characters would overflow during one sample. */
static void listen()
{
    static const char word[] = "invcal ";
    uint8_t bytes[INVCAL_RECORD_SIZE];
    invcal_record record;

    for (const char *c = word; *c; c++) {
        if (next_character() != *c) {
            return; /* something else */
        }
    }
    if (!read_record(bytes) || invcal_record_decode(bytes, sizeof bytes, &record) != INVCAL_OK) {
        Serial.println(F("invcal: damaged on its way, send it again"));
    } else if (invcal_store_save(&calibration_store, bytes, sizeof bytes) != INVCAL_OK) {
        Serial.println(F("invcal: not stored, the EEPROM fails"));
    } else {
        Serial.println(F("invcal: stored"));
    }
}

void setup()
{
    invcal_calibration calibration;

    Serial.begin(115200);
    Serial.setTimeout(TIMEOUT);
    while (!sensor_begin()) {
        Serial.println(F("# sensor: no answer, or another chip"));
        delay(1000);
    }
    Serial.println(invcal_load(&calibration, &calibration_store) == INVCAL_OK
                       ? F("# stored calibration: found")
                       : F("# stored calibration: none"));
}

void loop()
{
    int32_t raw[3];

    if (sensor_next(raw) == SENSOR_SILENT) {
        Serial.println(F("# sensor: no sample in due time"));
        return;
    }
    Serial.print(raw[0]);
    Serial.print(',');
    Serial.print(raw[1]);
    Serial.print(',');
    Serial.println(raw[2]);
    if (Serial.available() > 0) {
        listen();
    }
}
