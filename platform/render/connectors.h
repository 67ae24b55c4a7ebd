/* connectors.h -- reads from the kernel which connectors of the graphics cards have a screen
 * plugged in.
 *
 * SDL without a window system does not detect that a screen was unplugged or replaced. The kernel
 * lists the state of each connector in /sys/class/drm. Reading this directory causes no traffic to
 * the screen. */
#ifndef KINGYO_PLATFORM_RENDER_CONNECTORS_H
#define KINGYO_PLATFORM_RENDER_CONNECTORS_H

#include <stdint.h>

struct connectors {
    uint32_t count;     /* Number of connectors. 0 means that there is no card or that the directory
                           is unreadable. */
    uint32_t connected; /* Number of connectors with a screen. */
    uint64_t which;     /* Hash of the names of all connectors with a screen. 0 means that no
                           connector has a screen. */
};

/* Reads the connectors from `root`, a directory like /sys/class/drm. Returns 0 connectors if the
 * directory cannot be read. */
struct connectors connectors_read(const char *root);

#endif
