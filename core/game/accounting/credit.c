/* credit.c -- takes and refunds the credits of rounds, and counts the tickets that rounds win. */
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/game/table_setup.h"

/* Number of seconds that is reported if an event never occurred: about eleven days. */
#define NEVER_S 1e6f

static uint32_t committed_credits(const struct ledger *ledger)
{
    const struct ledger_credits sure = ledger_committed_credits(ledger);
    return sure.paid + sure.service;
}

/* Returns the number of credits that are not on disk yet. */
static uint32_t coming_credits(const struct ledger *ledger)
{
    return ledger->balance.paid + ledger->balance.service - committed_credits(ledger);
}

/* ---- Taking and refunding the credit of a round ---------------------------------------------- */

/* Returns the kind of credit to use next (enum round_payment). PAYMENT_NONE means that no credit
 * can be used. A refunded credit is used first, because it cannot be refunded a second time.
 * Service credits are used next, so that an operator's test leaves paid credits unused. */
static uint8_t next_credit(const struct ledger *ledger)
{
    const struct ledger_credits sure = ledger_committed_credits(ledger);
    const struct balance *balance = &ledger->balance;
    if (balance->returned == PAYMENT_PAID && balance->paid > 0) {
        return sure.paid > 0 ? PAYMENT_PAID : PAYMENT_NONE;
    }
    if (balance->returned == PAYMENT_SERVICE && balance->service > 0) {
        return sure.service > 0 ? PAYMENT_SERVICE : PAYMENT_NONE;
    }
    return sure.service > 0 ? PAYMENT_SERVICE : sure.paid > 0 ? PAYMENT_PAID : PAYMENT_NONE;
}

/* Returns true if a round may start: play is free, or a credit is on disk and the ledger has room.
 * Without room the end of the round could not be logged either. */
bool credit_can_play(const struct ledger *ledger, const struct core_config *config)
{
    return config->credit_coins == 0 ||
           (next_credit(ledger) != PAYMENT_NONE && ledger_has_room(ledger, LEDGER_COINS));
}

void credit_request(struct accounts *accounts, uint32_t tick, struct output *output)
{
    struct credit *credit = &accounts->credit;
    if (coming_credits(&accounts->ledger) > 0) {
        credit->await_tick = tick;
        return;
    }
    credit->request_tick = tick;
    output_sound(output, SOUND_FOUL, 0.4f, 0.0f);
}

bool credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                       uint32_t tick)
{
    const uint32_t await_tick = accounts->credit.await_tick;
    return await_tick != 0 && tick - await_tick < CREDIT_AWAIT_TICKS &&
           credit_can_play(&accounts->ledger, config);
}

void credit_take(struct accounts *accounts, const struct game *game,
                 const struct core_config *config, uint8_t what, struct output *output)
{
    struct credit *credit = &accounts->credit;
    struct balance *balance = &accounts->ledger.balance;
    CORE_ASSERT(credit_can_play(&accounts->ledger, config));
    CORE_ASSERT(what < CHOICE_COUNT);
    /* No game is open, because coins_tick() closes the previous game. */
    CORE_ASSERT(balance->open == PAYMENT_NONE);
    const struct ledger_entry entry = {
        .kind = LEDGER_BEGIN,
        .detail = what,
        .count = what < MODE_COUNT ? table_setup_grade(config, what) : 0u,
    };
    credit->came_back = 0;
    credit->await_tick = 0;
    credit->act_tick = game->tick;
    credit->stand_id = 0;
    credit->stand = (struct ledger_stand){ 0 };
    balance->open = PAYMENT_FREE;
    if (config->credit_coins > 0) {
        const uint8_t kind = next_credit(&accounts->ledger);
        CORE_ASSERT(kind == PAYMENT_PAID || kind == PAYMENT_SERVICE);
        balance->open = kind | (balance->returned != PAYMENT_NONE ? PAYMENT_SPENT : 0u);
        balance->bonus_units = 0;
        balance->service -= kind == PAYMENT_SERVICE;
        balance->paid -= kind == PAYMENT_PAID;
        balance->returned = PAYMENT_NONE;
    }
    ledger_write(accounts, game->tick, &entry, output);
}

/* Ends the open round in the balance and refunds its credit if the credit is refundable. The
 * balance may then exceed SET_CREDIT_MAX by one, because the credit belongs to a player. If a
 * restart interrupted a round that no player had joined, the function closes the round even if the
 * credit is not refundable. The LEDGER_REFUND of such a round has `count` 0. */
void credit_refund(struct accounts *accounts, const struct game *game,
                   const struct core_config *config, enum refund_cause cause, struct output *output)
{
    CORE_ASSERT(cause < REFUND_CAUSE_COUNT);
    struct balance *balance = &accounts->ledger.balance;
    const uint8_t open = balance->open, kind = open & PAYMENT_KIND_MASK;
    const bool is_spent = round_standing_is_spent(game, config);
    const bool is_credit = kind == PAYMENT_PAID || kind == PAYMENT_SERVICE;
    const uint32_t count = is_credit && !is_spent;
    accounts->credit.came_back = (uint8_t)count;
    if (kind == PAYMENT_NONE || (kind == PAYMENT_FREE && cause == REFUND_NO_POI) ||
        (is_spent && cause != REFUND_RESTART)) {
        return;
    }
    const struct ledger_entry entry = {
        .kind = LEDGER_REFUND, .detail = (uint8_t)cause, .count = count, .value = open
    };
    balance->paid += kind == PAYMENT_PAID ? count : 0u;
    balance->service += kind == PAYMENT_SERVICE ? count : 0u;
    balance->returned = count > 0 && config_has_rules(config, 8) ? kind : balance->returned;
    balance->open = PAYMENT_NONE;
    ledger_write(accounts, game->tick, &entry, output);
}

uint32_t credit_tickets_won(const struct game *game, const struct core_config *config)
{
    CORE_ASSERT(config->ticket_fish <= CREDIT_TICKET_FISH_MAX);
    const uint32_t price = config->ticket_fish;
    uint32_t won = 0;
    if (price == 0 || game->bot_played || !rules_of(game->mode)->keeps_score) {
        return 0;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        won += game->player[i].plays ? game->player[i].caught / price : 0u;
    }
    return won;
}

uint32_t credit_add_tickets(struct accounts *accounts, const struct core_config *config,
                            uint32_t count)
{
    CORE_ASSERT(accounts->ledger.balance.tickets <= BALANCE_TICKETS_MAX);
    struct balance *balance = &accounts->ledger.balance;
    if (!config_has_rules(config, 8)) {
        accounts->credit.tickets += count;
        return count;
    }
    const uint32_t room = BALANCE_TICKETS_MAX - balance->tickets;
    const uint32_t owed = count < room ? count : room;
    balance->tickets = (uint16_t)(balance->tickets + owed);
    return owed;
}

uint32_t credit_award_tickets(struct accounts *accounts, const struct game *game,
                              const struct core_config *config)
{
    CORE_ASSERT(game->phase == PHASE_RESULT || game->phase == PHASE_ROUND);
    return credit_add_tickets(accounts, config, credit_tickets_won(game, config));
}

/* ---- Displayed state of the credits --------------------------------------------------------- */

static float seconds_since_event(uint32_t tick, uint32_t event_tick)
{
    return event_tick != 0 ? (float)(tick - event_tick) * CORE_TICK_S : NEVER_S;
}

void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out)
{
    const struct credit *credit = &accounts->credit;
    const struct balance *balance = &accounts->ledger.balance;
    const uint8_t price = config->credit_coins;
    const bool is_event = config->persistent.settings.value[SET_PLAY] == PLAY_EVENT;
    *out = (struct scene_credit){
        .price = price,
        .is_event = (uint8_t)(price == 0 && is_event),
        .unpaid = (uint8_t)(!credit_can_play(&accounts->ledger, config) &&
                            coming_credits(&accounts->ledger) == 0),
        .warnings = credit->warnings,
        .came_back = credit->came_back,
        .coin_units = (uint8_t)config->persistent.settings.value[SET_COIN_1],
        .units = balance->units,
        .credits = committed_credits(&accounts->ledger),
        .coming = coming_credits(&accounts->ledger),
        .coin_s = seconds_since_event(tick, credit->coin_tick),
        .request_s = seconds_since_event(tick, credit->request_tick),
    };
}
