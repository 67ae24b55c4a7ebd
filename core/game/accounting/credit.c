/* credit.c -- takes and refunds the credits of rounds, dispenses tickets, and computes the
 * warnings that close the coin slot. */
#include "core/game/accounting/credit.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/accounting/ledger_writer.h"
#include "core/game/game.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

#define NEVER_S 1e6f /* Time in seconds that stands for never, about eleven days. */

static uint32_t sure_credits(const struct ledger *ledger)
{
    const struct ledger_credits sure = ledger_committed_credits(ledger);
    return sure.paid + sure.service;
}

uint32_t credit_coming(const struct ledger *ledger)
{
    return ledger->balance.paid + ledger->balance.service - sure_credits(ledger);
}

/* ---- The tick ------------------------------------------------------------------------------- */

/* Returns the current warnings (bit mask of enum credit_warning). A person could play if a slot has
 * a connected controller or the bot. */
static uint8_t current_warnings(const struct game *game, const struct world *world,
                                const struct core_config *config, const struct input *input)
{
    const struct credit *credit = &game->accounts.credit;
    uint32_t warnings = WARN_NO_POI;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t link = input->poi[i].link;
        if (world->bowl[i].present && (link == POI_SOURCE_LIVE || link == POI_SOURCE_BOT)) {
            warnings = 0;
        }
    }
    if (credit->tilt_tick != 0 && game->tick - credit->tilt_tick < CREDIT_TILT_TICKS) {
        warnings |= WARN_TILT;
    }
    if ((input->held | input->pressed) & INPUT_DOOR) {
        warnings |= WARN_DOOR;
    }
    if (config->credit_coins > 0 && !ledger_is_safe(&game->accounts.ledger)) {
        warnings |= WARN_STORE;
    }
    return (uint8_t)warnings;
}

/* Closes a round or lab visit that ended without a result. A visit to the growth lab has no result,
 * and neither has a round that no player joined. */
static void close_what_is_over(struct game *game, struct output *output)
{
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD);
    const int runs =
        game->phase == PHASE_READY || game->phase == PHASE_ROUND || game->phase == PHASE_LAB;
    if (game->accounts.ledger.balance.open != PAYMENT_NONE && !runs) {
        const struct ledger_entry entry = { .kind = LEDGER_LEFT };
        game->accounts.ledger.balance.open = PAYMENT_NONE;
        ledger_write(&game->accounts, game->tick, &entry, output);
    }
}

/* Logs the next ticket, or starts the pulse of the ticket dispenser, if the previous step is
 * complete. */
static void tick_tickets(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         const struct input *input, struct output *output)
{
    CORE_ASSERT(accounts->ledger.balance.tickets <= BALANCE_TICKETS_MAX);
    struct ledger *ledger = &accounts->ledger;
    struct credit *credit = &accounts->credit;
    const struct ledger_entry entry = { .kind = LEDGER_TICKET, .count = 1 };
    const int is_owed_on_disk = ledger->committed.tickets > 0 && ledger->balance.tickets > 0;
    if (credit->ticket_id != 0) {
        if (ledger_is_saved(ledger, credit->ticket_id)) {
            credit->tickets++;
            credit->ticket_id = 0;
        }
    } else if (!config->rules_7 && is_owed_on_disk && input->tickets_done == credit->tickets &&
               ledger_may_write(ledger, LEDGER_TICKET)) {
        ledger->balance.tickets--;
        credit->ticket_id = ledger_write(accounts, tick, &entry, output);
    }
}

/* Handles TILT and SERVICE outside the operator's menu. */
static void take_buttons(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         const struct input *input, struct output *output)
{
    CORE_ASSERT(config->credit_coins <= CREDIT_COINS_MAX);
    struct credit *credit = &accounts->credit;
    if ((input->held | input->pressed) & INPUT_TILT) {
        if (!(credit->warnings & WARN_TILT)) {
            credit->shakes++;
            output_sound(output, SOUND_FOUL, 0.8f, 0.0f);
        }
        credit->tilt_tick = tick;
    }
    if ((input->pressed & INPUT_SERVICE) && config->credit_coins > 0 &&
        accounts->ledger.balance.paid + accounts->ledger.balance.service <
            (uint32_t)config->persistent.settings.value[SET_CREDIT_MAX] &&
        ledger_may_write(&accounts->ledger, LEDGER_SERVICE)) {
        const struct ledger_entry entry = { .kind = LEDGER_SERVICE };
        accounts->ledger.balance.service++;
        credit->act_tick = tick;
        ledger_write(accounts, tick, &entry, output);
        output_sound(output, SOUND_COIN, 0.5f, 0.0f);
    }
}

void credit_tick(struct game *game, const struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output)
{
    struct accounts *accounts = &game->accounts;
    CORE_ASSERT(accounts->ledger.saved_id <= accounts->ledger.last_id);
    close_what_is_over(game, output);
    if (game->phase == PHASE_MENU) {
        coins_test(accounts, game->tick, input, output);
    } else {
        coins_insert(accounts, config, game->tick, input, output);
        take_buttons(accounts, config, game->tick, input, output);
    }
    coins_convert(accounts, config, game->tick, output);
    coins_expire(game, &config->persistent.settings, output);
    tick_tickets(accounts, config, game->tick, input, output);
    accounts->credit.warnings = current_warnings(game, world, config, input);
}

/* ---- Rounds --------------------------------------------------------------------------------- */

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

/* If the ledger has no room, a round cannot be bought, because the end of the round could not be
 * logged either. */
int credit_can_play(const struct ledger *ledger, const struct core_config *config)
{
    return config->credit_coins == 0 ||
           (next_credit(ledger) != PAYMENT_NONE && ledger_has_room(ledger, LEDGER_COINS));
}

void credit_ask(struct accounts *accounts, uint32_t tick, struct output *output)
{
    struct credit *credit = &accounts->credit;
    if (credit_coming(&accounts->ledger) > 0) {
        credit->await_tick = tick;
        return;
    }
    credit->asked_tick = tick;
    output_sound(output, SOUND_FOUL, 0.4f, 0.0f);
}

int credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                      uint32_t tick)
{
    const uint32_t await_tick = accounts->credit.await_tick;
    return await_tick != 0 && tick - await_tick < CREDIT_AWAIT_TICKS &&
           credit_can_play(&accounts->ledger, config);
}

void credit_take(struct game *game, const struct core_config *config, uint8_t what,
                 struct output *output)
{
    struct credit *credit = &game->accounts.credit;
    struct balance *balance = &game->accounts.ledger.balance;
    CORE_ASSERT(credit_can_play(&game->accounts.ledger, config));
    CORE_ASSERT(what < CHOICE_COUNT);
    close_what_is_over(game, output);
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
        const uint8_t kind = next_credit(&game->accounts.ledger);
        CORE_ASSERT(kind == PAYMENT_PAID || kind == PAYMENT_SERVICE);
        balance->open = kind | (balance->returned != PAYMENT_NONE ? PAYMENT_SPENT : 0u);
        balance->bonus_units = 0;
        balance->service -= kind == PAYMENT_SERVICE;
        balance->paid -= kind == PAYMENT_PAID;
        balance->returned = PAYMENT_NONE;
    }
    ledger_write(&game->accounts, game->tick, &entry, output);
}

/* A refund may exceed SET_CREDIT_MAX by one, because the credit belongs to a player. After a
 * restart, an open round may have a non-refundable credit if no player had joined. The
 * LEDGER_REFUND of that round has `count` 0. */
void credit_refund(struct game *game, const struct core_config *config, enum refund_cause cause,
                   struct output *output)
{
    CORE_ASSERT(cause < REFUND_CAUSE_COUNT);
    struct balance *balance = &game->accounts.ledger.balance;
    const uint8_t open = balance->open, kind = open & PAYMENT_KIND_MASK;
    const int is_spent = round_standing_is_spent(game, config);
    const int is_credit = kind == PAYMENT_PAID || kind == PAYMENT_SERVICE;
    const uint32_t count = is_credit && !is_spent;
    game->accounts.credit.came_back = (uint8_t)count;
    if (kind == PAYMENT_NONE || (kind == PAYMENT_FREE && cause == REFUND_NO_POI) ||
        (is_spent && cause != REFUND_RESTART)) {
        return;
    }
    const struct ledger_entry entry = {
        .kind = LEDGER_REFUND, .detail = (uint8_t)cause, .count = count, .value = open
    };
    balance->paid += kind == PAYMENT_PAID ? count : 0u;
    balance->service += kind == PAYMENT_SERVICE ? count : 0u;
    balance->returned = count > 0 && !config->rules_7 ? kind : balance->returned;
    balance->open = PAYMENT_NONE;
    ledger_write(&game->accounts, game->tick, &entry, output);
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

uint32_t credit_award_tickets(struct game *game, const struct core_config *config)
{
    CORE_ASSERT(game->phase == PHASE_RESULT || game->phase == PHASE_ROUND);
    const uint32_t won = credit_tickets_won(game, config);
    credit_owe_tickets(&game->accounts, config, won);
    return won;
}

/* ---- Display -------------------------------------------------------------------------------- */

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
    const int is_event = config->persistent.settings.value[SET_PLAY] == PLAY_EVENT;
    *out = (struct scene_credit){
        .price = price,
        .is_event = (uint8_t)(price == 0 && is_event),
        .unpaid = (uint8_t)(!credit_can_play(&accounts->ledger, config) &&
                            credit_coming(&accounts->ledger) == 0),
        .warnings = credit->warnings,
        .came_back = credit->came_back,
        .coin_units = (uint8_t)config->persistent.settings.value[SET_COIN_1],
        .units = balance->units,
        .credits = sure_credits(&accounts->ledger),
        .coming = credit_coming(&accounts->ledger),
        .coin_s = seconds_since_event(tick, credit->coin_tick),
        .asked_s = seconds_since_event(tick, credit->asked_tick),
    };
}

uint64_t credit_hash(uint64_t hash, const struct credit *credit)
{
    const uint32_t words[] = { credit->came_back, credit->warnings,   credit->metered,
                               credit->shakes,    credit->tickets,    credit->coin_tick,
                               credit->tilt_tick, credit->asked_tick, credit->await_tick,
                               credit->act_tick };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const struct pending_coins *untold = &credit->pending_coins[line];
        hash = hash_u32(hash_u32(hash_u32(hash, untold->pulses), untold->units), untold->owed);
    }
    hash = hash_later(hash_later(hash, 1, credit->stand_id), 2, credit->ticket_id);
    return round_standing_hash(hash, &credit->stand);
}

void credit_owe_tickets(struct accounts *accounts, const struct core_config *config, uint32_t count)
{
    CORE_ASSERT(accounts->ledger.balance.tickets <= BALANCE_TICKETS_MAX);
    struct balance *balance = &accounts->ledger.balance;
    if (config->rules_7) {
        accounts->credit.tickets += count;
        return;
    }
    const uint32_t room = BALANCE_TICKETS_MAX - balance->tickets;
    balance->tickets = (uint16_t)(balance->tickets + (count < room ? count : room));
}
