/* test_championship.c -- plays a championship from START to the result with controller input.
 * Checks the tank, the clock, the announcements of the time, the number of fish, and the record.
 * Equal inputs must give an equal result. */
#include "tests/unit/support/balance.h"
#include "tests/unit/support/core_fixture.h"

#include "core/game/bot/bot.h"
#include "tests/unit/support/newest_record.h"

#define ROUND_TICKS (180u * CORE_TICK_HZ)
#define CALLS_MAX 16u

/* A bot computes the poses. The test sends them as controller input, so the core treats the bot as
 * a person. */
static struct bot player;

struct heard {
    uint32_t tick; /* Time of the sound, in ticks since the start of the round. */
    uint8_t sound;
};

static struct heard heard[CALLS_MAX];
static uint32_t heard_count;

static void listen(void)
{
    for (uint32_t i = 0; i < output.sound_count; i++) {
        const uint8_t sound = output.sounds[i].sound;
        if ((sound == SOUND_CALL || sound == SOUND_TICK) && heard_count < CALLS_MAX) {
            heard[heard_count++] =
                (struct heard){ .tick = core.game.tick - 1u - core.game.round_tick,
                                .sound = sound };
        }
    }
}

static void run_to_result(int plays)
{
    while (core.game.phase != PHASE_RESULT && core.game.tick < 2u * ROUND_TICKS) {
        if (plays) {
            const struct vision vision = { .game = &core.game, .world = &core.world, .player = 0 };
            input.poi[0].target = bot_tick(&player, &vision);
        }
        tick();
        listen();
    }
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static uint64_t play_through(uint32_t seed, uint32_t round_s)
{
    const struct core_config config = { .seed = seed,
                                        .round_s = round_s,
                                        .modes = 1u << MODE_CHAMPIONSHIP };
    open_core(&config);
    bot_init(&player, &technique_expert, seed);
    hold(0, v3(0.0f, ABOVE_M, 0.0f));
    input.pressed = INPUT_START;
    run_to_result(1);
    return core_hash(&core);
}

static int play_one(void **state)
{
    (void)state;
    play_through(4, 0);
    return 0;
}

static void test_a_championship_has_the_federations_tank_paper_and_time(void **state)
{
    (void)state;
    look();
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.world.tank.preset, TANK_PRESET_OFFICIAL);
    assert_int_equal(scene.fish_count, 1000);
    assert_int_equal(scene.mode, MODE_CHAMPIONSHIP);
    assert_int_equal(core.world.poi[0].sheet.grade, 5);
    assert_float_equal(2.0f * scene.poi[0].ring_radius_m, 0.080f, 1e-6f);
    assert_int_equal(core.world.tank.oxygen.pump, 0);
    const uint32_t lasted = newest_record(&output)->end_tick - newest_record(&output)->start_tick;
    assert_true(lasted <= ROUND_TICKS + GAME_CARRY_TICKS);
    assert_true(lasted >= ROUND_TICKS || scene.player[0].out);
}

/* The player holds the poi above the water, so that no paper tears and the round lasts its full
 * time. */
static void test_the_time_announcements_come_at_their_ticks(void **state)
{
    (void)state;
    const struct core_config config = { .preset = TANK_PRESET_OFFICIAL,
                                        .fish_count = 12,
                                        .modes = 1u << MODE_CHAMPIONSHIP };
    static const struct heard calls[] = {
        { 60u * CORE_TICK_HZ, SOUND_CALL },  { 120u * CORE_TICK_HZ, SOUND_CALL },
        { 170u * CORE_TICK_HZ, SOUND_CALL }, { 175u * CORE_TICK_HZ, SOUND_TICK },
        { 176u * CORE_TICK_HZ, SOUND_TICK }, { 177u * CORE_TICK_HZ, SOUND_TICK },
        { 178u * CORE_TICK_HZ, SOUND_TICK }, { 179u * CORE_TICK_HZ, SOUND_TICK },
        { 180u * CORE_TICK_HZ, SOUND_CALL },
    };
    open_core(&config);
    heard_count = 0;
    hold(0, v3(0.0f, ABOVE_M, 0.0f));
    press(INPUT_START);
    run_to_result(0);
    assert_int_equal(heard_count, sizeof calls / sizeof calls[0]);
    for (uint32_t i = 0; i < heard_count; i++) {
        assert_int_equal(heard[i].tick, calls[i].tick);
        assert_int_equal(heard[i].sound, calls[i].sound);
    }
    assert_int_equal(look()->call, CALL_TIME);
    assert_int_equal(newest_record(&output)->end_tick - newest_record(&output)->start_tick,
                     ROUND_TICKS);
}

static void test_the_catch_is_shown_and_stored(void **state)
{
    (void)state;
    const struct player_record *record = &newest_record(&output)->player[0];
    print_message("%u caught by %u scoops, %u fouls\n", record->caught, record->scoops,
                  record->fouls);
    assert_true(entries_keep_record(&output));
    assert_int_equal(balance_count(&output, LEDGER_ROUND), 1);
    assert_int_equal(newest_record(&output)->mode, MODE_CHAMPIONSHIP);
    assert_int_equal(newest_record(&output)->grade, 5);
    assert_int_equal(newest_record(&output)->players, 1);
    /* The poses arrived as controller input, so the round counts as the round of a person. */
    assert_int_equal(newest_record(&output)->by_bot, 0);
    assert_true(record->caught > 0);
    assert_int_equal(record->caught, look()->caught[0]);
    assert_true(record->scoops >= record->caught / 8u);
    assert_int_equal(scene.best_today, record->caught);
    assert_true(core.world.bowl[0].fish_count >= record->caught);
}

static void test_the_same_inputs_play_the_same_championship(void **state)
{
    (void)state;
    const uint64_t first = play_through(4, 15);
    assert_true(play_through(4, 15) == first);
    assert_true(play_through(5, 15) != first);
}

int main(void)
{
    const struct CMUnitTest whole[] = {
        cmocka_unit_test(test_a_championship_has_the_federations_tank_paper_and_time),
        cmocka_unit_test(test_the_catch_is_shown_and_stored),
    };
    const struct CMUnitTest parts[] = {
        cmocka_unit_test(test_the_time_announcements_come_at_their_ticks),
        cmocka_unit_test(test_the_same_inputs_play_the_same_championship),
    };
    return cmocka_run_group_tests(whole, play_one, NULL) +
           cmocka_run_group_tests(parts, NULL, NULL);
}
