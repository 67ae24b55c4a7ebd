/* mode_select.c -- the screen on which players select the mode or the growth lab. LEFT, RIGHT or
 * the position of a poi selects an item. The tank's width is divided into one section per item, in
 * the order of the items. START, OK or a dip confirms the selection. */
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"

static uint32_t mode_count(uint8_t modes)
{
    uint32_t count = 0;
    for (uint32_t mode = 0; mode < CHOICE_COUNT; mode++) {
        count += modes >> mode & 1u;
    }
    return count;
}

/* Returns the `nth` item of the bit mask `modes`, counted from 0. */
static uint8_t nth_mode(uint8_t modes, uint32_t nth)
{
    uint8_t mode = 0;
    for (; mode < CHOICE_COUNT - 1u; mode++) {
        if (modes >> mode & 1u) {
            if (nth == 0) {
                break;
            }
            nth--;
        }
    }
    return mode;
}

static uint32_t mode_place(uint8_t modes, uint8_t mode)
{
    return mode_count((uint8_t)(modes & ((1u << mode) - 1u)));
}

static uint8_t pointed_at(const struct game *game)
{
    return game->lab_chosen ? CHOICE_LAB : game->mode;
}

static void point_at_mode(struct game *game, const struct core_config *config, uint32_t nth,
                          struct output *output)
{
    const uint8_t mode = nth_mode(table_setup_modes(config), nth);
    game->point_tick = game->tick;
    if (mode != pointed_at(game)) {
        game->lab_chosen = mode == CHOICE_LAB;
        game->mode = game->lab_chosen ? game->mode : mode;
        output_sound(output, SOUND_CHOOSE, 0.8f, 0.0f);
    }
}

/* Returns the section of the tank under the poi, from 0. If the poi is beyond a wall, returns the
 * section nearest to that wall. */
static uint32_t share_under(const struct world *world, vec3 hand_m, uint32_t count)
{
    const float share = hand_m.x / world->tank.size_m.x + 0.5f;
    return (uint32_t)f_clamp(share * (float)count, 0.0f, (float)count - 0.5f);
}

/* Selects an item when the poi enters a different section. While the poi stays in one section, the
 * buttons can select. A moving poi also restarts the timeout of the screen. */
static void point_at_mode_by_hand(struct game *game, const struct world *world,
                                  const struct core_config *config, uint32_t index,
                                  struct output *output)
{
    struct player *player = &game->player[index];
    const vec3 hand_m = game->validation[index].newest.position_m;
    const uint32_t share = share_under(world, hand_m, mode_count(table_setup_modes(config)));
    if (player->points != share + 1u) {
        player->points = (uint8_t)(share + 1u);
        point_at_mode(game, config, share, output);
    }
    if (player_stirs(player, hand_m)) {
        player_rests(player, hand_m);
        game->point_tick = game->tick;
    }
}

/* Evaluates the pois from last to first, so that the first player's poi decides. */
static void point_by_hands(struct game *game, const struct world *world,
                           const struct core_config *config, struct output *output)
{
    for (uint32_t i = POI_MAX; i-- > 0;) {
        if (world->bowl[i].present && world->poi[i].link == POI_SOURCE_LIVE) {
            point_at_mode_by_hand(game, world, config, i, output);
        } else {
            game->player[i].points = 0;
        }
    }
}

static void point_by_buttons(struct game *game, const struct core_config *config,
                             const struct input *input, struct output *output)
{
    const uint8_t modes = table_setup_modes(config);
    const uint32_t count = mode_count(modes);
    const uint32_t here = mode_place(modes, pointed_at(game));
    if (input->pressed & INPUT_LEFT) {
        point_at_mode(game, config, (here + count - 1u) % count, output);
    } else if (input->pressed & INPUT_RIGHT) {
        point_at_mode(game, config, (here + 1u) % count, output);
    }
}

/* Confirms the selected item. The store may have stopped after the screen opened, so that no credit
 * can be used. The selection then stays, and the player may try again. */
static void activate_mode(struct game *game, struct world *world, const struct core_config *config,
                          struct output *output)
{
    if (!credit_can_play(&game->accounts.ledger, config)) {
        credit_ask(&game->accounts, game->tick, output);
        return;
    }
    const int is_lab = game->lab_chosen || table_setup_modes(config) == 1u << CHOICE_LAB;
    game->lab_chosen = 0;
    credit_take(game, config, is_lab ? CHOICE_LAB : game->mode, output);
    if (is_lab) {
        lab_begin(game, world, config, output);
    } else {
        ready_begin(game, world, config, output);
    }
}

void mode_select_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output)
{
    if (mode_count(table_setup_modes(config)) == 1u) {
        activate_mode(game, world, config, output);
        return;
    }
    if (!credit_can_play(&game->accounts.ledger, config)) {
        credit_ask(&game->accounts, game->tick, output);
        return;
    }
    game_enter_phase(game, PHASE_MODE_SELECT);
    game->point_tick = game->tick;
    game->lab_chosen = (table_setup_modes(config) >> game->mode & 1u) == 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].points = 0;
    }
    table_setup_empty_bowls(world);
    output_sound(output, SOUND_CHOOSE, 1.0f, 0.0f);
}

void mode_select_tick(struct game *game, struct world *world, const struct core_config *config,
                      const struct input *input, struct output *output)
{
    const uint32_t dipped = game_dipped_player(game, world, input);
    point_by_hands(game, world, config, output);
    if (dipped < POI_MAX) { /* A dip selects the section below the poi, even if a button selected a
                               different item after the poi entered the section. */
        point_at_mode(game, config, game->player[dipped].points - 1u, output);
    }
    point_by_buttons(game, config, input, output);
    const int is_fresh = game->tick - game->phase_tick < GAME_MODE_SELECT_TICKS_MIN;
    if (!is_fresh && (dipped < POI_MAX || (input->pressed & (INPUT_START | INPUT_OK)))) {
        activate_mode(game, world, config, output);
    } else if (game_seconds_left(game, game->tick) <= 0.0f) {
        attract_begin(game, world, config);
    }
}
