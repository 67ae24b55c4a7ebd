/* board.h -- what main() asks of the one board that was linked in (make BOARD=name). */
#ifndef KINGYO_PLATFORM_BOARD_H
#define KINGYO_PLATFORM_BOARD_H

#include <stdint.h>

#include "platform/hal.h"

enum board_poi {
    BOARD_POI_AUTO = 0, /* The best that is plugged in: USB, then a pad, then mouse or finger. */
    BOARD_POI_MOUSE,
    BOARD_POI_TOUCH,
    BOARD_POI_PAD,
    BOARD_POI_USB,
    BOARD_POI_BOT,
};

enum board_keyboard {
    BOARD_KEYBOARD_AUTO = 0, /* ON at a desk, OFF as a service: a stranger may plug one in. */
    BOARD_KEYBOARD_ON,
    BOARD_KEYBOARD_OFF,      /* No key is a button, a coin or a way out. */
};

#define BOARD_USB_MAX 8u     /* Controllers that are named: as many as the desk has rows. */
#define BOARD_USB_SIZE 74u   /* "VVVV:PPPP:" and a serial number of 63 bytes. */
#define BOARD_LINE_MAX 32u   /* Wires: every role once, and again to overrule the file's. */
#define BOARD_LINE_SIZE 128u /* "coin-counter=LABEL:OFFSET,low,up,pulse=100ms/100ms", and some. */

struct shelf;

struct board_options {
    uint8_t poi;               /* enum board_poi */
    uint32_t usb_count;        /* Controllers that play without being chosen in the menu. */
    const char (*usb)[BOARD_USB_SIZE];
    uint32_t line_count;       /* What is wired where; of one role the last counts. */
    const char (*line)[BOARD_LINE_SIZE];
    uint8_t keyboard;          /* enum board_keyboard, but AUTO, which the caller decides. */
    uint8_t off_screen;        /* Render without a screen, for pictures. */
    uint8_t on_demand;         /* Off screen, draw only the frames that become pictures. */
    uint8_t full_screen;
    uint8_t waits_for_screen;  /* One that is not there at the start may come later: the display
                                  answers HAL_ERR_GONE until then. */
    uint32_t width, height;    /* Window or picture size in pixels; 0 is the board's own. */
    uint8_t mute;
    const char *data_dir;      /* Where the store lives; null keeps nothing. */
    struct view view;          /* Where a pointer device's rays start. */
    const struct shelf *shelf; /* Makers' species to show (platform/species/shelf.h); null: none. */
    /* Called at the moment when the display breaks for good, from inside whichever display call
     * noticed; null: none. What lies under the display may not survive that call's return: end
     * the program here. */
    void (*on_display_lost)(void *self);
    void *on_display_lost_self;
    /* Called while the board is opened, with each line "FILE:LINE: what" about a file of the data
     * folder that was passed over; standard error has it, too. Null: none. */
    void (*on_refused)(void *self, const char *line);
    void *on_refused_self;
};

/* Whether every text is a wire, and no two roles are on one line. -1: `why` says what is wrong. */
int board_reads_lines(const char (*line)[BOARD_LINE_SIZE], uint32_t count,
                      char why[HAL_TEXT_SIZE]);

/* Whether `text` names a USB controller: "VVVV:PPPP" or "VVVV:PPPP:SERIAL". */
int board_reads_usb(const char *text);

/* Wires real drivers where there are devices and null drivers where there are none. Never fails:
 * what is missing says so through describe(). */
void board_open(struct hal *hal, const struct board_options *options);

/* Gives every device back but the display, which may be gone: coins fall through, kernel drivers
 * have their controllers again, threads have ended. */
void board_let_go(struct hal *hal);

/* The same, and closes the display. */
void board_close(struct hal *hal);

/* The board's display off screen, START pressed once at `start_ns`, no hands, no sound, no
 * store, and a clock that begins at 0 and that only board_rehearsal_advance() moves: the same on
 * every machine. */
void board_open_rehearsal(struct hal *hal, const struct board_options *options, uint64_t start_ns);
void board_rehearsal_advance(uint64_t ns);

/* Whether a screen can be opened at all. When not, `why` (`why_size` bytes) gets one line. */
int board_has_screen(char *why, size_t why_size);

#endif
