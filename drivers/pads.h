/* pads.h -- game pads with hot-plug, through SDL's game controller API and its mapping database.
 *
 * Needs SDL's video subsystem for the event queue; the owner of the window pumps the queue.
 * Removes joystick and controller events from the queue and no others. At most PADS_MAX pads are
 * used, and a replugged pad returns to its own place. A pad without an SDL mapping is ignored. A
 * mapping file or $SDL_GAMECONTROLLERCONFIG can add a mapping, or the pad can be learned as a
 * HID device. Devices of another driver are barred first, so that each device has one owner. */
#ifndef KINGYO_DRIVERS_PADS_H
#define KINGYO_DRIVERS_PADS_H

#include "drivers/hid_port.h"
#include "drivers/pad_track.h"
#include "platform/hal.h"

#define PADS_MAX POI_MAX
/* 32 keys chosen for USB, and eight devices that play there without being chosen. */
#define PADS_BAR_MAX 40u
#define PAD_GUID_SIZE 33u

struct _SDL_GameController;

struct pad {
    struct pads *pads;
    struct _SDL_GameController *controller; /* Null while no pad is plugged in. */
    int32_t instance;                       /* SDL's id, new at each connection. */
    char guid[PAD_GUID_SIZE];               /* SDL's GUID of the last device. */
    char serial[32];                        /* Serial number from SDL, or "". */
    uint16_t vendor, product;               /* USB vendor and product id. */
    char usb_serial[HID_TEXT_SIZE];         /* Serial number from /sys; "": not known. */
    uint8_t was_here;
    struct pad_report now;
    struct pad_track track;
    struct pad_rumble rumble;               /* Motor levels sent last. */
    uint64_t rumble_ns;                     /* Time at which `rumble` was sent. */
    uint8_t cannot_rumble;
    char text[HAL_TEXT_SIZE];
};

/* A USB device of another driver: the one with this serial number, or all of its product. */
struct pad_bar {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": all devices of the product. */
};

struct pads {
    struct hal_clock clock;
    struct view view;
    struct pad pad[PADS_MAX];
    struct pad_bar bar[PADS_BAR_MAX];
    uint32_t bar_count;
    uint8_t is_open;
    uint64_t pumped_ns;
    char text[HAL_TEXT_SIZE];
};

/* Initializes the state without starting SDL. `view` is copied. */
void pads_init(struct pads *pads, struct hal_clock clock, const struct view *view);

/* Replaces the list of barred devices, which other drivers own. Barred devices are not opened,
 * and a barred pad that is open is closed. A product without serial numbers is also given to
 * SDL's ignore hint, which does not support serial numbers. Must be called before pads_open()
 * for devices that are already plugged in. At most PADS_BAR_MAX entries are used; bytes after
 * the end of a serial number must be 0. An unchanged list has no effect. */
void pads_bar(struct pads *pads, const struct pad_bar *bar, uint32_t count);

/* Returns 1 if the pad is barred. A pad with unknown serial number matches any serial number. */
int pads_are_barred(const struct pads *pads, uint16_t vendor, uint16_t product,
                    const char *serial);

/* Starts SDL's game controllers. `database` is a file of further mappings, which may be null or
 * missing. Returns HAL_OK, or HAL_ERR_NONE with the reason in pads->text; there are then no
 * pads. */
int pads_open(struct pads *pads, const char *database);

/* Closes all pads and stops SDL's game controllers. */
void pads_close(struct pads *pads);

/* Processes SDL's pending pad events. */
void pads_pump(struct pads *pads);
uint64_t pads_now_ns(const struct pads *pads);

#endif
