/* test_session_recorder.c -- Tests the session recorder, which stores a replay with each ranked
 * score. Also tests the verifier, which rejects every replay that does not prove the score. */
#include <fenv.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/float_env.h"
#include "core/pin.h"
#include "drivers/sim/storage_sim.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/replay_verifier.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"

static struct core core, bots;
static struct output output, unheard;
static struct input input;
static struct session_recorder sessions;
static struct replay_verifier verifier;
static struct storage_sim sim;
static struct hal_storage storage;
static uint8_t room[SESSION_RECORDER_SIZE];
static int hand_is_away;

/* Advances two cores by one tick: the core `bots`, in which a bot plays, and the tested core
 * `core`. A simulated controller sends the bot's poses to `core`, so that `core` records a human
 * player. */
static void tick(uint32_t pressed)
{
    struct input by_bot = { .pressed = pressed, .poi[0].link = POI_SOURCE_BOT };
    unheard.sound_count = output.sound_count = 0;
    core_tick(&bots, &by_bot, &unheard);
    input.pressed = pressed;
    input.store_well = 1;
    input.record_saved_id = storage.ledger.ops->committed_id(storage.ledger.self);
    input.poi[0] = (struct poi_input){ .link = POI_SOURCE_LIVE,
                                       .has_wrist = 1,
                                       .target = bots.game.control[0].target_pose };
    input.poi[0].link = hand_is_away ? POI_SOURCE_ABSENT : POI_SOURCE_LIVE;
    const uint32_t before = output.entry_id;
    core_tick(&core, &input, &output);
    for (uint32_t id = before + 1u; id <= output.entry_id; id++) {
        storage.ledger.ops->append(storage.ledger.self, &output.entries[id % LEDGER_RING]);
    }
    session_recorder_tick(&sessions, &input, &core, &output);
    session_recorder_offer(&sessions, &storage);
}

static void ticks(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        tick(0);
    }
}

static uint8_t level; /* Skill level of the players (enum level). */

static int set_up(void **state)
{
    (void)state;
    struct core_config config = { .seed = 11, .round_s = 20, .level = level, .lanes = cpu_lanes() };
    settings_reset(&config.persistent.settings);
    memset(&sim, 0, sizeof sim);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    memset(&sessions.totals, 0, sizeof sessions.totals);
    sessions.round_id = sessions.missed = sessions.is_lent = 0;
    sim.replay = room;
    sim.replay_room = sizeof room;
    storage = storage_sim_device(&sim);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core_init(&bots, &config), CORE_OK);
    session_recorder_begin(&sessions, &core);
    return 0;
}

/* Starts a round from attract mode and plays to its end. Returns the id of the round's ledger
 * entry. */
static uint32_t play_at_once(void)
{
    const uint32_t before = sim.record.id;
    tick(INPUT_START);
    for (uint32_t i = 0; i < 90u * CORE_TICK_HZ && sim.record.id == before; i++) {
        tick(0);
    }
    assert_true(sim.record.id != before && sim.record.caught > 0 && !sim.record.by_bot);
    ticks(2);
    return sim.record.id;
}

/* Waits two seconds in attract mode, and plays a round. Returns the id of the round's ledger
 * entry. */
static uint32_t play(void)
{
    ticks(2u * CORE_TICK_HZ);
    return play_at_once();
}

/* Runs ticks without a controller until the tested core starts a new session in attract mode.
 * Finally `bots` becomes a copy of the tested core, so that both continue equally. */
static void rest(void)
{
    hand_is_away = 1;
    for (uint32_t i = 0; i < 240u * CORE_TICK_HZ && !core_is_fresh(&core); i++) {
        tick(0);
    }
    assert_true(core_is_fresh(&core));
    hand_is_away = 0;
    bots = core;
}

/* Returns the verdict for a round whose entry is no longer in the ledger. The replay can then be
 * compared only with the ranking. */
static enum replay_verdict stored_verdict(uint32_t round_id)
{
    static const struct ledger_entry dropped;
    return replay_verifier_result(&verifier, &core.game.accounts.ranking, round_id, &dropped);
}

static enum replay_verdict verification_of(const uint8_t *bytes, size_t size, uint32_t round_id)
{
    if (replay_verifier_begin(&verifier, bytes, size) == 0) {
        while (replay_verifier_tick(&verifier)) {
        }
    }
    return replay_verifier_result(&verifier, &core.game.accounts.ranking, round_id, &sim.round);
}

static void test_a_ranked_round_has_a_replay_that_verifies(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    assert_int_equal(sim.replay_id, round_id);
    assert_int_equal(sessions.missed, 0);
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(verifier.round.round.caught, sim.record.caught);
    assert_int_equal(verification_of(room, sim.replay_size, round_id + 1u), REPLAY_VERDICT_OTHER);
}

/* Returns the settings that the replay contains in its initial state. */
static const struct settings *settings_of(const uint8_t *bytes, size_t size)
{
    static struct replay_reader reader;
    assert_int_equal(replay_open_in(&reader, bytes, size), 0);
    replay_close(&reader);
    return &reader.header.config.persistent.settings;
}

static void lock(uint32_t pin)
{
    core.config.persistent.settings.value[SET_PIN] = pin_hide(pin, 5);
    core.game.settings_edit.logged = core.config.persistent.settings;
    static struct core_config config;
    config = core.config;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    session_recorder_begin(&sessions, &core);
}

static void test_a_stored_replay_contains_no_pin_and_verifies(void **state)
{
    (void)state;
    lock(4071);
    const int32_t kept = core.config.persistent.settings.value[SET_PIN];
    const uint32_t first_id = play();
    assert_int_equal(settings_of(room, sim.replay_size)->value[SET_PIN], PIN_WITHHELD);
    assert_int_equal(verification_of(room, sim.replay_size, first_id), REPLAY_VERDICT_GENUINE);
    rest(); /* The new session that begins here has the PIN in its initial state. */
    const uint32_t round_id = play();
    assert_int_equal(sim.replay_id, round_id);
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    assert_int_equal(core.config.persistent.settings.value[SET_PIN], kept);
    static struct replay_reader reader;
    assert_int_equal(replay_open_in(&reader, room, sim.replay_size), 0);
    const struct core_config *config = &reader.header.config;
    assert_int_equal(config->persistent.settings.value[SET_PIN], PIN_WITHHELD);
    assert_int_equal(config->session.settings_edit.logged.value[SET_PIN], PIN_WITHHELD);
    replay_close(&reader);
}

/* Starts a session after a change of the PIN. `logged_pin` is the PIN in the ledger, and `kept` is
 * the PIN in the settings. */
static void begin_with_pin(int32_t logged_pin, int32_t kept)
{
    static struct core_config config;
    rest(); /* A new session begins here, and its configuration then gets both PINs. */
    config = core.config;
    config.persistent.settings.value[SET_PIN] = kept;
    config.session.settings_edit.logged.value[SET_PIN] = logged_pin;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    session_recorder_begin(&sessions, &core);
}

static void test_a_replay_after_a_change_of_the_pin_verifies(void **state)
{
    const int32_t a = pin_hide(4071, 5), b = pin_hide(1234, 9);
    const int32_t pins[][2] = { { a, 0 }, { 0, a }, { a, b } };
    (void)state;
    play();
    for (uint32_t i = 0; i < sizeof pins / sizeof pins[0]; i++) {
        begin_with_pin(pins[i][0], pins[i][1]);
        assert_int_equal(core.game.settings_edit.logged.value[SET_PIN], pins[i][0]);
        const uint32_t round_id = play();
        assert_int_equal(sim.replay_id, round_id);
        const struct settings *start = settings_of(room, sim.replay_size);
        assert_true(start->value[SET_PIN] == 0 || start->value[SET_PIN] == PIN_WITHHELD);
        assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    }
}

/* Writes the session to a file, as after a panic, and replays the file. Asserts that the file
 * contains no PIN, and that the replay ends in the state with `hash`. */
static void assert_panic_replay_ends_in(uint64_t hash)
{
    static struct replayer replayer;
    static struct core played;
    static struct output shown;
    struct core_config config;
    char path[] = "/tmp/kingyo-panic-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(session_recorder_dump(&sessions, &core, true, fd), 0);
    close(fd);
    assert_int_equal(replayer_begin(&replayer, path, &config), 0);
    unlink(path);
    assert_int_equal(config.persistent.settings.value[SET_PIN], PIN_WITHHELD);
    assert_int_equal(config.session.settings_edit.logged.value[SET_PIN], 0);
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap tap = replayer_tap(&replayer);
    struct input recorded = { 0 };
    config.lanes = cpu_lanes();
    memset(&shown, 0, sizeof shown);
    assert_int_equal(core_init(&played, &config), CORE_OK);
    while (source.next(source.self, &recorded)) {
        shown.sound_count = 0;
        assert_int_equal(core_tick(&played, &recorded, &shown), CORE_OK);
        tap.tick(tap.self, &recorded, &played);
    }
    assert_false(replayer.damaged);
    assert_false(replayer.difference.found);
    assert_true(core_hash(&played) == hash);
}

static void test_a_panic_replay_contains_no_pin_and_reproduces_the_game(void **state)
{
    (void)state;
    lock(4071);
    play();
    ticks(50); /* 50 ticks are less than a second, so the recording ends within a second. */
    assert_panic_replay_ends_in(core_hash(&core));
}

static void test_the_recording_ends_when_a_page_for_the_pin_opens(void **state)
{
    (void)state;
    lock(4071);
    ticks(CORE_TICK_HZ / 2u);
    tick(INPUT_TEST);
    assert_true(core_status(&core).takes_pin);
    assert_false(replay_is_open(&sessions.writer));
    const uint64_t hash = core_hash(&core);
    ticks(CORE_TICK_HZ);
    /* Presses OK four times, which types 1111, a wrong PIN. */
    for (uint32_t i = 0; i < 4u; i++) {
        tick(INPUT_OK);
        ticks(CORE_TICK_HZ / 2u);
    }
    assert_int_equal(core.game.settings_edit.pin_wrong, 1);
    assert_panic_replay_ends_in(hash);
    lock(4071); /* lock() starts a new session with a new recording. */
    assert_true(replay_is_open(&sessions.writer));
}

static void test_the_recording_ends_when_the_page_for_a_new_pin_opens(void **state)
{
    (void)state;
    tick(INPUT_TEST);
    ticks(10);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_true(replay_is_open(&sessions.writer));
    core.game.menu.page = MENU_NEW_PIN;
    tick(0);
    assert_false(replay_is_open(&sessions.writer));
}

/* `missed` normally counts each round without a replay, and the menu then shows a warning. A page
 * for the PIN ends the recording on purpose, so this round must not be counted. */
static void test_a_round_after_a_page_for_the_pin_has_no_replay_and_is_not_missed(void **state)
{
    (void)state;
    lock(4071);
    hand_is_away = 1; /* Without a controller, no poi can select digits. */
    tick(INPUT_TEST);
    assert_true(core_status(&core).takes_pin);
    for (uint32_t i = 0; i <= MENU_PIN_IDLE_TICKS && core.game.phase == PHASE_MENU; i++) {
        tick(0); /* The loop ends when the menu closes after its idle timeout. */
    }
    hand_is_away = 0;
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    bots = core;    /* `bots` still has an open menu, so it becomes a copy of the tested core. */
    play_at_once(); /* This round starts before a new session could begin. */
    assert_int_equal(sessions.missed, 0);
    assert_int_equal(sim.replay_id, 0);
}

static void test_a_round_after_the_memory_is_full_is_missed(void **state)
{
    (void)state;
    sessions.writer.memory_size = (size_t)sessions.writer.offset + REPLAY_END_SIZE;
    play();
    assert_false(replay_is_open(&sessions.writer));
    assert_int_equal(sessions.missed, 1);
    assert_int_equal(sim.replay_id, 0);
}

static void test_the_replay_verifier_is_independent_of_the_float_mode(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    fesetround(FE_UPWARD);
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    assert_true(float_env_is_standard());
    fesetround(FE_TONEAREST);
}

static void test_the_replay_verifier_reports_unchecked_if_the_core_fails_to_start(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    assert_int_equal(replay_verifier_begin(&verifier, room, sim.replay_size), 0);
    fesetround(FE_UPWARD);
    while (replay_verifier_tick(&verifier)) {
    }
    fesetround(FE_TONEAREST);
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_UNCHECKED);
}

static void test_a_score_is_genuine_only_on_the_board_of_its_level(void **state)
{
    (void)state;
    for (level = LEVEL_NORMAL; level < LEVEL_COUNT; level++) {
        set_up(NULL);
        const uint32_t round_id = play();
        struct ranking *ranking = &core.game.accounts.ranking;
        struct rank_row *row = &ranking->row[ranking_board(MODE_FESTIVAL, level)][RANK_EVER][0];
        assert_int_equal(row->round_id, round_id);
        assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
        assert_int_equal(verifier.round.round.level, level);
        ranking->row[MODE_FESTIVAL][RANK_EVER][0] = *row;
        assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_OTHER);
    }
    level = LEVEL_MASTER;
}

static void test_an_edited_score_is_not_genuine(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    struct rank_row *row = &core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][0];
    assert_int_equal(row->round_id, round_id);
    row->caught++;
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_OTHER);
    row->caught--;
    row->slot = 1;
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_OTHER);
    row->slot = 0;
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    memset(&core.game.accounts.ranking, 0, sizeof core.game.accounts.ranking);
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_OTHER);
}

/* In each step of the loop, one field of the stored round differs from the replayed round. */
static void test_a_replay_of_a_different_round_is_not_genuine(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    const struct ledger_entry kept = sim.round;
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    for (uint32_t i = 0; i < 13; i++) {
        struct round_record *round = &sim.round.round;
        uint32_t *const words[] = { &sim.round.boot,
                                    &sim.round.tick,
                                    &round->seed,
                                    &round->start_tick,
                                    &round->end_tick,
                                    &round->player[0].scoops,
                                    &round->player[0].hole_area_mm2 };
        uint8_t *const bytes[] = { &round->grade, &round->players, &sim.round.kind,
                                   &round->preset };
        uint16_t *const round_values[] = { &round->fish_count, &round->round_s };
        if (i < 7) {
            ++*words[i];
        } else if (i < 11) {
            ++*bytes[i - 7u];
        } else {
            ++*round_values[i - 11u];
        }
        assert_int_equal(
            replay_verifier_result(&verifier, &core.game.accounts.ranking, round_id, &sim.round),
            REPLAY_VERDICT_OTHER);
        sim.round = kept;
    }
    sim.round = (struct ledger_entry){ 0 }; /* With an empty entry, as if the ledger had dropped the
                                               round, only the ranking is compared. */
    assert_int_equal(
        replay_verifier_result(&verifier, &core.game.accounts.ranking, round_id, &sim.round),
        REPLAY_VERDICT_GENUINE);
}

/* Changes one field of the verifier's result or of the ranking at a time. Each change alone must
 * make the score not genuine. */
static void test_each_single_mismatch_makes_a_score_not_genuine(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    struct rank_row *row = &core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][0];
    const struct rank_row ranked = *row;
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    static struct replay_verifier found;
    found = verifier;

    verifier.round.round.players = 2; /* The mask 2 means that only slot 1 played, but the score
                                      belongs to slot 0. */
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    verifier = found;
    memset(&core.game.accounts.ranking, 0, sizeof core.game.accounts.ranking);
    *row = ranked;
    row->round_id = round_id + 1u; /* The ranking row now names another round with the same
                                      catch. */
    assert_int_equal(stored_verdict(round_id + 1u), REPLAY_VERDICT_OTHER);
    *row = ranked;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_GENUINE);
    verifier.recorded
        .ticks++; /* The recorded number of ticks is now larger than the replayed number. */
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    verifier = found;
    verifier.round.round.by_bot = 1;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    verifier = found;
    verifier.round.round.unscored = 1;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    verifier = found;
    verifier.replayer.difference.found = 1;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    verifier = found;
    verifier.replayer.damaged = 1;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_DAMAGED);
    verifier = found;
    verifier.is_damaged = 1;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_DAMAGED);
    verifier = found;
    row->caught--;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_OTHER);
    row->caught++;
    assert_int_equal(stored_verdict(round_id), REPLAY_VERDICT_GENUINE);
}

static void test_an_altered_replay_is_reported_as_damaged(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    for (size_t at = 7; at < sim.replay_size; at += sim.replay_size / 20u) {
        room[at] ^= 1u;
        assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_DAMAGED);
        room[at] ^= 1u;
    }
    assert_int_equal(verification_of(room, sim.replay_size - 1u, round_id), REPLAY_VERDICT_DAMAGED);
    assert_int_equal(verification_of(room, 0, round_id), REPLAY_VERDICT_DAMAGED);
}

static void test_a_round_of_the_next_session_verifies_alone(void **state)
{
    (void)state;
    play();
    rest();
    assert_int_equal(sessions.totals.ticks, 0);
    const uint32_t round_id = play();
    assert_int_equal(sim.replay_id, round_id);
    assert_int_equal(verification_of(room, sim.replay_size, round_id), REPLAY_VERDICT_GENUINE);
    assert_in_range(verifier.recorded.ticks, 20u * CORE_TICK_HZ, 40u * CORE_TICK_HZ);
}

static void test_a_replay_is_stored_only_after_its_score(void **state)
{
    (void)state;
    sim.delay_polls = 1000;
    const uint32_t round_id = play();
    assert_int_equal(sim.replay_id, 0);
    ticks(1100);
    assert_int_equal(sim.replay_id, round_id);
}

static void test_a_store_without_replays_keeps_all_other_data(void **state)
{
    (void)state;
    sim.replay = NULL;
    play();
    assert_int_equal(sessions.round_id, 0);
    assert_int_equal(sessions.missed, 0);
    sim.replay = room;
    sim.replay_room = 100; /* Every replay is larger than 100 bytes, so the store has no room for a
                              replay, as on a full card. */
    rest();
    play();
    assert_int_equal(sessions.round_id, 0);
    assert_int_equal(sessions.missed, 1);
}

/* ---- Tests of the playback of a score ------------------------------------------------------- */

static struct score_playback playback;
static struct scene scene;
/* Time of the simulated stopwatch in ns. Each reading advances the stopwatch by a third of the time
 * that one frame may spend on seeking in a replay. */
static uint64_t watch_ns;

static uint64_t expect_watch(void *self)
{
    (void)self;
    return watch_ns += SCORE_PLAYBACK_SEEK_NS / 3u + 1u;
}

static const struct hal_clock_ops slow_ops = { .now_ns = expect_watch };
static const struct hal_clock no_stopwatch, slow_stopwatch = { .ops = &slow_ops };

static void frame(void)
{
    static struct hal hal;
    hal.storage = storage;
    score_playback_frame(&playback, &hal, &no_stopwatch, &core.game.accounts.ranking, 2);
    core_scene(&core, &scene);
    score_playback_show(&playback, &scene, &output);
}

/* Runs frames while the playback has the state `what`, but for at most 90 s. Returns the number of
 * frames. */
static uint32_t frames_while(uint8_t what)
{
    uint32_t count = 0;
    while (playback.state == what && count < 5400u) {
        frame();
        count++;
    }
    return count;
}

static void test_a_played_back_score_is_shown_as_genuine(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    ticks(200);
    sim.replay_polls_left = 30; /* The store needs 30 frames to read the replay. */
    score_playback_request(&playback, round_id);
    frame();
    assert_int_equal(scene.playback, PLAYBACK_SEEKS);
    assert_in_range(frames_while(PLAYBACK_SEEKS), 29, 40);
    assert_int_equal(playback.state, PLAYBACK_PLAYS);
    const uint32_t shown = frames_while(PLAYBACK_PLAYS);
    assert_in_range(shown, 10u * 60u, 60u * 60u); /* The playback runs at normal speed, and takes
                                                     between 10 and 60 s. */
    assert_int_equal(scene.playback, PLAYBACK_GENUINE);
    assert_int_equal(scene.caught[0], sim.record.caught);
    assert_int_equal(frames_while(PLAYBACK_GENUINE), SCORE_PLAYBACK_END_TICKS / 2u);
    assert_int_equal(scene.playback, PLAYBACK_OFF);
}

static void test_a_long_replay_is_read_within_the_time_budget_of_each_frame(void **state)
{
    (void)state;
    static struct hal hal;
    const uint32_t round_id = play();
    uint32_t frames = 0;
    hal.storage = storage;
    sim.replay_polls_left = 0;
    score_playback_request(&playback, round_id);
    score_playback_frame(&playback, &hal, &slow_stopwatch, &core.game.accounts.ranking, 2);
    score_playback_frame(&playback, &hal, &slow_stopwatch, &core.game.accounts.ranking, 2);
    for (; !playback.has_play && frames < 1000u; frames++) {
        const uint32_t before = playback.verifier.replayer.reader.tick;
        score_playback_frame(&playback, &hal, &slow_stopwatch, &core.game.accounts.ranking, 2);
        assert_true(playback.verifier.replayer.reader.tick <= before + 3u * CORE_TICK_HZ);
        score_playback_show(&playback, &scene, &output);
        assert_int_equal(scene.playback, PLAYBACK_SEEKS);
    }
    assert_in_range(frames, playback.verifier.recorded.ticks / (3u * CORE_TICK_HZ) - 1u, 100);
    assert_true(frames >= 3u);
    score_playback_end(&playback);
}

static void test_a_button_or_a_dip_ends_the_playback(void **state)
{
    (void)state;
    struct poi_input poi[POI_MAX] = { { .link = POI_SOURCE_LIVE, .target.position_m.y = -0.05f } };
    const uint32_t round_id = play();
    score_playback_request(&playback, round_id);
    frames_while(PLAYBACK_SEEKS);
    /* This dip began before the playback, so it must not end the playback. */
    assert_int_equal(score_playback_handle_input(&playback, 0, poi), 0);
    poi[0].target.position_m.y = 0.05f;
    assert_int_equal(score_playback_handle_input(&playback, 0, poi), 0);
    poi[0].target.position_m.y = -0.05f;
    assert_int_equal(score_playback_handle_input(&playback, 0, poi), 1);
    assert_int_equal(playback.state, PLAYBACK_OFF);
    score_playback_request(&playback, round_id);
    assert_int_equal(score_playback_handle_input(&playback, INPUT_SERVICE, poi), 1);
    frame();
    assert_int_equal(scene.playback, PLAYBACK_OFF);
}

static void test_a_score_without_a_replay_is_reported_as_missing(void **state)
{
    (void)state;
    const uint32_t round_id = play();
    score_playback_request(&playback, round_id + 5u);
    frames_while(PLAYBACK_SEEKS);
    assert_int_equal(scene.playback, PLAYBACK_NONE);
    score_playback_end(&playback);
    room[sim.replay_size / 2u] ^= 4u;
    score_playback_request(&playback, round_id);
    frames_while(PLAYBACK_SEEKS);
    assert_int_equal(scene.playback, PLAYBACK_OTHER);
    score_playback_end(&playback);
    sim.replay = NULL;
    score_playback_request(&playback, round_id);
    frames_while(PLAYBACK_SEEKS);
    assert_int_equal(scene.playback, PLAYBACK_NONE);
    score_playback_end(&playback);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, set_up)
    const struct CMUnitTest tests[] = {
        TEST(test_a_ranked_round_has_a_replay_that_verifies),
        TEST(test_a_stored_replay_contains_no_pin_and_verifies),
        TEST(test_a_replay_after_a_change_of_the_pin_verifies),
        TEST(test_a_panic_replay_contains_no_pin_and_reproduces_the_game),
        TEST(test_the_recording_ends_when_a_page_for_the_pin_opens),
        TEST(test_the_recording_ends_when_the_page_for_a_new_pin_opens),
        TEST(test_a_round_after_a_page_for_the_pin_has_no_replay_and_is_not_missed),
        TEST(test_a_round_after_the_memory_is_full_is_missed),
        TEST(test_the_replay_verifier_is_independent_of_the_float_mode),
        TEST(test_the_replay_verifier_reports_unchecked_if_the_core_fails_to_start),
        TEST(test_a_score_is_genuine_only_on_the_board_of_its_level),
        TEST(test_an_edited_score_is_not_genuine),
        TEST(test_a_replay_of_a_different_round_is_not_genuine),
        TEST(test_each_single_mismatch_makes_a_score_not_genuine),
        TEST(test_an_altered_replay_is_reported_as_damaged),
        TEST(test_a_round_of_the_next_session_verifies_alone),
        TEST(test_a_replay_is_stored_only_after_its_score),
        TEST(test_a_store_without_replays_keeps_all_other_data),
        TEST(test_a_played_back_score_is_shown_as_genuine),
        TEST(test_a_long_replay_is_read_within_the_time_budget_of_each_frame),
        TEST(test_a_button_or_a_dip_ends_the_playback),
        TEST(test_a_score_without_a_replay_is_reported_as_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
