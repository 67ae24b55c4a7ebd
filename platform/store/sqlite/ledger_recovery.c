/* ledger_recovery.c -- recovers each entry separately by its id, so that a damaged entry does not
 * affect the next one. */
#include "platform/store/sqlite/ledger_recovery.h"

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"

#define BATCH 64u /* Maximum number of entries in one transaction. */

/* Maximum number of ids that are searched. The number is slightly more than the number of entries
 * in a database. Ids beyond this range do not belong to the ledger. */
#define SALVAGE_MAX (LEDGER_FILE_ENTRIES + 512u)

struct salvage {
    struct ledger_file from;
    struct ledger_file *to;
    const struct ledger_mirror *tail;
    struct ledger_entry entries[BATCH];
    uint32_t count;       /* Number of entries in `entries` that are not yet written. */
    uint32_t first, last; /* Ids of the first and the last entry that the recovery reads. */
    uint32_t newest_id;   /* Newest id that is known to have been assigned to an entry. */
    bool has_from;        /* True if the damaged file has a readable table of entries. */
    bool last_is_newest;  /* True if the id `last` is certainly the newest id of the ledger. False
                             if newer entries may have existed. */
    struct ledger_recovered done;
};

/* ---- Comparison of two ledgers ------------------------------------------------------------- */

enum ledger_relation ledger_recovery_relation(struct ledger_file *file, uint32_t last_id,
                                              const struct ledger_mirror *tail,
                                              struct ledger_file *other)
{
    CORE_ASSERT((tail == NULL) != (other == NULL));
    struct ledger_entry ours, theirs;
    for (uint32_t i = 0; i < LEDGER_MIRROR_SLOTS && i < last_id; i++) {
        const uint32_t id = last_id - i;
        const bool has = tail ? ledger_mirror_entry(tail, id, &theirs)
                              : ledger_file_entry(other, id, &theirs) == SQLITE_OK;
        if (has && ledger_file_entry(file, id, &ours) == SQLITE_OK) {
            return ours.boot == theirs.boot && ours.tick == theirs.tick &&
                           ours.kind == theirs.kind && ours.day == theirs.day &&
                           ours.minute == theirs.minute
                       ? LEDGER_RELATION_SAME
                       : LEDGER_RELATION_OTHER;
        }
    }
    return LEDGER_RELATION_UNKNOWN;
}

static bool has_others_tail(struct salvage *salvage)
{
    const struct ledger_content *content = &salvage->to->content;
    const uint32_t last_id = content->memory.ledger.last_id;
    enum ledger_relation kin = LEDGER_RELATION_UNKNOWN;
    if (salvage->has_from) {
        kin = ledger_recovery_relation(
            &salvage->from, salvage->last_is_newest ? salvage->last : last_id, salvage->tail, NULL);
    }
    if (kin == LEDGER_RELATION_UNKNOWN && salvage->to->db) {
        kin = ledger_recovery_relation(salvage->to, last_id, salvage->tail, NULL);
    }
    /* The mirror belongs to a foreign ledger if it has no common entry with the database and is
     * older than `content`. An empty mirror is accepted. */
    struct ledger_entry newest;
    return kin == LEDGER_RELATION_OTHER ||
           (kin == LEDGER_RELATION_UNKNOWN &&
            !(!ledger_mirror_entry(salvage->tail, ledger_mirror_last_id(salvage->tail), &newest) ||
              newest.boot > content->memory.ledger.boots ||
              (newest.boot == content->memory.ledger.boots && newest.tick >= content->tick)));
}

/* ---- Range of ids -------------------------------------------------------------------------- */

static bool is_readable(struct salvage *salvage, int64_t id)
{
    struct ledger_entry entry;
    return id > 0 && id <= UINT32_MAX &&
           ledger_file_entry(&salvage->from, (uint32_t)id, &entry) == SQLITE_OK;
}

/* Reads the smallest and the largest id of the damaged file, and limits the range to plausible
 * values. */
static void find_range(struct salvage *salvage)
{
    int64_t min = 0, max = 0;
    sqlite3 *db = salvage->from.db;
    const bool has_min = sql_number(db, "SELECT min(id) FROM entries", &min) == SQLITE_OK &&
                         is_readable(salvage, min);
    const bool has_max =
        sql_number(db, "SELECT max(id) FROM entries", &max) == SQLITE_OK && max >= 0;
    if (has_min && min > salvage->first) {
        salvage->first = (uint32_t)min;
    }
    if (has_max && max > (int64_t)salvage->first + SALVAGE_MAX && is_readable(salvage, max)) {
        salvage->first = (uint32_t)max - SALVAGE_MAX;
    }
    salvage->last_is_newest = has_max && max <= (int64_t)salvage->first + SALVAGE_MAX;
    salvage->last = salvage->last_is_newest ? (uint32_t)max : salvage->first + SALVAGE_MAX;
}

/* Extends the range of ids to the end of the mirror. Each entry is written to the mirror before it
 * is acknowledged. If the mirror reaches at least the end of the backup, the last id of the mirror
 * is therefore the newest id. Otherwise the mirror was not written completely. */
static void reach_to_tail(struct salvage *salvage)
{
    const uint32_t last_id = ledger_mirror_last_id(salvage->tail);
    const bool is_empty = salvage->last_is_newest && salvage->last < salvage->first;
    const bool is_newest = last_id > 0 && last_id >= salvage->to->content.memory.ledger.last_id;
    salvage->done.is_open_ended = !is_newest && (is_empty || !salvage->last_is_newest);
    if (salvage->last_is_newest && last_id > salvage->last) {
        const uint32_t span = is_empty ? LEDGER_MIRROR_SLOTS : SALVAGE_MAX;
        salvage->last = last_id;
        if (last_id >= span && salvage->first < last_id - span + 1u) {
            salvage->first = last_id - span + 1u;
        }
    }
    salvage->newest_id = salvage->last_is_newest ? salvage->last : last_id;
}

/* ---- Recovery of entries ------------------------------------------------------------------- */

static int write_salvaged(struct salvage *salvage)
{
    CORE_ASSERT(salvage->count <= BATCH);
    struct ledger_file *to = salvage->to;
    int code = SQLITE_OK;
    if (to->refusal) {
        for (uint32_t i = 0; i < salvage->count; i++) {
            ledger_aggregates_note(&to->content, &salvage->entries[i]);
        }
    } else if (salvage->count > 0) {
        code = ledger_file_write(to, salvage->entries, salvage->count);
    }
    salvage->done.entries += code == SQLITE_OK ? salvage->count : 0u;
    salvage->count = 0;
    return code;
}

int ledger_recover(const char *path, const struct ledger_mirror *tail, struct ledger_file *to,
                   struct ledger_recovered *out)
{
    CORE_ASSERT(tail && out);
    static const struct ledger_mirror none;
    const uint32_t before_id = to->content.memory.ledger.last_id;
    struct salvage salvage = { .from = { .refusal = SQLITE_READONLY },
                               .to = to,
                               .tail = tail,
                               .first = before_id + 1u,
                               .last = before_id,
                               .last_is_newest = true };
    static const char any[] = "SELECT count(*) FROM sqlite_schema WHERE name = 'entries'"
                              " AND type = 'table' AND sql LIKE 'CREATE TABLE%'";
    int64_t has_entries = 0;
    salvage.has_from = path &&
                       sql_open(path, SQLITE_OPEN_READONLY, NULL, &salvage.from.db) == SQLITE_OK &&
                       sql_number(salvage.from.db, any, &has_entries) == SQLITE_OK && has_entries;
    if (salvage.has_from) {
        find_range(&salvage);
    }
    if (has_others_tail(&salvage)) {
        salvage.done.has_others_tail = true;
        salvage.tail = &none;
    }
    reach_to_tail(&salvage);
    int code = SQLITE_OK;
    for (uint32_t id = salvage.first; code == SQLITE_OK && id <= salvage.last; id++) {
        struct ledger_entry *entry = &salvage.entries[salvage.count];
        if (((salvage.has_from && ledger_file_entry(&salvage.from, id, entry) == SQLITE_OK) ||
             ledger_mirror_entry(salvage.tail, id, entry)) &&
            ++salvage.count == BATCH) {
            code = write_salvaged(&salvage);
        }
    }
    code = code == SQLITE_OK ? write_salvaged(&salvage) : code;
    const uint32_t last_id = to->content.memory.ledger.last_id;
    const uint32_t newest_id = salvage.newest_id > last_id ? salvage.newest_id : last_id;
    salvage.done.lost = newest_id - before_id - salvage.done.entries;
    ledger_file_close(&salvage.from);
    *out = salvage.done;
    return code;
}
