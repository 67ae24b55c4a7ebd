/* test_session.c -- checks that attract mode starts a new session, which does not depend on the
 * previous one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/game_fields.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/accounting/accounts.h"

static struct core core, twin;
static struct output output, echo;

static void begin(const struct core_config *config)
{
    memset(&output, 0, sizeof output);
    assert_int_equal(core_init(&core, config), CORE_OK);
}

static void tick(struct core *at, const struct input *input, struct output *to)
{
    to->sound_count = 0;
    core_tick(at, input, to);
}

/* Runs the core with `input` until a new session starts, for at most `tick_max` ticks. Returns the
 * number of ticks. */
static uint32_t run_to_session(const struct input *input, uint32_t tick_max)
{
    uint32_t ticks = 0;
    do {
        tick(&core, input, &output);
        ticks++;
    } while (!core_is_fresh(&core) && ticks < tick_max);
    return ticks;
}

static void test_ten_minutes_of_attract_are_a_session(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12 };
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    assert_true(core_is_fresh(&core));
    assert_int_equal(run_to_session(&input, UINT32_MAX), SESSION_TICKS_MAX + SESSION_FADE_TICKS);
    assert_int_equal(core.game.tick, SESSION_TICKS_MAX + SESSION_FADE_TICKS);
    assert_true(core.config.seed != 3);
    const uint32_t second = core.config.seed;
    assert_int_equal(run_to_session(&input, UINT32_MAX), SESSION_TICKS_MAX + SESSION_FADE_TICKS);
    assert_true(core.config.seed != 3 && core.config.seed != second);
}

/* Simulates visitors for `ticks` ticks. The visitors insert coins and press SERVICE, LANGUAGE, TEST
 * and START. */
static void live(uint32_t ticks, struct input *input)
{
    static const uint32_t presses[] = { INPUT_SERVICE, INPUT_LANGUAGE, INPUT_TEST,
                                        INPUT_SERVICE, INPUT_TEST,     INPUT_START };
    for (uint32_t i = 0; i < ticks; i++) {
        input->pressed = i % 40u == 39u ? presses[i / 40u % 6u] : 0u;
        input->coin_count[i / 50u % COIN_LINE_COUNT] = i % 50u == 7u;
        input->record_saved_id = output.entry_id - (output.entry_id > 2u ? 2u : 0u);
        input->store_well = 1;
        input->day = 9800;
        input->minute = (uint16_t)(i / 100u % 1440u);
        tick(&core, input, &output);
        memset(input->coin_count, 0, sizeof input->coin_count);
    }
    input->pressed = 0;
}

/* A second core gets the session's configuration and its inputs. The second core must reach the
 * same state, because replays depend on this. */
static void test_a_session_depends_only_on_its_configuration_and_inputs(void **state)
{
    (void)state;
    struct core_config config = { .seed = 9,
                                  .fish_count = 30,
                                  .players = 2,
                                  .round_s = 10,
                                  .credit_coins = 2,
                                  .ticket_fish = 1 };
    settings_reset(&config.persistent.settings);
    struct input input = { .poi[0].link = POI_SOURCE_BOT, .poi[1].link = POI_SOURCE_BOT };
    begin(&config);
    live(40u * CORE_TICK_HZ, &input);
    for (uint32_t session = 0; session < 3; session++) {
        assert_in_range(run_to_session(&input, SESSION_TICKS_MAX * 2u), 1, SESSION_TICKS_MAX * 2u);
        assert_true(core_is_fresh(&core));
        static struct core_config from;
        from = core.config;
        assert_int_equal(core_init(&twin, &from), CORE_OK);
        assert_true(core_hash(&twin) == core_hash(&core));
        memset(&echo, 0, sizeof echo);
        echo.entry_id = output.entry_id;
        for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
            input.pressed = i == 100u ? INPUT_SERVICE : i == 200u || i == 300u ? INPUT_START : 0u;
            tick(&core, &input, &output);
            tick(&twin, &input, &echo);
            assert_int_equal(core_hash_quick(&twin), core_hash_quick(&core));
        }
        assert_true(core_hash(&twin) == core_hash(&core));
        assert_int_equal(core.game.round_count, 1);
        assert_int_equal(echo.entry_id, output.entry_id);
        assert_int_equal(echo.tickets, output.tickets);
        assert_int_equal(echo.coins_counted, output.coins_counted);
    }
}

static void test_a_recently_chosen_language_survives_the_session(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12 };
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    while (core.game.tick < SESSION_TICKS_MAX) {
        tick(&core, &input, &output);
    }
    input.pressed = INPUT_LANGUAGE;
    tick(&core, &input, &output);
    input.pressed = 0;
    const uint32_t until = core.game.language_until;
    assert_in_range(run_to_session(&input, SESSION_TICKS_MAX), 1, SESSION_FADE_TICKS);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    while (core.game.tick < until) {
        tick(&core, &input, &output);
        assert_int_equal(core.game.language, LANGUAGE_EN);
    }
    tick(&core, &input, &output);
    assert_int_equal(core.game.language, LANGUAGE_JA);
}

static void test_a_new_session_keeps_credits_and_settings(void **state)
{
    (void)state;
    struct core_config config = { .seed = 9, .fish_count = 12, .credit_coins = 3 };
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    settings_reset(&config.persistent.settings);
    begin(&config);
    live(30u * CORE_TICK_HZ, &input);
    while (core.game.phase != PHASE_ATTRACT || core.game.turn_tick == 0) {
        tick(&core, &input, &output);
    }
    const struct credit credit = core.game.accounts.credit;
    const struct ledger ledger = core.game.accounts.ledger;
    const struct audits audits = core.game.accounts.audits;
    const uint32_t commands = core.game.menu.command_count;
    run_to_session(&input, SESSION_TICKS_MAX);
    assert_true(core_is_fresh(&core));
    assert_true(field_hash(0, &credit_fields, &core.game.accounts.credit) ==
                field_hash(0, &credit_fields, &credit));
    assert_true(field_hash(0, &ledger_fields, &core.game.accounts.ledger) ==
                field_hash(0, &ledger_fields, &ledger));
    assert_true(field_hash(0, &audits_fields, &core.game.accounts.audits) ==
                field_hash(0, &audits_fields, &audits));
    assert_int_equal(core.game.menu.command_count, commands);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* The picture fades to black, the session changes while the picture is black, and then the picture
 * fades in. The fade must be short and must not jump. */
static void test_the_picture_is_dark_only_at_the_session_change(void **state)
{
    (void)state;
    static struct scene scene;
    const struct core_config config = { .seed = 3, .fish_count = 12 };
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    core_scene(&core, &scene);
    float before = scene.veil;
    assert_true(before == 1.0f);
    uint32_t dark = 0;
    for (uint32_t i = 0; i < SESSION_TICKS_MAX + 2u * SESSION_FADE_TICKS; i++) {
        tick(&core, &input, &output);
        core_scene(&core, &scene);
        assert_true(scene.veil >= 0.0f && scene.veil <= 1.0f);
        assert_true(scene.veil - before < 0.02f && before - scene.veil < 0.02f);
        assert_true(!core_is_fresh(&core) || scene.veil == 1.0f);
        dark += scene.veil > 0.0f;
        before = scene.veil;
    }
    assert_in_range(dark, 3u * SESSION_FADE_TICKS - 4u, 3u * SESSION_FADE_TICKS);
}

/* If a player dips during the fade, the session does not change. The session ends when attract mode
 * is reached again. */
static void test_a_player_prevents_the_session_change(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12, .round_s = 10 };
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    for (uint32_t i = 0; i < SESSION_TICKS_MAX + SESSION_FADE_TICKS / 2u; i++) {
        tick(&core, &input, &output);
    }
    input.pressed = INPUT_START;
    tick(&core, &input, &output);
    input.pressed = 0;
    assert_int_not_equal(core.game.phase, PHASE_ATTRACT);
    while (core.game.phase != PHASE_ATTRACT) {
        tick(&core, &input, &output);
        assert_int_equal(core.config.session.tick, 0);
    }
    assert_int_equal(run_to_session(&input, SESSION_TICKS_MAX), SESSION_FADE_TICKS - 1u);
}

/* Plays games, each started by START on the result screen of the previous game, until a session
 * ends or `game_max` games have been played. Returns the number of ticks. */
static uint32_t play_games(uint32_t game_max)
{
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    uint32_t ticks = 0, games = 0;
    bool was_result = false;
    do {
        const bool is_result = core.game.phase == PHASE_RESULT;
        games += is_result && !was_result;
        was_result = is_result;
        input.pressed = ticks % CORE_TICK_HZ == 0 ? INPUT_START : 0u;
        tick(&core, &input, &output);
        ticks++;
    } while (!core_is_fresh(&core) && games < game_max);
    return ticks;
}

/* A session must also end between two games. Otherwise a queue of visitors would make the whole
 * evening one session, and the recording of the last minutes would not fit into the memory. */
static void test_games_without_attract_mode_end_the_session_after_ten_minutes(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12, .round_s = 30 };
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    assert_in_range(play_games(UINT32_MAX), SESSION_TICKS_MAX,
                    SESSION_TICKS_MAX + 60u * CORE_TICK_HZ);
    /* The visitor pressed START, so the next game begins by itself. */
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    tick(&core, &input, &output);
    assert_int_not_equal(core.game.phase, PHASE_ATTRACT);
}

/* The result screen has led to attract mode, and START is pressed while the picture fades. */
static void test_start_in_the_fade_after_a_game_is_kept_for_the_new_session(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12, .round_s = 30 };
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    begin(&config);
    while (core.game.tick < SESSION_TICKS_MAX) {
        play_games(1);
    }
    while (core.game.phase != PHASE_ATTRACT) {
        tick(&core, &input, &output);
    }
    input.pressed = INPUT_START;
    tick(&core, &input, &output);
    input.pressed = 0;
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_in_range(run_to_session(&input, SESSION_TICKS_MAX), 1, SESSION_FADE_TICKS);
    tick(&core, &input, &output);
    assert_int_not_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_recordings_of_format_9_keep_their_long_session(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12, .round_s = 30, .rules = 9 };
    begin(&config);
    assert_in_range(play_games(30), SESSION_TICKS_MAX + 120u * CORE_TICK_HZ, UINT32_MAX);
    assert_false(core_is_fresh(&core));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ten_minutes_of_attract_are_a_session),
        cmocka_unit_test(test_games_without_attract_mode_end_the_session_after_ten_minutes),
        cmocka_unit_test(test_start_in_the_fade_after_a_game_is_kept_for_the_new_session),
        cmocka_unit_test(test_recordings_of_format_9_keep_their_long_session),
        cmocka_unit_test(test_a_session_depends_only_on_its_configuration_and_inputs),
        cmocka_unit_test(test_a_recently_chosen_language_survives_the_session),
        cmocka_unit_test(test_a_new_session_keeps_credits_and_settings),
        cmocka_unit_test(test_the_picture_is_dark_only_at_the_session_change),
        cmocka_unit_test(test_a_player_prevents_the_session_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
