/* game_tick.c -- runs the steps of a game tick in order and changes the phase. Computes the time
 * left in a phase and whether a phase permits dips. No other file of the game includes all phases
 * and all steps of a tick. */
#include "core/game/game.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/bot/bot.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu.h"
#include "core/game/phases.h"
#include "core/game/ranking/name.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

#define START_LAMP_TICKS (CORE_TICK_HZ / 2u)

/* ---- Current phase and permitted actions ----------------------------------------------------- */

void game_enter_phase(struct game *game, uint8_t phase)
{
    CORE_ASSERT(phase <= PHASE_LEADERBOARD);
    game->phase = phase;
    game->phase_tick = game->tick;
}

bool game_may_scoop(const struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const bool in_time = game->phase == PHASE_ROUND && game_seconds_left(game, game->tick) > 0.0f;
    return game->phase == PHASE_ATTRACT || (in_time && !game->paused && !game->player[index].out);
}

bool game_pumps(const struct game *game, uint32_t tick)
{
    const uint32_t elapsed = (tick - game->phase_tick) % (GAME_STALE_TICKS + GAME_AIR_TICKS);
    return game->phase == PHASE_ATTRACT ? elapsed >= GAME_STALE_TICKS : game->phase != PHASE_ROUND;
}

static uint32_t min_ticks(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

float game_seconds_left(const struct game *game, uint32_t tick)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    const struct name *name = &game->name;
    uint32_t start = game->phase_tick, total = 0;
    switch (game->phase) {
    case PHASE_MODE_SELECT:
        total = min_ticks(game->point_tick - start + RULES_MODE_SELECT_TICKS,
                          GAME_MODE_SELECT_TICKS_MAX);
        break;
    case PHASE_READY:
        total = rules_of(game->mode)->ready_s * CORE_TICK_HZ;
        break;
    case PHASE_ROUND:
        total = game->round_s * CORE_TICK_HZ;
        break;
    case PHASE_NAME:
        start = name->start_tick;
        total = min_ticks(name->act_tick - start + NAME_IDLE_TICKS, NAME_TICKS_MAX);
        break;
    default:
        break;
    }
    const uint32_t elapsed = tick - start;
    return elapsed < total ? (float)(total - elapsed) * CORE_TICK_S : 0.0f;
}

/* ---- Start and tick of the game -------------------------------------------------------------- */

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
    memcpy(game->lab.has_edit, config->book.has_edit, sizeof game->lab.has_edit);
    memcpy(game->lab.edits, config->book.edits, sizeof game->lab.edits);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        game->control[i].live_y_m = -1.0f;
        bot_init(&game->bot[i], &technique_expert, config->seed + i);
    }
    session_restore(game, &config->session);
}

static void tick_phase(struct game *game, struct world *world, struct core_config *config,
                       const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD && game->phase != PHASE_WORDLESS);
    static game_phase_tick *const ticks[] = {
        [PHASE_ATTRACT] = attract_tick,     [PHASE_MODE_SELECT] = game_mode_select_tick,
        [PHASE_READY] = round_ready_tick,   [PHASE_ROUND] = round_tick,
        [PHASE_RESULT] = round_result_tick, [PHASE_LAB] = lab_tick,
        [PHASE_MENU] = menu_tick,           [PHASE_ALBUM] = album_tick,
        [PHASE_NAME] = name_tick,           [PHASE_LEADERBOARD] = leaderboard_tick,
    };
    ticks[game->phase](game, world, config, input, output);
}

/* Sets the cabinet's outputs: the START lamp, the coin lockout, and the counts for the coin meter
 * and the ticket dispenser. The lamp is lit if START would begin a game. In the menu the lamp is
 * lit while self_test_shows() returns true, and while START is held during the test of the input
 * lines. In the menu the coin slot is closed, except on the page that tests the input lines.
 * Otherwise a visitor might pay although no game can be bought. */
static void show_outputs(const struct game *game, const struct core_config *config,
                         struct output *output)
{
    const struct ledger *ledger = &game->accounts.ledger;
    const struct credit *credit = &game->accounts.credit;
    const uint32_t credits_max = (uint32_t)config->persistent.settings.value[SET_CREDIT_MAX];
    bool lamp = false, lockout = false;
    if (game->phase == PHASE_MENU) {
        const bool tests_lines = menu_tries_lines(game), shows = self_test_shows(game);
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
               const struct input *raw, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX])
{
    CORE_ASSERT(game->mode < MODE_COUNT && game->language < LANGUAGE_COUNT);
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD);
    const struct menu_scope scope = menu_scope_of(game, config, output);
    struct input own = *raw;
    const struct input *input = &own;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        input_calibration_apply(&config->persistent.settings, i, &own.poi[i]);
        input_validation_tick(&game->control[i].validation, &own.poi[i]);
    }
    menu_calibrate_tick(&scope, world, raw);
    session_language_tick(game, config, input);
    ledger_tick(&game->accounts.ledger, config, input);
    health_log_tick(&game->accounts, &game->health_log, game, config, input, output);
    /* Select the source of each poi (controller or bot) again, because a new phase may use a
     * different source. */
    controller_assign(game, world, input);
    coins_tick(&game->accounts, game, world, config, input, output);
    const uint8_t phase = game->phase;
    if (!menu_opens(game, world, config, input, output)) {
        tick_phase(game, world, config, input, output);
    } else if (phase == PHASE_NAME) {
        name_keep(&game->accounts, &game->name, game->tick, output);
    }
    table_setup_moor_bowl(game, world, config);
    self_test_tick(&scope, raw);
    settings_edit_tick(&scope);
    controller_assign(game, world, input);
    controller_tick_all(game->control, game->bot, game, world, config, input, targets, live);
    hints_tick(&game->hints, game, world, config);
    show_outputs(game, config, output);
}
