/* drm_card.h -- finds the graphics card to which the monitor is connected.
 *
 * The kernel numbers the cards in the order in which their drivers load. If a second card without
 * connectors exists, the card with the connectors may be card0 after one boot and card1 after the
 * next. The kernel lists which connector has a monitor. */
#ifndef KINGYO_PLATFORM_RENDER_DRM_CARD_H
#define KINGYO_PLATFORM_RENDER_DRM_CARD_H

/* Maximum number of graphics cards. The kernel has the same limit for primary device nodes. */
#define DRM_CARD_MAX 64

/* Returns the number N of the card (/dev/dri/cardN) that shows the picture. This is the first card
 * with a connected monitor, otherwise the first card with a connector, whose monitor may be off.
 * Returns -1 if no card has a connector. `root` is a directory whose subdirectory sys/ is read
 * instead of /sys, or "" to read /sys. */
int drm_card_find(const char *root);

/* Makes SDL's KMSDRM driver use the card that drm_card_find() returns. Has no effect if
 * SDL_KMSDRM_DEVICE_INDEX in the environment selects a card. Call before each
 * SDL_InitSubSystem(SDL_INIT_VIDEO). */
void drm_card_prefer(void);

#endif
