/* SPDX-License-Identifier: MIT
 *
 * The sketch Browser on this machine: its sensor and memory are these, and its serial port is a string. Exit status 0 if
 * it prints readings, stores what the page sends, and refuses what is damaged, torn, or something else.
 */
#include <Arduino.h>
#include <stdio.h>
#include <string.h>

mock_serial Serial;

#include "Browser.ino"

/* ---- a sensor, and a memory ------------------------------------------------------------------- */

void delay(unsigned long) {}

bool sensor_begin()
{
    return true;
}

sensor_status sensor_next(int32_t raw[3])
{
    raw[0] = -12;
    raw[1] = 345;
    raw[2] = 16384;
    return SENSOR_OK;
}

static uint8_t memory[2][INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1)];

static int read(void *, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    memcpy(bytes, memory[slot] + offset, size);
    return 0;
}

static int erase_slot(void *, unsigned slot)
{
    memset(memory[slot], 0xFF, sizeof memory[slot]);
    return 0;
}

static int program(void *, unsigned slot, uint32_t offset, const uint8_t *bytes, uint32_t size)
{
    memcpy(memory[slot] + offset, bytes, size);
    return 0;
}

const invcal_store calibration_store = {read, erase_slot, program, NULL, sizeof memory[0], 1};

/* ---- what the page sends ---------------------------------------------------------------------- */

static const invcal_calibration made = {{150, -320.5f, 410}, {{6e-5f, 1e-7f, 0}, {1e-7f, 6.1e-5f, 0}, {0, 0, 6.2e-5f}}};

static std::string line_of(const invcal_calibration &calibration)
{
    invcal_quality quality;
    invcal_record record;
    uint8_t bytes[INVCAL_RECORD_SIZE];
    char digits[3];
    std::string line = "invcal ";

    memset(&quality, 0, sizeof quality);
    invcal_record_init(&record, &calibration, &quality);
    if (invcal_record_encode(&record, bytes) != INVCAL_OK) {
        return "";
    }
    for (unsigned i = 0; i < sizeof bytes; i++) {
        snprintf(digits, sizeof digits, "%02x", bytes[i]);
        line += digits;
    }
    return line + "\n";
}

static int failures;

/* What is said when this comes: `answer` at the end of it, or with null nothing but a reading. */
static void expect(const char *what, const std::string &comes, const char *answer)
{
    const std::string reading = "-12,345,16384\r\n";
    const std::string wanted = reading + (answer ? std::string(answer) + "\r\n" : "");

    Serial.out.clear();
    Serial.in = comes;
    loop();
    if (Serial.out != wanted) {
        printf("%s: %s", what, Serial.out.c_str());
        failures++;
    }
    Serial.in.clear();
}

static bool holds(const invcal_calibration &calibration)
{
    invcal_calibration found;

    return invcal_load(&found, &calibration_store) == INVCAL_OK &&
           memcmp(&found, &calibration, sizeof found) == 0;
}

int main()
{
    const char *const damaged = "invcal: damaged on its way, send it again";
    const std::string line = line_of(made);
    std::string wrong = line;

    memset(memory, 0xFF, sizeof memory);
    setup();
    failures += Serial.out != "# stored calibration: none\r\n";
    expect("a reading", "", NULL);
    expect("something else", "hello\n", NULL);
    expect("torn", line.substr(0, 100), damaged);
    wrong[60] = wrong[60] == '0' ? '1' : '0';
    expect("a wrong digit", wrong, damaged);
    failures += holds(made);
    expect("sound", line, "invcal: stored");
    failures += !holds(made);
    expect("a wrong digit", wrong, damaged);
    failures += !holds(made);
    Serial.out.clear();
    setup();
    failures += Serial.out != "# stored calibration: found\r\n";
    return failures > 0;
}
