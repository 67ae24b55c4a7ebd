/* test_storage_mirror.c -- the newest entries once more: whatever single thing happens to the
 * database, nothing that was acknowledged is lost with it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "platform/store/storage.h"

#define PAGE_SIZE 4096

static uint32_t boot;
static char dir[64], whole[64], file[128], backup[128], tail_path[128];
static struct storage storage;
static struct hal_storage device;

static void run(const char *command)
{
    assert_int_equal(system(command), 0);
}

static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-tail-XXXXXX");
    strcpy(whole, "/tmp/kingyo-whole-XXXXXX");
    if (!mkdtemp(dir) || !mkdtemp(whole)) {
        return -1;
    }
    snprintf(file, sizeof file, "%s/" STORAGE_FILE, dir);
    snprintf(backup, sizeof backup, "%s/" STORAGE_FILE STORAGE_BACKUP_SUFFIX, dir);
    snprintf(tail_path, sizeof tail_path, "%s/" STORAGE_FILE STORAGE_MIRROR_SUFFIX, dir);
    boot = 1;
    storage = (struct storage){ .dir = dir, .by_hand = 1 };
    device = storage_device(&storage);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    char command[160];
    device.ledger.ops->close(device.ledger.self);
    snprintf(command, sizeof command, "rm -rf %s %s", dir, whole);
    return system(command);
}

static void reopen(void)
{
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .by_hand = 1 };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
}

/* Each round catches as many fish as its id. */
static void hand_over_rounds(uint32_t first, uint32_t last)
{
    for (uint32_t id = first; id <= last; id++) {
        const struct ledger_entry round = {
            .id = id,
            .boot = boot,
            .tick = 100 * id,
            .kind = LEDGER_ROUND,
            .balance = { .paid = id },
            .round = { .id = id, .caught = id, .players = 1, .player = { { .caught = id } } },
        };
        assert_int_equal(device.ledger.ops->append(device.ledger.self, &round), HAL_OK);
    }
    storage_work(&storage);
}

static void play_rounds(uint32_t first, uint32_t last)
{
    hand_over_rounds(first, last);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), last);
}

/* The backup has the first four. */
static void play_eight_and_close(void)
{
    reopen();
    play_rounds(1, 4);
    play_rounds(5, 8);
    device.ledger.ops->close(device.ledger.self);
}

static int ask(const char *path, const char *question)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, question, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

static void has_all_eight(void)
{
    static struct persistent_state memory;
    reopen();
    memset(&memory, 0, sizeof memory);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 8);
    assert_int_equal(memory.ledger.balance.paid, 8);
    assert_int_equal(memory.audits.count[AUDIT_CAUGHT], 36);
    assert_int_equal(ask(file, "SELECT count(*) FROM rounds"), 8);
    assert_int_equal(storage.salvaged.lost, 0);
    play_rounds(9, 9);
}

static void spoil_page(long page)
{
    static const uint8_t dirt[PAGE_SIZE] = { 0xff, 0x5a, 0xff };
    FILE *out = fopen(file, "r+b");
    assert_non_null(out);
    assert_int_equal(fseek(out, page * PAGE_SIZE, SEEK_SET), 0);
    assert_int_equal(fwrite(dirt, sizeof dirt, 1, out), 1);
    fclose(out);
}

static bool is_beside(const char *suffix)
{
    char path[160];
    snprintf(path, sizeof path, "%s%s", file, suffix);
    return access(path, F_OK) == 0;
}

static int mode_beside(const char *suffix)
{
    char path[160];
    struct stat about = { 0 };
    snprintf(path, sizeof path, "%s%s", file, suffix);
    assert_int_equal(stat(path, &about), 0);
    return about.st_mode & 0777;
}

/* ---- What happens to the database ------------------------------------------------------------ */

static void test_whichever_page_is_damaged_nothing_is_lost(void **state)
{
    (void)state;
    char command[256];
    struct stat about;
    play_eight_and_close();
    snprintf(command, sizeof command, "cp %s/* %s/", dir, whole);
    run(command);
    assert_int_equal(stat(file, &about), 0);
    assert_true(about.st_size > 8 * PAGE_SIZE);
    for (long page = 0; page < about.st_size / PAGE_SIZE; page++) {
        snprintf(command, sizeof command, "rm -f %s/* && cp %s/* %s/", dir, whole, dir);
        run(command);
        spoil_page(page);
        has_all_eight();
        device.ledger.ops->close(device.ledger.self);
    }
}

static void test_of_a_file_that_was_removed_nothing_is_lost(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    has_all_eight();
    assert_string_equal(device.ledger.ops->describe(device.ledger.self),
                        "kingyo.db was missing: 4 entries from the backup, 4 later ones, 0 lost");
    assert_true(is_beside(".missing-1"));
    assert_int_equal(mode_beside(".missing-1"), 0600);
}

static void test_without_file_and_tail_nobody_knows_what_is_lost(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    assert_int_equal(unlink(tail_path), 0);
    reopen();
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self),
                           "4 entries from the backup, 0 later ones, unknown how many lost"));
}

static void test_nor_where_all_of_it_is_dirt(void **state)
{
    (void)state;
    play_eight_and_close();
    spoil_page(0);
    assert_int_equal(unlink(backup), 0);
    assert_int_equal(unlink(tail_path), 0);
    reopen();
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self),
                           "damaged-1: 0 entries from the backup, 0 later ones, unknown how many"));
}

/* As where an update first reads a card from end to end. */
static void test_of_one_of_the_third_version_its_rounds_are_read_too(void **state)
{
    static const char old[] = "tests/unit/platform/store/files/version-3.db";
    (void)state;
    char command[256], copy[160];
    snprintf(copy, sizeof copy, "%s/copy", whole);
    snprintf(command, sizeof command, "cp %s %s", old, copy);
    run(command);
    for (long page = 4; page < 8; page++) {
        snprintf(command, sizeof command, "rm -f %s/* && cp %s %s", dir, old, file);
        run(command);
        spoil_page(page);
        reopen();
        assert_int_equal(atomic_load(&storage.aside), 1);
        assert_int_equal(storage.salvaged.lost, 0);
        assert_int_equal(storage.salvaged.entries, ask(copy, "SELECT max(id) FROM entries"));
        device.ledger.ops->close(device.ledger.self);
    }
}

/* No backup could be made for long. */
static void test_what_neither_has_is_counted(void **state)
{
    (void)state;
    play_eight_and_close();
    reopen();
    for (uint32_t id = 9; id < 1401; id += 24) {
        storage.backup_due_s = INT64_MAX;
        storage.backup_id = id;
        play_rounds(id, id + 23u);
    }
    device.ledger.ops->close(device.ledger.self);
    assert_int_equal(ask(backup, "SELECT max(id) FROM entries"), 4);
    assert_int_equal(unlink(file), 0);
    reopen();
    assert_int_equal(storage.from_backup, 4);
    assert_int_equal(storage.salvaged.entries, LEDGER_MIRROR_SLOTS);
    assert_int_equal(storage.salvaged.lost, 1400 - 4 - (int)LEDGER_MIRROR_SLOTS);
}

/* Another stall's card, put in by hand: nothing of the tail that lay there gets into it. */
static void test_a_database_of_another_list_is_not_followed_by_this_tail(void **state)
{
    (void)state;
    char other[160], command[400];
    snprintf(other, sizeof other, "%s/other", whole);
    reopen();
    play_rounds(1, 3);
    device.ledger.ops->close(device.ledger.self);
    assert_int_equal(rename(file, other), 0);
    snprintf(command, sizeof command, "rm -f %s/*", dir);
    run(command);
    boot = 77;
    play_eight_and_close();
    boot = 1;
    assert_int_equal(rename(other, file), 0);
    reopen();
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 3);
    assert_int_equal(atomic_load(&storage.aside), 0);
    assert_true(is_beside(".backup.other-1"));
    assert_true(is_beside(".tail.other-2"));
    play_rounds(4, 4);
}

static void test_nor_of_one_without_a_byte(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(truncate(file, 0), 0);
    has_all_eight();
}

static void test_without_file_and_backup_the_tail_is_what_there_is(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    assert_int_equal(unlink(backup), 0);
    has_all_eight();
}

static void test_a_file_with_less_than_its_tail_is_damage(void **state)
{
    (void)state;
    sqlite3 *db;
    play_eight_and_close();
    assert_int_equal(sqlite3_open(file, &db), SQLITE_OK);
    sqlite3_exec(db, "DELETE FROM entries WHERE id > 6", NULL, NULL, NULL); /* The backup has 4. */
    sqlite3_close(db);
    has_all_eight();
    assert_int_equal(atomic_load(&storage.aside), 1);
}

/* ---- What happens to the tail ---------------------------------------------------------------- */

static void test_a_slot_that_is_not_as_it_was_written_is_no_entry(void **state)
{
    (void)state;
    struct ledger_mirror tail;
    struct ledger_entry found;
    const struct ledger_entry coins[] = { { .id = 7, .kind = LEDGER_COINS },
                                          { .id = 8, .kind = LEDGER_COINS } };
    assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
    assert_int_equal(ledger_mirror_write(&tail, coins, 2), 0);
    assert_int_equal(ledger_mirror_last_id(&tail), 8);
    assert_true(ledger_mirror_entry(&tail, 8, &found));
    assert_false(ledger_mirror_entry(&tail, 8 + LEDGER_MIRROR_SLOTS, &found));
    assert_false(ledger_mirror_entry(&tail, 9, &found));
    ledger_mirror_close(&tail);
    for (long byte = 0; byte < (long)sizeof coins[1] + 16; byte++) {
        FILE *out = fopen(tail_path, "r+b");
        assert_non_null(out);
        fseek(out, 8L * LEDGER_MIRROR_SLOT_SIZE + byte, SEEK_SET);
        const int was = fgetc(out);
        fseek(out, -1, SEEK_CUR);
        fputc(was ^ 4, out);
        fflush(out);
        tail = ledger_mirror_inspect(tail_path);
        assert_int_equal(ledger_mirror_last_id(&tail), 7);
        ledger_mirror_close(&tail);
        fseek(out, -1, SEEK_CUR);
        fputc(was, out);
        fclose(out);
    }
}

static void test_a_newer_entry_takes_the_oldest_ones_slot(void **state)
{
    (void)state;
    struct ledger_mirror tail;
    struct ledger_entry found;
    assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
    for (uint32_t id = 1; id <= LEDGER_MIRROR_SLOTS + 1u; id++) {
        const struct ledger_entry coin = { .id = id, .kind = LEDGER_COINS, .count = id };
        assert_int_equal(ledger_mirror_write(&tail, &coin, 1), 0);
    }
    assert_false(ledger_mirror_entry(&tail, 1, &found));
    assert_true(ledger_mirror_entry(&tail, 2, &found));
    assert_true(ledger_mirror_entry(&tail, LEDGER_MIRROR_SLOTS + 1u, &found));
    assert_int_equal(found.count, LEDGER_MIRROR_SLOTS + 1u);
    ledger_mirror_close(&tail);
}

/* As where a database was copied there by hand: what is not of its list must not get into it. */
static void test_a_tail_of_another_list_is_begun_anew(void **state)
{
    (void)state;
    struct ledger_mirror tail;
    struct ledger_entry found;
    const struct ledger_entry others[] = { { .id = 7, .boot = 77, .kind = LEDGER_COINS },
                                           { .id = 8, .boot = 77, .kind = LEDGER_COINS } };
    play_eight_and_close();
    assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
    assert_int_equal(ledger_mirror_write(&tail, others, 2), 0);
    ledger_mirror_close(&tail);
    reopen();
    play_rounds(9, 9);
    assert_true(ledger_mirror_entry(&storage.tail, 7, &found));
    assert_int_equal(found.boot, 1);
    assert_true(ledger_mirror_entry(&storage.tail, 9, &found));
    assert_true(is_beside(".tail.other-1"));
}

static void test_a_copy_that_is_put_back_has_a_tail_of_its_own(void **state)
{
    (void)state;
    char copy[160];
    snprintf(copy, sizeof copy, "%s/copy", whole);
    reopen();
    play_rounds(1, 2);
    assert_int_equal(ledger_backup_make(&storage.file, copy, true), SQLITE_OK);
    play_rounds(3, 8);
    device.ledger.ops->close(device.ledger.self);
    assert_int_equal(rename(copy, file), 0);
    reopen();
    assert_int_equal(atomic_load(&storage.aside), 0);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 2);
    play_rounds(3, 3);
    assert_int_equal(ledger_mirror_last_id(&storage.tail), 3);
}

static void test_a_card_that_refuses_the_tail_alone_has_nothing_acknowledged(void **state)
{
    (void)state;
    struct ledger_entry found;
    reopen();
    assert_int_equal(mkdir(tail_path, 0755), 0); /* At the start it would be set aside. */
    hand_over_rounds(1, 3);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 0);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_non_null(
        strstr(device.ledger.ops->describe(device.ledger.self), "second copy is not written"));
    hand_over_rounds(4, 4);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 0);
    assert_int_equal(rmdir(tail_path), 0);
    play_rounds(5, 5);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    assert_null(strstr(device.ledger.ops->describe(device.ledger.self), "second copy"));
    for (uint32_t id = 1; id <= 5; id++) {
        assert_true(ledger_mirror_entry(&storage.tail, id, &found));
        assert_int_equal(found.round.caught, id);
    }
}

static void test_entries_that_only_the_tail_lacks_are_not_lost_at_the_end(void **state)
{
    (void)state;
    reopen();
    assert_int_equal(mkdir(tail_path, 0755), 0); /* At the start it would be set aside. */
    hand_over_rounds(1, 3);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(ask(file, "SELECT max(id) FROM entries"), 3);
}

static void test_a_tail_that_is_removed_is_written_whole_anew(void **state)
{
    (void)state;
    struct ledger_entry found;
    reopen();
    play_rounds(1, 4);
    assert_int_equal(unlink(tail_path), 0);
    play_rounds(5, 5);
    struct ledger_mirror tail = ledger_mirror_inspect(tail_path);
    assert_true(ledger_mirror_entry(&tail, 1, &found));
    assert_int_equal(ledger_mirror_last_id(&tail), 5);
    ledger_mirror_close(&tail);
}

static void test_a_name_that_is_taken_back_is_not_left_in_it(void **state)
{
    (void)state;
    struct ledger_entry found;
    struct ledger_entry name = {
        .id = 1, .boot = 1, .kind = LEDGER_NAME, .count = 9, .detail = 1, .name = "A WORD"
    };
    reopen();
    device.ledger.ops->append(device.ledger.self, &name);
    storage_work(&storage);
    memset(name.name, 0, sizeof name.name);
    name.id = 2;
    device.ledger.ops->append(device.ledger.self, &name);
    storage_work(&storage);
    assert_true(ledger_mirror_entry(&storage.tail, 1, &found));
    assert_string_equal(found.name, "");
}

static void test_a_backup_comes_before_the_tail_bites_itself(void **state)
{
    (void)state;
    reopen();
    play_rounds(1, 1);
    for (uint32_t id = 2; id < 2u + STORAGE_BACKUP_ENTRIES; id += LEDGER_RING) {
        play_rounds(id, id + LEDGER_RING - 1u);
    }
    assert_int_equal(ask(backup, "SELECT max(id) FROM entries"), 1 + (int)STORAGE_BACKUP_ENTRIES);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_whichever_page_is_damaged_nothing_is_lost),
        TEST(test_of_a_file_that_was_removed_nothing_is_lost),
        TEST(test_without_file_and_tail_nobody_knows_what_is_lost),
        TEST(test_nor_where_all_of_it_is_dirt),
        TEST(test_of_one_of_the_third_version_its_rounds_are_read_too),
        TEST(test_what_neither_has_is_counted),
        TEST(test_a_database_of_another_list_is_not_followed_by_this_tail),
        TEST(test_nor_of_one_without_a_byte),
        TEST(test_without_file_and_backup_the_tail_is_what_there_is),
        TEST(test_a_file_with_less_than_its_tail_is_damage),
        TEST(test_a_slot_that_is_not_as_it_was_written_is_no_entry),
        TEST(test_a_newer_entry_takes_the_oldest_ones_slot),
        TEST(test_a_tail_of_another_list_is_begun_anew),
        TEST(test_a_copy_that_is_put_back_has_a_tail_of_its_own),
        TEST(test_a_card_that_refuses_the_tail_alone_has_nothing_acknowledged),
        TEST(test_entries_that_only_the_tail_lacks_are_not_lost_at_the_end),
        TEST(test_a_tail_that_is_removed_is_written_whole_anew),
        TEST(test_a_name_that_is_taken_back_is_not_left_in_it),
        TEST(test_a_backup_comes_before_the_tail_bites_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
