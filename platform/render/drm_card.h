/* drm_card.h -- finds the graphics card that has the monitor.
 *
 * The kernel numbers the cards in the order in which their drivers load. The card with the
 * connectors may therefore be card0 after one boot and card1 after the next, if a second card
 * without connectors exists. The kernel lists which connector has a monitor. */
#ifndef KINGYO_PLATFORM_RENDER_DRM_CARD_H
#define KINGYO_PLATFORM_RENDER_DRM_CARD_H

/* Maximum number of graphics cards, which is also the kernel's maximum of primary nodes. */
#define DRM_CARD_MAX 64

/* Returns the number N of the card (/dev/dri/cardN) that shows the picture: the first card with a
 * connected monitor, otherwise the first card with a connector (its monitor may be off). Returns -1
 * if there is no card with a connector. `root` is "", or a directory whose sys/ is read instead of
 * /sys. */
int drm_card_find(const char *root);

/* Makes SDL's KMSDRM driver use the card that drm_card_find() returns. Has no effect if
 * SDL_KMSDRM_DEVICE_INDEX in the environment selects a card. Call before each
 * SDL_InitSubSystem(SDL_INIT_VIDEO). */
void drm_card_prefer(void);

#endif
