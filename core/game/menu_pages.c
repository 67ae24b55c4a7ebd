/* menu_pages.c -- which pages there are, and what their tags do. */
#include "core/game/menu_pages.h"

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/phases.h"

#define TAG(tag) ((uint16_t)(1u << (tag)))

static void order(struct core *core, struct output *output, enum desk_order_kind kind)
{
    struct menu *menu = &core->game.menu;
    output->orders[menu->order_count % DESK_ORDER_MAX] =
        (struct desk_order){ (uint8_t)kind, menu->row };
    output->order_count = ++menu->order_count;
}

/* ---- The top -------------------------------------------------------------------------------- */

static uint16_t top_offers(const struct menu *menu)
{
    (void)menu;
    return TAG(TOP_CONTROLLERS) | TAG(TOP_LINES) | TAG(TOP_FILES) | TAG(TOP_LEAVE);
}

static void take_top(struct core *core, uint32_t tag, struct output *output)
{
    switch (tag) {
    case TOP_CONTROLLERS:
        menu_turn(core, MENU_CONTROLLERS);
        break;
    case TOP_LINES:
        menu_turn(core, MENU_LINES);
        break;
    case TOP_FILES:
        core->game.menu.file_first = 0;
        menu_turn(core, MENU_FILES);
        break;
    default:
        menu_close(core, output);
        break;
    }
}

/* ---- Controllers ---------------------------------------------------------------------------- */

static uint16_t rows_offers(const struct menu *menu)
{
    uint16_t offers = TAG(ROWS_BACK);
    for (uint32_t row = 0; row < CONTROLLER_MAX; row++) {
        offers |= menu->desk.state[row] != CONTROLLER_NONE ? TAG(row) : 0;
    }
    return offers;
}

static void take_rows(struct core *core, uint32_t tag, struct output *output)
{
    (void)output;
    if (tag == ROWS_BACK) {
        menu_turn(core, MENU_TOP);
        return;
    }
    core->game.menu.row = (uint8_t)tag;
    menu_turn(core, MENU_CONTROLLER);
}

static uint16_t row_offers(const struct menu *menu)
{
    static const uint16_t by_state[CONTROLLER_STATE_COUNT] = {
        [CONTROLLER_FREE] = TAG(ROW_CHOOSE) | TAG(ROW_LEARN),
        [CONTROLLER_PLAYS] = TAG(ROW_RELEASE) | TAG(ROW_LEARN),
        [CONTROLLER_LOST] = TAG(ROW_RELEASE), /* Away, it can be learned as little as led. */
        [CONTROLLER_DENIED] = TAG(ROW_CHOOSE) | TAG(ROW_RELEASE), /* Perhaps we may by now. */
    };
    return by_state[menu->desk.state[menu->row]] | TAG(ROW_BACK);
}

static void take_row(struct core *core, uint32_t tag, struct output *output)
{
    switch (tag) {
    case ROW_CHOOSE:
        order(core, output, DESK_CHOOSE);
        break;
    case ROW_RELEASE:
        order(core, output, DESK_RELEASE);
        break;
    case ROW_LEARN:
        order(core, output, DESK_LEARN);
        menu_turn(core, MENU_LEARN);
        break;
    default:
        menu_turn(core, MENU_CONTROLLERS);
        break;
    }
}

/* ---- Learning ------------------------------------------------------------------------------- */

static uint16_t learn_offers(const struct menu *menu)
{
    switch (menu->desk.learn_step) {
    case LEARN_NONE:
        return TAG(LEARNS_END); /* Nobody has begun yet, or the controller is away. */
    case LEARN_TRY:
    case LEARN_UNKEPT: /* The card may be in by now. */
        return TAG(LEARNS_KEEP) | TAG(LEARNS_AGAIN) | TAG(LEARNS_END);
    case LEARN_FAILED:
        return TAG(LEARNS_AGAIN) | TAG(LEARNS_END);
    default:
        return TAG(LEARNS_NEXT) | TAG(LEARNS_END);
    }
}

static void take_learn(struct core *core, uint32_t tag, struct output *output)
{
    switch (tag) {
    case LEARNS_NEXT:
        order(core, output, DESK_LEARN_NEXT);
        break;
    case LEARNS_KEEP:
        order(core, output, DESK_LEARN_KEEP);
        menu_turn(core, MENU_CONTROLLERS);
        break;
    case LEARNS_AGAIN:
        order(core, output, DESK_LEARN);
        break;
    default:
        order(core, output, DESK_LEARN_END);
        menu_turn(core, MENU_CONTROLLER);
        break;
    }
}

/* ---- Buttons and coins ---------------------------------------------------------------------- */

static uint16_t lines_offers(const struct menu *menu)
{
    (void)menu;
    return TAG(LINES_BACK);
}

static void take_lines(struct core *core, uint32_t tag, struct output *output)
{
    (void)tag;
    (void)output;
    menu_turn(core, MENU_TOP);
}

/* ---- Files ---------------------------------------------------------------------------------- */

#define FILES_SHOWN 5u

uint32_t menu_files_shown(int upright)
{
    return upright ? SCENE_FILE_MAX : FILES_SHOWN;
}

static uint16_t files_offers(const struct menu *menu)
{
    const int is_long = menu->desk.file_count > menu_files_shown(menu->upright);
    return (uint16_t)((is_long ? TAG(FILES_MORE) : 0u) | TAG(FILES_BACK));
}

/* Behind the last row comes the first again. */
static void take_files(struct core *core, uint32_t tag, struct output *output)
{
    struct menu *menu = &core->game.menu;
    (void)output;
    if (tag == FILES_BACK) {
        menu_turn(core, MENU_TOP);
        return;
    }
    const uint32_t next = menu->file_first + menu_files_shown(menu->upright);
    menu->file_first = (uint8_t)(next < menu->desk.file_count ? next : 0u);
}

/* ---- The table ------------------------------------------------------------------------------ */

static const struct menu_sheet sheets[MENU_PAGE_COUNT] = {
    [MENU_TOP] = { BODY_HUNG, TOP_LEAVE, TOP_TAGS, 0, top_offers, take_top },
    [MENU_CONTROLLERS] = { BODY_ROWS, ROWS_BACK, ROWS_TAGS, 0, rows_offers, take_rows },
    [MENU_CONTROLLER] = { BODY_HUNG, ROW_BACK, ROW_TAGS, 0, row_offers, take_row },
    [MENU_LEARN] = { BODY_FREE, 0, LEARNS_TAGS, 0, learn_offers, take_learn },
    [MENU_LINES] = { BODY_FREE, 0, LINES_TAGS, 1, lines_offers, take_lines },
    [MENU_FILES] = { BODY_FREE, 0, FILES_TAGS, 0, files_offers, take_files },
};
_Static_assert(ROWS_TAGS <= MENU_TAG_MAX, "each tag has its bit");

const struct menu_sheet *menu_sheet_of(uint8_t page)
{
    CORE_ASSERT(page < MENU_PAGE_COUNT);
    return &sheets[page];
}

void menu_close(struct core *core, struct output *output)
{
    if (core->game.menu.page == MENU_LEARN) {
        order(core, output, DESK_LEARN_END);
    }
    attract_begin(core);
}
