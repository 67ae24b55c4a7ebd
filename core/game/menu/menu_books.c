/* menu_books.c -- the pages about statistics: resets a group of counters, browses the leaderboards,
 * plays back a score, and removes a name. */
#include "core/game/menu/menu_pages.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"

void menu_book_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag == BOOK_RESET);
    (void)tag;
    scope->menu->from = scope->menu->page;
    menu_go(scope, MENU_RESET);
}

/* Resets the group of counters that the operator selected. If the ledger has no room, the page that
 * requests confirmation stays open. The ledger entry stores the sum of the group's counters, so
 * that later reports can show the amount that was removed. */
void menu_reset_activate(const struct menu_scope *scope, uint32_t tag)
{
    const uint8_t from = scope->menu->from, group = menu_page_desc_of(from)->topic;
    const struct audits *audits = &scope->accounts->audits;
    uint32_t sum = 0;
    CORE_ASSERT(group < AUDIT_GROUP_COUNT);
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        const uint32_t count = audits_group_of(id) == group ? audits->count[id] : 0u;
        sum = (uint32_t)INT32_MAX - sum < count ? (uint32_t)INT32_MAX : sum + count;
    }
    const struct ledger_entry entry = { .kind = LEDGER_RESET,
                                        .detail = group,
                                        .value = (int32_t)sum };
    (void)tag;
    if (ledger_write(scope->accounts, scope->game->tick, &entry, scope->output) != 0) {
        menu_go(scope, (enum menu_page)from);
    }
}

/* Number of leaderboards. Each board (a mode at one level) has three leaderboards: one for the day,
 * one for the week and one for all time. */
#define BOARD_COUNT (RANK_BOARD_COUNT * RANK_PERIOD_COUNT)

static const struct rank_row *rows_of(const struct ranking *ranking, const struct menu *menu)
{
    CORE_ASSERT(menu->board < BOARD_COUNT);
    const uint8_t board = menu->board;
    return ranking->row[board / RANK_PERIOD_COUNT][board % RANK_PERIOD_COUNT];
}

static const struct rank_row *selected_score_row(const struct ranking *ranking,
                                                 const struct menu *menu)
{
    CORE_ASSERT(menu->score < RANK_ROWS);
    return &rows_of(ranking, menu)[menu->score];
}

/* Returns true if the page shows the selected leaderboard. Modes without a score, such as practice,
 * are skipped, and so are empty leaderboards of the easier levels. */
static bool is_listed(const struct ranking *ranking, const struct menu *menu)
{
    const struct rank_board board = ranking_board_at(menu->board / RANK_PERIOD_COUNT);
    return rules_of(board.mode)->keeps_score &&
           (board.level == LEVEL_MASTER || rows_of(ranking, menu)->caught > 0);
}

/* ---- Page of a leaderboard ------------------------------------------------------------------ */

static void note_rows(const struct ranking *ranking, struct menu *menu)
{
    CORE_ASSERT(menu->board < BOARD_COUNT);
    menu->scores = 0;
    for (uint32_t i = 0; i < RANK_ROWS; i++) {
        menu->scores |= rows_of(ranking, menu)[i].caught > 0 ? MENU_TAG(i) : 0u;
    }
}

uint16_t menu_ranking_enabled(const struct menu *menu)
{
    return (uint16_t)(menu->scores | MENU_TAG(RANKING_NEXT) | MENU_TAG(RANKING_BACK));
}

void menu_ranking_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)settings;
    note_rows(&game->accounts.ranking, menu);
}

/* Runs the action of an item on the leaderboard page: shows the next leaderboard, or opens the page
 * of the selected score. Nothing happens if a new day has removed the selected score. */
void menu_ranking_activate(const struct menu_scope *scope, uint32_t tag)
{
    const struct ranking *ranking = &scope->accounts->ranking;
    struct menu *menu = scope->menu;
    if (tag == RANKING_NEXT) {
        do {
            menu->board = (uint8_t)((menu->board + 1u) % BOARD_COUNT);
        } while (!is_listed(ranking, menu));
        note_rows(ranking, menu);
        return;
    }
    CORE_ASSERT(tag < RANK_ROWS);
    menu->score = (uint8_t)tag;
    note_rows(ranking, menu);
    if (selected_score_row(ranking, menu)->caught > 0) {
        menu_go(scope, MENU_SCORE);
    }
}

/* ---- Page of one score ---------------------------------------------------------------------- */

uint16_t menu_score_enabled(const struct menu *menu)
{
    const uint16_t unname = menu->is_unnaming ? MENU_TAG(SCORE_CONFIRM) : MENU_TAG(SCORE_UNNAME);
    return (uint16_t)(MENU_TAG(SCORE_REPLAY) | (menu->score_is_named ? unname : 0u) |
                      MENU_TAG(SCORE_BACK));
}

void menu_score_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)settings;
    menu->score_is_named = selected_score_row(&game->accounts.ranking, menu)->name[0] != 0;
    menu->is_unnaming = 0;
}

/* Removes the name of a score; the score stays. If the ledger has no room, nothing changes and the
 * operator must try again. */
static void unname(const struct menu_scope *scope)
{
    const struct rank_row *row = selected_score_row(&scope->accounts->ranking, scope->menu);
    const struct ledger_entry entry = { .kind = LEDGER_NAME,
                                        .detail = row->slot,
                                        .count = row->round_id };
    CORE_ASSERT(row->slot < POI_MAX);
    ledger_write(scope->accounts, scope->game->tick, &entry, scope->output);
    menu_score_open(scope->menu, scope->game, &scope->config->persistent.settings);
}

void menu_score_activate(const struct menu_scope *scope, uint32_t tag)
{
    struct menu *menu = scope->menu;
    struct output *output = scope->output;
    const struct rank_row *row = selected_score_row(&scope->accounts->ranking, menu);
    if (row->caught == 0) {
        menu_go(scope, MENU_RANKING);
    } else if (tag == SCORE_REPLAY) {
        output->commands[menu->command_count % CONTROLLER_COMMAND_MAX] =
            (struct controller_command){ .kind = COMMAND_REPLAY, .round_id = row->round_id };
        output->command_count = ++menu->command_count;
    } else if (tag == SCORE_UNNAME) {
        menu->is_unnaming = 1;
    } else {
        unname(scope);
    }
}
