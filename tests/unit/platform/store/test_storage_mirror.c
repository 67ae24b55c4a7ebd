/* test_storage_mirror.c -- Tests the ledger mirror, a second file with copies of the newest entries
 * of the database.
 *
 * Together with the mirror, a single fault of the database must not lose an acknowledged entry. */
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
    storage = (struct storage){ .dir = dir, .without_thread = true };
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
    storage = (struct storage){ .dir = dir, .without_thread = true };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
}

/* Appends the rounds `first` to `last` to the store. The catch of each round is equal to its id. */
static void append_rounds(uint32_t first, uint32_t last)
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
    append_rounds(first, last);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), last);
}

/* Stores eight rounds and closes the store. The backup has only the first four rounds. */
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

/* ---- Tests of a damaged database ------------------------------------------------------------ */

static void test_damage_of_any_page_loses_no_entry(void **state)
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

static void test_removal_of_the_database_loses_no_entry(void **state)
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

static void test_without_database_and_mirror_the_loss_is_unknown(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    assert_int_equal(unlink(tail_path), 0);
    reopen();
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self),
                           "4 entries from the backup, 0 later ones, unknown how many lost"));
}

static void
test_a_damaged_first_page_without_backup_and_mirror_leaves_the_loss_unknown(void **state)
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

/* The migration of a database of version 3 reads all pages, so it must detect the damaged page. */
static void test_rounds_of_a_damaged_version_3_database_are_recovered(void **state)
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
        assert_int_equal(atomic_load(&storage.quarantined), 1);
        assert_int_equal(storage.salvaged.lost, 0);
        assert_int_equal(storage.salvaged.entries, ask(copy, "SELECT max(id) FROM entries"));
        device.ledger.ops->close(device.ledger.self);
    }
}

/* Stores more entries than the mirror can hold, and deletes the database. The oldest of them are
 * neither in the backup nor in the mirror, and must be counted as lost. */
static void test_entries_missing_from_backup_and_mirror_are_counted(void **state)
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

/* The database is replaced by that of another kiosk, but the mirror stays. The entries of the
 * mirror must not be added to the new database. */
static void test_a_mirror_is_not_merged_into_a_foreign_database(void **state)
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
    assert_int_equal(atomic_load(&storage.quarantined), 0);
    assert_true(is_beside(".backup.other-1"));
    assert_true(is_beside(".tail.other-2"));
    play_rounds(4, 4);
}

static void test_an_empty_database_is_restored_from_backup_and_mirror(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(truncate(file, 0), 0);
    has_all_eight();
}

static void test_without_database_and_backup_the_mirror_is_recovered(void **state)
{
    (void)state;
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    assert_int_equal(unlink(backup), 0);
    has_all_eight();
}

/* The newest entry contains the balance of credits. The mirror has this entry, so no credit is lost
 * although the backup is damaged. */
static void test_without_database_a_damaged_backup_loses_no_credit(void **state)
{
    (void)state;
    static const char damage[] = "no database";
    play_eight_and_close();
    assert_int_equal(unlink(file), 0);
    FILE *out = fopen(backup, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(damage, 1, sizeof damage, out), sizeof damage);
    assert_int_equal(fclose(out), 0);
    has_all_eight();
    /* The damaged backup is renamed with the number 2, because the file that reports the missing
     * database already has the number 1. */
    assert_true(is_beside(STORAGE_BACKUP_SUFFIX STORAGE_OTHER_SUFFIX "2"));
}

static void test_a_database_with_fewer_entries_than_its_mirror_is_damage(void **state)
{
    (void)state;
    sqlite3 *db;
    play_eight_and_close();
    assert_int_equal(sqlite3_open(file, &db), SQLITE_OK);
    /* After this deletion, the entries 7 and 8 are only in the mirror. */
    sqlite3_exec(db, "DELETE FROM entries WHERE id > 6", NULL, NULL, NULL);
    sqlite3_close(db);
    has_all_eight();
    assert_int_equal(atomic_load(&storage.quarantined), 1);
}

/* ---- Tests of a damaged mirror -------------------------------------------------------------- */

static void test_a_mirror_slot_with_a_wrong_checksum_is_ignored(void **state)
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

static void test_the_newest_entry_overwrites_the_oldest_mirror_slot(void **state)
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

/* The mirror was made for another database, for example because an operator copied it. A new mirror
 * must replace it, and its entries must not be added to the database. */
static void test_a_mirror_of_a_foreign_database_is_recreated(void **state)
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

static void test_a_restored_copy_gets_a_new_mirror(void **state)
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
    assert_int_equal(atomic_load(&storage.quarantined), 0);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 2);
    play_rounds(3, 3);
    assert_int_equal(ledger_mirror_last_id(&storage.tail), 3);
}

static void test_without_a_writable_mirror_nothing_is_acknowledged(void **state)
{
    (void)state;
    struct ledger_entry found;
    reopen();
    /* A folder is in the place of the mirror, so each write of the mirror fails. */
    assert_int_equal(mkdir(tail_path, 0755), 0);
    append_rounds(1, 3);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 0);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_non_null(
        strstr(device.ledger.ops->describe(device.ledger.self), "second copy is not written"));
    append_rounds(4, 4);
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

static void test_entries_missing_only_from_the_mirror_are_not_counted_as_lost(void **state)
{
    (void)state;
    reopen();
    /* A folder is in the place of the mirror, so each write of the mirror fails. */
    assert_int_equal(mkdir(tail_path, 0755), 0);
    append_rounds(1, 3);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(ask(file, "SELECT max(id) FROM entries"), 3);
}

static void mirror_has_all(uint32_t last_id)
{
    struct ledger_entry found;
    struct ledger_mirror tail = ledger_mirror_inspect(tail_path);
    for (uint32_t id = 1; id <= last_id; id++) {
        assert_true(ledger_mirror_entry(&tail, id, &found));
    }
    assert_int_equal(ledger_mirror_last_id(&tail), last_id);
    ledger_mirror_close(&tail);
}

static void test_a_removed_mirror_is_rewritten_completely(void **state)
{
    (void)state;
    reopen();
    play_rounds(1, 4);
    assert_int_equal(unlink(tail_path), 0);
    play_rounds(5, 5);
    mirror_has_all(5);
}

/* The open descriptor of a renamed mirror can still be written, but no start reads the file. */
static void test_a_renamed_or_replaced_mirror_is_rewritten_completely(void **state)
{
    (void)state;
    char away[160];
    snprintf(away, sizeof away, "%s/away", whole);
    reopen();
    play_rounds(1, 4);
    assert_int_equal(rename(tail_path, away), 0);
    play_rounds(5, 5);
    mirror_has_all(5);
    assert_int_equal(rename(away, tail_path), 0);
    play_rounds(6, 6);
    mirror_has_all(6);
}

static void test_a_removed_mirror_is_rewritten_while_nothing_is_written(void **state)
{
    (void)state;
    reopen();
    play_rounds(1, 4);
    assert_int_equal(unlink(tail_path), 0);
    storage_work(&storage);
    mirror_has_all(4);
    /* A failed attempt is reported and repeated. */
    assert_int_equal(unlink(tail_path), 0);
    assert_int_equal(mkdir(tail_path, 0755), 0);
    storage_work(&storage);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_int_equal(rmdir(tail_path), 0);
    storage_work(&storage);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    mirror_has_all(4);
}

static void test_a_withdrawn_name_is_removed_from_the_mirror(void **state)
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

static void test_a_backup_is_made_before_the_mirror_wraps(void **state)
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
        TEST(test_damage_of_any_page_loses_no_entry),
        TEST(test_removal_of_the_database_loses_no_entry),
        TEST(test_without_database_and_mirror_the_loss_is_unknown),
        TEST(test_a_damaged_first_page_without_backup_and_mirror_leaves_the_loss_unknown),
        TEST(test_rounds_of_a_damaged_version_3_database_are_recovered),
        TEST(test_entries_missing_from_backup_and_mirror_are_counted),
        TEST(test_a_mirror_is_not_merged_into_a_foreign_database),
        TEST(test_an_empty_database_is_restored_from_backup_and_mirror),
        TEST(test_without_database_and_backup_the_mirror_is_recovered),
        TEST(test_without_database_a_damaged_backup_loses_no_credit),
        TEST(test_a_database_with_fewer_entries_than_its_mirror_is_damage),
        TEST(test_a_mirror_slot_with_a_wrong_checksum_is_ignored),
        TEST(test_the_newest_entry_overwrites_the_oldest_mirror_slot),
        TEST(test_a_mirror_of_a_foreign_database_is_recreated),
        TEST(test_a_restored_copy_gets_a_new_mirror),
        TEST(test_without_a_writable_mirror_nothing_is_acknowledged),
        TEST(test_entries_missing_only_from_the_mirror_are_not_counted_as_lost),
        TEST(test_a_removed_mirror_is_rewritten_completely),
        TEST(test_a_renamed_or_replaced_mirror_is_rewritten_completely),
        TEST(test_a_removed_mirror_is_rewritten_while_nothing_is_written),
        TEST(test_a_withdrawn_name_is_removed_from_the_mirror),
        TEST(test_a_backup_is_made_before_the_mirror_wraps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
