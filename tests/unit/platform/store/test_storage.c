/* test_storage.c -- finished rounds survive; a bad disk is a line of text, never a dead kiosk. */
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

#include "platform/store/storage.h"

struct stall {
    char dir[64];
    char file[96];
    struct storage storage;
    struct hal_storage device;
};

static void pause_ms(long ms)
{
    nanosleep(&(struct timespec){ .tv_nsec = ms * 1000000L }, NULL);
}

static int set_up(void **state)
{
    struct stall *stall = calloc(1, sizeof *stall);
    strcpy(stall->dir, "/tmp/kingyo-store-XXXXXX");
    if (!mkdtemp(stall->dir)) {
        return -1;
    }
    snprintf(stall->file, sizeof stall->file, "%s/" STORAGE_FILE, stall->dir);
    stall->storage.dir = stall->dir;
    stall->device = storage_device(&stall->storage);
    *state = stall;
    return 0;
}

static int tear_down(void **state)
{
    struct stall *stall = *state;
    stall->device.ledger.ops->close(stall->device.ledger.self);
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", stall->dir);
    const int failed = system(command);
    free(stall);
    return failed;
}

static int open_store(struct stall *stall)
{
    return stall->device.ledger.ops->open(stall->device.ledger.self);
}

static int save(struct stall *stall, uint32_t id, uint32_t caught, uint8_t by_bot)
{
    const struct round_record record = { .id = id,
                                         .seed = 7,
                                         .start_tick = 120,
                                         .end_tick = 7320,
                                         .caught = caught,
                                         .by_bot = by_bot,
                                         .players = 1,
                                         .player = { { .caught = caught } } };
    const struct ledger_entry entry = {
        .id = id, .boot = 1, .day = 9821, .kind = LEDGER_ROUND, .round = record
    };
    return stall->device.ledger.ops->append(stall->device.ledger.self, &entry);
}

static uint32_t saved_id(struct stall *stall)
{
    return stall->device.ledger.ops->committed_id(stall->device.ledger.self);
}

static const char *text(struct stall *stall)
{
    return stall->device.ledger.ops->describe(stall->device.ledger.self);
}

/* Up to 5 s: a syncing disk is slow, a lost record never comes. */
static void wait_until_saved(struct stall *stall, uint32_t id)
{
    for (int i = 0; i < 500 && saved_id(stall) < id; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(stall), id);
}

static void reopen(struct stall *stall)
{
    stall->device.ledger.ops->close(stall->device.ledger.self);
    memset(&stall->storage, 0, sizeof stall->storage);
    stall->storage.dir = stall->dir;
    assert_int_equal(open_store(stall), HAL_OK);
}

/* What another program reads in the file: the result of a query with one number. */
static int ask(const struct stall *stall, const char *query)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(stall->file, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, query, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

static void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static void test_a_saved_round_is_on_disk_with_every_field(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    assert_int_equal(saved_id(stall), 0);
    assert_int_equal(save(stall, 1, 5, 0), HAL_OK);
    wait_until_saved(stall, 1);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds WHERE entry = 1 AND seed = 7 AND"
                                " start_tick = 120 AND end_tick = 7320 AND caught = 5 AND"
                                " by_bot = 0 AND day = 9821"),
                     1);
}

static void test_the_next_start_goes_on_where_the_last_ended(void **state)
{
    struct stall *stall = *state;
    static struct persistent_state memory;
    assert_int_equal(open_store(stall), HAL_OK);
    assert_int_equal(stall->device.ledger.ops->load(stall->device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 0);
    assert_int_equal(memory.ledger.boots, 1);
    const struct ledger_entry coin = { .id = 1,
                                       .boot = 1,
                                       .kind = LEDGER_COINS,
                                       .count = 1,
                                       .value = 1,
                                       .balance = { .units = 2, .paid = 3 } };
    stall->device.ledger.ops->append(stall->device.ledger.self, &coin);
    save(stall, 2, 4, 0);
    wait_until_saved(stall, 2);
    reopen(stall);
    assert_int_equal(saved_id(stall), 2);
    assert_int_equal(stall->device.ledger.ops->load(stall->device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 2);
    assert_int_equal(memory.ledger.boots, 2);
    assert_int_equal(memory.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 4);
}

static void test_a_round_asked_for_every_frame_is_kept_once(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    for (int frame = 0; frame < 100; frame++) {
        assert_int_equal(save(stall, 1, 2, 0), HAL_OK);
    }
    wait_until_saved(stall, 1);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 1);
}

static void test_closing_writes_what_is_queued(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    for (uint32_t id = 1; id <= 5; id++) {
        assert_int_equal(save(stall, id, id, 0), HAL_OK);
    }
    stall->device.ledger.ops->close(stall->device.ledger.self);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 5);
}

/* Another program holds the file: save() never waits, a full queue is busy, nothing is lost. */
static void test_a_card_that_does_not_answer_never_holds_a_frame(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    sqlite3 *other;
    sqlite3_open(stall->file, &other);
    assert_int_equal(sqlite3_exec(other, "BEGIN EXCLUSIVE", 0, 0, 0), SQLITE_OK);

    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    uint32_t id = 1;
    while (id <= STORAGE_QUEUE_MAX) {
        assert_int_equal(save(stall, id, id, 0), HAL_OK);
        id++;
    }
    assert_int_equal(save(stall, id, id, 0), HAL_ERR_BUSY);
    clock_gettime(CLOCK_MONOTONIC, &after);
    const double ms = (double)(after.tv_sec - before.tv_sec) * 1e3 +
                      (double)(after.tv_nsec - before.tv_nsec) * 1e-6;
    assert_true(ms < 100.0); /* 17 calls; waiting for the file would take 2 s. */
    assert_int_equal(saved_id(stall), 0);

    sqlite3_exec(other, "ROLLBACK", 0, 0, 0);
    sqlite3_close(other);
    wait_until_saved(stall, STORAGE_QUEUE_MAX);
    assert_int_equal(save(stall, id, id, 0), HAL_OK);
    wait_until_saved(stall, id);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), (int)id);
}

static void test_rounds_that_no_try_could_write_are_counted_and_told(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    sqlite3 *other;
    sqlite3_open(stall->file, &other);
    assert_int_equal(sqlite3_exec(other, "BEGIN EXCLUSIVE", 0, 0, 0), SQLITE_OK);
    save(stall, 1, 4, 0);
    save(stall, 2, 5, 0);
    for (int i = 0;
         i < 500 && stall->device.ledger.ops->failed_count(stall->device.ledger.self) == 0; i++) {
        pause_ms(10);
    }
    assert_true(stall->device.ledger.ops->failed_count(stall->device.ledger.self) > 0);
    assert_non_null(strstr(text(stall), "2 entries not written"));
    assert_non_null(strstr(text(stall), "locked"));
    assert_int_equal(stall->device.ledger.ops->close(stall->device.ledger.self), 2);
    assert_non_null(strstr(text(stall), "lost"));
    sqlite3_exec(other, "ROLLBACK", 0, 0, 0);
    sqlite3_close(other);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 0);
}

static void test_the_folder_is_made_where_it_can_be(void **state)
{
    struct stall *stall = *state;
    char dir[160];
    snprintf(dir, sizeof dir, "%s/not/there/yet", stall->dir);
    stall->storage.dir = dir;
    assert_int_equal(open_store(stall), HAL_OK);
    stall->device.ledger.ops->close(stall->device.ledger.self);

    memset(&stall->storage, 0, sizeof stall->storage);
    write_file(stall->file, "", 0);
    snprintf(dir, sizeof dir, "%s/below-a-file", stall->file);
    stall->storage.dir = dir;
    assert_int_equal(open_store(stall), HAL_ERR_IO);
    assert_non_null(strstr(text(stall), "no store"));
    assert_non_null(strstr(text(stall), "make that folder"));
}

static void test_a_folder_that_cannot_be_written_is_one_line(void **state)
{
    struct stall *stall = *state;
    stall->storage.dir = "/proc"; /* Refuses root too. */
    assert_int_equal(open_store(stall), HAL_ERR_IO);
    assert_non_null(strstr(text(stall), "/proc"));
    assert_null(strchr(text(stall), '\n'));
    static struct persistent_state memory;
    assert_int_equal(save(stall, 1, 1, 0), HAL_ERR_ABSENT);
    assert_int_equal(stall->device.ledger.ops->load(stall->device.ledger.self, &memory),
                     HAL_ERR_ABSENT);
    assert_int_equal(saved_id(stall), 0);
}

static void test_no_folder_at_all_is_said(void **state)
{
    struct stall *stall = *state;
    stall->storage.dir = NULL;
    assert_int_equal(open_store(stall), HAL_ERR_ABSENT);
    assert_non_null(strstr(text(stall), "--data"));
}

static void test_a_file_that_is_no_database_is_set_aside(void **state)
{
    struct stall *stall = *state;
    char junk[4096], aside[128];
    memset(junk, 'x', sizeof junk);
    write_file(stall->file, junk, sizeof junk);
    assert_int_equal(open_store(stall), HAL_OK);
    assert_non_null(strstr(text(stall), "damaged"));
    snprintf(aside, sizeof aside, "%s.damaged-1", stall->file);
    struct stat info;
    assert_int_equal(stat(aside, &info), 0);
    assert_int_equal(info.st_size, sizeof junk); /* Kept, not emptied. */
    save(stall, 1, 1, 0);
    wait_until_saved(stall, 1);
}

/* ---- Damage and the backup ------------------------------------------------------------------- */

static void open_by_hand(struct stall *stall)
{
    stall->device.ledger.ops->close(stall->device.ledger.self);
    memset(&stall->storage, 0, sizeof stall->storage);
    stall->storage.dir = stall->dir;
    stall->storage.by_hand = 1;
    assert_int_equal(open_store(stall), HAL_OK);
}

/* Rounds `first` .. `last`; each has caught as many fish as its id. */
static void work_rounds(struct stall *stall, uint32_t first, uint32_t last)
{
    for (uint32_t id = first; id <= last; id++) {
        assert_int_equal(save(stall, id, id, 0), HAL_OK);
    }
    storage_work(&stall->storage);
    assert_int_equal(saved_id(stall), last);
}

/* Four rounds that the backup has, and four that came later. */
static void fill_and_close(struct stall *stall)
{
    open_by_hand(stall);
    work_rounds(stall, 1, 4);
    work_rounds(stall, 5, 8);
    stall->device.ledger.ops->close(stall->device.ledger.self);
}

/* So that the database has to do alone. */
static void lose_tail(const struct stall *stall)
{
    char path[160];
    snprintf(path, sizeof path, "%s" STORAGE_MIRROR_SUFFIX, stall->file);
    assert_int_equal(unlink(path), 0);
}

static void fill_and_lose_tail(struct stall *stall)
{
    fill_and_close(stall);
    lose_tail(stall);
}

static void spoil(const struct stall *stall, long offset)
{
    FILE *file = fopen(stall->file, "r+b");
    assert_non_null(file);
    assert_int_equal(fseek(file, offset, SEEK_SET), 0);
    for (int i = 0; i < 64; i++) {
        fputc(0xff, file);
    }
    fclose(file);
}

static struct persistent_state *remember(struct stall *stall)
{
    static struct persistent_state memory;
    memset(&memory, 0, sizeof memory);
    assert_int_equal(stall->device.ledger.ops->load(stall->device.ledger.self, &memory), HAL_OK);
    return &memory;
}

static void path_beside(const struct stall *stall, const char *suffix, char out[160])
{
    snprintf(out, 160, "%s%s", stall->file, suffix);
}

static void test_of_a_damaged_file_nothing_is_lost_that_can_be_read(void **state)
{
    struct stall *stall = *state;
    char aside[160];
    fill_and_lose_tail(stall);
    spoil(stall,
          4096L * (ask(stall, "SELECT rootpage FROM sqlite_schema WHERE name = 'audits'") - 1));
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "damaged-1"));
    assert_non_null(strstr(text(stall), "4 entries from the backup, 4 later ones"));
    assert_int_equal(remember(stall)->ledger.last_id, 8);
    assert_int_equal(remember(stall)->audits.count[AUDIT_CAUGHT], 36);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 8);
    path_beside(stall, ".damaged-1", aside);
    assert_int_equal(access(aside, F_OK), 0);
    work_rounds(stall, 9, 9);
}

/* What somebody has looked at and removed says nothing of the next one: that has a number of its
 * own, and is told of. */
static void test_a_mark_of_an_earlier_damage_hides_no_later_one(void **state)
{
    struct stall *stall = *state;
    char seen[160];
    path_beside(stall, ".damaged-1.seen", seen);
    write_file(seen, "", 0);
    write_file(stall->file, "nonsense", 8);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "damaged-2"));
}

static void do_sql(const struct stall *stall, const char *text)
{
    sqlite3 *db;
    sqlite3_open(stall->file, &db);
    assert_int_equal(sqlite3_exec(db, text, 0, 0, 0), SQLITE_OK);
    sqlite3_close(db);
}

static void test_a_bad_entry_hides_none_that_came_later(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    do_sql(stall, "UPDATE entries SET tick = tick + 64 WHERE id = 6;"
                  "UPDATE audits SET count = 0 WHERE name = 'caught'");
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "4 entries from the backup, 3 later ones, 1 lost"));
    assert_int_equal(remember(stall)->ledger.last_id, 8);
    assert_int_equal(remember(stall)->audits.count[AUDIT_CAUGHT], 36 - 6);
    work_rounds(stall, 9, 9);
}

static void test_a_bad_newest_entry_leaves_the_one_before(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    do_sql(stall, "UPDATE entries SET paid = paid + 64 WHERE id = 8");
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "4 entries from the backup, 3 later ones, 1 lost"));
    assert_int_equal(remember(stall)->ledger.last_id, 7);
    work_rounds(stall, 8, 8);
}

/* 300 coins lie on several pages: one of them, and the way to its neighbour, is gone. */
static void test_a_bad_page_hides_no_other(void **state)
{
    struct stall *stall = *state;
    open_by_hand(stall);
    for (uint32_t id = 1; id <= 300; id++) {
        const struct ledger_entry coin = { .id = id,
                                           .boot = 1,
                                           .tick = 100 * id,
                                           .kind = LEDGER_COINS,
                                           .count = 1,
                                           .value = 1,
                                           .balance = { .paid = id } };
        assert_int_equal(stall->device.ledger.ops->append(stall->device.ledger.self, &coin),
                         HAL_OK);
        storage_work(&stall->storage);
    }
    stall->device.ledger.ops->close(stall->device.ledger.self);
    lose_tail(stall);
    const long page = ask(stall, "SELECT pageno FROM dbstat WHERE name = 'entries' AND"
                                 " pagetype = 'leaf' ORDER BY path LIMIT 1 OFFSET 1");
    spoil(stall, 4096L * (page - 1));
    open_by_hand(stall);
    assert_int_equal(remember(stall)->ledger.last_id, 300);
    assert_int_equal(remember(stall)->ledger.balance.paid, 300);
    const struct storage *storage = &stall->storage;
    assert_int_equal(storage->from_backup + storage->salvaged.entries + storage->salvaged.lost,
                     300);
    assert_in_range(storage->salvaged.lost, 1, 150);
    assert_int_equal(ask(stall, "SELECT count(*) FROM entries"), 300 - storage->salvaged.lost);
}

static void test_a_file_that_cannot_be_read_at_all_gives_way_to_its_backup(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    spoil(stall, 0);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "4 entries from the backup, 0 later ones"));
    assert_int_equal(remember(stall)->ledger.last_id, 4);
    work_rounds(stall, 5, 6);
}

static void test_a_backup_of_an_earlier_version_is_brought_up_to_date(void **state)
{
    struct stall *stall = *state;
    char command[256];
    snprintf(command, sizeof command,
             "cp tests/unit/platform/store/files/version-3.db %s" STORAGE_BACKUP_SUFFIX,
             stall->file);
    assert_int_equal(system(command), 0);
    write_file(stall->file, "no database, whatever it says", 29);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "9 entries from the backup"));
    assert_int_equal(remember(stall)->ledger.balance.paid, 2);
}

static void test_without_a_backup_a_fresh_file_begins(void **state)
{
    struct stall *stall = *state;
    char backup[160];
    fill_and_lose_tail(stall);
    path_beside(stall, STORAGE_BACKUP_SUFFIX, backup);
    assert_int_equal(unlink(backup), 0);
    spoil(stall, 0);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "0 entries from the backup, 0 later ones"));
    assert_int_equal(remember(stall)->ledger.last_id, 0);
}

static void test_a_damaged_backup_is_not_believed(void **state)
{
    struct stall *stall = *state;
    char backup[160];
    fill_and_lose_tail(stall);
    path_beside(stall, STORAGE_BACKUP_SUFFIX, backup);
    write_file(backup, "no database, whatever it says", 29);
    spoil(stall,
          4096L * (ask(stall, "SELECT rootpage FROM sqlite_schema WHERE name = 'ranking'") - 1));
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "0 entries from the backup, 8 later ones"));
    assert_int_equal(remember(stall)->ledger.last_id, 8);
}

static void test_a_file_that_is_away_comes_back_from_its_backup(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    assert_int_equal(unlink(stall->file), 0);
    open_by_hand(stall);
    assert_int_equal(remember(stall)->ledger.last_id, 4);
}

/* What a card in disorder, or a slip of the hand, has put there. */
static void test_a_folder_in_the_files_place_is_set_aside(void **state)
{
    struct stall *stall = *state;
    char aside[160], inside[200];
    struct stat info;
    fill_and_lose_tail(stall);
    assert_int_equal(unlink(stall->file), 0);
    assert_int_equal(mkdir(stall->file, 0755), 0);
    snprintf(inside, sizeof inside, "%s/somebody's", stall->file);
    write_file(inside, "words", 5);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "damaged-1: 4 entries from the backup"));
    assert_int_equal(remember(stall)->ledger.last_id, 4);
    path_beside(stall, ".damaged-1/somebody's", aside);
    assert_int_equal(stat(aside, &info), 0);
    assert_int_equal(info.st_size, 5);
    work_rounds(stall, 5, 6);
}

/* A link to itself stands for a card that answers, but not with the file. */
static void test_a_name_that_cannot_be_looked_at_is_not_taken_for_none(void **state)
{
    struct stall *stall = *state;
    char hidden[160];
    path_beside(stall, "-hidden", hidden);
    fill_and_close(stall);
    assert_int_equal(rename(stall->file, hidden), 0);
    assert_int_equal(symlink(strrchr(stall->file, '/') + 1, stall->file), 0);
    stall->device.ledger.ops->close(stall->device.ledger.self);
    memset(&stall->storage, 0, sizeof stall->storage);
    stall->storage.dir = stall->dir;
    stall->storage.by_hand = 1;
    assert_int_not_equal(open_store(stall), HAL_OK);
    assert_int_equal(stall->device.ledger.ops->is_healthy(stall->device.ledger.self), 0);
    assert_int_equal(rename(hidden, stall->file), 0); /* Over the link, which is still there. */
    stall->device.ledger.ops->close(stall->device.ledger.self);
    open_by_hand(stall);
    assert_int_equal(remember(stall)->ledger.last_id, 8);
}

static int last_id_of(const char *path)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, "SELECT max(id) FROM entries", -1, &statement, NULL),
                     SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

/* The file has lost what it had, and the backup has it. */
static void goes_on_from_the_backup(struct stall *stall)
{
    char backup[160], aside[160];
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "4 entries from the backup, 0 later ones"));
    assert_int_equal(remember(stall)->ledger.last_id, 4);
    path_beside(stall, ".damaged-1", aside);
    assert_int_equal(access(aside, F_OK), 0);
    storage_work(&stall->storage);
    path_beside(stall, STORAGE_BACKUP_SUFFIX, backup);
    assert_int_equal(last_id_of(backup), 4);
}

static void test_a_file_of_no_bytes_is_damage_where_there_is_a_backup(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    assert_int_equal(truncate(stall->file, 0), 0);
    goes_on_from_the_backup(stall);
}

static void test_a_file_with_less_than_its_backup_is_damage(void **state)
{
    struct stall *stall = *state;
    fill_and_lose_tail(stall);
    do_sql(stall, "DELETE FROM entries WHERE id > 3");
    goes_on_from_the_backup(stall);
}

/* As `kingyoctl backup` makes it, and as its words say how to go back to it. */
static void test_a_copy_that_is_put_back_is_gone_on_from(void **state)
{
    struct stall *stall = *state;
    char copy[160], backup[160], before[160];
    path_beside(stall, "-copy", copy);
    path_beside(stall, STORAGE_BACKUP_SUFFIX, backup);
    path_beside(stall, STORAGE_BEFORE_SUFFIX, before);
    open_by_hand(stall);
    work_rounds(stall, 1, 2);
    assert_int_equal(ledger_backup_make(&stall->storage.file, copy, true), SQLITE_OK);
    work_rounds(stall, 3, 4);
    stall->storage.backup_due_s = 0;
    storage_work(&stall->storage);
    stall->device.ledger.ops->close(stall->device.ledger.self);
    assert_int_equal(last_id_of(backup), 4);
    assert_int_equal(rename(copy, stall->file), 0);
    open_by_hand(stall);
    assert_null(strstr(text(stall), "damaged"));
    assert_int_equal(remember(stall)->ledger.last_id, 2);
    storage_work(&stall->storage);
    assert_int_equal(last_id_of(backup), 2);
    assert_int_equal(last_id_of(before), 4);
    work_rounds(stall, 3, 5);
    stall->storage.backup_due_s = 0;
    storage_work(&stall->storage);
    stall->device.ledger.ops->close(stall->device.ledger.self);
    do_sql(stall, "DELETE FROM entries WHERE id > 3"); /* It is no copy any more. */
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "damaged-1"));
    assert_int_equal(remember(stall)->ledger.last_id, 5);
}

static void test_a_log_without_its_file_is_set_aside(void **state)
{
    struct stall *stall = *state;
    char log[160];
    write_file(stall->file, "", 0);
    path_beside(stall, "-wal", log);
    write_file(log, "of a file that is no more", 25);
    open_by_hand(stall);
    assert_non_null(strstr(text(stall), "damaged-1"));
    path_beside(stall, ".damaged-1-wal", log);
    assert_int_equal(access(log, F_OK), 0);
}

static void test_a_backup_is_not_written_over_by_a_file_that_has_less(void **state)
{
    struct stall *stall = *state;
    char backup[160];
    fill_and_close(stall);
    path_beside(stall, STORAGE_BACKUP_SUFFIX, backup);
    open_by_hand(stall);
    stall->storage.file.content.memory.ledger.last_id = 3; /* As if it had been swapped. */
    storage_work(&stall->storage);
    assert_int_equal(last_id_of(backup), 4);
    assert_int_equal(stall->device.ledger.ops->failed_count(stall->device.ledger.self), 1);
}

/* Each is SQL as good as before. */
static void test_tables_that_are_not_as_they_were_made_are_damage(void **state)
{
    struct stall *stall = *state;
    static const char *const flips[] = {
        "UPDATE sqlite_schema SET sql = replace(sql, 'bonus_units', 'bonus_ujits')",
        "UPDATE sqlite_schema SET sql = replace(sql, 'count INTEGER', 'cou~t INTEGER')",
        "UPDATE sqlite_schema SET sql = replace(sql, 'seat INTEGER', 'sdat INTEGER')",
    };
    for (size_t i = 0; i < sizeof flips / sizeof flips[0]; i++) {
        char command[160];
        sqlite3 *db;
        snprintf(command, sizeof command, "rm -f %s*", stall->file);
        stall->device.ledger.ops->close(stall->device.ledger.self);
        assert_int_equal(system(command), 0);
        fill_and_close(stall);
        sqlite3_open(stall->file, &db);
        sqlite3_exec(db, "PRAGMA writable_schema = ON", 0, 0, 0);
        assert_int_equal(sqlite3_exec(db, flips[i], 0, 0, 0), 0);
        sqlite3_close(db);
        open_by_hand(stall);
        assert_non_null(strstr(text(stall), "damaged-1"));
        assert_true(remember(stall)->ledger.last_id >= 4);
        work_rounds(stall, 9, 9);
    }
}

static void test_a_replacement_that_was_cut_off_is_ended(void **state)
{
    struct stall *stall = *state;
    char fresh[160], log[160], aside[160];
    fill_and_close(stall);
    path_beside(stall, STORAGE_NEW_SUFFIX, fresh);
    path_beside(stall, "-wal", log);
    assert_int_equal(rename(stall->file, fresh), 0); /* The old is aside, the new not yet there, */
    write_file(log, "of the damaged one", 18);       /* and the old one's log is still here. */
    open_by_hand(stall);
    assert_int_equal(remember(stall)->ledger.last_id, 8);
    path_beside(stall, ".damaged-1-wal", aside);
    assert_int_equal(access(aside, F_OK), 0);
    assert_int_equal(access(fresh, F_OK), -1);
}

static void test_a_replacement_that_was_not_ready_is_forgotten(void **state)
{
    struct stall *stall = *state;
    char fresh[160];
    fill_and_close(stall);
    path_beside(stall, STORAGE_NEW_SUFFIX, fresh);
    write_file(fresh, "half", 4);
    open_by_hand(stall);
    assert_int_equal(remember(stall)->ledger.last_id, 8);
    assert_int_equal(access(fresh, F_OK), -1);
}

static void test_damage_while_the_kiosk_runs_is_answered_in_the_same_way(void **state)
{
    struct stall *stall = *state;
    open_by_hand(stall);
    work_rounds(stall, 1, 4);
    work_rounds(stall, 5, 8);
    sqlite3_wal_checkpoint_v2(stall->storage.file.db, NULL, SQLITE_CHECKPOINT_TRUNCATE, NULL, NULL);
    sqlite3_db_release_memory(stall->storage.file.db);
    spoil(stall,
          4096L * (ask(stall, "SELECT rootpage FROM sqlite_schema WHERE name = 'audits'") - 1));
    save(stall, 9, 9, 0);
    for (int i = 0; i < 3; i++) {
        storage_work(&stall->storage);
    }
    assert_int_equal(saved_id(stall), 9);
    assert_non_null(strstr(text(stall), "damaged-1"));
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 9);
}

static void test_a_store_without_memory_says_so_and_goes_on_when_it_has_some(void **state)
{
    struct stall *stall = *state;
    open_by_hand(stall);
    work_rounds(stall, 1, 1);
    sqlite3_db_release_memory(stall->storage.file.db);
    sqlite3_hard_heap_limit64(sqlite3_memory_used() + 512);
    assert_int_equal(save(stall, 2, 2, 0), HAL_OK);
    storage_work(&stall->storage);
    assert_int_equal(saved_id(stall), 1);
    assert_int_equal(stall->device.ledger.ops->is_healthy(stall->device.ledger.self), 0);
    assert_non_null(strstr(text(stall), "out of memory"));
    sqlite3_hard_heap_limit64(STORAGE_HEAP_MAX);
    storage_work(&stall->storage);
    assert_int_equal(saved_id(stall), 2);
    assert_int_equal(stall->device.ledger.ops->is_healthy(stall->device.ledger.self), 1);
    assert_int_equal(ask(stall, "SELECT count(*) FROM rounds"), 2);
}

static void test_a_second_damaged_file_does_not_replace_the_first(void **state)
{
    struct stall *stall = *state;
    char first[128], second[128];
    snprintf(first, sizeof first, "%s.damaged-1", stall->file);
    snprintf(second, sizeof second, "%s.damaged-2", stall->file);
    write_file(first, "kept", 4);
    write_file(stall->file, "this was never a database", 25);
    assert_int_equal(open_store(stall), HAL_OK);
    struct stat info;
    assert_int_equal(stat(first, &info), 0);
    assert_int_equal(info.st_size, 4);
    assert_int_equal(access(second, F_OK), 0);
}

static void test_a_file_of_a_later_kingyo_is_one_line_and_left_alone(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    stall->device.ledger.ops->close(stall->device.ledger.self);
    sqlite3 *db;
    sqlite3_open(stall->file, &db);
    assert_int_equal(sqlite3_exec(db, "PRAGMA user_version = 99", 0, 0, 0), 0);
    sqlite3_close(db);
    assert_int_equal(open_store(stall), HAL_ERR_IO);
    assert_non_null(strstr(text(stall), "a later Kingyo wrote it"));
    assert_int_equal(ask(stall, "PRAGMA user_version"), 99);
}

static void test_sqlite_has_a_hard_limit_on_memory(void **state)
{
    struct stall *stall = *state;
    assert_int_equal(open_store(stall), HAL_OK);
    assert_int_equal(sqlite3_hard_heap_limit64(-1), STORAGE_HEAP_MAX);
    save(stall, 1, 1, 0);
    wait_until_saved(stall, 1);
    assert_true(sqlite3_memory_highwater(0) < STORAGE_HEAP_MAX / 8);
}

#define IN_A_FOLDER(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

static int has_replay(const struct stall *stall, uint32_t round_id)
{
    return stall->device.replays.ops->has(stall->device.replays.self, round_id);
}

static void test_a_ranked_round_is_sealed_while_its_replay_is_kept(void **state)
{
    struct stall *stall = *state;
    static const uint8_t bytes[64] = { 1, 2, 3 };
    open_by_hand(stall);
    assert_int_equal(save(stall, 1, 5, 0), HAL_OK);
    storage_work(&stall->storage);
    assert_false(has_replay(stall, 1));
    assert_int_equal(
        stall->device.replays.ops->store(stall->device.replays.self, 1, bytes, sizeof bytes),
        HAL_OK);
    assert_false(has_replay(stall, 1));
    storage_work(&stall->storage);
    assert_true(has_replay(stall, 1));
    assert_false(has_replay(stall, 2));
    assert_false(has_replay(stall, 0));
    reopen(stall);
    assert_true(has_replay(stall, 1));
    for (uint32_t id = 2; id <= 1u + RANK_ROWS; id++) { /* Ten better ones: it falls out. */
        assert_int_equal(save(stall, id, 9, 0), HAL_OK);
    }
    wait_until_saved(stall, 1u + RANK_ROWS);
    stall->device.ledger.ops->close(stall->device.ledger.self);
    open_by_hand(stall);
    storage_work(&stall->storage);
    assert_false(has_replay(stall, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_A_FOLDER(test_a_saved_round_is_on_disk_with_every_field),
        IN_A_FOLDER(test_the_next_start_goes_on_where_the_last_ended),
        IN_A_FOLDER(test_a_round_asked_for_every_frame_is_kept_once),
        IN_A_FOLDER(test_closing_writes_what_is_queued),
        IN_A_FOLDER(test_a_card_that_does_not_answer_never_holds_a_frame),
        IN_A_FOLDER(test_rounds_that_no_try_could_write_are_counted_and_told),
        IN_A_FOLDER(test_the_folder_is_made_where_it_can_be),
        IN_A_FOLDER(test_a_folder_that_cannot_be_written_is_one_line),
        IN_A_FOLDER(test_no_folder_at_all_is_said),
        IN_A_FOLDER(test_a_file_that_is_no_database_is_set_aside),
        IN_A_FOLDER(test_of_a_damaged_file_nothing_is_lost_that_can_be_read),
        IN_A_FOLDER(test_a_mark_of_an_earlier_damage_hides_no_later_one),
        IN_A_FOLDER(test_a_bad_entry_hides_none_that_came_later),
        IN_A_FOLDER(test_a_bad_newest_entry_leaves_the_one_before),
        IN_A_FOLDER(test_a_bad_page_hides_no_other),
        IN_A_FOLDER(test_a_file_that_cannot_be_read_at_all_gives_way_to_its_backup),
        IN_A_FOLDER(test_a_backup_of_an_earlier_version_is_brought_up_to_date),
        IN_A_FOLDER(test_without_a_backup_a_fresh_file_begins),
        IN_A_FOLDER(test_a_damaged_backup_is_not_believed),
        IN_A_FOLDER(test_a_file_that_is_away_comes_back_from_its_backup),
        IN_A_FOLDER(test_a_folder_in_the_files_place_is_set_aside),
        IN_A_FOLDER(test_a_name_that_cannot_be_looked_at_is_not_taken_for_none),
        IN_A_FOLDER(test_a_file_of_no_bytes_is_damage_where_there_is_a_backup),
        IN_A_FOLDER(test_a_file_with_less_than_its_backup_is_damage),
        IN_A_FOLDER(test_a_copy_that_is_put_back_is_gone_on_from),
        IN_A_FOLDER(test_a_log_without_its_file_is_set_aside),
        IN_A_FOLDER(test_a_backup_is_not_written_over_by_a_file_that_has_less),
        IN_A_FOLDER(test_tables_that_are_not_as_they_were_made_are_damage),
        IN_A_FOLDER(test_a_replacement_that_was_cut_off_is_ended),
        IN_A_FOLDER(test_a_replacement_that_was_not_ready_is_forgotten),
        IN_A_FOLDER(test_damage_while_the_kiosk_runs_is_answered_in_the_same_way),
        IN_A_FOLDER(test_a_store_without_memory_says_so_and_goes_on_when_it_has_some),
        IN_A_FOLDER(test_a_second_damaged_file_does_not_replace_the_first),
        IN_A_FOLDER(test_a_file_of_a_later_kingyo_is_one_line_and_left_alone),
        IN_A_FOLDER(test_sqlite_has_a_hard_limit_on_memory),
        cmocka_unit_test_setup_teardown(test_a_ranked_round_is_sealed_while_its_replay_is_kept,
                                        set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
