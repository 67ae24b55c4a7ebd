/* keys.h -- the keys on the handle: GPIO lines that the kernel's gpio-keys debounces. */
#ifndef KINGYO_POI_GADGET_KEYS_H
#define KINGYO_POI_GADGET_KEYS_H

#include <stdint.h>

#define KEYS_DEVICES_MAX 8u /* One for each gpio-keys node; a handle has one. */

struct keys {
    int fd[KEYS_DEVICES_MAX];
    uint32_t count;
    uint32_t held; /* enum poi_button */
};

/* Opens each input device under `root` that gpio-keys drives. None is no fault. */
void keys_open(struct keys *keys, const char *root);

/* enum poi_button levels now. BTN_TRIGGER is OK, BTN_START START, BTN_DPAD_LEFT and _RIGHT LEFT and
 * RIGHT, BTN_THUMB FAN: codes that no console takes for letters. */
uint8_t keys_held(struct keys *keys);

void keys_close(struct keys *keys);

#endif
