/* menu_internal.h -- internal interface of the menu pages that have code of their own. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_INTERNAL_H
#define KINGYO_CORE_GAME_MENU_MENU_INTERNAL_H

#include "core/game/menu/menu_pages.h"

#define MENU_TAG(tag) ((uint16_t)(1u << (tag)))

/* Sends a command to the shell, for the selected controller. */
void menu_command(struct core *core, struct output *output, enum controller_command_kind kind);

/* menu_controllers.c */
uint16_t menu_rows_enabled(const struct menu *menu);
void menu_rows_activate(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_row_enabled(const struct menu *menu);
void menu_row_activate(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_learn_enabled(const struct menu *menu);
void menu_learn_activate(struct core *core, uint32_t tag, struct output *output);
void menu_learn_close(struct core *core, struct output *output);
void menu_reopen(struct core *core); /* Highlights the first item. */

/* menu_calibrate.c */
uint16_t menu_calibrate_enabled(const struct menu *menu);
void menu_calibrate_open(struct core *core);
void menu_calibrate_activate(struct core *core, uint32_t tag, struct output *output);

/* self_test.c */
uint16_t menu_self_enabled(const struct menu *menu);
void menu_self_open(struct core *core);
void menu_self_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_files.c */
uint16_t menu_files_enabled(const struct menu *menu);
void menu_files_open(struct core *core);
void menu_files_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_books.c */
void menu_book_activate(struct core *core, uint32_t tag, struct output *output);
void menu_reset_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_confirm.c */
void menu_confirm_open(
    struct core *core); /* Highlights Back, so that a hasty press does nothing. */
void menu_restart_activate(struct core *core, uint32_t tag, struct output *output);
void menu_factory_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_pin.c */
void menu_pin_open(struct core *core);
void menu_pin_activate(struct core *core, uint32_t tag, struct output *output);
void menu_new_pin_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_ranking.c */
uint16_t menu_ranking_enabled(const struct menu *menu);
void menu_ranking_open(struct core *core);
void menu_ranking_activate(struct core *core, uint32_t tag, struct output *output);
uint16_t menu_score_enabled(const struct menu *menu);
void menu_score_open(struct core *core);
void menu_score_activate(struct core *core, uint32_t tag, struct output *output);

/* menu_settings.c */
uint16_t menu_settings_enabled(const struct menu *menu);
void menu_settings_open(struct core *core);
void menu_settings_activate(struct core *core, uint32_t tag, struct output *output);
void menu_bits_activate(struct core *core, uint32_t tag, struct output *output);

/* Repeats the change of a value while the button or poi that selected it is still pressed. */
void menu_settings_tick(struct core *core, int is_pressed, struct output *output);

#endif
