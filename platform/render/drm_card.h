/* drm_card.h -- which graphics card has the monitor.
 *
 * Cards are numbered as their drivers happen to load: the one with sockets may be card0 today and
 * card1 tomorrow, beside one that only computes. The kernel says which socket has a monitor. */
#ifndef KINGYO_PLATFORM_RENDER_DRM_CARD_H
#define KINGYO_PLATFORM_RENDER_DRM_CARD_H

#define DRM_CARD_MAX 64 /* The kernel's own bound on primary nodes. */

/* N of the card (/dev/dri/cardN) to show the picture on: the first that a monitor is connected to;
 * else, while the monitor is off, the first that has a socket at all; -1: there is none. `root`:
 * "", or a folder whose sys/ is looked at instead. */
int drm_card_find(const char *root);

/* Has SDL's KMSDRM driver use that card from its next start on, unless SDL_KMSDRM_DEVICE_INDEX in
 * the environment names one. Before each SDL_InitSubSystem(SDL_INIT_VIDEO). */
void drm_card_prefer(void);

#endif
