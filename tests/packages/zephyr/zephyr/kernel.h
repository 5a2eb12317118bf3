/* SPDX-License-Identifier: MIT
 *
 * In place of Zephyr's header of this name: what the sample uses of it, as its documentation says.
 */
#ifndef MOCK_KERNEL_H
#define MOCK_KERNEL_H

#include <stdint.h>

typedef struct {
    int64_t ticks;
} k_timeout_t;
#define K_USEC(t) ((k_timeout_t){(t)})

struct k_timer {
    k_timeout_t period;
};
#define K_TIMER_DEFINE(name, expiry_fn, stop_fn) struct k_timer name = {{0}}

void k_timer_start(struct k_timer *timer, k_timeout_t duration, k_timeout_t period);

/* Waits until the timer has expired; how many times since it was asked last. */
uint32_t k_timer_status_sync(struct k_timer *timer);

#endif
