/* pads.h -- game pads that come and go, through SDL's game controllers and its database of them.
 *
 * Needs SDL's video for the event queue and whoever owns the window to pump it. Takes joystick and
 * controller events from the queue and no others. Up to PADS_MAX pads; one that is pulled out comes
 * back to its own place. A pad that SDL has no mapping for is not taken: a file of mappings or
 * $SDL_GAMECONTROLLERCONFIG may add one, and as a HID device it can be learned instead. Devices
 * that another driver of ours holds are barred first: one owner a device. */
#ifndef KINGYO_DRIVERS_PADS_H
#define KINGYO_DRIVERS_PADS_H

#include "drivers/hid_port.h"
#include "drivers/pad_track.h"
#include "platform/hal.h"

#define PADS_MAX POI_MAX
#define PADS_BAR_MAX 40u /* The 32 that USB lets name, and eight that play there unnamed. */
#define PAD_GUID_SIZE 33u

struct _SDL_GameController;

struct pad {
    struct pads *pads;
    struct _SDL_GameController *controller; /* Null: nobody holds this one now. */
    int32_t instance;                       /* Of SDL, of this plugging in. */
    char guid[PAD_GUID_SIZE];               /* Who it was last: SDL's model number ... */
    char serial[32];                        /* ... and its own, "" where it says none. */
    uint16_t vendor, product;               /* On USB, ... */
    char usb_serial[HID_TEXT_SIZE];         /* ... as the kernel has read it; "": not known. */
    uint8_t was_here;
    struct pad_report now;
    struct pad_track track;
    struct pad_rumble rumble;               /* As it hums by now, ... */
    uint64_t rumble_ns;                     /* ... and since when. */
    uint8_t cannot_rumble;
    char text[HAL_TEXT_SIZE];
};

/* A USB device that is another driver's: the one with that serial number, or all of its kind. */
struct pad_bar {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": all. */
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

void pads_init(struct pads *pads, struct hal_clock clock, const struct view *view);

/* From now on these, and no others, are another driver's: they are not opened, and one that is a
 * pad of ours is let go. Where all of a kind are meant SDL does not even look at them: its hint
 * knows no serial numbers. Before pads_open() for those that are plugged in already. At most
 * PADS_BAR_MAX are heeded; bytes behind a serial number's end are 0. Asked again with the same it
 * does nothing. */
void pads_bar(struct pads *pads, const struct pad_bar *bar, uint32_t count);

/* Whether such a pad is another driver's. One whose number is not known may be the one that is. */
int pads_are_barred(const struct pads *pads, uint16_t vendor, uint16_t product,
                    const char *serial);

/* Begins SDL's controllers. `database`: a file of further mappings; null, or not there: none.
 * HAL_ERR_NONE, and pads->text says why: there will be no pads. */
int pads_open(struct pads *pads, const char *database);
void pads_close(struct pads *pads);

/* Takes what SDL's queue holds of them. */
void pads_pump(struct pads *pads);
uint64_t pads_now_ns(const struct pads *pads);

#endif
