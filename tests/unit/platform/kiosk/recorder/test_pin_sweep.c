/* test_pin_sweep.c -- Tests the PIN sweep. Older versions of Kingyo stored the PIN of the
 * operator's menu in replays, and the sweep removes it.
 *
 * A replay without its PIN must still verify as genuine, and no old bytes may remain in the
 * database. If a replay may contain a PIN that cannot be removed, the replay is deleted. All other
 * replays stay. Scores and money never change. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/pin.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/pin_sweep.h"
#include "platform/os/log.h"
#include "platform/replay/replay_format.h"
#include "platform/store/sqlite/ledger_file.h"

#define PIN 4071

static char folder[] = "/tmp/kingyo-sweep-XXXXXX";
static char path[64], log_path[72];
static struct core core, bots;
static struct output output, unheard;
static struct input input;
static struct replay_writer writer;
static struct replay_totals totals;
static struct recorder_tally tally;
static struct pin_sweep sweep;
static struct replay_verifier verifier;
static struct ledger_file file;
static uint8_t replay[SESSION_RECORDER_SIZE], found[SESSION_RECORDER_SIZE];
static size_t replay_size, found_size;
static uint8_t memory[SESSION_RECORDER_SIZE];
static bool hand_is_away; /* True while no controller is connected to the tested core. */
static bool types_pin;    /* True if keep_as_before() also types the PIN in the menu. */
/* True if core_init() must fail for the core with which the sweep (the removal of PINs from stored
 * replays) simulates a replay. */
static bool refuses_core;
static char logged[400];                          /* Messages of the last sweep_all(). */
static uint8_t large[SESSION_RECORDER_SIZE + 1u]; /* Buffer for a replay that is one byte too large
                                                     for the sweep. */

enum core_error __real_core_init(struct core *to, const struct core_config *config);
enum core_error __wrap_core_init(struct core *to, const struct core_config *config);

/* Replaces core_init() in this test program through the linker option --wrap, so that the call can
 * fail. */
enum core_error __wrap_core_init(struct core *to, const struct core_config *config)
{
    return refuses_core && to == &sweep.core ? CORE_ERR_FLOAT : __real_core_init(to, config);
}

static uint32_t tick(uint32_t pressed)
{
    struct input by_bot = { .pressed = pressed, .poi[0].link = POI_SOURCE_BOT };
    uint32_t round_id = 0;
    unheard.sound_count = output.sound_count = 0;
    core_tick(&bots, &by_bot, &unheard);
    input.pressed = pressed;
    input.store_well = 1;
    input.record_saved_id = output.entry_id;
    input.poi[0] = (struct poi_input){ .link = POI_SOURCE_LIVE,
                                       .has_wrist = 1,
                                       .target = bots.game.control[0].target_pose };
    input.poi[0].link = hand_is_away ? POI_SOURCE_ABSENT : POI_SOURCE_LIVE;
    const uint32_t before = output.entry_id;
    core_tick(&core, &input, &output);
    for (uint32_t id = before + 1u; id <= output.entry_id; id++) {
        const struct ledger_entry *entry = &output.entries[id % LEDGER_RING];
        assert_int_equal(ledger_file_write(&file, entry, 1), SQLITE_OK);
        round_id = entry->kind == LEDGER_ROUND ? id : round_id;
    }
    recorder_add_tick(&writer, &totals, &tally, &input, &core);
    return round_id;
}

static void press(uint32_t buttons, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        tick(buttons);
        for (uint32_t wait = 0; wait < MENU_TAKE_TICKS; wait++) {
            tick(0);
        }
    }
}

/* Opens the menu in attract mode, types the PIN 4071, closes the menu and presses START. LEFT and
 * RIGHT move the selection by one digit, and OK enters the selected digit. */
static void type_the_pin(void)
{
    hand_is_away = true; /* Without a controller, no poi can select other digits. */
    for (uint32_t i = 0; i < 2u && !core_status(&core).takes_pin; i++) {
        press(INPUT_TEST, 1); /* During a game, the first press of TEST only shows a
                                 confirmation. */
    }
    assert_true(core_status(&core).takes_pin);
    press(INPUT_RIGHT, 3); /* Moves the selection from digit 1 to digit 4. */
    press(INPUT_OK, 1);
    press(INPUT_RIGHT, 6); /* Moves the selection from digit 4 to digit 0. */
    press(INPUT_OK, 1);
    press(INPUT_LEFT, 3); /* Moves the selection from digit 0 to digit 7. */
    press(INPUT_OK, 1);
    press(INPUT_LEFT, 6); /* Moves the selection from digit 7 to digit 1. */
    press(INPUT_OK, 1);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(core.game.menu.page, MENU_TOP);
    tick(INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    hand_is_away = false;
    tick(INPUT_START);
    assert_int_not_equal(core.game.phase, PHASE_ATTRACT);
}

/* Plays a round with a PIN in the settings, under the rules of replay format 7. Stores a replay
 * that contains the PIN, as Kingyo versions with format 7 did. Returns the id of the round. */
static uint32_t keep_as_before(void)
{
    struct core_config config = { .seed = 11, .round_s = 20, .lanes = cpu_lanes(), .rules = 7 };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_PIN] = PIN;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core_init(&bots, &config), CORE_OK);
    totals = (struct replay_totals){ .hash = core_hash(&core) };
    tally = (struct recorder_tally){ 0 };
    assert_int_equal(replay_create_in(&writer, memory, sizeof memory, &config, totals.hash), 0);
    uint32_t round_id = 0;
    for (uint32_t i = 0; i < 90u * CORE_TICK_HZ && round_id == 0; i++) {
        if (i == CORE_TICK_HZ && types_pin) {
            type_the_pin();
        }
        round_id = tick(i == 2u * CORE_TICK_HZ ? INPUT_START : 0);
    }
    assert_true(round_id != 0);
    replay_size = replay_copy(&writer, core_hash(&core), replay, sizeof replay);
    assert_true(replay_size > 0);
    assert_int_equal(ledger_file_put_replay(&file, round_id, replay, replay_size), SQLITE_OK);
    return round_id;
}

/* Sweeps all replays. Copies the messages of the sweep to `logged`. */
static void sweep_all(void)
{
    const struct storage_chore chore = pin_sweep_chore(&sweep);
    FILE *log = tmpfile();
    const int before = dup(STDERR_FILENO);
    assert_true(log != NULL && before >= 0);
    dup2(fileno(log), STDERR_FILENO);
    log_open();
    memset(&sweep, 0, sizeof sweep);
    int code = SQLITE_OK;
    for (uint32_t i = 0; i < 10000000u && code == SQLITE_OK; i++) {
        code = chore.step(chore.self, &file);
    }
    dup2(before, STDERR_FILENO);
    close(before);
    log_open();
    memset(logged, 0, sizeof logged);
    assert_true(pread(fileno(log), logged, sizeof logged - 1u, 0) >= 0);
    fclose(log);
    assert_int_equal(code, SQLITE_DONE);
    assert_int_equal(sweep.stage, PIN_SWEEP_DONE);
}

static enum replay_verdict verification_of(uint32_t round_id)
{
    struct ledger_entry kept;
    ledger_file_round(&file, round_id, &kept);
    assert_int_equal(ledger_file_get_replay(&file, round_id, found, sizeof found, &found_size),
                     SQLITE_OK);
    if (replay_verifier_begin(&verifier, found, found_size) == 0) {
        while (replay_verifier_tick(&verifier)) {
        }
    }
    return replay_verifier_result(&verifier, &file.content.memory.ranking, round_id, &kept);
}

/* Returns 1 if the file `name` contains the `size` bytes at `bytes`, and 0 otherwise. */
static int file_holds(const char *name, const void *bytes, size_t size)
{
    static uint8_t all[16u * 1024u * 1024u];
    FILE *in = fopen(name, "rb");
    const size_t length = in ? fread(all, 1, sizeof all, in) : 0;
    int holds = 0;
    for (size_t i = 0; i + size <= length && !holds; i++) {
        holds = memcmp(all + i, bytes, size) == 0;
    }
    if (in) {
        fclose(in);
    }
    return holds;
}

static int set_up(void **state)
{
    (void)state;
    strcpy(folder + sizeof folder - 7, "XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/kingyo.db", folder);
    snprintf(log_path, sizeof log_path, "%s-wal", path);
    types_pin = hand_is_away = refuses_core = false;
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    static const char *const suffixes[] = { "", "-wal", "-shm", ".copy", ".tail", ".backup" };
    char name[80];
    ledger_file_close(&file);
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++) {
        snprintf(name, sizeof name, "%s%s", path, suffixes[i]);
        unlink(name);
    }
    return rmdir(folder);
}

static void test_removing_the_pin_keeps_an_old_replay_genuine(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    const uint32_t ticks = verifier.replayer.totals.ticks;
    const struct round_record round = verifier.round.round;
    sweep_all();
    assert_int_equal(sweep.cleaned, 1);
    assert_int_equal(sweep.left, 0);
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(verifier.replayer.totals.ticks, ticks);
    assert_memory_equal(&verifier.round.round, &round, sizeof round);
    const struct core_config *config = &verifier.replayer.reader.header.config;
    assert_int_equal(config->rules, 7);
    assert_int_equal(config->persistent.settings.value[SET_PIN], PIN_WITHHELD);
    assert_false(session_recorder_may_contain_pin(&verifier.replayer.reader));
    sweep_all(); /* A second sweep must find no replay with a PIN. */
    assert_int_equal(sweep.cleaned + sweep.left, 0);
}

static void test_removed_pin_bytes_are_erased_from_the_file_at_the_next_open(void **state)
{
    (void)state;
    keep_as_before();
    /* These first bytes contain checksums that differ in the cleared replay. After the sweep, they
     * must not be found in the database any more. */
    uint8_t old[REPLAY_HEADER_SIZE + 48u];
    memcpy(old, replay, sizeof old);
    ledger_file_close(&file);
    assert_true(file_holds(path, old, sizeof old));
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    sweep_all();
    assert_int_equal(sweep.cleaned, 1);
    ledger_file_close(&file);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    assert_false(file_holds(path, old, sizeof old));
    assert_false(file_holds(log_path, old, sizeof old));
}

/* ---- Replays that cannot be cleared of a PIN ------------------------------------------------ */

static void put(uint32_t round_id, const void *bytes, size_t size)
{
    assert_int_equal(ledger_file_put_replay(&file, round_id, bytes, size), SQLITE_OK);
}

/* Sweeps the replays. Asserts that the replay of `round_id` was deleted, and that the ranking, the
 * settings, the audits and the balance are unchanged. */
static void assert_sweep_deletes(uint32_t round_id)
{
    static struct persistent_state before, after;
    struct ledger_entry round, same;
    size_t size;
    ledger_content_load(&file.content, &before);
    ledger_file_round(&file, round_id, &round);
    sweep_all();
    assert_int_equal(sweep.deleted, 1);
    assert_int_equal(sweep.cleaned + sweep.left, 0);
    assert_non_null(strstr(logged, " 1 were deleted"));
    assert_null(strstr(logged, "version")); /* The message must not name the version as the reason,
                                               because a damaged replay may have the current
                                               version. */
    assert_int_equal(ledger_file_get_replay(&file, round_id, found, sizeof found, &size),
                     SQLITE_NOTFOUND);
    ledger_file_close(&file);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    ledger_content_load(&file.content, &after);
    ledger_file_round(&file, round_id, &same);
    assert_true(round.id == round_id);
    assert_memory_equal(&round, &same, sizeof round);
    assert_memory_equal(&before.ranking, &after.ranking, sizeof before.ranking);
    assert_memory_equal(&before.settings, &after.settings, sizeof before.settings);
    assert_memory_equal(&before.audits, &after.audits, sizeof before.audits);
    assert_memory_equal(&before.ledger.balance, &after.ledger.balance,
                        sizeof before.ledger.balance);
    sweep_all(); /* A second sweep must find no replay with a PIN. */
    assert_int_equal(sweep.cleaned + sweep.deleted + sweep.left, 0);
}

static void test_a_replay_that_differs_is_deleted(void **state)
{
    (void)state;
    static struct core_config config;
    static struct replay_reader reader;
    struct input recorded;
    const uint32_t round_id = keep_as_before();
    assert_int_equal(replay_open_in(&reader, replay, replay_size), 0);
    config = reader.header.config;
    config.seed++;
    assert_int_equal(replay_create_in(&writer, found, sizeof found, &config, 1), 0);
    while (replay_next(&reader, &recorded) == 1) {
        totals = reader.totals;
        totals.ticks = reader.tick;
        replay_add(&writer, &recorded, reader.digest, &totals);
    }
    assert_int_equal(replay_finish(&writer, reader.totals.hash), 0);
    put(round_id, found, (size_t)writer.offset + REPLAY_END_SIZE);
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_OTHER);
    assert_sweep_deletes(round_id);
}

static void test_a_replay_that_cannot_be_read_is_deleted(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    const size_t places[] = { 0, 12, 40, replay_size / 2u };
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        memcpy(found, replay, replay_size);
        found[places[i]] ^= 0x10u;
        put(round_id, found, replay_size);
        assert_sweep_deletes(round_id);
    }
    put(round_id, replay, replay_size - 1u);
    assert_sweep_deletes(round_id);
    memset(large, 0, sizeof large);
    memcpy(large, replay, replay_size);
    put(round_id, large, sizeof large);
    assert_sweep_deletes(round_id);
}

static void read_format_7(void)
{
    FILE *in = fopen("tests/replay/format-7.replay", "rb");
    assert_non_null(in);
    replay_size = fread(replay, 1, sizeof replay, in);
    fclose(in);
}

static void test_a_replay_of_format_7_with_a_damaged_initial_state_is_deleted(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    read_format_7();
    replay[REPLAY_HEADER_SIZE + 5u] ^= 0x10u;
    put(round_id, replay, replay_size);
    assert_sweep_deletes(round_id);
}

static void test_a_replay_of_a_format_that_is_too_old_is_deleted(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    replay[8] = (uint8_t)(REPLAY_VERSION_MIN - 1u);
    put(round_id, replay, replay_size);
    assert_sweep_deletes(round_id);
}

static void test_a_replay_in_which_a_pin_is_typed_is_deleted(void **state)
{
    (void)state;
    types_pin = true;
    const uint32_t round_id = keep_as_before();
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    assert_sweep_deletes(round_id);
}

static void test_the_kiosk_shows_no_seal_for_a_deleted_replay(void **state)
{
    (void)state;
    static struct storage storage;
    const uint32_t round_id = keep_as_before();
    put(round_id, replay, replay_size - 1u);
    ledger_file_close(&file);
    memset(&sweep, 0, sizeof sweep);
    storage =
        (struct storage){ .dir = folder, .without_thread = true, .chore = pin_sweep_chore(&sweep) };
    const struct hal_storage device = storage_device(&storage);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), 0);
    assert_int_equal(device.replays.ops->has(device.replays.self, round_id), 1);
    for (uint32_t i = 0; i < 1000u && storage.chore.step; i++) {
        storage_work(&storage);
    }
    assert_int_equal(sweep.deleted, 1);
    assert_int_equal(device.replays.ops->has(device.replays.self, round_id), 0);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
}

/* ---- Replays that can be cleared of a PIN --------------------------------------------------- */

static void test_a_replay_of_another_score_is_cleared_and_still_reported(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    put(round_id + 1u, replay, replay_size); /* No round in the ranking has this id. */
    sweep_all();
    assert_int_equal(sweep.cleaned, 2);
    assert_int_equal(sweep.deleted + sweep.left, 0);
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(verification_of(round_id + 1u), REPLAY_VERDICT_OTHER);
    assert_int_equal(verifier.replayer.reader.header.config.persistent.settings.value[SET_PIN],
                     PIN_WITHHELD);
    assert_false(verifier.replayer.difference.found);
}

/* In a replay of format 7, a PIN may have been typed during the recording even if the initial
 * settings have no PIN. Only a simulation of the replay shows whether a PIN was typed. The sweep
 * therefore simulates every such replay and stores it in the current format. */
static void test_a_replay_of_format_7_is_simulated_and_stored_in_the_current_format(void **state)
{
    (void)state;
    read_format_7();
    put(1, replay, replay_size);
    sweep_all();
    assert_int_equal(sweep.cleaned, 1);
    assert_int_equal(sweep.deleted + sweep.left, 0);
    verification_of(1);
    assert_false(verifier.replayer.difference.found);
    assert_int_equal(verifier.replayer.totals.ticks, 17455);
    assert_int_equal(verifier.replayer.reader.header.version, REPLAY_VERSION);
    assert_int_equal(verifier.replayer.reader.header.config.rules, 7);
}

/* ---- Replays that the sweep does not change ------------------------------------------------- */

/* Stores `bytes` as the replay of a round. Asserts that the sweep neither changes nor reports the
 * replay. */
static void assert_sweep_keeps(uint32_t round_id, const uint8_t *bytes, size_t size)
{
    static uint8_t kept[sizeof large];
    size_t kept_size;
    put(round_id, bytes, size);
    sweep_all();
    assert_int_equal(sweep.cleaned + sweep.deleted + sweep.left, 0);
    assert_string_equal(logged, "");
    assert_int_equal(ledger_file_get_replay(&file, round_id, kept, sizeof kept, &kept_size),
                     SQLITE_OK);
    assert_int_equal(kept_size, size);
    assert_memory_equal(kept, bytes, size);
}

/* The first replay has a newer format. The second one is also larger than this program can store. A
 * newer version may have stored both before the operator went back to this version. */
static void test_a_replay_of_a_newer_format_is_not_changed(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    replay[8] = (uint8_t)(REPLAY_VERSION + 1u);
    assert_sweep_keeps(round_id, replay, replay_size);
    memset(large, 0, sizeof large);
    memcpy(large, replay, replay_size);
    assert_sweep_keeps(round_id, large, sizeof large);
}

/* The first replay is damaged, but its header is valid and has a format of 8 or newer. Programs
 * that write such formats store no PIN, so the replay must stay. */
static void test_a_damaged_replay_whose_recorder_stored_no_pin_stays(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    memcpy(found, replay, replay_size);
    found[REPLAY_HEADER_SIZE + 5u] ^= 0x10u;
    assert_sweep_keeps(round_id, found, replay_size);
    for (uint32_t version = 8; version <= REPLAY_VERSION; version++) {
        memcpy(found, replay, replay_size);
        found[HEADER_VERSION] = (uint8_t)version;
        found[HEADER_DIGEST_TICKS] = 0; /* No recorder writes the value 0 in this field, so the
                                           replay is invalid. */
        replay_put_u64(found + HEADER_SUM, hash_bytes(HASH_START, found, HEADER_SUM));
        assert_sweep_keeps(round_id, found, replay_size);
    }
}

static void test_a_replay_stays_until_the_next_start_if_the_core_refuses_to_run(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    refuses_core = true;
    sweep_all();
    assert_int_equal(sweep.left, 1);
    assert_int_equal(sweep.cleaned + sweep.deleted, 0);
    assert_non_null(strstr(logged, " 1 could not be examined"));
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    refuses_core = false;
    sweep_all();
    assert_int_equal(sweep.cleaned, 1);
}

/* Only the catalog of species is damaged. A PIN would be in the initial state, which is intact and
 * has none, so the replay must stay. */
static void test_a_replay_without_a_pin_stays_if_only_its_catalog_cannot_be_read(void **state)
{
    (void)state;
    struct core_config config = { .seed = 11, .lanes = cpu_lanes(), .book.refused = 1 };
    settings_reset(&config.persistent.settings);
    assert_int_equal(replay_create_in(&writer, memory, sizeof memory, &config, 1), 0);
    replay_size = replay_copy(&writer, 1, replay, sizeof replay);
    assert_int_equal(replay_open_in(&verifier.replayer.reader, replay, replay_size), 0);
    /* Changes the last byte of the catalog. */
    replay[verifier.replayer.reader.offset - REPLAY_SUM_SIZE - 1u] ^= 1u;
    assert_int_equal(replay_open_in(&verifier.replayer.reader, replay, replay_size), -1);
    assert_sweep_keeps(1, replay, replay_size);
}

static void test_a_replay_without_a_pin_is_skipped(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    sweep_all();
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    memcpy(replay, found, found_size);
    const size_t size = found_size;
    sweep_all();
    assert_int_equal(sweep.cleaned + sweep.left, 0);
    verification_of(round_id);
    assert_int_equal(found_size, size);
    assert_memory_equal(found, replay, size);
}

static void test_the_store_removes_pins_only_while_its_queue_is_empty(void **state)
{
    (void)state;
    static struct storage storage;
    const uint32_t round_id = keep_as_before();
    ledger_file_close(&file);
    memset(&sweep, 0, sizeof sweep);
    storage =
        (struct storage){ .dir = folder, .without_thread = true, .chore = pin_sweep_chore(&sweep) };
    const struct hal_storage device = storage_device(&storage);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), 0);
    for (uint32_t i = 0; i < 100000u && storage.chore.step; i++) {
        storage_work(&storage);
    }
    assert_int_equal(sweep.stage, PIN_SWEEP_DONE);
    assert_int_equal(sweep.cleaned, 1);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    assert_int_equal(verification_of(round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(verifier.replayer.reader.header.config.persistent.settings.value[SET_PIN],
                     PIN_WITHHELD);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_removing_the_pin_keeps_an_old_replay_genuine),
        TEST(test_removed_pin_bytes_are_erased_from_the_file_at_the_next_open),
        TEST(test_a_replay_that_differs_is_deleted),
        TEST(test_a_replay_that_cannot_be_read_is_deleted),
        TEST(test_a_replay_of_format_7_with_a_damaged_initial_state_is_deleted),
        TEST(test_a_replay_of_a_format_that_is_too_old_is_deleted),
        TEST(test_a_replay_in_which_a_pin_is_typed_is_deleted),
        TEST(test_the_kiosk_shows_no_seal_for_a_deleted_replay),
        TEST(test_a_replay_of_another_score_is_cleared_and_still_reported),
        TEST(test_a_replay_of_format_7_is_simulated_and_stored_in_the_current_format),
        TEST(test_a_replay_of_a_newer_format_is_not_changed),
        TEST(test_a_damaged_replay_whose_recorder_stored_no_pin_stays),
        TEST(test_a_replay_stays_until_the_next_start_if_the_core_refuses_to_run),
        TEST(test_a_replay_without_a_pin_stays_if_only_its_catalog_cannot_be_read),
        TEST(test_a_replay_without_a_pin_is_skipped),
        TEST(test_the_store_removes_pins_only_while_its_queue_is_empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
