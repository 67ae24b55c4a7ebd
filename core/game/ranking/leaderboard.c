/* leaderboard.c -- selects the leaderboard to show, and writes its content to the scene. */
#include "core/game/ranking/name.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/phases.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

_Static_assert(SCENE_LEADERBOARD_ROWS == RANK_ROWS, "every row can be shown");

uint32_t leaderboard_board(const struct game *game)
{
    return ranking_board(game->mode, game_level(game));
}

struct leaderboard_place leaderboard_best_place(const struct game *game, uint8_t slot)
{
    CORE_ASSERT(slot < POI_MAX);
    const uint32_t board = leaderboard_board(game), round_id = game->name.round_id;
    struct leaderboard_place best = { 0, 0 };
    for (uint8_t period = 0; period < RANK_PERIOD_COUNT && round_id != 0; period++) {
        const uint32_t place = ranking_place(&game->accounts.ranking, board,
                                             (enum rank_period)period, round_id, slot) +
                               1u;
        if (place <= RANK_ROWS && (best.place == 0 || place <= best.place)) {
            best = (struct leaderboard_place){ period, (uint8_t)place };
        }
    }
    return best;
}

/* ---- Selection of the displayed leaderboard ------------------------------------------------- */

struct pick {
    uint8_t shown, board, period;
    uint32_t ticks; /* Number of ticks since the leaderboard appeared on the screen. */
};

/* Returns the leaderboard to show in attract mode. Each interval of LEADERBOARD_EVERY_TICKS begins
 * with the tank, so that passers-by see goldfish first. The leaderboards that have entries take
 * turns. */
static struct pick in_attract(const struct game *game, const struct core_config *config)
{
    CORE_ASSERT(game->phase == PHASE_ATTRACT);
    const uint32_t elapsed = game->tick - game->phase_tick;
    const uint32_t turn = elapsed / LEADERBOARD_EVERY_TICKS;
    const uint32_t within = elapsed % LEADERBOARD_EVERY_TICKS;
    const uint8_t modes = table_setup_modes(config);
    uint8_t filled[RANK_BOARD_COUNT * RANK_PERIOD_COUNT];
    uint32_t count = 0;
    for (uint32_t i = 0; i < RANK_BOARD_COUNT * RANK_PERIOD_COUNT; i++) {
        const uint32_t board = i / RANK_PERIOD_COUNT, period = i % RANK_PERIOD_COUNT;
        const uint8_t mode = ranking_board_at(board).mode;
        if ((modes >> mode & 1u) && rules_of(mode)->keeps_score &&
            game->accounts.ranking.row[board][period][0].caught != 0) {
            filled[count++] = (uint8_t)i;
        }
    }
    if (count == 0 || within < LEADERBOARD_EVERY_TICKS - LEADERBOARD_TICKS) {
        return (struct pick){ 0 };
    }
    const uint8_t nth = filled[turn % count];
    return (struct pick){ 1, nth / RANK_PERIOD_COUNT, nth % RANK_PERIOD_COUNT,
                          within + LEADERBOARD_TICKS - LEADERBOARD_EVERY_TICKS };
}

/* Returns the leaderboard to show in the operator's menu or after a round. In the menu, the result
 * is the selected leaderboard. After a round, the result is the leaderboard on which a player of
 * the round has the best place. */
static struct pick shown_ranking(const struct game *game, const struct core_config *config)
{
    const struct menu *menu = &game->menu;
    struct leaderboard_place best = { 0, 0 };
    switch (game->phase) {
    case PHASE_ATTRACT:
        return in_attract(game, config);
    case PHASE_MENU:
        return (struct pick){ menu->page == MENU_RANKING || menu->page == MENU_SCORE,
                              menu->board / RANK_PERIOD_COUNT, menu->board % RANK_PERIOD_COUNT, 0 };
    case PHASE_LEADERBOARD:
        for (uint8_t slot = 0; slot < POI_MAX; slot++) {
            const struct leaderboard_place place = leaderboard_best_place(game, slot);
            if (place.place != 0 && (best.place == 0 || place.place < best.place)) {
                best = place;
            }
        }
        return (struct pick){ best.place != 0, (uint8_t)leaderboard_board(game), best.period,
                              game->tick - game->phase_tick };
    default:
        return (struct pick){ 0 };
    }
}

/* ---- Tick of the leaderboard phase ---------------------------------------------------------- */

void leaderboard_tick(struct game *game, struct world *world, struct core_config *config,
                      const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_LEADERBOARD);
    const bool dipped = controller_dipped_player(game, world, input) < POI_MAX;
    const bool is_read = game->tick - game->phase_tick >= LEADERBOARD_TICKS;
    if (dipped || (input->pressed & INPUT_START)) {
        game_mode_select_begin(game, world, config, output);
    } else if (((input->pressed & INPUT_OK) || is_read) && !album_begin(game)) {
        attract_begin(game, world, config);
    }
}

/* ---- Content of the leaderboard screen ------------------------------------------------------- */

void leaderboard_show(const struct game *game, const struct core_config *config,
                      struct scene_leaderboard *out)
{
    const struct pick pick = shown_ranking(game, config);
    *out = (struct scene_leaderboard){ .shown = pick.shown };
    if (!pick.shown) {
        return;
    }
    out->mode = ranking_board_at(pick.board).mode;
    out->level = ranking_board_at(pick.board).level;
    out->period = pick.period;
    out->shown_s = (float)pick.ticks * CORE_TICK_S;
    out->left_s = pick.ticks < LEADERBOARD_TICKS
                      ? (float)(LEADERBOARD_TICKS - pick.ticks) * CORE_TICK_S
                      : 0.0f;
    for (uint32_t i = 0; i < RANK_ROWS; i++) {
        const struct rank_row *row = &game->accounts.ranking.row[pick.board][pick.period][i];
        out->row[i].caught = row->caught;
        out->row[i].is_new =
            game->phase == PHASE_LEADERBOARD && row->round_id == game->name.round_id;
        out->row[i].slot = row->slot;
        out->row[i].round_id = row->round_id;
        memcpy(out->row[i].name, row->name, sizeof out->row[i].name);
    }
}
