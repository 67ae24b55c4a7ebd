/* settings_edit.c -- changes settings, logs the changes in the ledger, and runs the settings pages.
 * On a settings page TEST changes the highlighted value, and the change repeats while TEST is
 * held. */
#include "core/game/menu/menu_pages.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/tank/preset.h"

void settings_edit_init(struct settings_edit *settings_edit, const struct core_config *config)
{
    const uint32_t wrong = config->persistent.audits.count[AUDIT_WRONG_PINS];
    *settings_edit = (struct settings_edit){
        .logged = config->persistent.settings,
        /* The database does not record when wrong PINs were entered, so the lockout time starts at
         * the kiosk's start. */
        .pin_wrong = wrong < UINT8_MAX ? wrong : UINT8_MAX,
    };
    settings_sanitize(&settings_edit->logged);
}

int32_t settings_edit_max(const struct core_config *config, uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    const struct setting *setting = settings_entry(id);
    if (id != SET_FISH) {
        return setting->max;
    }
    const int32_t room = (int32_t)tank_preset_fish_max(tank_preset(config->preset), 1.0f);
    return room < setting->max ? room : setting->max;
}

static void apply(const struct menu_scope *scope)
{
    config_apply_settings(scope->config, &scope->config->persistent.settings);
    scope->settings_edit->turn_tick = scope->game->tick;
}

void settings_edit_set(const struct menu_scope *scope, uint32_t id, int32_t value)
{
    CORE_ASSERT(settings_allows(id, value));
    CORE_ASSERT(value <= settings_edit_max(scope->config, id));
    scope->config->persistent.settings.value[id] = value;
    apply(scope);
    if (id == SET_LANGUAGE) {
        *scope->language = (uint8_t)value;
    }
}

/* Returns the next allowed value of setting `id`. Paper grades 1 to 3 do not exist and are
 * skipped. */
static int32_t step_from(const struct core_config *config, uint32_t id, int32_t value, bool is_down)
{
    CORE_ASSERT(id < SETTING_COUNT);
    const struct setting *setting = settings_entry(id);
    const int32_t max = settings_edit_max(config, id);
    do {
        value += is_down ? -setting->step : setting->step;
        value = value > max ? setting->min : value < setting->min ? max : value;
    } while (!settings_allows(id, value));
    return value;
}

static bool is_setting_at_limit(const struct core_config *config, uint32_t id, int32_t value,
                                bool is_down)
{
    const int32_t next = step_from(config, id, value, is_down);
    return is_down ? next > value : next < value;
}

bool settings_edit_step(const struct menu_scope *scope, uint32_t id, bool is_down,
                        uint32_t step_count)
{
    CORE_ASSERT(id < SETTING_COUNT && step_count > 0);
    const struct core_config *config = scope->config;
    int32_t value = step_from(config, id, config->persistent.settings.value[id], is_down);
    for (uint32_t i = 1; i < step_count && !is_setting_at_limit(config, id, value, is_down); i++) {
        value = step_from(config, id, value, is_down);
    }
    settings_edit_set(scope, id, value);
    return is_setting_at_limit(config, id, value, is_down);
}

bool settings_edit_factory_reset(const struct menu_scope *scope)
{
    struct ledger *ledger = &scope->accounts->ledger;
    struct settings *settings = &scope->config->persistent.settings;
    const struct balance balance = ledger->balance;
    const struct ledger_entry entry = { .kind = LEDGER_FACTORY,
                                        .count = balance.paid + balance.service,
                                        .value = balance.tickets };
    ledger->balance = (struct balance){ 0 };
    if (!ledger_write(scope->accounts, scope->game->tick, &entry, scope->output)) {
        ledger->balance = balance;
        return false;
    }
    settings_reset(settings);
    scope->settings_edit->logged = *settings;
    scope->settings_edit->entry_id = ledger->last_id;
    *scope->language = (uint8_t)settings->value[SET_LANGUAGE];
    apply(scope);
    return true;
}

void settings_edit_tick(const struct menu_scope *scope)
{
    struct settings_edit *settings_edit = scope->settings_edit;
    const struct settings *settings = &scope->config->persistent.settings;
    const uint32_t tick = scope->game->tick;
    if (tick - settings_edit->turn_tick < SETTINGS_EDIT_REST_TICKS) {
        return;
    }
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const int32_t value = settings->value[id];
        if (value == settings_edit->logged.value[id]) {
            continue;
        }
        if (!ledger_may_write(&scope->accounts->ledger, LEDGER_SETTING)) {
            /* The ledger has no room. The next tick tries again, because every change of a setting
             * must be logged. */
            return;
        }
        const struct ledger_entry entry = { .kind = LEDGER_SETTING,
                                            .detail = (uint8_t)(id & 0xffu),
                                            .count = id >> 8,
                                            .value = value };
        settings_edit->entry_id = ledger_write(scope->accounts, tick, &entry, scope->output);
        settings_edit->logged.value[id] = value;
    }
}

bool settings_edit_is_saved(const struct ledger *ledger, const struct settings_edit *settings_edit,
                            const struct settings *settings)
{
    return memcmp(settings, &settings_edit->logged, sizeof *settings) == 0 &&
           ledger_is_saved(ledger, settings_edit->entry_id);
}

/* HOLD_TICKS is the time before a held button first repeats. AGAIN_TICKS is the time between two
 * repeats: eight values per second. */
#define HOLD_TICKS (CORE_TICK_HZ / 2u)
#define AGAIN_TICKS (CORE_TICK_HZ / 8u)

/* HURRY_COUNT is the number of repeats (two seconds) after which a value with a long range changes
 * by ten steps at a time. After RUSH_COUNT repeats (five seconds), such a value changes by a
 * hundred steps at a time. */
#define HURRY_COUNT 12u
#define RUSH_COUNT 36u
#define HURRY_STEPS_MIN 40
#define RUSH_STEPS_MIN 400

static bool is_settings(const struct menu *menu)
{
    return menu_page_desc_of(menu->page)->body == MENU_BODY_SETTINGS;
}

/* Opens a settings page. Until the operator changes a value, the item "restore the default" applies
 * to the first row whose value differs from its default. */
void menu_settings_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    menu->chosen = MENU_TAG_MAX;
    menu->turns_down = menu->turning = 0;
    menu->tag[menu->page] = 0;
    if (!is_settings(menu)) {
        return;
    }
    for (uint32_t tag = menu_body_count(menu->page, menu->rules); tag-- > 0;) {
        const uint32_t id = menu_setting_at(menu->page, menu->rules, tag);
        if (id < SETTING_COUNT && settings->value[id] != settings_entry(id)->standard) {
            menu->chosen = (uint8_t)tag;
        }
    }
}

/* Changes the value of setting `id` by one or more steps. While a button is held, the value stops
 * at the end of its range. A new press continues at the opposite end. */
static void step_setting(const struct menu_scope *scope, uint32_t id)
{
    struct menu *menu = scope->menu;
    CORE_ASSERT(id < SETTING_COUNT);
    const struct setting *setting = settings_entry(id);
    const int32_t steps = (settings_edit_max(scope->config, id) - setting->min) / setting->step;
    const uint32_t stride = menu->turn_count >= RUSH_COUNT && steps >= RUSH_STEPS_MIN     ? 100u
                            : menu->turn_count >= HURRY_COUNT && steps >= HURRY_STEPS_MIN ? 10u
                                                                                          : 1u;
    menu->turning = !settings_edit_step(scope, id, menu->turns_down, stride);
    menu->turn_tick = scope->game->tick;
}

/* Returns the items of a settings page that can be selected. The item "restore the default" applies
 * to the row that was changed last. The highlighted row cannot be meant, because the item itself is
 * highlighted when it is selected. Before any change, the item applies to the first row that
 * differs from its default. */
uint16_t menu_settings_enabled(const struct menu *menu)
{
    CORE_ASSERT(menu->page < MENU_PAGE_COUNT);
    const uint32_t standard = menu_body_count(menu->page, menu->rules) + SETTINGS_STANDARD;
    const uint32_t all = (1u << menu_tag_count(menu->page, menu->rules)) - 1u;
    return (uint16_t)(menu->chosen < MENU_TAG_MAX ? all : all & ~(1u << standard));
}

void menu_settings_activate(const struct menu_scope *scope, uint32_t tag)
{
    struct menu *menu = scope->menu;
    CORE_ASSERT(is_settings(menu) && tag < menu_tag_count(menu->page, menu->rules));
    const uint32_t body_count = menu_body_count(menu->page, menu->rules);
    if (tag < body_count) {
        menu->turn_count = 0;
        menu->chosen = (uint8_t)tag;
        step_setting(scope, menu_setting_at(menu->page, menu->rules, tag));
    } else if (tag == body_count + SETTINGS_DIRECTION) {
        menu->turns_down = !menu->turns_down;
    } else {
        const uint32_t id = menu_setting_at(menu->page, menu->rules, menu->chosen);
        settings_edit_set(scope, id, settings_entry(id)->standard);
        menu->turn_tick = scope->game->tick;
    }
}

/* Toggles one bit of the page's setting. A bit that is the only set bit cannot be cleared. */
void menu_bits_activate(const struct menu_scope *scope, uint32_t tag)
{
    struct menu *menu = scope->menu;
    CORE_ASSERT(menu_page_desc_of(menu->page)->body == MENU_BODY_BITS);
    const uint32_t id = menu_page_desc_of(menu->page)->topic;
    const int32_t value = scope->config->persistent.settings.value[id] ^ (1 << tag);
    if (settings_allows(id, value)) {
        settings_edit_set(scope, id, value);
        menu->turn_tick = scope->game->tick;
    }
}

void menu_settings_tick(const struct menu_scope *scope, bool is_pressed)
{
    struct menu *menu = scope->menu;
    CORE_ASSERT(scope->game->phase == PHASE_MENU && menu->page < MENU_PAGE_COUNT);
    const uint8_t tag = menu->tag[menu->page];
    if (!is_settings(menu)) {
        menu->turning = 0;
        return;
    }
    const uint32_t wait = menu->turn_count == 0 ? HOLD_TICKS : AGAIN_TICKS;
    menu->turning = menu->turning && is_pressed && tag == menu->chosen;
    if (menu->turning && scope->game->tick - menu->turn_tick >= wait) {
        menu->turn_count = (uint8_t)(menu->turn_count + (menu->turn_count < UINT8_MAX));
        step_setting(scope, menu_setting_at(menu->page, menu->rules, tag));
        output_sound(scope->output, SOUND_TICK, 0.4f, 0.0f);
    }
}
