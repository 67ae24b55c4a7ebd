/* credit.c -- takes and refunds the credits of rounds, and decides when the coin slot is closed. */
#include "core/game/accounting/credit.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/accounting/coins.h"
#include "core/game/accounting/round_standing.h"
#include "core/game/accounting/tickets.h"

#define NEVER_S 1e6f /* Time in seconds that stands for never, about eleven days. */

uint32_t credit_price(const struct core_config *config)
{
    return config->credit_coins;
}

static uint32_t credits_max(const struct settings *settings)
{
    return (uint32_t)settings->value[SET_CREDIT_MAX];
}

static uint32_t credits_of(const struct balance *balance)
{
    return balance->paid + balance->service;
}

static uint32_t sure_credits(const struct ledger *ledger)
{
    const struct ledger_credits sure = ledger_committed_credits(ledger);
    return sure.paid + sure.service;
}

uint32_t credit_coming(const struct ledger *ledger)
{
    return credits_of(&ledger->balance) - sure_credits(ledger);
}

/* ---- The tick ------------------------------------------------------------------------------- */

static void take_service(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         struct output *output)
{
    const struct ledger_entry entry = { .kind = LEDGER_SERVICE };
    if (credit_price(config) > 0 &&
        credits_of(&accounts->ledger.balance) < credits_max(&config->persistent.settings) &&
        ledger_may_write(&accounts->ledger, LEDGER_SERVICE)) {
        accounts->ledger.balance.service++;
        accounts->credit.act_tick = tick;
        ledger_write(accounts, tick, &entry, output);
        output_sound(output, SOUND_COIN, 0.5f, 0.0f);
    }
}

/* Returns 1 if a person could play, because a slot has a connected controller or the bot; otherwise
 * 0. */
static int has_poi(const struct world *world, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t link = input->poi[i].link;
        if (world->bowl[i].present && (link == POI_SOURCE_LIVE || link == POI_SOURCE_BOT)) {
            return 1;
        }
    }
    return 0;
}

static void note_tilt(struct credit *credit, uint32_t tick, const struct input *input,
                      struct output *output)
{
    if (!((input->held | input->pressed) & INPUT_TILT)) {
        return;
    }
    if (!(credit->warnings & WARN_TILT)) {
        credit->shakes++;
        output_sound(output, SOUND_FOUL, 0.8f, 0.0f);
    }
    credit->tilt_tick = tick;
}

static uint8_t warnings(const struct game *game, const struct world *world,
                        const struct core_config *config, const struct input *input)
{
    const struct credit *credit = &game->accounts.credit;
    const int is_tilted =
        credit->tilt_tick != 0 && game->tick - credit->tilt_tick < CREDIT_TILT_TICKS;
    const int is_open = ((input->held | input->pressed) & INPUT_DOOR) != 0;
    const int is_unsafe = credit_price(config) > 0 && !ledger_is_safe(&game->accounts.ledger);
    return (uint8_t)((is_tilted ? (uint32_t)WARN_TILT : 0u) | (is_open ? (uint32_t)WARN_DOOR : 0u) |
                     (is_unsafe ? (uint32_t)WARN_STORE : 0u) |
                     (has_poi(world, input) ? 0u : (uint32_t)WARN_NO_POI));
}

/* Closes a round or lab visit that ended without a result. A visit to the growth lab has no result,
 * and neither has a round that no player joined. */
static void close_what_is_over(struct game *game, struct output *output)
{
    const int runs =
        game->phase == PHASE_READY || game->phase == PHASE_ROUND || game->phase == PHASE_LAB;
    if (game->accounts.ledger.balance.open != PAYMENT_NONE && !runs) {
        const struct ledger_entry entry = { .kind = LEDGER_LEFT };
        game->accounts.ledger.balance.open = PAYMENT_NONE;
        ledger_write(&game->accounts, game->tick, &entry, output);
    }
}

void credit_tick(struct game *game, const struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output)
{
    struct credit *credit = &game->accounts.credit;
    close_what_is_over(game, output);
    if (game->phase == PHASE_MENU) {
        coins_test(&game->accounts, game->tick, input, output);
    } else {
        coins_insert(&game->accounts, config, game->tick, input, output);
        note_tilt(&game->accounts.credit, game->tick, input, output);
        if (input->pressed & INPUT_SERVICE) {
            take_service(&game->accounts, config, game->tick, output);
        }
    }
    coins_convert(&game->accounts, config, game->tick, output);
    coins_expire(game, &config->persistent.settings, output);
    tickets_tick(&game->accounts, config, game->tick, input, output);
    credit->warnings = warnings(game, world, config, input);
}

/* Returns 1 if the coin slot must return coins, otherwise 0. In the menu the slot is open only on
 * the page that tests the input lines, because a visitor cannot see that no game can be bought. */
static int sends_coins_back(const struct game *game, const struct core_config *config)
{
    if (game->phase == PHASE_MENU) {
        return !menu_tries_lines(game) || self_test_shows(game);
    }
    return credit_price(config) == 0 || game->accounts.credit.warnings != 0 ||
           credits_of(&game->accounts.ledger.balance) >= credits_max(&config->persistent.settings);
}

void credit_show_outputs(const struct game *game, const struct core_config *config,
                         struct output *output)
{
    output->coin_lockout = (uint8_t)sends_coins_back(game, config);
    output->coins_counted = game->accounts.credit.metered;
    output->tickets = game->accounts.credit.tickets;
}

/* ---- Rounds --------------------------------------------------------------------------------- */

/* Returns the kind of credit to use next (enum round_payment); PAYMENT_NONE means that no credit
 * can be used. A refunded credit comes first, because it cannot be refunded a second time. Service
 * credits come next, so that an operator's test leaves paid credits unused. */
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

/* If the ledger has no room, no round can be bought, because the end of the round could not be
 * logged either. */
int credit_can_play(const struct ledger *ledger, const struct core_config *config)
{
    return credit_price(config) == 0 ||
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

static uint8_t pay(struct ledger *ledger, const struct core_config *config)
{
    struct balance *balance = &ledger->balance;
    if (credit_price(config) == 0) {
        return PAYMENT_FREE;
    }
    const uint8_t kind = next_credit(ledger);
    const uint8_t spent = balance->returned != PAYMENT_NONE ? PAYMENT_SPENT : 0u;
    balance->bonus_units = 0;
    balance->service -= kind == PAYMENT_SERVICE;
    balance->paid -= kind == PAYMENT_PAID;
    balance->returned = PAYMENT_NONE;
    return kind | spent;
}

void credit_take(struct game *game, const struct core_config *config, uint8_t what,
                 struct output *output)
{
    struct credit *credit = &game->accounts.credit;
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
    game->accounts.ledger.balance.open = pay(&game->accounts.ledger, config);
    ledger_write(&game->accounts, game->tick, &entry, output);
}

/* A refund may exceed SET_CREDIT_MAX by one, because the credit belongs to a player. After a
 * restart, an open round may have a non-refundable credit if no player had joined. The
 * LEDGER_REFUND of that round has `count` 0. */
void credit_refund(struct game *game, const struct core_config *config, enum refund_cause cause,
                   struct output *output)
{
    struct balance *balance = &game->accounts.ledger.balance;
    const uint8_t open = balance->open, kind = open & PAYMENT_KIND_MASK;
    const int is_spent = stand_is_spent(game, config);
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
    const uint32_t won = credit_tickets_won(game, config);
    tickets_owe(&game->accounts, config, won);
    return won;
}

/* ---- Display -------------------------------------------------------------------------------- */

static float since_s(uint32_t tick, uint32_t event_tick)
{
    return event_tick != 0 ? (float)(tick - event_tick) * CORE_TICK_S : NEVER_S;
}

void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out)
{
    const struct credit *credit = &accounts->credit;
    const struct balance *balance = &accounts->ledger.balance;
    const uint32_t price = credit_price(config);
    const int is_event = config->persistent.settings.value[SET_PLAY] == PLAY_EVENT;
    *out = (struct scene_credit){
        .price = (uint8_t)price,
        .is_event = (uint8_t)(price == 0 && is_event),
        .unpaid = (uint8_t)(!credit_can_play(&accounts->ledger, config) &&
                            credit_coming(&accounts->ledger) == 0),
        .warnings = credit->warnings,
        .came_back = credit->came_back,
        .coin_units = (uint8_t)config->persistent.settings.value[SET_COIN_1],
        .units = balance->units,
        .credits = sure_credits(&accounts->ledger),
        .coming = credit_coming(&accounts->ledger),
        .coin_s = since_s(tick, credit->coin_tick),
        .asked_s = since_s(tick, credit->asked_tick),
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
    return stand_hash(hash, &credit->stand);
}
