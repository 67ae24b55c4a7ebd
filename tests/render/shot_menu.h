/* shot_menu.h -- opens a page of the operator's menu with example content for a picture. */
#ifndef KINGYO_TESTS_RENDER_SHOT_MENU_H
#define KINGYO_TESTS_RENDER_SHOT_MENU_H

#include "core/core.h"

/* Returns 1 if the menu has the page and the page has this step. */
int shot_menu_exists(const char *page, uint8_t step);

/* Returns the name of the menu page `id` (enum menu_page), or null if the page has no name. */
const char *shot_menu_name_of(uint8_t id);

/* Opens the menu on `page`, a name of the table `names` in shot_menu.c. The meaning of `step`
 * depends on the page. On the learn page and the calibration page, `step` is the step of the
 * wizard. On a page with settings and on the controller page, it is the selected row. On the files
 * page, it is the number of presses of MORE. */
void shot_menu_open(struct core *core, const char *page, uint8_t step, int upright);

/* Fills in example names of controllers, example lines of the device search, and example files from
 * the row `file_first` on. */
void shot_menu_name(struct scene_devices *devices, uint8_t file_first);

#endif
