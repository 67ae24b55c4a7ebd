/* test_panic_recovery.c -- Tests the recovery after several panics. The next start omits stored
 * settings. The omission is recorded only after this start has succeeded. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <semaphore.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/cpu.h"
#include "platform/kiosk/recorder/panic_recovery.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/ledger_backup.h"

static char dir[32];
static char path[64];
static int folder;
static int flock_error;      /* errno that each call of flock() sets, or 0 if flock() succeeds. */
static struct panics during; /* Number of panics in the file at the time of the last database
                                copy. */
static int copies;           /* Number of copies of the database. Each copy calls chmod() once. */
static struct evidence evidence;

int flock(int handle, int operation)
{
    if (flock_error) {
        errno = flock_error;
        return -1;
    }
    return (int)syscall(SYS_flock, handle, operation);
}

/* Semaphore on which each thread waits instead of ten minutes of real time. sem_post() ends the
 * wait. */
static sem_t ten_minutes;

int clock_nanosleep(clockid_t clock, int flags, const struct timespec *wait, struct timespec *left)
{
    (void)clock;
    (void)flags;
    (void)left;
    assert_int_equal(wait->tv_sec, 600);
    sem_wait(&ten_minutes);
    return 0;
}

int chmod(const char *name, mode_t mode)
{
    copies++;
    panics_read(&during, folder);
    return fchmodat(AT_FDCWD, name, mode, 0);
}

static void fill(void)
{
    static struct ledger_file file;
    const struct ledger_entry entry = {
        .id = 1, .boot = 1, .kind = LEDGER_SETTING, .detail = SET_VOLUME, .value = 30
    };
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(ledger_file_write(&file, &entry, 1), 0);
    ledger_file_close(&file);
}

static bool has_volume(void)
{
    static struct ledger_file file;
    assert_int_equal(ledger_file_inspect(&file, path), 0);
    const int has = file.content.has_setting[SET_VOLUME];
    ledger_file_close(&file);
    return has;
}

/* Writes the panic file as after one panic before the first frame. */
static void panic_early(void)
{
    struct panics panics = { 0 };
    panics_add(&panics, panics_boot(), panics_up_s(), 1, 0);
    assert_int_equal(panics_write(&panics, folder), 0);
}

static struct panics read_count(void)
{
    struct panics panics;
    assert_int_equal(panics_read(&panics, folder), 0);
    return panics;
}

static void start(void)
{
    panic_evidence_open(&evidence, dir, NULL, NULL);
    close(evidence.folder - 1);
}

static void block_copies(int blocks)
{
    char name[96];
    for (unsigned i = 1; i <= LEDGER_LEFT_MAX; i++) {
        snprintf(name, sizeof name, "%s.left-out-%u", path, i);
        assert_int_equal(blocks ? symlink("nowhere", name) : unlink(name), 0);
    }
}

static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-evidence-XXXXXX");
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/kingyo.db", dir);
    folder = open(dir, O_RDONLY | O_DIRECTORY);
    flock_error = copies = 0;
    memset(&during, 0, sizeof during);
    panic_early();
    return folder < 0;
}

static int tear_down(void **state)
{
    (void)state;
    char command[64];
    close(folder);
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
}

static void assert_left_out(void)
{
    const struct panics now = read_count();
    assert_int_equal(now.left, LEFT_SETTINGS);
    assert_true(now.left_boot == panics_boot());
    assert_int_equal(now.attempt, LEFT_NOTHING);
    assert_false(panics_is_due(&now));
    assert_false(has_volume());
}

static void assert_nothing_changed(void)
{
    const struct panics now = read_count();
    assert_int_equal(now.left, LEFT_NOTHING);
    assert_true(now.left_boot == 0);
    assert_int_equal(now.attempt, LEFT_NOTHING);
    assert_int_equal(now.count, 1);
    assert_true(panics_is_due(&now));
    assert_true(has_volume());
}

static void test_an_attempt_is_on_disk_while_settings_are_left_out(void **state)
{
    (void)state;
    fill();
    start();
    assert_int_equal(copies, 1);
    assert_int_equal(during.attempt, LEFT_SETTINGS);
    assert_int_equal(during.left, LEFT_NOTHING);
    assert_left_out();
}

static void test_a_failed_attempt_changes_nothing_and_is_retried_at_the_next_start(void **state)
{
    (void)state;
    fill();
    block_copies(1);
    start();
    assert_nothing_changed();
    block_copies(0);
    start();
    assert_left_out();
}

/* Ends the wait of ten minutes in each thread that a test has started. Then waits until the panic
 * count is 0. */
static void end_ten_minutes(void)
{
    for (int i = 0; i < 8; i++) {
        sem_post(&ten_minutes);
    }
    for (int i = 0; i < 2000 && read_count().count > 0; i++) {
        poll(NULL, 0, 1);
    }
    while (sem_trywait(&ten_minutes) == 0) {
    }
}

static void test_a_good_run_after_a_failed_attempt_clears_the_count(void **state)
{
    (void)state;
    fill();
    block_copies(1);
    panic_evidence_open(&evidence, dir, NULL, NULL);
    assert_nothing_changed();
    panic_evidence_note_frame(&evidence);
    end_ten_minutes();
    close(evidence.folder - 1);
    const struct panics now = read_count();
    assert_false(panics_is_due(&now));
    assert_int_equal(now.total, 1);
    block_copies(0);
    start();
    assert_true(has_volume());
}

static void test_a_panic_after_a_failed_attempt_makes_the_next_start_retry(void **state)
{
    (void)state;
    static struct core core;
    fill();
    block_copies(1);
    panic_evidence_open(&evidence, dir, NULL, &core);
    panic_evidence_write(&evidence, "a test");
    panic_evidence_note_frame(&evidence);
    sem_post(&ten_minutes);
    poll(NULL, 0, 100);
    close(evidence.folder - 1);
    assert_int_equal(read_count().count, 2);
    block_copies(0);
    start();
    assert_left_out();
}

static void test_a_start_without_a_database_clears_the_count(void **state)
{
    (void)state;
    start();
    const struct panics now = read_count();
    assert_int_equal(now.left, LEFT_NOTHING);
    assert_false(panics_is_due(&now));
    fill();
    start();
    assert_true(has_volume());
}

static void test_a_folder_locked_by_another_process_is_not_changed(void **state)
{
    (void)state;
    fill();
    const int hold = file_lock_folder(dir);
    assert_true(hold >= 0);
    start();
    assert_nothing_changed();
    close(hold);
    start();
    assert_left_out();
}

static void test_recovery_omits_settings_on_a_file_system_without_flock(void **state)
{
    (void)state;
    fill();
    flock_error = ENOLCK;
    start();
    assert_left_out();
}

static void test_a_panic_inside_an_attempt_makes_the_next_start_skip_it(void **state)
{
    (void)state;
    struct panics panics = read_count();
    fill();
    panics_try(&panics);
    panics_add(&panics, panics_boot(), panics_up_s(), 0, 0);
    assert_int_equal(panics_write(&panics, folder), 0);
    start();
    assert_int_equal(copies, 0);
    assert_true(has_volume());
    panics = read_count();
    assert_int_equal(panics.total, 2);
    assert_int_equal(panics.left, LEFT_NOTHING);
    assert_int_equal(panics.attempt, LEFT_NOTHING);
    assert_false(panics_is_due(&panics));
}

/* In the first call, `is_busy` is set, as if another thread were in the middle of a tick.
 * panic_evidence_write() must then return false, because that thread may still change the core. */
static void test_a_panic_of_another_thread_reports_an_unfinished_tick(void **state)
{
    static struct session_recorder sessions;
    (void)state;
    panic_evidence_open(&evidence, "", &sessions, NULL);
    evidence.thread = getpid() + 1;
    atomic_store(&sessions.is_busy, 1);
    assert_int_equal(panic_evidence_write(&evidence, "test"), 0);
    assert_true(atomic_load(&sessions.is_frozen));
    atomic_store(&sessions.is_busy, 0);
    assert_int_equal(panic_evidence_write(&evidence, "test"), 1);
}

static void test_only_the_owner_may_read_a_panic_replay(void **state)
{
    static struct session_recorder sessions;
    static struct core core;
    struct core_config config = { .seed = 3, .lanes = cpu_lanes() };
    struct stat about;
    (void)state;
    settings_reset(&config.persistent.settings);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    session_recorder_begin(&sessions, &core);
    panic_evidence_open(&evidence, dir, &sessions, &core);
    const mode_t before = umask(0);
    panic_evidence_write(&evidence, "a test");
    umask(before);
    char name[] = "panic-0.kgr";
    name[6] = (char)('0' + (evidence.panics.total - 1u) % PANICS_FILES);
    assert_int_equal(fstatat(folder, name, &about, 0), 0);
    assert_int_equal(about.st_mode & 07777, 0600);
    assert_int_equal(unlinkat(folder, name, 0), 0);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_an_attempt_is_on_disk_while_settings_are_left_out),
        TEST(test_a_failed_attempt_changes_nothing_and_is_retried_at_the_next_start),
        TEST(test_a_good_run_after_a_failed_attempt_clears_the_count),
        TEST(test_a_panic_after_a_failed_attempt_makes_the_next_start_retry),
        TEST(test_a_start_without_a_database_clears_the_count),
        TEST(test_a_folder_locked_by_another_process_is_not_changed),
        TEST(test_recovery_omits_settings_on_a_file_system_without_flock),
        TEST(test_a_panic_inside_an_attempt_makes_the_next_start_skip_it),
        TEST(test_a_panic_of_another_thread_reports_an_unfinished_tick),
        TEST(test_only_the_owner_may_read_a_panic_replay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
