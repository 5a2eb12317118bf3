/* SPDX-License-Identifier: MIT
 *
 * The sketch Gyroscope on this machine: an MPU-6050 on its bus, whose queue fills while nobody reads it, and a hand
 * that does what it prints. Exit status 0 if it calibrates both sensors, refuses the move in which samples were
 * lost and the one that was too quick, stores the truth within 4 sigma, finds it after power has been off, and
 * begins again on request.
 */
#include <Arduino.h>
#include <EEPROM.h>
#include <Wire.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

mock_serial Serial;
mock_wire Wire;
mock_eeprom EEPROM;

#include "Gyroscope.ino"

/* ---- the motion --------------------------------------------------------------------------------- */

static const double RATE = 100; /* steps per second */
static const double PI = 3.14159265358979324;
static const double offset[3] = {610.5, -345.2, 920.3};
static const double gain[3][3] = { /* accelerometer, symmetric: counts for 1 g, over the data sheet's */
    {1.021, 0.003, -0.005}, {0.003, 0.987, 0.002}, {-0.005, 0.002, 1.017}};
static const double gyro_offset[3] = {-140.3, 66.6, 21.5};
static const double gyro_gain[3][3] = {
    {0.975, 0.012, -0.004}, {-0.015, 1.018, 0.007}, {0.003, -0.009, 1.009}};

static double up[3] = {0.05, -0.03, 1};
static double vector_[3], wobble[3]; /* of the turn, and on the way, rad/s */
static int turning, turn;            /* steps of it */
static int leaving;                  /* steps until it is taken up; 0: it is held */
static int place;                    /* how many have been visited */
static int wish;                     /* the axis that is to be up, from 1; negative: down */
static unsigned long steps;          /* in all */

enum { HURRIES = 4, BUSY = 7 }; /* the turn that is too quick; in which the board does something else */

static double noise()
{
    static uint32_t state = 1;
    double sum = -6;

    for (int i = 0; i < 12; i++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        sum += (state >> 8) / 16777216.0;
    }
    return sum;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void leave()
{
    double to[3];
    double dot = 0;

    for (int i = 0; i < 3; i++) {
        to[i] = (abs(wish) - 1 == i ? (wish < 0 ? -1 : 1) : 0) + 0.05 * noise();
        dot += to[i] * up[i];
        wobble[i] = 0.3 * noise();
    }
    cross(to, up, vector_);
    const double sine = length(vector_);
    for (int i = 0; i < 3; i++) {
        vector_[i] *= atan2(sine, dot) / sine;
    }
    place++;
    turning = 0;
    turn = place == HURRIES ? 25 : 120;
}

/* What was up turns the other way round, in fine steps. */
static void move(double rate[3])
{
    const double tau = (turning + 0.5) / turn;
    const double window = 16 * tau * tau * (1 - tau) * (1 - tau);

    for (int i = 0; i < 3; i++) {
        rate[i] = window * (30.0 / 16 * vector_[i] * RATE / turn + wobble[i] * sin(15 * tau + i));
    }
    for (int n = 0; n < 200; n++) {
        double change[3];
        cross(up, rate, change);
        for (int i = 0; i < 3; i++) {
            up[i] += change[i] / (200 * RATE);
        }
    }
    const double one = length(up);
    for (int i = 0; i < 3; i++) {
        up[i] /= one;
    }
    turning++;
}

/* ---- the chip ----------------------------------------------------------------------------------- */

static uint8_t registers[128] = {0};
static uint8_t queue[1024];
static unsigned waiting;

static void put(double value)
{
    const long rounded = lround(value);
    const int limited = rounded < -32768 ? -32768 : rounded > 32767 ? 32767 : (int)rounded;

    queue[waiting++ % 1024] = (uint8_t)(limited >> 8 & 0xFF);
    queue[waiting++ % 1024] = (uint8_t)(limited & 0xFF);
}

static void step()
{
    double rate[3] = {0, 0, 0};
    const bool is_moving = turning < turn;

    steps++;
    if (is_moving) {
        move(rate);
    } else if (leaving > 0 && --leaving == 0) {
        leave();
    }
    if (registers[0x6B] != 1 || registers[0x19] != 9 || registers[0x1A] != 3 || registers[0x1B] != 8 ||
        registers[0x1C] != 0 || registers[0x23] != 0x78 || !(registers[0x6A] & 0x40)) {
        return; /* it is not set up */
    }
    if (waiting + 12 > sizeof queue) {
        registers[0x3A] |= 0x10;
        return;
    }
    for (int i = 0; i < 3; i++) {
        double sum = offset[i] + 40 * noise();
        for (int k = 0; k < 3; k++) {
            sum += 16384 * gain[i][k] * (up[k] + (is_moving ? 0.05 * noise() : 0));
        }
        put(sum);
    }
    for (int i = 0; i < 3; i++) {
        double sum = gyro_offset[i] + 3.3 * noise();
        for (int k = 0; k < 3; k++) {
            sum += 65.5 * 180 / PI * gyro_gain[i][k] * rate[k];
        }
        put(sum);
    }
}

bool bus_write(uint8_t chip, uint8_t address, uint8_t value)
{
    registers[address % 128] = value;
    if (address == 0x6A && (value & 0x04)) {
        waiting = 0;
    }
    return chip == 0x68;
}

bool bus_read(uint8_t chip, uint8_t address, uint8_t *bytes, uint8_t size)
{
    static unsigned looks;

    registers[0x75] = 0x68;
    if (address == 0x72 && ++looks % 4 == 0) {
        step();
    }
    registers[0x72] = (uint8_t)(waiting >> 8);
    registers[0x73] = (uint8_t)(waiting & 0xFF);
    for (uint8_t i = 0; i < size; i++) {
        bytes[i] = address == 0x74 ? queue[i] : registers[(address + i) % 128];
    }
    if (address == 0x74) {
        waiting -= size;
        memmove(queue, queue + size, waiting);
    } else if (address == 0x3A) {
        registers[0x3A] = 0;
    }
    return chip == 0x68;
}

unsigned long millis()
{
    return steps * 10;
}

void delay(unsigned long)
{
}

/* ---- who reads the serial port ------------------------------------------------------------------ */

static int failures;
static std::string refused; /* what was said of moves, a line each */
static unsigned readings, taken;

static void fail(const char *what)
{
    printf("%s\n", what);
    failures++;
}

static void read_line(const std::string &line)
{
    puts(line.c_str());
    if (line.compare(0, 6, "next: ") == 0) {
        wish = (line[7] - 'x' + 1) * (line[6] == '-' ? -1 : 1);
    } else if (line.compare(0, 4, "good") == 0 || line.compare(0, 7, "refused") == 0) {
        leaving = turning == turn ? 50 : 0;
    } else if (line.compare(0, 12, "move refused") == 0) {
        refused += line.substr(14) + "\n";
    } else if (line.compare(0, 9, "positions") == 0) {
        taken = (unsigned)atoi(line.c_str() + 17);
    } else if (line.compare(0, 6, "rate, ") == 0) {
        readings++;
    }
}

static bool said(const char *text)
{
    const bool found = Serial.out.find(text) != std::string::npos;

    if (!found) {
        printf("not said: %s\n", text);
        failures++;
    }
    return found;
}

/* Until a line begins with this. Everything said since the last time stands in Serial.out. */
static bool run_until(const char *text)
{
    static const unsigned long PATIENCE_STEPS = 15000;
    const unsigned long begin = steps;
    size_t read = 0;

    while (steps - begin < PATIENCE_STEPS) {
        bool is_there = false;
        loop();
        for (size_t end; (end = Serial.out.find("\r\n", read)) != std::string::npos; read = end + 2) {
            const std::string line = Serial.out.substr(read, end - read);
            read_line(line);
            is_there = is_there || line.compare(0, strlen(text), text) == 0;
        }
        if (is_there) {
            return true;
        }
        if (place == BUSY && turning == 60) { /* for a second */
            for (int i = 0; i < 100; i++) {
                step();
            }
        }
    }
    printf("never said: %s\n", text);
    failures++;
    return false;
}

/* ---- the end ------------------------------------------------------------------------------------ */

static void judge()
{
    invcal_imu_record r;

    if (invcal_load_imu(&calibration_store, &r) != INVCAL_OK) {
        fail("nothing is stored");
        return;
    }
    for (int i = 0; i < 9; i++) {
        double error = i % 4 == 0 ? -1 : 0;
        double other = error;
        for (int k = 0; k < 3; k++) {
            error += (double)r.gyro.matrix[i / 3][k] * 65.5 * 180 / PI * gyro_gain[k][i % 3];
            other += (double)r.accelerometer.calibration.matrix[i / 3][k] * 16384 * gain[k][i % 3];
        }
        printf("world: gyroscope %.2f e-4, sigma %.2f; accelerometer %.2f e-4\n", 1e4 * error,
               1e4 * (double)r.sigma[i], 1e4 * other);
        if (!(fabs(error) < 4 * (double)r.sigma[i] && r.sigma[i] < 2e-3f && fabs(other) < 1e-3)) {
            fail("the matrix is wrong");
        }
    }
    for (int i = 0; i < 3; i++) {
        if (!(fabs((double)r.gyro.offset[i] - gyro_offset[i]) < 1 &&
              fabs((double)r.accelerometer.calibration.offset[i] - offset[i]) < 16)) {
            fail("an offset is wrong");
        }
    }
}

int main()
{
    memset(EEPROM.cell, 0xFF, sizeof EEPROM.cell);
    setup();
    said("stored calibration: none\r\ncalibration begins\r\nnext: +z up\r\n");
    Serial.out.clear();
    if (run_until("calibration stored")) {
        said("verdict: good");
        judge();
    }
    if (refused != "at the end of the sensor's range\nsamples were lost in the move\n") {
        fail("other moves were refused");
    }
    if (taken < 13) {
        fail("too few positions");
    }
    Serial.out.clear();
    run_until("rate, mrad/s:");
    memset(&calibration, 0, sizeof calibration); /* off and on */
    is_calibrated = false;
    Serial.out.clear();
    setup();
    said("stored calibration: found");
    Serial.out.clear();
    turning = turn = 0; /* held still */
    leaving = 0;
    run_until("rate, mrad/s:");
    run_until("rate, mrad/s:");
    Serial.out.clear();
    Serial.in = "c";
    run_until("calibration begins");
    printf("%u readings, %d failures\n", readings, failures);
    return failures > 0;
}
