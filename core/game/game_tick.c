/* game_tick.c -- runs the steps of a game tick in order. No other file of the game includes the
 * phases and the steps of a tick all together. */
#include "core/game/game.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "core/game/bot/bot.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu.h"
#include "core/game/phases.h"
#include "core/game/ranking/name.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

#define START_LAMP_TICKS (CORE_TICK_HZ / 2u)

void game_init(struct game *game, const struct core_config *config)
{
    CORE_ASSERT(config->language < LANGUAGE_COUNT && config->preset < TANK_PRESET_COUNT);
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
    game->hints = (struct hints){ 0 };
    lab_init(&game->lab, config);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->live_y_m[i] = -1.0f;
        bot_init(&game->bot[i], &technique_expert, config->seed + i);
    }
    session_restore(game, &config->session);
}

static void tick_phase(struct game *game, struct world *world, struct core_config *config,
                       const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD && game->phase != PHASE_WORDLESS);
    switch (game->phase) {
    case PHASE_ATTRACT:
        attract_tick(game, world, config, input, output);
        break;
    case PHASE_MODE_SELECT:
        game_mode_select_tick(game, world, config, input, output);
        break;
    case PHASE_READY:
        round_ready_tick(game, world, config, output);
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
        round_result_tick(game, world, config, input, output);
        break;
    }
}

/* Writes the START lamp, the coin lockout, and the counts for the coin meter and the ticket
 * dispenser to `output`. START is lit if START would begin a game. In the menu the lamp is lit
 * while self_test_shows() returns 1, and while START is held during the test of the input lines.
 * The coin slot is open in the menu only on the page that tests the input lines, because a visitor
 * cannot see that no game can be bought. */
static void show_outputs(const struct game *game, const struct core_config *config,
                         struct output *output)
{
    const struct ledger *ledger = &game->accounts.ledger;
    const struct credit *credit = &game->accounts.credit;
    const uint32_t credits_max = (uint32_t)config->persistent.settings.value[SET_CREDIT_MAX];
    int lamp = 0, lockout = 0;
    if (game->phase == PHASE_MENU) {
        const int tests_lines = menu_tries_lines(game), shows = self_test_shows(game);
        lamp = shows || (tests_lines && (game->menu.held & INPUT_START) != 0);
        lockout = !tests_lines || shows;
    } else {
        lamp = (game->phase == PHASE_ATTRACT || game->phase == PHASE_MODE_SELECT) &&
               credit_can_play(ledger, config) && game->tick % CORE_TICK_HZ < START_LAMP_TICKS;
        lockout = config->credit_coins == 0 || credit->warnings != 0 ||
                  ledger->balance.paid + ledger->balance.service >= credits_max;
    }
    output->start_lamp = (uint8_t)lamp;
    output->coin_lockout = (uint8_t)lockout;
    output->coins_counted = credit->metered;
    output->tickets = credit->tickets;
}

void game_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *said, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX])
{
    CORE_ASSERT(game->mode < MODE_COUNT && game->language < LANGUAGE_COUNT);
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD);
    const struct input own = controller_calibrate(&config->persistent.settings, said),
                       *input = &own;
    menu_calibrate_tick(game, world, config, said, output);
    session_language_tick(game, config, input);
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
                      input); /* The source of a poi may change when a new phase begins, so the pois
                                 are assigned after the phase. */
    controller_tick_all(game, world, config, input, targets, live);
    hints_tick(&game->hints, game, world, config);
    show_outputs(game, config, output);
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
        hash = input_pose_hash(hash, &game->hand_pose[i]);
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
    hash = session_language_hash(hash,
                                 &(struct language_choice){ .until_tick = game->language_until });
    return hints_hash(hash, &game->hints);
}
