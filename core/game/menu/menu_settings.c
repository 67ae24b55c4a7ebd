/* menu_settings.c -- the settings pages. TEST changes the highlighted value, and the change repeats
 * while TEST is held. */
#include "core/base/panic.h"
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

/* HOLD_TICKS is the time before a held button first repeats. AGAIN_TICKS is the time between two
 * repeats: eight values per second. */
#define HOLD_TICKS (CORE_TICK_HZ / 2u)
#define AGAIN_TICKS (CORE_TICK_HZ / 8u)

/* Number of repeats after which a value with a long range changes by ten steps (two seconds), and
 * by a hundred steps (five seconds). */
#define HURRY_COUNT 12u
#define RUSH_COUNT 36u
#define HURRY_STEPS_MIN 40
#define RUSH_STEPS_MIN 400

static int is_settings(const struct menu *menu)
{
    return menu_page_desc_of(menu->page)->body == MENU_BODY_SETTINGS;
}

/* Returns the first row whose value differs from its default; MENU_TAG_MAX means none. */
static uint8_t first_changed(const struct settings *settings, uint8_t page)
{
    for (uint32_t tag = 0; tag < menu_body_count(page); tag++) {
        const uint32_t id = menu_setting_at(page, tag);
        if (id < SETTING_COUNT && settings->value[id] != settings_entry(id)->standard) {
            return (uint8_t)tag;
        }
    }
    return MENU_TAG_MAX;
}

void menu_settings_open(struct game *game, const struct settings *settings)
{
    struct menu *menu = &game->menu;
    menu->chosen = is_settings(menu) ? first_changed(settings, menu->page) : MENU_TAG_MAX;
    menu->turns_down = menu->turning = 0;
    menu->tag[menu->page] = 0;
}

static uint32_t stride(const struct menu *menu, const struct core_config *config, uint32_t id)
{
    const struct setting *setting = settings_entry(id);
    const int32_t steps = (settings_edit_max(config, id) - setting->min) / setting->step;
    return menu->turn_count >= RUSH_COUNT && steps >= RUSH_STEPS_MIN     ? 100u
           : menu->turn_count >= HURRY_COUNT && steps >= HURRY_STEPS_MIN ? 10u
                                                                         : 1u;
}

/* Changes a value by one or more steps. While a button is held, the value stops at the end of its
 * range. A new press continues at the opposite end. */
static void step_setting(struct game *game, struct core_config *config, uint32_t id)
{
    struct menu *menu = &game->menu;
    const int is_at_end =
        settings_edit_step(game, config, id, menu->turns_down, stride(&game->menu, config, id));
    menu->turn_tick = game->tick;
    menu->turning = !is_at_end;
}

/* Returns the items that can be selected. The item that restores the default applies to the row
 * that was changed last, because SERVICE has passed other rows to reach that item. Before any
 * change, the item applies to the first row that differs from its default. */
uint16_t menu_settings_enabled(const struct menu *menu)
{
    const uint32_t standard = menu_body_count(menu->page) + SETTINGS_STANDARD;
    const uint32_t all = (1u << menu_tag_count(menu->page)) - 1u;
    return (uint16_t)(menu->chosen < MENU_TAG_MAX ? all : all & ~(1u << standard));
}

void menu_settings_activate(struct game *game, struct core_config *config, uint32_t tag,
                            struct output *output)
{
    struct menu *menu = &game->menu;
    const uint32_t body_count = menu_body_count(menu->page);
    (void)output;
    if (tag < body_count) {
        menu->turn_count = 0;
        menu->chosen = (uint8_t)tag;
        step_setting(game, config, menu_setting_at(menu->page, tag));
    } else if (tag == body_count + SETTINGS_DIRECTION) {
        menu->turns_down = !menu->turns_down;
    } else {
        const uint32_t id = menu_setting_at(menu->page, menu->chosen);
        settings_edit_set(game, config, id, settings_entry(id)->standard);
        menu->turn_tick = game->tick;
    }
}

/* Toggles one bit of a setting. The only bit that is set cannot be cleared. */
void menu_bits_activate(struct game *game, struct core_config *config, uint32_t tag,
                        struct output *output)
{
    const uint32_t id = menu_page_desc_of(game->menu.page)->about;
    const int32_t value = config->persistent.settings.value[id] ^ (1 << tag);
    (void)output;
    if (settings_allows(id, value)) {
        settings_edit_set(game, config, id, value);
        game->menu.turn_tick = game->tick;
    }
}

void menu_settings_tick(struct game *game, struct core_config *config, int is_pressed,
                        struct output *output)
{
    struct menu *menu = &game->menu;
    const uint8_t tag = menu->tag[menu->page];
    if (!is_settings(menu)) {
        menu->turning = 0;
        return;
    }
    const uint32_t wait = menu->turn_count == 0 ? HOLD_TICKS : AGAIN_TICKS;
    menu->turning = menu->turning && is_pressed && tag == menu->chosen;
    if (menu->turning && game->tick - menu->turn_tick >= wait) {
        menu->turn_count = (uint8_t)(menu->turn_count + (menu->turn_count < UINT8_MAX));
        step_setting(game, config, menu_setting_at(menu->page, tag));
        output_sound(output, SOUND_TICK, 0.4f, 0.0f);
    }
}
