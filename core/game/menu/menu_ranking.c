/* menu_ranking.c -- the menu pages of the leaderboards, which browse scores, play back a score, and
 * remove a name. */
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

/* Number of leaderboards: each mode has one for the day, one for the week, and one for all time. */
#define BOARD_COUNT (MODE_COUNT * RANK_PERIOD_COUNT)

static struct rank_row *rows_of(struct ranking *ranking, const struct menu *menu)
{
    const uint8_t board = menu->board;
    return ranking->row[board / RANK_PERIOD_COUNT][board % RANK_PERIOD_COUNT];
}

static struct rank_row *score(struct ranking *ranking, const struct menu *menu)
{
    return &rows_of(ranking, menu)[menu->score];
}

/* ---- Leaderboards --------------------------------------------------------------------------- */

static void note_rows(struct ranking *ranking, struct menu *menu)
{
    menu->scores = 0;
    for (uint32_t i = 0; i < RANK_ROWS; i++) {
        menu->scores |= rows_of(ranking, menu)[i].caught > 0 ? MENU_TAG(i) : 0u;
    }
}

uint16_t menu_ranking_enabled(const struct menu *menu)
{
    return (uint16_t)(menu->scores | MENU_TAG(RANKING_NEXT) | MENU_TAG(RANKING_BACK));
}

void menu_ranking_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    note_rows(&game->accounts.ranking, &game->menu);
}

/* Selects the next leaderboard. Modes without a score, such as practice, are skipped. */
static void next_board(struct ranking *ranking, struct menu *menu)
{
    do {
        menu->board = (uint8_t)((menu->board + 1u) % BOARD_COUNT);
    } while (!rules_of(menu->board / RANK_PERIOD_COUNT)->keeps_score);
    note_rows(ranking, menu);
}

/* Opens the page of the selected score, if its row still exists. A new day may have cleared the
 * row. */
void menu_ranking_activate(struct game *game, struct core_config *config, uint32_t tag,
                           struct output *output)
{
    struct menu *menu = &game->menu;
    (void)output;
    if (tag == RANKING_NEXT) {
        next_board(&game->accounts.ranking, &game->menu);
        return;
    }
    menu->score = (uint8_t)tag;
    note_rows(&game->accounts.ranking, &game->menu);
    if (score(&game->accounts.ranking, &game->menu)->caught > 0) {
        menu_turn(game, &config->persistent.settings, MENU_SCORE);
    }
}

/* ---- One score ------------------------------------------------------------------------------ */

uint16_t menu_score_enabled(const struct menu *menu)
{
    const uint16_t unname = menu->score_asks ? MENU_TAG(SCORE_CONFIRM) : MENU_TAG(SCORE_UNNAME);
    return (uint16_t)(MENU_TAG(SCORE_REPLAY) | (menu->score_is_named ? unname : 0u) |
                      MENU_TAG(SCORE_BACK));
}

void menu_score_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    struct menu *menu = &game->menu;
    menu->score_is_named = score(&game->accounts.ranking, &game->menu)->name[0] != 0;
    menu->score_asks = 0;
}

static void show_again(struct ranking *ranking, struct menu *menu, struct output *output)
{
    output->commands[menu->command_count % CONTROLLER_COMMAND_MAX] =
        (struct controller_command){ .kind = COMMAND_REPLAY,
                                     .round_id = score(ranking, menu)->round_id };
    output->command_count = ++menu->command_count;
}

/* Removes the name of a score; the score stays. If the ledger has no room, nothing changes and the
 * operator must try again. */
static void unname(struct game *game, const struct settings *settings, struct output *output)
{
    const struct rank_row *row = score(&game->accounts.ranking, &game->menu);
    const struct ledger_entry entry = { .kind = LEDGER_NAME,
                                        .detail = row->seat,
                                        .count = row->round_id };
    ledger_write(&game->accounts, game->tick, &entry, output);
    menu_score_open(game, settings);
}

void menu_score_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output)
{
    if (score(&game->accounts.ranking, &game->menu)->caught == 0) {
        menu_turn(game, &config->persistent.settings, MENU_RANKING);
    } else if (tag == SCORE_REPLAY) {
        show_again(&game->accounts.ranking, &game->menu, output);
    } else if (tag == SCORE_UNNAME) {
        game->menu.score_asks = 1;
    } else {
        unname(game, &config->persistent.settings, output);
    }
}
