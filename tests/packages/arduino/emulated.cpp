/* SPDX-License-Identifier: MIT
 *
 * emulated FLASH save TEXT   saves the text in the calibration store. Exit status 0 if it was stored
 * emulated FLASH fail TEXT   the same with a flash that fails
 * emulated FLASH load        prints the text
 *
 * Each run is a power-on: only what is in the flash lasts.
 */
#include <EEPROM.h>
#include <stdio.h>
#include <string.h>

#include "storage.h"

mock_eeprom EEPROM;

static int load()
{
    uint8_t bytes[64];
    uint32_t size;

    if (invcal_store_load(&calibration_store, bytes, sizeof bytes, &size) != INVCAL_OK) {
        return 1;
    }
    printf("%.*s\n", (int)size, (const char *)bytes);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        return 2;
    }
    EEPROM.flash = argv[1];
    if (argc == 3) {
        return load();
    }
    EEPROM.fails = strcmp(argv[2], "fail") == 0;
    return invcal_store_save(&calibration_store, (const uint8_t *)argv[3], (uint32_t)strlen(argv[3])) != INVCAL_OK;
}
