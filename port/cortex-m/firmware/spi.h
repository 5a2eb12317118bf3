/* SPDX-License-Identifier: MIT
 *
 * spi.h: the bus to the sensor. Write it for your board; sim/spi_sim.c replaces it here.
 */
#ifndef SPI_H
#define SPI_H

#include <stdint.h>

/* Selects the chip, exchanges `size` bytes (the answer replaces what was sent), deselects it. */
void spi_transfer(uint8_t *bytes, unsigned size);

#endif
