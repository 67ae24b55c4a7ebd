/* mode_select.c -- the mode selection. On this screen players select the mode or the growth lab,
 * and in the festival mode each player selects a level.
 *
 * Each tag (mode_tags.h) stands for a mode, or for the festival mode at a level. The pointer of a
 * moved poi selects the tag below it. LEFT and RIGHT select for the first player with a poi. START,
 * OK or a dip confirms the selection. A poi that has not moved since the screen appeared selects
 * nothing. START or a dip at once therefore begins the festival mode at the configured level.
 *
 * In recordings older than format 9 the festival mode is one item without levels, and the tank's
 * width is divided into one section for each item. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/mode_tags.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

static uint32_t count_bits(uint32_t mask)
{
    uint32_t count = 0;
    for (; mask; mask >>= 1) {
        count += mask & 1u;
    }
    return count;
}

static uint32_t offered_tags(const struct core_config *config)
{
    return mode_tags_offered(table_setup_modes(config), config_has_rules(config, 9));
}

uint32_t game_mode_select_tag(const struct game *game, uint32_t player)
{
    CORE_ASSERT(player < POI_MAX && game->mode < MODE_COUNT);
    const uint8_t mode = game->lab_chosen ? CHOICE_LAB : game->mode;
    uint32_t tag = 0;
    while (mode_tags[tag].mode != mode ||
           (tag < MODE_TAG_LEVELS && mode_tags[tag].level != game->player[player].level)) {
        tag++;
    }
    return tag;
}

uint32_t game_mode_select_lead(const struct world *world)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (world->bowl[i].present && world->poi[i].link == POI_SOURCE_LIVE) {
            return i;
        }
    }
    return 0;
}

/* Selects tag `nth` of the offered tags, counted from 0, for `player`. */
static void point_at_tag(struct game *game, const struct core_config *config, uint32_t player,
                         uint32_t nth, struct output *output)
{
    const uint32_t offered = offered_tags(config);
    uint32_t tag = 0;
    CORE_ASSERT(nth < count_bits(offered));
    while (!(offered >> tag & 1u) || nth > 0) {
        nth -= offered >> tag & 1u;
        tag++;
    }
    game->point_tick = game->tick;
    if (tag == game_mode_select_tag(game, player)) {
        return;
    }
    game->lab_chosen = mode_tags[tag].mode == CHOICE_LAB;
    game->mode = game->lab_chosen ? game->mode : mode_tags[tag].mode;
    if (tag < MODE_TAG_LEVELS) {
        game->player[player].level = mode_tags[tag].level;
    }
    output_sound(output, SOUND_CHOOSE, 0.8f, 0.0f);
}

/* Returns the tag under the pointer of a moved poi as its number among the offered tags, counted
 * from 1, or 0 if there is no tag. Stores the pointer in `player`. */
static uint32_t tag_under_pointer(struct player *player, struct pointer_state pointer,
                                  uint32_t offered, bool upright)
{
    player->has_pointer = pointer.present;
    player->pointer = pointer.at;
    uint32_t nth = 0;
    for (uint32_t tag = 0; tag < MODE_TAG_COUNT && pointer.present; tag++) {
        if (!(offered >> tag & 1u)) {
            continue;
        }
        nth++;
        if (pointer_is_inside(mode_tag_box(upright, offered, tag), 0.0f, pointer.at)) {
            return player->stance == STANCE_MOVED ? nth : 0u;
        }
    }
    return 0;
}

/* Returns the section of the tank below a pose, counted from 1. A poi outside the tank selects the
 * nearest section. Recordings older than format 9 have sections instead of tags. */
static uint32_t section_below(const struct world *world, vec3 hand_m, uint32_t offered)
{
    const float count = (float)count_bits(offered);
    const float share = hand_m.x / world->tank.size_m.x + 0.5f;
    return (uint32_t)f_clamp(share * count, 0.0f, count - 0.5f) + 1u;
}

/* Selects an item when a poi enters a different item. While the poi stays in one item, the buttons
 * can select. A moving poi also restarts the timeout of the screen. The pois are evaluated from
 * last to first, so that the first player's poi decides about the mode. */
static void point_by_pois(struct game *game, const struct world *world,
                          const struct core_config *config, const struct input *input,
                          struct output *output)
{
    const uint32_t offered = offered_tags(config);
    const bool has_tags = config_has_rules(config, 9);
    for (uint32_t i = POI_MAX; i-- > 0;) {
        struct player *player = &game->player[i];
        if (!world->bowl[i].present || world->poi[i].link != POI_SOURCE_LIVE) {
            player->points = 0;
            player->has_pointer = 0;
            /* A poi that appears during the selection was brought to its place, like a finger that
             * touches a tag. It counts as moved. */
            player->stance = config_has_rules(config, 10) ? (uint8_t)STANCE_MOVED : player->stance;
            continue;
        }
        const vec3 hand_m = game->control[i].validation.newest.position_m;
        const bool stirs = player_stirs(player, hand_m), is_new = player->stance == STANCE_UNSEEN;
        if (has_tags && (stirs || is_new)) {
            player->stance = is_new ? STANCE_RESTS : STANCE_MOVED;
        }
        const uint32_t points =
            has_tags
                ? tag_under_pointer(player, pointer_of_player(world, input, input->upright != 0, i),
                                    offered, input->upright != 0)
                : section_below(world, hand_m, offered);
        if (player->points != points) {
            player->points = (uint8_t)points;
            if (points > 0) {
                point_at_tag(game, config, i, points - 1u, output);
            }
        }
        if (stirs || (has_tags && is_new)) {
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

/* Prepares the players for the selection. Players who play again keep the level of their last
 * round. */
static void reset_pointers(struct player players[POI_MAX], const struct core_config *config,
                           bool plays_again)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &players[i];
        player->points = 0;
        player->level = plays_again ? player->level : config->level;
        player->stance = config_has_rules(config, 9) ? (uint8_t)STANCE_UNSEEN : player->stance;
    }
}

void game_mode_select_begin(struct game *game, struct world *world,
                            const struct core_config *config, struct output *output)
{
    const bool plays_again = game->phase != PHASE_ATTRACT;
    const bool follows_game = plays_again || game->tick - game->phase_tick < SESSION_FADE_TICKS;
    if (follows_game && session_must_end(game, config) &&
        credit_can_play(&game->accounts.ledger, config)) {
        game->accounts.credit.await_tick = game->tick; /* Attract mode then repeats the request. */
        if (plays_again) {
            attract_begin(game, world, config);
        }
        return;
    }
    const bool is_choice = count_bits(table_setup_modes(config)) > 1u;
    if (!is_choice) {
        activate_mode(game, world, config, output);
        return;
    }
    if (!credit_can_play(&game->accounts.ledger, config)) {
        credit_request(&game->accounts, game->tick, output);
        return;
    }
    reset_pointers(game->player, config, plays_again && rules_of(game->mode)->has_levels);
    game_enter_phase(game, PHASE_MODE_SELECT);
    game->point_tick = game->tick;
    game->lab_chosen = (table_setup_modes(config) >> game->mode & 1u) == 0;
    table_setup_empty_bowls(world);
    output_sound(output, SOUND_CHOOSE, 1.0f, 0.0f);
}

void game_mode_select_tick(struct game *game, struct world *world, struct core_config *config,
                           const struct input *input, struct output *output)
{
    const uint32_t offered = offered_tags(config), count = count_bits(offered);
    const uint32_t dipped = controller_dipped_player(game, world, input);
    const uint32_t lead = game_mode_select_lead(world);
    CORE_ASSERT(count > 0);
    game->upright = config_has_rules(config, 9) && input->upright;
    point_by_pois(game, world, config, input, output);
    if (dipped < POI_MAX && game->player[dipped].points > 0) {
        /* A dip selects the item below the poi, even if a button selected a different item after
         * the poi entered the item. */
        point_at_tag(game, config, dipped, game->player[dipped].points - 1u, output);
    }
    const uint32_t here = count_bits(offered & ((1u << game_mode_select_tag(game, lead)) - 1u));
    if (input->pressed & INPUT_LEFT) {
        point_at_tag(game, config, lead, (here + count - 1u) % count, output);
    } else if (input->pressed & INPUT_RIGHT) {
        point_at_tag(game, config, lead, (here + 1u) % count, output);
    }
    const bool is_fresh = game->tick - game->phase_tick < GAME_MODE_SELECT_TICKS_MIN;
    if (!is_fresh && (dipped < POI_MAX || (input->pressed & (INPUT_START | INPUT_OK)))) {
        activate_mode(game, world, config, output);
    } else if (game_seconds_left(game, game->tick) <= 0.0f) {
        attract_begin(game, world, config);
    }
}
