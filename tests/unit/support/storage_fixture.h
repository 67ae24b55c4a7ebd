/* storage_fixture.h -- test fixture of a store. Each test has its own temporary folder. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_STORAGE_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_STORAGE_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/storage.h"

/* A store in its own temporary folder. `file` is the path of its database. */
struct fixture {
    char dir[64];
    char file[96];
    struct storage storage;
    struct hal_storage device;
};

/* Sleeps for `ms` milliseconds. */
static inline void pause_ms(long ms)
{
    nanosleep(&(struct timespec){ .tv_nsec = ms * 1000000L }, NULL);
}

/* Creates the folder; a cmocka setup function. The store is not open. */
static inline int set_up(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    strcpy(fixture->dir, "/tmp/kingyo-store-XXXXXX");
    if (!mkdtemp(fixture->dir)) {
        return -1;
    }
    snprintf(fixture->file, sizeof fixture->file, "%s/" STORAGE_FILE, fixture->dir);
    fixture->storage.dir = fixture->dir;
    fixture->device = storage_device(&fixture->storage);
    *state = fixture;
    return 0;
}

/* Closes the store and removes the folder; a cmocka teardown function. */
static inline int tear_down(void **state)
{
    struct fixture *fixture = *state;
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", fixture->dir);
    const int failed = system(command);
    free(fixture);
    return failed;
}

/* Opens the store. Returns the result of the store. */
static inline int open_store(struct fixture *fixture)
{
    return fixture->device.ledger.ops->open(fixture->device.ledger.self);
}

/* Appends a round with the given id and number of caught fish to the store. Returns the result of
 * the store. */
static inline int save(struct fixture *fixture, uint32_t id, uint32_t caught, uint8_t by_bot)
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
    return fixture->device.ledger.ops->append(fixture->device.ledger.self, &entry);
}

/* Returns the newest id that the store has committed. */
static inline uint32_t saved_id(struct fixture *fixture)
{
    return fixture->device.ledger.ops->committed_id(fixture->device.ledger.self);
}

/* Returns the text with which the store describes its state. */
static inline const char *text(struct fixture *fixture)
{
    return fixture->device.ledger.ops->describe(fixture->device.ledger.self);
}

/* Waits until the store has committed entry `id`. If this takes more than 5 s, which is enough even
 * for a slow disk, the test fails. */
static inline void wait_until_saved(struct fixture *fixture, uint32_t id)
{
    for (int i = 0; i < 500 && saved_id(fixture) < id; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(fixture), id);
}

/* Closes the store and opens it again, as a restart does. */
static inline void reopen(struct fixture *fixture)
{
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    memset(&fixture->storage, 0, sizeof fixture->storage);
    fixture->storage.dir = fixture->dir;
    assert_int_equal(open_store(fixture), HAL_OK);
}

/* Opens the store again without its thread, so that nothing is written until storage_work() is
 * called. */
static inline void open_without_thread(struct fixture *fixture)
{
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    memset(&fixture->storage, 0, sizeof fixture->storage);
    fixture->storage.dir = fixture->dir;
    fixture->storage.without_thread = true;
    assert_int_equal(open_store(fixture), HAL_OK);
}

/* Stores the rounds with the ids `first` to `last`. The number of caught fish of each round equals
 * its id. */
static inline void work_rounds(struct fixture *fixture, uint32_t first, uint32_t last)
{
    for (uint32_t id = first; id <= last; id++) {
        assert_int_equal(save(fixture, id, id, 0), HAL_OK);
    }
    storage_work(&fixture->storage);
    assert_int_equal(saved_id(fixture), last);
}

/* Stores eight rounds and closes the store. The backup contains the first four rounds. */
static inline void fill_and_close(struct fixture *fixture)
{
    open_without_thread(fixture);
    work_rounds(fixture, 1, 4);
    work_rounds(fixture, 5, 8);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
}

/* Removes the mirror, which is the second copy of the newest entries. Entries can then come only
 * from the database. */
static inline void remove_mirror(const struct fixture *fixture)
{
    char path[160];
    snprintf(path, sizeof path, "%s" STORAGE_MIRROR_SUFFIX, fixture->file);
    assert_int_equal(unlink(path), 0);
}

/* Stores eight rounds and removes the mirror. The store is closed. */
static inline void fill_and_remove_mirror(struct fixture *fixture)
{
    fill_and_close(fixture);
    remove_mirror(fixture);
}

/* Runs `query` through a second connection, as another program would. Returns the number that is
 * its result. */
static inline int query_number(const struct fixture *fixture, const char *query)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(fixture->file, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, query, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

/* Writes a file with the given bytes. */
static inline void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

/* Overwrites 64 bytes of the database at `offset`. */
static inline void damage_file(const struct fixture *fixture, long offset)
{
    FILE *file = fopen(fixture->file, "r+b");
    assert_non_null(file);
    assert_int_equal(fseek(file, offset, SEEK_SET), 0);
    for (int i = 0; i < 64; i++) {
        fputc(0xff, file);
    }
    fclose(file);
}

/* Returns the state that the store loads. The result is valid until the next call. */
static inline struct persistent_state *load_state(struct fixture *fixture)
{
    static struct persistent_state memory;
    memset(&memory, 0, sizeof memory);
    assert_int_equal(fixture->device.ledger.ops->load(fixture->device.ledger.self, &memory),
                     HAL_OK);
    return &memory;
}

/* Writes the path of the database, followed by `suffix`, to `out`. */
static inline void path_beside(const struct fixture *fixture, const char *suffix, char out[160])
{
    snprintf(out, 160, "%s%s", fixture->file, suffix);
}

/* Runs SQL on the database through a second connection, as another program would. */
static inline void do_sql(const struct fixture *fixture, const char *text)
{
    sqlite3 *db;
    sqlite3_open(fixture->file, &db);
    assert_int_equal(sqlite3_exec(db, text, 0, 0, 0), SQLITE_OK);
    sqlite3_close(db);
}

#define IN_A_FOLDER(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

#endif
