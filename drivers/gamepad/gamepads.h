/* gamepads.h -- game pads with hot-plug, through SDL's game controller API and its mapping
 * database.
 *
 * Needs SDL's video subsystem for the event queue. The owner of the window pumps the queue.
 * gamepads_poll() removes joystick and controller events from the queue and leaves all other
 * events.
 *
 * At most GAMEPADS_MAX game pads are used. A game pad that is plugged in again returns to its
 * former element of `pad`. A game pad without an SDL mapping is ignored. A mapping file or
 * $SDL_GAMECONTROLLERCONFIG can add a mapping, or the operator can let the kiosk learn the pad as a
 * HID device.
 *
 * Devices that other drivers use must be excluded (gamepads_exclude()), so that each device has one
 * owner. */
#pragma once

#include <SDL_gamecontroller.h>
#include <stdbool.h>

#include "drivers/gamepad/gamepad_decoder.h"
#include "drivers/usb/usb_choice.h"
#include "platform/hal.h"

#define GAMEPADS_MAX POI_MAX
/* Largest number of excluded devices: at most 32 devices that the operator selected for the USB
 * driver, and at most eight devices that the USB driver uses without a selection. */
#define GAMEPADS_EXCLUSION_MAX 40u
#define GAMEPAD_GUID_SIZE 33u

struct gamepad {
    struct gamepads *gamepads;
    SDL_GameController *controller; /* SDL's handle, or null while no game pad is plugged in. */
    int32_t instance;               /* SDL's instance id, which is new at each connection. */
    char guid[GAMEPAD_GUID_SIZE];   /* SDL's GUID of the game pad that used this element last. */
    char serial[32];                /* Serial number from SDL, or "" if unknown. */
    /* USB ids, and the serial number from /sys, or "" if unknown. */
    struct usb_key usb;
    bool was_here;                /* True if a game pad used this element before. */
    struct gamepad_report now;    /* State of the pad after the newest event. */
    struct gamepad_queue track;   /* Reports that are not decoded yet. */
    struct gamepad_rumble rumble; /* Motor levels that were sent last. */
    uint64_t rumble_ns;           /* Time at which `rumble` was sent. */
    bool cannot_rumble;           /* True if the pad has no motors. */
    char text[HAL_TEXT_SIZE];
};

struct gamepads {
    struct hal_clock clock;
    struct view view;
    struct gamepad pad[GAMEPADS_MAX];
    /* List of devices that must not be opened as game pads, because other drivers use them. */
    struct usb_key bar[GAMEPADS_EXCLUSION_MAX];
    uint32_t bar_count;
    bool is_open;       /* True while SDL's game controllers are started. */
    uint64_t pumped_ns; /* Time at which SDL's events were processed last. */
    char text[HAL_TEXT_SIZE];
};

/* Initializes the state without starting SDL. `view` is copied. */
void gamepads_init(struct gamepads *gamepads, struct hal_clock clock, const struct view *view);

/* Replaces the list of excluded devices by the `count` entries of `bar`. Other drivers use the
 * excluded devices. An excluded game pad is not opened, and is closed if it is open. A product that
 * is excluded without a serial number is also added to SDL's ignore hint, which has no serial
 * numbers.
 *
 * For devices that are already plugged in, this function must be called before gamepads_open(). At
 * most GAMEPADS_EXCLUSION_MAX entries are used. All bytes after the end of a serial number must be
 * 0. A call with an unchanged list has no effect. */
void gamepads_exclude(struct gamepads *gamepads, const struct usb_key *bar, uint32_t count);

/* Returns true if the game pad `key` is excluded. An unknown serial number ("") matches every
 * serial number of the product. */
bool gamepads_is_excluded(const struct gamepads *gamepads, const struct usb_key *key);

/* Starts SDL's game controllers. `database` is the path of a file with further mappings. `database`
 * may be null, and the file may be missing. Returns HAL_OK. Returns HAL_ERR_ABSENT with the reason
 * in gamepads->text if SDL fails. After a failure no game pad can be used. */
int gamepads_open(struct gamepads *gamepads, const char *database);

/* Closes all game pads and stops SDL's game controllers. */
void gamepads_close(struct gamepads *gamepads);

/* Processes SDL's pending game pad events. */
void gamepads_poll(struct gamepads *gamepads);

/* ---- Devices of struct hal (gamepad_poi.c) --------------------------------------------------- */

/* Returns the poi and the fan of game pad `index` (0 to GAMEPADS_MAX - 1), and the button device of
 * all game pads. The buttons are START, LEFT, RIGHT, OK and LANGUAGE. The pois must be polled
 * before the buttons. */
struct hal_controller_devices gamepad_poi_devices(struct gamepads *gamepads, uint32_t index);

/* Returns true if the game pad `pad` (a struct gamepad) is plugged in. Processes pending events
 * first. */
bool gamepad_poi_is_present(void *pad);
