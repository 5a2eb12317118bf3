/* SPDX-License-Identifier: MIT
 *
 * spi.h: the bus to the sensor. Yours to write; sim/spi_sim.c stands in for it here.
 */
#ifndef SPI_H
#define SPI_H

#include <stdint.h>

/* Selects the chip, exchanges size bytes (what it answers replaces what was sent), deselects it. */
void spi_transfer(uint8_t *bytes, unsigned size);

#endif
