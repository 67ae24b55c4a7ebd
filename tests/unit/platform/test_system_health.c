/* test_system_health.c -- Tests the state of the machine that the operator's menu shows: storage,
 * backup, clock, temperature and quarantined files. Files in a temporary folder simulate the
 * machine. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/system_health.h"

static char root[64], checked[96], heat[96];
static time_t calendar_ahead_s, monotonic_ahead_s;

/* Replaces the function of the C library, so that a test can set the calendar and the monotonic
 * clock ahead. */
int clock_gettime(clockid_t clock, struct timespec *out)
{
    const int result = (int)syscall(SYS_clock_gettime, clock, out);
    out->tv_sec += clock == CLOCK_REALTIME ? calendar_ahead_s : monotonic_ahead_s;
    return result;
}

static void write_file(const char *name, const char *words)
{
    char path[192];
    snprintf(path, sizeof path, "%s/%s", root, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(words, file);
    fclose(file);
}

static int set_up(void **state)
{
    (void)state;
    calendar_ahead_s = monotonic_ahead_s = 0;
    strcpy(root, "/var/tmp/kingyo-machine-XXXXXX");
    if (!mkdtemp(root)) {
        return -1;
    }
    snprintf(checked, sizeof checked, "%s/checked", root);
    snprintf(heat, sizeof heat, "%s/heat", root);
    return 0;
}

static int tear_down(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -r %s", root);
    return system(command);
}

static struct system_health machine_here(void)
{
    return (struct system_health){ .data = root, .checked = checked, .heat = heat };
}

static struct scene_machine look(struct system_health *machine)
{
    struct scene_machine status = { .watch = WATCH_FAIL, .missed = 3 };
    system_health_sample(machine, &status);
    assert_int_equal(status.is_checked, 1);
    /* `watch` and `missed` belong to the frame loop, so a sample must not change them. */
    assert_int_equal(status.watch, WATCH_FAIL);
    assert_int_equal(status.missed, 3);
    return status;
}

static void test_the_board_check_reports_whether_data_persist(void **state)
{
    struct system_health machine = machine_here(), nowhere = { .checked = checked, .heat = heat };
    struct system_health gone = { .data = "/nowhere/at/all", .checked = checked, .heat = heat };
    struct system_health memory = { .data = "/dev/shm", .checked = checked, .heat = heat };
    (void)state;
    assert_int_equal(look(&machine).keeps, KEEPS_FOLDER);
    write_file("checked", "kept: /dev/mmcblk0p3, ext4; start 7 of this disk, ...\n");
    assert_int_equal(look(&machine).keeps, KEEPS_PROVEN);
    /* `memory` describes a kiosk with another data folder, for which the file `checked` is not
     * valid. */
    assert_int_equal(look(&memory).keeps, KEEPS_MEMORY);
    write_file("checked", "not kept: /dev/loop0 is memory\n");
    assert_int_equal(look(&machine).keeps, KEEPS_NOT);
    write_file("checked", "");
    assert_int_equal(look(&machine).keeps, KEEPS_FOLDER);
    assert_int_equal(look(&nowhere).keeps, KEEPS_NOWHERE);
    assert_int_equal(look(&gone).keeps, KEEPS_NOWHERE);
    assert_int_equal(look(&gone).room_mib, 0);
    assert_true(look(&machine).room_mib > 0);
}

static void test_the_backup_age_uses_the_monotonic_clock(void **state)
{
    struct system_health machine = machine_here();
    (void)state;
    assert_int_equal(look(&machine).has_backup, 0);
    write_file("kingyo.db.backup", "x");
    assert_int_equal(look(&machine).has_backup, 1);
    assert_int_equal(look(&machine).backup_min, 0);
    calendar_ahead_s = 40 * 365 * 86400; /* The calendar jumps ahead by 40 years, as when the
                                            network time is set. The age of the backup must not
                                            jump. */
    assert_int_equal(look(&machine).backup_min, 0);
    monotonic_ahead_s = 61 * 60;
    assert_int_equal(look(&machine).backup_min, 61);
    write_file("kingyo.db.backup.new", "y");
    char from[160], to[160];
    snprintf(from, sizeof from, "%s/kingyo.db.backup.new", root);
    snprintf(to, sizeof to, "%s/kingyo.db.backup", root);
    /* A new backup has replaced the old one, so the age of the backup is 0 again. */
    assert_int_equal(rename(from, to), 0);
    assert_int_equal(look(&machine).backup_min, 0);
}

static void test_an_earlier_backup_has_the_age_of_its_date(void **state)
{
    struct system_health machine = machine_here();
    (void)state;
    write_file("kingyo.db.backup", "x");
    calendar_ahead_s = 5 * 3600;
    assert_in_range(look(&machine).backup_min, 299, 301);
}

static void test_a_clock_older_than_the_files_was_set_back(void **state)
{
    struct system_health machine = machine_here(), later = machine_here();
    (void)state;
    write_file("kingyo.db", "x");
    assert_int_equal(look(&machine).is_clock_back, 0);
    /* A clock that is set back by one hour is no error, because this happens at the end of daylight
     * saving time. */
    calendar_ahead_s = -3600;
    assert_int_equal(look(&machine).is_clock_back, 0);
    calendar_ahead_s = -86400;
    assert_int_equal(look(&later).is_clock_back, 1);
    /* This write gives the file the same wrong time as the clock. The error must still be reported,
     * because an earlier check has found it. */
    write_file("kingyo.db", "xx");
    assert_int_equal(look(&later).is_clock_back, 1);
    calendar_ahead_s = 0;
    assert_int_equal(look(&later).is_clock_back, 0);
}

static void test_the_thermal_margin_is_reported_if_a_sensor_exists(void **state)
{
    struct system_health machine = machine_here();
    char zone[128];
    (void)state;
    assert_int_equal(look(&machine).has_heat, 0);
    mkdir(heat, 0700);
    snprintf(zone, sizeof zone, "%s/thermal_zone0", heat);
    mkdir(zone, 0700);
    write_file("heat/thermal_zone0/temp", "71500\n");
    assert_int_equal(look(&machine).has_heat, 1);
    assert_int_equal(look(&machine).heat_margin_c, 8);
    write_file("heat/thermal_zone0/temp", "83000\n");
    assert_int_equal(look(&machine).heat_margin_c, -3);
}

static void test_a_quarantined_file_is_counted_until_acknowledged(void **state)
{
    struct system_health machine = machine_here();
    (void)state;
    write_file("kingyo.db.damaged-1", "x");
    /* This log belongs to the quarantined database 1, so it must not be counted. */
    write_file("kingyo.db.damaged-1-wal", "x");
    write_file("kingyo.db.damaged-2", "x");
    /* This name has no number, so it must not be counted. Kingyo never creates such a file. */
    write_file("kingyo.db.damaged-", "x");
    assert_int_equal(look(&machine).quarantined, 2);
    assert_int_equal(system_health_mark_seen(&machine), 0);
    assert_int_equal(look(&machine).quarantined, 0);
    assert_true(system_health_is_seen(root, "kingyo.db.damaged-2"));
    struct system_health restarted = machine_here();
    assert_int_equal(look(&restarted).quarantined, 0);
    write_file("kingyo.db.damaged-3", "x");
    assert_int_equal(look(&restarted).quarantined, 1);
    assert_int_equal(system_health_quarantine_of("kingyo.db.damaged-1.seen"),
                     SYSTEM_HEALTH_QUARANTINE_NONE);
    write_file("kingyo.db.missing-4", "");
    write_file("kingyo.db.tail.other-5", "");
    write_file("kingyo.db.backup.other-6", "");
    assert_int_equal(look(&restarted).quarantined, 4);
}

static bool is_reported(struct system_health *machine, uint32_t aside)
{
    struct scene_machine status = { .watch = WATCH_OK };
    /* The interval of the checks is longer than the 5 s of this loop. The test therefore passes
     * only if the thread checks at once. */
    for (uint32_t i = 0; i < 500u; i++) {
        system_health_read(machine, &status);
        if (status.is_checked && status.quarantined == aside) {
            return status.watch == WATCH_OK;
        }
        usleep(10000);
    }
    return false;
}

static void test_the_health_thread_does_all_file_access_of_the_frame_loop(void **state)
{
    static struct system_health machine;
    struct scene_machine status = { 0 };
    (void)state;
    write_file("kingyo.db.damaged-1", "x");
    machine = machine_here();
    system_health_read(&machine, &status); /* The thread has not been started, so nothing has been
                                            checked yet. */
    assert_int_equal(status.is_checked, 0);
    system_health_start(&machine);
    assert_true(is_reported(&machine, 1));
    system_health_acknowledge(&machine);
    assert_true(is_reported(&machine, 0));
    /* The test holds the lock, as the thread does from time to time. system_health_read() must
     * return at once and leave the values unchanged. */
    pthread_mutex_lock(&machine.lock);
    status = (struct scene_machine){ .room_mib = 77 };
    system_health_read(&machine, &status);
    assert_int_equal(status.room_mib, 77);
    system_health_acknowledge(&machine); /* system_health_acknowledge() must not block while the
                                            lock is held. */
    pthread_mutex_unlock(&machine.lock);
    system_health_stop(&machine);
    assert_true(system_health_is_seen(root, "kingyo.db.damaged-1"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_the_board_check_reports_whether_data_persist, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_the_backup_age_uses_the_monotonic_clock, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_an_earlier_backup_has_the_age_of_its_date, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_a_clock_older_than_the_files_was_set_back, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(test_the_thermal_margin_is_reported_if_a_sensor_exists,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_quarantined_file_is_counted_until_acknowledged,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(
            test_the_health_thread_does_all_file_access_of_the_frame_loop, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
