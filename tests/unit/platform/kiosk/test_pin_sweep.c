/* test_pin_sweep.c -- Tests the removal of the menu's PIN from replays that an older Kingyo stored.
 *
 * The replay stays genuine and no old bytes remain. A replay that does not verify is not
 * changed. */
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

#include "core/pin.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/pin_sweep.h"
#include "platform/store/sqlite/ledger_file.h"

#define PIN 4071

static char folder[] = "/tmp/kingyo-sweep-XXXXXX";
static char path[64], log_path[72];
static struct core core, bots;
static struct output output, unheard;
static struct input input;
static struct session_recorder chapters;
static struct pin_sweep sweep;
static struct replay_verifier judge;
static struct ledger_file file;
static uint8_t replay[SESSION_RECORDER_SIZE], found[SESSION_RECORDER_SIZE];
static size_t replay_size, found_size;

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
                                       .target = bots.game.hand_pose[0] };
    const uint32_t before = output.entry_id;
    core_tick(&core, &input, &output);
    for (uint32_t id = before + 1u; id <= output.entry_id; id++) {
        const struct ledger_entry *entry = &output.entries[id % LEDGER_RING];
        assert_int_equal(ledger_file_write(&file, entry, 1), SQLITE_OK);
        round_id = entry->kind == LEDGER_ROUND ? id : round_id;
    }
    session_recorder_tick(&chapters, &input, &core, &output);
    return round_id;
}

/* Plays a round under the rules of format 7 while a PIN is set, and keeps its replay with the PIN,
 * as that version did. Returns the round. */
static uint32_t keep_as_before(void)
{
    struct core_config config = { .seed = 11, .round_s = 20, .lanes = cpu_lanes(), .rules = 7 };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_PIN] = PIN;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core_init(&bots, &config), CORE_OK);
    session_recorder_begin(&chapters, &core);
    uint32_t round_id = 0;
    for (uint32_t i = 0; i < 90u * CORE_TICK_HZ && round_id == 0; i++) {
        round_id = tick(i == 2u * CORE_TICK_HZ ? INPUT_START : 0);
    }
    assert_true(round_id != 0);
    replay_size = replay_copy(&chapters.writer, core_hash(&core), replay, sizeof replay);
    assert_true(replay_size > 0);
    assert_int_equal(ledger_file_put_replay(&file, round_id, replay, replay_size), SQLITE_OK);
    return round_id;
}

static void sweep_all(void)
{
    const struct storage_chore chore = pin_sweep_chore(&sweep);
    memset(&sweep, 0, sizeof sweep);
    for (uint32_t i = 0; i < 10000000u && sweep.stage != PIN_SWEEP_DONE; i++) {
        assert_int_equal(chore.step(chore.self, &file), SQLITE_OK);
    }
    assert_int_equal(chore.step(chore.self, &file), SQLITE_DONE);
}

static enum replay_verdict judged(uint32_t round_id)
{
    struct ledger_entry kept;
    ledger_file_round(&file, round_id, &kept);
    assert_int_equal(ledger_file_get_replay(&file, round_id, found, sizeof found, &found_size),
                     SQLITE_OK);
    if (replay_verifier_begin(&judge, found, found_size) == 0) {
        while (replay_verifier_tick(&judge)) {
        }
    }
    return replay_verifier_result(&judge, &file.content.memory.ranking, round_id, &kept);
}

/* Returns whether the file `name` holds these bytes anywhere. */
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
    assert_int_equal(judged(round_id), REPLAY_VERDICT_GENUINE);
    const uint32_t ticks = judge.replayer.totals.ticks;
    const struct round_record round = judge.round.round;
    sweep_all();
    assert_int_equal(sweep.cleaned, 1);
    assert_int_equal(sweep.left, 0);
    assert_int_equal(judged(round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(judge.replayer.totals.ticks, ticks);
    assert_memory_equal(&judge.round.round, &round, sizeof round);
    const struct core_config *config = &judge.replayer.reader.header.config;
    assert_int_equal(config->rules, 7);
    assert_int_equal(config->persistent.settings.value[SET_PIN], PIN_WITHHELD);
    assert_false(session_recorder_start_has_pin(config));
    sweep_all(); /* No replay is left to process. */
    assert_int_equal(sweep.cleaned + sweep.left, 0);
}

static void test_removed_pin_bytes_are_erased_from_the_file_at_the_next_open(void **state)
{
    (void)state;
    keep_as_before();
    /* Checksums of the header and of the initial state. The new recording has different ones. */
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

static void test_an_invalid_replay_is_not_changed(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    static struct core_config config;
    static struct replay_reader reader;
    assert_int_equal(replay_open_in(&reader, replay, replay_size), 0);
    config = reader.header.config;
    replay_close(&reader);
    config.seed++;
    struct replay_seal seal;
    replay_size = replay_replace_start(replay, replay_size, sizeof replay, &config, &seal);
    while (!replay_seal_next(&seal, sizeof replay)) {
    }
    assert_int_equal(ledger_file_put_replay(&file, round_id, replay, replay_size), SQLITE_OK);
    assert_int_not_equal(judged(round_id), REPLAY_VERDICT_GENUINE);
    sweep_all();
    assert_int_equal(sweep.cleaned, 0);
    assert_int_equal(sweep.left, 1);
    judged(round_id);
    assert_int_equal(found_size, replay_size);
    assert_memory_equal(found, replay, replay_size);
}

static void test_a_replay_without_a_pin_is_skipped(void **state)
{
    (void)state;
    const uint32_t round_id = keep_as_before();
    sweep_all();
    assert_int_equal(judged(round_id), REPLAY_VERDICT_GENUINE);
    memcpy(replay, found, found_size);
    const size_t size = found_size;
    sweep_all();
    assert_int_equal(sweep.cleaned + sweep.left, 0);
    judged(round_id);
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
    storage = (struct storage){ .dir = folder, .by_hand = 1, .chore = pin_sweep_chore(&sweep) };
    const struct hal_storage device = storage_device(&storage);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), 0);
    for (uint32_t i = 0; i < 100000u && storage.chore.step; i++) {
        storage_work(&storage);
    }
    assert_int_equal(sweep.stage, PIN_SWEEP_DONE);
    assert_int_equal(sweep.cleaned, 1);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    assert_int_equal(judged(round_id), REPLAY_VERDICT_GENUINE);
    assert_false(session_recorder_start_has_pin(&judge.replayer.reader.header.config));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_removing_the_pin_keeps_an_old_replay_genuine, set_up,
                                        tear_down),
        cmocka_unit_test_setup_teardown(
            test_removed_pin_bytes_are_erased_from_the_file_at_the_next_open, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_an_invalid_replay_is_not_changed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_replay_without_a_pin_is_skipped, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_the_store_removes_pins_only_while_its_queue_is_empty,
                                        set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
