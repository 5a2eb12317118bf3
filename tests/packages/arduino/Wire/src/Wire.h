/* SPDX-License-Identifier: MIT
 *
 * In place of Arduino's Wire, in the simulator: a bus with an MPU-6050 on it, and a hand that turns
 * it. The processor is reset in the middle of the session, and power fails while the EEPROM is
 * written; one position is wrong. When all places have been visited the processor is reset once more,
 * to see what is in the EEPROM, and to meet an MPU-9250; then the truth is printed, for whoever reads
 * the log, and the run ends.
 */
#ifndef WIRE_H
#define WIRE_H

#include <Arduino.h>

class TwoWire
{
  public:
    void begin();
    void setClock(uint32_t frequency);
    void beginTransmission(uint8_t address);
    size_t write(uint8_t byte);
    uint8_t endTransmission(bool stop = true);
    uint8_t requestFrom(uint8_t address, uint8_t size);
    int read();
};

extern TwoWire Wire;

#endif
