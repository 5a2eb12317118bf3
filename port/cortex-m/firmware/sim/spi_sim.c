/* SPDX-License-Identifier: MIT
 *
 * The chip on the bus: registers, triads, clock, queue. Time advances by one step at every fourth
 * read of the queue's status: as fast as the firmware polls.
 */
#include "spi.h"

#include <string.h>

#include "imu_registers.h"
#include "sim.h"

#define READS_PER_STEP 4
#define RESET_READS 3   /* until a reset is done */
#define NOISE 8.0f      /* counts, 1 mg */
#define GYRO_NOISE 3.3f /* counts, 0.05 degrees/s */

enum { WORD = 7 }; /* bytes of a sample in the queue */

static struct {
    uint32_t magic;
    uint32_t steps; /* since power-on */
    uint8_t reads;
    uint8_t reset;
    uint8_t registers[IMU_REGISTERS];
    unsigned first, waiting; /* of the queue */
    uint8_t queue[IMU_FIFO_SIZE][WORD];
} chip SIM_NOINIT;

/* Scale errors to 2 %, cross terms to 1 % either way, offsets to 50 mg. */
const sim_triad sim_truth = {
    {310.5f, -145.2f, 420.3f},
    {{8192 * 1.021f, 8192 * 0.003f, 8192 * -0.005f},
     {8192 * 0.003f, 8192 * 0.987f, 8192 * 0.002f},
     {8192 * -0.005f, 8192 * 0.002f, 8192 * 1.017f}},
};

/* Scale errors to 3 %, cross terms to 1.5 %, offsets to 2 degrees/s. */
const sim_triad sim_gyro_truth = {
    {85.0f, -131.0f, 24.5f},
    {{3752.3f * 0.973f, 3752.3f * 0.012f, 3752.3f * -0.004f},
     {3752.3f * -0.015f, 3752.3f * 1.018f, 3752.3f * 0.007f},
     {3752.3f * 0.003f, 3752.3f * -0.009f, 3752.3f * 1.009f}},
};

static void put_int16(uint8_t *at, float value)
{
    const float limited = value < -32768 ? -32768 : value > 32767 ? 32767 : value;
    const uint32_t bits = (uint32_t)(int32_t)(limited + (limited < 0 ? -0.5f : 0.5f));

    at[0] = (uint8_t)bits;
    at[1] = (uint8_t)(bits >> 8);
}

static void convert(uint8_t tag, const sim_triad *truth, const float v[3], float noise)
{
    if (chip.waiting == IMU_FIFO_SIZE) {
        chip.registers[IMU_FIFO_STATUS2] |= IMU_FIFO_STATUS2_OVERRUN;
        return;
    }
    uint8_t *word = chip.queue[(chip.first + chip.waiting) % IMU_FIFO_SIZE];
    word[0] = tag;
    for (unsigned i = 0; i < 3; i++) {
        const float *gain = truth->gain[i];
        put_int16(&word[1 + 2 * i], truth->offset[i] + gain[0] * v[0] + gain[1] * v[1] +
                                        gain[2] * v[2] + noise * sim_noise());
    }
    chip.waiting++;
}

static void step(void)
{
    float rate[3], force[3];

    hand_step(rate, force);
    if (chip.registers[IMU_CTRL2] == (IMU_CTRL2_200_HZ | IMU_CTRL2_500_DPS)) {
        convert(IMU_TAG_GYRO, &sim_gyro_truth, rate, GYRO_NOISE);
    }
    if (chip.steps++ % 2 == 1 && chip.registers[IMU_CTRL1] == (IMU_CTRL1_100_HZ | IMU_CTRL1_4_G)) {
        convert(IMU_TAG_ACCELEROMETER, &sim_truth, force, NOISE);
    }
}

void sim_pass(unsigned steps)
{
    while (chip.registers[IMU_FIFO_CTRL] == IMU_FIFO_CTRL_ON && steps-- > 0) {
        step();
    }
}

static void reset_chip(void)
{
    memset(chip.registers, 0, sizeof chip.registers);
    chip.registers[IMU_WHO_AM_I] = IMU_NAME;
    chip.first = chip.waiting = 0;
}

/* Reads a register, with its side effects. */
static uint8_t read_register(uint8_t address)
{
    if (address == IMU_FIFO_STATUS1) {
        if (++chip.reads % READS_PER_STEP == 0) {
            sim_pass(1);
        }
        chip.registers[IMU_FIFO_STATUS1] = (uint8_t)chip.waiting;
        chip.registers[IMU_FIFO_STATUS2] =
            (uint8_t)((chip.registers[IMU_FIFO_STATUS2] & IMU_FIFO_STATUS2_OVERRUN) |
                      chip.waiting >> 8);
    }
    if (address == IMU_CTRL3 && chip.reset > 0 && --chip.reset == 0) {
        reset_chip();
    }
    if (address == IMU_FIFO_TAG && chip.waiting > 0) {
        memcpy(&chip.registers[IMU_FIFO_TAG], chip.queue[chip.first], WORD);
        chip.first = (chip.first + 1) % IMU_FIFO_SIZE;
        chip.waiting--;
    }
    const uint8_t value = chip.registers[address];
    if (address == IMU_FIFO_STATUS2) {
        chip.registers[address] = 0;
    }
    return value;
}

static void write_register(uint8_t address, uint8_t value)
{
    if (address == IMU_CTRL1 || address == IMU_CTRL2 || address == IMU_FIFO_CTRL) {
        chip.registers[address] = value;
    } else if (address == IMU_CTRL3 && value & IMU_CTRL3_RESET) {
        chip.registers[address] = value;
        chip.reset = RESET_READS;
    } /* others are read-only */
}

void spi_transfer(uint8_t *bytes, unsigned size)
{
    const int is_read = bytes[0] & IMU_READ;
    const unsigned first = bytes[0] & ~(unsigned)IMU_READ;

    if (sim_is_new(&chip.magic)) {
        chip.steps = 0;
        chip.reads = 0;
        chip.reset = 0;
        reset_chip();
    }
    for (unsigned i = 1; i < size; i++) {
        const uint8_t address = (uint8_t)((first + i - 1) % IMU_REGISTERS);
        if (is_read) {
            bytes[i] = read_register(address);
        } else {
            write_register(address, bytes[i]);
        }
    }
}
