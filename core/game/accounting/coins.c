/* coins.c -- counts each coin exactly once, even while the ledger is full, and handles the
 * cabinet's money inputs in each tick: coins, SERVICE, TILT, DOOR and the ticket dispenser. */
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/poi/world.h"

#define TICKS_PER_MIN (60u * CORE_TICK_HZ)

static uint32_t unsigned_setting(const struct settings *settings, uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    CORE_ASSERT(settings->value[id] >= 0);
    return (uint32_t)settings->value[id];
}

static void add_saturated(uint32_t *count, uint32_t more)
{
    const uint64_t sum = (uint64_t)*count + more;
    *count = sum < BALANCE_MAX ? (uint32_t)sum : BALANCE_MAX;
}

static uint32_t less(uint32_t from, uint32_t what)
{
    return from > what ? from - what : 0u;
}

/* ---- Conversion of pulses to units ---------------------------------------------------------- */

/* Adds the coin pulses of this tick to the pending coins and to the units that are not logged yet.
 * The settings contain the value of a pulse of each coin line. */
static void insert_coins(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         const struct input *input, struct output *output)
{
    struct credit *credit = &accounts->credit;
    const bool is_sold = config->credit_coins > 0;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        struct pending_coins *pending = &credit->pending_coins[line];
        const uint32_t pulses = input->coin_count[line];
        const uint64_t value =
            (uint64_t)pulses * unsigned_setting(&config->persistent.settings, SET_COIN_1 + line);
        const uint32_t units = value < BALANCE_MAX ? (uint32_t)value : BALANCE_MAX;
        /* In free play a coin adds no units to the balance. */
        const uint32_t owed = is_sold ? units : 0u;
        add_saturated(&pending->pulses, pulses);
        add_saturated(&pending->units, units);
        add_saturated(&pending->owed, owed);
        add_saturated(&accounts->ledger.balance.unlogged, owed);
    }
    if (input_coin_pulses(input) > 0) {
        credit->metered += input_coin_pulses(input);
        credit->coin_tick = credit->act_tick = tick;
        if (is_sold) {
            output_sound(output, SOUND_COIN, 0.9f, 0.0f);
        }
    }
}

/* Counts inserted units towards a bonus credit. Without a configured bonus the count stays 0. Units
 * inserted earlier therefore do not count towards a bonus that is configured later. */
static void note_for_bonus(struct balance *balance, const struct settings *settings, uint32_t units)
{
    if (unsigned_setting(settings, SET_BONUS_UNITS) > 0) {
        add_saturated(&balance->bonus_units, units);
    } else {
        balance->bonus_units = 0;
    }
}

void coins_convert_pending(struct ledger *ledger, const struct core_config *config)
{
    CORE_ASSERT(ledger->balance.open <= (PAYMENT_SERVICE | PAYMENT_SPENT));
    struct balance *balance = &ledger->balance;
    const uint32_t units = balance->unlogged;
    balance->unlogged = 0;
    add_saturated(&balance->units, units);
    if (!config_has_rules(config, 8)) {
        add_saturated(&balance->bonus_units, units);
    } else {
        note_for_bonus(balance, &config->persistent.settings, units);
    }
}

/* Logs the pending coins of each line for which the ledger has room, and adds their units to the
 * balance. */
static void log_coins(struct accounts *accounts, const struct settings *settings, uint32_t tick,
                      struct output *output)
{
    struct balance *balance = &accounts->ledger.balance;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        struct pending_coins *pending = &accounts->credit.pending_coins[line];
        const struct ledger_entry entry = { .kind = LEDGER_COINS,
                                            .detail = (uint8_t)line,
                                            .count = pending->pulses,
                                            .value = (int32_t)pending->units };
        if (pending->pulses > 0 && ledger_may_write(&accounts->ledger, LEDGER_COINS)) {
            balance->unlogged = less(balance->unlogged, pending->owed);
            add_saturated(&balance->units, pending->owed);
            note_for_bonus(balance, settings, pending->owed);
            *pending = (struct pending_coins){ 0 };
            ledger_write(accounts, tick, &entry, output);
        }
    }
}

/* ---- Conversion of units to credits --------------------------------------------------------- */

/* Buys as many credits as the units and SET_CREDIT_MAX permit, and adds the bonus credits, which
 * may exceed SET_CREDIT_MAX. Several coins may arrive in one tick, so the number of credits is
 * computed by division. Remaining units stay in the balance. */
static void buy_credits(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                        struct output *output)
{
    const struct settings *settings = &config->persistent.settings;
    struct balance *balance = &accounts->ledger.balance;
    const uint32_t price = config->credit_coins, each = unsigned_setting(settings, SET_BONUS_UNITS);
    CORE_ASSERT(price > 0 && price <= CREDIT_COINS_MAX);
    const uint32_t room =
        less(unsigned_setting(settings, SET_CREDIT_MAX), balance->paid + balance->service);
    const uint32_t bought = balance->units / price < room ? balance->units / price : room;
    balance->units -= bought * price;
    add_saturated(&balance->paid, bought);
    const uint32_t times = each > 0 ? balance->bonus_units / each : 0u;
    const uint32_t bonus = times * unsigned_setting(settings, SET_BONUS_CREDITS);
    balance->bonus_units -= times * each;
    add_saturated(&balance->paid, bonus);
    if (bought + bonus > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_CREDITS,
                                            .count = bought + bonus,
                                            .value = (int32_t)bonus };
        ledger_write(accounts, tick, &entry, output);
    }
}

/* Removes unused credits and units after SET_CREDIT_EXPIRY_MIN without activity. Credits expire
 * only in attract mode, and only when every entry of the ledger is on disk. */
static void expire_credits(struct accounts *accounts, const struct game *game,
                           const struct settings *settings, struct output *output)
{
    const struct ledger *ledger = &accounts->ledger;
    struct balance *balance = &accounts->ledger.balance;
    const uint32_t minutes = unsigned_setting(settings, SET_CREDIT_EXPIRY_MIN);
    const uint32_t credits = balance->paid + balance->service;
    if (game->phase != PHASE_ATTRACT) {
        accounts->credit.act_tick = game->tick;
    }
    if (minutes == 0 || game->tick - accounts->credit.act_tick < minutes * TICKS_PER_MIN ||
        credits + balance->units == 0 || !ledger_is_flushed(ledger) || balance->unlogged > 0 ||
        !ledger_may_write(ledger, LEDGER_COINS)) {
        return;
    }
    const struct ledger_entry entry = { .kind = LEDGER_EXPIRED, .count = credits };
    *balance = (struct balance){ .open = balance->open, .tickets = balance->tickets };
    ledger_write(accounts, game->tick, &entry, output);
}

/* ---- Tickets, cabinet buttons and the tick of the money inputs ------------------------------- */

/* Dispenses the tickets that the kiosk owes, one after the other. Logs the next ticket if the
 * previous pulse of the ticket dispenser has ended. Starts the dispenser's pulse for a logged
 * ticket when the ticket's entry is on disk. */
static void tick_tickets(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         const struct input *input, struct output *output)
{
    CORE_ASSERT(accounts->ledger.balance.tickets <= BALANCE_TICKETS_MAX);
    struct ledger *ledger = &accounts->ledger;
    struct credit *credit = &accounts->credit;
    const struct ledger_entry entry = { .kind = LEDGER_TICKET, .count = 1 };
    const bool is_owed_on_disk = ledger->committed.tickets > 0 && ledger->balance.tickets > 0;
    if (credit->ticket_id != 0) {
        if (ledger_is_saved(ledger, credit->ticket_id)) {
            credit->tickets++;
            credit->ticket_id = 0;
        }
    } else if (config_has_rules(config, 8) && is_owed_on_disk &&
               input->tickets_done == credit->tickets && ledger_may_write(ledger, LEDGER_TICKET)) {
        ledger->balance.tickets--;
        credit->ticket_id = ledger_write(accounts, tick, &entry, output);
    }
}

/* Handles the tilt switch (TILT) and the SERVICE button outside the operator's menu. */
static void take_buttons(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                         const struct input *input, struct output *output)
{
    CORE_ASSERT(config->credit_coins <= CREDIT_COINS_MAX);
    struct credit *credit = &accounts->credit;
    struct balance *balance = &accounts->ledger.balance;
    if ((input->held | input->pressed) & INPUT_TILT) {
        if (!(credit->warnings & WARN_TILT)) {
            credit->shakes++;
            output_sound(output, SOUND_FOUL, 0.8f, 0.0f);
        }
        credit->tilt_tick = tick;
    }
    if ((input->pressed & INPUT_SERVICE) && config->credit_coins > 0 &&
        balance->paid + balance->service <
            unsigned_setting(&config->persistent.settings, SET_CREDIT_MAX) &&
        ledger_may_write(&accounts->ledger, LEDGER_SERVICE)) {
        const struct ledger_entry entry = { .kind = LEDGER_SERVICE };
        balance->service++;
        credit->act_tick = tick;
        ledger_write(accounts, tick, &entry, output);
        output_sound(output, SOUND_COIN, 0.5f, 0.0f);
    }
}

/* Returns the current warnings (bit mask of enum credit_warning). The warning WARN_NO_POI is set
 * unless a slot has a connected controller or the bot, because otherwise a person who pays could
 * not play. */
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

void coins_tick(struct accounts *accounts, const struct game *game, const struct world *world,
                const struct core_config *config, const struct input *input, struct output *output)
{
    const struct settings *settings = &config->persistent.settings;
    CORE_ASSERT(accounts->ledger.saved_id <= accounts->ledger.last_id);
    const bool runs =
        game->phase == PHASE_READY || game->phase == PHASE_ROUND || game->phase == PHASE_LAB;
    if (accounts->ledger.balance.open != PAYMENT_NONE && !runs) {
        /* The game ended without a result: a visit to the growth lab, or a round that no player
         * joined. */
        const struct ledger_entry left = { .kind = LEDGER_LEFT };
        accounts->ledger.balance.open = PAYMENT_NONE;
        ledger_write(accounts, game->tick, &left, output);
    }
    /* Coins inserted in the operator's menu are tests. The coin meter counts the coins, but the
     * balance does not change. */
    if (game->phase == PHASE_MENU) {
        for (uint8_t line = 0; line < COIN_LINE_COUNT; line++) {
            if (input->coin_count[line] > 0) {
                const struct ledger_entry entry = { .kind = LEDGER_TEST_COIN,
                                                    .detail = line,
                                                    .count = input->coin_count[line] };
                ledger_write(accounts, game->tick, &entry, output);
            }
        }
        accounts->credit.metered += input_coin_pulses(input);
    } else {
        insert_coins(accounts, config, game->tick, input, output);
        take_buttons(accounts, config, game->tick, input, output);
    }
    log_coins(accounts, settings, game->tick, output);
    if (config->credit_coins > 0 && ledger_may_write(&accounts->ledger, LEDGER_COINS)) {
        buy_credits(accounts, config, game->tick, output);
    }
    expire_credits(accounts, game, settings, output);
    tick_tickets(accounts, config, game->tick, input, output);
    accounts->credit.warnings = current_warnings(game, world, config, input);
}
