/* x11_guard.h -- keeps a process alive when its X server goes away.
 *
 * Xlib answers a broken connection by printing a line and calling exit(), twice over: in its
 * default error handler, and again after any handler that returns. Since libX11 1.7 both can be
 * replaced. The functions are looked up at run time, so nothing links against X11 and other window
 * systems need nothing. After the break Xlib lets every further call on that connection fail
 * quietly. */
#ifndef KINGYO_PLATFORM_RENDER_X11_GUARD_H
#define KINGYO_PLATFORM_RENDER_X11_GUARD_H

#include <SDL.h>

/* `on_broken` is called once, from inside a call to SDL or OpenGL. Does nothing off X11. */
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context);

#endif
