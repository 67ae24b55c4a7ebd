/* shot_menu.h -- opens the operator's menu with several controllers for a picture. */
#ifndef KINGYO_TESTS_RENDER_SHOT_MENU_H
#define KINGYO_TESTS_RENDER_SHOT_MENU_H

#include "core/core.h"

/* Returns 1 if the menu has the page and the page has this step. */
int shot_menu_exists(const char *page, uint8_t step);

/* Opens the menu on `page` (top, controllers, controller, learn, lines or files). On the learn page
 * `step` is an enum learn_step. On the files page `step` is the number of presses of MORE. On other
 * pages `step` is the row of the controller. */
void shot_menu_open(struct core *core, const char *page, uint8_t step, int upright);

/* Fills in the names of the controllers, the lines of the device search, and the files from row
 * `file_first` on. */
void shot_menu_name(struct scene_devices *devices, uint8_t file_first);

#endif
