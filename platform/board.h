/* board.h -- the interface between main() and the board that is linked in (make BOARD=name). */
#ifndef KINGYO_PLATFORM_BOARD_H
#define KINGYO_PLATFORM_BOARD_H

#include <stdint.h>

#include "platform/hal.h"

enum board_poi {
    BOARD_POI_AUTO = 0, /* The best connected controller: USB, then gamepad, then mouse or touch
                           screen. */
    BOARD_POI_MOUSE,
    BOARD_POI_TOUCH,
    BOARD_POI_PAD,
    BOARD_POI_USB,
    BOARD_POI_BOT,
};

enum board_keyboard {
    BOARD_KEYBOARD_AUTO = 0, /* ON on a desktop. OFF in a service because a stranger may plug a
                                keyboard in. */
    BOARD_KEYBOARD_ON,
    BOARD_KEYBOARD_OFF, /* Ignores all keys: no key acts as a button, a coin or quit. */
};

/* Controllers that can be named: the number of rows in struct controller_status. */
#define BOARD_USB_MAX 8u
#define BOARD_USB_SIZE 74u /* "VVVV:PPPP:" and a serial number of 63 bytes. */
#define BOARD_LINE_MAX 32u /* GPIO line options: every role once, and again as override. */
/* "coin-counter=LABEL:OFFSET,low,up,pulse=100ms/100ms" and some reserve. */
#define BOARD_LINE_SIZE 128u

struct library;

struct board_options {
    uint8_t poi;        /* enum board_poi */
    uint32_t usb_count; /* USB controllers that play without being chosen in the menu. */
    const char (*usb)[BOARD_USB_SIZE];
    uint32_t line_count; /* GPIO line options; the last one for a role counts. */
    const char (*line)[BOARD_LINE_SIZE];
    uint8_t keyboard;   /* enum board_keyboard, but never AUTO, because the caller resolves AUTO. */
    uint8_t off_screen; /* 1: render without a screen, to take pictures. */
    uint8_t on_demand;  /* 1: off screen, draw only the frames that become pictures. */
    uint8_t full_screen;
    uint8_t waits_for_screen; /* 1: a screen may be connected after the start. Until then the
                                 display returns HAL_ERR_GONE. */
    uint32_t width, height;   /* Window or picture size in pixels; 0 is the board's default. */
    uint8_t mute;
    const char *data_dir;          /* Folder of the store; null stores nothing. */
    struct view view;              /* View from which the rays of a pointer device start. */
    const struct library *library; /* Species files of makers to show (platform/species/library.h);
                                      null: none. */
    /* Called when the display is lost for good, from inside the display call that detected the
     * loss. The callback must end the program, because memory below the display may not survive the
     * return of that call. Null: no callback. */
    void (*on_display_lost)(void *self);
    void *on_display_lost_self;
    /* Called while the board is opened, once for each rejected line in a file of the data
     * folder, with the text "FILE:LINE: reason". The same line goes to standard error. Null: no
     * callback. */
    void (*on_refused)(void *self, const char *line);
    void *on_refused_self;
};

/* Returns 0 if every text is a valid GPIO line option and no two roles share a line. Otherwise
 * returns -1 and writes the reason to `why`. */
int board_check_lines(const char (*line)[BOARD_LINE_SIZE], uint32_t count, char why[HAL_TEXT_SIZE]);

/* Returns 1 if `text` names a USB controller: "VVVV:PPPP" or "VVVV:PPPP:SERIAL". */
int board_check_usb(const char *text);

/* Connects real drivers where there are devices and null drivers where there are none. Never fails;
 * describe() of each device states what is missing. */
void board_open(struct hal *hal, const struct board_options *options);

/* Releases every device except the display, which may already be lost. Afterwards coins pass
 * through to the return slot, kernel drivers have their controllers again, and all driver threads
 * have ended. */
void board_release_store(struct hal *hal);

/* Releases every device as board_release_store() and closes the display. */
void board_close(struct hal *hal);

/* Opens the board's display off screen with START pressed once at `start_ns`, without controllers,
 * sound or a store. The clock begins at 0 and advances only through board_rehearsal_advance(). The
 * result is the same on every machine. */
void board_open_rehearsal(struct hal *hal, const struct board_options *options, uint64_t start_ns);

/* Advances the clock of board_open_rehearsal() by `ns` nanoseconds. */
void board_rehearsal_advance(uint64_t ns);

/* Returns 1 if a screen can be opened. Otherwise returns 0 and writes one line to `why` (`why_size`
 * bytes). */
int board_has_screen(char *why, size_t why_size);

#endif
