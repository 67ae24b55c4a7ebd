/* attract.c -- the phases without a round: attract mode, in which the built-in bot plays, and the
 * mode selection.
 *
 * Attract mode ends when a player dips the poi or presses START. On the screen of the mode
 * selection players select the mode or the growth lab. LEFT, RIGHT or the position of a poi selects
 * an item. The tank's width is divided into one section per item, in the order of the items. START,
 * OK or a dip confirms the selection. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/bot/paper_patch.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

/* Time in attract mode for which the bot keeps a torn poi before its paper is replaced. */
#define SWAP_TICKS (2u * CORE_TICK_HZ)
/* Number of fish in the bot's bowl at which the bowl is emptied into the tank. Without this limit
 * the bot would catch all fish of the tank during a night. */
#define BOWL_MAX 10u

void attract_begin(struct game *game, struct world *world, const struct core_config *config)
{
    game->mode = table_setup_first_mode(config);
    game->gone_tick = 0;
    world->tank.temper = rules_of_level(LEVEL_MASTER)->temper;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].level = LEVEL_MASTER;
    }
    session_language_reset(game, config);
    game_enter_phase(game, PHASE_ATTRACT);
    table_setup_empty_bowls(world);
    table_setup_prepare(game->control, game, world, config, config->preset);
    game->turn_tick = 0;
    session_request(game);
}

void attract_tick(struct game *game, struct world *world, struct core_config *config,
                  const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ATTRACT);
    const bool dipped = controller_dipped_player(game, world, input) < POI_MAX;
    if ((input->pressed & INPUT_START) || dipped ||
        credit_is_awaited(&game->accounts, config, game->tick)) {
        game_mode_select_begin(game, world, config, output);
    }
    if (game->phase != PHASE_ATTRACT) {
        game->hints = (struct hints){ 0 }; /* A new player starts a game, so reset the hints. */
        return;
    }
    if (game->tick - game->phase_tick >= SESSION_TICKS_MAX) {
        session_request(game);
    }
    const bool is_full = world->bowl[0].fish_count >= BOWL_MAX;
    const bool is_free = world->poi[0].immersed <= 0.0f && world->poi[0].carried_count == 0;
    if (game->gone_tick == 0 && (is_full || !paper_can_hold(&world->poi[0].sheet))) {
        game->gone_tick = game->tick;
    }
    if (game->gone_tick != 0 && game->tick - game->gone_tick >= SWAP_TICKS && is_free) {
        table_setup_replace_poi(game, world, config, 0, game->tick, GAME_SERIES_ATTRACT);
        bowl_empty(&world->bowl[0], 0, &world->tank);
        game->gone_tick = 0;
    }
}

static uint32_t mode_count(uint8_t modes)
{
    uint32_t count = 0;
    for (uint32_t mode = 0; mode < CHOICE_COUNT; mode++) {
        count += modes >> mode & 1u;
    }
    return count;
}

static uint8_t pointed_at(const struct game *game)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    return game->lab_chosen ? CHOICE_LAB : game->mode;
}

/* Selects mode `nth` of the modes that players can choose, counted from 0. */
static void point_at_mode(struct game *game, const struct core_config *config, uint32_t nth,
                          struct output *output)
{
    const uint8_t modes = table_setup_modes(config);
    uint8_t mode = 0;
    CORE_ASSERT(nth < mode_count(modes));
    while (mode < CHOICE_COUNT - 1u && (!(modes >> mode & 1u) || nth > 0)) {
        nth -= modes >> mode & 1u;
        mode++;
    }
    game->point_tick = game->tick;
    if (mode != pointed_at(game)) {
        game->lab_chosen = mode == CHOICE_LAB;
        game->mode = game->lab_chosen ? game->mode : mode;
        output_sound(output, SOUND_CHOOSE, 0.8f, 0.0f);
    }
}

/* Selects an item when a poi enters a different section of the tank. While the poi stays in one
 * section, the buttons can select. A moving poi also restarts the timeout of the screen. The pois
 * are evaluated from last to first, so that the first player's poi decides. */
static void point_by_pois(struct game *game, const struct world *world,
                          const struct core_config *config, struct output *output)
{
    const float count = (float)mode_count(table_setup_modes(config));
    for (uint32_t i = POI_MAX; i-- > 0;) {
        struct player *player = &game->player[i];
        if (!world->bowl[i].present || world->poi[i].link != POI_SOURCE_LIVE) {
            player->points = 0;
            continue;
        }
        /* A poi outside the tank selects the section nearest to the poi. */
        const vec3 hand_m = game->control[i].validation.newest.position_m;
        const float share = hand_m.x / world->tank.size_m.x + 0.5f;
        const uint32_t section = (uint32_t)f_clamp(share * count, 0.0f, count - 0.5f);
        if (player->points != section + 1u) {
            player->points = (uint8_t)(section + 1u);
            point_at_mode(game, config, section, output);
        }
        if (player_stirs(player, hand_m)) {
            player_rests(player, hand_m);
            game->point_tick = game->tick;
        }
    }
}

/* Starts the selected mode. If no credit can be used, because the store stopped after the screen
 * opened, the selection stays and the player may try again. */
static void activate_mode(struct game *game, struct world *world, const struct core_config *config,
                          struct output *output)
{
    if (!credit_can_play(&game->accounts.ledger, config)) {
        credit_request(&game->accounts, game->tick, output);
        return;
    }
    const bool is_lab = game->lab_chosen || table_setup_modes(config) == 1u << CHOICE_LAB;
    game->lab_chosen = 0;
    credit_take(&game->accounts, game, config, is_lab ? CHOICE_LAB : game->mode, output);
    if (is_lab) {
        lab_begin(game, world, config, output);
    } else {
        round_ready_begin(game, world, config, output);
    }
}

void game_mode_select_begin(struct game *game, struct world *world,
                            const struct core_config *config, struct output *output)
{
    if (mode_count(table_setup_modes(config)) == 1u) {
        activate_mode(game, world, config, output);
        return;
    }
    if (!credit_can_play(&game->accounts.ledger, config)) {
        credit_request(&game->accounts, game->tick, output);
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

void game_mode_select_tick(struct game *game, struct world *world, struct core_config *config,
                           const struct input *input, struct output *output)
{
    const uint8_t modes = table_setup_modes(config);
    const uint32_t count = mode_count(modes);
    const uint32_t dipped = controller_dipped_player(game, world, input);
    point_by_pois(game, world, config, output);
    if (dipped < POI_MAX) { /* A dip selects the section below the poi, even if a button selected a
                               different item after the poi entered the section. */
        point_at_mode(game, config, game->player[dipped].points - 1u, output);
    }
    const uint32_t here = mode_count((uint8_t)(modes & ((1u << pointed_at(game)) - 1u)));
    if (input->pressed & INPUT_LEFT) {
        point_at_mode(game, config, (here + count - 1u) % count, output);
    } else if (input->pressed & INPUT_RIGHT) {
        point_at_mode(game, config, (here + 1u) % count, output);
    }
    const bool is_fresh = game->tick - game->phase_tick < GAME_MODE_SELECT_TICKS_MIN;
    if (!is_fresh && (dipped < POI_MAX || (input->pressed & (INPUT_START | INPUT_OK)))) {
        activate_mode(game, world, config, output);
    } else if (game_seconds_left(game, game->tick) <= 0.0f) {
        attract_begin(game, world, config);
    }
}
