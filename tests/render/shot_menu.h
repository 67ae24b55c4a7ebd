/* shot_menu.h -- the operator's menu with a desk full of controllers, for its picture. */
#ifndef KINGYO_TESTS_RENDER_SHOT_MENU_H
#define KINGYO_TESTS_RENDER_SHOT_MENU_H

#include "core/core.h"

/* Whether there is such a page, and such a step of it. */
int shot_menu_knows(const char *page, uint8_t step);

/* Opens it on `page` (top, controllers, controller, learn, lines or files). `step` is
 * enum learn_step while it learns, how often MORE was taken among the files, and the row of the
 * controller elsewhere. */
void shot_menu_open(struct core *core, const char *page, uint8_t step, int upright);

/* What those controllers are called, the lines of what looks for them, and files from a row on. */
void shot_menu_name(struct scene_devices *devices, uint8_t file_first);

#endif
