/* SPDX-License-Identifier: MIT
 *
 * As much of Arduino as the sketch Browser uses, on this machine. What arrives stands in Serial.in.
 */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>

#include <string>

#define F(text) text

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
    void print(char c)
    {
        out += c;
    }
    void print(int32_t v)
    {
        out += std::to_string(v);
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

#endif
