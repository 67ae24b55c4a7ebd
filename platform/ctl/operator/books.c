/* books.c -- finds the ledger database and opens it for commands that only read. */
#include "platform/ctl/operator/books.h"

#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/storage.h"

static const char service_folder[] = "/var/lib/kingyo";

static const struct option options[] = {
    { "data", "DIR",
      "data folder of the kiosk; the default is /var/lib/kingyo, or else your own data folder",
      OPTION_TEXT, .offset = offsetof(struct books_words, data) },
    { "json", NULL, "print JSON", OPTION_FLAG, .offset = offsetof(struct books_words, as_json) },
};

const struct option_table books_options = OPTION_TABLE(options, NULL);

/* Returns 0 if `path` exists, otherwise an errno. EACCES is common, because most users have no
 * access to the data folder of the system service. */
static int existence_error(const char *path)
{
    struct stat about;
    return lstat(path, &about) ? errno : 0;
}

void books_path(const struct books_words *words, char path[BOOKS_PATH_SIZE])
{
    char own[FILE_FOLDER_MAX];
    CORE_ASSERT(!words->data || words->data[0]);
    const char *folder = words->data ? words->data : service_folder;
    snprintf(path, BOOKS_PATH_SIZE, "%s/" STORAGE_FILE, folder);
    file_default_data(own);
    if (!words->data && existence_error(path) == ENOENT && own[0]) {
        snprintf(path, BOOKS_PATH_SIZE, "%s/" STORAGE_FILE, own);
    }
}

bool books_is_same(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

int books_check_copy(const char *path, struct ledger_start *out)
{
    struct ledger_file file;
    sqlite3 *db = NULL;
    int64_t count = 0;
    *out = (struct ledger_start){ 0 };
    int code = ledger_file_inspect(&file, path);
    if (code == SQLITE_OK) {
        *out = file.content.memory.ledger;
        ledger_file_close(&file);
    }
    if (code == SQLITE_SCHEMA) {
        /* A file without tables is also SQLITE_SCHEMA, because the kiosk would create the tables.
         * Such a file is no copy of a database. */
        code = sql_open(path, SQLITE_OPEN_READONLY, NULL, &db);
        code =
            code == SQLITE_OK ? sql_number(db, "SELECT count(*) FROM sqlite_schema", &count) : code;
        sqlite3_close(db);
        code = code == SQLITE_OK && count == 0 ? SQLITE_NOTFOUND : code;
    }
    return code;
}

bool books_report_foreign(const char *command, const char *path, const char *advice)
{
    struct ledger_foreign foreign;
    sqlite3 *db = NULL;
    const bool has_foreign = sql_open(path, SQLITE_OPEN_READONLY, NULL, &db) == SQLITE_OK &&
                             ledger_schema_foreign(db, &foreign);
    sqlite3_close(db);
    if (has_foreign) {
        print_error("kingyoctl %s: %s: holds the %s '%s', %s; %s", command, path, foreign.type,
                    foreign.name, ledger_foreign_reason(&foreign), advice);
    }
    return has_foreign;
}

enum exit_code books_open(const char *command, const struct books_words *words,
                          struct ledger_file *out)
{
    char path[BOOKS_PATH_SIZE];
    CORE_ASSERT(command && words && out);
    books_path(words, path);
    const int error = existence_error(path);
    if (error) {
        return print_fail(EXIT_IO, "kingyoctl %s: %s: %s", command, path,
                          error == ENOENT   ? "does not exist; name the data folder with --data"
                          : error == EACCES ? "you have no access; use sudo"
                                            : strerror(error));
    }
    const int type_error = file_type_error(path);
    if (type_error) {
        return print_fail(EXIT_IO, "kingyoctl %s: %s: %s", command, path, file_error(type_error));
    }
    const int code = ledger_file_inspect(out, path);
    if (code == SQLITE_OK) {
        return EXIT_OK;
    }
    if (code == SQLITE_CORRUPT &&
        books_report_foreign(command, path, "the kiosk replaces the file when it starts")) {
        return EXIT_BAD_DATA;
    }
    print_error("kingyoctl %s: %s: %s", command, path,
                code == SQLITE_SCHEMA
                    ? "an earlier version of Kingyo wrote it: start the kiosk once"
                : code == SQLITE_NOTADB  ? "is not a database"
                : code == SQLITE_CORRUPT ? "is damaged: the kiosk replaces it when it starts"
                                         : ledger_file_error(code));
    return code == SQLITE_SCHEMA || code == SQLITE_NOTADB || code == SQLITE_CORRUPT ||
                   code == LEDGER_FILE_NEWER
               ? EXIT_BAD_DATA
               : EXIT_IO;
}
