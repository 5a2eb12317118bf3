/* SPDX-License-Identifier: MIT
 *
 *     uno MCU IMAGE
 *
 * The board on which the sketch Calibrate runs, around a simulated processor (libsimavr): an MPU-6050
 * on the I2C bus, an EEPROM that takes its time, a power supply, and a hand that turns the sensor as
 * the words on the serial port say. The image is the one that is flashed. The processor is reset in
 * the middle of the session, one position is wrong, and power fails while the EEPROM is written. When
 * the calibration is stored the board is switched off and on again, with an MPU-9250 in place of the
 * MPU-6050; after some calibrated readings the truth is printed, for the reader of the log.
 *
 * Exit status 0 if it came to that.
 */
#include <math.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_twi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "invcal/store.h"

enum { CLOCK = 16000000 };                       /* of the processor */
enum { RATE = 100, SAMPLE_US = 1000000 / RATE }; /* of the sensor */
enum { PATIENCE = 200 * RATE };                  /* in samples, as the next two */
enum { THINK = RATE / 2, MOVE = RATE };          /* of the hand */
enum { READINGS = 10 };                          /* calibrated ones, at the end */
/* What happens when so many positions have been taken: */
enum { RESET_AT = 4, PULLED_AT = 7, CUT_AT = 10 };
enum { CUT_AFTER = 100 }; /* bytes written to the EEPROM since then */

static avr_t *avr;
static elf_firmware_t image;
static uint8_t eeprom[4096];
static int is_off; /* power has failed */

/* ---- the motion --------------------------------------------------------------------------------- */

static const double COUNTS = 16384;
static const double NOISE = 40; /* counts, 2.4 mg */
static const double offset[3] = {610.5, -345.2, 920.3};
static const double gain[3][3] = {
    {1.021, 0.003, -0.005}, {0.003, 0.987, 0.002}, {-0.005, 0.002, 1.017}};

static double from[3] = {0, 0, 1}, up[3] = {0.1, -0.05, 1};
static unsigned there = THINK + MOVE; /* samples since the hand set out */
static unsigned samples;              /* in all */
static int is_pulled; /* somebody pulls at the cable: all readings are 50 mg wrong */

/* Nearly normal, standard deviation 1: the sum of twelve uniform numbers. */
static double noise(void)
{
    static uint32_t state = 1;
    double sum = -6;

    for (int i = 0; i < 12; i++) {
        state = state * UINT32_C(1664525) + UINT32_C(1013904223);
        sum += (state >> 8) / 16777216.0;
    }
    return sum;
}

static void to_unit(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* A moment to understand the words; then in an arc, shaking; then at rest. */
static void feel(double force[3])
{
    static const double aside[3] = {0.5, -0.3, 0.4};
    const double part = there < THINK          ? 0
                        : there < THINK + MOVE ? (double)(there - THINK) / MOVE
                                               : 1;

    for (int i = 0; i < 3; i++) {
        force[i] = (1 - part) * from[i] + part * up[i] + 4 * part * (1 - part) * aside[i];
    }
    to_unit(force);
    for (int i = 0; i < 3; i++) {
        force[i] += part > 0 && part < 1 ? 0.1 * noise() : 0;
        force[i] *= part >= 1 && is_pulled ? 1.05 : 1;
    }
}

/* A direction, if these are words for one: of all that a cube has the one with the same words. */
static int is_direction(const char *text, double direction[3])
{
    char words[INVCAL_WORDS];

    for (int n = 0; n < 27; n++) {
        invcal_real v[3];
        const int sign[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        if (n == 13) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            direction[i] = sign[i];
        }
        to_unit(direction);
        for (int i = 0; i < 3; i++) {
            v[i] = (invcal_real)direction[i];
        }
        if (strcmp(invcal_words(v, words), text) == 0) {
            return 1;
        }
    }
    return 0;
}

/* Sets out, and places the sensor only roughly. */
static void turn(const char *words)
{
    double direction[3];

    if (!is_direction(words, direction)) {
        printf("world: no direction: %s\n", words);
        exit(1);
    }
    memcpy(from, up, sizeof from);
    for (int i = 0; i < 3; i++) {
        up[i] = direction[i] + 0.07 * noise();
    }
    to_unit(up);
    there = 0;
}

/* ---- the chip ----------------------------------------------------------------------------------- */

/* Of the register maps. */
enum {
    ADDRESS = 0x68,
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* of the MPU-9250: its accelerometer has a filter of its own */
    INT_STATUS = 0x3A,
    ACCEL_XOUT_H = 0x3B,
    PWR_MGMT_1 = 0x6B,
    WHO_AM_I = 0x75,
    REGISTERS = 0x80,
    IS_MPU6050 = 0x68,
    IS_MPU9250 = 0x71
};

enum { TWCR = 0xBC, TWINT = 0x80 }; /* of the processor */

static avr_irq_t *bus;
static uint8_t registers[REGISTERS];
static uint8_t at;      /* the register that is next */
static int is_selected; /* addressed since the last start */
static int is_number;   /* the next byte written is a register's number */
static unsigned lost;   /* samples that nobody has read */

static void switch_chip_on(uint8_t which)
{
    memset(registers, 0, sizeof registers);
    registers[WHO_AM_I] = which;
    registers[PWR_MGMT_1] = 0x40; /* asleep */
}

/* Samples come only if it has been woken and set to 100 Hz: the filter on, and 1 kHz / (1 + 9). */
static int is_set_up(void)
{
    const int filter = registers[registers[WHO_AM_I] == IS_MPU9250 ? ACCEL_CONFIG2 : CONFIG] & 7;

    return !(registers[PWR_MGMT_1] & 0x40) && filter != 0 && filter != 7 &&
           registers[SMPLRT_DIV] == 9;
}

static void convert(void)
{
    const int range = registers[ACCEL_CONFIG] >> 3 & 3;
    double force[3];

    feel(force);
    for (int i = 0; i < 3; i++) {
        const double g = gain[i][0] * force[0] + gain[i][1] * force[1] + gain[i][2] * force[2];
        const long counts = lround((offset[i] + NOISE * noise() + COUNTS * g) / (1 << range));
        const int limited = counts < -32768 ? -32768 : counts > 32767 ? 32767 : (int)counts;
        registers[ACCEL_XOUT_H + 2 * i] = (uint8_t)(limited >> 8 & 0xFF);
        registers[ACCEL_XOUT_H + 2 * i + 1] = (uint8_t)(limited & 0xFF);
    }
    lost += registers[INT_STATUS] & 1;
    registers[INT_STATUS] = 1;
}

/* In time, whether it is read or not. */
static avr_cycle_count_t sample(avr_t *of, avr_cycle_count_t when, void *context)
{
    (void)of;
    (void)context;
    there++;
    samples++;
    if (is_set_up()) {
        convert();
    }
    return when + (avr_cycle_count_t)CLOCK / RATE;
}

static void say(uint8_t message, uint8_t data)
{
    avr_raise_irq(bus + TWI_IRQ_INPUT, avr_twi_irq_msg(message, ADDRESS << 1, data));
}

/* What the processor does on the bus. */
static void hear(avr_irq_t *irq, uint32_t value, void *context)
{
    const avr_twi_msg_irq_t message = {.u = {.v = value}};
    const unsigned what = message.u.twi.msg;

    (void)irq;
    (void)context;
    if (what & (TWI_COND_START | TWI_COND_STOP)) {
        is_selected = (what & TWI_COND_START) && message.u.twi.addr >> 1 == ADDRESS;
        is_number = 1;
        if (is_selected) {
            say(TWI_COND_ACK, 1);
        }
    }
    if (is_selected && (what & TWI_COND_WRITE)) {
        if (is_number) {
            at = message.u.twi.data % REGISTERS;
        } else {
            registers[at] = message.u.twi.data;
            at = (uint8_t)((at + 1) % REGISTERS);
        }
        is_number = 0;
        say(TWI_COND_ACK, 1);
    }
    if (is_selected && (what & TWI_COND_READ)) {
        say(TWI_COND_READ, registers[at]);
        if (at == INT_STATUS) {
            registers[at] = 0;
        }
        at = (uint8_t)((at + 1) % REGISTERS);
    }
}

/* Writing a 1 clears the flag: the simulator's version 1.6 does that only if its interrupt is on. */
static void clear_flag(avr_t *of, avr_io_addr_t address, uint8_t value, void *context)
{
    (void)of;
    (void)address;
    (void)context;
    if (value & TWINT) {
        avr->data[TWCR] &= (uint8_t)~TWINT;
    }
}

/* ---- the EEPROM --------------------------------------------------------------------------------- */

enum { EECR = 0x3F, EEPE = 2, EEARL = 0x41, WRITING_US = 3400 };
static unsigned taken;   /* positions, as the sketch says */
static unsigned written; /* bytes since then */

static uint8_t *cells(void)
{
    avr_eeprom_desc_t all = {NULL, 0, 1};

    avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &all);
    return all.ee;
}

static avr_cycle_count_t end_writing(avr_t *of, avr_cycle_count_t when, void *context)
{
    (void)when;
    (void)context;
    of->data[EECR] &= (uint8_t)~EEPE;
    return 0;
}

/* The simulator has written already. While power fails the byte becomes any. */
static void write_byte(avr_t *of, avr_io_addr_t address, uint8_t value, void *context)
{
    static int is_cut;

    (void)of;
    (void)address;
    (void)context;
    if (!(value & EEPE)) {
        return;
    }
    avr->data[EECR] |= EEPE;
    avr_cycle_timer_register_usec(avr, WRITING_US, end_writing, NULL);
    written++;
    if (taken == CUT_AT && written == CUT_AFTER && !is_cut) {
        cells()[avr->data[EEARL] | (unsigned)avr->data[EEARL + 1] << 8] = 0x5A;
        puts("world: power fails while the EEPROM is written");
        is_cut = 1;
        is_off = 1;
    }
}

/* ---- the serial port, and who reads it ------------------------------------------------------------ */

static int is_reset;   /* somebody has pressed the button */
static int is_stored;  /* the sketch has come to its end */
static unsigned shown; /* calibrated readings */

static int begins(const char *line, const char *with)
{
    return strncmp(line, with, strlen(with)) == 0;
}

static void count(const char *line)
{
    static int was_pulled;

    taken = (unsigned)strtoul(strrchr(line, ' '), NULL, 10);
    written = 0;
    is_pulled = 0;
    if (taken == PULLED_AT && !was_pulled) {
        was_pulled = 1;
        is_pulled = 1;
        puts("world: somebody pulls at the cable");
    }
}

static void read_line(const char *line)
{
    static const char next[] = "next: ";
    static int was_reset;

    puts(line);
    if (begins(line, next)) {
        turn(line + sizeof next - 1);
    } else if (begins(line, "positions taken: ")) {
        count(line);
    } else if (begins(line, "good: move on") && taken == RESET_AT && !was_reset) {
        was_reset = is_reset = 1;
    } else if (begins(line, "calibration stored")) {
        is_stored = 1;
    } else if (begins(line, "a, mg:")) {
        shown++;
    }
}

static void hear_byte(avr_irq_t *irq, uint32_t value, void *context)
{
    static char line[256];
    static size_t length;

    (void)irq;
    (void)context;
    if (value == '\n') {
        line[length] = '\0';
        length = 0;
        read_line(line);
    } else if (value != '\r' && length + 1 < sizeof line) {
        line[length++] = (char)value;
    }
}

/* ---- the power supply --------------------------------------------------------------------------- */

enum { PAINT = 0xA5 }; /* what is in RAM when power comes */
static unsigned deepest;

static unsigned first_free(void)
{
    return avr->ioend + 1u + image.datasize + image.bsssize;
}

static void look_how_deep(void)
{
    unsigned i = first_free();

    while (i <= avr->ramend && avr->data[i] == PAINT) {
        i++;
    }
    const unsigned depth = avr->ramend + 1 - i;
    deepest = depth > deepest ? depth : deepest;
}

static void switch_off(void)
{
    look_how_deep();
    memcpy(eeprom, cells(), avr->e2end + 1);
    avr_terminate(avr);
}

static void no_log(avr_t *of, const int level, const char *format, va_list arguments)
{
    (void)of;
    (void)level;
    (void)format;
    (void)arguments;
}

static void switch_on(const char *mcu, uint8_t chip)
{
    uint32_t flags = 0;

    avr = avr_make_mcu_by_name(mcu);
    if (!avr || avr_init(avr) != 0) {
        exit(2);
    }
    avr_load_firmware(avr, &image);
    avr->frequency = CLOCK;
    memset(avr->data + avr->ioend + 1, PAINT, avr->ramend - avr->ioend);
    memcpy(cells(), eeprom, avr->e2end + 1);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT),
                            hear_byte, NULL);
    bus = avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), 0);
    avr_irq_register_notify(bus + TWI_IRQ_OUTPUT, hear, NULL);
    avr_register_io_write(avr, TWCR, clear_flag, &image); /* behind the simulator's own */
    avr_register_io_write(avr, EECR, write_byte, &image);
    avr_cycle_timer_register_usec(avr, SAMPLE_US, sample, NULL);
    switch_chip_on(chip);
    is_off = 0;
}

/* ---- the end ------------------------------------------------------------------------------------ */

/* Of the calibrations in the EEPROM, which come first there. */
static int read_slot(void *context, unsigned slot, uint32_t begin, uint8_t *bytes, uint32_t size)
{
    const invcal_store *store = context;

    memcpy(bytes, cells() + slot * store->slot_size + begin, size);
    return 0;
}

static int no_erase(void *context, unsigned slot)
{
    (void)context;
    (void)slot;
    return 1;
}

static int no_program(void *context, unsigned slot, uint32_t to, const uint8_t *bytes,
                      uint32_t size)
{
    (void)to;
    (void)bytes;
    (void)size;
    return no_erase(context, slot);
}

/* How far a reading of 1 g is from the truth at most, once it is calibrated, in g. */
static double worst_error(const invcal_calibration *c)
{
    double worst = 0;

    for (unsigned n = 0; n < 1000; n++) {
        double eta[3] = {noise(), noise(), noise()};
        double square = 0;
        double u[3];
        to_unit(eta);
        for (int i = 0; i < 3; i++) {
            u[i] = offset[i] - (double)c->offset[i];
            for (int k = 0; k < 3; k++) {
                u[i] += COUNTS * gain[i][k] * eta[k];
            }
        }
        for (int i = 0; i < 3; i++) {
            double error = -eta[i];
            for (int k = 0; k < 3; k++) {
                error += (double)c->matrix[i][k] * u[k];
            }
            square += error * error;
        }
        worst = square > worst ? square : worst;
    }
    return sqrt(worst);
}

static void tell(void)
{
    invcal_store store = {
        read_slot, no_erase, no_program, &store, INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1), 1};
    invcal_calibration stored;

    if (invcal_load(&store, &stored) == INVCAL_OK) {
        printf("world: what is stored is wrong by %.2f mg at most\n", 1000 * worst_error(&stored));
    }
    look_how_deep();
    printf("world: up, mg: %.1f %.1f %.1f\n", 1000 * up[0], 1000 * up[1], 1000 * up[2]);
    printf("world: samples that nobody has read: %u\n", lost);
    printf("world: RAM %u, stack %u\n", image.datasize + image.bsssize, deepest);
}

int main(int argc, char **argv)
{
    int is_last = 0;

    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    avr_global_logger_set(no_log);
    if (argc != 3 || elf_read_firmware(argv[2], &image) != 0) {
        return 2;
    }
    memset(eeprom, 0xFF, sizeof eeprom);
    switch_on(argv[1], IS_MPU6050);
    while (samples < PATIENCE && shown < READINGS && avr->state != cpu_Crashed &&
           avr->state != cpu_Done) {
        avr_run(avr);
        if (is_off || (is_stored && !is_last)) {
            is_last = is_stored;
            switch_off();
            puts("world: power returns");
            switch_on(argv[1], is_last ? IS_MPU9250 : IS_MPU6050);
        }
        if (is_reset) {
            is_reset = 0;
            puts("world: reset");
            avr_reset(avr);
            avr_cycle_timer_register_usec(avr, SAMPLE_US, sample, NULL); /* it has forgotten that */
        }
    }
    tell();
    return shown < READINGS;
}
