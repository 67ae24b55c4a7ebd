/* backup.c -- `kingyoctl backup`: a copy of all that the stall keeps, while it runs. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "platform/ctl/books.h"
#include "platform/store/ledger_backup.h"

static const char name[] = "backup";

static int is_same(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

/* A copy onto the file itself would be one of nothing, and so with its log and its backup. */
static int is_stalls_own(struct ledger_file *file, const char *path)
{
    const char *own = sqlite3_db_filename(file->db, "main"), *own_name = strrchr(own, '/');
    const char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path;
    char folder[LEDGER_PATH_SIZE], own_folder[LEDGER_PATH_SIZE];
    snprintf(folder, sizeof folder, "%.*s.", (int)(last - path), path);
    snprintf(own_folder, sizeof own_folder, "%.*s.", own_name ? (int)(own_name + 1 - own) : 0, own);
    own_name = own_name ? own_name + 1 : own;
    return is_same(own, path) ||
           (is_same(folder, own_folder) && strncmp(last, own_name, strlen(own_name)) == 0);
}

/* What is there already may only be an older copy. */
static int is_foreign(const char *path)
{
    struct ledger_file older;
    struct stat about;
    if (stat(path, &about) != 0 || (S_ISREG(about.st_mode) && about.st_size == 0)) {
        return 0;
    }
    const int code = S_ISREG(about.st_mode) ? ledger_file_look(&older, path) : SQLITE_CANTOPEN;
    if (code == SQLITE_OK) {
        ledger_file_close(&older);
    }
    return code != SQLITE_OK && code != SQLITE_SCHEMA;
}

static enum exit_code copy(struct ledger_file *file, const char *path, int as_json)
{
    if (is_stalls_own(file, path)) {
        return ctl_usage(name, "%.200s: is the stall's own file", path);
    }
    if (is_foreign(path)) {
        return ctl_usage(name, "%.200s: is there, and is no copy of a stall's file", path);
    }
    const int code = ledger_backup_make(file, path, true);
    if (code != SQLITE_OK) {
        fprintf(stderr, "kingyoctl backup: %s: cannot be written: %s\n", path,
                code == SQLITE_CORRUPT ? "the stall's own file is damaged"
                                       : ledger_file_error(code));
        return code == SQLITE_CORRUPT ? EXIT_BAD_DATA : EXIT_IO;
    }
    const struct ledger_start *ledger = &file->content.memory.ledger;
    if (as_json) {
        fputs("{\"file\": ", stdout);
        books_print_json(path);
        printf(", \"entries\": %u, \"start\": %u}\n", ledger->last_id, ledger->boots);
    } else {
        printf("%s: whole, %u entries\n", path, ledger->last_id);
    }
    return EXIT_OK;
}

static enum exit_code run(int argc, const char *const *argv)
{
    struct books_words words = { 0 };
    struct ledger_file file;
    const char *path = NULL;
    for (int i = 0; i < argc; i++) {
        if (books_take(&words, argc, argv, &i)) {
            continue;
        }
        if (path || argv[i][0] == '-') {
            return ctl_usage(name, "'%.60s' is not understood; --help says more", argv[i]);
        }
        path = argv[i];
    }
    if (!path || strlen(path) + 32u > LEDGER_PATH_SIZE) {
        return ctl_usage(name, path ? "the name is too long" : "wants a file to write to");
    }
    enum exit_code code = books_open(name, &words, &file);
    if (code == EXIT_OK) {
        code = copy(&file, path, words.as_json);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_backup = {
    .name = name,
    .summary = "a copy of all that the stall keeps, while it runs",
    .usage = "  kingyoctl backup FILE [--data DIR] [--json]\n\n" BOOKS_USAGE
             "\nFILE is checked before it gets its name. To go back to it: stop the stall, remove\n"
             "kingyo.db, kingyo.db-wal and kingyo.db-shm, put FILE there as kingyo.db, give it\n"
             "to the stall's user (chown kingyo:kingyo), start it. A copy that was made otherwise\n"
             "and has less than kingyo.db.backup is taken for a damaged file: remove that, too.\n",
    .run = run,
};
