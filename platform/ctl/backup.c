/* backup.c -- `kingyoctl backup`: a copy of all that the stall keeps, while it runs. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "platform/ctl/books.h"
#include "platform/store/ledger_backup.h"

static const char name[] = "backup";

/* A copy onto the file itself would be one of nothing. */
static int is_same(struct ledger_file *file, const char *path)
{
    struct stat one, other;
    return stat(sqlite3_db_filename(file->db, "main"), &one) == 0 && stat(path, &other) == 0 &&
           one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

static enum exit_code copy(struct ledger_file *file, const char *path, int as_json)
{
    if (is_same(file, path)) {
        return ctl_usage(name, "%.200s: is the stall's own file", path);
    }
    const int code = ledger_backup_make(file, path);
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
             "to the stall's user (chown kingyo:kingyo), start it.\n",
    .run = run,
};
