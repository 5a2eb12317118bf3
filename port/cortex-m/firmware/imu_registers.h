/* SPDX-License-Identifier: MIT
 *
 * imu_registers.h: the data sheet in short. The chip does not exist, but its registers are typical:
 * replace them by those of yours.
 *
 * A transfer begins with a register's address, with IMU_READ to read. The address is incremented
 * after each byte. Both sensors put their samples into one queue (FIFO), each at its own rate.
 */
#ifndef IMU_REGISTERS_H
#define IMU_REGISTERS_H

enum {
    IMU_FIFO_CTRL = 0x0A, /* the queue: on */
    IMU_WHO_AM_I = 0x0F,
    IMU_CTRL1 = 0x10,        /* accelerometer: samples per second, range */
    IMU_CTRL2 = 0x11,        /* gyroscope: the same */
    IMU_CTRL3 = 0x12,        /* reset */
    IMU_FIFO_STATUS1 = 0x1A, /* number of samples in the queue, the low byte; */
    IMU_FIFO_STATUS2 = 0x1B, /* its upper bits, and whether the queue has overflowed */
    IMU_FIFO_TAG = 0x20,     /* the sensor; then x, y, z, int16, low byte first. Read all 7. */
    IMU_REGISTERS = 0x28,
    IMU_READ = 0x80
};

#define IMU_NAME 0x6C /* in WHO_AM_I */

#define IMU_CTRL1_100_HZ 0x40
#define IMU_CTRL1_4_G 0x08 /* 8192 counts for 1 g */

#define IMU_CTRL2_200_HZ 0x50
#define IMU_CTRL2_500_DPS 0x04 /* 65.5 counts for 1 degree/s */

#define IMU_CTRL3_RESET 0x01 /* clears itself when the reset is done */

#define IMU_FIFO_CTRL_ON 0x06

#define IMU_FIFO_STATUS2_MORE 0x03
#define IMU_FIFO_STATUS2_OVERRUN 0x40 /* cleared when it is read */

#define IMU_TAG_GYRO 0x01
#define IMU_TAG_ACCELEROMETER 0x02

#define IMU_FIFO_SIZE 128 /* samples: 0.4 s of both sensors */

#endif
