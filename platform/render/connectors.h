/* connectors.h -- which of the graphics cards' sockets have a screen in them.
 *
 * SDL draws on bare DRM without noticing that a screen was pulled out, or that another came: the
 * kernel says so in /sys/class/drm. Reading it asks no screen, it is what the kernel knows. */
#ifndef KINGYO_PLATFORM_RENDER_CONNECTORS_H
#define KINGYO_PLATFORM_RENDER_CONNECTORS_H

#include <stdint.h>

struct connectors {
    uint32_t count;     /* Sockets; 0: no card, or nothing is told. */
    uint32_t connected; /* Those with a screen. */
    uint64_t which;     /* Tells two sets of sockets with screens apart; 0: none. */
};

/* `root`: a folder like /sys/class/drm. One that cannot be read has no sockets. */
struct connectors connectors_read(const char *root);

#endif
