/* doctor_store.c -- checks the data folder, the database and the stored controller mappings. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <time.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_mapping.h"
#include "platform/ctl/doctor/doctor.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/storage.h"
#include "platform/system_health.h"

/* Free space in MiB below which `kingyoctl doctor` prints a warning. The space is enough for two
 * copies of a database that contains a replay of each ranked round. */
#define ROOM_MIB 64u
#define PATH_ROOM (OPTIONS_PATH_MAX + 400u)

/* ---- Data folder ----------------------------------------------------------------------------- */

static void check_room(struct doctor *doctor, const char *path)
{
    struct statvfs about;
    if (statvfs(path, &about) == 0) {
        const uint64_t mib = (uint64_t)about.f_bavail * about.f_frsize / 1048576u;
        const bool is_low = mib < ROOM_MIB;
        struct doctor_finding *finding =
            doctor_find(doctor, "store", is_low ? DOCTOR_CHECK : DOCTOR_FINE, "room");
        doctor_state(finding, "%" PRIu64 " MiB are free", mib);
        if (is_low) {
            doctor_todo(finding, "free space on the card: %u MiB at least", ROOM_MIB);
        }
    }
}

/* Adds a finding for the data folder. Returns 0 if the kiosk's user may use the folder, otherwise
 * an errno. */
static int check_folder(struct doctor *doctor, const char *path)
{
    struct statvfs mount;
    /* The mode bits of a folder do not show whether its file system is mounted read-only. */
    const int error = statvfs(path, &mount) == 0 && (mount.f_flag & ST_RDONLY) != 0
                          ? EROFS
                          : doctor_access_error(doctor, doctor->options.data);
    struct doctor_finding *finding = doctor_find(doctor, "store", DOCTOR_FINE, "%s", path);
    if (error == ENOENT) {
        doctor_state(finding,
                     "does not exist yet: the kiosk creates the folder at its first start");
    } else if (error == EROFS) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "is mounted read-only: the kiosk saves nothing and accepts no coin");
        doctor_todo(finding,
                    "see /run/kingyo-data and 'findmnt %.300s'; replace a card that became "
                    "read-only by itself",
                    doctor->options.data);
    } else if (error) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%s may not write there: %s", doctor->user.name, strerror(error));
        doctor_todo(finding, "sudo chown -R %s '%.400s'", doctor->user.name, doctor->options.data);
    } else {
        doctor_state(finding, "%s may write there", doctor->user.name);
    }
    return error;
}

/* ---- Database -------------------------------------------------------------------------------- */

/* Age in hours above which `kingyoctl doctor` reports a backup as old. The kiosk makes a backup at
 * each program start and every hour. */
#define BACKUP_OLD_H 48

static int64_t count_of(struct ledger_file *file, const char *sql)
{
    int64_t count = 0;
    return sql_number(file->db, sql, &count) == SQLITE_OK ? count : 0;
}

/* States why the database is damaged. Names a trigger, a table or another object that is not
 * Kingyo's, because the operator cannot guess it from SQLite's error text. */
static void report_damage(struct doctor_finding *finding, int code, const char *path)
{
    struct ledger_foreign foreign;
    sqlite3 *db = NULL;
    if (sql_open(path, SQLITE_OPEN_READONLY, NULL, &db) == SQLITE_OK &&
        ledger_schema_foreign(db, &foreign)) {
        doctor_state(finding, "damaged: holds the %s '%.60s', %s", foreign.type, foreign.name,
                     ledger_foreign_reason(&foreign));
    } else {
        doctor_state(finding, "damaged: %.200s", ledger_file_error(code));
    }
    sqlite3_close(db);
    doctor_todo(finding, "restart the kiosk: it renames the file and continues from the "
                         "backup and the entries that can still be read");
}

static void report_open_error(struct doctor *doctor, struct doctor_finding *finding, int code,
                              const char *path)
{
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        doctor_state(finding, "another program is writing to the database");
        return;
    }
    if (code == SQLITE_SCHEMA) {
        doctor_state(finding,
                     "of an earlier version: the kiosk updates the database at its next start");
        return;
    }
    finding->level = DOCTOR_WRONG;
    if (code == LEDGER_FILE_NEWER) {
        doctor_state(finding,
                     "a later version of Kingyo wrote the database: this version saves nothing");
        doctor_todo(finding, "install the later version again, or replace the file with a backup");
    } else if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
        report_damage(finding, code, path);
    } else {
        doctor_state(finding, "cannot be opened: %.200s", ledger_file_error(code));
        doctor_todo(finding, "sudo chown %s '%s'", doctor->user.name, path);
    }
}

static void check_database(struct doctor *doctor, const char *folder)
{
    char path[PATH_ROOM];
    struct stat about;
    struct ledger_file file;
    CORE_ASSERT(folder[0]);
    snprintf(path, sizeof path, "%s/%s", folder, STORAGE_FILE);
    struct doctor_finding *finding = doctor_find(doctor, "database", DOCTOR_FINE, "%s", path);
    if (lstat(path, &about)) {
        doctor_state(finding, "does not exist yet: the kiosk has saved nothing");
        return;
    }
    const int error = file_type_error(path);
    if (error) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%s%s", file_error(error),
                     error == ELOOP ? ": the kiosk does not follow it, and saves nothing" : "");
        doctor_todo(finding, "%s",
                    error == ELOOP
                        ? "move the database itself to this path; --data names another folder"
                        : "restart the kiosk: it renames the object and continues from the backup");
        return;
    }
    int code = ledger_file_inspect(&file, path);
    code = code == SQLITE_OK ? ledger_check(file.db) : code;
    if (code == SQLITE_OK) {
        const struct ledger_start *ledger = &file.content.memory.ledger;
        doctor_state(finding,
                     "whole, version %d: %u entries of %u starts, %" PRId64 " rounds, %" PRId64
                     " replays",
                     LEDGER_FILE_VERSION, ledger->last_id, ledger->boots,
                     count_of(&file, "SELECT count(*) FROM rounds"),
                     count_of(&file, "SELECT count(*) FROM replays"));
    } else {
        report_open_error(doctor, finding, code, path);
    }
    ledger_file_close(&file);
}

static void check_backup(struct doctor *doctor, const char *folder)
{
    char path[PATH_ROOM];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", folder, STORAGE_FILE STORAGE_BACKUP_SUFFIX);
    if (lstat(path, &about)) {
        return; /* A missing backup gives no finding, because a kiosk that has never run has no
                   backup. */
    }
    const int error = file_type_error(path);
    if (error) {
        struct doctor_finding *other = doctor_find(doctor, "backup", DOCTOR_CHECK, "%s", path);
        doctor_state(other, "%s", file_error(error));
        doctor_todo(other, "restart the kiosk: it renames the object and makes a new backup");
        return;
    }
    const int64_t hours = ((int64_t)time(NULL) - about.st_mtime) / 3600;
    struct doctor_finding *finding = doctor_find(
        doctor, "backup", hours < BACKUP_OLD_H ? DOCTOR_FINE : DOCTOR_CHECK, "%s", path);
    doctor_state(finding, "%" PRId64 " h old, %" PRId64 " KiB", hours,
                 (int64_t)about.st_size / 1024);
    if (hours >= BACKUP_OLD_H) {
        doctor_todo(
            finding,
            "nothing, if the kiosk was closed for this time; otherwise free space on the card "
            "and check the log of the kiosk");
    }
}

static const struct {
    const char *state, *todo;
} quarantines[] = {
    [SYSTEM_HEALTH_QUARANTINE_DAMAGED] = { "was damaged, and was renamed",
                                           "compare the audits (kingyoctl audits) with the meter, "
                                           "then remove the file. If there are several, replace "
                                           "the card" },
    [SYSTEM_HEALTH_QUARANTINE_MISSING] = { "kingyo.db was missing, and was created from what could "
                                           "be read",
                                           "compare the audits (kingyoctl audits) with the meter, "
                                           "then remove this note" },
    [SYSTEM_HEALTH_QUARANTINE_LEFT] = { "is the database from before a start that left out a part "
                                        "because of panics",
                                        "send the log and panic-*.kgr; kingyoctl backup --restore "
                                        "restores this database. Then remove the file" },
    [SYSTEM_HEALTH_QUARANTINE_OTHER] = { "belongs to another database or is not a regular file, "
                                         "and was renamed",
                                         "remove the file, or move it back to the kingyo.db to "
                                         "which it belongs" },
};

/* Adds a finding for each quarantined file, a damaged file that the kiosk renamed. A quarantined
 * file stays in the data folder until the operator deletes it. */
static void check_damaged(struct doctor *doctor, const char *folder)
{
    static struct doctor_names names;
    doctor_list(doctor, doctor->options.data, "", &names);
    for (uint32_t i = 0; i < names.count; i++) {
        const enum system_health_quarantine kind = system_health_quarantine_of(names.name[i]);
        if (kind != SYSTEM_HEALTH_QUARANTINE_NONE) {
            CORE_ASSERT((size_t)kind < sizeof quarantines / sizeof quarantines[0]);
            struct doctor_finding *finding =
                doctor_find(doctor, "database", DOCTOR_CHECK, "%s/%s", folder, names.name[i]);
            doctor_state(finding, "%s%s", quarantines[kind].state,
                         system_health_is_seen(folder, names.name[i])
                             ? "; the operator has confirmed the finding"
                             : "");
            doctor_todo(finding, "%s", quarantines[kind].todo);
        }
    }
}

/* ---- Stored controller mappings -------------------------------------------------------------- */

static void check_poi_file(struct doctor *doctor, const char *path)
{
    static char text[HID_MAPPING_STORE_TEXT_SIZE];
    static struct hid_mapping_store_entry entry;
    char why[HAL_TEXT_SIZE] = "";
    FILE *file = file_open(path, sizeof text - 1u);
    const size_t size = file ? fread(text, 1, sizeof text - 1u, file) : 0;
    const int error = !file || ferror(file) ? errno : 0;
    if (file) {
        fclose(file);
    }
    text[size] = '\0';
    const int line = error ? 0 : hid_mapping_store_read(&entry, text, why);
    if (!error && line == 0) {
        doctor_state(doctor_find(doctor, "learned", DOCTOR_FINE, "%04x:%04x %s", entry.vendor,
                                 entry.product, entry.serial),
                     "%u motions and buttons", entry.map.count);
        return;
    }
    struct doctor_finding *finding = doctor_find(doctor, "learned", DOCTOR_CHECK, "%s", path);
    if (error) {
        doctor_state(finding, "%s", file_error(error));
    } else {
        doctor_state(finding, "line %d: %s", line, why);
    }
    doctor_todo(finding, "remove the file, and learn the controller again in the operator's menu");
}

static void check_poi_files(struct doctor *doctor, const char *data)
{
    static struct doctor_names names;
    char path[PATH_ROOM];
    snprintf(path, sizeof path, "%s/pois", doctor->options.data);
    doctor_list(doctor, path, "", &names);
    for (uint32_t i = 0; i < names.count; i++) {
        const char *dot = strrchr(names.name[i], '.');
        if (dot && strcmp(dot, ".poi") == 0) {
            snprintf(path, sizeof path, "%s/pois/%s", data, names.name[i]);
            check_poi_file(doctor, path);
        }
    }
}

static void (*const checks[])(struct doctor *doctor, const char *folder) = {
    check_room, check_database, check_backup, check_damaged, check_poi_files,
};

void doctor_store(struct doctor *doctor)
{
    char path[OPTIONS_PATH_MAX + 64u];
    if (!doctor->options.data[0]) {
        struct doctor_finding *none = doctor_find(doctor, "store", DOCTOR_WRONG, "data folder");
        doctor_state(none, "neither --data nor HOME is set, so the kiosk saves nothing");
        doctor_todo(none, "start the kiosk with --data FOLDER");
        return;
    }
    snprintf(path, sizeof path, "%s%s", doctor->root, doctor->options.data);
    const int error = check_folder(doctor, path);
    for (size_t i = 0; !error && i < sizeof checks / sizeof checks[0]; i++) {
        checks[i](doctor, path);
    }
}
