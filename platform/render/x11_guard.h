/* x11_guard.h -- prevents that Xlib ends the process when the X server closes the connection.
 *
 * On a broken connection, Xlib prints a line and calls exit(). Xlib calls exit() in its default
 * error handler, and also after a replaced error handler returns. In libX11 1.7 and later, a
 * program can replace the error handler and the exit handler. The functions that replace them
 * are loaded with dlsym(). Therefore the program does not link against X11, and other window
 * systems need no X11. After the break every further Xlib call on the connection fails without a
 * message. */
#ifndef KINGYO_PLATFORM_RENDER_X11_GUARD_H
#define KINGYO_PLATFORM_RENDER_X11_GUARD_H

#include <SDL.h>

/* Installs the error handler and the exit handler for the X11 connection of `window`. `on_broken`
 * is called once, from inside a call to SDL or OpenGL. Does nothing if the window system is not
 * X11. */
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context);

#endif
