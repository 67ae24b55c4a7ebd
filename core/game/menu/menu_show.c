/* menu_show.c -- computes the positions of the items of a page, writes the visible state of the
 * operator's menu to the scene, and computes the menu's hash. The pointer code and the renderer
 * share the positions. */
#include "core/game/menu/menu_pages.h"

#include "core/base/fmath.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/game.h"

/* Size of one kind of item: its width and height, and its distances to the items of the next column
 * and row. */
struct tile {
    float width, height, gap_x, gap_y;
};

/* Sizes and distances of the menu's items that differ between the wide and the portrait canvas. */
struct measures {
    struct layout_box body;
    uint32_t hung_columns; /* Largest number of large items that fit in one row. */
    /* Size of a large item. `gap_y` is the space in which the renderer draws the pole that carries
     * the items. */
    struct tile hung;
    float row_height, row_pitch;
    /* Height of the list of settings in the body. The help text is below the list. */
    float settings_height;
    uint32_t key_columns;
    float key_top;
    struct tile key;
    float foot_y;
    struct tile foot;
};

static const struct measures wide = {
    .body = { 130.0f, 124.0f, 1020.0f, 464.0f },
    .hung_columns = 4,
    .hung = { 282.0f, 172.0f, 26.0f, 60.0f },
    .row_height = 52.0f,
    .row_pitch = 58.0f,
    .settings_height = 428.0f,
    .key_columns = 5,
    .key_top = 262.0f,
    .key = { 150.0f, 130.0f, 26.0f, 26.0f },
    .foot_y = 610.0f,
    .foot = { 250.0f, 66.0f, 24.0f, 0.0f },
};
static const struct measures upright_measures = {
    .body = { 27.0f, 200.0f, 800.0f, 1040.0f },
    .hung_columns = 2,
    .hung = { 372.0f, 200.0f, 30.0f, 72.0f },
    .row_height = 112.0f,
    .row_pitch = 128.0f,
    .settings_height = 912.0f,
    .key_columns = 3,
    .key_top = 420.0f,
    .key = { 210.0f, 160.0f, 36.0f, 36.0f },
    .foot_y = 1262.0f,
    .foot = { 250.0f, 86.0f, 20.0f, 0.0f },
};

/* Returns the number of available items from `first` up to, but not including, `limit`. */
static uint32_t count_offered(uint16_t offered, uint32_t first, uint32_t limit)
{
    CORE_ASSERT(first <= limit && limit <= MENU_TAG_MAX);
    uint32_t count = 0;
    for (uint32_t tag = first; tag < limit; tag++) {
        count += offered >> tag & 1u;
    }
    return count;
}

/* Returns box `nth` of `count` boxes in a grid with `columns` columns and its upper left corner at
 * height `top`. Each row is centred, and the last row may have fewer boxes. */
static struct layout_box grid_box(const struct measures *m, uint32_t nth, uint32_t count,
                                  uint32_t columns, float top, const struct tile *tile)
{
    const uint32_t row = nth / columns, column = nth % columns, left = count - row * columns;
    const float in_row = (float)(left < columns ? left : columns);
    const float width = in_row * tile->width + (in_row - 1.0f) * tile->gap_x;
    CORE_ASSERT(nth < count && columns > 0);
    return (struct layout_box){
        m->body.x + 0.5f * (m->body.width - width) + (float)column * (tile->width + tile->gap_x),
        top + (float)row * (tile->height + tile->gap_y),
        tile->width,
        tile->height,
    };
}

/* Returns the box of the item `tag` on the canvas. Items at the foot of a page lie in one row and
 * have equal widths. Large items lie in as few rows as possible. If there are many rows, the height
 * of each row is reduced. */
struct layout_box menu_box(bool upright, uint8_t page, uint8_t rules, uint16_t offered,
                           uint32_t tag)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    const struct measures *m = upright ? &upright_measures : &wide;
    CORE_ASSERT(tag < menu_tag_count(page, rules));
    if (!(offered >> tag & 1u)) {
        return (struct layout_box){ 0.0f, 0.0f, 0.0f, 0.0f };
    }
    const uint32_t body_count = menu_body_count(page, rules);
    if (tag >= body_count) {
        const uint32_t nth = count_offered(offered, body_count, tag);
        const uint32_t count = count_offered(offered, body_count, menu_tag_count(page, rules));
        const float gaps = (float)(count - 1u) * m->foot.gap_x;
        const float width = f_min(m->foot.width, (m->body.width - gaps) / (float)count);
        const float row = (float)count * width + gaps;
        return (struct layout_box){
            0.5f * (pointer_layout_size(upright).x - row) + (float)nth * (width + m->foot.gap_x),
            m->foot_y,
            width,
            m->foot.height,
        };
    }
    if (sheet->body == MENU_BODY_TILES || sheet->body == MENU_BODY_PAGES) {
        const uint32_t count = count_offered(offered, 0, body_count);
        const uint32_t rows = (count + m->hung_columns - 1u) / m->hung_columns;
        const float height = (float)rows * (m->hung.height + m->hung.gap_y) - m->hung.gap_y;
        return grid_box(m, count_offered(offered, 0, tag), count, m->hung_columns,
                        m->body.y + 0.5f * (m->body.height - height), &m->hung);
    }
    if (sheet->body == MENU_BODY_KEYS) {
        return grid_box(m, tag, body_count, m->key_columns, m->key_top, &m->key);
    }
    const bool is_settings = sheet->body == MENU_BODY_SETTINGS || sheet->body == MENU_BODY_BITS;
    const float height = is_settings ? m->settings_height : m->body.height;
    const float pitch = f_min(m->row_pitch, height / (float)body_count);
    return (struct layout_box){ m->body.x, m->body.y + (float)tag * pitch, m->body.width,
                                pitch * m->row_height / m->row_pitch };
}

/* Width of an arrow, and of the space for a value between two arrows. */
#define ARROW_WIDTH 58.0f
#define VALUE_WIDTH 192.0f

bool menu_has_arrows(uint8_t page, uint8_t rules, uint32_t tag)
{
    return (rules == 0 || rules >= 10u) && menu_page_desc_of(page)->body == MENU_BODY_SETTINGS &&
           menu_page_at(page, rules, tag) == MENU_PAGE_COUNT &&
           menu_setting_at(page, rules, tag) < SETTING_COUNT;
}

struct layout_box menu_arrow_box(struct layout_box row, bool is_left)
{
    const float from_right = is_left ? VALUE_WIDTH + 2.0f * ARROW_WIDTH : ARROW_WIDTH;
    CORE_ASSERT(row.width > VALUE_WIDTH + 2.0f * ARROW_WIDTH);
    return (struct layout_box){ row.x + row.width - from_right, row.y, ARROW_WIDTH, row.height };
}

void menu_aim_at_arrow(struct menu *menu, struct layout_point at)
{
    const uint32_t tag = menu->tag[menu->page];
    if (!menu_has_arrows(menu->page, menu->rules, tag)) {
        return;
    }
    const struct layout_box row =
        menu_box(menu->upright, menu->page, menu->rules, menu_enabled(menu), tag);
    for (uint32_t is_left = 0; is_left < 2u; is_left++) {
        if (pointer_is_inside(menu_arrow_box(row, is_left), 0.0f, at)) {
            menu->turns_down = (uint8_t)is_left;
        }
    }
}

_Static_assert(AUDIT_COUNT <= SCENE_AUDIT_MAX, "every audit can be shown");

/* Time for which a menu page shows that a change has been saved on disk. */
#define SAVED_TICKS (10u * CORE_TICK_HZ)
/* Number of seconds that is reported if an event never occurred: about eleven days. */
#define NEVER_S 1e6f

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
    out->rules = menu->rules;
    out->has_pointer = menu->has_pointer;
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
    /* Show the typed digits only on the page for a new PIN. The PIN that is typed to open the menu
     * must not be visible. */
    out->pin = menu->page == MENU_NEW_PIN ? menu->pin : 0;
    memcpy(out->audit, game->accounts.audits.count, sizeof game->accounts.audits.count);
    out->boot = game->accounts.ledger.boot;
    out->last_id = game->accounts.ledger.last_id;
    out->saved_id = game->accounts.ledger.saved_id;
    out->settings = config->persistent.settings;
    self_test_show(game, config, &out->self);
    out->slot = menu->calibrate.slot;
    out->calibrate_step = menu->calibrate.step;
    out->calibrate_fault = menu->calibrate.fault;
    out->calibrated = menu->calibrate.is_set;
    out->menu_calibrate_progress = menu_calibrate_progress(&menu->calibrate);
    out->calibrated_m = game->control[menu->calibrate.slot].validation.newest.position_m;
    out->coin_s =
        menu->test_coins > 0 ? (float)(game->tick - menu->coin_tick) * CORE_TICK_S : NEVER_S;
}
