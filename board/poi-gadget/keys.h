/* keys.h -- reads the keys on the handle, GPIO lines that the kernel's gpio-keys driver
 * debounces. */
#ifndef KINGYO_BOARD_POI_GADGET_KEYS_H
#define KINGYO_BOARD_POI_GADGET_KEYS_H

#include <stdint.h>

#define KEYS_DEVICES_MAX 8u /* Maximum number of gpio-keys devices. A handle has one. */

struct keys {
    int fd[KEYS_DEVICES_MAX];
    uint32_t count;
    uint32_t held; /* Pressed keys, enum poi_button. */
};

/* Opens each input device under `root` that gpio-keys drives. A handle without keys is not an
 * error. */
void keys_open(struct keys *keys, const char *root);

/* Returns the pressed keys as enum poi_button. BTN_TRIGGER is OK, BTN_START is START, BTN_DPAD_LEFT
 * is LEFT, BTN_DPAD_RIGHT is RIGHT, and BTN_THUMB is FAN. A text console does not interpret these
 * codes as letters. */
uint8_t keys_held(struct keys *keys);

/* Closes all input devices. */
void keys_close(struct keys *keys);

#endif
