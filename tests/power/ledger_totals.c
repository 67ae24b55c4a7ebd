/* ledger_totals.c -- computes the totals of ledger entries without the code of the store, and
 * compares them with the totals that the store loads. */
#include "tests/power/ledger_totals.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "core/game/accounting/accounts.h"
#include "core/game/game_fields.h"
#include "tests/power/hour.h"

void ledger_totals_open(struct ledger_totals *totals)
{
    memset(totals, 0, sizeof *totals);
    settings_reset(&totals->settings);
}

void ledger_totals_add(struct ledger_totals *totals, const struct ledger_entry *entry)
{
    totals->coins += entry->kind == LEDGER_COINS ? entry->count : 0u;
    totals->services += entry->kind == LEDGER_SERVICE;
    totals->refunds += entry->kind == LEDGER_REFUND ? entry->count : 0u;
    if (entry->kind == LEDGER_ROUND) {
        totals->rounds++;
        totals->caught += entry->round.caught;
    }
    if (entry->kind == LEDGER_SETTING) {
        totals->settings.value[entry->detail | entry->count << 8] = entry->value;
    }
    totals->balance = entry->balance;
    totals->stand = round_standing_after(totals->stand, entry);
    audits_note(&totals->audits, entry);
    ranking_note(&totals->ranking, entry);
}

/* ---- Reading the database without the store ------------------------------------------------- */

static int64_t query_number(sqlite3 *db, const char *query, int *code)
{
    sqlite3_stmt *statement = NULL;
    int64_t answer = -1;
    if (*code == SQLITE_OK) {
        *code = sqlite3_prepare_v2(db, query, -1, &statement, NULL);
    }
    if (*code == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW) {
        answer = sqlite3_column_int64(statement, 0);
    }
    sqlite3_finalize(statement);
    return answer;
}

static void read_integrity(sqlite3 *db, char out[64], int *code)
{
    sqlite3_stmt *statement = NULL;
    snprintf(out, 64, "no answer");
    if (*code == SQLITE_OK) {
        *code = sqlite3_prepare_v2(db, "PRAGMA integrity_check", -1, &statement, NULL);
    }
    if (*code == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW) {
        snprintf(out, 64, "%s", (const char *)sqlite3_column_text(statement, 0));
    }
    sqlite3_finalize(statement);
}

static bool is_replay_of(uint32_t round_id, const void *bytes, size_t size)
{
    static uint8_t whole[HOUR_REPLAY_MAX];
    const size_t length = hour_replay(round_id, whole);
    return length == size && memcmp(whole, bytes, size) == 0;
}

static void read_replays(sqlite3 *db, uint32_t replay_id, struct ledger_totals_file *out, int *code)
{
    sqlite3_stmt *statement = NULL;
    if (*code == SQLITE_OK) {
        *code = sqlite3_prepare_v2(db, "SELECT round, bytes FROM replays", -1, &statement, NULL);
    }
    while (*code == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW) {
        const uint32_t id = (uint32_t)sqlite3_column_int64(statement, 0);
        const void *bytes = sqlite3_column_blob(statement, 1);
        out->replays++;
        out->has_replay |= id == replay_id;
        out->bad_replays += !is_replay_of(id, bytes, (size_t)sqlite3_column_bytes(statement, 1));
    }
    sqlite3_finalize(statement);
}

int ledger_totals_read(const char *path, uint32_t replay_id, struct ledger_totals_file *out)
{
    sqlite3 *db = NULL;
    memset(out, 0, sizeof *out);
    int code = sqlite3_open_v2(path, &db, SQLITE_OPEN_READWRITE, NULL);
    read_integrity(db, out->integrity, &code);
    out->rounds = query_number(db, "SELECT count(*) FROM rounds", &code);
    out->caught = query_number(db, "SELECT coalesce(sum(caught), 0) FROM rounds", &code);
    out->doubled = query_number(db, "SELECT count(*) - count(DISTINCT entry) FROM rounds", &code);
    read_replays(db, replay_id, out, &code);
    sqlite3_close(db);
    return code;
}

/* ---- Comparing the totals ------------------------------------------------------------------- */

static int differs(char why[LEDGER_TOTALS_WHY_SIZE], const char *what, int64_t is, int64_t should)
{
    if (is == should) {
        return 0;
    }
    snprintf(why, LEDGER_TOTALS_WHY_SIZE, "%s: %lld, and %lld were reported", what, (long long)is,
             (long long)should);
    return 1;
}

static int balance_differs(char why[LEDGER_TOTALS_WHY_SIZE], const struct balance *is,
                           const struct balance *should)
{
    return differs(why, "credits that were paid", is->paid, should->paid) ||
           differs(why, "credits by SERVICE", is->service, should->service) ||
           differs(why, "units", is->units, should->units) ||
           differs(why, "units towards the bonus", is->bonus_units, should->bonus_units) ||
           differs(why, "untold units", is->unlogged, should->unlogged) ||
           differs(why, "the credit that came back", is->returned, should->returned) ||
           differs(why, "tickets that are owed", is->tickets, should->tickets) ||
           differs(why, "the open round", is->open, should->open);
}

static int round_differs(char why[LEDGER_TOTALS_WHY_SIZE], const struct ledger_stand *is,
                         const struct ledger_stand *should)
{
    return differs(why, "the catch of the open round", is->count, should->count) ||
           differs(why, "the tickets of the open round", is->value, should->value) ||
           differs(why, "the mode of the open round", is->detail, should->detail);
}

static int sums_differ(char why[LEDGER_TOTALS_WHY_SIZE], const struct ledger_totals *totals,
                       const struct audits *audits)
{
    char name[AUDIT_NAME_SIZE];
    const uint32_t *count = audits->count;
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        audits_name(id, name);
        if (differs(why, name, count[id], totals->audits.count[id])) {
            return 1;
        }
    }
    return differs(why, "coins", count[AUDIT_COINS_1], totals->coins) ||
           differs(why, "services", count[AUDIT_CREDITS_SERVICE], totals->services) ||
           differs(why, "refunds", count[AUDIT_REFUNDS], totals->refunds) ||
           differs(why, "fish", count[AUDIT_CAUGHT], totals->caught);
}

static int settings_differ(char why[LEDGER_TOTALS_WHY_SIZE], const struct settings *is,
                           const struct settings *should)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (differs(why, settings_entry(id)->name, is->value[id], should->value[id])) {
            return 1;
        }
    }
    return 0;
}

static int ranking_differs(char why[LEDGER_TOTALS_WHY_SIZE], const struct ranking *is,
                           const struct ranking *should)
{
    if (field_hash(0, &ranking_fields, is) == field_hash(0, &ranking_fields, should)) {
        return 0;
    }
    snprintf(why, LEDGER_TOTALS_WHY_SIZE, "the ranking is another one");
    return 1;
}

static int file_differs(char why[LEDGER_TOTALS_WHY_SIZE], const struct ledger_totals_file *is,
                        const struct ledger_totals *should)
{
    if (strcmp(is->integrity, "ok") != 0) {
        snprintf(why, LEDGER_TOTALS_WHY_SIZE, "integrity: %.60s", is->integrity);
        return 1;
    }
    return differs(why, "rounds", is->rounds, should->rounds) ||
           differs(why, "fish in rounds", is->caught, should->caught) ||
           differs(why, "rounds that are there twice", is->doubled, 0) ||
           differs(why, "replays that are not their round's", is->bad_replays, 0);
}

int ledger_totals_agree(const struct ledger_totals *totals, const struct persistent_state *memory,
                        const struct ledger_totals_file *file, char why[LEDGER_TOTALS_WHY_SIZE])
{
    const int differ = balance_differs(why, &memory->ledger.balance, &totals->balance) ||
                       round_differs(why, &memory->ledger.stand, &totals->stand) ||
                       sums_differ(why, totals, &memory->audits) ||
                       settings_differ(why, &memory->settings, &totals->settings) ||
                       ranking_differs(why, &memory->ranking, &totals->ranking) ||
                       file_differs(why, file, totals);
    return differ ? -1 : 0;
}
