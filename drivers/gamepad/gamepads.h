/* gamepads.h -- game pads with hot-plug, through SDL's game controller API and its mapping
 * database.
 *
 * Needs SDL's video subsystem for the event queue; the owner of the window pumps the queue.
 * Removes joystick and controller events from the queue and no others. At most GAMEPADS_MAX pads
 * are used, and a replugged pad returns to its own place. A pad without an SDL mapping is ignored.
 * A mapping file or $SDL_GAMECONTROLLERCONFIG can add a mapping, or the pad can be learned as a HID
 * device. Devices of another driver are barred first, so that each device has one owner. */
#ifndef KINGYO_DRIVERS_GAMEPAD_GAMEPADS_H
#define KINGYO_DRIVERS_GAMEPAD_GAMEPADS_H

#include "drivers/gamepad/gamepad_queue.h"
#include "drivers/hid/hid_port.h"
#include "platform/hal.h"

#define GAMEPADS_MAX POI_MAX
/* 32 keys chosen for USB, and eight devices that play there without being chosen. */
#define GAMEPADS_EXCLUSION_MAX 40u
#define GAMEPAD_GUID_SIZE 33u

struct _SDL_GameController;

struct gamepad {
    struct gamepads *gamepads;
    struct _SDL_GameController *controller; /* Null while no pad is plugged in. */
    int32_t instance;                       /* SDL's id, new at each connection. */
    char guid[GAMEPAD_GUID_SIZE];           /* SDL's GUID of the last device. */
    char serial[32];                        /* Serial number from SDL, or "". */
    uint16_t vendor, product;               /* USB vendor and product id. */
    char usb_serial[HID_TEXT_SIZE];         /* Serial number from /sys; "": not known. */
    uint8_t was_here;
    struct gamepad_report now;
    struct gamepad_queue track;
    struct gamepad_rumble rumble; /* Motor levels sent last. */
    uint64_t rumble_ns;           /* Time at which `rumble` was sent. */
    uint8_t cannot_rumble;
    char text[HAL_TEXT_SIZE];
};

/* A USB device of another driver: the one with this serial number, or all of its product. */
struct gamepad_exclusion {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": all devices of the product. */
};

struct gamepads {
    struct hal_clock clock;
    struct view view;
    struct gamepad pad[GAMEPADS_MAX];
    struct gamepad_exclusion bar[GAMEPADS_EXCLUSION_MAX];
    uint32_t bar_count;
    uint8_t is_open;
    uint64_t pumped_ns;
    char text[HAL_TEXT_SIZE];
};

/* Initializes the state without starting SDL. `view` is copied. */
void gamepads_init(struct gamepads *gamepads, struct hal_clock clock, const struct view *view);

/* Replaces the list of barred devices, which other drivers own. Barred devices are not opened,
 * and a barred pad that is open is closed. A product without serial numbers is also given to
 * SDL's ignore hint, which does not support serial numbers. Must be called before gamepads_open()
 * for devices that are already plugged in. At most GAMEPADS_EXCLUSION_MAX entries are used; bytes
 * after the end of a serial number must be 0. An unchanged list has no effect. */
void gamepads_exclude(struct gamepads *gamepads, const struct gamepad_exclusion *bar,
                      uint32_t count);

/* Returns 1 if the pad is barred. A pad with unknown serial number matches any serial number. */
int gamepads_is_excluded(const struct gamepads *gamepads, uint16_t vendor, uint16_t product,
                         const char *serial);

/* Starts SDL's game controllers. `database` is a file of further mappings, which may be null or
 * missing. Returns HAL_OK, or HAL_ERR_ABSENT with the reason in pads->text; there are then no
 * pads. */
int gamepads_open(struct gamepads *gamepads, const char *database);

/* Closes all pads and stops SDL's game controllers. */
void gamepads_close(struct gamepads *gamepads);

/* Processes SDL's pending pad events. */
void gamepads_poll(struct gamepads *gamepads);
uint64_t gamepads_now_ns(const struct gamepads *gamepads);

#endif
