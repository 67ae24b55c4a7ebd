/* menu_ranking.c -- menu pages of the leaderboard: browse, play back a score, and remove a name. */
#include "core/core.h"
#include "core/game/menu/menu_internal.h"

/* Number of leaderboards: for each mode those of the day, of the week, and the permanent one. */
#define BOARD_COUNT (MODE_COUNT * RANK_PERIOD_COUNT)

static struct rank_row *rows_of(struct core *core)
{
    const uint8_t board = core->game.menu.board;
    return core->game.accounts.ranking.row[board / RANK_PERIOD_COUNT][board % RANK_PERIOD_COUNT];
}

static struct rank_row *score(struct core *core)
{
    return &rows_of(core)[core->game.menu.score];
}

/* ---- Leaderboards --------------------------------------------------------------------------- */

static void note_rows(struct core *core)
{
    struct menu *menu = &core->game.menu;
    menu->scores = 0;
    for (uint32_t i = 0; i < RANK_ROWS; i++) {
        menu->scores |= rows_of(core)[i].caught > 0 ? MENU_TAG(i) : 0u;
    }
}

uint16_t menu_ranking_enabled(const struct menu *menu)
{
    return (uint16_t)(menu->scores | MENU_TAG(RANKING_NEXT) | MENU_TAG(RANKING_BACK));
}

void menu_ranking_open(struct core *core)
{
    note_rows(core);
}

/* Skips modes without a score, such as practice. */
static void next_board(struct core *core)
{
    struct menu *menu = &core->game.menu;
    do {
        menu->board = (uint8_t)((menu->board + 1u) % BOARD_COUNT);
    } while (!rules_of(menu->board / RANK_PERIOD_COUNT)->keeps_score);
    note_rows(core);
}

/* Opens the selected score, if the row still exists; a new day may have cleared it. */
void menu_ranking_activate(struct core *core, uint32_t tag, struct output *output)
{
    struct menu *menu = &core->game.menu;
    (void)output;
    if (tag == RANKING_NEXT) {
        next_board(core);
        return;
    }
    menu->score = (uint8_t)tag;
    note_rows(core);
    if (score(core)->caught > 0) {
        menu_turn(core, MENU_SCORE);
    }
}

/* ---- One score ------------------------------------------------------------------------------ */

uint16_t menu_score_enabled(const struct menu *menu)
{
    const uint16_t unname = menu->score_asks ? MENU_TAG(SCORE_CONFIRM) : MENU_TAG(SCORE_UNNAME);
    return (uint16_t)(MENU_TAG(SCORE_REPLAY) | (menu->score_is_named ? unname : 0u) |
                      MENU_TAG(SCORE_BACK));
}

void menu_score_open(struct core *core)
{
    struct menu *menu = &core->game.menu;
    menu->score_is_named = score(core)->name[0] != 0;
    menu->score_asks = 0;
}

static void show_again(struct core *core, struct output *output)
{
    struct menu *menu = &core->game.menu;
    output->commands[menu->command_count % CONTROLLER_COMMAND_MAX] =
        (struct controller_command){ .kind = COMMAND_REPLAY, .round_id = score(core)->round_id };
    output->command_count = ++menu->command_count;
}

/* Removes the name; the score stays. If the ledger has no room, the operator must try again. */
static void unname(struct core *core, struct output *output)
{
    const struct rank_row *row = score(core);
    const struct ledger_entry entry = { .kind = LEDGER_NAME,
                                        .detail = row->seat,
                                        .count = row->round_id };
    ledger_write(core, &entry, output);
    menu_score_open(core);
}

void menu_score_activate(struct core *core, uint32_t tag, struct output *output)
{
    if (score(core)->caught == 0) {
        menu_turn(core, MENU_RANKING);
    } else if (tag == SCORE_REPLAY) {
        show_again(core, output);
    } else if (tag == SCORE_UNNAME) {
        core->game.menu.score_asks = 1;
    } else {
        unname(core, output);
    }
}
