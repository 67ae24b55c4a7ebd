/* status.c -- `kingyoctl status`, which prints the status file that a running kiosk writes. */
#include <errno.h>
#include <sqlite3.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/kiosk/status.h"
#include "platform/os/json.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

#define DEFAULT_FILE "/run/kingyo/" STATUS_FILE
/* Age of the status file in ms above which the status counts as outdated. The watchdog timeout of
 * the kiosk's service has the same value. */
#define STALE_MS 10000

static const char name[] = "status";

struct request {
    const char *file;
    uint8_t as_json;
};

static const struct option options[] = {
    { "file", "FILE", "status file", OPTION_TEXT, .offset = offsetof(struct request, file),
      .initial = DEFAULT_FILE },
    { "json", NULL, "print the status file unchanged", OPTION_FLAG,
      .offset = offsetof(struct request, as_json) },
};

static const struct option_table table = { options, sizeof options / sizeof options[0], NULL };

static enum exit_code status_read_file(const char *path, char text[STATUS_TEXT_MAX])
{
    FILE *file = file_open(path, STATUS_TEXT_MAX - 1u);
    const size_t size = file ? fread(text, 1, STATUS_TEXT_MAX - 1u, file) : 0;
    const int error = !file || ferror(file) ? errno : 0;
    text[size] = '\0';
    if (file) {
        fclose(file);
    }
    if (error) {
        print_error("kingyoctl status: %s: %s%s", path, file_error(error),
                    error == ENOENT ? "; no stall runs as a service here" : "");
    }
    return error == EFBIG ? EXIT_BAD_DATA : error ? EXIT_IO : EXIT_OK;
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

static const char sql_figures[] =
    "SELECT json_extract(?1, '$.written_ms'), json_extract(?1, '$.store.well'),"
    " printf('kingyo %s, start %d, open for %d h %02d min: %s', json_extract(?1, '$.version'),"
    "  json_extract(?1, '$.boot'), json_extract(?1, '$.up_s') / 3600,"
    "  json_extract(?1, '$.up_s') / 60 % 60, json_extract(?1, '$.phase')),"
    " printf('%d paid, %d of service, %d units towards the next',"
    "  json_extract(?1, '$.credits.paid'), json_extract(?1, '$.credits.service'),"
    "  json_extract(?1, '$.credits.units')),"
    " printf('%d owed, %d dispensed', json_extract(?1, '$.tickets.owed'),"
    "  json_extract(?1, '$.tickets.dispensed')),"
    " printf('%s; %d entries, %d not on disk yet', iif(json_extract(?1, '$.store.well'), 'well',"
    "  'NOT WELL'), json_extract(?1, '$.store.entry_id'), json_extract(?1, '$.store.waiting')),"
    " printf('data %s; backup %s; %s MiB free; heat %s; watchdog %s%s',"
    "  coalesce(json_extract(?1, '$.machine.data'), '?'),"
    "  coalesce(json_extract(?1, '$.machine.backup_min') || ' min old', 'none'),"
    "  coalesce(json_extract(?1, '$.machine.free_mib'), '?'),"
    "  coalesce(json_extract(?1, '$.machine.heat_margin_c') || ' degrees below slowing down',"
    "   'not measured'), coalesce(json_extract(?1, '$.machine.watchdog'), '?'),"
    "  iif(json_extract(?1, '$.machine.clock_day') IS NULL, '; CLOCK NOT SET',"
    "   iif(json_extract(?1, '$.machine.clock_went_back'), '; CLOCK WENT BACK', ''))),"
    " printf('%d refused; %d databases set aside and not seen; %d scores without their replay',"
    "  json_extract(?1, '$.files.refused'), json_extract(?1, '$.files.set_aside'),"
    "  json_extract(?1, '$.files.replays_missed')),"
    " printf('%d; left out because of them: %s', json_extract(?1, '$.panics.count'),"
    "  coalesce(json_extract(?1, '$.panics.left_out'), 'nothing')),"
    " printf('%d, median %.1f ms, p99 %.1f ms; %d ticks dropped',"
    "  json_extract(?1, '$.frames.count'), json_extract(?1, '$.frames.median_ms'),"
    "  json_extract(?1, '$.frames.p99_ms'), json_extract(?1, '$.ticks.dropped'))";

static const char sql_faults[] = "SELECT key || ' ' || value FROM json_each(?1, '$.faults') "
                                 "WHERE value > 0";
static const char sql_devices[] = "SELECT json_extract(value, '$.part'), "
                                  "json_extract(value, '$.text') FROM json_each(?1, '$.devices')";

static void status_print_text(sqlite3 *database, sqlite3_stmt *figures, const char *text)
{
    static const char *const parts[] = { "credits", "tickets", "ledger", "machine",
                                         "files",   "panics",  "frames" };
    const char *gap = "";
    CORE_ASSERT(sqlite3_column_count(figures) == 10);
    print_line(stdout, "%s", (const char *)sqlite3_column_text(figures, 2));
    for (int i = 0; i < (int)(sizeof parts / sizeof parts[0]); i++) {
        print_line(stdout, "  %-9s %s", parts[i],
                   (const char *)sqlite3_column_text(figures, 3 + i));
    }
    printf("  %-9s ", "faults");
    sqlite3_stmt *faults = status_prepare_query(database, sql_faults, text);
    while (sqlite3_step(faults) == SQLITE_ROW) {
        print_part(stdout, "%s%s", gap, (const char *)sqlite3_column_text(faults, 0));
        gap = ", ";
    }
    puts(gap[0] ? "" : "none");
    sqlite3_finalize(faults);
    sqlite3_stmt *devices = status_prepare_query(database, sql_devices, text);
    while (sqlite3_step(devices) == SQLITE_ROW) {
        print_line(stdout, "  %-9s %s", (const char *)sqlite3_column_text(devices, 0),
                   (const char *)sqlite3_column_text(devices, 1));
    }
    sqlite3_finalize(devices);
}

/* ---- Exit code from the status --------------------------------------------------------------- */

static enum exit_code status_exit_code(sqlite3_stmt *figures)
{
    struct timespec now;
    clock_gettime(CLOCK_BOOTTIME, &now);
    const int64_t age_ms =
        (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000 - sqlite3_column_int64(figures, 0);
    if (age_ms > STALE_MS || age_ms < 0) {
        print_error("kingyoctl status: the stall has said nothing for %.1f s: it has ended, or "
                    "stands still",
                    (double)(age_ms < 0 ? STALE_MS : age_ms) * 1e-3);
        return EXIT_NOT_SO;
    }
    if (!sqlite3_column_int(figures, 1)) {
        print_error("kingyoctl status: what is earned is not kept now: look at 'store'");
        return EXIT_NOT_SO;
    }
    return EXIT_OK;
}

static enum exit_code status_print_report(const struct request *request, sqlite3 *database,
                                          const char *text)
{
    sqlite3_stmt *figures = status_prepare_query(database, sql_figures, text);
    const int is_sound = figures && sqlite3_step(figures) == SQLITE_ROW &&
                         sqlite3_column_type(figures, 0) == SQLITE_INTEGER;
    enum exit_code code = EXIT_BAD_DATA;
    if (!is_sound) {
        print_error("kingyoctl status: %s: is no stall's status", request->file);
    } else {
        if (request->as_json) {
            json_copy(text);
        } else {
            status_print_text(database, figures, text);
        }
        /* If the output is incomplete, main() reports the write error. */
        code = print_flush(stdout) == 0 ? status_exit_code(figures) : EXIT_NOT_SO;
    }
    sqlite3_finalize(figures);
    return code;
}

static enum exit_code status_run(int argc, const char *const *argv)
{
    static char text[STATUS_TEXT_MAX];
    struct request request = { NULL, 0 };
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
             "the same as the page Ready? of the operator's menu.\n"
             "Exit code: 0 the kiosk runs and saves what it earns; 1 the kiosk has ended, hangs\n"
             "or cannot save; 65 FILE is not a status file; 74 FILE is missing.\n",
    .run = status_run,
};
