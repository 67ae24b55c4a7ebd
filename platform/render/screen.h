/* screen.h -- detects which screens are connected, and when the connection to the screen breaks.
 *
 * SDL without a window system does not detect that a screen was unplugged or replaced. The kernel
 * lists the graphics cards and the state of each connector in /sys/class/drm. Reading this
 * directory causes no traffic to the screen. With a window system, only the connection to the X
 * server can break. */
#pragma once

#include <SDL.h>
#include <stdint.h>

/* Maximum number of graphics cards. The kernel has the same limit for primary device nodes. */
#define SCREEN_CARD_MAX 64

struct connectors {
    /* Number of connectors that the kernel lists. 0 means that there is no card or that the
     * directory is unreadable. */
    uint32_t count;
    uint32_t connected; /* Number of connectors with a screen. */
    /* Hash of the names of all connectors with a screen. 0 means that no connector has a screen. */
    uint64_t which;
};

/* Reads the connectors from `root`, a directory like /sys/class/drm. A null `root` means
 * /sys/class/drm. Returns 0 connectors if the directory cannot be read. */
struct connectors screen_connectors(const char *root);

/* Returns the number N of the card (/dev/dri/cardN) that shows the picture. This is the first card
 * with a connected screen. If no card has one, it is the first card with a connector, whose screen
 * may be off. Returns -1 if no card has a connector. `root` is a directory whose subdirectory sys/
 * is read instead of /sys, or "" to read /sys.
 *
 * The kernel numbers the cards in the order in which their drivers load. If a second card without
 * connectors exists, the card with the connectors may be card0 after one boot and card1 after the
 * next. */
int screen_card_find(const char *root);

/* Makes SDL's KMSDRM driver use the card that screen_card_find() returns. Has no effect if
 * SDL_KMSDRM_DEVICE_INDEX in the environment selects a card. Must be called before each
 * SDL_InitSubSystem(SDL_INIT_VIDEO). */
void screen_card_prefer(void);

/* Prevents Xlib from ending the process when the X server closes the connection of `window`.
 * `on_broken` is called once with `context`, from inside a call to SDL or OpenGL. Does nothing if
 * the window system is not X11.
 *
 * If a connection breaks, Xlib calls an error handler, which prints a line and calls exit(). If the
 * program has replaced this handler, Xlib then calls an exit handler, which also calls exit(). In
 * libX11 1.7 and later, a program can replace both handlers. This module finds the functions that
 * replace the handlers with dlsym(), so that the program does not link against X11 and other window
 * systems need no X11. After the break every further Xlib call on the connection fails without a
 * message. */
void screen_guard_x11(SDL_Window *window, void (*on_broken)(void *context), void *context);
