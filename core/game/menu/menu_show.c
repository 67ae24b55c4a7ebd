/* menu_show.c -- writes the visible state of the operator's menu to the scene, and computes the
 * menu's hash. */
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_pages.h"

_Static_assert(AUDIT_COUNT <= SCENE_AUDIT_MAX, "every audit can be shown");

/* Time for which a page shows that a change is on disk. */
#define SAVED_TICKS (10u * CORE_TICK_HZ)
#define NEVER_S 1e6f /* Time in seconds that stands for never, about eleven days. */

void menu_show(const struct game *game, const struct core_config *config, struct scene_menu *out)
{
    const struct menu *menu = &game->menu;
    *out = (struct scene_menu){ 0 };
    if (game->phase != PHASE_MENU) {
        return;
    }
    out->page = menu->page;
    out->tag = menu->tag[menu->page];
    out->tags = menu_enabled(menu);
    out->row = menu->row;
    out->file_first = menu->file_first < menu->controllers.file_count ? menu->file_first : 0;
    out->score = menu->score;
    out->upright = menu->upright;
    out->has_hand = menu->has_hand;
    out->presses = menu->presses;
    out->x = menu->x;
    out->y = menu->y;
    out->controllers = menu->controllers;
    out->held = menu->held;
    memcpy(out->pressed_count, menu->pressed_count, sizeof out->pressed_count);
    out->test_coins = menu->test_coins;
    out->chosen = menu->chosen;
    out->turns_down = menu->turns_down;
    out->has_turned = menu->turn_tick != 0 && game->tick - menu->turn_tick < SAVED_TICKS;
    out->is_saved = (uint8_t)settings_edit_is_saved(&game->accounts.ledger, &game->settings_edit,
                                                    &config->persistent.settings);
    out->fish_max = (uint32_t)settings_edit_max(config, SET_FISH);
    out->from = menu->from;
    out->pin_count = menu->pin_count;
    out->pin_wait_s = (float)menu_pin_wait_ticks(&game->settings_edit, game->tick) * CORE_TICK_S;
    /* The PIN that is typed to open the menu must not be visible. */
    out->pin = menu->page == MENU_NEW_PIN ? menu->pin : 0;
    memcpy(out->audit, game->accounts.audits.count, sizeof game->accounts.audits.count);
    out->boot = game->accounts.ledger.boot;
    out->last_id = game->accounts.ledger.last_id;
    out->saved_id = game->accounts.ledger.saved_id;
    out->settings = config->persistent.settings;
    self_test_show(game, config, &out->self);
    out->seat = menu->calibrate.seat;
    out->calibrate_step = menu->calibrate.step;
    out->calibrate_fault = menu->calibrate.fault;
    out->calibrated = menu->calibrate.is_set;
    out->menu_calibrate_progress = menu_calibrate_progress(&menu->calibrate);
    out->calibrated_m = game->validation[menu->calibrate.seat].newest.position_m;
    out->coin_s =
        menu->test_coins > 0 ? (float)(game->tick - menu->coin_tick) * CORE_TICK_S : NEVER_S;
}

uint64_t menu_hash(uint64_t hash, const struct menu *menu)
{
    const uint32_t words[] = { menu->page,           menu->row,        menu->upright,
                               menu->file_first,     menu->board,      menu->score,
                               menu->score_is_named, menu->score_asks, menu->scores,
                               menu->chosen,         menu->turns_down, menu->turning,
                               menu->turn_count,     menu->turn_tick,  menu->from,
                               menu->pin_count,      menu->pin,        menu->has_hand,
                               menu->hand,           menu->presses,    menu->points,
                               menu->held,           menu->test_coins, menu->coin_tick,
                               menu->command_count,  menu->ask_tick,   menu->take_tick,
                               menu->act_tick,       menu->use_tick };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    hash = hash_bytes(hash, menu->tag, sizeof menu->tag);
    hash = hash_bytes(hash, (const uint8_t *)&menu->controllers, sizeof menu->controllers);
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        hash = hash_u32(hash, menu->pressed_count[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_float(hash_float(hash, menu->rest[i].x), menu->rest[i].y);
    }
    hash = self_test_hash(menu_calibrate_hash(hash, &menu->calibrate), &menu->self);
    return hash_float(hash_float(hash, menu->x), menu->y);
}
