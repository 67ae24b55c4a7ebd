/* mode_select.c -- the selection screen for the mode or the growth lab. LEFT, RIGHT or the position
 * of a poi selects. The tank's width is divided into one section per item, in their order. START,
 * OK or a dip confirms the selection. */
#include "core/core.h"
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

/* Returns the `nth` item on offer, from 0. */
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

static uint8_t pointed_at(const struct core *core)
{
    return core->game.lab_chosen ? CHOICE_LAB : core->game.mode;
}

static void point_at_mode(struct core *core, uint32_t nth, struct output *output)
{
    const uint8_t mode = nth_mode(table_setup_modes(&core->config), nth);
    struct game *game = &core->game;
    game->point_tick = core->game.tick;
    if (mode != pointed_at(core)) {
        game->lab_chosen = mode == CHOICE_LAB;
        game->mode = game->lab_chosen ? game->mode : mode;
        output_sound(output, SOUND_CHOOSE, 0.8f, 0.0f);
    }
}

/* Returns the section of the tank under the poi, from 0. A poi beyond a wall counts for the
 * outermost section. */
static uint32_t share_under(const struct core *core, vec3 hand_m, uint32_t count)
{
    const float share = hand_m.x / core->world.tank.size_m.x + 0.5f;
    return (uint32_t)f_clamp(share * (float)count, 0.0f, (float)count - 0.5f);
}

/* Selects by position when the poi enters another section, so that the buttons keep control while
 * the poi stays in one section. A moving poi also restarts the timeout of the screen. */
static void point_at_mode_by_hand(struct core *core, uint32_t index, struct output *output)
{
    struct player *player = &core->game.player[index];
    const vec3 hand_m = core->game.validation[index].newest.position_m;
    const uint32_t share = share_under(core, hand_m, mode_count(table_setup_modes(&core->config)));
    if (player->points != share + 1u) {
        player->points = (uint8_t)(share + 1u);
        point_at_mode(core, share, output);
    }
    if (player_stirs(player, hand_m)) {
        player_rests(player, hand_m);
        core->game.point_tick = core->game.tick;
    }
}

/* Evaluates the pois from last to first, so that the first player's poi decides. */
static void point_by_hands(struct core *core, struct output *output)
{
    for (uint32_t i = POI_MAX; i-- > 0;) {
        if (core->world.bowl[i].present && core->world.poi[i].link == POI_SOURCE_LIVE) {
            point_at_mode_by_hand(core, i, output);
        } else {
            core->game.player[i].points = 0;
        }
    }
}

static void point_by_buttons(struct core *core, const struct input *input, struct output *output)
{
    const uint8_t modes = table_setup_modes(&core->config);
    const uint32_t count = mode_count(modes);
    const uint32_t here = mode_place(modes, pointed_at(core));
    if (input->pressed & INPUT_LEFT) {
        point_at_mode(core, (here + count - 1u) % count, output);
    } else if (input->pressed & INPUT_RIGHT) {
        point_at_mode(core, (here + 1u) % count, output);
    }
}

/* Confirms the selection, or the only item on offer. If no credit can be used because the store
 * stopped in the meantime, the selection stays and the player may try again. */
static void activate_mode(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    if (!credit_can_play(core)) {
        credit_ask(core, output);
        return;
    }
    const int is_lab = game->lab_chosen || table_setup_modes(&core->config) == 1u << CHOICE_LAB;
    game->lab_chosen = 0;
    credit_take(core, is_lab ? CHOICE_LAB : game->mode, output);
    if (is_lab) {
        lab_begin(core, output);
    } else {
        ready_begin(core, output);
    }
}

void mode_select_begin(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    if (mode_count(table_setup_modes(&core->config)) == 1u) {
        activate_mode(core, output);
        return;
    }
    if (!credit_can_play(core)) {
        credit_ask(core, output);
        return;
    }
    game_enter_phase(core, PHASE_MODE_SELECT);
    game->point_tick = core->game.tick;
    game->lab_chosen = (table_setup_modes(&core->config) >> game->mode & 1u) == 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->player[i].points = 0;
    }
    table_setup_empty_bowls(core);
    output_sound(output, SOUND_CHOOSE, 1.0f, 0.0f);
}

void mode_select_tick(struct core *core, const struct input *input, struct output *output)
{
    const uint32_t dipped = game_dipped_player(core, input);
    point_by_hands(core, output);
    if (dipped < POI_MAX) { /* A dip selects the section below it, even if a button selected another
                               item since. */
        point_at_mode(core, core->game.player[dipped].points - 1u, output);
    }
    point_by_buttons(core, input, output);
    const int is_fresh = core->game.tick - core->game.phase_tick < GAME_MODE_SELECT_TICKS_MIN;
    if (!is_fresh && (dipped < POI_MAX || (input->pressed & (INPUT_START | INPUT_OK)))) {
        activate_mode(core, output);
    } else if (game_seconds_left(&core->game, core->game.tick) <= 0.0f) {
        attract_begin(core);
    }
}
