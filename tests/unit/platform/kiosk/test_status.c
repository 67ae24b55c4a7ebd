/* test_status.c -- Tests the status file. A reader must never see an incomplete file, and writing
 * the file must never block a frame. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "drivers/null.h"
#include "platform/kiosk/status.h"

static struct status status;
static struct kiosk kiosk;
static char folder[] = "/tmp/kingyo-status-XXXXXX";
static char path[64];

static int set_up(void **state)
{
    (void)state;
    strcpy(folder + sizeof folder - 7, "XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/status.json", folder);
    memset(&kiosk, 0, sizeof kiosk);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

static void read_text(char text[STATUS_TEXT_MAX])
{
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, STATUS_TEXT_MAX - 1u, file)] = '\0';
    fclose(file);
}

/* Asserts that `text` is valid JSON, and that the value at the JSON path `where` is `expected`.
 * SQLite is used as the parser. */
static void check_json(const char *text, const char *where, const char *expected)
{
    sqlite3 *database;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open(":memory:", &database), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(database, "SELECT json_valid(?1), json_extract(?1, ?2)", -1,
                                        &statement, NULL),
                     SQLITE_OK);
    sqlite3_bind_text(statement, 1, text, -1, SQLITE_STATIC);
    sqlite3_bind_text(statement, 2, where, -1, SQLITE_STATIC);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    assert_int_equal(sqlite3_column_int(statement, 0), 1);
    assert_non_null(sqlite3_column_text(statement, 1));
    assert_string_equal((const char *)sqlite3_column_text(statement, 1), expected);
    sqlite3_finalize(statement);
    sqlite3_close(database);
}

/* A status report in which every value differs from its default. */
static const struct status_report full_report = {
    .written_ms = 5000000000ull,
    .pid = 1234,
    .up_s = 60,
    .boot = 7,
    .phase = PHASE_ROUND,
    .players = 2,
    .balance = { .paid = 3,
                 .service = 4,
                 .units = 1,
                 .unlogged = 2,
                 .open = PAYMENT_PAID,
                 .tickets = 6 },
    .tickets_out = 40,
    .entry_id = 90,
    .saved_id = 88,
    .store_well = 1,
    .has_picture = true,
    .frames = 600,
    .dropped_ticks = 9,
    .ticks = 7200,
    .frame_median_ns = 16700000,
    .frame_p99_ns = 18000000,
    .faults = { .poi = 1,
                .shade = 2,
                .display = 3,
                .audio = 4,
                .storage = 5,
                .buttons = 6,
                .switches = 7 },
    .day = 9000,
    .minute = 61,
    .files_refused = 3,
    .machine = { .is_checked = 1,
                 .keeps = KEEPS_PROVEN,
                 .watch = WATCH_OK,
                 .has_backup = 1,
                 .backup_min = 12,
                 .room_mib = 345,
                 .has_heat = 1,
                 .heat_margin_c = -2,
                 .is_clock_back = 1,
                 .quarantined = 2,
                 .missed = 5,
                 .panics = 8,
                 .left_out = 2 },
    .buttons_missing = 5,
    .float_resets = 11,
    .device_count = 1,
    .device = { { "poi", "mouse" } },
};

/* Expected value at each JSON path of the status file of full_report. */
static const struct {
    const char *where, *value;
} expected[] = {
    { "$.version", KINGYO_VERSION },
    { "$.pid", "1234" },
    { "$.written_ms", "5000000000" },
    { "$.up_s", "60" },
    { "$.boot", "7" },
    { "$.phase", "round" },
    { "$.players", "2" },
    { "$.credits.paid", "3" },
    { "$.credits.service", "4" },
    { "$.credits.units", "1" },
    { "$.credits.untold", "2" },
    { "$.credits.round_open", "1" },
    { "$.tickets.owed", "6" },
    { "$.tickets.dispensed", "40" },
    { "$.store.well", "1" },
    { "$.store.entry_id", "90" },
    { "$.store.saved_id", "88" },
    { "$.store.waiting", "2" },
    { "$.frames.shown", "1" },
    { "$.frames.count", "600" },
    { "$.frames.median_ms", "16.7" },
    { "$.frames.p99_ms", "18.0" },
    { "$.ticks.dropped", "9" },
    { "$.ticks.count", "7200" },
    { "$.faults.poi", "1" },
    { "$.faults.fan", "2" },
    { "$.faults.display", "3" },
    { "$.faults.sound", "4" },
    { "$.faults.store", "5" },
    { "$.faults.buttons", "6" },
    { "$.faults.switches", "7" },
    { "$.faults.buttons_missing", "2" },
    { "$.faults.float", "11" },
    { "$.machine.data", "proven" },
    { "$.machine.backup_min", "12" },
    { "$.machine.free_mib", "345" },
    { "$.machine.heat_margin_c", "-2" },
    { "$.machine.watchdog", "fed" },
    { "$.machine.clock_day", "9000" },
    { "$.machine.clock_minute", "61" },
    { "$.machine.clock_went_back", "1" },
    { "$.files.refused", "3" },
    { "$.files.set_aside", "2" },
    { "$.files.replays_missed", "5" },
    { "$.panics.count", "8" },
    { "$.panics.left_out", "settings and replays" },
    { "$.devices[0].part", "poi" },
    { "$.devices[0].text", "mouse" },
};

static void test_the_status_file_contains_every_value(void **state)
{
    static char text[STATUS_TEXT_MAX];
    (void)state;
    const size_t size = status_format(&full_report, text);
    assert_int_equal(size, strlen(text));
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        check_json(text, expected[i].where, expected[i].value);
    }
    /* board/image/slots/mark-good searches for this text. */
    assert_non_null(strstr(text, "\n  \"frames\": {"));
    assert_non_null(strstr(text, ", \"shown\": true},\n"));
}

static void test_an_unmeasured_value_is_null(void **state)
{
    static char text[STATUS_TEXT_MAX];
    static const struct status_report report;
    static const char *const unknown[] = { "backup_min", "free_mib", "heat_margin_c", "clock_day",
                                           "clock_minute" };
    (void)state;
    status_format(&report, text);
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        char words[64];
        snprintf(words, sizeof words, "\"%s\": null", unknown[i]);
        assert_non_null(strstr(text, words));
    }
    check_json(text, "$.machine.data", "unknown");
    check_json(text, "$.machine.watchdog", "none");
}

static void test_a_device_name_is_escaped(void **state)
{
    static char text[STATUS_TEXT_MAX];
    struct status_report report = { .device_count = 1, .device = { { "usb", "" } } };
    (void)state;
    snprintf(report.device[0].text, HAL_TEXT_SIZE, "%s", "a\"b\\c\n\x01\x7F 金魚");
    status_format(&report, text);
    check_json(text, "$.devices[0].text", "a\"b\\c\n\x01\x7F 金魚");
}

static void test_invalid_utf8_is_replaced(void **state)
{
    static const char *const rows[][2] = {
        { "a\xFF"
          "b",
          "a\uFFFD"
          "b" },
        { "\xC3", "\uFFFD" },
        /* The first two bytes of a UTF-8 character of three bytes. */
        { "\xE9\x87", "\uFFFD\uFFFD" },
        { "\xC0\xAF", "\uFFFD\uFFFD" },
        { "\xED\xA0\x80", "\uFFFD\uFFFD\uFFFD" },
        { "\xF4\x90\x80\x80", "\uFFFD\uFFFD\uFFFD\uFFFD" },
        { "\u00E9\u91D1\U0001F41F", "\u00E9\u91D1\U0001F41F" },
    };
    static char text[STATUS_TEXT_MAX];
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct status_report report = { .device_count = 1, .device = { { "usb", "" } } };
        snprintf(report.device[0].text, HAL_TEXT_SIZE, "%s", rows[i][0]);
        status_format(&report, text);
        check_json(text, "$.devices[0].text", rows[i][1]);
    }
}

static void test_the_longest_status_report_fits_its_buffer(void **state)
{
    static char text[STATUS_TEXT_MAX];
    static struct status_report report;
    (void)state;
    memset(&report, 0xFF, sizeof report);
    report.device_count = STATUS_DEVICES_MAX;
    for (uint32_t i = 0; i < STATUS_DEVICES_MAX; i++) {
        report.device[i].part = "switches";
        /* The character with the code 1 is escaped with six characters (\u0001), so the text has
         * its maximum length. */
        memset(report.device[i].text, 1, HAL_TEXT_SIZE - 1u);
        report.device[i].text[HAL_TEXT_SIZE - 1u] = '\0';
    }
    assert_in_range(status_format(&report, text), STATUS_DEVICES_MAX * HAL_TEXT_SIZE,
                    STATUS_TEXT_MAX - 1u);
    check_json(text, "$.phase", "other");
}

/* Waits up to 5 s for the file. Returns 1 if the file exists. */
static int waits_for_file(void)
{
    const struct timespec rest = { .tv_nsec = 1000000 };
    for (int i = 0; i < 5000 && access(path, F_OK) != 0; i++) {
        nanosleep(&rest, NULL);
    }
    return access(path, F_OK) == 0;
}

static void test_the_status_file_exists_only_while_the_kiosk_runs(void **state)
{
    static char text[STATUS_TEXT_MAX];
    const struct hal hal = null_hal(NULL);
    struct stat about;
    (void)state;
    kiosk.frames = 5;
    const mode_t mask = umask(0077);
    status_begin(&status, folder);
    status_update(&status, &kiosk, &hal, 0);
    assert_true(waits_for_file());
    umask(mask);
    read_text(text);
    check_json(text, "$.frames.count", "5");
    assert_int_equal(stat(path, &about), 0);
    assert_int_equal(about.st_mode & 0777, 0644); /* The file must be readable for all users,
                                                     although the umask is 0077. */
    status_end(&status);
    assert_int_equal(access(path, F_OK), -1);
}

static void test_the_status_file_is_written_once_a_second(void **state)
{
    const struct hal hal = null_hal(NULL);
    (void)state;
    status_begin(&status, folder);
    status_update(&status, &kiosk, &hal, 5);
    assert_true(waits_for_file());
    assert_int_equal(unlink(path), 0);
    status_update(&status, &kiosk, &hal, 5 + STATUS_PERIOD_NS - 1u);
    assert_int_equal(status.is_fresh, 0);
    assert_int_equal(access(path, F_OK), -1);
    status_update(&status, &kiosk, &hal, 5 + STATUS_PERIOD_NS);
    assert_true(waits_for_file());
    status_end(&status);
}

static void test_a_store_fault_is_written_to_the_status_immediately(void **state)
{
    static char text[STATUS_TEXT_MAX];
    const struct hal hal = null_hal(NULL);
    const uint8_t was_well = kiosk.input.store_well;
    (void)state;
    kiosk.input.store_well = 1;
    status_begin(&status, folder);
    status_update(&status, &kiosk, &hal, 5);
    assert_true(waits_for_file());
    assert_int_equal(unlink(path), 0);
    kiosk.input.store_well = 0;
    /* The first call cannot pass on the fault, because the mutex is locked. The next call must pass
     * it on. */
    pthread_mutex_lock(&status.mutex);
    status_update(&status, &kiosk, &hal, 6);
    pthread_mutex_unlock(&status.mutex);
    status_update(&status, &kiosk, &hal, 7);
    assert_true(waits_for_file());
    read_text(text);
    check_json(text, "$.store.well", "0");
    status_end(&status);
    kiosk.input.store_well = was_well;
}

static void test_no_frame_waits_for_the_status_file(void **state)
{
    const struct hal hal = null_hal(NULL);
    (void)state;
    status_begin(&status, folder);
    /* The test locks the mutex, as the writing thread does while it copies a report. */
    pthread_mutex_lock(&status.mutex);
    status_update(&status, &kiosk, &hal, 0);
    assert_int_equal(status.is_fresh, 0); /* status_update() must skip the report instead of waiting
                                             for the mutex. */
    pthread_mutex_unlock(&status.mutex);
    status_end(&status);
}

static void test_without_a_folder_no_status_file_is_written(void **state)
{
    const struct hal hal = null_hal(NULL);
    static const char *const none[] = { NULL, "", "run/kingyo" };
    (void)state;
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        status_begin(&status, none[i]);
        assert_int_equal(status.runs, 0);
        status_update(&status, &kiosk, &hal, 0);
        status_end(&status);
    }
}

static void test_a_deleted_status_folder_is_counted_and_tolerated(void **state)
{
    const struct hal hal = null_hal(NULL);
    (void)state;
    status_begin(&status, "/tmp/kingyo-no-such-folder");
    status_update(&status, &kiosk, &hal, 0);
    const struct timespec rest = { .tv_nsec = 1000000 };
    for (int i = 0; i < 5000 && atomic_load(&status.failed) == 0; i++) {
        nanosleep(&rest, NULL);
    }
    status_end(&status);
    assert_int_equal(atomic_load(&status.failed), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_status_file_contains_every_value),
        cmocka_unit_test(test_an_unmeasured_value_is_null),
        cmocka_unit_test(test_a_device_name_is_escaped),
        cmocka_unit_test(test_invalid_utf8_is_replaced),
        cmocka_unit_test(test_the_longest_status_report_fits_its_buffer),
        cmocka_unit_test_setup_teardown(test_the_status_file_exists_only_while_the_kiosk_runs,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_the_status_file_is_written_once_a_second, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_a_store_fault_is_written_to_the_status_immediately,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_no_frame_waits_for_the_status_file, set_up, tear_down),
        cmocka_unit_test(test_without_a_folder_no_status_file_is_written),
        cmocka_unit_test(test_a_deleted_status_folder_is_counted_and_tolerated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
