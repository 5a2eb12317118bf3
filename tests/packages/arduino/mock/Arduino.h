/* SPDX-License-Identifier: MIT
 *
 * As much of Arduino as the sketches Browser and Gyroscope use, on this machine. What arrives stands in Serial.in.
 */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include <string>

#define F(text) text
typedef char __FlashStringHelper;

struct mock_serial {
    std::string in, out;

    void begin(long)
    {
    }
    void setTimeout(unsigned long)
    {
    }
    int available()
    {
        return (int)in.size();
    }
    size_t readBytes(char *bytes, size_t n)
    {
        const size_t got = in.copy(bytes, n);
        in.erase(0, got);
        return got;
    }
    int read()
    {
        char c;
        return readBytes(&c, 1) == 1 ? c : -1;
    }
    void flush()
    {
    }
    void print(const char *text)
    {
        out += text;
    }
    void print(char c)
    {
        out += c;
    }
    void print(int32_t v)
    {
        out += std::to_string(v);
    }
    void print(long v)
    {
        out += std::to_string(v);
    }
    void println()
    {
        out += "\r\n";
    }
    void println(int32_t v)
    {
        out += std::to_string(v) + "\r\n";
    }
    void println(const char *text)
    {
        out += std::string(text) + "\r\n";
    }
};

extern mock_serial Serial;
void delay(unsigned long);
unsigned long millis();

#endif
