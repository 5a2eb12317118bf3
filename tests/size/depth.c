/* SPDX-License-Identifier: MIT
 *
 * How deep the stack really gets: paints it, calls a function, looks how much paint is gone, and
 * prints "function bytes" for each, and OK. The compiler's frames and the call graph must not give
 * less.
 */
#include <stddef.h>

#include "../report.h"
#include "invcal/expert.h"

enum { DEPTH = 3072, GUARD = 48, PAINT = 0xA5 };

__attribute__((always_inline)) static inline uintptr_t stack_pointer(void)
{
    uintptr_t at;

#if defined(__arm__)
    __asm volatile("mov %0, sp" : "=r"(at));
#elif defined(__riscv)
    __asm volatile("mv %0, sp" : "=r"(at));
#elif defined(__powerpc__)
    __asm volatile("mr %0, 1" : "=r"(at));
#elif defined(__AVR__)
    at = *(volatile uint16_t *)0x5D + 1u; /* it points to the next free byte */
#else
#error "no way to read the stack pointer here"
#endif
    return at;
}

static volatile uint8_t *lowest;

/* Paints the stack below the caller, but for the bytes that this function may use itself. */
__attribute__((noinline)) static void paint(uintptr_t top)
{
    lowest = (volatile uint8_t *)(top - DEPTH);
    for (volatile uint8_t *at = lowest; at < (volatile uint8_t *)(top - GUARD); at++) {
        *at = PAINT;
    }
}

__attribute__((noinline)) static unsigned used(uintptr_t top)
{
    const volatile uint8_t *at = lowest;

    while (*at == PAINT) {
        at++;
    }
    return (unsigned)(top - (uintptr_t)at);
}

static invcal_session session;
static invcal_sums sums;
static invcal_calibration calibration;
static invcal_quality quality;
static invcal_real up[3];

/* How many bytes of stack a call takes. */
#define MEASURE(call) (paint(stack_pointer()), (void)(call), used(stack_pointer()))

/* Two seconds at rest in one of 18 orientations and half a second of motion, 50 samples per
 * second; 1024 counts are 1 g. Returns the deepest. */
static unsigned feed_position(const int32_t rest[3], uint32_t *random)
{
    unsigned deepest = 0;

    for (unsigned i = 0; i < 125; i++) {
        const uint32_t size = i < 100 ? 7 : 2047;
        int32_t raw[3];
        for (unsigned k = 0; k < 3; k++) {
            *random = *random * UINT32_C(1664525) + UINT32_C(1013904223);
            raw[k] = rest[k] + (int32_t)((*random >> 20) & size) - (int32_t)(size / 2);
        }
        const unsigned depth = MEASURE(invcal_session_feed(&session, raw[0], raw[1], raw[2]));
        deepest = depth > deepest ? depth : deepest;
    }
    return deepest;
}

/* Six faces and twelve edges. */
static const int8_t direction[18][3] = {
    {1, 0, 0},  {-1, 0, 0},  {0, 1, 0},  {0, -1, 0},  {0, 0, 1},  {0, 0, -1},
    {1, 1, 0},  {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0},  {1, 0, 1},  {-1, 0, -1},
    {1, 0, -1}, {-1, 0, 1},  {0, 1, 1},  {0, -1, -1}, {0, 1, -1}, {0, -1, 1},
};

int main(void)
{
    uint32_t random = 1;
    unsigned deepest = 0;

#ifdef __AVR__
    __asm volatile("cli"); /* the interrupts of the board have a stack use of their own */
#endif
    if (invcal_session_init(&session, sizeof session, 1024, 50) != INVCAL_OK) {
        return 1;
    }
    for (unsigned i = 0; i < 18; i++) {
        const int8_t *const d = direction[i];
        const int32_t length = i < 6 ? 1024 : 724;
        /* One position is wrong: the search for outliers runs to its end. */
        const int32_t rest[3] = {d[0] * length + (i == 10 ? 60 : 0), d[1] * length, d[2] * length};
        const unsigned depth = feed_position(rest, &random);
        deepest = depth > deepest ? depth : deepest;
    }
    if (session.count < 16) {
        return 1;
    }
    report("invcal_session_feed", deepest);
    report("invcal_session_solve", MEASURE(invcal_session_solve(&session, &calibration, &quality)));
    report("invcal_session_next", MEASURE((invcal_session_next(&session, up), 0)));
    for (unsigned i = 0; i < session.count; i++) {
        (void)invcal_sums_add(&sums, &session.nominal, session.mean[i].v, 1);
    }
    report("invcal_sums_solve", MEASURE(invcal_sums_solve(&sums, &session.nominal, &calibration)));
    report_text("OK\n");
    return 0;
}
