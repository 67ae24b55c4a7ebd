/* game.c -- runs the steps of a game tick in order, and contains the functions common to all
 * phases. */
#include "core/game/game.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/control/controller.h"
#include "core/game/menu/menu_calibrate.h"
#include "core/game/phases.h"
#include "core/game/ranking/leaderboard.h"

#define START_LAMP_TICKS (CORE_TICK_HZ / 2u)

void game_enter_phase(struct game *game, uint8_t phase)
{
    game->phase = phase;
    game->phase_tick = game->tick;
}

uint32_t game_dipped_player(const struct game *game, const struct world *world,
                            const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (world->bowl[i].present && controller_dip_pressed(game, input, i)) {
            return i;
        }
    }
    return POI_MAX;
}

static void tick_phase(struct game *game, struct world *world, struct core_config *config,
                       const struct input *input, struct output *output)
{
    switch (game->phase) {
    case PHASE_ATTRACT:
        attract_tick(game, world, config, input, output);
        break;
    case PHASE_MODE_SELECT:
        mode_select_tick(game, world, config, input, output);
        break;
    case PHASE_READY:
        ready_tick(game, world, config, output);
        break;
    case PHASE_ROUND:
        round_tick(game, world, config, output);
        break;
    case PHASE_LAB:
        lab_tick(game, world, config, input, output);
        break;
    case PHASE_MENU:
        menu_tick(game, world, config, input, output);
        break;
    case PHASE_ALBUM:
        album_tick(game, world, config, input, output);
        break;
    case PHASE_NAME:
        name_tick(game, world, input, output);
        break;
    case PHASE_LEADERBOARD:
        leaderboard_tick(game, world, config, input, output);
        break;
    default:
        result_tick(game, world, config, input, output);
        break;
    }
}

void game_init(struct game *game, const struct core_config *config)
{
    memset(game, 0, sizeof *game);
    game->tick = game->phase_tick = config->session.tick;
    game->phase = PHASE_ATTRACT;
    game->language = config->language;
    game->mode = table_setup_first_mode(config);
    game->round_s = table_setup_round_s(config, game->mode);
    ledger_init(&game->accounts.ledger, &config->persistent.ledger);
    game->accounts.audits = config->persistent.audits;
    game->accounts.ranking = config->persistent.ranking;
    settings_edit_init(&game->settings_edit, config);
    hints_init(&game->hints);
    lab_init(&game->lab, config);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->live_y_m[i] = -1.0f;
        bot_init(&game->bot[i], &technique_expert, config->seed + i);
    }
    session_restore(game, &config->session);
}

/* Returns 1 if the START lamp is lit, because START would begin a game or because the menu lights
 * the lamp; otherwise 0. */
static int start_lamp(const struct game *game, const struct core_config *config)
{
    const uint8_t phase = game->phase;
    if (phase == PHASE_MENU) {
        return menu_lights_start(game);
    }
    return (phase == PHASE_ATTRACT || phase == PHASE_MODE_SELECT) &&
           credit_can_play(&game->accounts.ledger, config) &&
           game->tick % CORE_TICK_HZ < START_LAMP_TICKS;
}

void game_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *said, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX])
{
    const struct input own = controller_calibrate(&config->persistent.settings, said),
                       *input = &own;
    menu_calibrate_tick(game, world, config, said, output);
    language_tick(game, config, input);
    ledger_tick(&game->accounts.ledger, input);
    health_log_tick(game, config, input, output);
    controller_validate(game, input);
    controller_assign(game, world, input);
    credit_tick(game, world, config, input, output);
    const uint8_t phase = game->phase;
    if (!menu_opens(game, world, config, input, output)) {
        tick_phase(game, world, config, input, output);
    } else if (phase == PHASE_NAME) {
        name_keep(&game->accounts, &game->name, game->tick, output);
    }
    self_test_tick(game, said, output);
    settings_edit_tick(game, &config->persistent.settings, output);
    controller_assign(game, world,
                      input); /* A new phase may change the source of a poi in the same tick. */
    controller_tick_all(game, world, config, input, targets, live);
    hints_tick(&game->hints, game, world, config);
    output->start_lamp = (uint8_t)start_lamp(game, config);
    credit_show_outputs(game, config, output);
}

int game_may_scoop(const struct game *game, uint32_t index)
{
    const int in_time = game->phase == PHASE_ROUND && game_seconds_left(game, game->tick) > 0.0f;
    return game->phase == PHASE_ATTRACT || (in_time && !game->paused && !game->player[index].out);
}

int game_pumps(const struct game *game, uint32_t tick)
{
    const uint32_t elapsed = (tick - game->phase_tick) % (GAME_STALE_TICKS + GAME_AIR_TICKS);
    return game->phase == PHASE_ATTRACT ? elapsed >= GAME_STALE_TICKS : game->phase != PHASE_ROUND;
}

/* Returns the timeout of the mode selection in ticks, counted from the start of the phase. */
static uint32_t choice_ticks(const struct game *game)
{
    const uint32_t pointed = game->point_tick - game->phase_tick + GAME_MODE_SELECT_TICKS;
    return pointed < GAME_MODE_SELECT_TICKS_MAX ? pointed : GAME_MODE_SELECT_TICKS_MAX;
}

float game_seconds_left(const struct game *game, uint32_t tick)
{
    uint32_t total = 0;
    switch (game->phase) {
    case PHASE_MODE_SELECT:
        total = choice_ticks(game);
        break;
    case PHASE_READY:
        total = rules_of(game->mode)->ready_s * CORE_TICK_HZ;
        break;
    case PHASE_ROUND:
        total = game->round_s * CORE_TICK_HZ;
        break;
    case PHASE_NAME:
        return name_seconds_left(&game->name, tick);
    default:
        break;
    }
    const uint32_t elapsed = tick - game->phase_tick;
    return elapsed < total ? (float)(total - elapsed) * CORE_TICK_S : 0.0f;
}

static uint64_t hash_target(uint64_t hash, const struct poi_target *target)
{
    hash = hash_vec3(hash, target->position_m);
    hash = hash_float(hash, target->angles.yaw_rad);
    hash = hash_float(hash, target->angles.pitch_rad);
    return hash_float(hash, target->angles.roll_rad);
}

uint64_t game_hash(uint64_t hash, const struct game *game)
{
    const uint32_t words[] = { game->phase,       game->language,     game->mode,
                               game->lab_chosen,  game->bot_played,   game->played,
                               game->paused,      game->call,         game->call_tick,
                               game->phase_tick,  game->round_tick,   game->point_tick,
                               game->lost_ticks,  game->gone_tick,    game->round_s,
                               game->round_count, game->waited_ticks, game->turn_tick,
                               game->paused_ticks };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = player_hash(hash, &game->player[i]);
        hash = hash_u32(hash, game->holder[i]);
        hash = hash_u32(hash, game->grip_tick[i]);
        hash = hash_target(hash, &game->hand_pose[i]);
        hash = hash_float(hash, game->live_y_m[i]);
        hash = input_validation_hash(hash, &game->validation[i]);
        hash = hash_u32(hash, game->return_ticks[i]);
        hash = hash_u32(hash, game->was_lost[i]);
        hash = hash_u32(hash, game->immunity_ticks[i]);
        hash = hash_u32(hash, game->outlier_ticks[i]);
        hash = hash_u32(hash, game->rest_ticks[i]);
        hash = bot_hash(hash, &game->bot[i]);
    }
    hash = ledger_hash(hash, &game->accounts.ledger);
    hash = credit_hash(hash, &game->accounts.credit);
    hash = name_hash(hash, &game->name);
    hash = health_log_hash(hash, &game->health_log);
    hash = menu_hash(hash, &game->menu);
    hash = album_hash(hash, &game->album);
    hash = lab_hash_quick(hash, &game->lab);
    hash = language_hash(hash, &(struct language_choice){ .until_tick = game->language_until });
    return hints_hash(hash, &game->hints);
}
