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

static void append(char out[AUDIT_NAME_SIZE], const char *text)
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
    const char digits[3] = { (char)('0' + number / 10u % 10u), (char)('0' + number % 10u), 0 };
    append(out, number < 10u ? digits + 1 : digits);
}

void audits_name(uint32_t id, char out[AUDIT_NAME_SIZE])
{
    CORE_ASSERT(id < AUDIT_COUNT);
    out[0] = '\0';
    if (id < AUDIT_PLAYS) {
        append(out, names[id]);
    } else if (id < AUDIT_HOUR) {
        append(out, "plays-");
        append(out, rules_of((uint8_t)((id - AUDIT_PLAYS) / AUDIT_GRADES))->name);
        append(out, "-");
        append_number(out, (id - AUDIT_PLAYS) % AUDIT_GRADES + SHEET_GRADE_MIN);
    } else if (id < AUDIT_WEEKDAY) {
        append(out, "hour-");
        append_number(out, id - AUDIT_HOUR);
    } else if (id < AUDIT_BOOTS) {
        append(out, "weekday-");
        append_number(out, id - AUDIT_WEEKDAY + 1u);
    } else {
        append(out, machine_names[id - AUDIT_BOOTS]);
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
    uint32_t *sum = &audits->count[id];
    *sum = UINT32_MAX - *sum < count ? UINT32_MAX : *sum + count;
}

/* ---- Money ---------------------------------------------------------------------------------- */

static void note_coins(struct audits *audits, const struct ledger_entry *entry)
{
    if (entry->detail < COIN_LINE_COUNT) {
        add_to_audit(audits, AUDIT_COINS_1 + entry->detail, entry->count);
    }
    add_to_audit(audits, AUDIT_UNITS, (uint32_t)entry->value);
}

static void note_refund(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_REFUNDS, entry->count);
    add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == REFUND_RESTART);
}

/* ---- Games ----------------------------------------------------------------------------------- */

/* Returns the weekday of `day`, from 0 (Monday) to 6 (Sunday). Day 0, 2000-01-01, is a Saturday. */
static uint32_t weekday_of(uint16_t day)
{
    return (day + 5u) % 7u;
}

static void note_begin(struct audits *audits, const struct ledger_entry *entry)
{
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
        add_to_audit(audits, AUDIT_HOUR + entry->minute / 60u, 1);
        add_to_audit(audits, AUDIT_WEEKDAY + weekday_of(entry->day), 1);
    }
}

static uint32_t seconds(uint32_t ticks)
{
    return (ticks + CORE_TICK_HZ / 2u) / CORE_TICK_HZ;
}

/* Adds one player's result. The lifetime of paper counts only for the first sheet, because a player
 * receives one sheet in scored modes. */
static void note_player(struct audits *audits, const struct round_record *round, uint32_t seat)
{
    const struct player_record *player = &round->player[seat];
    add_to_audit(audits, AUDIT_PLAYERS, 1);
    add_to_audit(audits, AUDIT_PAPERS, player->sheets);
    add_to_audit(audits, AUDIT_FOULS, player->fouls);
    if (player->torn_tick != 0) {
        add_to_audit(audits, AUDIT_PAPERS_TORN, 1);
        add_to_audit(audits, AUDIT_PAPER_LIFE_S, seconds(player->torn_tick - round->start_tick));
    }
}

static void note_round(struct audits *audits, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    add_to_audit(audits, AUDIT_TICKETS, (uint32_t)entry->value);
    add_to_audit(audits, AUDIT_CRASHED_ROUNDS, entry->detail == ROUND_CUT_OFF);
    if (round->by_bot || round->unscored) {
        return;
    }
    add_to_audit(audits, AUDIT_ROUNDS, 1);
    add_to_audit(audits, AUDIT_CAUGHT, round->caught);
    add_to_audit(audits, AUDIT_PLAY_S, seconds(round->end_tick - round->start_tick));
    for (uint32_t seat = 0; seat < POI_MAX; seat++) {
        if (round->players & 1u << seat) {
            note_player(audits, round, seat);
        }
    }
}

/* ---- The machine ---------------------------------------------------------------------------- */

static void note_health(struct audits *audits, const struct ledger_entry *entry)
{
    uint32_t *longest = &audits->count[AUDIT_UP_S_MAX];
    add_to_audit(audits, AUDIT_TILTS, entry->count);
    add_to_audit(audits, AUDIT_UP_S, (uint32_t)entry->value);
    add_to_audit(audits, AUDIT_DROPPED_TICKS, entry->health.dropped_ticks);
    add_to_audit(audits, AUDIT_DEVICE_FAULTS, entry->health.device_faults);
    *longest = *longest < entry->health.up_s ? entry->health.up_s : *longest;
}

static void note_ticket(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_TICKETS_OUT, entry->count);
}

static void note_loss(struct audits *audits, const struct ledger_entry *entry)
{
    if (entry->detail < POI_MAX) {
        add_to_audit(audits, AUDIT_LOST_AGAIN + entry->detail, entry->count);
    }
}

/* Resets a group of counters to 0. AUDIT_RESETS is not reset, but incremented. */
static void note_reset(struct audits *audits, const struct ledger_entry *entry)
{
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        if (id != AUDIT_RESETS && audits_group_of(id) == entry->detail) {
            audits->count[id] = 0;
        }
    }
    add_to_audit(audits, AUDIT_RESETS, 1);
}

static void note_pin(struct audits *audits, const struct ledger_entry *entry)
{
    if (entry->detail) {
        audits->count[AUDIT_WRONG_PINS] = 0;
    } else {
        add_to_audit(audits, AUDIT_WRONG_PINS, 1);
    }
}

/* ---- Selection of the function for each kind of entry ---------------------------------------- */

static void note_boot(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_BOOTS, 1);
    add_to_audit(audits, AUDIT_UNITS, (uint32_t)entry->value);
}

static void note_credits(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_CREDITS_PAID, entry->count);
    add_to_audit(audits, AUDIT_CREDITS_BONUS, (uint32_t)entry->value);
}

static void note_service(struct audits *audits, const struct ledger_entry *entry)
{
    (void)entry;
    add_to_audit(audits, AUDIT_CREDITS_SERVICE, 1);
}

static void note_expired(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_EXPIRED, entry->count);
}

static void note_test_coin(struct audits *audits, const struct ledger_entry *entry)
{
    add_to_audit(audits, AUDIT_TEST_COINS, entry->count);
}

/* Adds `entry` to the counters. Entries without a row in the table, such as LEDGER_NAME,
 * LEDGER_SETTING and LEDGER_LEFT, change no counter. */
void audits_note(struct audits *audits, const struct ledger_entry *entry)
{
    static void (*const note[LEDGER_KIND_COUNT])(struct audits *, const struct ledger_entry *) = {
        [LEDGER_BOOT] = note_boot,       [LEDGER_COINS] = note_coins,
        [LEDGER_CREDITS] = note_credits, [LEDGER_SERVICE] = note_service,
        [LEDGER_BEGIN] = note_begin,     [LEDGER_ROUND] = note_round,
        [LEDGER_REFUND] = note_refund,   [LEDGER_EXPIRED] = note_expired,
        [LEDGER_RESET] = note_reset,     [LEDGER_TEST_COIN] = note_test_coin,
        [LEDGER_HEALTH] = note_health,   [LEDGER_PIN] = note_pin,
        [LEDGER_FACTORY] = note_expired, [LEDGER_LOSS] = note_loss,
        [LEDGER_TICKET] = note_ticket,
    };
    if (entry->kind < LEDGER_KIND_COUNT && note[entry->kind]) {
        note[entry->kind](audits, entry);
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
