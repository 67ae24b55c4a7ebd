/* menu_show.c -- computes the positions of the items of a page, writes the visible state of the
 * operator's menu to the scene, and computes the menu's hash. The pointer code and the renderer
 * share the positions. */
#include "core/game/menu/menu_pages.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/game.h"

/* Sizes and distances that differ between the wide and the portrait canvas. */
struct measures {
    struct layout_box body;
    uint32_t hung_max; /* Largest number of large items in one row. */
    /* Width, height and horizontal distance of large items. `hung_drop` is the vertical space above
     * the next row, in which the renderer draws the pole that carries the items. */
    float hung_width, hung_height, hung_gap, hung_drop;
    float row_height, row_pitch;
    float settings_height; /* Height of the list of settings in the body. The help text is below the
                              list. */
    uint32_t key_columns;
    float key_top, key_width, key_height, key_gap;
    float foot_y, foot_width, foot_height, foot_gap;
};

static const struct measures wide = {
    .body = { 130.0f, 124.0f, 1020.0f, 464.0f },
    .hung_max = 4,
    .hung_width = 282.0f,
    .hung_height = 172.0f,
    .hung_gap = 26.0f,
    .hung_drop = 60.0f,
    .row_height = 52.0f,
    .row_pitch = 58.0f,
    .settings_height = 428.0f,
    .key_columns = 5,
    .key_top = 262.0f,
    .key_width = 150.0f,
    .key_height = 130.0f,
    .key_gap = 26.0f,
    .foot_y = 610.0f,
    .foot_width = 250.0f,
    .foot_height = 66.0f,
    .foot_gap = 24.0f,
};
static const struct measures upright_measures = {
    .body = { 27.0f, 200.0f, 800.0f, 1040.0f },
    .hung_max = 2,
    .hung_width = 372.0f,
    .hung_height = 200.0f,
    .hung_gap = 30.0f,
    .hung_drop = 72.0f,
    .row_height = 112.0f,
    .row_pitch = 128.0f,
    .settings_height = 912.0f,
    .key_columns = 3,
    .key_top = 420.0f,
    .key_width = 210.0f,
    .key_height = 160.0f,
    .key_gap = 36.0f,
    .foot_y = 1262.0f,
    .foot_width = 250.0f,
    .foot_height = 86.0f,
    .foot_gap = 20.0f,
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
 * height `top`. `size` has the width and the height of a box, and the gaps to the next column and
 * row. Each row is centred, and the last row may have fewer boxes. */
static struct layout_box grid_box(const struct measures *m, uint32_t nth, uint32_t count,
                                  uint32_t columns, float top, struct layout_box size)
{
    const uint32_t row = nth / columns, column = nth % columns, left = count - row * columns;
    const float in_row = (float)(left < columns ? left : columns);
    const float width = in_row * size.width + (in_row - 1.0f) * size.x;
    CORE_ASSERT(nth < count && columns > 0);
    return (struct layout_box){
        m->body.x + 0.5f * (m->body.width - width) + (float)column * (size.width + size.x),
        top + (float)row * (size.height + size.y),
        size.width,
        size.height,
    };
}

/* Items at the foot of a page lie in one row and share its width equally. Large items lie in as few
 * rows as possible. With many rows each row is lower than normal. */
struct layout_box menu_box(int upright, uint8_t page, uint16_t offered, uint32_t tag)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    const struct measures *m = upright ? &upright_measures : &wide;
    CORE_ASSERT(tag < menu_tag_count(page));
    if (!(offered >> tag & 1u)) {
        return (struct layout_box){ 0.0f, 0.0f, 0.0f, 0.0f };
    }
    const uint32_t body_count = menu_body_count(page);
    if (tag >= body_count) {
        const uint32_t nth = count_offered(offered, body_count, tag);
        const uint32_t count = count_offered(offered, body_count, menu_tag_count(page));
        const float gaps = (float)(count - 1u) * m->foot_gap;
        const float width = f_min(m->foot_width, (m->body.width - gaps) / (float)count);
        const float row = (float)count * width + gaps;
        return (struct layout_box){
            0.5f * (pointer_layout_size(upright).x - row) + (float)nth * (width + m->foot_gap),
            m->foot_y,
            width,
            m->foot_height,
        };
    }
    if (sheet->body == MENU_BODY_TILES || sheet->body == MENU_BODY_PAGES) {
        const uint32_t count = count_offered(offered, 0, body_count);
        const uint32_t rows = (count + m->hung_max - 1u) / m->hung_max;
        const float height = (float)rows * (m->hung_height + m->hung_drop) - m->hung_drop;
        const struct layout_box size = { m->hung_gap, m->hung_drop, m->hung_width, m->hung_height };
        return grid_box(m, count_offered(offered, 0, tag), count, m->hung_max,
                        m->body.y + 0.5f * (m->body.height - height), size);
    }
    if (sheet->body == MENU_BODY_KEYS) {
        const struct layout_box size = { m->key_gap, m->key_gap, m->key_width, m->key_height };
        return grid_box(m, tag, body_count, m->key_columns, m->key_top, size);
    }
    const int is_settings = sheet->body == MENU_BODY_SETTINGS || sheet->body == MENU_BODY_BITS;
    const float height = is_settings ? m->settings_height : m->body.height;
    const float pitch = f_min(m->row_pitch, height / (float)body_count);
    return (struct layout_box){ m->body.x, m->body.y + (float)tag * pitch, m->body.width,
                                pitch * m->row_height / m->row_pitch };
}

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
