/* screen.c -- reads the states of the graphics cards and of the display connectors, and handles a
 * broken connection to the X server. The directory /sys/class/drm lists cards ("card1") and
 * connectors ("card1-HDMI-A-1"). */
#include "platform/render/screen.h"

#include <SDL.h>
#include <SDL_syswm.h>
#include <dirent.h>
#include <dlfcn.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/file.h"

#define HASH_BASIS 0xcbf29ce484222325ull /* Initial value of the FNV-1a hash function. */
#define HASH_PRIME 0x100000001b3ull      /* Factor of the FNV-1a hash function. */

/* State of a display connector, in ascending order: absent, without a screen, with a screen. The
 * state of a card is the highest state of its connectors. */
enum connector_state {
    CONNECTOR_NONE = 0,
    CONNECTOR_FREE,
    CONNECTOR_CONNECTED,
};

/* Returns the number N of the connector name "cardN-CONNECTOR". Returns -1 for a card's own name,
 * such as "card1". Returns -1 for a writeback connector, which writes into memory and has no
 * screen. */
static int card_of(const char *name)
{
    int card = -1, length = 0;
    if (sscanf(name, "card%2d-%n", &card, &length) != 1 || length == 0 || card < 0 ||
        card >= SCREEN_CARD_MAX || strncmp(name + length, "Writeback", 9) == 0) {
        return -1;
    }
    return card;
}

/* Reads the state of the connector `name` from its file in the directory `folder`. */
static enum connector_state connector_state(const char *folder, const char *name)
{
    char path[PATH_MAX], word[16];
    snprintf(path, sizeof path, "%s/%.255s/status", folder, name);
    file_first_line(path, word, sizeof word);
    return word[0] == '\0'                  ? CONNECTOR_NONE
           : strcmp(word, "connected") == 0 ? CONNECTOR_CONNECTED
                                            : CONNECTOR_FREE;
}

int screen_card_find(const char *root)
{
    CORE_ASSERT(root);
    char path[PATH_MAX / 2];
    enum connector_state best[SCREEN_CARD_MAX] = { CONNECTOR_NONE };
    const struct dirent *entry;
    int found = -1;
    snprintf(path, sizeof path, "%s/sys/class/drm", root);
    DIR *folder = opendir(path);
    while (folder && (entry = readdir(folder))) {
        const int card = card_of(entry->d_name);
        const enum connector_state state =
            card >= 0 ? connector_state(path, entry->d_name) : CONNECTOR_NONE;
        if (state > CONNECTOR_NONE && state > best[card]) {
            best[card] = state;
        }
    }
    if (folder) {
        closedir(folder);
    }
    for (int card = 0; card < SCREEN_CARD_MAX; card++) {
        if (best[card] > (found < 0 ? CONNECTOR_NONE : best[found])) {
            found = card;
        }
    }
    return found;
}

void screen_card_prefer(void)
{
    char index[16];
    const int card = screen_card_find("");
    if (card >= 0) {
        snprintf(index, sizeof index, "%d", card);
        /* If the environment variable SDL_KMSDRM_DEVICE_INDEX is set, SDL ignores this hint. */
        SDL_SetHint(SDL_HINT_KMSDRM_DEVICE_INDEX, index);
    }
}

/* `which` is the sum of the hashes of the connectors' names, because a sum does not depend on the
 * order of the names. The kernel may list the names in a different order each time. */
struct connectors screen_connectors(const char *root)
{
    struct connectors found = { 0 };
    root = root ? root : "/sys/class/drm";
    DIR *const folder = opendir(root);
    if (!folder) {
        return found;
    }
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (card_of(entry->d_name) < 0) {
            continue;
        }
        found.count++;
        if (connector_state(root, entry->d_name) == CONNECTOR_CONNECTED) {
            uint64_t hash = HASH_BASIS;
            for (const char *at = entry->d_name; *at; at++) {
                hash = (hash ^ (uint8_t)*at) * HASH_PRIME;
            }
            found.connected++;
            found.which += hash;
        }
    }
    closedir(folder);
    CORE_ASSERT(found.connected <= found.count);
    return found;
}

/* ---- Connection to the X server -------------------------------------------------------------- */

struct guard {
    void (*on_broken)(void *context);
    void *context;
};

/* Xlib keeps a pointer to `guard` until the connection to the X server ends. The variable can be
 * static, because the program has only one connection. */
static struct guard guard;

#if defined(SDL_VIDEO_DRIVER_X11)
typedef int (*error_handler)(Display *display);
typedef error_handler (*set_error_handler)(error_handler handler);
typedef void (*exit_handler)(Display *display, void *context);
typedef void (*set_exit_handler)(Display *display, exit_handler handler, void *context);

static int ignore_io_error(Display *display)
{
    (void)display; /* After this error handler returns, Xlib calls the exit handler of the
                      connection. */
    return 0;
}

static void connection_broken(Display *display, void *context)
{
    (void)display;
    const struct guard *const self = context;
    self->on_broken(self->context);
}

void screen_guard_x11(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    CORE_ASSERT(window && on_broken);
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    if (!SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11) {
        return;
    }
    void *const library = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (library) {
        guard = (struct guard){ .on_broken = on_broken, .context = context };
        set_error_handler set_error;
        set_exit_handler set_exit;
        void *const symbols[2] = { dlsym(library, "XSetIOErrorHandler"),
                                   dlsym(library, "XSetIOErrorExitHandler") };
        /* memcpy() is used because ISO C has no cast from an object pointer to a function
         * pointer. */
        memcpy(&set_error, &symbols[0], sizeof set_error);
        memcpy(&set_exit, &symbols[1], sizeof set_exit);
        if (set_error && set_exit) {
            set_exit(info.info.x11.display, connection_broken, &guard);
            set_error(ignore_io_error);
        }
        dlclose(library); /* The functions stay loaded after dlclose(), because SDL has also opened
                             the library. */
    }
}
#else
void screen_guard_x11(SDL_Window *window, void (*on_broken)(void *context), void *context)
{
    (void)window;
    guard = (struct guard){ .on_broken = on_broken, .context = context };
}
#endif
