/* x11_guard.c -- see x11_guard.h. */
#include "platform/render/x11_guard.h"

#include <SDL_syswm.h>
#include <dlfcn.h>
#include <string.h>

struct guard {
    void (*on_broken)(void *context);
    void *context;
};

/* Xlib keeps a pointer to this for the life of the connection, and there is one connection. */
static struct guard guard;

#if defined(SDL_VIDEO_DRIVER_X11)
typedef void (*exit_handler)(Display *display, void *context);
typedef void (*set_exit_handler)(Display *display, exit_handler handler, void *context);

static void connection_broken(Display *display, void *context)
{
    (void)display;
    const struct guard *const self = context;
    self->on_broken(self->context);
}

void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) {
        return;
    }
    void *const library = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (!library) {
        return;
    }
    set_exit_handler set;
    void *const symbol = dlsym(library, "XSetIOErrorExitHandler");
    memcpy(&set, &symbol, sizeof set); /* ISO C has no cast from object to function pointer. */
    if (set) {
        guard = (struct guard){ .on_broken = on_broken, .context = context };
        set(info.info.x11.display, connection_broken, &guard);
    }
    dlclose(library); /* SDL holds it open. */
}
#else
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    (void)window;
    guard = (struct guard){ .on_broken = on_broken, .context = context };
}
#endif
