/* menu_parts.h -- internal interface of the menu pages that have code of their own. */
#ifndef KINGYO_CORE_GAME_MENU_PARTS_H
#define KINGYO_CORE_GAME_MENU_PARTS_H

#include "core/game/menu_pages.h"

#define MENU_TAG(tag) ((uint16_t)(1u << (tag)))

/* Sends a command to the shell, for the selected controller. */
void menu_order(struct core *core, struct output *output, enum desk_order_kind kind);

/* menu_controllers.c */
uint16_t menu_rows_offers(const struct menu *menu);
void menu_rows_take(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_row_offers(const struct menu *menu);
void menu_row_take(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_learn_offers(const struct menu *menu);
void menu_learn_take(struct core *core, uint32_t tag, struct output *output);
void menu_learn_leave(struct core *core, struct output *output);
void menu_enter_anew(struct core *core); /* Highlights the first item. */

/* menu_calibrate.c */
uint16_t menu_calibrate_offers(const struct menu *menu);
void menu_calibrate_enter(struct core *core);
void menu_calibrate_take(struct core *core, uint32_t tag, struct output *output);

/* self_test.c */
uint16_t menu_self_offers(const struct menu *menu);
void menu_self_enter(struct core *core);
void menu_self_take(struct core *core, uint32_t tag, struct output *output);

/* menu_files.c */
uint16_t menu_files_offers(const struct menu *menu);
void menu_files_enter(struct core *core);
void menu_files_take(struct core *core, uint32_t tag, struct output *output);

/* menu_books.c */
void menu_book_take(struct core *core, uint32_t tag, struct output *output);
void menu_reset_take(struct core *core, uint32_t tag, struct output *output);

/* menu_upkeep.c */
void menu_sure_enter(struct core *core); /* Highlights Back, so that a hasty press does nothing. */
void menu_restart_take(struct core *core, uint32_t tag, struct output *output);
void menu_factory_take(struct core *core, uint32_t tag, struct output *output);

/* menu_pin.c */
void menu_pin_enter(struct core *core);
void menu_pin_take(struct core *core, uint32_t tag, struct output *output);
void menu_new_pin_take(struct core *core, uint32_t tag, struct output *output);

/* menu_ranking.c */
uint16_t menu_ranking_offers(const struct menu *menu);
void menu_ranking_enter(struct core *core);
void menu_ranking_take(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_score_offers(const struct menu *menu);
void menu_score_enter(struct core *core);
void menu_score_take(struct core *core, uint32_t tag, struct output *output);

/* menu_settings.c */
uint16_t menu_settings_offers(const struct menu *menu);
void menu_settings_enter(struct core *core);
void menu_settings_take(struct core *core, uint32_t tag, struct output *output);
void menu_bits_take(struct core *core, uint32_t tag, struct output *output);

/* Repeats the change of a value while the button or poi that selected it is still pressed. */
void menu_settings_tick(struct core *core, int is_pressed, struct output *output);

#endif
