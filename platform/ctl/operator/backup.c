/* backup.c -- the command `kingyoctl backup`, which copies the kiosk's ledger database while the
 * kiosk runs, and replaces the database with a copy.
 *
 * --restore writes the copy under the name from which the kiosk recovers automatically if its
 * database is missing (storage_open.c). After a power failure, either the old database is still in
 * use, or the kiosk starts from the copy. The kiosk's automatic backup is renamed too. The backup
 * contains more entries than an older copy, so the kiosk would otherwise treat the copy as a
 * database that has lost entries. */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sqlite3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/ctl/operator/books.h"
#include "platform/os/file.h"
#include "platform/os/json.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/storage.h"

/* Maximum length of the database's path in bytes. The kiosk has the same limit. */
#define PATH_MAX_BYTES 520u
#define BEFORE_MAX 1000u /* Maximum number of replaced databases that stay in the folder. */
#define NAME_SIZE 40u    /* Size of a file name in the data folder, in bytes. */

static const char name[] = "backup";
static const char command[] = "backup --restore";
static const char in_use[] = "the kiosk runs, or another program reads the database: stop it first";

/* State of the replacement of the database. All files are in one folder, which another user may
 * own. The folder stays open, and the files are renamed by their names in the open folder. A
 * symbolic link that takes the place of the folder therefore has no effect. */
struct swap {
    char own[BOOKS_PATH_SIZE]; /* Path of the kiosk's ledger database. */
    int folder;                /* Descriptor of the folder of the ledger database. */
    char before[NAME_SIZE];    /* New name of the replaced database. */
    /* Start record of the copy. All fields are 0 if an earlier version of Kingyo wrote the copy. */
    struct ledger_start copied;
};

static const char fresh[] = STORAGE_FILE STORAGE_NEW_SUFFIX; /* Name of the copy that will replace
                                                                the database. */

static enum exit_code fails(const char *path, const char *why)
{
    return print_fail(EXIT_IO, "kingyoctl %s: %s: %s", command, path, why);
}

static void join_path_suffix(char out[LEDGER_PATH_SIZE], const char *path, const char *suffix)
{
    CORE_ASSERT(strlen(suffix) < 40u);
    snprintf(out, LEDGER_PATH_SIZE, "%.560s%.39s", path, suffix);
}

/* Opens the folder of the database and locks it. A kiosk locks its data folder for its whole run,
 * even while its database is closed. A file system without locks is used without a lock. Prints an
 * error. */
static enum exit_code open_folder(struct swap *swap)
{
    char path[BOOKS_PATH_SIZE];
    snprintf(path, sizeof path, "%.*s", (int)(strrchr(swap->own, '/') - swap->own), swap->own);
    swap->folder = file_lock_folder(path[0] ? path : "/");
    if (swap->folder == -EWOULDBLOCK) {
        return fails(swap->own, in_use);
    }
    if (swap->folder < 0) {
        swap->folder = open(path[0] ? path : "/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    }
    return swap->folder >= 0 ? EXIT_OK
                             : fails(path, errno == ENOENT   ? "does not exist; create it, or name "
                                                               "the data folder with --data"
                                           : errno == EACCES ? "you have no access; use sudo"
                                                             : strerror(errno));
}

/* Returns true if a process has the database open. SQLite locks parts of the database file or of
 * its shared-memory file while the database is open. */
static bool is_database_held(const struct swap *swap)
{
    static const char *const names[] = { STORAGE_FILE, STORAGE_FILE "-shm" };
    bool is_held = false;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct flock lock = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
        const int handle = file_handle_at(swap->folder, names[i], O_RDONLY, 0);
        is_held = is_held ||
                  (handle >= 0 && fcntl(handle, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK);
        if (handle >= 0) {
            close(handle);
        }
    }
    return is_held;
}

/* ---- Writing the copy ------------------------------------------------------------------------ */

/* Gives the copy the owner and the mode of the present database, because the kiosk's user must be
 * able to write the copy. If there is no database, or another kind of file has its name, the owner
 * is the owner of the data folder.
 * Returns 0, or -1 with errno set. */
static int copy_owner_and_mode(const struct swap *swap)
{
    struct stat about;
    const bool has_file = fstatat(swap->folder, STORAGE_FILE, &about, AT_SYMLINK_NOFOLLOW) == 0 &&
                          S_ISREG(about.st_mode);
    if (!has_file && fstat(swap->folder, &about) != 0) {
        return -1;
    }
    const mode_t mode = has_file ? about.st_mode & 0660 : S_IRUSR | S_IWUSR;
    return file_give_at(swap->folder, fresh, about.st_uid, about.st_gid, mode);
}

static enum exit_code make_copy(struct swap *swap, const char *from)
{
    struct ledger_file file = { .refusal = SQLITE_READONLY };
    struct stat about;
    char path[LEDGER_PATH_SIZE];
    if (stat(from, &about) != 0) {
        return fails(from, strerror(errno));
    }
    if (!S_ISREG(about.st_mode)) {
        return fails(from, "is not a regular file");
    }
    int code = books_check_copy(from, &swap->copied);
    code = code == SQLITE_OK ? sql_open(from, SQLITE_OPEN_READONLY, NULL, &file.db) : code;
    code = code == SQLITE_OK ? ledger_check(file.db) : code;
    if (code != SQLITE_OK) {
        ledger_file_close(&file);
        if (code != SQLITE_CORRUPT || !books_report_foreign(command, from, "use another copy")) {
            fails(from, code == SQLITE_NOTFOUND ? "is not a copy of a kiosk's database"
                                                : ledger_file_error(code));
        }
        return code == SQLITE_CANTOPEN ? EXIT_IO : EXIT_BAD_DATA;
    }
    join_path_suffix(path, swap->own, STORAGE_NEW_SUFFIX);
    code = ledger_backup_make(&file, path, false);
    ledger_file_close(&file);
    if (code != SQLITE_OK || copy_owner_and_mode(swap) != 0) {
        fails(path, code != SQLITE_OK ? ledger_file_error(code) : strerror(errno));
        unlinkat(swap->folder, fresh, 0);
        return EXIT_IO;
    }
    return EXIT_OK;
}

/* ---- Replacing the database ------------------------------------------------------------------ */

static bool has_name(const struct swap *swap, const char *suffix)
{
    char whole[2u * NAME_SIZE];
    struct stat about;
    snprintf(whole, sizeof whole, "%s%s", swap->before, suffix);
    return fstatat(swap->folder, whole, &about, AT_SYMLINK_NOFOLLOW) == 0;
}

static bool name_before(struct swap *swap)
{
    for (unsigned number = 1; number <= BEFORE_MAX; number++) {
        snprintf(swap->before, sizeof swap->before, STORAGE_FILE STORAGE_REPLACED_SUFFIX "%u",
                 number);
        if (!has_name(swap, "") && !has_name(swap, STORAGE_BACKUP_SUFFIX)) {
            return true;
        }
    }
    return false;
}

/* Replaces the database with the copy. The backup and the ledger mirror, a second copy of the
 * newest entries, are renamed first. The kiosk uses the old database until that database itself is
 * renamed. file_rename_durable() is not used, because it takes paths, and another user who owns a
 * folder of the path could replace this folder by a symbolic link between two renames. */
static int put_in_place(const struct swap *swap)
{
    static const char *const suffixes[] = {
        STORAGE_BACKUP_SUFFIX, STORAGE_MIRROR_SUFFIX, "", "-wal", "-journal", "-shm"
    };
    const int folder = swap->folder;
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++) {
        const bool is_database = suffixes[i][0] == '\0';
        char from[NAME_SIZE], to[2u * NAME_SIZE];
        snprintf(from, sizeof from, STORAGE_FILE "%s", suffixes[i]);
        snprintf(to, sizeof to, "%s%s", swap->before, suffixes[i]);
        /* Renaming a file that does not exist is no error. */
        if ((is_database && fsync(folder) != 0) ||
            (renameat(folder, from, folder, to) != 0 && errno != ENOENT) ||
            (is_database && fsync(folder) != 0)) {
            return -1;
        }
    }
    return renameat(folder, fresh, folder, STORAGE_FILE) == 0 ? fsync(folder) : -1;
}

/* Prints the copy `path` and its start record. `before` is the path of the replaced database, "" if
 * there was none, or null if no database is replaced. */
static void print_json(const char *path, const char *before, const struct ledger_start *ledger)
{
    struct json json = { .file = stdout };
    json_print(&json, "{file: %s", path);
    if (before) {
        json_text(&json, "before", before);
    }
    json_print(&json, "entries: %u, start: %u}", ledger->last_id, ledger->boots);
    json_end(&json);
}

static enum exit_code replace_database(struct swap *swap, const char *from)
{
    if (is_database_held(swap)) {
        return fails(swap->own, in_use);
    }
    const enum exit_code code = make_copy(swap, from);
    if (code != EXIT_OK) {
        return code;
    }
    if (is_database_held(swap) || !name_before(swap)) {
        unlinkat(swap->folder, fresh, 0);
        return fails(swap->own,
                     "the kiosk was started, or the folder has too many replaced databases");
    }
    return put_in_place(swap) == 0 ? EXIT_OK : fails(swap->own, strerror(errno));
}

static enum exit_code restore_backup(const struct books_words *words, const char *named)
{
    struct swap swap = { 0 };
    char resolved[PATH_MAX]; /* Target of the symbolic link if the user named a symbolic link. */
    const char *from = file_is_other(named) && realpath(named, resolved) ? resolved : named;
    books_path(words, swap.own);
    if (strlen(swap.own) > PATH_MAX_BYTES) {
        return ctl_usage(name, "the name is too long");
    }
    if (books_is_same(from, swap.own)) {
        return ctl_usage(name, "%.200s: is the kiosk's own database", from);
    }
    enum exit_code code = open_folder(&swap);
    if (code != EXIT_OK) {
        return code;
    }
    code = replace_database(&swap, from);
    const bool has_before = code == EXIT_OK && has_name(&swap, "");
    close(swap.folder);
    if (code != EXIT_OK) {
        return code;
    }
    char before[LEDGER_PATH_SIZE];
    join_path_suffix(before, swap.own, swap.before + sizeof STORAGE_FILE - 1u);
    if (words->as_json) {
        print_json(named, has_before ? before : "", &swap.copied);
        return EXIT_OK;
    }
    print_line(stdout, "%s: is now %s, %u entries", named, swap.own, swap.copied.last_id);
    if (has_before) {
        print_line(stdout, "replaced database: %s", before);
    }
    return EXIT_OK;
}

/* Returns EXIT_OK if a copy may be written to `path`, otherwise prints an error. A copy may replace
 * only an older copy or an empty file, or create a new file. A copy onto the kiosk's database would
 * empty the database, and a copy onto the write-ahead log would destroy the log. Therefore no file
 * in the data folder whose name begins with STORAGE_FILE is replaced. */
static enum exit_code check_target(const struct books_words *words, const char *path)
{
    char own[BOOKS_PATH_SIZE], folder[BOOKS_PATH_SIZE];
    struct ledger_start older;
    struct stat about;
    const char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path;
    books_path(words, own);
    snprintf(folder, sizeof folder, "%.*s.", (int)(last - path), path);
    const bool is_database = books_is_same(own, path);
    *(strrchr(own, '/') + 1) = '\0';
    if (is_database ||
        (strncmp(last, STORAGE_FILE, strlen(STORAGE_FILE)) == 0 && books_is_same(own, folder))) {
        return ctl_usage(name, "%.200s: is the kiosk's own database", path);
    }
    if (stat(path, &about) != 0 || (S_ISREG(about.st_mode) && about.st_size == 0)) {
        return EXIT_OK;
    }
    if (!S_ISREG(about.st_mode)) {
        return print_fail(EXIT_IO, "kingyoctl backup: %s: cannot be written: %s", path,
                          S_ISDIR(about.st_mode) ? "is a folder" : "is not a regular file");
    }
    return books_check_copy(path, &older) == SQLITE_OK
               ? EXIT_OK
               : ctl_usage(name, "%.200s: exists, and is not a copy of a kiosk's database", path);
}

static enum exit_code write_backup_copy(struct ledger_file *file, const char *path,
                                        const struct books_words *words)
{
    const enum exit_code target = check_target(words, path);
    if (target != EXIT_OK) {
        return target;
    }
    const int code = ledger_backup_make(file, path, true);
    if (code != SQLITE_OK) {
        return print_fail(code == SQLITE_CORRUPT ? EXIT_BAD_DATA : EXIT_IO,
                          "kingyoctl backup: %s: cannot be written: %s", path,
                          code == SQLITE_CORRUPT ? "the kiosk's own database is damaged"
                                                 : ledger_file_error(code));
    }
    const struct ledger_start *ledger = &file->content.memory.ledger;
    if (words->as_json) {
        print_json(path, NULL, ledger);
    } else {
        print_line(stdout, "%s: whole, %u entries", path, ledger->last_id);
    }
    return EXIT_OK;
}

struct request {
    struct books_words books;
    const char *path;
    bool restores; /* True if the database is replaced with the copy at `path`. False if the
                      database is only copied. */
};

static const struct option options[] = {
    { NULL, "FILE", "copy of the database", OPTION_ARGUMENT,
      .offset = offsetof(struct request, path) },
    { "restore", NULL, "replace the database with FILE, also on another machine", OPTION_FLAG,
      .offset = offsetof(struct request, restores) },
};

static const struct option_table table = OPTION_TABLE(options, &books_options);

static enum exit_code backup_run(int argc, const char *const *argv)
{
    struct request request = { .path = NULL };
    struct ledger_file file;
    enum exit_code code = ctl_options(name, &table, 0, &request, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    if (!request.path || strlen(request.path) + 32u > LEDGER_PATH_SIZE) {
        return ctl_usage(name, request.path ? "the name is too long" : "a FILE is missing");
    }
    if (request.restores) {
        return restore_backup(&request.books, request.path);
    }
    code = books_open(name, &request.books, &file);
    if (code == EXIT_OK) {
        code = write_backup_copy(&file, request.path, &request.books);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_backup = {
    .name = name,
    .summary = "copies all that the kiosk stores, while the kiosk runs",
    .usage = "  kingyoctl backup FILE [--data DIR] [--json]\n"
             "  kingyoctl backup --restore FILE [--data DIR] [--json]\n",
    .options = &table,
    .notes = "FILE is verified before it gets its name, and replaces only an older copy.\n"
             "To restore: stop the kiosk, run --restore, start the kiosk. FILE is verified\n"
             "again. The replaced database stays in the same folder as kingyo.db.before-N,\n"
             "with its own backup.\n",
    .run = backup_run,
};
