/* SPDX-License-Identifier: MIT
 *
 * Internal: loading the beginning of a structure, whose first member identifies its layout.
 */
#ifndef INVCAL_LAYOUT_H
#define INVCAL_LAYOUT_H

#include "invcal/store.h"

/* Of a session: the size before the means, and an identifier of layout, number type and byte
 * order. */
#define INVCAL_SESSION_HEAD ((uint32_t)offsetof(invcal_session, mean))
#define INVCAL_SESSION_LAYOUT                                                                      \
    (UINT32_C(0x5E040000) + (uint32_t)sizeof(invcal_real) * 256u + INVCAL_SESSION_HEAD)

/* As invcal_store_load, but INVCAL_OTHER_VERSION, and nothing is written, unless the data begin
 * with this layout, in the byte order of the machine. */
invcal_status invcal_store_load_layout(const invcal_store *store, uint32_t layout, uint8_t *bytes,
                                       uint32_t capacity, uint32_t *size);

#endif
