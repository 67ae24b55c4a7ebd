/* x11_guard.h -- keeps the process alive when its X server closes the connection.
 *
 * On a broken connection, Xlib prints a line and calls exit(). Xlib calls exit() in its default
 * error handler, and also after any other handler that returns. Both calls can be replaced in
 * libX11 1.7 and later. The functions are loaded with dlsym(), so that the program does not link
 * against X11 and other window systems need no X11. After the break every further Xlib call on the
 * connection fails without a message. */
#ifndef KINGYO_PLATFORM_RENDER_X11_GUARD_H
#define KINGYO_PLATFORM_RENDER_X11_GUARD_H

#include <SDL.h>

/* Installs the handlers for the connection of `window`. `on_broken` is called once, from inside a
 * call to SDL or OpenGL. Does nothing without X11. */
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context);

#endif
