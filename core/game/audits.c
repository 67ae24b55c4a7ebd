/* audits.c -- what each kind of entry adds to. */
#include "core/game/audits.h"

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
    [AUDIT_PLAYERS] = "players",
    [AUDIT_CAUGHT] = "caught",
    [AUDIT_PLAY_S] = "play-seconds",
    [AUDIT_PAPERS] = "papers",
    [AUDIT_PAPERS_TORN] = "papers-torn",
    [AUDIT_PAPER_LIFE_S] = "paper-life-seconds",
    [AUDIT_FOULS] = "fouls",
};

static const char *const machine_names[AUDIT_COUNT - AUDIT_BOOTS] = {
    "boots", "crashed-rounds", "dropped-ticks", "device-faults", "up-seconds", "up-seconds-longest",
    "resets",
};

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

void audit_name(uint32_t id, char out[AUDIT_NAME_SIZE])
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

enum audit_group audit_group_of(uint32_t id)
{
    CORE_ASSERT(id < AUDIT_COUNT);
    return id < AUDIT_PLAYS_PAID ? AUDIT_GROUP_MONEY
           : id < AUDIT_BOOTS    ? AUDIT_GROUP_PLAY
                                 : AUDIT_GROUP_MACHINE;
}

static void add(struct audits *audits, uint32_t id, uint32_t count)
{
    uint32_t *sum = &audits->count[id];
    *sum = UINT32_MAX - *sum < count ? UINT32_MAX : *sum + count;
}

static void note_round(struct audits *audits, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    add(audits, AUDIT_CAUGHT, round->caught);
    add(audits, AUDIT_PLAY_S, (round->end_tick - round->start_tick) / CORE_TICK_HZ);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (round->players & 1u << i) {
            add(audits, AUDIT_PLAYERS, 1);
            add(audits, AUDIT_PAPERS, round->player[i].sheets);
            add(audits, AUDIT_FOULS, round->player[i].fouls);
        }
    }
}

void audits_note(struct audits *audits, const struct ledger_entry *entry)
{
    if (entry->kind == LEDGER_ROUND) {
        note_round(audits, entry);
    }
}

uint64_t audits_hash(uint64_t hash, const struct audits *audits)
{
    for (uint32_t i = 0; i < AUDIT_COUNT; i++) {
        hash = hash_u32(hash, audits->count[i]);
    }
    return hash;
}
