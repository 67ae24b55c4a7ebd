/* keys.h -- reads the keys on the poi's handle. The keys are GPIO lines that the kernel's gpio-keys
 * driver debounces. */
#ifndef KINGYO_BOARD_POI_GADGET_KEYS_H
#define KINGYO_BOARD_POI_GADGET_KEYS_H

#include <stdint.h>

/* Maximum number of gpio-keys devices that are opened. A handle has one device. */
#define KEYS_DEVICES_MAX 8u

struct keys {
    int fd[KEYS_DEVICES_MAX];
    uint32_t count;
    uint32_t held; /* Bit mask of the pressed keys (enum poi_button). */
};

/* Opens each input device of the gpio-keys driver. `root` is the prefix of all paths: "" for this
 * machine, or a test folder. A handle without keys is not an error. */
void keys_open(struct keys *keys, const char *root);

/* Returns the pressed keys as a bit mask of enum poi_button. BTN_TRIGGER is OK, BTN_START is START,
 * BTN_DPAD_LEFT is LEFT, BTN_DPAD_RIGHT is RIGHT, and BTN_THUMB is FAN. These key codes were chosen
 * because a text console does not interpret them as letters. */
uint8_t keys_held(struct keys *keys);

/* Closes all input devices. */
void keys_close(struct keys *keys);

#endif
