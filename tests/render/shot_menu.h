/* shot_menu.h -- the operator's menu with a desk full of controllers, for its picture. */
#ifndef KINGYO_TESTS_SHOT_MENU_H
#define KINGYO_TESTS_SHOT_MENU_H

#include "core/core.h"

/* Opens it on `page` (top, controllers, controller, learn or lines; others: top). `step` is enum
 * learn_step while it learns, and the row of the controller elsewhere. */
void shot_menu_open(struct core *core, const char *page, uint8_t step, int upright);

/* What those controllers are called, and the lines of what looks for them. */
void shot_menu_name(struct scene_devices *devices);

#endif
