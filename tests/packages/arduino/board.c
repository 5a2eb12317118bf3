/* SPDX-License-Identifier: MIT
 *
 *     board MCU IMAGE [gyroscope]
 *
 * The board on which the sketch Calibrate or Gyroscope runs, around a simulated processor (libsimavr): an
 * MPU-6050 on the I2C bus, an EEPROM that takes its time, a power supply, and a hand that turns the sensor
 * as the words on the serial port say. The image is the one that is flashed. In the middle of Calibrate the
 * processor is reset, one position is wrong, and power fails while the EEPROM is written; in Gyroscope one
 * turn is too quick, and during another the processor stands still. Once the calibration is stored, the
 * board is switched off and on again, with an MPU-9250 in place of the MPU-6050; after some calibrated
 * readings (and, for Gyroscope, the request to begin again) it prints the truth, for whatever reads the log.
 *
 * Exit status 0 if it gets that far.
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

#include "hand.h"
#include "invcal/gyro_store.h"
#include "invcal/result.h"

enum { CLOCK = 16000000 };                             /* of the processor */
enum { RATE = HAND_RATE, SAMPLE_US = 1000000 / RATE }; /* of the sensor */
enum { PATIENCE = 200 * RATE };                        /* samples */
enum { READINGS = 10 };                                /* calibrated ones, at the end */
/* When what happens, as a number of positions taken: */
enum { RESET_AT = 4, PULLED_AT = 7, CUT_AT = 10 }; /* to Calibrate */
enum { CUT_AFTER = 100 };                          /* bytes written to the EEPROM since then */
enum { HURRY_AT = 4, STALL_AT = 7 };               /* to Gyroscope */
enum { STALL = RATE };                             /* samples */

static avr_t *avr;
static elf_firmware_t image;
static uint8_t eeprom[4096];
static int is_off; /* power has failed */
static int with_gyro;
static unsigned taken; /* positions, as the sketch says */

/* ---- the motion --------------------------------------------------------------------------------- */

static const double COUNTS = 16384;
static const double NOISE = 40; /* counts, 2.4 mg */
static const double offset[3] = {610.5, -345.2, 920.3};
static const double gain[3][3] = {
    {1.021, 0.003, -0.005}, {0.003, 0.987, 0.002}, {-0.005, 0.002, 1.017}};

static const double PI = 3.14159265358979324;
static const double GYRO_COUNTS = 131; /* for 1 degree/s, range 250 degrees/s */
static const double GYRO_NOISE = 6.6;  /* counts, 0.05 degrees/s */
static const double gyro_offset[3] = {-280.6, 133.2, 43};
static const double gyro_gain[3][3] = {
    {0.975, 0.012, -0.004}, {-0.015, 1.018, 0.007}, {0.003, -0.009, 1.009}};

static unsigned samples; /* in total */
static unsigned moving;  /* since the device was picked up; 0: it is held */
static int is_pulled;    /* somebody pulls at the cable: all readings are 50 mg wrong */

static void feel(double force[3], double rate[3])
{
    moving = hand_moves(rate, force) ? moving + 1 : 0;
    for (int i = 0; i < 3 && moving == 0 && is_pulled; i++) {
        force[i] *= 1.05;
    }
}

static void set_out(const char *words)
{
    if (!hand_reads(words, with_gyro && taken == HURRY_AT ? HAND_HURRY : HAND_TURN)) {
        printf("world: no direction: %s\n", words);
        exit(1);
    }
}

/* ---- the chip ----------------------------------------------------------------------------------- */

/* Of the register maps. */
enum {
    ADDRESS = 0x68,
    SMPLRT_DIV = 0x19,
    CONFIG = 0x1A,
    GYRO_CONFIG = 0x1B,
    ACCEL_CONFIG = 0x1C,
    ACCEL_CONFIG2 = 0x1D, /* of the MPU-9250: its accelerometer has a filter of its own */
    FIFO_EN = 0x23,       /* gyroscope x, y, z: 0x40, 0x20, 0x10; accelerometer: 8 */
    INT_STATUS = 0x3A,    /* 0x10: the queue has overflowed; 1: a new sample */
    ACCEL_XOUT_H = 0x3B,
    GYRO_XOUT_H = 0x43,
    USER_CTRL = 0x6A, /* 0x40: the queue is on; 4: empty it */
    PWR_MGMT_1 = 0x6B,
    FIFO_COUNTH = 0x72,
    FIFO_R_W = 0x74,
    WHO_AM_I = 0x75,
    REGISTERS = 0x80
};

enum { IS_MPU6050 = 0x68, IS_MPU9250 = 0x71 }; /* in WHO_AM_I */

enum { TWCR = 0xBC, TWINT = 0x80 }; /* of the processor */

static avr_irq_t *bus;
static uint8_t registers[REGISTERS];
static uint8_t at;      /* the next register */
static int is_selected; /* addressed since the last start */
static int is_number;   /* the next byte written is a register's number */
static unsigned lost;   /* samples that were never read */
static uint8_t queue[1024];
static unsigned oldest, waiting; /* bytes of the queue */

static void switch_chip_on(uint8_t which)
{
    memset(registers, 0, sizeof registers);
    registers[WHO_AM_I] = which;
    registers[PWR_MGMT_1] = 0x40; /* asleep */
    waiting = 0;
}

/* There are samples only if it was woken and set to 100 Hz: the filter on, and 1 kHz / (1 + 9). */
static int is_set_up(void)
{
    const int filter = registers[registers[WHO_AM_I] == IS_MPU9250 ? ACCEL_CONFIG2 : CONFIG] & 7;

    return !(registers[PWR_MGMT_1] & 0x40) && filter != 0 && filter != 7 &&
           registers[SMPLRT_DIV] == 9;
}

static void convert_axis(uint8_t address, double counts)
{
    const long rounded = lround(counts);
    const int limited = rounded < -32768 ? -32768 : rounded > 32767 ? 32767 : (int)rounded;

    registers[address] = (uint8_t)(limited >> 8 & 0xFF);
    registers[address + 1] = (uint8_t)(limited & 0xFF);
}

/* If it is full, drops the oldest byte. */
static void put_in_queue(uint8_t byte)
{
    if (waiting == sizeof queue) {
        oldest++;
        waiting--;
        registers[INT_STATUS] |= 0x10;
    }
    queue[(oldest + waiting++) % sizeof queue] = byte;
}

/* In the order of their registers. */
static void fill_queue(void)
{
    for (uint8_t i = 0; i < 6 && registers[FIFO_EN] & 8; i++) {
        put_in_queue(registers[ACCEL_XOUT_H + i]);
    }
    for (uint8_t i = 0; i < 6; i++) {
        if (registers[FIFO_EN] & 0x40 >> i / 2) {
            put_in_queue(registers[GYRO_XOUT_H + i]);
        }
    }
}

static void convert(void)
{
    const int range = registers[ACCEL_CONFIG] >> 3 & 3;
    const int gyro_range = registers[GYRO_CONFIG] >> 3 & 3;
    double force[3], rate[3];

    feel(force, rate);
    for (int i = 0; i < 3; i++) {
        double g = 0, degrees = 0;
        for (int k = 0; k < 3; k++) {
            g += gain[i][k] * force[k];
            degrees += gyro_gain[i][k] * rate[k] * 180 / PI;
        }
        convert_axis((uint8_t)(ACCEL_XOUT_H + 2 * i),
                     (offset[i] + NOISE * hand_noise() + COUNTS * g) / (1 << range));
        convert_axis((uint8_t)(GYRO_XOUT_H + 2 * i),
                     (gyro_offset[i] + GYRO_NOISE * hand_noise() + GYRO_COUNTS * degrees) /
                         (1 << gyro_range));
    }
    lost += registers[INT_STATUS] & 1;
    registers[INT_STATUS] |= 1;
    if (registers[USER_CTRL] & 0x40) {
        fill_queue();
    }
}

static void pass(void)
{
    samples++;
    if (is_set_up()) {
        convert();
    }
}

/* In time, whether it is read or not. */
static avr_cycle_count_t sample(avr_t *of, avr_cycle_count_t when, void *context)
{
    static int has_stalled;

    (void)of;
    (void)context;
    pass();
    if (with_gyro && taken == STALL_AT && moving == HAND_TURN / 4 && !has_stalled) {
        has_stalled = 1;
        puts("world: the processor stands still for a second");
        for (unsigned i = 0; i < STALL; i++) {
            pass();
        }
    }
    return when + (avr_cycle_count_t)CLOCK / RATE;
}

static void write_register(uint8_t value)
{
    registers[at] = value;
    if (at == USER_CTRL && value & 4) {
        registers[at] &= (uint8_t)~4;
        waiting = 0;
    }
}

/* The queue's register stays selected; after any other, the next one follows. */
static uint8_t read_register(void)
{
    registers[FIFO_COUNTH] = (uint8_t)(waiting >> 8);
    registers[FIFO_COUNTH + 1] = (uint8_t)waiting;
    if (at == FIFO_R_W) {
        if (waiting > 0) {
            registers[at] = queue[oldest++ % sizeof queue];
            waiting--;
        }
        return registers[at];
    }
    const uint8_t value = registers[at];
    if (at == INT_STATUS) {
        registers[at] = 0;
    }
    at = (uint8_t)((at + 1) % REGISTERS);
    return value;
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
            write_register(message.u.twi.data);
            at = (uint8_t)((at + 1) % REGISTERS);
        }
        is_number = 0;
        say(TWI_COND_ACK, 1);
    }
    if (is_selected && (what & TWI_COND_READ)) {
        say(TWI_COND_READ, read_register());
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
static unsigned written; /* bytes since the last position */

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

/* The simulator has already written. If power fails, the byte becomes something else. */
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
    if (!with_gyro && taken == CUT_AT && written == CUT_AFTER && !is_cut) {
        cells()[avr->data[EEARL] | (unsigned)avr->data[EEARL + 1] << 8] = 0x5A;
        puts("world: power fails while the EEPROM is written");
        is_cut = 1;
        is_off = 1;
    }
}

/* ---- the serial port, and its reader -------------------------------------------------------------- */

static int is_reset;   /* somebody has pressed the button */
static int is_stored;  /* the sketch has stored its calibration, */
static int has_begun;  /* or begins one (again) */
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
    if (!with_gyro && taken == PULLED_AT && !was_pulled) {
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
        set_out(line + sizeof next - 1);
    } else if (begins(line, "positions taken: ")) {
        count(line);
    } else if (begins(line, "turns made, ")) {
        taken++;
    } else if (begins(line, "good: move on") && !with_gyro && taken == RESET_AT && !was_reset) {
        was_reset = is_reset = 1;
    } else if (begins(line, "calibration stored")) {
        is_stored = 1;
    } else if (begins(line, "calibration begins")) {
        has_begun = 1;
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

enum { PAINT = 0xA5 }; /* fills RAM at power-on */
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

/* The larger of both, and NaN if either is: fmax() drops it. */
static double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

/* How far a reading of 1 g is from the truth at most, once it is calibrated, in g. */
static double worst_error(const invcal_calibration *c)
{
    double worst = 0;

    for (unsigned n = 0; n < 1000; n++) {
        double eta[3] = {hand_noise(), hand_noise(), hand_noise()};
        double square = 0;
        double u[3];
        const double length = sqrt(eta[0] * eta[0] + eta[1] * eta[1] + eta[2] * eta[2]);
        for (int i = 0; i < 3; i++) {
            eta[i] /= length;
        }
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
        worst = larger(worst, square);
    }
    return sqrt(worst);
}

static void tell_accelerometer(const invcal_calibration *stored)
{
    printf("world: what is stored is wrong by %.2f mg at most\n", 1000 * worst_error(stored));
}

/* A perfect matrix, in rad/s, makes the identity of the truth. */
static void tell_gyro(const invcal_imu_result *stored)
{
    double worst = 0, bias = 0;

    for (int i = 0; i < 9; i++) {
        double error = i % 4 == 0 ? -1 : 0;
        for (int k = 0; k < 3; k++) {
            error += (double)stored->gyro.matrix[i / 3][k] * GYRO_COUNTS / 2 * 180 / PI *
                     gyro_gain[k][i % 3];
        }
        worst = larger(worst, fabs(error) / (double)stored->sigma[INVCAL_GYRO_XX + i]);
        printf("world: %s sigma %.5f\n", invcal_parameter_text(INVCAL_GYRO_XX + (unsigned)i),
               (double)stored->sigma[INVCAL_GYRO_XX + i]);
    }
    for (int i = 0; i < 3; i++) {
        bias = larger(bias, fabs((double)stored->gyro.offset[i] - gyro_offset[i] / 2));
    }
    printf("world: the gyroscope is wrong by %.2f sigma at most, its offset by %.2f counts\n",
           worst, bias);
}

static void tell(void)
{
    const uint32_t size = with_gyro ? INVCAL_STORE_BYTES(INVCAL_IMU_RECORD_SIZE, 1)
                                    : INVCAL_STORE_BYTES(INVCAL_RECORD_SIZE, 1);
    invcal_store store = {read_slot, no_erase, no_program, &store, size, 1};
    invcal_calibration stored;
    invcal_imu_result both;

    if (with_gyro && invcal_imu_load_result(&both, &store) == INVCAL_OK) {
        tell_gyro(&both);
        tell_accelerometer(&both.accelerometer);
    } else if (invcal_load(&stored, &store) == INVCAL_OK) {
        tell_accelerometer(&stored);
    }
    look_how_deep();
    printf("world: up, mg: %.1f %.1f %.1f\n", 1000 * hand_up()[0], 1000 * hand_up()[1],
           1000 * hand_up()[2]);
    printf("world: samples that nobody has read: %u\n", lost);
    printf("world: RAM %u, stack %u\n", image.datasize + image.bsssize, deepest);
}

/* To the readings, and with both sensors once more to a beginning. */
static int is_at_end(void)
{
    static int has_asked;

    if (shown < READINGS) {
        return 0;
    }
    if (with_gyro && !has_asked) {
        has_asked = 1;
        has_begun = 0;
        avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), 'c');
    }
    return !with_gyro || has_begun;
}

int main(int argc, char **argv)
{
    int is_last = 0;

    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    avr_global_logger_set(no_log);
    with_gyro = argc == 4;
    if (argc < 3 || argc > 4 || elf_read_firmware(argv[2], &image) != 0) {
        return 2;
    }
    memset(eeprom, 0xFF, sizeof eeprom);
    switch_on(argv[1], IS_MPU6050);
    while (samples < PATIENCE && !is_at_end() && avr->state != cpu_Crashed &&
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
    return !is_at_end();
}
