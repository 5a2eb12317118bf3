/* SPDX-License-Identifier: MIT
 *
 * In place of Arduino's Wire, in the simulator: a bus with an MPU-6050 on it, and a hand that turns
 * it. Once everything has been shown the processor is reset, to see what is in the EEPROM, and to
 * meet an MPU-9250; then the truth is printed, for whoever reads the log, and the run ends.
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
