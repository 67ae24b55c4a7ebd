/* backup.c -- the command `kingyoctl backup`.
 *
 * The command copies the kiosk's ledger database while the kiosk runs. restore.c implements the
 * option --restore. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "platform/ctl/operator/books.h"
#include "platform/ctl/operator/restore.h"
#include "platform/os/json_char.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/storage.h"

static const char name[] = "backup";

/* Returns 1 if `path` names the kiosk's ledger database or one of its companion files, otherwise 0.
 * A copy onto the database would empty the database. A copy onto the write-ahead log would destroy
 * the log. Every file in the data folder whose name begins with STORAGE_FILE counts as a companion
 * file. */
static int is_stalls_own(const struct books_words *words, const char *path)
{
    char own[BOOKS_PATH_SIZE], folder[BOOKS_PATH_SIZE];
    const char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path;
    books_path(words, own);
    snprintf(folder, sizeof folder, "%.*s.", (int)(last - path), path);
    if (books_is_same(own, path)) {
        return 1;
    }
    *(strrchr(own, '/') + 1) = '\0';
    return strncmp(last, STORAGE_FILE, strlen(STORAGE_FILE)) == 0 && books_is_same(own, folder);
}

/* Returns the reason why a copy must not be written to `path`, or null if the copy may be written.
 * A copy may replace only an older copy or an empty file, or create a new file. */
static const char *why_not(const char *path)
{
    struct ledger_start older;
    struct stat about;
    if (stat(path, &about) != 0 || (S_ISREG(about.st_mode) && about.st_size == 0)) {
        return NULL;
    }
    if (!S_ISREG(about.st_mode)) {
        return S_ISDIR(about.st_mode) ? "is a folder" : "is no file";
    }
    return books_check_copy(path, &older) == SQLITE_OK
               ? NULL
               : "is there, and is no copy of a stall's file";
}

static enum exit_code copy(struct ledger_file *file, const char *path,
                           const struct books_words *words)
{
    const char *why = is_stalls_own(words, path) ? "is the stall's own file" : why_not(path);
    if (why) {
        return ctl_usage(name, "%.200s: %s", path, why);
    }
    const int code = ledger_backup_make(file, path, true);
    if (code != SQLITE_OK) {
        print_error("kingyoctl backup: %s: cannot be written: %s", path,
                    code == SQLITE_CORRUPT ? "the stall's own file is damaged"
                                           : ledger_file_error(code));
        return code == SQLITE_CORRUPT ? EXIT_BAD_DATA : EXIT_IO;
    }
    const struct ledger_start *ledger = &file->content.memory.ledger;
    if (words->as_json) {
        fputs("{\"file\": ", stdout);
        json_print(path);
        printf(", \"entries\": %u, \"start\": %u}\n", ledger->last_id, ledger->boots);
    } else {
        print_line(stdout, "%s: whole, %u entries", path, ledger->last_id);
    }
    return EXIT_OK;
}

struct request {
    struct books_words books;
    const char *path;
    uint8_t restores; /* 1 if the database is replaced with the copy `path`. */
};

static const struct option options[] = {
    { NULL, "FILE", "copy of the database", OPTION_ARGUMENT,
      .offset = offsetof(struct request, path) },
    { "restore", NULL, "replace the database with FILE, also on another machine", OPTION_FLAG,
      .offset = offsetof(struct request, restores) },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &books_options };

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
        code = copy(&file, request.path, &request.books);
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
