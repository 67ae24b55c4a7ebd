/* status.c -- `kingyoctl status`, which prints the status file that a running kiosk writes. */
#include <errno.h>
#include <sqlite3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "platform/ctl/lib/ctl.h"
#include "platform/kiosk/status.h"
#include "platform/os/clock.h"
#include "platform/os/json.h"
#include "platform/os/print.h"
#include "sql_texts.h"

#define DEFAULT_FILE "/run/kingyo/" STATUS_FILE
/* Age of the status file in ms above which the status counts as outdated. The watchdog timeout of
 * the kiosk's service has the same value. */
#define STALE_MS 10000

static const char name[] = "status";

struct request {
    const char *file;
    bool as_json;
};

static const struct option options[] = {
    { "file", "FILE", "status file", OPTION_TEXT, .offset = offsetof(struct request, file),
      .initial = DEFAULT_FILE },
    { "json", NULL, "print the status file unchanged", OPTION_FLAG,
      .offset = offsetof(struct request, as_json) },
};

static const struct option_table table = OPTION_TABLE(options, NULL);

/* Reads the status file. Returns EXIT_OK, or prints one line and returns another exit code. */
static enum exit_code status_read_file(const char *path, char text[STATUS_TEXT_MAX])
{
    size_t size = 0;
    if (access(path, F_OK) != 0 && errno == ENOENT) {
        return print_fail(EXIT_IO, "kingyoctl status: %s: %s; no kiosk runs as a service here",
                          path, strerror(ENOENT));
    }
    const enum exit_code code =
        ctl_file_read("kingyoctl status", path, text, STATUS_TEXT_MAX - 1u, &size);
    text[size] = '\0';
    return code;
}

/* ---- Reading the JSON status with SQLite ----------------------------------------------------- */

static sqlite3_stmt *status_prepare_query(sqlite3 *database, const char *sql, const char *text)
{
    sqlite3_stmt *statement = NULL;
    if (sqlite3_prepare_v2(database, sql, -1, &statement, NULL) == SQLITE_OK) {
        sqlite3_bind_text(statement, 1, text, -1, SQLITE_STATIC);
    }
    return statement;
}

/* ---- Exit code from the status --------------------------------------------------------------- */

static enum exit_code status_exit_code(sqlite3_stmt *head)
{
    const int64_t age_ms =
        (int64_t)(clock_ns(CLOCK_BOOTTIME) / NS_PER_MS) - sqlite3_column_int64(head, 0);
    if (age_ms > STALE_MS || age_ms < 0) {
        return print_fail(
            EXIT_NOT_SO,
            "kingyoctl status: the kiosk has written no status for %.1f s: the kiosk has "
            "ended or hangs",
            (double)(age_ms < 0 ? STALE_MS : age_ms) * 1e-3);
    }
    if (!sqlite3_column_int(head, 1)) {
        return print_fail(
            EXIT_NOT_SO,
            "kingyoctl status: the kiosk cannot save what it earns; see the lines 'ledger' "
            "and 'store'");
    }
    return EXIT_OK;
}

static enum exit_code status_print_report(const struct request *request, sqlite3 *database,
                                          const char *text)
{
    sqlite3_stmt *head = status_prepare_query(database, sql_status_head, text);
    enum exit_code code = EXIT_BAD_DATA;
    if (!head || sqlite3_step(head) != SQLITE_ROW ||
        sqlite3_column_type(head, 0) != SQLITE_INTEGER) {
        print_error("kingyoctl status: %s: is not the status file of a kiosk", request->file);
    } else {
        if (request->as_json) {
            json_copy(text);
        } else {
            print_line(stdout, "%s", (const char *)sqlite3_column_text(head, 2));
            sqlite3_stmt *lines = status_prepare_query(database, sql_status_lines, text);
            while (sqlite3_step(lines) == SQLITE_ROW) {
                print_line(stdout, "  %-9s %s", (const char *)sqlite3_column_text(lines, 0),
                           (const char *)sqlite3_column_text(lines, 1));
            }
            sqlite3_finalize(lines);
        }
        /* If standard output is incomplete, main() reports the write error. */
        code = print_flush(stdout) == 0 ? status_exit_code(head) : EXIT_NOT_SO;
    }
    sqlite3_finalize(head);
    return code;
}

static enum exit_code status_run(int argc, const char *const *argv)
{
    static char text[STATUS_TEXT_MAX];
    struct request request = { .file = NULL };
    sqlite3 *database = NULL;
    enum exit_code code = ctl_options(name, &table, 0, &request, argc, argv);
    code = code == EXIT_OK ? status_read_file(request.file, text) : code;
    if (code != EXIT_OK) {
        return code;
    }
    if (sqlite3_open(":memory:", &database) != SQLITE_OK) {
        print_error("kingyoctl status: SQLite: %s", sqlite3_errmsg(database));
        sqlite3_close(database);
        return EXIT_IO;
    }
    code = status_print_report(&request, database, text);
    sqlite3_close(database);
    return code;
}

const struct ctl_command ctl_status = {
    .name = name,
    .summary = "the running kiosk: phase, credits, tickets, store, machine, devices, faults",
    .usage = "  kingyoctl status [--json] [--file FILE]\n",
    .options = &table,
    .notes = "Prints the status that the service writes each second. 'machine' and 'files' show\n"
             "the same as the page Self-test of the operator's menu.\n"
             "Exit code: 0 the kiosk runs and saves what it earns; 1 the kiosk has ended, hangs\n"
             "or cannot save; 65 FILE is not a status file; 74 FILE is missing.\n",
    .run = status_run,
};
