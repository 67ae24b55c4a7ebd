/* board.h -- the interface between main() and the board, which is the set of drivers selected at
 * build time (make BOARD=name). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "platform/hal.h"

enum board_poi {
    /* Selects the best connected controller: USB, then gamepad, then mouse or touch screen. */
    BOARD_POI_AUTO = 0,
    BOARD_POI_MOUSE,
    BOARD_POI_TOUCH,
    BOARD_POI_PAD,
    BOARD_POI_USB,
    BOARD_POI_BOT,
};

enum board_keyboard {
    /* The caller replaces this value by ON on a desktop. If the program runs as a system service,
     * the caller replaces it by OFF, because a stranger may plug a keyboard into the kiosk. */
    BOARD_KEYBOARD_AUTO = 0,
    BOARD_KEYBOARD_ON,
    BOARD_KEYBOARD_OFF, /* Ignores all keys. No key acts as a button, inserts a coin or quits. */
};

/* Maximum number of USB controllers that the options can name. It equals the number of rows in
 * struct controller_status. */
#define BOARD_USB_MAX 8u
/* Size in bytes of "VVVV:PPPP:" and a serial number of 63 bytes, with the terminating zero. */
#define BOARD_USB_SIZE 74u
/* Maximum number of GPIO line options. Each role of a line (for example "coin-counter") may be set
 * once and overridden once. */
#define BOARD_LINE_MAX 32u
/* Size in bytes of a GPIO line option, for example
 * "coin-counter=LABEL:OFFSET,low,up,pulse=100ms/100ms", with a reserve. */
#define BOARD_LINE_SIZE 128u

struct library;

struct board_options {
    uint8_t poi; /* Type of the controller with which the player plays (enum board_poi). */
    /* Number of USB controllers that may play without being selected in the menu. */
    uint32_t usb_count;
    const char (*usb)[BOARD_USB_SIZE];
    /* Number of GPIO line options. If several options have the same role, the last one is used. */
    uint32_t line_count;
    const char (*line)[BOARD_LINE_SIZE];
    /* Keyboard mode: BOARD_KEYBOARD_ON or BOARD_KEYBOARD_OFF. The caller has replaced
     * BOARD_KEYBOARD_AUTO by one of the two. */
    uint8_t keyboard;
    bool off_screen; /* True if frames are rendered without a screen, to write pictures. */
    /* True if the renderer draws only the frames that are written as pictures. Callers set this
     * field only together with `off_screen`. */
    bool on_demand;
    bool full_screen;
    /* True if a screen may be connected after program start. Without a screen the display returns
     * HAL_ERR_GONE. */
    bool waits_for_screen;
    uint32_t width, height; /* Window or picture size in pixels. 0 means the board's default. */
    /* Width of the picture without its words, in per cent of the screen's width. 0 means the
     * renderer's default for the graphics hardware. */
    uint32_t detail;
    bool mute;
    const char *data_dir; /* Folder of the store. Null means that nothing is stored. */
    struct view view;     /* Camera view from which the rays of a pointer device start. */
    /* Installed species files to show (platform/species/library.h). Null means no species files. */
    const struct library *library;
    /* Callback for a permanent loss of the display, called by the display function that detected
     * the loss. The callback must end the program and must not return, because the windowing
     * library and the renderer are not usable after the loss. Null means no callback. */
    void (*on_display_lost)(void *self);
    void *on_display_lost_self;
    /* Callback for each rejected line in a file of the data folder. board_open() calls it with
     * the text "FILE:LINE: reason". The text is also written to standard error. Null means no
     * callback. */
    void (*on_refused)(void *self, const char *line);
    void *on_refused_self;
};

/* Returns 0 if every text is a valid GPIO line option and no two roles share a GPIO line. Otherwise
 * returns -1 and writes the reason to `why`. */
int board_check_lines(const char (*line)[BOARD_LINE_SIZE], uint32_t count, char why[HAL_TEXT_SIZE]);

/* Returns true if `text` names a USB controller ("VVVV:PPPP" or "VVVV:PPPP:SERIAL"). */
bool board_check_usb(const char *text);

/* Opens a real driver for each connected device and a null driver for each missing device. Never
 * fails. describe() of each device states what is missing. */
void board_open(struct hal *hal, const struct board_options *options);

/* Closes every device except the display, which may already be lost. After the call, the coin slot
 * returns all coins, the kernel drivers control their devices again, and all driver threads have
 * ended. */
void board_release_store(struct hal *hal);

/* Closes every device, including the display. */
void board_close(struct hal *hal);

/* Opens the board's display off screen, without controllers, sound or a store. START is pressed
 * once, at `start_ns`. The clock starts at 0 and advances only through board_rehearsal_advance().
 * The resulting frames are identical on every machine. */
void board_open_rehearsal(struct hal *hal, const struct board_options *options, uint64_t start_ns);

/* Advances the clock of board_open_rehearsal() by `ns` nanoseconds. */
void board_rehearsal_advance(uint64_t ns);

/* Returns true if a screen can be opened. Otherwise returns false and writes one line with the
 * reason to `why` (`why_size` bytes). */
bool board_has_screen(char *why, size_t why_size);
