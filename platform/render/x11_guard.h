/* x11_guard.h -- keeps a process alive when its X server goes away.
 *
 * Xlib answers a broken connection by calling exit(). Since libX11 1.7 that last step can be
 * replaced (XSetIOErrorExitHandler); it is looked up at run time, so nothing links against X11 and
 * other window systems need nothing. */
#ifndef KINGYO_PLATFORM_RENDER_X11_GUARD_H
#define KINGYO_PLATFORM_RENDER_X11_GUARD_H

#include <SDL.h>

/* `on_broken` is called once, from inside a call to SDL or OpenGL. Does nothing off X11. */
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context);

#endif
