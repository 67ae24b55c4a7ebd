/* doctor_store.c -- the data folder, the rounds in it, and the controllers that were learned. */
#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <sqlite3.h>

#include "drivers/hid_book_text.h"
#include "platform/ctl/doctor.h"
#include "platform/storage.h"

#define ROOM_MIB 64u /* A round is 200 bytes: rounds for years, and room for a recording. */
#define PATH_ROOM (OPTIONS_PATH_MAX + 400u)

/* ---- The folder ----------------------------------------------------------------------------- */

static void look_at_room(struct doctor *doctor, const char *path)
{
    struct statvfs about;
    if (statvfs(path, &about)) {
        return;
    }
    const uint64_t mib = (uint64_t)about.f_bavail * about.f_frsize / 1048576u;
    struct doctor_finding *finding =
        doctor_find(doctor, "store", mib < ROOM_MIB ? DOCTOR_LOOK : DOCTOR_FINE, "room");
    doctor_state(finding, "%" PRIu64 " MiB are free", mib);
    if (mib < ROOM_MIB) {
        doctor_todo(finding, "make room on that card: %u MiB at least", ROOM_MIB);
    }
}

/* 0: it is there, and the kiosk's own. */
static int look_at_folder(struct doctor *doctor, const char *path)
{
    const int error = doctor_may_use(doctor, doctor->options.data);
    struct doctor_finding *finding = doctor_find(doctor, "store", DOCTOR_FINE, "%s", path);
    if (error == ENOENT) {
        doctor_state(finding, "is not there yet: the kiosk makes it at its first start");
    } else if (error) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "%s may not write there: %s", doctor->user.name, strerror(error));
        doctor_todo(finding, "sudo chown -R %s '%.400s'", doctor->user.name, doctor->options.data);
    } else {
        doctor_state(finding, "%s may write there", doctor->user.name);
    }
    return error;
}

/* ---- The database --------------------------------------------------------------------------- */

/* The first column of the first row, as text; "" where there is none. */
static int ask(sqlite3 *database, const char *sql, char *out, size_t size)
{
    sqlite3_stmt *statement = NULL;
    int code = sqlite3_prepare_v2(database, sql, -1, &statement, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(statement);
        const unsigned char *text = code == SQLITE_ROW ? sqlite3_column_text(statement, 0) : NULL;
        snprintf(out, size, "%s", text ? (const char *)text : "");
        code = code == SQLITE_ROW ? SQLITE_OK : code;
    }
    sqlite3_finalize(statement);
    return code;
}

static void judge(struct doctor_finding *finding, sqlite3 *database)
{
    char verdict[DOCTOR_TEXT] = "", version[16] = "", rounds[24] = "";
    int code = ask(database, "PRAGMA quick_check(1)", verdict, sizeof verdict);
    code = code ? code : ask(database, "PRAGMA user_version", version, sizeof version);
    code = code ? code : ask(database, "SELECT count(*) FROM rounds", rounds, sizeof rounds);
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        doctor_state(finding, "another program writes to it right now");
    } else if (code || strcmp(verdict, "ok") != 0) {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "damaged: %.200s", code ? sqlite3_errmsg(database) : verdict);
        doctor_todo(finding, "the kiosk will set it aside and begin a new one; keep a copy if the "
                             "old rounds matter");
    } else {
        doctor_state(finding, "whole, %s rounds, version %s of %d", rounds, version,
                     LEDGER_FILE_VERSION);
    }
}

static void look_at_database(struct doctor *doctor, const char *folder)
{
    char path[PATH_ROOM];
    struct stat about;
    sqlite3 *database = NULL;
    snprintf(path, sizeof path, "%s/%s", folder, STORAGE_FILE);
    struct doctor_finding *finding = doctor_find(doctor, "database", DOCTOR_FINE, "%s", path);
    if (stat(path, &about)) {
        doctor_state(finding, "is not there yet: no round was kept");
        return;
    }
    if (sqlite3_open_v2(path, &database, SQLITE_OPEN_READONLY, NULL) == SQLITE_OK) {
        judge(finding, database);
    } else {
        finding->level = DOCTOR_WRONG;
        doctor_state(finding, "cannot be opened: %.200s", sqlite3_errmsg(database));
        doctor_todo(finding, "sudo chown %s '%s'", doctor->user.name, path);
    }
    sqlite3_close(database);
}

/* ---- Learned controllers -------------------------------------------------------------------- */

static void look_at_poi(struct doctor *doctor, const char *path)
{
    static char text[HID_BOOK_TEXT_SIZE];
    static struct hid_book_entry entry;
    char why[HAL_TEXT_SIZE] = "";
    FILE *file = fopen(path, "r");
    const size_t size = file ? fread(text, 1, sizeof text - 1u, file) : 0;
    const int error = file ? 0 : errno;
    if (file) {
        fclose(file);
    }
    text[size] = '\0';
    const int line = error ? 0 : hid_book_read(&entry, text, why);
    if (!error && line == 0) {
        doctor_state(doctor_find(doctor, "learned", DOCTOR_FINE, "%04x:%04x %s", entry.vendor,
                                 entry.product, entry.serial),
                     "%u motions and buttons", entry.map.count);
        return;
    }
    struct doctor_finding *finding = doctor_find(doctor, "learned", DOCTOR_LOOK, "%s", path);
    if (error) {
        doctor_state(finding, "%s", strerror(error));
    } else {
        doctor_state(finding, "line %d: %s", line, why);
    }
    doctor_todo(finding, "remove it, and learn that controller again in the operator's menu");
}

static void look_at_pois(struct doctor *doctor, const char *data)
{
    char path[PATH_ROOM];
    snprintf(path, sizeof path, "%s/pois", data);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        const char *dot = strrchr(entry->d_name, '.');
        if (dot && strcmp(dot, ".poi") == 0) {
            snprintf(path, sizeof path, "%s/pois/%.255s", data, entry->d_name);
            look_at_poi(doctor, path);
        }
    }
    if (folder) {
        closedir(folder);
    }
}

void doctor_store(struct doctor *doctor)
{
    char path[OPTIONS_PATH_MAX + 64u];
    if (!doctor->options.data[0]) {
        struct doctor_finding *none = doctor_find(doctor, "store", DOCTOR_WRONG, "data folder");
        doctor_state(none, "nowhere: neither --data nor HOME is set, so no round is kept");
        doctor_todo(none, "start the kiosk with --data FOLDER");
        return;
    }
    snprintf(path, sizeof path, "%s%s", doctor->root, doctor->options.data);
    if (look_at_folder(doctor, path) == 0) {
        look_at_room(doctor, path);
        look_at_database(doctor, path);
        look_at_pois(doctor, path);
    }
}
