/* menu_pages.c -- the table of the operator's menu pages, with the parent and the actions of each
 * page. */
#include "core/game/menu/menu_pages.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/poi/world.h"

#define PAGES(parent_page) { .parent = (parent_page), .body = MENU_BODY_PAGES, .foot_count = 1 }
#define BOOK(group)                                                                                \
    { .parent = MENU_BOOKS,                                                                        \
      .body = MENU_BODY_FREE,                                                                      \
      .foot_count = BOOK_TAGS,                                                                     \
      .topic = (group),                                                                            \
      .open = menu_confirm_open,                                                                   \
      .activate = menu_book_activate }
#define SURE(parent_page, take_it)                                                                 \
    { .parent = (parent_page),                                                                     \
      .body = MENU_BODY_FREE,                                                                      \
      .foot_count = CONFIRM_TAGS,                                                                  \
      .open = menu_confirm_open,                                                                   \
      .activate = (take_it) }
#define KEYS(parent_page, take_it)                                                                 \
    { .parent = (parent_page),                                                                     \
      .body = MENU_BODY_KEYS,                                                                      \
      .body_count = PIN_ERASE,                                                                     \
      .foot_count = PIN_TAGS - PIN_ERASE,                                                          \
      .open = menu_pin_open,                                                                       \
      .activate = (take_it) }
#define SETTINGS(group)                                                                            \
    { .parent = MENU_TOP,                                                                          \
      .body = MENU_BODY_SETTINGS,                                                                  \
      .foot_count = SETTINGS_FEET,                                                                 \
      .topic = (group),                                                                            \
      .is_enabled = menu_settings_enabled,                                                         \
      .open = menu_settings_open,                                                                  \
      .activate = menu_settings_activate }

/* clang-format off */
static const struct menu_page_desc sheets[MENU_PAGE_COUNT] = {
    [MENU_TOP] = PAGES(MENU_PAGE_COUNT),
    [MENU_DEVICES] = PAGES(MENU_TOP),
    [MENU_CONTROLLERS] = { .parent = MENU_DEVICES, .body = MENU_BODY_ROWS,
                           .body_count = CONTROLLER_MAX, .foot_count = 1,
                           .is_enabled = menu_rows_enabled, .activate = menu_rows_activate },
    [MENU_CONTROLLER] = { .parent = MENU_CONTROLLERS, .body = MENU_BODY_TILES,
        .body_count = ROW_BACK,
                          .foot_count = 1, .is_enabled = menu_row_enabled, .open = menu_reopen,
                          .activate = menu_row_activate },
    [MENU_LEARN] = { .parent = MENU_CONTROLLER, .body = MENU_BODY_FREE, .foot_count = LEARNS_TAGS,
                     .is_enabled = menu_learn_enabled, .open = menu_reopen,
                     .activate = menu_learn_activate, .leave = menu_learn_close },
    [MENU_LINES] = { .parent = MENU_DEVICES, .body = MENU_BODY_FREE, .foot_count = LINES_TAGS,
                     .shows_presses = true },
    [MENU_AXES] = { .parent = MENU_DEVICES, .body = MENU_BODY_FREE, .foot_count = 1 },
    [MENU_CALIBRATION] = { .parent = MENU_DEVICES, .body = MENU_BODY_FREE,
                           .foot_count = CALIBRATE_TAGS, .is_enabled = menu_calibrate_enabled,
                           .open = menu_calibrate_open, .activate = menu_calibrate_activate },
    [MENU_MONEY] = SETTINGS(GROUP_MONEY),
    [MENU_GAME] = SETTINGS(GROUP_GAME),
    [MENU_MODES] = { .parent = MENU_GAME, .body = MENU_BODY_BITS, .foot_count = 1,
                     .topic = SET_MODES, .activate = menu_bits_activate },
    [MENU_SOUND] = SETTINGS(GROUP_SOUND),
    [MENU_PICTURE] = SETTINGS(GROUP_PICTURE),
    [MENU_CARD] = { .parent = MENU_PICTURE, .body = MENU_BODY_FREE, .foot_count = 1 },
    [MENU_BOOKS] = PAGES(MENU_TOP),
    [MENU_EARNINGS] = BOOK(AUDIT_GROUP_MONEY),
    [MENU_PLAYS] = BOOK(AUDIT_GROUP_PLAY),
    [MENU_HOURS] = BOOK(AUDIT_GROUP_PLAY),
    [MENU_MACHINE] = BOOK(AUDIT_GROUP_MACHINE),
    [MENU_RESET] = { .parent = MENU_EARNINGS, .body = MENU_BODY_FREE, .foot_count = CONFIRM_TAGS,
                     .returns = true, .open = menu_confirm_open, .activate = menu_reset_activate },
    [MENU_RANKING] = { .parent = MENU_BOOKS, .body = MENU_BODY_ROWS, .body_count = RANKING_NEXT,
                       .foot_count = 2, .is_enabled = menu_ranking_enabled,
                       .open = menu_ranking_open, .activate = menu_ranking_activate },
    [MENU_SCORE] = { .parent = MENU_RANKING, .body = MENU_BODY_TILES, .body_count = SCORE_BACK,
                     .foot_count = 1, .is_enabled = menu_score_enabled, .open = menu_score_open,
                     .activate = menu_score_activate },
    [MENU_SELF_TEST] = { .parent = MENU_TOP, .body = MENU_BODY_FREE, .foot_count = SELF_TAGS,
                         .shows_presses = true, .is_enabled = menu_self_enabled,
                         .open = menu_self_open, .activate = menu_self_activate },
    [MENU_UPKEEP] = { .parent = MENU_TOP, .body = MENU_BODY_PAGES, .foot_count = 1,
                      .is_enabled = menu_upkeep_enabled },
    [MENU_FILES] = { .parent = MENU_UPKEEP, .body = MENU_BODY_FREE, .foot_count = FILES_TAGS,
                     .is_enabled = menu_files_enabled, .open = menu_files_open,
                     .activate = menu_files_activate },
    [MENU_ABOUT] = { .parent = MENU_UPKEEP, .body = MENU_BODY_FREE, .foot_count = 1 },
    [MENU_NEW_PIN] = KEYS(MENU_UPKEEP, menu_new_pin_activate),
    [MENU_RESTART] = SURE(MENU_UPKEEP, menu_restart_activate),
    [MENU_FACTORY] = SURE(MENU_UPKEEP, menu_factory_activate),
    [MENU_UPDATE] = { .parent = MENU_UPKEEP, .body = MENU_BODY_FREE, .foot_count = UPDATE_TAGS,
                      .is_enabled = menu_update_enabled, .open = menu_update_open,
                      .activate = menu_update_activate },
    [MENU_PIN] = KEYS(MENU_PAGE_COUNT, menu_pin_activate),
};
/* clang-format on */
_Static_assert(ROWS_TAGS <= MENU_TAG_MAX && PIN_TAGS <= MENU_TAG_MAX, "each tag has its bit");
_Static_assert(RANKING_TAGS <= MENU_TAG_MAX, "each tag has its bit");
_Static_assert(MENU_PAGE_COUNT <= 32u, "tests keep a bit for each page that they have seen");

const struct menu_page_desc *menu_page_desc_of(uint8_t page)
{
    CORE_ASSERT(page < MENU_PAGE_COUNT);
    return &sheets[page];
}

/* ---- Numbers and contents of a page's items -------------------------------------------------- */

/* Returns child page `nth` of the page `parent`, or MENU_PAGE_COUNT if the parent has fewer
 * children. Writes the number of children counted until then to `*count`. A page that is opened by
 * a row of data, such as a controller, is not counted. */
static uint8_t nth_child(uint8_t parent, uint32_t nth, uint32_t *count)
{
    CORE_ASSERT(parent <= MENU_PAGE_COUNT);
    *count = 0;
    for (uint32_t page = 0; page < MENU_PAGE_COUNT; page++) {
        if (sheets[page].parent == parent && (*count)++ == nth) {
            return (uint8_t)page;
        }
    }
    return MENU_PAGE_COUNT;
}

/* Returns setting `nth` of the group `group`, or SETTING_COUNT if the group has fewer settings.
 * Writes the number of settings counted until then to `*count`. Settings of kind KIND_BITS are not
 * counted, because each has a page of its own. A setting that is
 * newer than the format `rules` is not counted. */
static uint32_t nth_setting(uint8_t group, uint8_t rules, uint32_t nth, uint32_t *count)
{
    *count = 0;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        const bool has_row = setting->group == group && setting->kind != KIND_BITS &&
                             (rules == 0 || setting->since <= rules);
        if (has_row && (*count)++ == nth) {
            return id;
        }
    }
    return SETTING_COUNT;
}

uint32_t menu_body_count(uint8_t page, uint8_t rules)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    uint32_t children, settings, bits = 0;
    nth_child(page, MENU_PAGE_COUNT, &children);
    switch (sheet->body) {
    case MENU_BODY_PAGES:
        return children;
    case MENU_BODY_SETTINGS:
        nth_setting(sheet->topic, rules, SETTING_COUNT, &settings);
        return settings + children;
    case MENU_BODY_BITS:
        while (settings_entry(sheet->topic)->max >> bits) {
            bits++;
        }
        return bits;
    default:
        return sheet->body_count;
    }
}

uint32_t menu_tag_count(uint8_t page, uint8_t rules)
{
    const uint32_t count = menu_body_count(page, rules) + menu_page_desc_of(page)->foot_count;
    CORE_ASSERT(count <= MENU_TAG_MAX);
    return count;
}

uint8_t menu_page_at(uint8_t page, uint8_t rules, uint32_t tag)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    uint32_t first = 0, count;
    if (sheet->body == MENU_BODY_SETTINGS) {
        nth_setting(sheet->topic, rules, SETTING_COUNT, &first);
    } else if (sheet->body != MENU_BODY_PAGES) {
        return MENU_PAGE_COUNT;
    }
    return tag < first ? (uint8_t)MENU_PAGE_COUNT : nth_child(page, tag - first, &count);
}

uint32_t menu_setting_at(uint8_t page, uint8_t rules, uint32_t tag)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(page);
    const uint8_t leads = menu_page_at(page, rules, tag);
    uint32_t count;
    if (leads < MENU_PAGE_COUNT && sheets[leads].body == MENU_BODY_BITS) {
        return sheets[leads].topic;
    }
    return sheet->body == MENU_BODY_SETTINGS ? nth_setting(sheet->topic, rules, tag, &count)
                                             : SETTING_COUNT;
}

uint16_t menu_enabled(const struct menu *menu)
{
    const struct menu_page_desc *sheet = menu_page_desc_of(menu->page);
    return sheet->is_enabled ? sheet->is_enabled(menu)
                             : (uint16_t)((1u << menu_tag_count(menu->page, menu->rules)) - 1u);
}

/* ---- Actions of the selected item ----------------------------------------------------------- */

void menu_command(struct menu *menu, struct output *output, enum controller_command_kind kind)
{
    CORE_ASSERT(kind > COMMAND_NONE);
    output->commands[menu->command_count % CONTROLLER_COMMAND_MAX] =
        (struct controller_command){ .kind = (uint8_t)kind, .row = menu->row };
    output->command_count = ++menu->command_count;
}

bool menu_activate(const struct menu_scope *scope)
{
    struct menu *menu = scope->menu;
    const struct menu_page_desc *sheet = menu_page_desc_of(menu->page);
    const uint32_t tag = menu->tag[menu->page], count = menu_tag_count(menu->page, menu->rules);
    const uint8_t page = menu_page_at(menu->page, menu->rules, tag);
    CORE_ASSERT(tag < count);
    if (tag + 1u == count && sheet->parent == MENU_PAGE_COUNT) {
        return true;
    }
    if (tag + 1u == count) {
        if (sheet->leave) {
            sheet->leave(menu, scope->output);
        }
        menu_go(scope, (enum menu_page)(sheet->returns ? menu->from : sheet->parent));
    } else if (page < MENU_PAGE_COUNT) {
        menu_go(scope, (enum menu_page)page);
    } else {
        CORE_ASSERT(sheet->activate);
        sheet->activate(scope, tag);
    }
    return false;
}

void menu_close(struct game *game, struct world *world, const struct core_config *config,
                struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_MENU);
    const struct menu_page_desc *sheet = menu_page_desc_of(game->menu.page);
    if (sheet->leave) {
        sheet->leave(&game->menu, output);
    }
    attract_begin(game, world, config);
}
