/* SPDX-License-Identifier: MIT */
#include "Wire.h"

#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/sleep.h>

/* In samples, hundredths of a second. */
const unsigned HOLD = 350;
const unsigned TURN = 150;
const unsigned AGAIN = 400;         /* after the last reset */
const unsigned long PERIOD = 10000; /* microseconds: a sample */
const unsigned BYTE = 23;           /* microseconds: 9 bits at 400 kHz */
const unsigned PLACES = 18;
/* What happens at a place: */
const unsigned RESET_AT = 4;
const unsigned PULLED_AT = 7;  /* somebody pulls at the cable: all readings are 50 mg wrong */
const unsigned CUT_AT = 10;    /* power fails while it is on the way from here to the next, and */
const unsigned CUT_AFTER = 300; /* so many bytes of the EEPROM have been written */
const float NOISE = 40; /* counts, 2.4 mg */

/* counts = offset + 16384 gain (specific force in g), in the range of 2 g */
static const float offset[3] = {610.5f, -345.2f, 920.3f};
static const float gain[3][3] = {
    {1.021f, 0.003f, -0.005f}, {0.003f, 0.987f, 0.002f}, {-0.005f, 0.002f, 1.017f}};

/* Faces and edges of a cube: what points up. */
static const int8_t places[PLACES][3] = {
    {0, 0, 1},  {1, 0, 0},  {0, 1, 0},  {-1, 0, 0},  {0, -1, 0},  {0, 0, -1},
    {1, 1, 0},  {1, 0, 1},  {0, 1, 1},  {-1, 1, 0},  {-1, 0, 1},  {0, -1, 1},
    {1, -1, 0}, {1, 0, -1}, {0, 1, -1}, {-1, -1, 0}, {-1, 0, -1}, {0, -1, -1},
};

/* What goes on while the processor is reset. */
static struct {
    uint16_t magic;
    uint8_t lives;
    uint8_t place;    /* where the sensor is, or is on the way from */
    bool is_cut;      /* power has failed once */
    bool is_last;     /* all places have been visited */
    bool is_reset;    /* at RESET_AT, once */
    bool is_told;     /* that somebody pulls */
    uint16_t deepest; /* of the stack, bytes */
} world __attribute__((section(".noinit")));

static uint32_t state = 1;
static unsigned tick; /* samples since the place was reached or life began, in all those that nobody */
static unsigned lost; /* has read, */
static unsigned long due; /* and when the next one will be there */

/* Four bytes: nearly normal, standard deviation 1. */
static float noise()
{
    state = state * 1664525 + 1013904223;
    const uint32_t r = state ^ state >> 15;
    const int sum = (int)(r & 255) + (int)(r >> 8 & 255) + (int)(r >> 16 & 255) + (int)(r >> 24);

    return (sum - 510) / 147.8f;
}

/* ---- how deep the stack has been: the free memory is painted -------------------------------- */

extern uint8_t __heap_start; /* by the linker: behind the variables */
const uint8_t PAINT = 0xA5;

static void paint()
{
    for (uint8_t *p = &__heap_start; p < (uint8_t *)SP - 16; p++) {
        *p = PAINT;
    }
}

static void look_how_deep()
{
    const uint8_t *p = &__heap_start;

    while (*p == PAINT) {
        p++;
    }
    const uint16_t depth = (const uint8_t *)RAMEND - p + 1;
    if (depth > world.deepest) {
        world.deepest = depth;
    }
}

/* ---- the ends --------------------------------------------------------------------------------- */

static void start_anew()
{
    cli();
    __asm volatile("jmp 0");
}

static void show(const __FlashStringHelper *name, const float v[3])
{
    Serial.print(name);
    for (int i = 0; i < 3; i++) {
        Serial.print(' ');
        Serial.print(v[i], 4);
    }
    Serial.println();
}

/* The processor is reset, and all is well. */
static void reset()
{
    look_how_deep();
    Serial.print(F("world: reset; samples that nobody has read: "));
    Serial.println(lost);
    Serial.flush();
    start_anew();
}

/* Power fails: the byte that is being written reads as something else. */
void world_writes(uint8_t *at)
{
    static unsigned written;

    if (world.place == CUT_AT && !world.is_cut && ++written == CUT_AFTER) {
        eeprom_write_byte(at, 0x5A);
        look_how_deep();
        Serial.println(F("world: power fails while the EEPROM is written"));
        Serial.flush();
        world.is_cut = true;
        start_anew();
    }
}

static void to_unit(float v[3])
{
    const float length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* A place as a hand takes it: some degrees off, always the same. */
static void place_of(unsigned place, float up[3])
{
    for (int i = 0; i < 3; i++) {
        up[i] = places[place][i] + 0.02f * (float)((place * 7 + i * 5) % 11) - 0.1f;
    }
    to_unit(up);
}

/* Held; then in an arc to the next place, shaking. */
static void feel(float force[3])
{
    static const float aside[3] = {0.5f, -0.3f, 0.4f};
    float next[3];

    place_of(world.place, force);
    if (tick < HOLD || world.is_last) {
        for (int i = 0; i < 3 && world.place == PULLED_AT; i++) {
            force[i] *= 1.05f;
        }
        return;
    }
    place_of(world.place + 1, next);
    const float part = (float)(tick - HOLD) / TURN;
    for (int i = 0; i < 3; i++) {
        force[i] = (1 - part) * force[i] + part * next[i] + 4 * part * (1 - part) * aside[i];
    }
    to_unit(force);
    for (int i = 0; i < 3; i++) {
        force[i] += 0.1f * noise();
    }
}

static void finish()
{
    float up[3];

    place_of(world.place, up);
    show(F("world: up"), up);
    show(F("world: offset"), offset);
    look_how_deep();
    Serial.print(F("world: stack, bytes: "));
    Serial.println(world.deepest);
    Serial.flush();
    cli();
    sleep_enable();
    for (;;) {
        sleep_cpu(); /* the simulator ends */
    }
}

/* What the hour brings. */
static void go_on()
{
    if (world.is_last && tick >= AGAIN) {
        finish();
    }
    if (world.place == RESET_AT && tick >= HOLD / 2 && !world.is_reset) {
        world.is_reset = true;
        reset();
    }
    if (world.place == PULLED_AT && !world.is_told) {
        world.is_told = true;
        Serial.println(F("world: somebody pulls at the cable"));
    }
    if (!world.is_last && tick >= HOLD + TURN) {
        world.place++;
        tick = 0;
        if (world.place == PLACES - 1) {
            world.is_last = true;
            reset();
        }
    }
}

/* ---- the chip --------------------------------------------------------------------------------- */

/* Of the register maps. It is an MPU-6050, and in the last life an MPU-9250. */
enum {
    ADDRESS = 0x68,
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* of the MPU-9250: its accelerometer has a filter of its own */
    INT_STATUS = 0x3A,
    ACCEL_XOUT_H = 0x3B,
    TEMP_OUT_H = 0x41,
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
    REGISTERS = 0x76
};

TwoWire Wire;
static uint8_t registers[REGISTERS];
static uint8_t at;    /* the register that is next */
static bool is_first; /* of the bytes written: the register's number */
static bool is_addressed;

static void put(uint8_t address, long value)
{
    const long limited = value < -32768 ? -32768 : value > 32767 ? 32767 : value;

    registers[address] = (uint8_t)((uint16_t)limited >> 8);
    registers[address + 1] = (uint8_t)limited;
}

static void convert()
{
    const uint8_t range = registers[ACCEL_CONFIG] >> 3 & 3;
    float force[3];

    go_on();
    feel(force);
    for (uint8_t i = 0; i < 3; i++) {
        const float counts =
            offset[i] + NOISE * noise() +
            16384 * (gain[i][0] * force[0] + gain[i][1] * force[1] + gain[i][2] * force[2]);
        put(ACCEL_XOUT_H + 2 * i, lround(counts / (1 << range)));
    }
    put(TEMP_OUT_H, -3920 + (long)(tick / 30)); /* 25 degrees Celsius, rising */
    tick++;
}

/* Samples come in time, whether they are read or not; but only if the chip has been woken and set to
 * 100 Hz: the filter on, and 1 kHz / (1 + 9). */
static uint8_t look(uint8_t address)
{
    if (address != INT_STATUS) {
        return registers[address];
    }
    const uint8_t filter = registers[world.is_last ? ACCEL_CONFIG2 : CONFIG] & 7;
    if (registers[PWR_MGMT_1] & 0x40 || filter == 0 || filter == 7 || registers[SMPLRT_DIV] != 9 ||
        (long)(micros() - due) < 0) {
        return 0;
    }
    for (due += PERIOD; (long)(micros() - due) >= 0; due += PERIOD) {
        tick++;
        lost++;
    }
    convert();
    return 1;
}

void TwoWire::begin()
{
    const uint16_t mark = 0xBEEF;

    if (world.magic != mark) {
        memset(&world, 0, sizeof world);
        world.magic = mark;
    }
    world.lives++;
    state = world.lives;
    paint();
    registers[WHO_AM_I] = world.is_last ? 0x71 : 0x68;
    registers[PWR_MGMT_1] = 0x40; /* asleep */
    due = micros();
}

void TwoWire::setClock(uint32_t)
{
}

void TwoWire::beginTransmission(uint8_t address)
{
    is_addressed = address == ADDRESS;
    is_first = true;
}

size_t TwoWire::write(uint8_t byte)
{
    delayMicroseconds(BYTE);
    if (is_first) {
        at = byte % REGISTERS;
    } else {
        registers[at] = byte;
        at = (at + 1) % REGISTERS;
    }
    is_first = false;
    return 1;
}

uint8_t TwoWire::endTransmission(bool)
{
    return is_addressed ? 0 : 2; /* nobody has acknowledged the address */
}

uint8_t TwoWire::requestFrom(uint8_t address, uint8_t size)
{
    delayMicroseconds(BYTE * size);
    return address == ADDRESS ? size : 0;
}

int TwoWire::read()
{
    const uint8_t byte = look(at);

    at = (at + 1) % REGISTERS;
    return byte;
}
