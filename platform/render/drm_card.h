/* drm_card.h -- finds the graphics card that has the monitor.
 *
 * Cards are numbered in the order in which their drivers load. The card with connectors may
 * therefore be card0 today and card1 tomorrow, beside a card that only computes. The kernel lists
 * which connector has a monitor. */
#ifndef KINGYO_PLATFORM_RENDER_DRM_CARD_H
#define KINGYO_PLATFORM_RENDER_DRM_CARD_H

#define DRM_CARD_MAX 64 /* The kernel's own bound on primary nodes. */

/* Returns N of the card (/dev/dri/cardN) to show the picture on: the first card with a connected
 * monitor, otherwise the first card with a connector (the monitor may be off), or -1 if there is no
 * such card. `root` is "" or a directory whose sys/ is read instead. */
int drm_card_find(const char *root);

/* Makes SDL's KMSDRM driver use that card from its next start on, unless SDL_KMSDRM_DEVICE_INDEX in
 * the environment selects a card. Call before each SDL_InitSubSystem(SDL_INIT_VIDEO). */
void drm_card_prefer(void);

#endif
