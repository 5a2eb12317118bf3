/* SPDX-License-Identifier: MIT
 *
 * An AVR in simavr: UART 0 for text, timer 1 as a cycle counter.
 */
#include "board.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <string.h>

/* The stack grows down towards the data, unchecked. These bytes are at the end of the data: if they
 * have changed at the end of the run, the stack has overflowed. */
enum { GUARD = 64, GUARD_BYTE = 0xA5 };
__attribute__((section(".noinit"))) static uint8_t guard[GUARD];

static volatile uint16_t overflows;

ISR(TIMER1_OVF_vect)
{
    overflows++;
}

__attribute__((constructor)) void board_begin(void)
{
    memset(guard, GUARD_BYTE, sizeof guard);
    UCSR0A = _BV(U2X0); /* with UBRR0 0 an eighth of the clock: 80 cycles for a character */
    UCSR0B = _BV(TXEN0);
    TCCR1B = _BV(CS10); /* every cycle */
    TIMSK1 = _BV(TOIE1);
    sei();
}

void board_put(int c)
{
    while (!(UCSR0A & _BV(UDRE0))) {
    }
    UDR0 = (uint8_t)c;
}

static int is_guard_intact(void)
{
    for (unsigned i = 0; i < GUARD; i++) {
        if (guard[i] != GUARD_BYTE) {
            return 0;
        }
    }
    return 1;
}

/* From flash, since RAM may be corrupted. */
static void report_overflow(void)
{
    static const char message[] PROGMEM = "FAIL: the stack has met the data\n";
    char c;

    for (const char *text = message; (c = (char)pgm_read_byte(text)) != '\0'; text++) {
        board_put(c);
    }
}

/* simavr ends when the processor sleeps with interrupts off. It has no exit status: the last line
 * of the text shows a failure. */
void board_exit(int code)
{
    (void)code;
    if (!is_guard_intact()) {
        report_overflow();
    }
    cli();
    sleep_enable();
    for (;;) {
        sleep_cpu();
    }
}

/* An overflow that has not been counted yet is in the flag; TCNT1 is then small. */
uint32_t board_count(void)
{
    const uint8_t interrupts = SREG;

    cli();
    const uint16_t low = TCNT1;
    uint16_t high = overflows;
    if ((TIFR1 & _BV(TOV1)) && low < 0x8000u) {
        high++;
    }
    SREG = interrupts;
    return (uint32_t)high << 16 | low;
}

/* avr-libc runs this after main, whose result is in the register of the first argument. */
__attribute__((naked, used, section(".fini1"))) static void after_main(void)
{
    __asm volatile("jmp board_exit");
}
