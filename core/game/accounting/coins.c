/* coins.c -- counts each coin exactly once, even while the ledger is full. */
#include "core/game/accounting/credit.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/ledger_writer.h"
#include "core/game/game.h"

#define TICKS_PER_MIN (60u * CORE_TICK_HZ)

static uint32_t unsigned_setting(const struct settings *settings, uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    CORE_ASSERT(settings->value[id] >= 0);
    return (uint32_t)settings->value[id];
}

static uint32_t capped(uint64_t sum)
{
    return sum < BALANCE_MAX ? (uint32_t)sum : BALANCE_MAX;
}

static void add_saturated(uint32_t *count, uint32_t more)
{
    *count = capped((uint64_t)*count + more);
}

static uint32_t less(uint32_t from, uint32_t what)
{
    return from > what ? from - what : 0u;
}

/* ---- Pulses to units ------------------------------------------------------------------------ */

void coins_insert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output)
{
    struct credit *credit = &accounts->credit;
    const int is_sold = config->credit_coins > 0;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        struct pending_coins *pending = &credit->pending_coins[line];
        const uint32_t pulses = input->coin_count[line];
        const uint32_t each = unsigned_setting(&config->persistent.settings, SET_COIN_1 + line);
        const uint32_t units = capped((uint64_t)pulses * each);
        const uint32_t owed = is_sold ? units : 0u; /* In free play a coin adds no units to the
                                                       balance. */
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

void coins_test(struct accounts *accounts, uint32_t tick, const struct input *input,
                struct output *output)
{
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (input->coin_count[line] > 0) {
            const struct ledger_entry entry = { .kind = LEDGER_TEST_COIN,
                                                .detail = (uint8_t)line,
                                                .count = input->coin_count[line] };
            ledger_write(accounts, tick, &entry, output);
        }
    }
    accounts->credit.metered += input_coin_pulses(input);
}

/* Adds units to the counter of the units that earn a bonus credit. Without a configured bonus the
 * counter stays 0. Units inserted earlier therefore do not count towards a bonus that is configured
 * later. */
static void note_for_bonus(struct ledger *ledger, const struct settings *settings, uint32_t units)
{
    struct balance *balance = &ledger->balance;
    const uint64_t sum = (uint64_t)balance->bonus_units + units;
    balance->bonus_units = unsigned_setting(settings, SET_BONUS_UNITS) > 0 ? capped(sum) : 0u;
}

/* In recordings of format 7 the units count towards a bonus even if no bonus is configured. */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config)
{
    CORE_ASSERT(ledger->balance.open <= (PAYMENT_SERVICE | PAYMENT_SPENT));
    struct balance *balance = &ledger->balance;
    const uint32_t units = balance->unlogged;
    balance->unlogged = 0;
    add_saturated(&balance->units, units);
    if (config->rules_7) {
        add_saturated(&balance->bonus_units, units);
    } else {
        note_for_bonus(ledger, &config->persistent.settings, units);
    }
}

/* ---- Units to credits ----------------------------------------------------------------------- */

/* Logs the pending coins of `line`, and adds their units to the balance. */
static void log_coins(struct accounts *accounts, const struct settings *settings, uint32_t tick,
                      uint32_t line, struct output *output)
{
    struct pending_coins *pending = &accounts->credit.pending_coins[line];
    struct balance *balance = &accounts->ledger.balance;
    const struct ledger_entry entry = { .kind = LEDGER_COINS,
                                        .detail = (uint8_t)line,
                                        .count = pending->pulses,
                                        .value = (int32_t)pending->units };
    CORE_ASSERT(line < COIN_LINE_COUNT);
    balance->unlogged = less(balance->unlogged, pending->owed);
    add_saturated(&balance->units, pending->owed);
    note_for_bonus(&accounts->ledger, settings, pending->owed);
    *pending = (struct pending_coins){ 0 };
    ledger_write(accounts, tick, &entry, output);
}

/* Buys as many credits as the units and SET_CREDIT_MAX permit, and adds the bonus credits. Several
 * coins may arrive in one tick, so the number of credits is computed by division. Remaining units
 * stay in the balance. */
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

void coins_convert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output)
{
    const struct ledger *ledger = &accounts->ledger;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (accounts->credit.pending_coins[line].pulses > 0 &&
            ledger_may_write(ledger, LEDGER_COINS)) {
            log_coins(accounts, &config->persistent.settings, tick, line, output);
        }
    }
    if (config->credit_coins > 0 && ledger_may_write(ledger, LEDGER_COINS)) {
        buy_credits(accounts, config, tick, output);
    }
}

/* ---- Expiry --------------------------------------------------------------------------------- */

void coins_expire(struct game *game, const struct settings *settings, struct output *output)
{
    CORE_ASSERT(game->accounts.ledger.saved_id <= game->accounts.ledger.last_id);
    struct balance *balance = &game->accounts.ledger.balance;
    const uint32_t minutes = unsigned_setting(settings, SET_CREDIT_EXPIRY_MIN);
    const uint32_t credits = balance->paid + balance->service;
    if (game->phase != PHASE_ATTRACT) {
        game->accounts.credit.act_tick = game->tick;
    }
    if (minutes == 0 || game->tick - game->accounts.credit.act_tick < minutes * TICKS_PER_MIN ||
        credits + balance->units == 0 || !ledger_is_flushed(&game->accounts.ledger) ||
        balance->unlogged > 0 || !ledger_may_write(&game->accounts.ledger, LEDGER_COINS)) {
        return;
    }
    const struct ledger_entry entry = { .kind = LEDGER_EXPIRED, .count = credits };
    *balance = (struct balance){ .open = balance->open, .tickets = balance->tickets };
    ledger_write(&game->accounts, game->tick, &entry, output);
}
