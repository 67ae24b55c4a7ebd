/* session.c -- starts and ends sessions (the times between two initializations of the core), copies
 * the state that continues from one session to the next, and changes the display language. */
#include "core/game/phases.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"

void session_request(struct game *game)
{
    CORE_ASSERT(game->phase == PHASE_ATTRACT);
    if (game->turn_tick == 0) {
        game->turn_tick = game->tick + SESSION_FADE_TICKS;
    }
}

bool session_must_end(const struct game *game, const struct core_config *config)
{
    CORE_ASSERT(game->tick >= config->session.tick);
    return config_has_rules(config, 10) && game->tick - config->session.tick >= SESSION_TICKS_MAX;
}

/* Returns true if the session ends in this tick. The caller has already incremented
 * `game->tick`. */
bool session_is_over(const struct game *game)
{
    return game->phase == PHASE_ATTRACT && game->turn_tick != 0 && game->tick >= game->turn_tick;
}

void session_restart(const struct game *game, struct core_config *config)
{
    CORE_ASSERT(game->phase == PHASE_ATTRACT);
    CORE_ASSERT(game->accounts.ledger.saved_id <= game->accounts.ledger.last_id);
    config->seed = rng_u32((struct rng_key){ config->seed, game->tick, 0, RNG_SESSION });
    config->session = (struct game_session){
        .tick = game->tick,
        .command_count = game->menu.command_count,
        .edit_save_id = game->lab.save_id,
        .edit_saved_id = game->lab.saved_id,
        .ledger = game->accounts.ledger,
        .credit = game->accounts.credit,
        .health_log = game->health_log,
        .settings_edit = game->settings_edit,
        .language = { .chosen = game->language_until ? game->language : 0u,
                      .until_tick = game->language_until },
    };
    config->persistent.ledger.last_id = game->accounts.ledger.last_id;
    config->persistent.ledger.balance = game->accounts.ledger.balance;
    /* Clear the state of the open round, because no round is open in attract mode. */
    config->persistent.ledger.stand = (struct ledger_stand){ 0 };
    config->persistent.audits = game->accounts.audits;
    config->persistent.ranking = game->accounts.ranking;
    memcpy(config->book.has_edit, game->lab.has_edit, sizeof config->book.has_edit);
    memcpy(config->book.edits, game->lab.edits, sizeof config->book.edits);
}

void session_restore(struct game *game, const struct game_session *session)
{
    if (session->tick == 0) {
        return;
    }
    game->menu.command_count = session->command_count;
    game->lab.save_id = session->edit_save_id;
    game->lab.saved_id = session->edit_saved_id;
    game->accounts.ledger = session->ledger;
    game->accounts.credit = session->credit;
    game->health_log = session->health_log;
    game->settings_edit = session->settings_edit;
    if (session->language.until_tick != 0) {
        game->language = (uint8_t)session->language.chosen;
        game->language_until = session->language.until_tick;
    }
}

float session_fade(const struct game *game, const struct core_config *config)
{
    const uint32_t since = game->tick - config->session.tick;
    const uint32_t ahead = game->turn_tick - game->tick;
    uint32_t dark = since < SESSION_FADE_TICKS ? SESSION_FADE_TICKS - since : 0u;
    if (game->turn_tick != 0 && ahead < SESSION_FADE_TICKS && SESSION_FADE_TICKS - ahead > dark) {
        dark = SESSION_FADE_TICKS - ahead;
    }
    return game->phase == PHASE_ATTRACT ? (float)dark / (float)SESSION_FADE_TICKS : 0.0f;
}

void session_language_reset(struct game *game, const struct core_config *config)
{
    CORE_ASSERT(config->language < LANGUAGE_COUNT);
    if (config_has_rules(config, 8)) {
        game->language = config->language;
        game->language_until = 0;
    }
}

void session_language_tick(struct game *game, const struct core_config *config,
                           const struct input *input)
{
    CORE_ASSERT(game->language < LANGUAGE_COUNT);
    if (game->phase == PHASE_ATTRACT && game->language_until != 0 &&
        game->tick >= game->language_until) {
        session_language_reset(game, config);
    }
    if (input->pressed & INPUT_LANGUAGE) {
        game->language = (uint8_t)((game->language + 1u) % LANGUAGE_COUNT);
        game->language_until = !config_has_rules(config, 8) ? 0u : game->tick + LANGUAGE_TICKS;
    }
}
