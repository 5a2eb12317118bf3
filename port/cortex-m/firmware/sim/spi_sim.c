/* SPDX-License-Identifier: MIT
 *
 * The sensor behind the bus: its registers, its triad, its clock. Every fourth look at STATUS finds
 * a new sample: time goes as fast as the firmware asks.
 */
#include "spi.h"

#include <string.h>

#include "imu_registers.h"
#include "sim.h"

#define LOOKS 4       /* for one sample */
#define RESET_LOOKS 3 /* what a reset takes */
#define NOISE 8.0f    /* counts, 1 mg */

static struct {
    uint32_t magic;
    uint32_t samples; /* since power-on */
    uint8_t looks;
    uint8_t reset;
    uint8_t registers[IMU_REGISTERS];
} chip SIM_NOINIT;

/* Scale errors to 2 %, cross terms to 1 % either way, offsets to 50 mg. */
const sim_triad sim_truth = {
    {310.5f, -145.2f, 420.3f},
    {{8192 * 1.021f, 8192 * 0.003f, 8192 * -0.005f},
     {8192 * 0.003f, 8192 * 0.987f, 8192 * 0.002f},
     {8192 * -0.005f, 8192 * 0.002f, 8192 * 1.017f}},
};

static void put_int16(uint8_t address, float value)
{
    const float limited = value < -32768 ? -32768 : value > 32767 ? 32767 : value;
    const uint32_t bits = (uint32_t)(int32_t)(limited + (limited < 0 ? -0.5f : 0.5f));

    chip.registers[address] = (uint8_t)bits;
    chip.registers[address + 1] = (uint8_t)(bits >> 8);
}

static void convert(void)
{
    float force[3];

    hand_step(force);
    for (unsigned i = 0; i < 3; i++) {
        const float *gain = sim_truth.gain[i];
        const float counts = sim_truth.offset[i] + gain[0] * force[0] + gain[1] * force[1] +
                             gain[2] * force[2] + NOISE * sim_noise();
        put_int16((uint8_t)(IMU_TEMP_L + 2 + 2 * i), counts);
    }
    put_int16(IMU_TEMP_L, 256.0f * (3.0f + 1e-4f * (float)chip.samples)); /* it warms up */
    chip.samples++;
    uint8_t *const status = &chip.registers[IMU_STATUS];
    *status |= *status & IMU_STATUS_READY ? IMU_STATUS_OVERRUN : IMU_STATUS_READY;
}

void sim_pass(unsigned samples)
{
    const int is_on = chip.registers[IMU_CTRL1] == (IMU_CTRL1_100_HZ | IMU_CTRL1_4_G);

    while (is_on && samples-- > 0) {
        convert();
    }
}

static void reset_chip(void)
{
    memset(chip.registers, 0, sizeof chip.registers);
    chip.registers[IMU_WHO_AM_I] = IMU_NAME;
}

/* What happens as a register is looked at. */
static uint8_t look(uint8_t address)
{
    if (address == IMU_STATUS && ++chip.looks % LOOKS == 0) {
        sim_pass(1);
    }
    if (address == IMU_CTRL2 && chip.reset > 0 && --chip.reset == 0) {
        reset_chip();
    }
    const uint8_t value = chip.registers[address];
    if (address == IMU_TEMP_L) {
        chip.registers[IMU_STATUS] = 0;
    }
    return value;
}

static void write(uint8_t address, uint8_t value)
{
    if (address != IMU_CTRL1 && address != IMU_CTRL2) {
        return; /* read-only */
    }
    chip.registers[address] = value;
    if (address == IMU_CTRL2 && value & IMU_CTRL2_RESET) {
        chip.reset = RESET_LOOKS;
    }
}

void spi_transfer(uint8_t *bytes, unsigned size)
{
    const int is_read = bytes[0] & IMU_READ;
    const unsigned first = bytes[0] & ~(unsigned)IMU_READ;

    if (sim_is_new(&chip.magic)) {
        chip.samples = 0;
        chip.looks = 0;
        chip.reset = 0;
        reset_chip();
    }
    for (unsigned i = 1; i < size; i++) {
        const uint8_t address = (uint8_t)((first + i - 1) % IMU_REGISTERS);
        if (is_read) {
            bytes[i] = look(address);
        } else {
            write(address, bytes[i]);
        }
    }
}
