/* audits.c -- adds each kind of ledger entry to its counters. */
#include "core/game/accounting/audits.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/rules.h"

static const char *const names[AUDIT_PLAYS] = {
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
};

static const char *const machine_names[AUDIT_COUNT - AUDIT_BOOTS] = {
    "boots",
    "crashed-rounds",
    "dropped-ticks",
    "device-faults",
    "up-seconds",
    "up-seconds-longest",
    "resets",
    "wrong-pins",
    "lost-again-1",
    "lost-again-2",
    "lost-again-3",
    "lost-again-4",
    "tickets-dispensed",
};
_Static_assert(POI_MAX == 4u, "each seat has its counter of losses");

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
    if (id < AUDIT_PLAYS) {
        append_audit_text(out, names[id]);
    } else if (id < AUDIT_HOUR) {
        append_audit_text(out, "plays-");
        append_audit_text(out, rules_of((uint8_t)((id - AUDIT_PLAYS) / AUDIT_GRADES))->name);
        append_audit_text(out, "-");
        append_number(out, (id - AUDIT_PLAYS) % AUDIT_GRADES + SHEET_GRADE_MIN);
    } else if (id < AUDIT_WEEKDAY) {
        append_audit_text(out, "hour-");
        append_number(out, id - AUDIT_HOUR);
    } else if (id < AUDIT_BOOTS) {
        append_audit_text(out, "weekday-");
        append_number(out, id - AUDIT_WEEKDAY + 1u);
    } else {
        append_audit_text(out, machine_names[id - AUDIT_BOOTS]);
    }
}

enum audit_group audits_group_of(uint32_t id)
{
    CORE_ASSERT(id < AUDIT_COUNT);
    return id < AUDIT_PLAYS_PAID || id == AUDIT_TICKETS_OUT ? AUDIT_GROUP_MONEY
           : id < AUDIT_BOOTS                               ? AUDIT_GROUP_PLAY
                                                            : AUDIT_GROUP_MACHINE;
}

static void add_to_audit(struct audits *audits, uint32_t id, uint32_t count)
{
    CORE_ASSERT(id < AUDIT_COUNT);
    uint32_t *sum = &audits->count[id];
    *sum = UINT32_MAX - *sum < count ? UINT32_MAX : *sum + count;
}

/* ---- Games ----------------------------------------------------------------------------------- */

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
        /* Day 0, 2000-01-01, is a Saturday. */
        add_to_audit(audits, AUDIT_HOUR + entry->minute / 60u, 1);
        add_to_audit(audits, AUDIT_WEEKDAY + (entry->day + 5u) % 7u, 1);
    }
}

static uint32_t rounded_seconds(uint32_t ticks)
{
    return (ticks + CORE_TICK_HZ / 2u) / CORE_TICK_HZ;
}

/* Adds a round to the counters. The lifetime of paper counts only for the first sheet, because in
 * scored modes a player receives only one sheet. */
static void note_round(struct audits *audits, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->kind == LEDGER_ROUND);
    const struct round_record *round = &entry->round;
    add_to_audit(audits, AUDIT_TICKETS, (uint32_t)entry->value);
    add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == ROUND_CUT_OFF);
    if (round->by_bot || round->unscored) {
        return;
    }
    add_to_audit(audits, AUDIT_ROUNDS, 1);
    add_to_audit(audits, AUDIT_CAUGHT, round->caught);
    add_to_audit(audits, AUDIT_PLAY_S, rounded_seconds(round->end_tick - round->start_tick));
    for (uint32_t seat = 0; seat < POI_MAX; seat++) {
        const struct player_record *player = &round->player[seat];
        if (!(round->players & 1u << seat)) {
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

/* Resets a group of counters to 0. AUDIT_RESETS is not reset, but incremented. */
static void note_reset(struct audits *audits, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->kind == LEDGER_RESET);
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        if (id != AUDIT_RESETS && audits_group_of(id) == entry->detail) {
            audits->count[id] = 0;
        }
    }
    add_to_audit(audits, AUDIT_RESETS, 1);
}

/* ---- Each kind of entry ---------------------------------------------------------------------- */

/* Adds the entry kinds that change one or two counters. */
static void note_counts(struct audits *audits, const struct ledger_entry *entry)
{
    const uint32_t value = (uint32_t)entry->value;
    switch (entry->kind) {
    case LEDGER_BOOT:
        add_to_audit(audits, AUDIT_BOOTS, 1);
        add_to_audit(audits, AUDIT_UNITS, value);
        break;
    case LEDGER_COINS:
        if (entry->detail < COIN_LINE_COUNT) {
            add_to_audit(audits, AUDIT_COINS_1 + entry->detail, entry->count);
        }
        add_to_audit(audits, AUDIT_UNITS, value);
        break;
    case LEDGER_TEST_COIN:
        add_to_audit(audits, AUDIT_TEST_COINS, entry->count);
        break;
    case LEDGER_CREDITS:
        add_to_audit(audits, AUDIT_CREDITS_PAID, entry->count);
        add_to_audit(audits, AUDIT_CREDITS_BONUS, value);
        break;
    case LEDGER_SERVICE:
        add_to_audit(audits, AUDIT_CREDITS_SERVICE, 1);
        break;
    case LEDGER_REFUND:
        add_to_audit(audits, AUDIT_REFUNDS, entry->count);
        add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == REFUND_RESTART);
        break;
    case LEDGER_EXPIRED:
    case LEDGER_FACTORY:
        add_to_audit(audits, AUDIT_EXPIRED, entry->count);
        break;
    case LEDGER_TICKET:
        add_to_audit(audits, AUDIT_TICKETS_OUT, entry->count);
        break;
    case LEDGER_LOSS:
        if (entry->detail < POI_MAX) {
            add_to_audit(audits, AUDIT_LOST_AGAIN + entry->detail, entry->count);
        }
        break;
    default:
        break; /* LEDGER_NAME, LEDGER_SETTING and LEDGER_LEFT change no counter. */
    }
}

/* Adds `entry` to the counters. Entries without a row in the table, such as LEDGER_NAME,
 * LEDGER_SETTING and LEDGER_LEFT, change no counter. */
void audits_note(struct audits *audits, const struct ledger_entry *entry)
{
    uint32_t *wrong_pins = &audits->count[AUDIT_WRONG_PINS];
    uint32_t *longest = &audits->count[AUDIT_UP_S_MAX];
    switch (entry->kind) {
    case LEDGER_BEGIN:
        note_begin(audits, entry);
        break;
    case LEDGER_ROUND:
        note_round(audits, entry);
        break;
    case LEDGER_RESET:
        note_reset(audits, entry);
        break;
    case LEDGER_PIN:
        *wrong_pins = entry->detail ? 0u : *wrong_pins;
        add_to_audit(audits, AUDIT_WRONG_PINS, !entry->detail);
        break;
    case LEDGER_HEALTH:
        add_to_audit(audits, AUDIT_TILTS, entry->count);
        add_to_audit(audits, AUDIT_UP_S, (uint32_t)entry->value);
        add_to_audit(audits, AUDIT_DROPPED_TICKS, entry->health.dropped_ticks);
        add_to_audit(audits, AUDIT_DEVICE_FAULTS, entry->health.device_faults);
        *longest = *longest < entry->health.up_s ? entry->health.up_s : *longest;
        break;
    default:
        note_counts(audits, entry);
        break;
    }
}

uint64_t audits_hash(uint64_t hash, const struct audits *audits)
{
    for (uint32_t i = 0; i < AUDIT_FORMAT_7_COUNT; i++) {
        hash = hash_u32(hash, audits->count[i]);
    }
    for (uint32_t i = AUDIT_FORMAT_7_COUNT; i < AUDIT_COUNT; i++) {
        hash = hash_later(hash, i, audits->count[i]);
    }
    return hash;
}
