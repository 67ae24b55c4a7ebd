/* audits.c -- adds each ledger entry to the counters that belong to its kind. */
#include "core/game/accounting/audits.h"

#include "core/base/panic.h"
#include "core/game/rules.h"

/* Names of the counters that have a fixed name. audits_name() computes the other names, from
 * AUDIT_PLAYS to AUDIT_BOOTS - 1. */
static const char *const names[AUDIT_COUNT] = {
    [AUDIT_COINS_1] = "coins-1",
    [AUDIT_COINS_2] = "coins-2",
    [AUDIT_COINS_3] = "coins-3",
    [AUDIT_UNITS] = "units",
    [AUDIT_TEST_COINS] = "test-coins",
    [AUDIT_CREDITS_PAID] = "credits-paid",
    [AUDIT_CREDITS_BONUS] = "credits-bonus",
    [AUDIT_CREDITS_SERVICE] = "credits-service",
    [AUDIT_REFUNDS] = "refunds",
    [AUDIT_EXPIRED] = "expired",
    [AUDIT_TICKETS] = "tickets",
    [AUDIT_TILTS] = "tilts",
    [AUDIT_PLAYS_PAID] = "plays-paid",
    [AUDIT_PLAYS_SERVICE] = "plays-service",
    [AUDIT_PLAYS_FREE] = "plays-free",
    [AUDIT_PLAYS_LAB] = "plays-lab",
    [AUDIT_ROUNDS] = "rounds",
    [AUDIT_PLAYERS] = "players",
    [AUDIT_CAUGHT] = "caught",
    [AUDIT_PLAY_S] = "play-seconds",
    [AUDIT_PAPERS] = "papers",
    [AUDIT_PAPERS_TORN] = "papers-torn",
    [AUDIT_PAPER_LIFE_S] = "paper-life-seconds",
    [AUDIT_FOULS] = "fouls",
    [AUDIT_BOOTS] = "boots",
    [AUDIT_CRASHED_ROUNDS] = "crashed-rounds",
    [AUDIT_DROPPED_TICKS] = "dropped-ticks",
    [AUDIT_DEVICE_FAULTS] = "device-faults",
    [AUDIT_UP_S] = "up-seconds",
    [AUDIT_UP_S_MAX] = "up-seconds-longest",
    [AUDIT_RESETS] = "resets",
    [AUDIT_WRONG_PINS] = "wrong-pins",
    [AUDIT_LOST_AGAIN] = "lost-again-1",
    [AUDIT_LOST_AGAIN + 1] = "lost-again-2",
    [AUDIT_LOST_AGAIN + 2] = "lost-again-3",
    [AUDIT_LOST_AGAIN + 3] = "lost-again-4",
    [AUDIT_TICKETS_OUT] = "tickets-dispensed",
    [AUDIT_ROUNDS_EASIER] = "rounds-normal",
    [AUDIT_ROUNDS_EASIER + 1] = "rounds-easy",
};
_Static_assert(POI_MAX == 4u, "each slot has its counter of losses");
_Static_assert(LEVEL_NORMAL == 1 && LEVEL_EASY == 2 && LEVEL_COUNT == 3, "each level has a name");

static void append_audit_text(char out[AUDIT_NAME_SIZE], const char *text)
{
    uint32_t at = 0;
    while (out[at]) {
        at++;
    }
    for (uint32_t i = 0; text[i] && at + 1u < AUDIT_NAME_SIZE; i++) {
        out[at++] = text[i];
    }
    out[at] = '\0';
}

static void append_number(char out[AUDIT_NAME_SIZE], uint32_t number)
{
    CORE_ASSERT(number < 100u);
    const char digits[3] = { (char)('0' + number / 10u % 10u), (char)('0' + number % 10u), 0 };
    append_audit_text(out, number < 10u ? digits + 1 : digits);
}

void audits_name(uint32_t id, char out[AUDIT_NAME_SIZE])
{
    CORE_ASSERT(id < AUDIT_COUNT);
    out[0] = '\0';
    if (names[id]) {
        append_audit_text(out, names[id]);
    } else if (id < AUDIT_HOUR) {
        append_audit_text(out, "plays-");
        append_audit_text(out, rules_of((uint8_t)((id - AUDIT_PLAYS) / AUDIT_GRADES))->name);
        append_audit_text(out, "-");
        append_number(out, (id - AUDIT_PLAYS) % AUDIT_GRADES + SHEET_GRADE_MIN);
    } else if (id < AUDIT_WEEKDAY) {
        append_audit_text(out, "hour-");
        append_number(out, id - AUDIT_HOUR);
    } else {
        append_audit_text(out, "weekday-");
        append_number(out, id - AUDIT_WEEKDAY + 1u);
    }
}

enum audit_group audits_group_of(uint32_t id)
{
    CORE_ASSERT(id < AUDIT_COUNT);
    return id < AUDIT_PLAYS_PAID || id == AUDIT_TICKETS_OUT ? AUDIT_GROUP_MONEY
           : id < AUDIT_BOOTS || id >= AUDIT_ROUNDS_EASIER  ? AUDIT_GROUP_PLAY
                                                            : AUDIT_GROUP_MACHINE;
}

uint32_t audits_rounds_at(const uint32_t count[AUDIT_COUNT], uint8_t level)
{
    CORE_ASSERT(level < LEVEL_COUNT);
    uint32_t easier = 0;
    for (uint32_t i = AUDIT_ROUNDS_EASIER; i < AUDIT_COUNT; i++) {
        easier += count[i];
    }
    if (level != LEVEL_MASTER) {
        return count[AUDIT_ROUNDS_EASIER + level - LEVEL_NORMAL];
    }
    return count[AUDIT_ROUNDS] > easier ? count[AUDIT_ROUNDS] - easier : 0u;
}

static void add_to_audit(struct audits *audits, uint32_t id, uint32_t count)
{
    CORE_ASSERT(id < AUDIT_COUNT);
    uint32_t *sum = &audits->count[id];
    *sum = UINT32_MAX - *sum < count ? UINT32_MAX : *sum + count;
}

/* ---- Counters of games and rounds ------------------------------------------------------------ */

static void note_begin(struct audits *audits, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->kind == LEDGER_BEGIN);
    const uint8_t kind = entry->balance.open & PAYMENT_KIND_MASK;
    add_to_audit(audits,
                 kind == PAYMENT_PAID      ? AUDIT_PLAYS_PAID
                 : kind == PAYMENT_SERVICE ? AUDIT_PLAYS_SERVICE
                                           : AUDIT_PLAYS_FREE,
                 1);
    const uint32_t grade = entry->count - SHEET_GRADE_MIN;
    if (entry->detail < MODE_COUNT && grade < AUDIT_GRADES) {
        add_to_audit(audits, AUDIT_PLAYS + entry->detail * AUDIT_GRADES + grade, 1);
    } else if (entry->detail == CHOICE_LAB) {
        add_to_audit(audits, AUDIT_PLAYS_LAB, 1);
    }
    if (entry->day != 0 && entry->minute < 24u * 60u) {
        /* Weekday 0 is Monday. Day 0 of the calendar (2000-01-01) is a Saturday, so 5 is added. */
        add_to_audit(audits, AUDIT_HOUR + entry->minute / 60u, 1);
        add_to_audit(audits, AUDIT_WEEKDAY + (entry->day + 5u) % 7u, 1);
    }
}

static uint32_t rounded_seconds(uint32_t ticks)
{
    return (ticks + CORE_TICK_HZ / 2u) / CORE_TICK_HZ;
}

/* Adds a finished round to the counters. The lifetime of paper counts only for the first sheet,
 * because in scored modes a player receives only one sheet. */
static void note_round(struct audits *audits, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->kind == LEDGER_ROUND);
    const struct round_record *round = &entry->round;
    add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == ROUND_CUT_OFF);
    if (round->by_bot || round->unscored) {
        return;
    }
    add_to_audit(audits, AUDIT_ROUNDS, 1);
    if (round->level != LEVEL_MASTER && round->level < LEVEL_COUNT) {
        add_to_audit(audits, AUDIT_ROUNDS_EASIER + round->level - LEVEL_NORMAL, 1);
    }
    add_to_audit(audits, AUDIT_CAUGHT, round->caught);
    add_to_audit(audits, AUDIT_PLAY_S, rounded_seconds(round->end_tick - round->start_tick));
    for (uint32_t slot = 0; slot < POI_MAX; slot++) {
        const struct player_record *player = &round->player[slot];
        if (!(round->players & 1u << slot)) {
            continue;
        }
        add_to_audit(audits, AUDIT_PLAYERS, 1);
        add_to_audit(audits, AUDIT_PAPERS, player->sheets);
        add_to_audit(audits, AUDIT_FOULS, player->fouls);
        if (player->torn_tick != 0) {
            const uint32_t life_s = rounded_seconds(player->torn_tick - round->start_tick);
            add_to_audit(audits, AUDIT_PAPERS_TORN, 1);
            add_to_audit(audits, AUDIT_PAPER_LIFE_S, life_s);
        }
    }
}

/* ---- Counters for each kind of ledger entry -------------------------------------------------- */

/* Amount that an entry adds to a counter: 1, the entry's `count`, or the entry's `value`. */
enum amount { AMOUNT_ONE = 0, AMOUNT_COUNT, AMOUNT_VALUE };

/* Table of the counters that every entry of a given kind changes. */
static const struct {
    uint8_t kind, audit, amount;
} sums[] = {
    { LEDGER_BOOT, AUDIT_BOOTS, AMOUNT_ONE },
    { LEDGER_BOOT, AUDIT_UNITS, AMOUNT_VALUE },
    { LEDGER_COINS, AUDIT_UNITS, AMOUNT_VALUE },
    { LEDGER_TEST_COIN, AUDIT_TEST_COINS, AMOUNT_COUNT },
    { LEDGER_CREDITS, AUDIT_CREDITS_PAID, AMOUNT_COUNT },
    { LEDGER_CREDITS, AUDIT_CREDITS_BONUS, AMOUNT_VALUE },
    { LEDGER_SERVICE, AUDIT_CREDITS_SERVICE, AMOUNT_ONE },
    { LEDGER_REFUND, AUDIT_REFUNDS, AMOUNT_COUNT },
    { LEDGER_EXPIRED, AUDIT_EXPIRED, AMOUNT_COUNT },
    { LEDGER_FACTORY, AUDIT_EXPIRED, AMOUNT_COUNT },
    { LEDGER_ROUND, AUDIT_TICKETS, AMOUNT_VALUE },
    { LEDGER_TICKET, AUDIT_TICKETS_OUT, AMOUNT_COUNT },
    { LEDGER_HEALTH, AUDIT_TILTS, AMOUNT_COUNT },
    { LEDGER_HEALTH, AUDIT_UP_S, AMOUNT_VALUE },
    { LEDGER_RESET, AUDIT_RESETS, AMOUNT_ONE },
};

void audits_note(struct audits *audits, const struct ledger_entry *entry)
{
    const uint32_t amounts[] = { 1u, entry->count, (uint32_t)entry->value };
    uint32_t *wrong_pins = &audits->count[AUDIT_WRONG_PINS];
    uint32_t *longest = &audits->count[AUDIT_UP_S_MAX];
    for (uint32_t i = 0; i < sizeof sums / sizeof sums[0]; i++) {
        if (sums[i].kind == entry->kind) {
            add_to_audit(audits, sums[i].audit, amounts[sums[i].amount]);
        }
    }
    switch (entry->kind) {
    case LEDGER_COINS:
        if (entry->detail < COIN_LINE_COUNT) {
            add_to_audit(audits, AUDIT_COINS_1 + entry->detail, entry->count);
        }
        break;
    case LEDGER_BEGIN:
        note_begin(audits, entry);
        break;
    case LEDGER_ROUND:
        note_round(audits, entry);
        break;
    case LEDGER_REFUND:
        add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == REFUND_RESTART);
        break;
    case LEDGER_RESET: /* Reset every counter of the group except AUDIT_RESETS, which counts the
                          resets. */
        for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
            if (id != AUDIT_RESETS && audits_group_of(id) == entry->detail) {
                audits->count[id] = 0;
            }
        }
        break;
    case LEDGER_PIN:
        *wrong_pins = entry->detail ? 0u : *wrong_pins;
        add_to_audit(audits, AUDIT_WRONG_PINS, !entry->detail);
        break;
    case LEDGER_LOSS:
        if (entry->detail < POI_MAX) {
            add_to_audit(audits, AUDIT_LOST_AGAIN + entry->detail, entry->count);
        }
        break;
    case LEDGER_HEALTH:
        add_to_audit(audits, AUDIT_DROPPED_TICKS, entry->health.dropped_ticks);
        add_to_audit(audits, AUDIT_DEVICE_FAULTS, entry->health.device_faults);
        *longest = *longest < entry->health.up_s ? entry->health.up_s : *longest;
        break;
    default:
        /* The table `sums` contains all counters that the other kinds of entries change.
         * LEDGER_NAME, LEDGER_SETTING, LEDGER_STAND and LEDGER_LEFT change no counter. */
        break;
    }
}
