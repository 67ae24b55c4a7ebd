/* x11_guard.h -- keeps the process alive when its X server closes the connection.
 *
 * Xlib handles a broken connection by printing a line and calling exit(), first in its default
 * error handler, and again after any handler that returns. Since libX11 1.7 both handlers can be
 * replaced. The functions are looked up at run time, so that nothing links against X11 and other
 * window systems need nothing. After the break every further Xlib call on that connection fails
 * without a message. */
#ifndef KINGYO_PLATFORM_RENDER_X11_GUARD_H
#define KINGYO_PLATFORM_RENDER_X11_GUARD_H

#include <SDL.h>

/* Installs the handlers for the window's connection. `on_broken` is called once, from inside a call
 * to SDL or OpenGL. Does nothing without X11. */
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context);

#endif
