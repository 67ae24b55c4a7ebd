/* backup.c -- the command `kingyoctl backup`.
 *
 * The command copies the kiosk's ledger database while the kiosk runs. restore.c implements the
 * option --restore. */
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

static enum exit_code backup_run(int argc, const char *const *argv)
{
    struct books_words words = { 0 };
    struct ledger_file file;
    const char *path = NULL;
    int goes_back = 0;
    for (int i = 0; i < argc; i++) {
        if (books_take(&words, argc, argv, &i)) {
            continue;
        }
        if (strcmp(argv[i], "--restore") == 0 && !goes_back) {
            goes_back = 1;
            continue;
        }
        if (path || argv[i][0] == '-') {
            return ctl_usage(name, "'%.60s' is not understood; --help says more", argv[i]);
        }
        path = argv[i];
    }
    if (!path || strlen(path) + 32u > LEDGER_PATH_SIZE) {
        return ctl_usage(name, path ? "the name is too long" : "wants a file");
    }
    if (goes_back) {
        return restore_backup(&words, path);
    }
    enum exit_code code = books_open(name, &words, &file);
    if (code == EXIT_OK) {
        code = copy(&file, path, &words);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_backup = {
    .name = name,
    .summary = "a copy of all that the stall keeps, while it runs",
    .usage = "  kingyoctl backup FILE [--data DIR] [--json]\n"
             "  kingyoctl backup --restore FILE [--data DIR] [--json]\n\n" BOOKS_USAGE
             "  --restore    goes back to FILE, or begins with it on another machine\n"
             "\nFILE is checked before it gets its name, and replaces nothing but an older copy.\n"
             "To go back: stop the stall, --restore, start it. FILE is checked then, too, and\n"
             "what was there is kept beside it as kingyo.db.before-N, with its own backup.\n",
    .run = backup_run,
};
