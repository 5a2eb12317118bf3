/* SPDX-License-Identifier: MIT
 *
 * imu_registers.h: the data sheet in short. The chip is nobody's, its registers are as most have
 * them: put those of yours here.
 *
 * A transfer begins with a register's address, with IMU_READ to read. The address counts up with
 * every byte that follows.
 */
#ifndef IMU_REGISTERS_H
#define IMU_REGISTERS_H

enum {
    IMU_WHO_AM_I = 0x0F,
    IMU_CTRL1 = 0x10,  /* samples per second, range */
    IMU_CTRL2 = 0x11,  /* reset */
    IMU_STATUS = 0x1E, /* cleared when data are read */
    IMU_TEMP_L = 0x20, /* int16, low byte first; then x, y and z alike */
    IMU_REGISTERS = 0x28,
    IMU_READ = 0x80
};

#define IMU_NAME 0x5A /* in WHO_AM_I */

#define IMU_CTRL1_100_HZ 0x40
#define IMU_CTRL1_4_G 0x08 /* 8192 counts for 1 g */

#define IMU_CTRL2_RESET 0x01 /* clears itself when the reset is done */

#define IMU_STATUS_READY 0x01
#define IMU_STATUS_OVERRUN 0x10 /* a sample was replaced before anyone had read it */

#endif
