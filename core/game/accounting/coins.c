/* coins.c -- counts each coin exactly once, even while the ledger is full. */
#include "core/game/accounting/coins.h"

#include "core/game/game.h"
#include "core/config.h"

#define TICKS_PER_MIN (60u * CORE_TICK_HZ)

static uint32_t setting(const struct settings *settings, uint32_t id)
{
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

static void fall(struct accounts *accounts, const struct core_config *config, uint32_t line,
                 uint32_t pulses)
{
    struct pending_coins *untold = &accounts->credit.pending_coins[line];
    const uint32_t units =
        capped((uint64_t)pulses * setting(&config->persistent.settings, SET_COIN_1 + line));
    const uint32_t owed =
        credit_price(config) > 0 ? units : 0u; /* In free play a coin adds no units to the
                                                  balance. */
    add_saturated(&untold->pulses, pulses);
    add_saturated(&untold->units, units);
    add_saturated(&untold->owed, owed);
    add_saturated(&accounts->ledger.balance.unlogged, owed);
}

void coins_insert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output)
{
    struct credit *credit = &accounts->credit;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (input->coin_count[line] > 0) {
            fall(accounts, config, line, input->coin_count[line]);
        }
    }
    if (input_coin_pulses(input) > 0) {
        credit->metered += input_coin_pulses(input);
        credit->coin_tick = credit->act_tick = tick;
        if (credit_price(config) > 0) {
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

/* Adds units to the counter for the bonus. Without a configured bonus the counter stays 0. Units
 * inserted earlier therefore do not count towards a bonus that is configured later. */
static void note_for_bonus(struct ledger *ledger, const struct settings *settings, uint32_t units)
{
    struct balance *balance = &ledger->balance;
    const uint64_t sum = (uint64_t)balance->bonus_units + units;
    balance->bonus_units = setting(settings, SET_BONUS_UNITS) > 0 ? capped(sum) : 0u;
}

/* In recordings of format 7 the units count towards a bonus even if no bonus is configured. */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config)
{
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

static void append_coins_entry(struct accounts *accounts, const struct settings *settings,
                               uint32_t tick, uint32_t line, struct output *output)
{
    struct pending_coins *untold = &accounts->credit.pending_coins[line];
    struct balance *balance = &accounts->ledger.balance;
    const struct ledger_entry entry = { .kind = LEDGER_COINS,
                                        .detail = (uint8_t)line,
                                        .count = untold->pulses,
                                        .value = (int32_t)untold->units };
    balance->unlogged = less(balance->unlogged, untold->owed);
    add_saturated(&balance->units, untold->owed);
    note_for_bonus(&accounts->ledger, settings, untold->owed);
    *untold = (struct pending_coins){ 0 };
    ledger_write(accounts, tick, &entry, output);
}

/* ---- Units to credits ----------------------------------------------------------------------- */

/* Buys as many credits as the units and SET_CREDIT_MAX permit. Several coins may arrive in one
 * tick, so the number of credits is computed by division. Remaining units stay in the balance. */
static uint32_t buy(struct ledger *ledger, const struct core_config *config)
{
    struct balance *balance = &ledger->balance;
    const uint32_t price = credit_price(config);
    const uint32_t room = less(setting(&config->persistent.settings, SET_CREDIT_MAX),
                               balance->paid + balance->service);
    const uint32_t bought = balance->units / price < room ? balance->units / price : room;
    balance->units -= bought * price;
    add_saturated(&balance->paid, bought);
    return bought;
}

static uint32_t give_bonus(struct ledger *ledger, const struct settings *settings)
{
    struct balance *balance = &ledger->balance;
    const uint32_t each = setting(settings, SET_BONUS_UNITS);
    const uint32_t times = each > 0 ? balance->bonus_units / each : 0u;
    const uint32_t bonus = times * setting(settings, SET_BONUS_CREDITS);
    balance->bonus_units -= times * each;
    add_saturated(&balance->paid, bonus);
    return bonus;
}

static void change(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output)
{
    const uint32_t bought = buy(&accounts->ledger, config);
    const uint32_t bonus = give_bonus(&accounts->ledger, &config->persistent.settings);
    if (bought + bonus > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_CREDITS,
                                            .count = bought + bonus,
                                            .value = (int32_t)bonus };
        ledger_write(accounts, tick, &entry, output);
    }
}

static int may_tell(const struct ledger *ledger)
{
    return ledger_may_write(ledger, LEDGER_COINS);
}

void coins_convert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output)
{
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (accounts->credit.pending_coins[line].pulses > 0 && may_tell(&accounts->ledger)) {
            append_coins_entry(accounts, &config->persistent.settings, tick, line, output);
        }
    }
    if (credit_price(config) > 0 && may_tell(&accounts->ledger)) {
        change(accounts, config, tick, output);
    }
}

/* ---- Expiry --------------------------------------------------------------------------------- */

void coins_expire(struct game *game, const struct settings *settings, struct output *output)
{
    struct balance *balance = &game->accounts.ledger.balance;
    const uint32_t minutes = setting(settings, SET_CREDIT_EXPIRY_MIN);
    const uint32_t credits = balance->paid + balance->service;
    if (game->phase != PHASE_ATTRACT) {
        game->accounts.credit.act_tick = game->tick;
    }
    if (minutes == 0 || game->tick - game->accounts.credit.act_tick < minutes * TICKS_PER_MIN ||
        credits + balance->units == 0 || !ledger_is_flushed(&game->accounts.ledger) ||
        balance->unlogged > 0 || !may_tell(&game->accounts.ledger)) {
        return;
    }
    const struct ledger_entry entry = { .kind = LEDGER_EXPIRED, .count = credits };
    *balance = (struct balance){ .open = balance->open, .tickets = balance->tickets };
    ledger_write(&game->accounts, game->tick, &entry, output);
}
