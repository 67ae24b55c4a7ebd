/* coins.c -- every coin counts exactly once, even while the ledger is full. */
#include "core/game/accounting/coins.h"

#include "core/core.h"

#define TICKS_PER_MIN (60u * CORE_TICK_HZ)

static uint32_t setting(const struct core *core, uint32_t id)
{
    return (uint32_t)core->config.persistent.settings.value[id];
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

static void fall(struct core *core, uint32_t line, uint32_t pulses)
{
    struct pending_coins *untold = &core->game.accounts.credit.pending_coins[line];
    const uint32_t units = capped((uint64_t)pulses * setting(core, SET_COIN_1 + line));
    const uint32_t owed = credit_price(core) > 0 ? units : 0u; /* In free play a coin adds no units
                                                                  to the balance. */
    add_saturated(&untold->pulses, pulses);
    add_saturated(&untold->units, units);
    add_saturated(&untold->owed, owed);
    add_saturated(&core->game.accounts.ledger.balance.unlogged, owed);
}

void coins_insert(struct core *core, const struct input *input, struct output *output)
{
    struct credit *credit = &core->game.accounts.credit;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (input->coin_count[line] > 0) {
            fall(core, line, input->coin_count[line]);
        }
    }
    if (input_coin_pulses(input) > 0) {
        credit->metered += input_coin_pulses(input);
        credit->coin_tick = credit->act_tick = core->game.tick;
        if (credit_price(core) > 0) {
            output_sound(output, SOUND_COIN, 0.9f, 0.0f);
        }
    }
}

void coins_test(struct core *core, const struct input *input, struct output *output)
{
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (input->coin_count[line] > 0) {
            const struct ledger_entry entry = { .kind = LEDGER_TEST_COIN,
                                                .detail = (uint8_t)line,
                                                .count = input->coin_count[line] };
            ledger_write(core, &entry, output);
        }
    }
    core->game.accounts.credit.metered += input_coin_pulses(input);
}

/* Without a configured bonus the counter stays 0, so that old units do not count towards a bonus
 * that is enabled later. */
static void note_for_bonus(struct core *core, uint32_t units)
{
    struct balance *balance = &core->game.accounts.ledger.balance;
    const uint64_t sum = (uint64_t)balance->bonus_units + units;
    balance->bonus_units = setting(core, SET_BONUS_UNITS) > 0 ? capped(sum) : 0u;
}

/* Recordings of format 7 count these units towards a bonus even if no bonus is configured. */
void coins_convert_pending(struct core *core)
{
    struct balance *balance = &core->game.accounts.ledger.balance;
    const uint32_t units = balance->unlogged;
    balance->unlogged = 0;
    add_saturated(&balance->units, units);
    if (core->config.rules_7) {
        add_saturated(&balance->bonus_units, units);
    } else {
        note_for_bonus(core, units);
    }
}

static void append_coins_entry(struct core *core, uint32_t line, struct output *output)
{
    struct pending_coins *untold = &core->game.accounts.credit.pending_coins[line];
    struct balance *balance = &core->game.accounts.ledger.balance;
    const struct ledger_entry entry = { .kind = LEDGER_COINS,
                                        .detail = (uint8_t)line,
                                        .count = untold->pulses,
                                        .value = (int32_t)untold->units };
    balance->unlogged = less(balance->unlogged, untold->owed);
    add_saturated(&balance->units, untold->owed);
    note_for_bonus(core, untold->owed);
    *untold = (struct pending_coins){ 0 };
    ledger_write(core, &entry, output);
}

/* ---- Units to credits ----------------------------------------------------------------------- */

/* Buys as many credits as units and SET_CREDIT_MAX permit. Several coins may arrive in one tick, so
 * the count is computed by division. Remaining units stay in the balance. */
static uint32_t buy(struct core *core)
{
    struct balance *balance = &core->game.accounts.ledger.balance;
    const uint32_t price = credit_price(core);
    const uint32_t room = less(setting(core, SET_CREDIT_MAX), balance->paid + balance->service);
    const uint32_t bought = balance->units / price < room ? balance->units / price : room;
    balance->units -= bought * price;
    add_saturated(&balance->paid, bought);
    return bought;
}

static uint32_t give_bonus(struct core *core)
{
    struct balance *balance = &core->game.accounts.ledger.balance;
    const uint32_t each = setting(core, SET_BONUS_UNITS);
    const uint32_t times = each > 0 ? balance->bonus_units / each : 0u;
    const uint32_t bonus = times * setting(core, SET_BONUS_CREDITS);
    balance->bonus_units -= times * each;
    add_saturated(&balance->paid, bonus);
    return bonus;
}

static void change(struct core *core, struct output *output)
{
    const uint32_t bought = buy(core);
    const uint32_t bonus = give_bonus(core);
    if (bought + bonus > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_CREDITS,
                                            .count = bought + bonus,
                                            .value = (int32_t)bonus };
        ledger_write(core, &entry, output);
    }
}

static int may_tell(const struct core *core)
{
    return ledger_may_write(&core->game.accounts.ledger, LEDGER_COINS);
}

void coins_convert(struct core *core, struct output *output)
{
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (core->game.accounts.credit.pending_coins[line].pulses > 0 && may_tell(core)) {
            append_coins_entry(core, line, output);
        }
    }
    if (credit_price(core) > 0 && may_tell(core)) {
        change(core, output);
    }
}

/* ---- Expiry --------------------------------------------------------------------------------- */

void coins_expire(struct core *core, struct output *output)
{
    struct game *game = &core->game;
    struct balance *balance = &game->accounts.ledger.balance;
    const uint32_t minutes = setting(core, SET_CREDIT_EXPIRY_MIN);
    const uint32_t credits = balance->paid + balance->service;
    if (game->phase != PHASE_ATTRACT) {
        game->accounts.credit.act_tick = core->game.tick;
    }
    if (minutes == 0 ||
        core->game.tick - game->accounts.credit.act_tick < minutes * TICKS_PER_MIN ||
        credits + balance->units == 0 || !ledger_is_flushed(&game->accounts.ledger) ||
        balance->unlogged > 0 || !may_tell(core)) {
        return;
    }
    const struct ledger_entry entry = { .kind = LEDGER_EXPIRED, .count = credits };
    *balance = (struct balance){ .open = balance->open, .tickets = balance->tickets };
    ledger_write(core, &entry, output);
}
