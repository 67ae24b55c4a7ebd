/* menu_internal.h -- internal interface of the menu pages that have code of their own. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_INTERNAL_H
#define KINGYO_CORE_GAME_MENU_MENU_INTERNAL_H

#include "core/game/menu/menu_pages.h"

#define MENU_TAG(tag) ((uint16_t)(1u << (tag)))

/* Sends a command about the selected controller to the shell. */
void menu_command(struct menu *menu, struct output *output, enum controller_command_kind kind);

/* The following functions are in menu_controllers.c. */
uint16_t menu_rows_enabled(const struct menu *menu);
void menu_rows_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);
uint16_t menu_row_enabled(const struct menu *menu);
void menu_row_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output);
uint16_t menu_learn_enabled(const struct menu *menu);
void menu_learn_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);
void menu_learn_close(struct menu *menu, struct output *output);
/* Highlights the first item of the open page. */
void menu_reopen(struct game *game, const struct settings *settings);

/* The following functions are in menu_calibrate.c. */
uint16_t menu_calibrate_enabled(const struct menu *menu);
void menu_calibrate_open(struct game *game, const struct settings *settings);
void menu_calibrate_activate(struct game *game, struct core_config *config, uint32_t tag,
                             struct output *output);

/* The following functions are in self_test.c. */
uint16_t menu_self_enabled(const struct menu *menu);
void menu_self_open(struct game *game, const struct settings *settings);
void menu_self_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);

/* The following functions are in menu_files.c. */
uint16_t menu_files_enabled(const struct menu *menu);
void menu_files_open(struct game *game, const struct settings *settings);
void menu_files_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);

/* The following functions are in menu_books.c. */
void menu_book_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);
void menu_reset_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);

/* The following functions are in menu_confirm.c. */
/* Highlights the item "Back" of a page that requests confirmation, so that an accidental press does
 * nothing. */
void menu_confirm_open(struct game *game, const struct settings *settings);
void menu_restart_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);
void menu_factory_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);

/* The following functions are in menu_pin.c. */
void menu_pin_open(struct game *game, const struct settings *settings);
void menu_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                       struct output *output);
void menu_new_pin_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);

/* The following functions are in menu_ranking.c. */
uint16_t menu_ranking_enabled(const struct menu *menu);
void menu_ranking_open(struct game *game, const struct settings *settings);
void menu_ranking_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output);
uint16_t menu_score_enabled(const struct menu *menu);
void menu_score_open(struct game *game, const struct settings *settings);
void menu_score_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output);

/* The following functions are in menu_settings.c. */
uint16_t menu_settings_enabled(const struct menu *menu);
void menu_settings_open(struct game *game, const struct settings *settings);
void menu_settings_activate(struct game *game, struct core_config *config, uint32_t tag,
                            struct output *output);
void menu_bits_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output);

/* Continues to change a value while the button or poi that selected the value is still pressed. */
void menu_settings_tick(struct game *game, struct core_config *config, int is_pressed,
                        struct output *output);

#endif
