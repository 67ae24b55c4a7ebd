/* x11_guard.c -- implementation of x11_guard.h. */
#include "platform/render/x11_guard.h"

#include <SDL_syswm.h>
#include <dlfcn.h>
#include <string.h>

struct guard {
    void (*on_broken)(void *context);
    void *context;
};

/* Xlib keeps a pointer to `guard` until the connection ends. Only one connection exists. */
static struct guard guard;

#if defined(SDL_VIDEO_DRIVER_X11)
typedef int (*error_handler)(Display *display);
typedef error_handler (*set_error_handler)(error_handler handler);
typedef void (*exit_handler)(Display *display, void *context);
typedef void (*set_exit_handler)(Display *display, exit_handler handler, void *context);

static int keep_quiet(Display *display)
{
    (void)display; /* After this error handler returns, Xlib calls the exit handler. */
    return 0;
}

static void connection_broken(Display *display, void *context)
{
    (void)display;
    const struct guard *const self = context;
    self->on_broken(self->context);
}

static void install(void *library, Display *display)
{
    set_error_handler set_error;
    set_exit_handler set_exit;
    void *const symbols[2] = { dlsym(library, "XSetIOErrorHandler"),
                               dlsym(library, "XSetIOErrorExitHandler") };
    /* memcpy() is used because ISO C has no cast from an object pointer to a function pointer. */
    memcpy(&set_error, &symbols[0], sizeof set_error);
    memcpy(&set_exit, &symbols[1], sizeof set_exit);
    if (set_error && set_exit) {
        set_exit(display, connection_broken, &guard);
        set_error(keep_quiet);
    }
}

void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) {
        return;
    }
    void *const library = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (library) {
        guard = (struct guard){ .on_broken = on_broken, .context = context };
        install(library, info.info.x11.display);
        dlclose(library); /* SDL has also opened the library. Therefore the functions stay
                             loaded. */
    }
}
#else
void x11_guard(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    (void)window;
    guard = (struct guard){ .on_broken = on_broken, .context = context };
}
#endif
