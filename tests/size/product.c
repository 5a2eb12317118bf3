/* SPDX-License-Identifier: MIT
 *
 * What `make size` calls the product: an accelerometer that calibrates itself, from power-on to
 * calibrated readings, with guidance in words, reasons, and a session that survives a reset. It is
 * the program of README.md; what the board does is nothing here.
 */
#include "invcal/store.h"

static const volatile int32_t sample[3];

static const int32_t *board_sample(void)
{
    return (const int32_t *)sample;
}

static void board_show(const char *text)
{
    (void)*(const volatile char *)text;
}

static void board_use(const invcal_real *calibrated)
{
    (void)*(const volatile invcal_real *)calibrated;
}

static int board_read(void *context, unsigned slot, uint32_t offset, uint8_t *bytes, uint32_t size)
{
    (void)context, (void)slot, (void)offset, (void)size;
    return *(volatile uint8_t *)bytes;
}

static int board_erase(void *context, unsigned slot)
{
    (void)context;
    return (int)slot;
}

static int board_program(void *context, unsigned slot, uint32_t offset, const uint8_t *bytes,
                         uint32_t size)
{
    (void)context, (void)slot, (void)offset, (void)size;
    return *(const volatile uint8_t *)bytes;
}

static const invcal_store board_calibration = {board_read, board_erase, board_program, NULL, 512, 8};
static const invcal_store board_progress = {board_read, board_erase, board_program, NULL, 512, 8};

static invcal_session session;

int main(void)
{
    invcal_calibration calibration; /* raw counts to g */
    invcal_quality quality;
    invcal_real a[3];
    char words[INVCAL_WORDS];

    if (invcal_load(&board_calibration, &calibration) != INVCAL_OK) {
        if (invcal_load_session(&board_progress, &session) != INVCAL_OK) {
            invcal_session_init(&session, 16384, 100); /* counts per g, samples per second */
        }
        while (!invcal_session_is_good(&session)) {
            switch (invcal_session_feed(&session, board_sample())) {
            case INVCAL_READY:   board_show(invcal_session_next_words(&session, words)); break;
            case INVCAL_TAKEN:   invcal_save_session(&board_progress, &session); break;
            case INVCAL_REFUSED: board_show(invcal_session_why(&session)); break;
            default: break;
            }
        }
        invcal_session_solve(&session, &calibration, &quality);
        invcal_save(&board_calibration, &calibration, &quality);
    }
    for (;;) {
        invcal_apply_counts(&calibration, board_sample(), a);
        board_use(a);
    }
}
