/* ledger_backup.c -- SQLite's own way to copy, with a check and a rename behind it. */
#include "platform/store/ledger_backup.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/ledger_parts.h"
#include "platform/store/sql.h"

#define PAGES_A_STEP 64
#define BATCH 64u /* Salvaged entries in one transaction. */

static void name_part(const struct ledger_backup *backup, char out[LEDGER_PATH_SIZE])
{
    snprintf(out, LEDGER_PATH_SIZE, "%.580s" LEDGER_PART_SUFFIX, backup->path);
}

int ledger_sync_folder(const char *path)
{
    char folder[LEDGER_PATH_SIZE];
    snprintf(folder, sizeof folder, "%s", path);
    char *slash = strrchr(folder, '/');
    snprintf(slash ? slash + (slash == folder) : folder, 2, "%s", slash ? "" : ".");
    const int handle = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int result = handle < 0 ? -1 : fsync(handle);
    if (handle >= 0) {
        close(handle);
    }
    return result;
}

/* ---- Copying -------------------------------------------------------------------------------- */

void ledger_backup_drop(struct ledger_backup *backup)
{
    char part[LEDGER_PATH_SIZE];
    name_part(backup, part);
    sqlite3_backup_finish(backup->copy);
    sqlite3_close(backup->to);
    if (backup->path[0]) {
        unlink(part);
    }
    *backup = (struct ledger_backup){ 0 };
}

int ledger_backup_begin(struct ledger_backup *backup, struct ledger_file *from, const char *path)
{
    const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
    char part[LEDGER_PATH_SIZE], journal[LEDGER_PATH_SIZE];
    *backup = (struct ledger_backup){ 0 };
    snprintf(backup->path, sizeof backup->path, "%s", path);
    name_part(backup, part);
    snprintf(journal, sizeof journal, "%.580s-journal", part);
    unlink(journal);
    unlink(part);
    int code = sqlite3_open_v2(part, &backup->to, flags, NULL);
    code = code == SQLITE_OK ? sql_run(backup->to, "PRAGMA cache_size = -256") : code;
    if (code == SQLITE_OK) {
        backup->copy = sqlite3_backup_init(backup->to, "main", from->db, "main");
        code = backup->copy ? SQLITE_OK : sqlite3_errcode(backup->to);
    }
    if (code != SQLITE_OK) {
        ledger_backup_drop(backup);
    }
    return code;
}

static int mark(sqlite3 *db, bool is_marked)
{
    char text[64];
    snprintf(text, sizeof text, "PRAGMA application_id = %d", is_marked ? LEDGER_COPY_MARK : 0);
    return sql_run(db, text);
}

bool ledger_is_marked(struct ledger_file *file)
{
    int64_t id = 0;
    return sql_number(file->db, "PRAGMA application_id", &id) == SQLITE_OK &&
           id == LEDGER_COPY_MARK;
}

int ledger_unmark(struct ledger_file *file)
{
    return mark(file->db, false);
}

/* The copy stands alone: no other file beside it is needed to read it. It is looked through by the
 * same eyes as the file itself, for what is damaged is no backup. */
static int end_copy(struct ledger_backup *backup)
{
    char part[LEDGER_PATH_SIZE];
    name_part(backup, part);
    int code = sqlite3_backup_finish(backup->copy);
    backup->copy = NULL;
    code = code == SQLITE_OK ? sql_run(backup->to, "PRAGMA journal_mode = DELETE") : code;
    code = code == SQLITE_OK ? mark(backup->to, backup->is_marked) : code;
    code = code == SQLITE_OK ? ledger_check(backup->to) : code;
    if (code == SQLITE_OK) {
        sqlite3_close(backup->to);
        backup->to = NULL;
        code = rename(part, backup->path) == 0 && ledger_sync_folder(backup->path) == 0
                   ? SQLITE_DONE
                   : SQLITE_IOERR;
    }
    return code;
}

int ledger_backup_step(struct ledger_backup *backup)
{
    int code = sqlite3_backup_step(backup->copy, PAGES_A_STEP);
    if (code == SQLITE_OK || code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        return code == SQLITE_OK ? SQLITE_OK : SQLITE_BUSY;
    }
    code = code == SQLITE_DONE ? end_copy(backup) : code;
    ledger_backup_drop(backup);
    return code;
}

int ledger_backup_make(struct ledger_file *from, const char *path, bool is_marked)
{
    struct ledger_backup backup;
    int code = ledger_backup_begin(&backup, from, path);
    backup.is_marked = is_marked;
    while (code == SQLITE_OK) {
        code = ledger_backup_step(&backup);
    }
    if (code == SQLITE_BUSY) {
        ledger_backup_drop(&backup);
    }
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

/* ---- What a damaged file still says --------------------------------------------------------- */

/* An id more than a file has after any cleaning: what lies beyond is no id of this list. */
#define SALVAGE_MAX (LEDGER_FILE_ENTRIES + 512u)

struct salvage {
    struct ledger_file from;
    struct ledger_file *to;
    const struct ledger_tail *tail;
    struct ledger_entry entries[BATCH];
    uint32_t count;       /* Of these, not yet written. */
    uint32_t first, last; /* Ids to ask for. */
    bool knows_last;
    struct ledger_salvaged done;
};

static bool reads_well(struct salvage *salvage, int64_t id)
{
    struct ledger_entry entry;
    return id > 0 && id <= UINT32_MAX &&
           ledger_file_entry(&salvage->from, (uint32_t)id, &entry) == SQLITE_OK;
}

/* What the damaged file says about its ends is believed as far as it can be true. */
static void find_ends(struct salvage *salvage)
{
    int64_t min = 0, max = 0;
    sqlite3 *db = salvage->from.db;
    const bool has_min = sql_number(db, "SELECT min(id) FROM entries", &min) == SQLITE_OK &&
                         reads_well(salvage, min);
    const bool has_max = sql_number(db, "SELECT max(id) FROM entries", &max) == SQLITE_OK;
    salvage->first = salvage->to->content.memory.ledger.last_id + 1u;
    if (has_min && min > salvage->first) {
        salvage->first = (uint32_t)min;
    }
    if (has_max && max > (int64_t)salvage->first + SALVAGE_MAX && reads_well(salvage, max)) {
        salvage->first = (uint32_t)max - SALVAGE_MAX;
    }
    salvage->knows_last = has_max && max <= (int64_t)salvage->first + SALVAGE_MAX;
    salvage->last = salvage->knows_last ? (uint32_t)max : salvage->first + SALVAGE_MAX;
}

/* The tail goes on where the file ends, or is all that there is. */
static void reach_to_tail(struct salvage *salvage)
{
    const uint32_t last_id = ledger_tail_last_id(salvage->tail);
    if (salvage->knows_last && last_id > salvage->last) {
        const bool is_empty = salvage->last < salvage->first;
        const uint32_t span = is_empty ? LEDGER_TAIL_SLOTS : SALVAGE_MAX;
        salvage->last = last_id;
        if (last_id >= span && salvage->first < last_id - span + 1u) {
            salvage->first = last_id - span + 1u;
        }
    }
}

static bool read_either(struct salvage *salvage, uint32_t id, struct ledger_entry *out)
{
    return (salvage->from.db && ledger_file_entry(&salvage->from, id, out) == SQLITE_OK) ||
           ledger_tail_entry(salvage->tail, id, out);
}

static int write_salvaged(struct salvage *salvage)
{
    const int code = salvage->count > 0
                         ? ledger_file_write(salvage->to, salvage->entries, salvage->count)
                         : SQLITE_OK;
    salvage->done.entries += code == SQLITE_OK ? salvage->count : 0u;
    salvage->count = 0;
    return code;
}

/* Each is asked for by its id, so that what is in the way of one is not in the way of the next. */
static void salvage_entries(struct salvage *salvage)
{
    uint32_t missing = 0;
    int code = SQLITE_OK;
    for (uint32_t id = salvage->first; code == SQLITE_OK && id <= salvage->last; id++) {
        if (!read_either(salvage, id, &salvage->entries[salvage->count])) {
            missing++;
            continue;
        }
        salvage->done.lost += missing;
        missing = 0;
        if (++salvage->count == BATCH) {
            code = write_salvaged(salvage);
        }
    }
    write_salvaged(salvage);
    salvage->done.lost += salvage->knows_last ? missing : 0u;
}

struct ledger_salvaged ledger_salvage(const char *path, const struct ledger_tail *tail,
                                      struct ledger_file *to)
{
    static const char any[] = "SELECT count(*) FROM sqlite_schema WHERE name = 'entries'";
    const uint32_t newest_id = to->content.memory.ledger.last_id;
    struct salvage salvage = { .from = { .refusal = SQLITE_READONLY }, .to = to, .tail = tail,
                               .first = newest_id + 1u, .last = newest_id, .knows_last = true };
    int64_t has_entries = 0;
    const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX;
    if (path && sqlite3_open_v2(path, &salvage.from.db, flags, NULL) == SQLITE_OK &&
        sql_number(salvage.from.db, any, &has_entries) == SQLITE_OK && has_entries) {
        find_ends(&salvage);
    }
    reach_to_tail(&salvage);
    salvage_entries(&salvage);
    ledger_file_close(&salvage.from);
    return salvage.done;
}
