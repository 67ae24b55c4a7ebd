/* keys.c -- reads key events from the kernel. If the kernel reports that events were lost, the
 * state of all keys is read again. */
#include "board/poi-gadget/keys.h"

#include <fcntl.h>
#include <linux/input.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "drivers/hid/poi_report.h"

#define EVENT_DEVICES 32u
/* Maximum number of events in one read. Even a bouncing key sends fewer events. */
#define EVENTS_MAX 16

static const struct key_code {
    uint16_t code;
    uint8_t button;
} codes[] = {
    { BTN_TRIGGER, POI_BUTTON_OK },     { BTN_START, POI_BUTTON_START },
    { BTN_DPAD_LEFT, POI_BUTTON_LEFT }, { BTN_DPAD_RIGHT, POI_BUTTON_RIGHT },
    { BTN_THUMB, POI_BUTTON_FAN },
};
#define CODE_COUNT (sizeof codes / sizeof codes[0])

static int is_gpio_keys(const char *root, uint32_t number)
{
    char path[256], phys[32] = "";
    snprintf(path, sizeof path, "%s/sys/class/input/event%u/device/phys", root, number);
    FILE *file = fopen(path, "r");
    if (!file) {
        return 0;
    }
    const int got = fgets(phys, sizeof phys, file) != NULL;
    fclose(file);
    return got && strncmp(phys, "gpio-keys/", 10) == 0;
}

/* Adds the keys that the kernel reports as pressed to `held`. If the kernel returns an error,
 * `held` is unchanged. */
static void ask_levels(struct keys *keys, int fd)
{
    uint8_t bits[KEY_MAX / 8 + 1] = { 0 };
    if (ioctl(fd, EVIOCGKEY(sizeof bits), bits) < 0) {
        return;
    }
    for (size_t k = 0; k < CODE_COUNT; k++) {
        if (bits[codes[k].code / 8] >> codes[k].code % 8 & 1) {
            keys->held |= codes[k].button;
        }
    }
}

void keys_open(struct keys *keys, const char *root)
{
    *keys = (struct keys){ 0 };
    for (uint32_t i = 0; i < EVENT_DEVICES && keys->count < KEYS_DEVICES_MAX; i++) {
        char path[256];
        snprintf(path, sizeof path, "%s/dev/input/event%u", root, i);
        const int fd = is_gpio_keys(root, i) ? open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC) : -1;
        if (fd >= 0) {
            keys->fd[keys->count++] = fd;
            ask_levels(keys, fd);
        }
    }
}

static void keys_take_event(struct keys *keys, const struct input_event *event)
{
    if (event->type == EV_SYN && event->code == SYN_DROPPED) {
        keys->held = 0;
        for (uint32_t i = 0; i < keys->count; i++) {
            ask_levels(keys, keys->fd[i]);
        }
    }
    for (size_t k = 0; k < CODE_COUNT && event->type == EV_KEY; k++) {
        if (codes[k].code == event->code) {
            keys->held = event->value ? keys->held | codes[k].button
                                      : keys->held & ~(uint32_t)codes[k].button;
        }
    }
}

uint8_t keys_held(struct keys *keys)
{
    for (uint32_t i = 0; i < keys->count; i++) {
        struct input_event events[EVENTS_MAX];
        const ssize_t size = read(keys->fd[i], events, sizeof events);
        for (ssize_t e = 0; e < size / (ssize_t)sizeof events[0]; e++) {
            keys_take_event(keys, &events[e]);
        }
    }
    return (uint8_t)keys->held;
}

void keys_close(struct keys *keys)
{
    for (uint32_t i = 0; i < keys->count; i++) {
        close(keys->fd[i]);
    }
    keys->count = 0;
}
