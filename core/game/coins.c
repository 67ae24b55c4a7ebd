/* coins.c -- every coin counts exactly once, even while the ledger is full. */
#include "core/game/coins.h"

#include "core/core.h"

#define TICKS_PER_MIN (60u * CORE_TICK_HZ)

static uint32_t setting(const struct core *core, uint32_t id)
{
    return (uint32_t)core->config.memory.settings.value[id];
}

static uint32_t capped(uint64_t sum)
{
    return sum < PURSE_MAX ? (uint32_t)sum : PURSE_MAX;
}

static void add(uint32_t *count, uint32_t more)
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
    struct untold *untold = &core->game.credit.untold[line];
    const uint32_t units = capped((uint64_t)pulses * setting(core, SET_COIN_1 + line));
    const uint32_t owed = credit_price(core) > 0 ? units : 0u; /* In free play a coin adds no units
                                                                  to the balance. */
    add(&untold->pulses, pulses);
    add(&untold->units, units);
    add(&untold->owed, owed);
    add(&core->game.ledger.purse.untold, owed);
}

void coins_fall(struct core *core, const struct input *input, struct output *output)
{
    struct credit *credit = &core->game.credit;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (input->coin_count[line] > 0) {
            fall(core, line, input->coin_count[line]);
        }
    }
    if (coin_pulses(input) > 0) {
        credit->metered += coin_pulses(input);
        credit->coin_tick = credit->act_tick = core->tick;
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
    core->game.credit.metered += coin_pulses(input);
}

/* Without a configured bonus the counter stays 0, so that old units do not count towards a bonus
 * that is enabled later. */
static void note_for_bonus(struct core *core, uint32_t units)
{
    struct purse *purse = &core->game.ledger.purse;
    const uint64_t sum = (uint64_t)purse->bonus_units + units;
    purse->bonus_units = setting(core, SET_BONUS_UNITS) > 0 ? capped(sum) : 0u;
}

/* Recordings of format 7 count these units towards a bonus even if no bonus is configured. */
void coins_fold_untold(struct core *core)
{
    struct purse *purse = &core->game.ledger.purse;
    const uint32_t units = purse->untold;
    purse->untold = 0;
    add(&purse->units, units);
    if (core->config.rules_7) {
        add(&purse->bonus_units, units);
    } else {
        note_for_bonus(core, units);
    }
}

static void tell(struct core *core, uint32_t line, struct output *output)
{
    struct untold *untold = &core->game.credit.untold[line];
    struct purse *purse = &core->game.ledger.purse;
    const struct ledger_entry entry = { .kind = LEDGER_COINS,
                                        .detail = (uint8_t)line,
                                        .count = untold->pulses,
                                        .value = (int32_t)untold->units };
    purse->untold = less(purse->untold, untold->owed);
    add(&purse->units, untold->owed);
    note_for_bonus(core, untold->owed);
    *untold = (struct untold){ 0 };
    ledger_write(core, &entry, output);
}

/* ---- Units to credits ----------------------------------------------------------------------- */

/* Buys as many credits as units and SET_CREDIT_MAX permit. Several coins may arrive in one tick, so
 * the count is computed by division. Remaining units stay in the balance. */
static uint32_t buy(struct core *core)
{
    struct purse *purse = &core->game.ledger.purse;
    const uint32_t price = credit_price(core);
    const uint32_t room = less(setting(core, SET_CREDIT_MAX), purse->paid + purse->service);
    const uint32_t bought = purse->units / price < room ? purse->units / price : room;
    purse->units -= bought * price;
    add(&purse->paid, bought);
    return bought;
}

static uint32_t give_bonus(struct core *core)
{
    struct purse *purse = &core->game.ledger.purse;
    const uint32_t each = setting(core, SET_BONUS_UNITS);
    const uint32_t times = each > 0 ? purse->bonus_units / each : 0u;
    const uint32_t bonus = times * setting(core, SET_BONUS_CREDITS);
    purse->bonus_units -= times * each;
    add(&purse->paid, bonus);
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
    return ledger_may_write(&core->game.ledger, LEDGER_COINS);
}

void coins_settle(struct core *core, struct output *output)
{
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (core->game.credit.untold[line].pulses > 0 && may_tell(core)) {
            tell(core, line, output);
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
    struct purse *purse = &game->ledger.purse;
    const uint32_t minutes = setting(core, SET_CREDIT_EXPIRY_MIN);
    const uint32_t credits = purse->paid + purse->service;
    if (game->phase != PHASE_ATTRACT) {
        game->credit.act_tick = core->tick;
    }
    if (minutes == 0 || core->tick - game->credit.act_tick < minutes * TICKS_PER_MIN ||
        credits + purse->units == 0 || !ledger_is_settled(&game->ledger) ||
        purse->untold > 0 || !may_tell(core)) {
        return;
    }
    const struct ledger_entry entry = { .kind = LEDGER_EXPIRED, .count = credits };
    *purse = (struct purse){ .open = purse->open, .tickets = purse->tickets };
    ledger_write(core, &entry, output);
}
