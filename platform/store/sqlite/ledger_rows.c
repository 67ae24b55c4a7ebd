/* ledger_rows.c -- writes one ledger entry to rows and reads it back. */
#include <string.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* A new field of struct balance also needs a column (ledger_schema.c), code in this file, and a
 * term in entry_sum(). */
_Static_assert(sizeof(struct balance) == 24, "a field of the purse is not kept");
_Static_assert(sizeof(struct health) == 12, "a field of the health is not kept");
_Static_assert(sizeof(struct player_record) == 24, "a field of the player's record is not kept");

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

/* The column `open` contains three fields of the balance: `open` in the low 8 bits, `returned`
 * shifted by RETURNED_SHIFT, and `tickets` shifted by TICKETS_SHIFT. Older files have 0 in the
 * upper two fields, so that their rows and checksums remain valid. */
#define RETURNED_SHIFT 8u
#define TICKETS_SHIFT 16u

static uint32_t pack_open(const struct balance *balance)
{
    return balance->open | (uint32_t)balance->returned << RETURNED_SHIFT |
           (uint32_t)balance->tickets << TICKETS_SHIFT;
}

/* ---- Checksum ------------------------------------------------------------------------------ */

static uint64_t hash_words(uint64_t hash, const uint32_t *words, int count)
{
    for (int i = 0; i < count; i++) {
        hash = hash_u32(hash, words[i]);
    }
    return hash;
}

static uint64_t round_sum(uint64_t sum, const struct round_record *round)
{
    const uint32_t words[] = { round->seed,   round->start_tick, round->end_tick,
                               round->caught, round->by_bot,     round->mode,
                               round->grade,  round->players,    round->unscored };
    const uint32_t stall[] = { round->fish_count, round->round_s, round->preset };
    sum = hash_words(sum, words, COUNT(words));
    sum = round->fish_count > 0 ? hash_words(sum, stall, COUNT(stall)) : sum;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player_record *player = &round->player[i];
        const uint32_t own[] = { player->caught,    player->scoops, player->hole_area_mm2,
                                 player->torn_tick, player->sheets, player->fouls };
        sum = round->players >> i & 1u ? hash_words(sum, own, COUNT(own)) : sum;
    }
    return sum;
}

/* Returns the checksum of an entry. The checksum is needed because SQLite detects an incompletely
 * written page but not a flipped bit. */
static int64_t entry_sum(const struct ledger_entry *entry)
{
    const struct balance *balance = &entry->balance;
    const struct health *health = &entry->health;
    const uint32_t words[] = {
        entry->id,        entry->boot,           entry->tick,
        entry->day,       entry->minute,         entry->kind,
        entry->detail,    entry->count,          (uint32_t)entry->value,
        balance->units,   balance->bonus_units,  balance->paid,
        balance->service, balance->unlogged,     pack_open(balance),
        health->up_s,     health->dropped_ticks, health->device_faults,
    };
    const uint64_t sum = hash_words(HASH_START, words, COUNT(words));
    return (int64_t)(entry->kind == LEDGER_ROUND ? round_sum(sum, &entry->round) : sum);
}

/* ---- Writing ------------------------------------------------------------------------------- */

static int put_entry(struct ledger_file *file, const struct ledger_entry *entry)
{
    const struct balance *balance = &entry->balance;
    const struct health *health = &entry->health;
    const int64_t values[] = {
        entry->id,        entry->boot,           entry->tick,
        entry->day,       entry->minute,         entry->kind,
        entry->detail,    entry->count,          entry->value,
        balance->units,   balance->bonus_units,  balance->paid,
        balance->service, balance->unlogged,     pack_open(balance),
        health->up_s,     health->dropped_ticks, health->device_faults,
        entry_sum(entry),
    };
    sqlite3_stmt *put = NULL;
    const int code = ledger_statement(file, PUT_ENTRY, &put);
    if (code != SQLITE_OK) {
        return code;
    }
    const int name_size = (int)strnlen(entry->name, sizeof entry->name);
    sqlite3_bind_text(put, COUNT(values) + 1, entry->name, name_size, SQLITE_STATIC);
    return sql_put_one(put, values, COUNT(values));
}

/* Stores a player's name. An empty name revokes the player's earlier names. Revoked names are also
 * erased in the entries of the ledger. Returns an SQLite code. */
static int put_name(struct ledger_file *file, const struct ledger_entry *entry)
{
    const int64_t whose[] = { entry->count, entry->detail, LEDGER_NAME };
    sqlite3_stmt *put = NULL, *forget = NULL;
    int code = ledger_statement(file, PUT_NAME, &put);
    if (code == SQLITE_OK) {
        const int size = (int)strnlen(entry->name, sizeof entry->name);
        sqlite3_bind_text(put, 3, entry->name, size, SQLITE_STATIC);
        code = sql_put(put, whose, 2);
    }
    if (code == SQLITE_OK && !entry->name[0]) {
        code = ledger_statement(file, FORGET_NAME, &forget);
        code = code == SQLITE_OK ? sql_put(forget, whose, 3) : code;
    }
    return code;
}

int ledger_rows_put_value(struct ledger_file *file, const struct ledger_entry *entry)
{
    const int64_t values[] = { entry->value, entry_sum(entry), entry->id };
    sqlite3_stmt *put = NULL;
    int code = sqlite3_prepare_v2(file->db, "UPDATE entries SET value = ?1, sum = ?2 WHERE id = ?3",
                                  -1, &put, NULL);
    code = code == SQLITE_OK ? sql_put_one(put, values, COUNT(values)) : code;
    sqlite3_finalize(put);
    return code;
}

int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->id > 0);
    int code = put_entry(file, entry);
    if (code == SQLITE_OK && entry->kind == LEDGER_ROUND) {
        const struct round_record *round = &entry->round;
        const int64_t values[] = { entry->id,       entry->boot,       entry->day,
                                   entry->minute,   round->seed,       round->start_tick,
                                   round->end_tick, round->caught,     round->by_bot,
                                   round->mode,     round->grade,      round->players,
                                   round->unscored, round->fish_count, round->round_s,
                                   round->preset };
        sqlite3_stmt *put = NULL;
        code = ledger_statement(file, PUT_ROUND, &put);
        code = code == SQLITE_OK ? sql_put_one(put, values, COUNT(values)) : code;
        if (code == SQLITE_OK) {
            sqlite3_stmt *put_player = NULL;
            code = ledger_statement(file, PUT_PLAYER, &put_player);
            for (uint32_t i = 0; code == SQLITE_OK && i < POI_MAX; i++) {
                const struct player_record *player = &entry->round.player[i];
                const int64_t columns[] = { entry->id,
                                            i,
                                            player->caught,
                                            player->scoops,
                                            player->hole_area_mm2,
                                            player->torn_tick,
                                            player->sheets,
                                            player->fouls };
                if (entry->round.players >> i & 1u) {
                    code = sql_put_one(put_player, columns, COUNT(columns));
                }
            }
        }
    } else if (code == SQLITE_OK && entry->kind == LEDGER_NAME) {
        code = put_name(file, entry);
    }
    return code;
}

/* ---- Reading ------------------------------------------------------------------------------- */

static uint32_t column_u32(sqlite3_stmt *row, int column)
{
    return sql_uint(row, column, UINT32_MAX);
}

static uint8_t column_u8(sqlite3_stmt *row, int column)
{
    return (uint8_t)sql_uint(row, column, UINT8_MAX);
}

static struct ledger_entry entry_of(sqlite3_stmt *row)
{
    const uint32_t open = column_u32(row, 14);
    struct ledger_entry entry = {
        .id = column_u32(row, 0),
        .boot = column_u32(row, 1),
        .tick = column_u32(row, 2),
        .day = (uint16_t)sql_uint(row, 3, UINT16_MAX),
        .minute = (uint16_t)sql_uint(row, 4, UINT16_MAX),
        .kind = column_u8(row, 5),
        .detail = column_u8(row, 6),
        .count = column_u32(row, 7),
        .value = (int32_t)sqlite3_column_int64(row, 8),
        .balance = { column_u32(row, 9), column_u32(row, 10), column_u32(row, 11),
                     column_u32(row, 12), column_u32(row, 13), (uint8_t)open,
                     (uint8_t)(open >> RETURNED_SHIFT), (uint16_t)(open >> TICKETS_SHIFT) },
        .health = { column_u32(row, 15), column_u32(row, 16), column_u32(row, 17) },
    };
    sql_text(row, 18, entry.name, sizeof entry.name);
    return entry;
}

#define ROUND_COLUMNS                                                                              \
    "SELECT seed, start_tick, end_tick, caught, by_bot, mode, grade, players, unscored, "
#define ROUND_OF " FROM rounds WHERE entry = ?"

/* Reads a round. A recovered file may have version 3, which lacks the columns fish_count, round_s
 * and preset. */
static int read_round(struct ledger_file *file, uint32_t id, struct round_record *round)
{
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(file->db, ROUND_COLUMNS "fish_count, round_s, preset" ROUND_OF,
                                  -1, &row, NULL);
    if (code == SQLITE_ERROR) {
        code = sqlite3_prepare_v2(file->db, ROUND_COLUMNS "0, 0, 0" ROUND_OF, -1, &row, NULL);
    }
    sqlite3_bind_int64(row, 1, id);
    code = code == SQLITE_OK ? sqlite3_step(row) : code;
    if (code == SQLITE_ROW) {
        *round = (struct round_record){
            .id = id,
            .seed = column_u32(row, 0),
            .start_tick = column_u32(row, 1),
            .end_tick = column_u32(row, 2),
            .caught = column_u32(row, 3),
            .by_bot = column_u8(row, 4),
            .mode = column_u8(row, 5),
            .grade = column_u8(row, 6),
            .players = column_u8(row, 7),
            .unscored = column_u8(row, 8),
            .fish_count = (uint16_t)sql_uint(row, 9, UINT16_MAX),
            .round_s = (uint16_t)sql_uint(row, 10, UINT16_MAX),
            .preset = column_u8(row, 11),
        };
        code = SQLITE_DONE;
    }
    return sql_end(row, code);
}

#define ENTRY_COLUMNS                                                                              \
    "SELECT id, boot, tick, day, minute, kind, detail, count, value, units, bonus_units, paid,"    \
    " service, untold, open, up_s, dropped_ticks, device_faults, name, sum FROM entries "

static int find_entry(struct ledger_file *file, const char *text, uint32_t id,
                      struct ledger_entry *out)
{
    CORE_ASSERT(file->db);
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(file->db, text, -1, &row, NULL);
    sqlite3_bind_int64(row, 1, id);
    code = code == SQLITE_OK ? sqlite3_step(row) : code;
    if (code == SQLITE_ROW) {
        *out = entry_of(row);
        const int64_t sum = sqlite3_column_int64(row, 19);
        code = SQLITE_OK;
        if (out->kind == LEDGER_ROUND) {
            code = read_round(file, out->id, &out->round);
            if (code == SQLITE_OK) {
                sqlite3_stmt *player = NULL;
                code = sqlite3_prepare_v2(
                    file->db,
                    "SELECT seat, caught, scoops, hole_area_mm2, torn_tick, sheets,"
                    " fouls FROM round_players WHERE round = ?",
                    -1, &player, NULL);
                sqlite3_bind_int64(player, 1, out->id);
                while ((code == SQLITE_OK || code == SQLITE_ROW) &&
                       (code = sqlite3_step(player)) == SQLITE_ROW) {
                    const uint32_t seat = column_u32(player, 0);
                    if (seat < POI_MAX) {
                        out->round.player[seat] = (struct player_record){
                            column_u32(player, 1), column_u32(player, 2), column_u32(player, 3),
                            column_u32(player, 4), column_u32(player, 5), column_u8(player, 6),
                        };
                    }
                }
                code = sql_end(player, code);
            }
        }
        code = code == SQLITE_OK && (entry_sum(out) != sum || !ledger_entry_is_valid(out))
                   ? SQLITE_CORRUPT
                   : code;
    } else if (code == SQLITE_DONE) {
        code = SQLITE_NOTFOUND;
    }
    sqlite3_finalize(row);
    return code;
}

int ledger_rows_newest(struct ledger_file *file, struct ledger_entry *out)
{
    return find_entry(file, ENTRY_COLUMNS "WHERE id >= ?1 ORDER BY id DESC LIMIT 1", 0, out);
}

/* Reads the newest entry that records the start or the state of an open round. */
int ledger_rows_state(struct ledger_file *file, struct ledger_stand *out)
{
    _Static_assert(LEDGER_BEGIN == 4 && LEDGER_STAND == 17, "the kinds of the statement");
    struct ledger_entry entry;
    const int code = find_entry(
        file, ENTRY_COLUMNS "WHERE id >= ?1 AND kind IN (4, 17) ORDER BY id DESC LIMIT 1", 0,
        &entry);
    *out = code == SQLITE_OK ? round_standing_after((struct ledger_stand){ 0 }, &entry)
                             : (struct ledger_stand){ 0 };
    return code == SQLITE_NOTFOUND ? SQLITE_OK : code;
}

int ledger_file_entry(struct ledger_file *file, uint32_t id, struct ledger_entry *out)
{
    return find_entry(file, ENTRY_COLUMNS "WHERE id = ?1", id, out);
}

void ledger_file_round(struct ledger_file *file, uint32_t id, struct ledger_entry *out)
{
    *out = (struct ledger_entry){ 0 };
    const int code = ledger_file_entry(file, id, out);
    if (code != SQLITE_OK) {
        *out = (struct ledger_entry){ .id = code == SQLITE_NOTFOUND ? 0u : id };
    }
}
